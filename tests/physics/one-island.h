/* The run of a scene that is one island, whose steps a test takes itself and into which it can look. */
#ifndef TEST_ONE_ISLAND_H
#define TEST_ONE_ISLAND_H

#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/island/island-run.h"
#include "physics/plan/islands.h"
#include "physics/run/island-runs.h"
#include "physics/run/island-steps.h"

typedef struct {
    TinkerScene *scene;
    TinkerModel *model;
    GPtrArray *islands;
    TinkerIsland island; /* the only one, which may be changed before the start */
    TinkerSummary whole;
    TinkerIslandRun *run; /* NULL before the start */
} OneIsland;

static inline void one_island_open(OneIsland *self, const char *blocks)
{
    g_autoptr(GError) error = NULL;
    self->scene = physics_scene(NULL, blocks);
    self->model = tinker_model_new(self->scene, &error);
    g_assert_no_error(error);
    self->islands = tinker_islands_new(self->model, &error);
    g_assert_no_error(error);
    g_assert_cmpuint(self->islands->len, ==, 1);
    self->island = *(TinkerIsland *)g_ptr_array_index(self->islands, 0);
    self->whole.events = g_ptr_array_new_with_free_func(tinker_event_free);
    self->whole.warnings = tinker_warnings_new();
}

static inline void one_island_start(OneIsland *self, const TinkerChoice *choice, double duration)
{
    g_autoptr(GError) error = NULL;
    self->run = tinker_island_run_new(&self->island, choice, 0.8, duration, &self->whole, NULL, &error);
    g_assert_no_error(error);
}

static inline void one_island_clear(OneIsland *self)
{
    tinker_island_run_free(self->run);
    g_ptr_array_unref(self->whole.events);
    g_ptr_array_unref(self->whole.warnings);
    g_ptr_array_unref(self->islands);
    tinker_model_free(self->model);
    tinker_scene_free(self->scene);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(OneIsland, one_island_clear)

#endif
