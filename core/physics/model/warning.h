/* What a model, a plan and a run warn of: arrays of sentences that say of what kind they are. */
#ifndef TINKER_CORE_WARNING_H
#define TINKER_CORE_WARNING_H

#include <glib.h>

typedef enum {
    TINKER_WARNING_METHOD,  /* of how it is stepped: another method or step may spare it */
    TINKER_WARNING_START,   /* of how the scene starts, which the advice about the scene tells as well */
    TINKER_WARNING_SCENE,   /* of the scene itself, as all that follow: no other method would spare it */
    TINKER_WARNING_LAWS,    /* the outcome depends on the law of impact */
    TINKER_WARNING_SAMPLES, /* samples are too far apart to show the motion; `number`: an interval (s) that shows it */
} TinkerWarningKind;

typedef struct {
    TinkerWarningKind kind;
    char *text;    /* a sentence, with what helps in brackets */
    char *brief;   /* without the brackets, for those who offer the help themselves; NULL: what helps has no name */
    double number; /* that the help needs; else 0 */
} TinkerWarning;

/* An array of TinkerWarning *, which it owns. (transfer full) */
GPtrArray *tinker_warnings_new(void);

/* A warning of this text (transfer full). (transfer full) */
TinkerWarning *tinker_warning_new(TinkerWarningKind kind, char *text);

/* Adds a warning of this text (transfer full). */
void tinker_warnings_add(GPtrArray *warnings, TinkerWarningKind kind, char *text);

/* Adds a warning that says `brief` and, in brackets, what helps, which takes this number. */
void tinker_warnings_add_with_help(GPtrArray *warnings, TinkerWarningKind kind, const char *brief, const char *help,
                                   double number);

/* Adds copies of other warnings. */
void tinker_warnings_add_copies(GPtrArray *warnings, const GPtrArray *others);

/* The sentence of one of them. (transfer none) */
const char *tinker_warnings_text(const GPtrArray *warnings, guint i);

/* The sentences of all of them (of const char *, borrowed from them). (transfer container) */
GPtrArray *tinker_warnings_texts(const GPtrArray *warnings);

/* Whether one of them says just this. */
gboolean tinker_warnings_say(const GPtrArray *warnings, const char *text);

#endif
