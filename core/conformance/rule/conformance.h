/* The conformance kit: every rule of the contract, tried on every block type and integrator of a plugin file.
 *
 * Each rule is tried on each subject in a child process with a time limit, so that a plugin which crashes, hangs,
 * aborts or ends the process has failed that rule, and the caller goes on. The plugin is never opened in the caller's
 * process.
 */
#ifndef TINKER_CORE_CONFORMANCE_H
#define TINKER_CORE_CONFORMANCE_H

#include "conformance/probe/outcome.h"
#include "plugin/catalogue/catalogue.h"

/* All rules, in the order they are tried in; ended by one without a name. */
const TinkerConformanceRule *tinker_conformance_rules(void);

typedef struct {
    const char *rule;    /* its name */
    const char *subject; /* id of the block type or integrator; "" where the rule is about the library */
    TinkerConformanceOutcome outcome;
    const char *text; /* why it failed or does not apply; what was measured; "" where there is nothing to tell */
} TinkerConformanceResult;

/* Borrowed for the length of the call. */
typedef void (*TinkerConformanceFunc)(const TinkerConformanceResult *result, gpointer data);

typedef struct {
    guint32 seed;     /* of the random values: the same seed tries the same values */
    double seconds;   /* time limit of each rule on each subject; at most 3600 */
    const char *rule; /* this rule alone; NULL: all */
    const char *type; /* this block type or integrator alone; NULL: all, and the library itself */
} TinkerConformanceOptions;

#define TINKER_CONFORMANCE_SEED    1
#define TINKER_CONFORMANCE_SECONDS 10.0

/* Tries the library at `path`. The catalogue (borrowed) provides the bodies that scenes need; nothing is opened in it.
 * To be called where there is one thread alone, since processes are forked, and where SIGCHLD is not ignored. FALSE
 * only where not everything could be tried: TINKER_PLUGIN_ERROR_FILE where the file cannot be read, or the system gives
 * no memory or process; _MISSING where it has nothing called `type`. A library that is refused is a result: its first
 * rule has failed. */
gboolean tinker_conformance_check(TinkerCatalogue *catalogue, const char *path, const TinkerConformanceOptions *options,
                                  TinkerConformanceFunc result, gpointer data, GError **error);

#endif
