/* Tinker SDK: integrators.
 *
 * An integrator advances an abstract second-order system
 *
 *     M dv/dt = f(q, v, t) + J^T lambda,   dq/dt = v,   g(q, t) = 0
 *
 * and knows nothing of scenes. The host owns the state; the integrator owns its stages and whatever dense output needs.
 * Besides q and v the system has `books`: energy integrals dw/dt = power(q, v, t) that are advanced with the method's
 * own order. They enter no error control, but for where velocities hardly change: there the motion tells nothing of
 * them, and an adaptive method had better ask how well they are integrated.
 *
 * Steppers may be at work at once, each on a thread of its own: what one keeps is in what `create` allotted, and
 * nowhere else.
 *
 * Waveforms switch only at breaks, and the host never asks for a step across one; within a step they are smooth up to
 * and including both ends.
 */
#ifndef TINKER_INTEGRATOR_H
#define TINKER_INTEGRATOR_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Flags of a system. */
#define TINKER_SYSTEM_CONSTRAINED        (1u << 0) /* there are constraint rows */
#define TINKER_SYSTEM_VELOCITY_DEPENDENT (1u << 1) /* f depends on v */

/* Places of a sparse square matrix, compressed by rows, columns ascending, the diagonal included; as a pattern it is
 * symmetric. Constant for the life of the system. */
typedef struct TinkerPattern {
    int32_t size;
    int32_t entries;
    const int32_t *row_starts; /* size + 1 */
    const int32_t *columns;    /* entries */
} TinkerPattern;

/* Linear systems ------------------------------------------------------------------------------------------------- */

/* A spring and a damper between two coordinates, or between one and an anchor. With d = x_b - x_a and s the sign of d,
 * which stays until d reaches 0, it pulls a towards b with
 *     s * tension + stiffness * (d - s * length) + damping * dd/dt. */
typedef struct TinkerLinearEdge {
    int32_t a, b; /* coordinate; -1 - k for anchor k */
    double stiffness, length, damping, tension;
} TinkerLinearEdge;

/* An input: a function of time, in the form that it has between two breaks. */
#define TINKER_SIGNAL_POLYNOMIAL 0 /* sum of coefficient[k] * (t - origin)^k */
#define TINKER_SIGNAL_HARMONIC   1 /* coefficient[0] * sin(coefficient[1] * (t - origin) + coefficient[2]) */
typedef struct TinkerSignal {
    int32_t kind;
    int32_t reserved;
    double origin; /* s */
    double coefficient[4];
} TinkerSignal;

/* Adds factor * signal to the force on a coordinate (N), or to the place of an anchor (m). */
typedef struct TinkerSignalUse {
    int32_t target; /* coordinate or anchor */
    int32_t signal;
    int32_t book; /* that the force's power is booked in; -1: none */
    int32_t reserved;
    double factor;
} TinkerSignalUse;

/* A constant force on a coordinate (N). */
typedef struct TinkerConstantLoad {
    int32_t target;
    int32_t book; /* -1: conservative */
    double force;
} TinkerConstantLoad;

/* M x'' = edges - drag x' + loads, coordinate by coordinate: what a system amounts to whose parts move on one line, or
 * hang on springs without length. */
typedef struct TinkerLinearSystem {
    uint32_t struct_size;
    int32_t size; /* coordinates: TinkerSystem.size */
    int32_t edge_count, anchor_count, signal_count, load_count, force_count, motion_count;
    const double *mass; /* size */
    const double *drag; /* size, N s/m; NULL: none */
    const TinkerLinearEdge *edges;
    const double *anchors;                        /* place of each, unmoved */
    const TinkerConstantLoad *loads;              /* load_count */
    const TinkerSignalUse *forces;                /* force_count: on coordinates */
    const TinkerSignalUse *motions;               /* motion_count: of anchors */
    int32_t damper_book, drag_book, support_book; /* -1: none */
    int32_t reserved;
} TinkerLinearSystem;

/* The system, as functions over plain arrays. All but those marked "may be NULL" are provided; arrays do not overlap
 * unless it is said. Answers other than TINKER_OK leave the outputs undefined. */
typedef struct TinkerSystem {
    uint32_t struct_size;
    uint32_t flags;
    int32_t size;       /* n: entries of q, v and a */
    int32_t books;      /* m: entries of power; may be 0 */
    void *context;      /* first argument of every function */
    const double *mass; /* n entries: diagonal of M */

    /* a = M^-1 (f + J^T lambda), power[m] unless it is NULL. */
    TinkerStatus (*acceleration)(void *context, double t, const double *q, const double *v, double *a, double *power);
    /* a = M^-1 f: the applied forces alone; power[m] unless it is NULL, of constraints too. */
    TinkerStatus (*applied)(void *context, double t, const double *q, const double *v, double *a, double *power);
    /* Brings q back onto g(q, t) = 0 by mass-weighted Newton steps, then v onto J v + dg/dt = 0. *moved says whether
     * anything changed. Does nothing on an unconstrained system. */
    TinkerStatus (*project)(void *context, double t, double *q, double *v, int32_t *moved);
    /* RATTLE's position stage: finds mu with g(q + M^-1 J(q_from, t_from)^T mu, t) = 0, adds that displacement to q and
     * the displacement / h to v. */
    TinkerStatus (*constrain_step)(void *context, double t_from, const double *q_from, double t, double h, double *q,
                                   double *v);
    /* Mass-weighted projection of v, at the place q: onto J v + dg/dt = 0, or where `homogeneous` is 1 onto J v = 0. */
    TinkerStatus (*project_velocity)(void *context, double t, const double *q, double *v, int32_t homogeneous);
    /* out = d(M^-1 f)/dv times dv, the applied forces' damping, at (t, q, v). */
    TinkerStatus (*damping_product)(void *context, double t, const double *q, const double *v, const double *dv,
                                    double *out);
    /* What errors are measured against: the extent (m) and the largest speed (m/s) of the system so far, this state
     * included. Either may be 0. */
    void (*scales)(void *context, const double *q, const double *v, double *extent, double *speed);
    /* Why the last function failed, as static or system-owned text; NULL where nothing is known. */
    const char *(*failure)(void *context);
    /* The derivatives of the applied forces: stiffness = -df/dq (N/m) and damping = -df/dv (N s/m), `entries` values
     * each in the order of the pattern. Exact where the blocks give theirs, differences elsewhere. */
    const TinkerPattern *pattern;
    TinkerStatus (*jacobian)(void *context, double t, const double *q, const double *v, double *stiffness,
                             double *damping);
    /* The same system in linear form; NULL where it has none. */
    const TinkerLinearSystem *linear;
    /* The form of every signal in the piece between breaks that the host entered last. NULL where `linear` is. */
    TinkerStatus (*signals)(void *context, TinkerSignal *signals);
    /* J^T W J at (t, q), `entries` values in the order of the pattern: W is diagonal, and holds the mass that moves
     * along each row, 1 / (J M^-1 J^T). An implicit method adds a multiple of it, so that its linear solves leave the
     * constraints alone. NULL where `jacobian` is, and on an unconstrained system. */
    TinkerStatus (*row_masses)(void *context, double t, const double *q, double *values);
} TinkerSystem;

/* The state that a step advances; owned by the host. */
typedef struct TinkerState {
    double t;
    double *q;
    double *v;
    double *books;
} TinkerState;

typedef struct TinkerIntegratorOptions {
    uint32_t struct_size;
    int32_t reserved;
    double tolerance;       /* of an adaptive method: relative to the scales of the system */
    double first_step;      /* s: 0 lets the method choose */
    double spectral_radius; /* of a dissipative method: at infinite frequency */
} TinkerIntegratorOptions;

/* What the last step did. */
typedef struct TinkerStepReport {
    uint32_t struct_size;
    int32_t rejected; /* trials that were thrown away */
    double t_from;
    double step;         /* s */
    double error;        /* estimate relative to the tolerance, at most 1; 0 for a fixed step */
    const char *failure; /* static text: why the step failed, or NULL */
} TinkerStepReport;

/* Flags of an integrator. */
#define TINKER_INTEGRATOR_ADAPTIVE   (1u << 0) /* takes a tolerance; else a step */
#define TINKER_INTEGRATOR_EXPLICIT   (1u << 1) /* stable only below a step */
#define TINKER_INTEGRATOR_SYMPLECTIC (1u << 2) /* where the system is undamped */
#define TINKER_INTEGRATOR_LINEAR     (1u << 3) /* needs TinkerSystem.linear */
#define TINKER_INTEGRATOR_IMPLICIT   (1u << 4) /* asks for the jacobian */
#define TINKER_INTEGRATOR_DISSIPATES (1u << 5) /* takes energy from unresolved motion, on purpose */
#define TINKER_INTEGRATOR_FLAGS      0x3fu     /* all of them; a library that sets others is refused */

typedef struct TinkerIntegrator {
    uint32_t struct_size;
    uint32_t flags;
    const char *id;      /* the "method" in a scene, "rk4" */
    const char *title;   /* "Classical Runge-Kutta, order 4" */
    const char *summary; /* one sentence: what it is for */
    const char *source;  /* where the method comes from */
    int32_t order;
    int32_t dense_order;          /* of the interpolation between steps */
    int32_t evaluations_per_step; /* of accelerations, where nothing is rejected */
    int32_t reserved;
    double imaginary_limit; /* h * omega of an undamped oscillator at the edge of stability; 0: unstable for any; < 0:
                               none */
    double real_limit;      /* h * c / m of a pure damper at the edge of stability; < 0: no limit */

    /* A stepper for this system, which outlives it; all memory that steps need is allotted here, but for what a solver
     * of somebody else's sets up when it sees its first matrix. NULL: out of memory. */
    void *(*create)(const TinkerSystem *system, const TinkerIntegratorOptions *options);
    void (*destroy)(void *stepper);
    /* Forgets what was carried over from earlier steps: the state was changed, or a derivative jumped. */
    void (*restart)(void *stepper);
    /* One accepted step. A fixed-step method steps exactly to `limit`; an adaptive one as far as its error control
     * allows, never past `limit`, and lands exactly on it where little remains; one of linear systems ends earlier
     * where the system that it was given changes. On a constrained system the new state is projected. On failure the
     * state is as before. */
    TinkerStatus (*step)(void *stepper, TinkerState *state, double limit, TinkerStepReport *report);
    /* The state at t inside the last step, from dense output, not projected. `books` may be NULL. */
    TinkerStatus (*interpolate)(void *stepper, double t, double *q, double *v, double *books);
} TinkerIntegrator;

#ifdef __cplusplus
}
#endif
#endif
