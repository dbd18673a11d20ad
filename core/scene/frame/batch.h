/* Snapshots of a scene's tables, ready to be handed to plugins: columns of their own, with defaults resolved and
 * waveform columns kept up to date.
 *
 * A run works on a snapshot, so later edits of the scene do not reach it. */
#ifndef TINKER_CORE_BATCH_H
#define TINKER_CORE_BATCH_H

#include "plugin/call/call.h"
#include "scene/store/scene.h"

typedef struct _TinkerBlockBatch TinkerBlockBatch;

/* All blocks of one class. The members are read-only to others; ids, columns and ends may be those of another batch
 * (tinker_batches_take). */
struct _TinkerBlockBatch {
    TinkerScene *scene; /* borrowed */
    const TinkerBlockClass *block_class;
    int32_t count;
    TinkerBlockId *ids;
    double **columns;     /* columns[c][row] */
    int32_t ends;         /* of each block; -1 where they differ */
    int32_t end_count;    /* of all blocks */
    int32_t *end_offsets; /* count + 1 entries */
    TinkerSceneEnd *end;  /* of all blocks, row by row */
    int32_t waveforms;    /* waveform properties of the class */
    int32_t evaluator_count;
    TinkerWaveformEvaluator **evaluators; /* waveform by waveform, row by row; then of what t alone switches in laws.
                                             NULL where there are none, and so below */
    int32_t *evaluator_rows;              /* whose they are */
    int32_t *waveform_columns;            /* first column of each waveform property */
    struct _TinkerPiece *pieces;          /* of each evaluator, what is known of its next break */
    double earliest, latest;              /* s: of times that laws are given, see tinker_block_batch_bound_laws */
    void *scratch;                        /* as the class's physics asked for; see guarded.h */
    double *end_masses;                   /* kg: see TinkerBatch; NULL: not known */
    gboolean has_timed_law, has_law_of_velocity; /* of any block */
    int32_t law_count;                           /* typed laws of each block, */
    struct TinkerTypedLaw **laws;                /* row by row; NULL: an empty text, or one that cannot be read: */
    int32_t point_list_count;                    /* lists of points of each block, */
    TinkerPointList *point_lists;                /* row by row; NULL where there are none */
    GPtrArray *law_notes; /* of char *: "NAME: ...", where units do not come out; NULL: nothing is typed */
    char *law_fault;      /* "NAME: ..."; NULL: none */
};

/* A snapshot of every table with at least one block, of the blocks that `include` has TRUE for (by block id; NULL:
 * all). "As placed" properties stay NaN. Element: TinkerBlockBatch *. (transfer full) */
GPtrArray *tinker_batches_new(TinkerScene *scene, const gboolean *include);

/* Some blocks of these batches: `numbers` of rows, counted from 0 batch by batch, ascending. What was filled in since
 * the snapshot, such as lengths as placed, is there as well; scratch is not. Rows without waveforms that lie one behind
 * the other are not copied: these batches outlive those. (transfer full) */
GPtrArray *tinker_batches_take(const GPtrArray *batches, const int32_t *numbers, int32_t count);

/* The rows of the largest batch. */
int32_t tinker_batches_most_rows(const GPtrArray *batches);

/* The time that typed laws are given at t: an end of a piece lies within it, by some ulp. */
static inline double tinker_block_batch_inside(const TinkerBlockBatch *batch, double t)
{
    return t < batch->earliest ? batch->earliest : t > batch->latest ? batch->latest : t;
}

/* The view of a whole batch that plugins get, at time t. */
TinkerBatch tinker_block_batch_view(TinkerBlockBatch *batch, double t);

/* The name of the block in a row; what TinkerPluginCall.name wants. */
const char *tinker_block_batch_name(const void *batch, int32_t row);

/* "NAME: what the plugin says of its failure", about the instance that the view names; `otherwise` (one that is
 * translated) where it says nothing. (transfer full) */
char *tinker_block_batch_refusal(const TinkerBlockBatch *batch, const TinkerBatch *view, const char *otherwise);

/* Every call of a plugin about a batch: an expression of its answer. `function` names what is called, in messages. */
#define TINKER_CALL_BATCH(blocks, function, view, call)                                                                \
    TINKER_CALL(call, .phase = (function), .block_class = (blocks)->block_class, .batch = (view),                      \
                .name = tinker_block_batch_name, .source = (blocks))

/* Whether a typed law of the block depends on t. */
gboolean tinker_block_batch_is_timed(const TinkerBlockBatch *batch, int32_t row);
/* Whether the energy is known that its typed law stores. */
gboolean tinker_block_batch_stores(const TinkerBlockBatch *batch, int32_t row);

/* The entry of a block's row that has a meaning (TINKER_MEANING_...), by component; `otherwise` where no property has
 * it. */
double tinker_block_batch_meaning(const TinkerBlockBatch *batch, int32_t row, int32_t meaning, int32_t component,
                                  double otherwise);

/* Evaluates all waveforms of the batch at t into its columns. */
void tinker_block_batch_set_time(TinkerBlockBatch *batch, double t);
/* Puts what of each waveform is steady into its column, with derivatives of 0. */
void tinker_block_batch_set_steady(TinkerBlockBatch *batch);

/* The evaluator of the waveform whose first column is `column`; NULL where that is not the first column of one.
 * Borrowed. */
const TinkerWaveformEvaluator *tinker_block_batch_evaluator(const TinkerBlockBatch *batch, int32_t column, int32_t row);

/* Enters the piece of every waveform, and of what t alone switches in laws, that contains `inside`. */
void tinker_block_batch_enter_piece(TinkerBlockBatch *batch, double inside);

/* Between these times, the ends of a piece, nothing switches: laws in which t switches something alone are given times
 * a little within them. Infinite: there is no end. */
void tinker_block_batch_bound_laws(TinkerBlockBatch *batch, double from, double to);

/* The first break after t, of waveforms and of what t alone switches in laws, not after the horizon; INFINITY for none.
 * What is found is remembered, so that only those whose break has passed are asked again. */
double tinker_block_batch_next_break(TinkerBlockBatch *batch, double t, double horizon);

/* t; or, where a break is there, the time next to it at which expressions are on the side that holds from t on. */
double tinker_block_batch_time_behind(TinkerBlockBatch *batch, double t);

/* Enters the piece that holds from t on. */
void tinker_block_batch_enter_behind(TinkerBlockBatch *batch, double t);

#endif
