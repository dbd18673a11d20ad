/* The laws of unilateral contact with Coulomb friction, for several contacts at once, as complementarity problems.
 *
 * Contact k has a normal and a tangential direction. Vectors hold normal and tangential entries by turns: n0, t0, n1,
 * t1, ...; u are relative velocities (normal: positive where it opens), a relative accelerations, p impulses, f forces,
 * of what touches. W, the Delassus matrix, is symmetric positive semidefinite, 2m x 2m by rows: what one unit of
 * impulse at one contact changes in the relative velocity at another. A contact without friction may leave its
 * tangential row and column 0.
 *
 * A moment that resists rolling is a contact that leans on another one, its bearer b, which comes before it: it has no
 * normal direction of its own (row, column and entries of n are 0), is closed while its bearer is, and |p_t| is at most
 * friction times the p_n of the bearer. One that is held together by other means leans on nothing, bearer -1: it is
 * always closed, and |p_t| is at most its friction itself. Problems with such contacts have W as a matrix.
 *
 * Sources: Anitescu, Potra, "Formulating dynamic multi-rigid-body contact problems with friction as solvable linear
 * complementarity problems", Nonlinear Dynamics 14 (1997) 231-247; Glocker, Pfeiffer, "Multibody Dynamics with
 * Unilateral Contacts" (1996); Genot, Brogliato, "New results on Painleve paradoxes", Eur. J. Mech. A 18 (1999)
 * 653-677. */
#ifndef TINKER_NUMERICS_CONTACT_LAWS_H
#define TINKER_NUMERICS_CONTACT_LAWS_H

#include <stddef.h>
#include <stdint.h>

typedef enum {
    TINKER_CONTACT_OPEN,
    TINKER_CONTACT_STICK,
    TINKER_CONTACT_SLIP_FORWARD,  /* u_t > 0, or about to be: friction is -mu f_n */
    TINKER_CONTACT_SLIP_BACKWARD, /* u_t < 0: friction is +mu f_n */
    TINKER_CONTACT_SMOOTH, /* slides with its friction left out: no answer of the laws, a choice of whoever asks */
} TinkerContactMode;

typedef enum {
    TINKER_CONTACT_SOLVED,
    TINKER_CONTACT_NO_ACCELERATION, /* no finite forces satisfy the laws: Painleve's paradox, an impulse has to act; or
                                       a contact closes whose normal direction (W_nn = 0) nothing can move along, or
                                       bodies are squeezed, or wedge where they should part */
    TINKER_CONTACT_GAVE_UP,         /* a number that is none */
    TINKER_CONTACT_NO_MEMORY,       /* for as many contacts at once */
} TinkerContactResult;

/* W of very many contacts is not written down; this is what it does. Functions of `context`, for vectors of 2m. */
typedef struct {
    void *context;
    /* v = W p. `size` (or NULL) gets for each entry the sum of what meets in it. */
    void (*times)(void *context, const double *p, double *v, double *size);
    /* Writes p that is 0 but where `unknown`, and v and size of it; there (W p)_i = b_i, as near as W can. A normal
     * entry brings p_t = slope p_n with it where the tangential one is not unknown itself. 0 where that cannot be
     * solved. */
    int (*solve)(void *context, const int8_t *unknown, const double *slope, const double *b, double *p, double *v,
                 double *size);
    /* Solves with W + softness / mass, to about rounding: first where unknown, with what slopes and how soft; then for
     * as many b as anybody likes. */
    void (*soften)(void *context, const int8_t *unknown, const double *slope, double softness);
    void (*solve_soft)(void *context, const double *b, double *p);
    const double *mass; /* m: of the bodies that touch, so that masses of all sizes are judged alike */
} TinkerContactMotion;

/* Impact. After it, for every contact:
 *     u_n' >= least_n,  p_n >= 0,  p_n (u_n' - least_n) = 0,
 *     |p_t| <= friction p_n;  u_t' = 0, or p_t = -friction p_n sign(u_t').
 * least_n is -restitution * u_n where the contact closes (u_n < 0), else 0 for contacts that rest. */
typedef struct {
    int32_t count;             /* m */
    const double *delassus;    /* 2m x 2m; NULL: `motion` */
    const double *velocity;    /* 2m, before */
    const double *restitution; /* m */
    const double *friction;    /* m: dynamic coefficients */
    const double *least;       /* m: least normal velocities after the impact, in place of those that restitution
                                  gives; or NULL */
    const TinkerContactMotion *motion;
    const int32_t *bearer; /* m: its own number, that of the contact it leans on, or -1; NULL: none leans on another */
    const double *driven;  /* m: restitution of what others' blows drive together, by laws that know of it; NULL: as
                              restitution */
} TinkerImpact;

/* Writes the impulses p (2m). No impact adds energy: where Newton's restitution together with friction would (the sum
 * of p . (u + u') / 2 over all contacts > 0), all coefficients of restitution are taken as smaller by one common
 * factor, the largest that does not; so too where bodies wedge, so that no impulses make them rebound as much. That
 * does not apply to `least`, for which restitution may be NULL. Where the laws leave several answers, a contact by
 * itself sticks if it can, and of up to 24 the least impulses are taken, as with tinker_contact_modes. Velocities that
 * miss what W can do by rounding are met to 1e-10 of the largest; where W is so nearly singular that nothing does, to
 * 1e-7. */
TinkerContactResult tinker_impact_solve(const TinkerImpact *impact, double *impulses);

/* Solves the laws of impact with `least` for very many contacts, to 1e-14 of the largest velocity or as near as 500
 * sweeps of projected Gauss-Seidel come. `offset` is room for 2m. FALSE where a number is none. */
int tinker_impact_sweep(const TinkerImpact *impact, double *offset, double *impulses);

/* Solves the laws of impact with `least` by pivots alone (Lemke's method), to about 1e-7 of the largest velocity. For
 * contacts that wedge, where sweeps come to no end. `room` holds tinker_impact_pivot_room doubles. FALSE where nothing
 * satisfies them. Allots nothing. */
size_t tinker_impact_pivot_room(int32_t count);
int tinker_impact_pivot(const TinkerImpact *impact, double *room, double *impulses);

/* Impact with `least` and `motion`, for a step that asks for no more than its method makes of it: impulses that keep
 * the laws to rounding; or but for what stresses that move nothing still lack (1e-5 of the largest velocity at most),
 * so met; or as near as some hundred solves come. `room` holds tinker_impact_guess_room doubles. Allots nothing. */
typedef enum {
    TINKER_IMPACT_NO_NUMBER,
    TINKER_IMPACT_APPROACHED,
    TINKER_IMPACT_MET,
} TinkerImpactGuess;
size_t tinker_impact_guess_room(int32_t count);
TinkerImpactGuess tinker_impact_guess(const TinkerImpact *impact, double *room, double *impulses);

/* Contacts that are closed (gap 0, u_n = 0) and their forces. */
typedef struct {
    int32_t count;                  /* m */
    const double *delassus;         /* 2m x 2m; NULL: `motion` */
    const double *acceleration;     /* 2m: relative accelerations without any contact force */
    const int8_t *sliding;          /* m: sign of u_t; 0: at rest along the top, and it may stick */
    const double *static_friction;  /* m */
    const double *dynamic_friction; /* m: at most the static ones */
    double noise;                   /* m/s^2: accelerations up to this are rounding */
    const TinkerContactMotion *motion;
    const int32_t *bearer; /* as in TinkerImpact */
    double *relative;      /* 2m: gets the relative accelerations with the forces found, rounding as 0; or NULL */
    int any;               /* whether of several answers any will do, not the least */
} TinkerClosedContacts;

/* Finds what every contact does from here on, and its forces f (2m):
 *     a_n >= 0,  f_n >= 0,  f_n a_n = 0;
 *     sliding: f_t = -dynamic f_n sign(u_t);
 *     at rest: a_t = 0 and |f_t| <= static f_n, or it begins to slip against f_t = -dynamic f_n sign(a_t).
 * Whoever begins to slip rubs with its dynamic coefficient from then on: where with that it holds after all, it sticks.
 * A contact that neither presses nor parts (f_n = 0, a_n within the noise) counts as closed. Where many forces do the
 * same (a mass held twice over), the least are taken, the more readily a contact moves the less (norm weighted by W),
 * that lie within the laws, away from their edges if they can be; any, of more than 24 contacts, or where `any` will
 * do, or where they are met loosely only. */
TinkerContactResult tinker_contact_modes(const TinkerClosedContacts *closed, TinkerContactMode *modes, double *forces);

/* Where tinker_contact_modes has no solution: the impulses (2m), without any approach, that end the sliding of the
 * contacts that jam. `velocity` as in TinkerImpact; its normal entries count as 0, and so do those along contacts that
 * are taken to be at rest, whose friction may well be what the others jam against. They keep the laws of an impact
 * without restitution: where p_n > 0, u_n' = 0, and u_t' = 0 or p_t = -friction p_n sign(u_t'); static coefficients at
 * contacts at rest. */
TinkerContactResult tinker_contact_jam(const TinkerClosedContacts *closed, const double *velocity, double *impulses);

#endif
