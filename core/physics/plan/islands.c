/* Each set of the partition is compiled into a model of its own. */
#include "physics/plan/islands.h"

#include "numerics/solve/disjoint-sets.h"
#include "physics/compile/compile.h"
#include "physics/contact/contacts.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/plan/partition.h"
#include "plugin/call/process-state.h"

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
    island->body_of = g_new0(int32_t, MAX(model->bodies, 1));
    for (int32_t i = 0; i < model->bodies; i++)
        island->body_of[i] = tinker_model_centre(whole, model->body_blocks[i]);
    if (!in_plane && (model->contacts == NULL || !tinker_contacts_touch(model->contacts)))
        island->linear = tinker_linear_form_new(model);
    return island;
}

static gboolean add_islands(GPtrArray *islands, TinkerModel *whole, const TinkerPartition *partition, GError **error)
{
    for (int32_t set = 0; set < partition->count; set++) {
        const guint *starts = &g_array_index(partition->starts, guint, set);
        const int32_t *numbers = (const int32_t *)(const void *)partition->numbers->data + starts[0];
        TinkerModel *part = tinker_model_new_of(whole, numbers, (int32_t)(starts[1] - starts[0]), error);
        if (part == NULL) return FALSE;
        g_ptr_array_add(islands, island_new(part, TRUE, whole, FALSE));
    }
    return TRUE;
}

GPtrArray *tinker_islands_new(TinkerModel *whole, GError **error)
{
    g_autoptr(GPtrArray) islands = g_ptr_array_new_with_free_func(island_free);
    g_autoptr(TinkerPartition) partition = tinker_partition_new(whole);
    if (partition->count <= 1) {
        g_ptr_array_add(islands, island_new(whole, FALSE, whole, FALSE));
        return g_steal_pointer(&islands);
    }
    tinker_process_state_enter();
    const gboolean done = add_islands(islands, whole, partition, error);
    tinker_process_state_leave();
    return done ? g_steal_pointer(&islands) : NULL;
}

GPtrArray *tinker_islands_for(TinkerModel *whole, gboolean impulses, GError **error)
{
    if (!impulses || !tinker_contacts_can_meet(whole->contacts)) return tinker_islands_new(whole, error);
    GPtrArray *islands = g_ptr_array_new_with_free_func(island_free);
    g_ptr_array_add(islands, island_new(whole, FALSE, whole, TRUE));
    return islands;
}
