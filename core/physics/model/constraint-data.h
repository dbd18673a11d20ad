/* The constraints of a compiled model. Constant after compiling, but for the parts under "working state", which belong
 * to the one evaluation in progress.
 *
 * Symbols: J rows of the constraints; lambda their multipliers; S = J M^-1 J^T.
 */
#ifndef TINKER_CORE_CONSTRAINT_DATA_H
#define TINKER_CORE_CONSTRAINT_DATA_H

#include "numerics/solve/sparse-ldl.h"
#include "scene/frame/batch.h"

/* What a batch that speaks of angles has of its ends beside their points (angles.h). */
typedef struct _TinkerAngles TinkerAngles;

/* One class of constraints: its rows and entries lie behind one another in the model's arrays. */
typedef struct {
    TinkerBlockBatch *batch;
    const TinkerConstraint *constraint;
    const int32_t *end_points;
    int32_t first_row, row_count;
    int32_t first_entry;  /* an entry is one end of one row, or its turn: those of a row stand behind its ends */
    TinkerAngles *angles; /* of rows that depend on them; else NULL. Borrowed. */
    double *distances;    /* of rows that keep a constant distance, which the host works out: one each; else NULL */
    gboolean coincident;  /* their ends coincide, which the host works out */
    TinkerBatch view;     /* of the whole batch */
} TinkerConstraintBatch;

typedef struct _TinkerRowChains TinkerRowChains;
typedef struct _TinkerPinChains TinkerPinChains;

/* An entry on a body that turns: what the row has beside it in the column of that body's turn. */
typedef struct {
    int32_t entry, row;
    int32_t attachment; /* where on the body */
    int32_t turn;       /* the body's number among those that turn */
    int32_t coordinate; /* its turn's */
} TinkerTurnEntry;

/* One product that is added up in S: inverse mass * J of one entry . J of another, on the same body. */
typedef struct {
    int32_t slot, first_entry, second_entry;
    double inverse_mass;
} TinkerProduct;

/* A row that holds nothing, and its slot on the diagonal of S. */
typedef struct {
    int32_t row, slot;
} TinkerIdleRow;

/* A row that repeats `first`, which stands before it, sign times (repeated-rows.h). */
typedef struct {
    int32_t row, first;
    int32_t copies; /* rows that say so, with the first */
    double sign;
    int32_t slot, first_slot; /* of both on the diagonal of S */
} TinkerRepeatedRow;

/* What a row has on a hub, a body that S leaves out: by its number in a Jacobian, in the column of one of the unknowns
 * behind the rows. */
typedef struct {
    int32_t row, unknown, entry, slot;
} TinkerHubEntry;

typedef struct {
    int32_t slot; /* of such an unknown on the diagonal */
    double mass;  /* kg: of its body */
} TinkerHubMass;

/* Whether there is a factor of S, and of which Jacobian: see TinkerConstraints. */
typedef struct {
    gboolean factored, keeps_factored, shifted;
} TinkerFactorState;

typedef struct {
    int32_t rows, entries;
    GArray *batches;        /* of TinkerConstraintBatch */
    GArray *straight;       /* of TinkerStraightRow (straight-bars.h): rows that no block has, ... */
    int32_t first_straight; /* ... from this one on, behind all others */
    int32_t fitted; /* rods of bars that depend on the others there, however nearly their rows say that they do not */
    int32_t *row_starts;                 /* rows + 1: the entries of each row */
    int32_t *points;                     /* of each entry: the centre of its body, or the point of a support */
    int32_t *ends_at;                    /* of each entry: the point itself; the array above where none turns */
    int32_t *row_of;                     /* of each entry */
    int32_t *body_starts, *body_entries; /* bodies + 1: the entries on each body */
    gboolean two_entries;                /* every row has two */
    double *scales;                      /* of each row: the length its error is measured against */
    double *inverse_scales;
    TinkerBlockId *blocks; /* of each row */
    /* Of rows that hold in one direction only, g <= 0; NULL where there are none. Slack rows do not act: their entries
     * in the arrays below are 0, and what they would be is kept as their own. */
    gboolean *unilateral, *slack; /* by row */
    int32_t *diagonal;            /* by row: its slot in S */
    double *own_g, *own_drift, *own_rate, *own_jacobian;
    TinkerIdleRow *idle; /* room for every row */
    int32_t idle_count;
    TinkerRepeatedRow *repeated; /* in the order of `first`, then of `row` */
    int32_t repeated_count;
    gboolean *repeats; /* by row; NULL where none does */
    int32_t *hubs;     /* of each body: the first unknown of its own, behind the rows; 0: it has none. NULL: no body */
    int32_t border;    /* unknowns of hubs */
    TinkerHubEntry *hub_entries;
    int32_t hub_entry_count;
    TinkerHubMass *hub_masses; /* of each of these unknowns */
    double *bordered;          /* working state: a right-hand side with them */
    TinkerProduct *products;
    gsize product_count;
    TinkerTurnEntry *turns; /* in the order of the rows */
    int32_t turn_count;
    int32_t *turn_starts;         /* rows + 1: where those of each row begin; NULL where nothing turns */
    TinkerProduct *turn_products; /* of two turns' entries, by their numbers in a Jacobian */
    gsize turn_product_count;
    gsize jacobian_size; /* numbers in a Jacobian: two an entry, then one for each of `turns` */
    TinkerSparseLdl *ldl;
    TinkerRowChains *chains;     /* of rows that hang together in chains alone; else NULL */
    TinkerPinChains *pin_chains; /* of blocks whose ends coincide that do; else NULL */
    double work;       /* J: what the last projection of positions gave, by the applied forces evaluated last */
    gboolean gave_way; /* a projection stopped short at a singular place; whoever reports it clears it */
    int32_t redundant; /* rows that depend on others at the start, with those that repeat one: told to users */
    int32_t dependent; /* without those */
    double shift;      /* of it: a share of the diagonal of S */
    int32_t rounds;    /* that a proximal solve takes, by one for any motion at the start; 0: none is */

    /* working state */
    TinkerPoint *ends; /* gathered, of the largest batch */
    double *jacobian;
    double *g, *drift, *rate;
    double miss; /* the largest |g| relative to its row's length */
    double *lambda, *residual, *correction;
    double *asked;           /* of each row: the change of speed that a projection asks for */
    double *by_point;        /* 2 per point */
    double *turned;          /* RATTLE: the Jacobian at the start of the step */
    double *displacement;    /* of a Newton step: 2 per body */
    int32_t rounds_taken;    /* by the last proximal solve */
    gboolean shifted;        /* the factor is of S + eps I: solve by proximal iteration */
    gboolean prescribed;     /* some row's dg/dt of what is prescribed is not 0 */
    gboolean factored;       /* there is a factor, ... */
    gboolean keeps_factored; /* ... of `jacobian` itself; else of this one, which else is room for the next: */
    double *factored_jacobian;
    gboolean looked; /* at a sample since the last step, which goes on with these: */
    TinkerFactorState kept;
    double *kept_jacobian, *kept_factored_jacobian;
} TinkerConstraints;

#endif
