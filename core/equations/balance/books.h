/* Three ways to keep the books of bodies over an interval: Newton's law at its end, work and energy, impulse and
 * momentum (linear, and angular about a point), each with what every force gave and what is left over.
 *
 * Powers, forces and moments are integrated over the run itself, by Gauss's rule with 8 points between all instants at
 * which a force is known to jump (M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, table 25.4). Panels
 * are divided where the Legendre series of a function does not die out, or does not go on into the next panel's, as
 * about a jump that nobody told of, until the integrals stand still. What an impact gives is the jump of the velocity.
 */
#ifndef TINKER_CORE_BALANCE_BOOKS_H
#define TINKER_CORE_BALANCE_BOOKS_H

#include "equations/state/model-state.h"
#include "physics/plan/run-options.h"

/* What one kind of force of a block did. */
typedef struct {
    double force[2];   /* N, at the end */
    double work;       /* J */
    double impulse[2]; /* N s */
    double angular;    /* N m s, about the point */
} TinkerBookShare;

/* What one block did. */
typedef struct {
    TinkerBlockId by;
    gboolean inner; /* it acts between the bodies: its forces cancel, and only its work counts */
    TinkerBookShare all;
    gboolean rubs;            /* it touches, and friction did something: */
    TinkerBookShare friction; /* of all this; the rest is of normal forces, and of impacts */
} TinkerBookEntry;

typedef struct {
    double time;
    TinkerBlockId by, on; /* `by` is -1 where the jump cannot be told to be of one block */
    double impulse[2], work;
} TinkerBookImpact;

/* Before and after, what is left over (change less sum; of vectors the length of the difference), and the size that it
 * is to be measured by. */
typedef struct {
    double residual, scale;
} TinkerBookBalance;

typedef struct {
    double from, to;
    double about[2];
    GArray *entries;       /* of TinkerBookEntry, in the order of the scene */
    GArray *impacts;       /* of TinkerBookImpact, by time; in the entries as well, but those by nobody known */
    double rate[2];        /* N: of momentum at the end, m a by the record */
    double kinetic[2];     /* J: at the start, at the end */
    double momentum[2][2]; /* kg m/s: at the start, at the end */
    double angular[2];     /* kg m^2/s */
    TinkerBookBalance newton, energy, impulse, moment;
    /* By how much the integrals still changed when there were as many panels as there may be, relative to the scales:
     * the forces swing too fast for them. 0: they stand still. */
    double unsettled;
} TinkerBooks;

/* The books of bodies (ended by -1) from one time to another of a run with these options, whose samples do not matter.
 * Errors are those of running. (transfer full) */
TinkerBooks *tinker_books_new(TinkerScene *scene, const TinkerRunOptions *options, const TinkerBlockId *bodies,
                              double from, double to, const double about[2], GError **error);
/* An entry as it is told: whole, or normal forces with impacts, and friction. How many parts there are. */
int tinker_book_parts(const TinkerBookEntry *entry, TinkerBookShare parts[2]);

void tinker_books_free(TinkerBooks *books);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerBooks, tinker_books_free)

#endif
