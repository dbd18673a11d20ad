/* States: random instances of a block type with all that its functions look at, and functions called on them.
 *
 * A state owns its arrays. Rules copy one, change the copy, and compare what the functions answer.
 */
#ifndef TINKER_CONFORMANCE_STATE_H
#define TINKER_CONFORMANCE_STATE_H

#include <math.h>

#include "conformance/probe/kit.h"

#define KIT_LABEL_SIZE 192

typedef struct {
    const TinkerBlockClass *block_class;
    int32_t count;
    int32_t ends;        /* of each instance; -1 where they differ */
    int32_t *offsets;    /* count + 1 */
    double **columns;    /* columns[c][i] */
    TinkerPoint *points; /* of every end */
    TinkerPoint *placed; /* of every end, where angles are spoken of: at t = 0 */
    TinkerPose *placed_poses;
    int32_t *has_angle;      /* of every end */
    double **placed_columns; /* as columns, at t = 0 */
    double *lengths;         /* of a line law, one an instance; */
    double *rates;           /*   independent of `points` */
    double *accelerations;   /* what graphs see: two of each end, */
    double *forces;          /*   two of each end, */
    TinkerPose *poses;       /*   one of each end (and what speaks of angles sees), */
    double *torques;         /*   one of each end, */
    double *multipliers;     /*   one a row, */
    double *contacts;        /*   four an instance */
    int32_t body_count;      /* what fields see */
    TinkerPoint *bodies;
    double *masses;
    int32_t first_body, body_range; /* whose forces are asked for */
    double time;
    double origin[2];
    guint8 *scratch;
    int32_t first;              /* number of its first instance in the state it was cut from */
    char label[KIT_LABEL_SIZE]; /* "ordinary values", for messages */
} KitState;

#define KIT_COUNT 24

/* `count` instances with ordinary values, as the declaration suggests them, that the block does not refuse. On failure
 * the check is decided and NULL answered. (transfer full) */
KitState *kit_state_new(KitCheck *check, int32_t count);
KitState *kit_state_copy(const KitState *state);
/* The instances first to first + count - 1, with the whole's scratch. (transfer full) */
KitState *kit_state_slice(const KitState *state, int32_t first, int32_t count);
void kit_state_free(KitState *state);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(KitState, kit_state_free)

/* Sizes of its arrays. */
int32_t kit_state_end_count(const KitState *state);
int32_t kit_state_rows(const KitState *state); /* of each instance; 0 unless it is a constraint */

/* Allots the scratch anew and lets the block prepare and check itself. What it says is in the batch's failure; NULL. */
TinkerStatus kit_state_prepare(KitState *state, const char **failure);

/* An ordinary value of a property's component; random. */
double kit_ordinary_value(const TinkerPropertyType *property, GRand *random);

/* What a reader needs to see the instance: "stiffness = 3, ends (0, 1) (2, 1), ...". (transfer full) */
char *kit_state_describe(const KitState *state, int32_t instance);
/* Of what a field acts on: "body 3 of 2 kg at (0, 1) with velocity (2, 1)", and with one instance its values. (transfer
 * full) */
char *kit_state_describe_body(const KitState *state, int32_t body);

/* Functions ------------------------------------------------------------------------------------------------------ */

/* Of what a result has entries. */
typedef enum { KIT_INSTANCES, KIT_ENDS, KIT_ROWS, KIT_ROW_ENDS, KIT_BODIES, KIT_ONCE } KitExtent;

typedef struct {
    const char *name;
    KitExtent extent;
    int32_t width;      /* numbers for each entry */
    gboolean integers;  /* of int32_t */
    gboolean infinite;  /* may be INFINITY */
    gboolean absent;    /* NAN says that an instance has none, where its class says that this may be */
    gboolean tolerance; /* says how nearly, not what: it may be a plain 1 m */
    gboolean angular;   /* what is written through batch->angular */
    gboolean of_g;      /* of a constraint, whose rows have a unit of their own: dimension is relative to it */
    TinkerDimension dimension[8]; /* of each of the numbers */
} KitOutput;

/* Whether a number of a result is NAN, and may be: energy of a line law that stores none (TinkerLineLaw.partly_stores).
 */
static inline gboolean kit_output_is_absent(const KitOutput *output, const KitState *state, double value)
{
    const TinkerPhysics *physics = state->block_class->physics;
    return output->absent && isnan(value) && physics->line_law != NULL && physics->line_law->partly_stores != 0;
}

#define KIT_MOST_OUTPUTS 4

typedef struct _KitFunction KitFunction;

/* The arguments of one call, in memory of the caller's choice. */
typedef struct {
    TinkerBatch *batch;
    const double *lengths, *rates;
    const TinkerPoint *points;
    const TinkerBodies *bodies;
    const TinkerGraphInput *graph;
    void *const *outputs;
} KitArguments;

struct _KitFunction {
    const char *name;
    gboolean hot;      /* called inside steps */
    gboolean optional; /* RETRY_SMALLER says "not of that form" */
    int32_t quantity;  /* of a graph */
    int32_t output_count;
    KitOutput outputs[KIT_MOST_OUTPUTS];
    TinkerStatus (*call)(const KitFunction *function, const TinkerBlockClass *block_class, const KitArguments *with);
};

/* All functions over batches that the block offers; of KitFunction. (transfer full) */
GArray *kit_functions(const TinkerBlockClass *block_class);
/* The one of this name, or NULL. */
const KitFunction *kit_function(const GArray *functions, const char *name);

/* Entries of a result on a state. */
gsize kit_output_entries(const KitOutput *output, const KitState *state);
/* The number of the first entry of a range of instances, and how many it has; of bodies those of the range. */
gsize kit_output_first(const KitOutput *output, const KitState *state, int32_t instance);

/* What a call answered. */
typedef struct {
    TinkerStatus status;
    int32_t failed_instance;
    const char *failure;              /* the plugin's static text */
    double *values[KIT_MOST_OUTPUTS]; /* room to spare before and behind; NAN where nothing was written */
    gsize entries[KIT_MOST_OUTPUTS];  /* numbers, width included */
    double *memory[KIT_MOST_OUTPUTS];
} KitAnswer;

/* Calls a function on a copy of the state. (transfer full) */
KitAnswer *kit_call(KitCheck *check, const KitFunction *function, const KitState *state);
void kit_answer_free(KitAnswer *answer);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(KitAnswer, kit_answer_free)

/* Calls a function of which only TINKER_OK will do: else the check is decided and NULL answered, */
KitAnswer *kit_call_well(KitCheck *check, const KitFunction *function, const KitState *state);

/* Sets the state's time to that of the first blow after -1 s, and asks for that blow. NULL: there is none, or the check
 * is decided. (transfer full) */
KitAnswer *kit_call_first_blow(KitCheck *check, const GArray *functions, KitState *state);

/* The batch that a state's instances make; `columns` has room for one pointer a column. */
TinkerBatch kit_state_view(const KitState *state, const double **columns);

/* What graph functions see of it; borrowed from the state. */
TinkerGraphInput kit_state_graph_input(const KitState *state);

/* The instance that an entry of a result belongs to; -1 for a body's or the whole's. */
int32_t kit_output_instance(const KitOutput *output, const KitState *state, gsize entry);

/* What an entry of a result belongs to: "instance 3", "body 2", "the whole"; and what a reader needs to see it.
 * (transfer full) */
char *kit_entry_name(const KitOutput *output, const KitState *state, gsize entry);
char *kit_entry_describe(const KitOutput *output, const KitState *state, gsize entry);

#endif
