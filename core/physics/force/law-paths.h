/* Typed laws that may be large in a narrow band of time or place alone, and what they give along a step: the way of
 * each point is the cubic between the two ends of the step, with room for how far it may be from that. */
#ifndef TINKER_CORE_LAW_PATHS_H
#define TINKER_CORE_LAW_PATHS_H

#include "physics/model/model-data.h"
#include "units/compiled/compiled.h"

/* What an argument of a law is, by its name: those that the SDK's typed-law.h reserves. */
typedef enum {
    TINKER_LAW_X,
    TINKER_LAW_Y,
    TINKER_LAW_VX,
    TINKER_LAW_VY,
    TINKER_LAW_T,
    TINKER_LAW_M,
    TINKER_LAW_L,
    TINKER_LAW_RATE,
} TinkerLawArgument;

/* What a step did not resolve. */
typedef struct {
    double impulse;  /* N s */
    double change;   /* N */
    double at, step; /* s */
} TinkerLawMissed;

/* One number (N) that a law gives: a force, or the slope of a potential. */
typedef struct {
    const TinkerCompiled *force;
    TinkerBlockId block;
    int32_t a, b; /* points; b is -1 of a law at one place */
    double mass;  /* kg: the least that it acts on */
    int count;
    TinkerLawArgument arguments[TINKER_TYPED_MOST_ARGUMENTS];
    TinkerInterval whole;   /* N: that of a step that is looked at; */
    gboolean is_gentle;     /* and whether it is gentle all along */
    TinkerLawMissed missed; /* the most; 0: nothing */
    int jumps;              /* steps with a jump in them, counted since: */
    double jumps_from;      /* s */
} TinkerLawForce;

/* All of a model that are not gentle over any box. Element: TinkerLawForce. (transfer full) */
GArray *tinker_law_forces(const TinkerModel *model);

/* A step, with all points at its ends. */
typedef struct {
    double from, to; /* s */
    const TinkerPoint *first, *last;
    const double *origin;
    gboolean in_piece; /* t alone switches nothing within it */
} TinkerLawStep;

/* The force within a part of a step, from `low` to `high` (0 to 1); TRUE where it is gentle there. */
gboolean tinker_law_enclose(const TinkerLawForce *law, const TinkerLawStep *step, double low, double high,
                            TinkerInterval *force);
/* The force at one place of it. */
double tinker_law_force_at(const TinkerLawForce *law, const TinkerLawStep *step, double at);

#endif
