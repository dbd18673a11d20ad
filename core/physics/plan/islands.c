/* Bodies are joined by union and find over the ends of whatever acts between them; each set, with the supports that it hangs
 * on and what moves those, is compiled into a model of its own. */
#include "physics/plan/islands.h"

#include "numerics/solve/disjoint-sets.h"
#include "physics/compile/compile.h"
#include "physics/contact/contacts.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"

#define MOST_BLOCKS_ASKED  20000000
#define LEAST_MOST_ISLANDS 256

static void join_ends(const TinkerModel *model, const TinkerBlockBatch *batch, int32_t *parent)
{
    const int32_t *points = tinker_model_end_points(model, batch);
    for (int32_t row = 0; row < batch->count; row++) {
        int32_t first = -1;
        for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++) {
            if (points[e] >= model->bodies) continue;
            if (first >= 0) tinker_sets_join(parent, first, points[e]);
            first = points[e];
        }
    }
}

static gboolean is_field(const TinkerBlockBatch *batch)
{
    return batch->block_class->physics != NULL && batch->block_class->physics->field != NULL;
}

static gboolean is_motion(const TinkerBlockBatch *batch)
{
    return batch->block_class->physics != NULL && batch->block_class->physics->motion != NULL;
}

/* The set that each body belongs to, numbered from 0 in the order of their first bodies; their number is answered. */
static int32_t find_sets(const TinkerModel *model, int32_t *set_of)
{
    g_autofree int32_t *parent = g_new(int32_t, MAX(model->bodies, 1));
    tinker_sets_begin(parent, model->bodies);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->end_count > 0) join_ends(model, batch, parent);
        if (!is_field(batch) || !batch->block_class->physics->field->couples_bodies) continue;
        for (int32_t body = 1; body < model->bodies; body++)
            tinker_sets_join(parent, 0, body);
    }
    int32_t sets = 0;
    for (int32_t i = 0; i < model->bodies; i++) {
        int32_t root = tinker_sets_first(parent, i);
        set_of[i] = root == i ? sets++ : set_of[root];
    }
    return sets;
}

typedef struct {
    int32_t set, size;
} SetSize;

static int by_size(const void *left, const void *right)
{
    const SetSize *l = left, *r = right;
    if (l->size != r->size) return l->size > r->size ? -1 : 1;
    return l->set - r->set;
}

/* Every island is found in all blocks of the scene: so many of them may be asked in all. */
static int32_t most_islands(const TinkerModel *model)
{
    int32_t blocks = MAX(tinker_scene_id_limit(model->scene), 1);
    return CLAMP(MOST_BLOCKS_ASKED / blocks, LEAST_MOST_ISLANDS, TINKER_MOST_ISLANDS);
}

/* Behind the largest, all sets become one; its number is answered, or -1 where none were joined. */
static int32_t join_smallest(const TinkerModel *model, int32_t *set_of, int32_t *sets)
{
    const int32_t most = most_islands(model);
    if (*sets <= most) return -1;
    g_autofree SetSize *sizes = g_new0(SetSize, *sets);
    g_autofree int32_t *renumbered = g_new0(int32_t, *sets);
    for (int32_t i = 0; i < *sets; i++)
        sizes[i].set = i;
    for (int32_t i = 0; i < model->bodies; i++)
        sizes[set_of[i]].size++;
    qsort(sizes, (gsize)*sets, sizeof(SetSize), by_size);
    int32_t rest = most - 1;
    for (int32_t i = rest; i < *sets; i++)
        renumbered[sizes[i].set] = -1;
    for (int32_t i = 0, number = 0; i < *sets; i++)
        renumbered[i] = renumbered[i] < 0 ? rest : number++;
    for (int32_t i = 0; i < model->bodies; i++)
        set_of[i] = renumbered[set_of[i]];
    *sets = most;
    return rest;
}

/* Solid plates are in every part: a body may come upon them wherever it is. */
static void include_plates(const TinkerModel *model, gboolean *include)
{
    for (int32_t i = 0; model->contacts != NULL && i < model->contacts->plate_count; i++)
        include[model->contacts->plates[i].block] = TRUE;
}

/* The blocks of a set: its bodies, whatever has an end on one of them and the blocks at its other ends, what moves those, and
 * all fields. */
static gboolean *blocks_of(const TinkerModel *model, const int32_t *set_of, int32_t set)
{
    gboolean *include = g_new0(gboolean, MAX(tinker_scene_id_limit(model->scene), 1));
    include_plates(model, include);
    for (int32_t i = 0; i < model->bodies; i++)
        include[model->body_blocks[i]] = set_of[i] == set;
    for (int pass = 0; pass < 2; pass++) { /* motions last, when it is known which supports are there */
        for (guint b = 0; b < model->batches->len; b++) {
            const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, b);
            const int32_t *points = tinker_model_end_points(model, batch);
            if (is_motion(batch) != (pass == 1)) continue;
            for (int32_t row = 0; row < batch->count; row++) {
                gboolean mine = is_field(batch);
                for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++)
                    mine |= pass == 1 ? include[batch->end[e].block]
                                      : points[e] < model->bodies && set_of[points[e]] == set;
                if (!mine) continue;
                include[batch->ids[row]] = TRUE;
                for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++)
                    include[batch->end[e].block] = TRUE;
            }
        }
    }
    return include;
}

static void island_free(gpointer data)
{
    TinkerIsland *island = data;
    tinker_linear_form_free(island->linear);
    if (island->owns_model) tinker_model_free(island->model);
    g_free(island->body_of);
    g_free(island);
}

/* Bodies keep their order in a part. */
static TinkerIsland *island_new(TinkerModel *model, gboolean owns_model, const TinkerModel *whole, gboolean in_plane)
{
    TinkerIsland *island = g_new0(TinkerIsland, 1);
    island->model = model;
    island->owns_model = owns_model;
    island->joined = 1;
    island->body_of = g_new0(int32_t, MAX(model->bodies, 1));
    for (int32_t i = 0; i < model->bodies; i++)
        island->body_of[i] = whole->centre_point[model->body_blocks[i]];
    if (!in_plane && (model->contacts == NULL || !tinker_contacts_touch(model->contacts)))
        island->linear = tinker_linear_form_new(model);
    return island;
}

GPtrArray *tinker_islands_new(TinkerModel *whole, GError **error)
{
    g_autoptr(GPtrArray) islands = g_ptr_array_new_with_free_func(island_free);
    g_autofree int32_t *set_of = g_new0(int32_t, MAX(whole->bodies, 1));
    int32_t found = find_sets(whole, set_of), sets = found;
    if (sets <= 1) {
        g_ptr_array_add(islands, island_new(whole, FALSE, whole, FALSE));
        return g_steal_pointer(&islands);
    }
    int32_t rest = join_smallest(whole, set_of, &sets);
    for (int32_t set = 0; set < sets; set++) {
        g_autofree gboolean *include = blocks_of(whole, set_of, set);
        TinkerModel *part = tinker_model_new_part(whole->scene, include, error);
        if (part == NULL) return NULL;
        TinkerIsland *island = island_new(part, TRUE, whole, FALSE);
        if (set == rest) island->joined = found - sets + 1;
        g_ptr_array_add(islands, island);
    }
    return g_steal_pointer(&islands);
}

GPtrArray *tinker_islands_for(TinkerModel *whole, gboolean impulses, GError **error)
{
    if (!impulses || whole->contacts == NULL || whole->contacts->plate_count == 0)
        return tinker_islands_new(whole, error);
    GPtrArray *islands = g_ptr_array_new_with_free_func(island_free);
    g_ptr_array_add(islands, island_new(whole, FALSE, whole, TRUE));
    return islands;
}
