/* The forces in a scene as it is set up, without a run that anybody made: short runs of their own. */
#include "physics/compile/compile.h"
#include "physics/plan/run-options.h"
#include "physics/run/acting-forces.h"
#include "physics/run/simulation-private.h"

/* Takes no step: any method that goes with contacts. */
#define START_METHOD "dop853"

static gboolean list_sample(TinkerSimulation *simulation, G_GNUC_UNUSED double time, G_GNUC_UNUSED const double *values,
                            void *out, GError **error)
{
    g_autoptr(TinkerActingForces) forces = tinker_acting_forces_new(simulation->all->model);
    return tinker_acting_forces_at(forces, simulation, out, error);
}

static gboolean list_by(TinkerScene *scene, const TinkerRunOptions *options, GArray *out, GError **error)
{
    g_array_set_size(out, 0);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, error);
    if (model == NULL) return FALSE;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, options, error);
    return simulation != NULL && tinker_simulation_run(simulation, NULL, list_sample, out, error);
}

/* A run of no duration finds out what touches. */
gboolean tinker_acting_forces_at_start(TinkerScene *scene, GArray *out, GError **error)
{
    const TinkerRunOptions options = {.interval = 1, .method = START_METHOD, .tolerance = 1e-9, .spectral_radius = 1};
    return list_by(scene, &options, out, error);
}

static gboolean is_late(void *until)
{
    return g_get_monotonic_time() > *(const gint64 *)until;
}

gboolean tinker_acting_forces_after(TinkerScene *scene, double time, double patience, GArray *out, GError **error)
{
    gint64 until = g_get_monotonic_time() + (gint64)(patience * G_USEC_PER_SEC);
    const TinkerRunOptions options = {.duration = time,
                                      .interval = time,
                                      .at = &time,
                                      .at_count = 1,
                                      .method = START_METHOD,
                                      .tolerance = 1e-9,
                                      .spectral_radius = 1,
                                      .cancelled = is_late,
                                      .data = &until};
    return list_by(scene, &options, out, error);
}
