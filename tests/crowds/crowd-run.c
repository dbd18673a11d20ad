/* Energy and overlaps are worked out here from the recorded states alone: E = sum m v^2/2 + I w^2/2 + m g y, which
 * contacts with what stands still never raise; and convex shapes are apart where their shadows are so along a normal of
 * one of their edges, or from a corner to the centre of a disc. */
#include "crowd-run.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "physics/compile/compile.h"
#include "scene/read/scene-json.h"

typedef struct {
    const Crowd *crowd;
    CrowdRun *run;
    double began, patience, lowest, scale; /* s; s; J: the least energy so far, and how much there was */
    gboolean claims;
} Watch;

static double processor_time(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static gboolean is_late(void *data)
{
    const Watch *watch = data;
    return processor_time() - watch->began > watch->patience;
}

/* Overlaps --------------------------------------------------------------------------------------------------------- */

typedef struct {
    double low, high;
} Shadow;

static void corner_of(const CrowdPart *part, int number, const double *state, double out[2])
{
    const double c = cos(state[2]), s = sin(state[2]), *at = part->at[number];
    out[0] = state[0] + c * at[0] - s * at[1];
    out[1] = state[1] + s * at[0] + c * at[1];
}

static Shadow shadow_of(const CrowdBody *body, const CrowdPart *part, const double *state, const double axis[2])
{
    const double middle = state[0] * axis[0] + state[1] * axis[1];
    if (part->corners == 0) return (Shadow){middle - body->radius, middle + body->radius};
    Shadow shadow = {INFINITY, -INFINITY};
    for (int i = 0; i < part->corners; i++) {
        double at[2];
        corner_of(part, i, state, at);
        shadow.low = fmin(shadow.low, at[0] * axis[0] + at[1] * axis[1]);
        shadow.high = fmax(shadow.high, at[0] * axis[0] + at[1] * axis[1]);
    }
    return shadow;
}

typedef struct {
    const CrowdBody *body;
    const CrowdPart *part;
    const double *state;
} Placed;

static double along(const Placed *a, const Placed *b, double x, double y)
{
    const double length = hypot(x, y), axis[] = {x / length, y / length};
    if (!(length > 0)) return INFINITY;
    const Shadow one = shadow_of(a->body, a->part, a->state, axis), two = shadow_of(b->body, b->part, b->state, axis);
    return fmin(one.high - two.low, two.high - one.low);
}

static double least_over_axes_of(const Placed *a, const Placed *b)
{
    double least = INFINITY;
    if (a->part->corners == 0 && b->part->corners == 0)
        return along(a, b, b->state[0] - a->state[0], b->state[1] - a->state[1]);
    for (int i = 0; i < a->part->corners; i++) {
        double at[2], next[2];
        corner_of(a->part, i, a->state, at);
        corner_of(a->part, (i + 1) % a->part->corners, a->state, next);
        least = fmin(least, along(a, b, next[1] - at[1], at[0] - next[0]));
        if (b->part->corners == 0) least = fmin(least, along(a, b, b->state[0] - at[0], b->state[1] - at[1]));
    }
    return least;
}

static double overlap_of(const CrowdBody *a, const double *at_a, const CrowdBody *b, const double *at_b)
{
    double most = -INFINITY;
    if (hypot(at_a[0] - at_b[0], at_a[1] - at_b[1]) > a->radius + b->radius) return most;
    for (int i = 0; i < a->part_count; i++)
        for (int k = 0; k < b->part_count; k++) {
            const Placed one = {a, &a->parts[i], at_a}, two = {b, &b->parts[k], at_b};
            most = fmax(most, fmin(least_over_axes_of(&one, &two), least_over_axes_of(&two, &one)));
        }
    return most;
}

static double overlap_with_walls(const Crowd *crowd, const CrowdBody *body, const double *state)
{
    double most = -INFINITY;
    for (int i = 0; i < body->part_count; i++)
        for (int k = 0; k < 2; k++) {
            const Shadow shadow = shadow_of(body, &body->parts[i], state, (const double[]){k == 0, k == 1});
            most = fmax(most, fmax(-shadow.low, shadow.high - crowd->inside[k]));
        }
    return most;
}

static double largest_overlap(const Crowd *crowd, const double *states)
{
    double most = -INFINITY;
    for (int i = 0; i < crowd->count; i++) {
        const double *state = states + i * CROWD_COLUMNS;
        most = fmax(most, overlap_with_walls(crowd, &crowd->bodies[i], state));
        for (int k = 0; k < i; k++)
            most = fmax(most, overlap_of(&crowd->bodies[i], state, &crowd->bodies[k], states + k * CROWD_COLUMNS));
    }
    return most;
}

/* The run ---------------------------------------------------------------------------------------------------------- */

static double energy_of(const Crowd *crowd, const double *states)
{
    double sum = 0;
    for (int i = 0; i < crowd->count; i++) {
        const CrowdBody *body = &crowd->bodies[i];
        const double *s = states + i * CROWD_COLUMNS;
        sum += 0.5 * body->mass * (s[3] * s[3] + s[4] * s[4]) + 0.5 * body->inertia * s[5] * s[5] +
               body->mass * crowd->gravity * s[1];
    }
    return sum;
}

static gboolean keep(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Watch *watch = data;
    CrowdRun *run = watch->run;
    (void)error;
    const double energy = energy_of(watch->crowd, values), overlap = largest_overlap(watch->crowd, values);
    g_array_append_vals(run->rows, values, (guint)(watch->crowd->count * CROWD_COLUMNS));
    const double claim = watch->claims ? tinker_simulation_error(simulation) : NAN;
    g_array_append_val(run->claims, claim);
    if (run->samples++ == 0) watch->scale = fabs(energy);
    if (energy - watch->lowest > run->gain * watch->scale) {
        run->gain = (energy - watch->lowest) / watch->scale;
        run->gain_time = time;
    }
    watch->lowest = fmin(watch->lowest, energy);
    if (overlap > run->overlap) {
        run->overlap = overlap;
        run->overlap_time = time;
    }
    return TRUE;
}

static gboolean run_scene(TinkerScene *scene, Watch *watch, double tolerance, GError **error)
{
    static const char *const quantities[] = {"x", "y", "angle", "vx", "vy", "angular velocity"};
    const Crowd *crowd = watch->crowd;
    CrowdRun *run = watch->run;
    g_autoptr(GString) list = g_string_new(NULL);
    g_autoptr(GArray) columns = tinker_columns_new();
    g_autoptr(TinkerModel) model = tinker_model_new(scene, error);
    if (model == NULL) return FALSE;
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.tolerance = tolerance;
    options.duration = crowd->duration;
    options.interval = crowd->duration / CROWD_SAMPLES;
    options.estimate = watch->claims;
    options.cancelled = is_late;
    options.data = watch;
    for (int i = 0; i < crowd->count; i++)
        for (int k = 0; k < CROWD_COLUMNS; k++)
            g_string_append_printf(list, "%sb%d.%s", list->len > 0 ? "," : "", i, quantities[k]);
    if (!tinker_columns_add_list(columns, scene, list->str, error)) return FALSE;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, error);
    if (simulation == NULL) return FALSE;
    const gboolean done = tinker_simulation_run(simulation, columns, keep, watch, error);
    const TinkerSummary *summary = tinker_simulation_summary(simulation);
    run->balance = summary->energy_balance_error;
    run->changes = summary->contact_changes;
    run->warnings = summary->warnings->len;
    return done;
}

gboolean crowd_run(TinkerCatalogue *catalogue, const Crowd *crowd, double tolerance, double patience, gboolean claims,
                   CrowdRun *run, GError **error)
{
    *run = (CrowdRun){.rows = g_array_new(FALSE, FALSE, sizeof(double)),
                      .claims = g_array_new(FALSE, FALSE, sizeof(double)),
                      .overlap = -INFINITY,
                      .gain = 0};
    Watch watch = {crowd, run, processor_time(), patience, INFINITY, 0, claims};
    g_autoptr(TinkerScene) scene =
        tinker_scene_read_text(catalogue, crowd->text, strlen(crowd->text), NULL, NULL, error);
    const gboolean done = scene != NULL && run_scene(scene, &watch, tolerance, error);
    run->seconds = processor_time() - watch.began;
    return done;
}

void crowd_run_clear(CrowdRun *run)
{
    g_array_unref(run->rows);
    g_array_unref(run->claims);
}
