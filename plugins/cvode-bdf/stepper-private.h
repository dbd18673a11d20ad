/* What the parts of the integrator share: one run's memory. */
#ifndef CVODE_BDF_STEPPER_PRIVATE_H
#define CVODE_BDF_STEPPER_PRIVATE_H

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <tinker/integrator.h>

/* The unknowns are y = (q, v), 2n of them. */
typedef struct Stepper {
    const TinkerSystem *system;
    double tolerance; /* that one step may spend, relative to the scales */
    SUNContext context;
    void *cvode;
    N_Vector y, weights;
    double *work; /* 2n */
    double *from_misses,
        *to_misses; /* 2n: what CVODE's polynomial of the last step lacks to the host's states at its ends */

    /* Newton's matrix */
    SUNMatrix matrix;
    SUNLinearSolver solver;
    double *stiffness, *damping; /* in the order of the pattern; NULL where no jacobian is offered */
    sunindextype *row_starts;    /* of the sparse matrix: 2n + 1; NULL where it is dense */
    sunindextype *columns;
    double fastest; /* rad/s: bound of the frequencies, from the last jacobian; 0: not known */

    /* the books */
    double *books_from, *power_to,
        *power_within;  /* at the start of the last step; powers at its end, at a time within */
    double *powers;     /* at places within the step, of all books at each */
    double energy;      /* J: the largest kinetic energy so far */
    int even;           /* velocities hardly changed in the last step ... */
    double slowest;     /* m/s: ... beside this ... */
    double books_error; /* ... so that its books tell by themselves what they are off by: of what is let pass */
    double longest;     /* s: that they let a step be; 0: any */

    /* the order */
    int capped;             /* at order 2 */
    long steps_since_cap;   /* steps */
    long stability_reports; /* of CVODE, since its last start */

    /* the last step */
    int fresh;       /* CVODE has to be started from the host's state */
    int done;        /* there is a last step ... */
    double from, to; /* ... between these times */
    double first_step;
    double start_extent, start_speed; /* that the motion was headed for at the last start */
} Stepper;

/* Length of y: 1 where nothing can move, as CVODE needs something to step. */
static inline sunindextype stepper_unknowns(const TinkerSystem *system)
{
    return system->size > 0 ? 2 * (sunindextype)system->size : 1;
}

/* newton.c ------------------------------------------------------------------------------------------------------- */

/* Allots Newton's matrix and its solver and hands them to CVODE. 0 where memory is short. */
int stepper_newton_create(Stepper *stepper);
void stepper_newton_destroy(Stepper *stepper);

/* order-limit.c -------------------------------------------------------------------------------------------------- */

/* CVODE was started anew. */
void stepper_order_restart(Stepper *stepper);

/* After a step: lowers or raises the order that CVODE may use. It must be started anew where this answers 1. */
int stepper_order_watch(Stepper *stepper);

/* scales.c ------------------------------------------------------------------------------------------------------- */

/* The largest magnitude among numbers; 0 of none. */
double stepper_largest(int32_t count, const double *x);

/* Before CVODE is started: finds the scales that the motion is headed for, by what the accelerations `a` can bring
 * about until `limit`. */
void stepper_scales_start(Stepper *stepper, const TinkerState *state, double limit, const double *a);

/* CVODE's weights, the inverse of what errors in q and in v are measured against, and its norm: the largest weighted
 * entry, where CVODE's own is their root mean square. */
int stepper_weights(N_Vector y, N_Vector weights, void *data);
realtype stepper_norm(N_Vector errors, N_Vector weights);

/* books.c --------------------------------------------------------------------------------------------------------- */

/* 0 where memory is short. */
int stepper_books_create(Stepper *stepper);
void stepper_books_destroy(Stepper *stepper);

/* Notes the books and the powers at the start of a step, where the last one ended, and how large the kinetic energy is:
 * a small share of it is all that books are asked for. */
void stepper_books_begin(Stepper *stepper, const TinkerState *state);

/* Before they are integrated over a step from this state: whether velocities hardly change in it, by those at its end
 * and the accelerations there. */
void stepper_books_look(Stepper *stepper, const TinkerState *state, double to, const double *v, const double *a);

/* The books at `to`, within the last step that CVODE made from `from`, by the powers there. Uses `weights` for work. */
TinkerStatus stepper_books_integrate(Stepper *stepper, double from, double to, const double *power_to, double *books);

/* After the books of a step of `span` were integrated: whether they are known well enough. If not, it must be made
 * again, anew; CVODE then makes no step that is as long. */
int stepper_books_accept(Stepper *stepper, double span);

#endif
