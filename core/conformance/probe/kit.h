/* What the rules of the kit share: a rule's table row, and the check that a rule works on in its child process. */
#ifndef TINKER_CONFORMANCE_KIT_H
#define TINKER_CONFORMANCE_KIT_H

#include "conformance/probe/outcome.h"
#include "plugin/catalogue/catalogue.h"

#define KIT_PHASE_SIZE 1024
#define KIT_TEXT_SIZE  2048

/* Shared between the child, which writes, and its parent, which reads it when the child has ended. */
typedef struct {
    int32_t decided;            /* 1: outcome and text hold */
    int32_t came_back;          /* 1: the child came back from its work, and was not ended in it */
    int32_t outcome;            /* TinkerConformanceOutcome */
    char phase[KIT_PHASE_SIZE]; /* what is being done: where the child crashed */
    char text[KIT_TEXT_SIZE];
    char names[KIT_TEXT_SIZE * 8]; /* of the survey: a line for each subject, 't' or 'i' and its id */
} KitSheet;

/* One rule on one subject. */
typedef struct {
    TinkerCatalogue *catalogue;          /* of the child alone */
    const char *path;                    /* of the library, absolute */
    const TinkerBlockClass *block_class; /* NULL unless the subject is a block type */
    const TinkerIntegrator *integrator;  /* NULL unless it is an integrator */
    GRand *random;
    GPtrArray *objects; /* loader's bases of what was mapped before the library, see quiet.c */
    KitSheet *sheet;
} KitCheck;

/* The first of these that is called decides; nothing called means passed. */
void kit_fail(KitCheck *check, const char *format, ...) G_GNUC_PRINTF(2, 3);
void kit_skip(KitCheck *check, const char *format, ...) G_GNUC_PRINTF(2, 3);
/* Passed, with something to tell. */
void kit_tell(KitCheck *check, const char *format, ...) G_GNUC_PRINTF(2, 3);
gboolean kit_decided(const KitCheck *check);

/* Says what is being done, for the report of a crash. */
void kit_phase(KitCheck *check, const char *format, ...) G_GNUC_PRINTF(2, 3);

typedef void (*KitTry)(KitCheck *check);

/* A rule and what tries it on each kind of subject; NULL where it is not about such. */
typedef struct {
    TinkerConformanceRule rule;
    KitTry library, type, integrator;
} KitRule;

/* In the order of tinker_conformance_rules. */
const KitRule *kit_rule(gsize number);

/* The rules; each is described in the table of rules.c. */
void kit_try_symbols(KitCheck *check);
void kit_try_library_declaration(KitCheck *check);
void kit_try_declaration(KitCheck *check);
void kit_try_batches(KitCheck *check);
void kit_try_coupling(KitCheck *check);
void kit_try_finite(KitCheck *check);
void kit_try_momentum(KitCheck *check);
void kit_try_moment(KitCheck *check);
void kit_try_translation(KitCheck *check);
void kit_try_rotation(KitCheck *check);
void kit_try_energy(KitCheck *check);
void kit_try_passive(KitCheck *check);
void kit_try_derivatives(KitCheck *check);
void kit_try_jacobian(KitCheck *check);
void kit_try_drift(KitCheck *check);
void kit_try_motion(KitCheck *check);
void kit_try_linear(KitCheck *check);
void kit_try_law(KitCheck *check);
void kit_try_breaks(KitCheck *check);
void kit_try_dimensions(KitCheck *check);
void kit_try_memory(KitCheck *check);
void kit_try_library_process(KitCheck *check);
void kit_try_process(KitCheck *check);
void kit_try_quiet(KitCheck *check);
void kit_try_bounds(KitCheck *check);
void kit_try_hit(KitCheck *check);
void kit_try_run(KitCheck *check);
void kit_try_saved(KitCheck *check);
void kit_try_speed(KitCheck *check);

/* Decides where a stable name is not one. `whose`: "its", "a property's"; `joint` is usual between its words. */
void kit_look_at_id(KitCheck *check, const char *whose, const char *id, char joint);

void kit_try_method_declaration(KitCheck *check);
void kit_try_method_order(KitCheck *check);
void kit_try_method_steps(KitCheck *check);
void kit_try_method_limits(KitCheck *check);
void kit_try_method_constrained(KitCheck *check);
void kit_try_method_same_bits(KitCheck *check);
void kit_try_method_quiet(KitCheck *check);
void kit_try_method_speed(KitCheck *check);

#endif
