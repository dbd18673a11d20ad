/* What the files of the exact integrator share: one part of a linear system in its modes, and its propagators. */
#ifndef TINKER_NUMERICS_EXACT_PRIVATE_H
#define TINKER_NUMERICS_EXACT_PRIVATE_H

#include <glib.h>
#include <tinker/integrator.h>

#include "numerics/exact/linear-parts.h"
#include "numerics/exact/linear-response.h"

#define TINKER_EXACT_MOST_COORDINATES 1500 /* of one part with modes */
#define TINKER_EXACT_MOST_COUPLED     400  /* of one part whose modes are coupled by dampers */

/* Value and derivatives of a signal: polynomial, four; harmonic, A sin and A cos of its phase. */
typedef double TinkerExactValues[4];

#define TINKER_EXACT_MOST_LEVELS 62 /* slots of a search by halving */

/* What a signal adds to the place of an anchor at one end of an edge, as part of d. */
typedef struct {
    int32_t edge;   /* of the part */
    int32_t signal; /* of the part */
    double factor;
} TinkerExactMove;

typedef struct {
    int32_t edge; /* of the system */
    double sign;  /* of d, as the equations have it now */
    double place; /* d at the reference, anchors unmoved */
    double pull;  /* tension at the reference, anchors unmoved */
    double limit; /* of |d''| within the step; 0: d = 0 is out of reach */
    double noise; /* rounding of d */
    double now, rate, ahead;
    gboolean watched, moved, due; /* due: the sign flips before the next step */
    gboolean meets, met; /* d comes to 0 without passing at the end of the step; has done so, and is near it still */
} TinkerExactEdge;

/* A signal as the force on the modes: what acts by forces and springs, and what acts by dampers times its rate. */
typedef struct {
    int32_t id;        /* of the system */
    int32_t input;     /* index into `inputs` */
    double *by_value;  /* n */
    double *by_rate;   /* n */
    double *by_spring; /* n: the part of by_value that anchors' springs make */
} TinkerExactSignal;

/* Power that is booked: direction . eta' times the signal (or its rate), weighted into one or two books. */
typedef struct {
    int32_t signal;
    gboolean of_rate;
    const double *direction; /* n */
    int32_t books[2];        /* -1: none */
    double weights[2];
} TinkerExactPower;

/* Everything about a step of one length. */
typedef struct {
    double h; /* 0: empty */
    guint64 used;
    gboolean with_books;
    double *propagator; /* of modes: F00, F01, F10, F11, n each; else D x D */
    double *response;   /* of modes: (eta, eta') x entries, n each */
    double *forms;      /* of modes: n times D x D; else form_count times D x D */
    double *moments;    /* of modes: n times entries x D; else rows x D */
    double *gram;       /* entries x entries: integrals of products of the inputs' functions; of modes' inputs */
} TinkerExactSlot;

typedef struct {
    const TinkerSystem *system;
    const TinkerLinearSystem *linear;
    const int32_t *coordinates;
    int32_t n;
    gboolean coupled; /* the dampers couple the modes */
    GPtrArray *memory;

    double *omega, *shape, *weigh; /* x = reference + shape eta, eta' = weigh u */
    double *damping[2];            /* of dampers, of drag: n x n where coupled, else n */
    double *decay;                 /* their sum */
    double *load;                  /* constant loads on the modes */

    int32_t edge_count, move_count, signal_count, power_count;
    TinkerExactEdge *edges;
    double *elongation; /* edges x n: d of each mode */
    TinkerExactMove *moves;
    TinkerExactSignal *signals;
    TinkerExactPower *powers;
    TinkerConstantLoad *booked_loads; /* targets are local */
    int32_t booked_load_count, watched;
    gboolean booked; /* books are kept */

    /* As of the signals that were entered last. */
    TinkerLinearInput *inputs;
    int32_t input_count, entries;
    TinkerLinearInput *basis; /* of functions of time, whatever they act on */
    int32_t basis_count, basis_entries, *basis_of;
    TinkerLinearMoment *moments;
    double *drive, *unit;
    double rate; /* 1/s: a bound on the rates of all modes and inputs */
    TinkerExactSlot *slots;
    int32_t slot_count, step_slots;
    guint64 clock;
    double *slot_memory, *work;
    gsize slot_memory_size, work_size;

    double length;        /* s: of the last step, as the state went */
    double lag, lag_from; /* s: the state stands at t + lag; at the start of the last step */
    double *reference;    /* n */
    double *push;         /* n: the constant force on the modes */
    double *z, *from;     /* 2n: (scale eta, eta') now and at the start of the last step */
    double *scratch;      /* 4n: states on the way */
    double *amplitude;    /* entries x n of modes, else entries */
    double *place, *speed, *before;
    double *energy, *bend;             /* n: bounds on what each mode can do in a search, see exact-passing.c */
    double *power_sums;                /* power_count */
    TinkerExactValues *values, *ahead; /* of the signals at the start and end of a step */
    gboolean landed;                   /* the step ends where the search for a passing left the state */
    gboolean quiet;                    /* no edge can pass through d = 0 before something changes */
} TinkerExactPart;

/* exact-part.c: what a part is. NULL where it is too large, has negative stiffness or mass, or memory is out. */
TinkerExactPart *tinker_exact_part_new(const TinkerSystem *system, const TinkerLinearParts *parts, int32_t part);
void tinker_exact_part_free(TinkerExactPart *part);
static inline gpointer tinker_exact_allot(GPtrArray *memory, gsize count, gsize size)
{
    gpointer block = g_try_malloc0_n(MAX(count, 1), size);
    if (block) g_ptr_array_add(memory, block);
    return block;
}

/* exact-damping.c: the dampers in the modes; decides whether they are coupled. FALSE where memory is out. */
gboolean tinker_exact_part_damp(TinkerExactPart *part, const TinkerLinearParts *parts);

/* exact-inputs.c: takes the signals of a piece over. FALSE where memory is out. */
gboolean tinker_exact_part_enter(TinkerExactPart *part, const TinkerSignal *signals);
/* Of an input with these values: those of its rate, and a bound on its value within h. */
void tinker_exact_derivative(const TinkerLinearInput *input, const TinkerExactValues values, TinkerExactValues rate);
double tinker_exact_bound(const TinkerLinearInput *input, const TinkerExactValues values, double h);

/* Whether there are slots for every halving of a step. */
static inline gboolean tinker_exact_has_levels(const TinkerExactPart *part)
{
    return part->slot_count - part->step_slots >= TINKER_EXACT_MOST_LEVELS;
}

/* exact-slots.c: the propagator for h, to within `tolerance` of its length; NULL where h is too long.
 * Scratch slots are for interpolation and search, so that steps never use what those have made, nor lose what they use.
 */
const TinkerExactSlot *tinker_exact_slot(TinkerExactPart *part, double h, double tolerance, gboolean scratch,
                                         gboolean with_books);
/* What a step of h, at most TINKER_LINEAR_SERIES_REACH / part->rate, changes: z (2n, of coupled modes followed by the
 * inputs; of others `inputs`, entries x n) moves by `to` (2n). */
void tinker_exact_part_series(TinkerExactPart *part, double h, const double *z, const double *inputs, double *to);
/* Empties all slots and lays them out for the present inputs. FALSE where memory is out. */
gboolean tinker_exact_slots_prepare(TinkerExactPart *part);
gsize tinker_exact_slot_doubles(const TinkerExactPart *part);

/* exact-step.c */
void tinker_exact_part_start(TinkerExactPart *part, const double *q, const double *v, const TinkerSignal *signals,
                             double t);
/* Adds up the constant force on the modes from the edges' signs. */
void tinker_exact_part_set_constant_forces(TinkerExactPart *part);
void tinker_exact_part_values(TinkerExactPart *part, const TinkerSignal *signals, double t, TinkerExactValues *values);
/* Sets the amplitudes of the inputs from signal values. */
void tinker_exact_part_drive(TinkerExactPart *part, TinkerExactValues *values);
void tinker_exact_part_advance(TinkerExactPart *part, const TinkerExactSlot *slot, const double *from, double *to);
/* Takes the part from where the last step began to a place inside it, adding to `books` unless that is NULL; the
 * state there, in memory of the part. NULL where that cannot be worked out. */
const double *tinker_exact_part_inside(TinkerExactPart *part, const TinkerSignal *signals, double t_from, double h,
                                       double tolerance, double *books);
void tinker_exact_part_write(TinkerExactPart *part, const double *z, double *q, double *v);

/* exact-books.c: adds a step's energies; amplitudes and `values` are those at `from`, `ahead` those at `to`. */
void tinker_exact_part_book(TinkerExactPart *part, const TinkerExactSlot *slot, const double *from, const double *to,
                            double *books);

/* exact-passing.c: how far into the step of h the part goes before an edge reaches d = 0, at most h; marks such
 * edges. */
double tinker_exact_part_passing(TinkerExactPart *part, const TinkerSignal *signals, double t, double h);

#endif
