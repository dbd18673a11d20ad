/* Bodies are joined by union and find over the ends of whatever acts between them. The blocks of a set are then listed
 * from its bodies outwards, so that all sets together cost what their blocks and ends do. */
#include "physics/plan/partition.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

/* So many plates are held by all sets together: behind that the sets that may come upon them become one. */
#define MOST_PLATES 8000000

/* A list for each of some things, one behind the other. */
typedef struct {
    int32_t *starts; /* one more than there are things */
    int32_t *items;
} Lists;

typedef struct {
    const TinkerModel *model;
    int32_t *set_of;     /* of each body */
    Lists bodies;        /* of each set */
    Lists connectors;    /* of each body: numbers of the blocks with an end on it, but for motions */
    Lists motions;       /* of each block, by number: what moves it */
    int32_t *batch_of;   /* of each block: the number of its batch, ... */
    int32_t *first;      /* ... and of each batch: that of its first block */
    int32_t *listed_for; /* of each block: the last set that it was listed for */
    GArray *everywhere;  /* of int32_t: fields */
    TinkerPartition *out;
} Partitioning;

static const TinkerPhysics *physics_of(const TinkerBlockBatch *batch)
{
    return batch->block_class->physics;
}

static gboolean is_field(const TinkerBlockBatch *batch)
{
    return physics_of(batch) != NULL && physics_of(batch)->field != NULL;
}

static gboolean is_motion(const TinkerBlockBatch *batch)
{
    return physics_of(batch) != NULL && physics_of(batch)->motion != NULL;
}

static const TinkerBlockBatch *batch_at(const TinkerModel *model, guint number)
{
    return g_ptr_array_index(model->batches, number);
}

/* Sets of bodies --------------------------------------------------------------------------------------------------- */

static void join_ends(const TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points, int32_t *parent)
{
    for (int32_t row = 0; row < batch->count; row++) {
        int32_t first = -1;
        for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++) {
            const int32_t body = tinker_model_body_of(model, points[e]);
            if (body < 0) continue;
            if (first >= 0) tinker_sets_join(parent, first, body);
            first = body;
        }
    }
}

static gboolean has_shape(const TinkerModel *model, int32_t body)
{
    return model->contacts != NULL && tinker_contacts_may_touch(model->contacts, body);
}

static int32_t plate_count(const TinkerModel *model)
{
    return model->contacts != NULL ? model->contacts->plate_count : 0;
}

/* Where the plates of all sets together would not fit into memory, bodies that may touch them are one set. */
static void join_crowd(const TinkerModel *model, int32_t *parent)
{
    gint64 plates = 0;
    int32_t first = -1;
    for (int32_t i = 0; i < model->bodies; i++)
        if (has_shape(model, i) && tinker_sets_first(parent, i) == i) plates += plate_count(model);
    for (int32_t i = 0; plates > MOST_PLATES && i < model->bodies; i++) {
        if (!has_shape(model, i)) continue;
        if (first >= 0) tinker_sets_join(parent, first, i);
        first = i;
    }
}

/* Sets are numbered from 0 in the order of their first bodies; their number is answered. */
static int32_t find_sets(const TinkerModel *model, int32_t *set_of)
{
    g_autofree int32_t *parent = g_new(int32_t, MAX(model->bodies, 1));
    tinker_sets_begin(parent, model->bodies);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = batch_at(model, i);
        if (batch->end_count > 0) join_ends(model, batch, model->end_points[i], parent);
        if (!is_field(batch) || !physics_of(batch)->field->couples_bodies) continue;
        for (int32_t body = 1; body < model->bodies; body++)
            tinker_sets_join(parent, 0, body);
    }
    for (int32_t i = 0; model->contacts != NULL && i < model->contacts->pair_count; i++) {
        const int32_t *point = model->contacts->pairs[i].point;
        if (point[1] < model->bodies) tinker_sets_join(parent, point[0], point[1]);
    }
    join_crowd(model, parent);
    int32_t sets = 0;
    for (int32_t i = 0; i < model->bodies; i++) {
        int32_t root = tinker_sets_first(parent, i);
        set_of[i] = root == i ? sets++ : set_of[root];
    }
    return sets;
}

/* Who is on what --------------------------------------------------------------------------------------------------- */

/* Lists `things` of so many pairs (list, item): counts them, then fills. */
static Lists lists_new(int32_t things, const GArray *pairs)
{
    const int32_t *pair = (const int32_t *)(const void *)pairs->data;
    Lists lists = {g_new0(int32_t, (gsize)things + 1), g_new(int32_t, MAX(pairs->len / 2, 1))};
    g_autofree int32_t *next = g_new(int32_t, (gsize)things + 1);
    for (guint i = 0; i < pairs->len; i += 2)
        lists.starts[pair[i] + 1]++;
    for (int32_t i = 0; i < things; i++)
        lists.starts[i + 1] += lists.starts[i];
    memcpy(next, lists.starts, ((gsize)things + 1) * sizeof(int32_t));
    for (guint i = 0; i < pairs->len; i += 2)
        lists.items[next[pair[i]]++] = pair[i + 1];
    return lists;
}

static void add_pair(GArray *pairs, int32_t list, int32_t item)
{
    const int32_t pair[2] = {list, item};
    g_array_append_vals(pairs, pair, 2);
}

static void list_bodies(Partitioning *work)
{
    g_autoptr(GArray) pairs = g_array_new(FALSE, FALSE, sizeof(int32_t));
    for (int32_t i = 0; i < work->model->bodies; i++)
        add_pair(pairs, work->set_of[i], tinker_block_index_find(work->model->numbers, work->model->body_blocks[i]));
    work->bodies = lists_new(work->out->count, pairs);
}

/* What acts on bodies, and what moves blocks, by their ends. */
static void list_ends(Partitioning *work)
{
    const TinkerModel *model = work->model;
    g_autoptr(GArray) connectors = g_array_new(FALSE, FALSE, sizeof(int32_t));
    g_autoptr(GArray) motions = g_array_new(FALSE, FALSE, sizeof(int32_t));
    int32_t number = 0;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = batch_at(model, i);
        const int32_t *points = model->end_points[i];
        work->first[i] = number;
        for (int32_t row = 0; row < batch->count; row++, number++) {
            work->batch_of[number] = (int32_t)i;
            if (is_field(batch)) g_array_append_val(work->everywhere, number);
            for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++) {
                int32_t at = tinker_block_index_find(model->numbers, batch->end[e].block);
                if (is_motion(batch))
                    add_pair(motions, at, number);
                else if (points[e] < model->first_support)
                    add_pair(connectors, at, number);
            }
        }
    }
    work->connectors = lists_new(number, connectors);
    work->motions = lists_new(number, motions);
}

/* The blocks of a set ---------------------------------------------------------------------------------------------- */

static void add_block(Partitioning *work, int32_t set, int32_t number)
{
    work->out->blocks_asked++;
    if (work->listed_for[number] == set) return;
    work->listed_for[number] = set;
    g_array_append_val(work->out->numbers, number);
}

static void add_with_ends(Partitioning *work, int32_t set, int32_t number)
{
    const TinkerBlockBatch *batch = batch_at(work->model, (guint)work->batch_of[number]);
    const int32_t row = number - work->first[work->batch_of[number]];
    add_block(work, set, number);
    for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++)
        add_block(work, set, tinker_block_index_find(work->model->numbers, batch->end[e].block));
}

static int by_number(const void *left, const void *right)
{
    const int32_t l = *(const int32_t *)left, r = *(const int32_t *)right;
    return l < r ? -1 : l > r;
}

static void add_plates(Partitioning *work, int32_t set)
{
    const TinkerModel *model = work->model;
    gboolean any = FALSE;
    for (int32_t i = work->bodies.starts[set]; i < work->bodies.starts[set + 1]; i++)
        any |= has_shape(model, model->centre_point[work->bodies.items[i]]);
    for (int32_t i = 0; any && i < plate_count(model); i++)
        add_block(work, set, tinker_block_index_find(model->numbers, model->contacts->plates[i].block));
}

static void list_set(Partitioning *work, int32_t set)
{
    GArray *numbers = work->out->numbers;
    const guint start = numbers->len;
    for (int32_t i = work->bodies.starts[set]; i < work->bodies.starts[set + 1]; i++) {
        const int32_t body = work->bodies.items[i];
        add_block(work, set, body);
        for (int32_t k = work->connectors.starts[body]; k < work->connectors.starts[body + 1]; k++)
            add_with_ends(work, set, work->connectors.items[k]);
    }
    for (guint i = 0; i < work->everywhere->len; i++)
        add_with_ends(work, set, g_array_index(work->everywhere, int32_t, i));
    add_plates(work, set);
    for (guint i = start; i < numbers->len; i++) { /* also of what is moved by what moves */
        const int32_t moved = g_array_index(numbers, int32_t, i);
        for (int32_t k = work->motions.starts[moved]; k < work->motions.starts[moved + 1]; k++)
            add_with_ends(work, set, work->motions.items[k]);
    }
    qsort(&g_array_index(numbers, int32_t, start), numbers->len - start, sizeof(int32_t), by_number);
    g_array_append_val(work->out->starts, numbers->len);
}

static void list_sets(Partitioning *work)
{
    const int32_t blocks = tinker_block_index_count(work->model->numbers);
    const guint none = 0;
    work->batch_of = g_new(int32_t, MAX(blocks, 1));
    work->first = g_new(int32_t, MAX(work->model->batches->len, 1));
    work->listed_for = g_new(int32_t, MAX(blocks, 1));
    for (int32_t i = 0; i < blocks; i++)
        work->listed_for[i] = -1;
    work->everywhere = g_array_new(FALSE, FALSE, sizeof(int32_t));
    list_bodies(work);
    list_ends(work);
    g_array_append_val(work->out->starts, none);
    for (int32_t set = 0; set < work->out->count; set++)
        list_set(work, set);
    gpointer memory[] = {work->bodies.starts,    work->bodies.items,   work->connectors.starts,
                         work->connectors.items, work->motions.starts, work->motions.items,
                         work->batch_of,         work->first,          work->listed_for};
    for (gsize i = 0; i < G_N_ELEMENTS(memory); i++)
        g_free(memory[i]);
    g_array_unref(work->everywhere);
}

TinkerPartition *tinker_partition_new(const TinkerModel *model)
{
    g_autofree int32_t *set_of = g_new(int32_t, MAX(model->bodies, 1));
    TinkerPartition *partition = g_new0(TinkerPartition, 1);
    partition->starts = g_array_new(FALSE, FALSE, sizeof(guint));
    partition->numbers = g_array_new(FALSE, FALSE, sizeof(int32_t));
    partition->count = find_sets(model, set_of);
    Partitioning work = {.model = model, .set_of = set_of, .out = partition};
    list_sets(&work);
    return partition;
}

void tinker_partition_free(TinkerPartition *partition)
{
    g_array_unref(partition->starts);
    g_array_unref(partition->numbers);
    g_free(partition);
}
