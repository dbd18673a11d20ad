/* What impacts, forces and jams have in common: with v = b + W p, at every contact
 *
 *     v_n >= 0,  p_n >= 0,  v_n p_n = 0,
 *     sliding:  p_t = -friction p_n sign,
 *     else:     |p_t| <= friction p_n, and v_t = 0 or p_t = -friction p_n sign(v_t). */
#ifndef TINKER_NUMERICS_CONTACT_PRIVATE_H
#define TINKER_NUMERICS_CONTACT_PRIVATE_H

#include <glib.h>

#include "numerics/contact/contact-laws.h"

typedef struct {
    int32_t count;
    const double *delassus; /* 2m x 2m, symmetric positive semidefinite; NULL: `motion` */
    const double *offset;   /* 2m: b */
    const double *friction; /* m */
    const int8_t *sliding;  /* m: -1, 0, 1; NULL: none slides */
    const TinkerContactMotion *motion;
    const int32_t *bearer; /* m; NULL: none leans on another */
    const double *load;    /* m: of one whose bearer is -1, in place of a normal impulse; NULL: 1 */
    const double *least;   /* m: for tinker_contact_by_complementarity(), p_n in place of 0 at least; NULL: 0 */
    gboolean any;          /* of several answers any will do, not the least */
} TinkerContactProblem;

/* Closed contacts keep p_t = slope p_n, but where they stick. */
typedef enum {
    TINKER_STATE_OPEN,
    TINKER_STATE_STICK,
    TINKER_STATE_FORWARD,  /* v_t >= 0 */
    TINKER_STATE_BACKWARD, /* v_t <= 0 */
    TINKER_STATE_FREE,     /* without friction */
} TinkerContactState;

/* Writes p (2m). NO_ACCELERATION: there is none, because a contact slides with friction and jams; or a normal direction
 * that nothing moves along has b_n < 0 (then p is what the other contacts do). */
TinkerContactResult tinker_contact_solve(const TinkerContactProblem *problem, double *p);

/* v = b + W p, entry i; `size` is the sum of what meets in it, or NULL. */
double tinker_contact_velocity(const TinkerContactProblem *problem, const double *p, int32_t i, double *size);
/* v = b + W p and the sizes for all entries, W given as a matrix or as a motion. */
void tinker_contact_velocities(const TinkerContactProblem *problem, const double *p, double *v, double *size);

/* tinker_contact_solve where W is a motion; GAVE_UP where it finds none. */
TinkerContactResult tinker_contact_solve_many(const TinkerContactProblem *problem, double *p);

/* A problem with its scales and its room. Scales are powers of two, one a contact, so that cones of friction stay as
 * they are; W is near 1 then, and so is the largest b. */
typedef struct {
    TinkerContactProblem problem; /* scaled */
    double *scale;                /* m: p = scaled p * scale * unit */
    double unit;
    double floor;         /* what counts as meeting in every v, besides what does */
    gboolean blocked;     /* b_n < 0 where nothing moves: that contact is left out */
    gboolean singular;    /* the last states that were tried leave some impulses open */
    double *centre;       /* 2m: of a proximal point */
    double *kept;         /* 2m: an answer, while another one is looked for */
    double *grip, *least; /* m: coefficients of friction, and least normal impulses, while it is */
    double *p, *v, *size; /* 2m */
    double *system;       /* 2m x 2m */
    double *right;        /* 2m */
    double *lcp;          /* 4m x 4m */
    double *lcp_room;
    int32_t *unknown; /* 2m: which entries of p are unknown */
    int32_t *order;   /* 2m */
    TinkerContactState *state;
} TinkerContactWork;

/* Works out v from p. TRUE where they keep the laws in these states, but for a share of `tolerance` of what meets in
 * them; else `next`, if not NULL, is told what the states should rather be. */
gboolean tinker_contact_check(TinkerContactWork *work, double tolerance, TinkerContactState *next);

/* Checks the laws with v and size that were worked out before, as tinker_contact_check() does. */
gboolean tinker_contact_judge(TinkerContactWork *work, double tolerance, TinkerContactState *next);

/* Checks the states with the p that solves W p = -b as they have it. */
gboolean tinker_contact_try_states(TinkerContactWork *work, double tolerance, TinkerContactState *next);

/* Takes from p what it misses by, as it was checked last: the states stay as they are. */
void tinker_contact_correct(TinkerContactWork *work);

/* By how much the impulses miss the laws, as a velocity: 0 where they keep them, whatever states they are of. */
double tinker_contact_miss(TinkerContactWork *work);

/* Solves the problem as a linear complementarity problem, with softening (p - centre) times what a contact has in W
 * itself added to v; centre may be NULL: 0. Leaves p and state. */
gboolean tinker_contact_by_complementarity(TinkerContactWork *work, double softening, const double *centre);

/* Where the laws leave several answers: puts the least, of those that keep them to `tolerance`, in the place of the one
 * that was found. `states` is room for m. */
void tinker_contact_take_least(TinkerContactWork *work, double tolerance, TinkerContactState *states);

/* The contact whose normal impulse bounds the friction of contact k. */
static inline int32_t tinker_contact_bearer(const TinkerContactProblem *problem, int32_t k)
{
    return problem->bearer != NULL ? problem->bearer[k] : k;
}

static inline gboolean tinker_contact_leans(const TinkerContactProblem *problem, int32_t k)
{
    return tinker_contact_bearer(problem, k) != k;
}

/* Whether its friction is bounded by a number. */
static inline gboolean tinker_contact_is_held(const TinkerContactProblem *problem, int32_t k)
{
    return tinker_contact_bearer(problem, k) < 0;
}

/* What the friction of contact k is bounded by, times its coefficient. */
static inline double tinker_contact_normal(const TinkerContactProblem *problem, const double *p, int32_t k)
{
    const int32_t bearer = tinker_contact_bearer(problem, k);
    if (bearer >= 0) return p[2 * bearer];
    return problem->load != NULL ? problem->load[k] : 1;
}

/* Whether contact k may hold by friction. */
static inline gboolean tinker_contact_grips(const TinkerContactProblem *problem, int32_t k)
{
    int32_t t = 2 * k + 1;
    return (problem->sliding == NULL || problem->sliding[k] == 0) && problem->friction[k] > 0 &&
           (problem->delassus == NULL || problem->delassus[t * (2 * problem->count + 1)] > 0);
}

/* One sweep of projected Gauss-Seidel over all contacts, from the impulses p on; answers the largest change of a
 * velocity. */
double tinker_contact_sweep(const TinkerContactProblem *problem, double *p);

/* p_t / p_n of a closed contact that does not stick. */
static inline double tinker_contact_slope(const TinkerContactProblem *problem, int32_t k, TinkerContactState state)
{
    if (problem->sliding != NULL && problem->sliding[k] != 0) return -problem->friction[k] * problem->sliding[k];
    return state == TINKER_STATE_FORWARD    ? -problem->friction[k]
           : state == TINKER_STATE_BACKWARD ? problem->friction[k]
                                            : 0;
}

/* The impulse along t of one that is bounded by a number, and slides; 0 for all others. */
static inline double tinker_contact_held_slip(const TinkerContactProblem *problem, int32_t k, TinkerContactState state)
{
    if (!tinker_contact_is_held(problem, k)) return 0;
    return tinker_contact_slope(problem, k, state) * tinker_contact_normal(problem, NULL, k);
}

#endif
