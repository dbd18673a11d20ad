#include "acting-watch.h"

#include <math.h>

#include "allotments.h"
#include "physics/record/columns.h"

void acting_watch_open(ActingWatch *watch, TinkerScene *scene, TinkerModel *model)
{
    *watch = (ActingWatch){.scene = scene, .look = TRUE};
    watch->forces = tinker_acting_forces_new(model);
    watch->out = tinker_acting_forces_array();
    watch->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    watch->columns = tinker_columns_new();
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        const TinkerPhysics *physics = tinker_scene_block_class(scene, block)->physics;
        if (physics == NULL || physics->body == NULL || physics->body->degrees_of_freedom == 0) continue;
        const char *name = tinker_scene_block_name(scene, block);
        g_autofree char *x = g_strconcat(name, ".ax", NULL), *y = g_strconcat(name, ".ay", NULL);
        g_array_append_val(watch->bodies, block);
        g_assert_true(tinker_columns_add(watch->columns, scene, x, NULL));
        g_assert_true(tinker_columns_add(watch->columns, scene, y, NULL));
    }
}

void acting_watch_close(ActingWatch *watch)
{
    tinker_acting_forces_free(watch->forces);
    g_array_unref(watch->out);
    g_array_unref(watch->bodies);
    g_array_unref(watch->columns);
}

gboolean acting_watch_look(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    ActingWatch *watch = data;
    if (watch->samples != NULL) {
        g_array_append_val(watch->samples, time);
        g_array_append_vals(watch->samples, values, watch->columns->len);
    }
    if (!watch->look) return TRUE;
    int before = allotments;
    if (!tinker_acting_forces_at(watch->forces, simulation, watch->out, error)) return FALSE;
    if (watch->looked++ > 0) watch->allotted += allotments - before;
    for (guint i = 0; i < watch->out->len; i++) {
        const TinkerActingForce *force = &g_array_index(watch->out, TinkerActingForce, i);
        g_assert_true(isfinite(force->x) && isfinite(force->y) && isfinite(force->fx) && isfinite(force->fy));
        watch->most = MAX(watch->most, hypot(force->fx, force->fy));
    }
    return TRUE;
}

GArray *acting_watch_at_start(TinkerScene *scene)
{
    g_autoptr(GError) error = NULL;
    GArray *out = tinker_acting_forces_array();
    g_assert_true(tinker_acting_forces_at_start(scene, out, &error));
    g_assert_no_error(error);
    return out;
}
