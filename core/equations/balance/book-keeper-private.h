/* What the files that keep books share. */
#ifndef TINKER_CORE_BOOK_KEEPER_PRIVATE_H
#define TINKER_CORE_BOOK_KEEPER_PRIVATE_H

#include "equations/balance/book-nodes-private.h"
#include "equations/balance/books.h"
#include "equations/state/model-state.h"
#include "physics/constraint/jolts.h"

typedef struct {
    TinkerBookEntry entry;
    double work, impulse, angular; /* of magnitudes */
} TinkerBookAccount;

typedef struct {
    TinkerBlockId block;
    double mass, inertia; /* kg; kg m^2, 0 of one that does not turn */
    double speed[3];      /* m/s, m/s, rad/s: before a jump */
} TinkerBookBody;

/* Something happened in the run: contact, a jerk, a rope that went taut. */
typedef struct {
    double time;
    char *blocks; /* names, joined by ", " */
} TinkerBookInstant;

typedef struct {
    TinkerScene *scene;
    TinkerModel *model;
    TinkerBooks *books;
    GArray *bodies;   /* of TinkerBookBody */
    GArray *accounts; /* of TinkerBookAccount, by block id */
    GArray *panels;   /* of TinkerBookPanel */
    GArray *nodes;    /* of TinkerBookNode */
    guint next;       /* node */
    GArray *columns;
    const GPtrArray *instants; /* of TinkerBookInstant: those of the run before */
    GArray *jolts;             /* of TinkerJolt: of this run */
    double greatest[3]; /* sums over the bodies of kinetic energy, |momentum|, |angular momentum|: the greatest */
} TinkerBookKeeper;

/* The body of a block; NULL where it is none of those whose books these are. */
TinkerBookBody *tinker_book_body(const TinkerBookKeeper *keeper, TinkerBlockId block);

TinkerBookAccount *tinker_book_account(TinkerBookKeeper *keeper, TinkerBlockId by);

/* The moments of motion at a state, kept as those before (0), after (1) or of neither (-1). */
void tinker_book_add_motion(TinkerBookKeeper *keeper, const TinkerModelState *state, int which);

/* What the forces at a state do in so many seconds; at the end they are Newton's as well. `values` are what panels are
 * judged by: power, forces and moment of all, each by a number of its own, so that a jump of one is seen though another
 * one makes up for it. */
void tinker_book_add_forces(TinkerBookKeeper *keeper, const TinkerModelState *state, double weight, gboolean end,
                            double values[TINKER_BOOK_FUNCTIONS]);

/* Looks at velocities just before instants (`since` is INFINITY), and behind them, the first of which is `since` and
 * the last the state's time. */
void tinker_book_look_for_jumps(TinkerBookKeeper *keeper, const TinkerModelState *state, double since);

/* The motion at time 0, whose state is the one behind blows there: the books begin before them. The state is left as it
 * was. */
void tinker_book_begin_before_blows(TinkerBookKeeper *keeper, TinkerModelState *state);

/* Fills the books from the accounts. */
void tinker_book_conclude(TinkerBookKeeper *keeper);

#endif
