/* A rule, and what came of trying it. */
#ifndef TINKER_CONFORMANCE_OUTCOME_H
#define TINKER_CONFORMANCE_OUTCOME_H

typedef enum {
    TINKER_CONFORMANCE_PASSED,
    TINKER_CONFORMANCE_FAILED,
    TINKER_CONFORMANCE_SKIPPED, /* the rule does not apply; the text says why */
} TinkerConformanceOutcome;

/* A rule, as a list shows it. Static. */
typedef struct {
    const char *name;     /* "batches" */
    const char *sentence; /* what it holds */
} TinkerConformanceRule;

#endif
