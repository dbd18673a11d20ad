/* Forces told apart: they add up to mass times acceleration in every scene there is, have the values that statics asks
 * for, and looking at them changes no bit of a run. */
#include "allotments.h"
#include "physics-fixture.h"

#include "numerics/methods/integrators.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/acting-forces.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

#include <math.h>
#include <string.h>

#define G 9.81

/* Sums ------------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerScene *scene;
    TinkerActingForces *forces;
    GArray *out;
    GArray *bodies;  /* of TinkerBlockId; each has the columns ax, ay */
    GArray *columns; /* of TinkerColumn */
    GArray *samples; /* of double; or NULL */
    gboolean look;
    int looked, allotted;
    double most; /* N: the largest force seen */
} Watch;

static double mass_of(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    int32_t column = tinker_block_class_meaning_column(block_class, TINKER_MEANING_MASS);
    return tinker_scene_get(scene, block, column);
}

/* A connector takes nothing from anywhere, nor does a contact: what it does to all its ends adds up to nothing. */
static void assert_opposite(const GArray *out)
{
    for (guint i = 0; i < out->len; i++) {
        const TinkerActingForce *one = &g_array_index(out, TinkerActingForce, i);
        double fx = one->fx, fy = one->fy, scale = hypot(fx, fy);
        gboolean touch = one->kind >= TINKER_ACTING_NORMAL;
        if (one->kind != TINKER_ACTING_LINE && one->kind != TINKER_ACTING_CONSTRAINT && !touch) continue;
        for (guint k = 0; k < out->len; k++) {
            const TinkerActingForce *other = &g_array_index(out, TinkerActingForce, k);
            if (k == i || other->kind != one->kind) continue;
            if (touch ? other->by != one->on || other->on != one->by : other->by != one->by) continue;
            fx += other->fx;
            fy += other->fy;
        }
        physics_assert_near("the sum of opposite forces", hypot(fx, fy), 0, 1e-13 * scale);
    }
}

static void assert_newton(const Watch *watch, double time, const double *values)
{
    TinkerScene *scene = watch->scene;
    for (guint i = 0; i < watch->bodies->len; i++) {
        TinkerBlockId body = g_array_index(watch->bodies, TinkerBlockId, i);
        double mass = mass_of(scene, body), fx = 0, fy = 0, scale = 0;
        for (guint k = 0; k < watch->out->len; k++) {
            const TinkerActingForce *force = &g_array_index(watch->out, TinkerActingForce, k);
            g_assert_true(force->by != force->on);
            if (force->on != body) continue;
            fx += force->fx;
            fy += force->fy;
            scale += hypot(force->fx, force->fy);
        }
        double off = hypot(fx - mass * values[2 * i], fy - mass * values[2 * i + 1]);
        if (!(off <= 1e-9 * scale) && !g_test_failed())
            g_test_fail_printf("%s at t = %g s: forces (%.12g, %.12g) N are not mass times acceleration "
                               "(%.12g, %.12g) N",
                               tinker_scene_block_name(scene, body), time, fx, fy, mass * values[2 * i],
                               mass * values[2 * i + 1]);
    }
}

static gboolean look(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Watch *watch = data;
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

static gboolean look_and_add_up(TinkerSimulation *simulation, double time, const double *values, void *data,
                                GError **error)
{
    Watch *watch = data;
    if (!look(simulation, time, values, data, error)) return FALSE;
    assert_newton(watch, time, values);
    assert_opposite(watch->out);
    return TRUE;
}

static void open_watch(Watch *watch, TinkerScene *scene, TinkerModel *model)
{
    *watch = (Watch){.scene = scene, .look = TRUE};
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

static void close_watch(Watch *watch)
{
    tinker_acting_forces_free(watch->forces);
    g_array_unref(watch->out);
    g_array_unref(watch->bodies);
    g_array_unref(watch->columns);
}

/* Runs a scene with its own settings, but for samples at these times. */
static void check_sums(TinkerScene *scene, double duration, gboolean impulses)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.duration = duration;
    options.interval = duration / 97;
    options.impulses = impulses;
    options.estimate = FALSE;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    g_assert_no_error(error);
    Watch watch;
    open_watch(&watch, scene, model);
    tinker_simulation_run(simulation, watch.columns, look_and_add_up, &watch, &error);
    g_assert_no_error(error);
    g_assert_cmpint(watch.looked, ==, 98);
    g_assert_cmpint(watch.allotted, ==, 0);
    g_assert_cmpfloat(watch.most, >, 0);
    close_watch(&watch);
}

typedef struct {
    const char *name, *path; /* from the root of the sources */
    double duration;
    gboolean impulses;
} SceneCase;

static const SceneCase scene_cases[] = {
    {"spring-mass", "host/scenes/spring-mass.tinker.json", 3, FALSE},
    {"double-pendulum", "host/scenes/double-pendulum.tinker.json", 4, FALSE},
    {"four-bar-linkage", "host/scenes/four-bar-linkage.tinker.json", 4, FALSE},
    {"friction-incline", "host/scenes/friction-incline.tinker.json", 4, FALSE},
    {"friction-incline/impulses", "host/scenes/friction-incline.tinker.json", 4, TRUE},
    {"bouncing-balls", "host/scenes/bouncing-balls.tinker.json", 5, FALSE},
    {"bouncing-balls/impulses", "host/scenes/bouncing-balls.tinker.json", 3, TRUE},
    {"stick-slip-belt", "host/scenes/stick-slip-belt.tinker.json", 6, FALSE},
    {"sliding-ladder", "host/scenes/sliding-ladder.tinker.json", 2, FALSE},
    {"hanging-cable", "host/scenes/hanging-cable.tinker.json", 2, FALSE},
    {"kapitza-pendulum", "host/scenes/kapitza-pendulum.tinker.json", 2, FALSE},
    {"terminal-velocity", "host/scenes/terminal-velocity.tinker.json", 3, FALSE},
    {"tuned-mass-damper", "host/scenes/tuned-mass-damper.tinker.json", 5, FALSE},
    {"el-centro-block", "host/scenes/el-centro-block.tinker.json", 5, FALSE},
    {"one-sided-support", "host/scenes/one-sided-support.tinker.json", 1.5, FALSE},
    {"lift-off", "host/scenes/lift-off.tinker.json", 4, FALSE},
    {"support-motion", "host/scenes/support-motion.tinker.json", 5, FALSE},
    {"stiff-chain", "host/scenes/stiff-chain.tinker.json", 2, FALSE},
    {"A26", "tests/reference/A26_parallel_springs.tinker.json", 2, FALSE},
    {"A32", "tests/reference/A32_incline_stick.tinker.json", 5, FALSE},
    {"A38", "tests/reference/A38_shake_stickslip.tinker.json", 3, FALSE},
    {"B07", "tests/reference/B07_chain10.tinker.json", 1, FALSE},
    {"C02", "tests/reference/C02_car_axis_panhard.tinker.json", 1, FALSE},
    {"C09", "tests/reference/C09_slider_crank.tinker.json", 1, FALSE},
    {"D08", "tests/reference/D08_rod_mass_ratio_1e6.tinker.json", 1, FALSE},
    {"D12", "tests/reference/D12_redundant_parallelogram.tinker.json", 1, FALSE},
    {"D13", "tests/reference/D13_duplicate_rod.tinker.json", 1, FALSE},
};

static void test_scene(gconstpointer data)
{
    const SceneCase *scene_case = data;
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), scene_case->path, NULL);
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
    g_assert_no_error(error);
    check_sums(scene, scene_case->duration, scene_case->impulses);
}

/* Roles that no bundled block fills. */
static void test_other_roles(void)
{
    g_autoptr(TinkerScene) scene = physics_scene(
        NULL, "{'type': 'support', 'solid': false, 'position': [100, -50]}, {'type': 'gravity'},"
              "{'type': 'mass', 'position': [102, -50]}, {'type': 'mass', 'position': [102, -49], 'mass': 3},"
              "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 3, 'length': 1},"
              "{'type': 'bundle', 'ends': ['Mass 0', 'Mass 1', 'Support 0'], 'stiffness': 2},"
              "{'type': 'bundle', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 2},"
              "{'type': 'attraction', 'strength': 1}, {'type': 'attraction', 'strength': 2},"
              "{'type': 'torsion', 'ends': ['Mass 0', 'Support 0', 'Mass 1'], 'stiffness': 1},"
              "{'type': 'orbit', 'ends': ['Support 0'], 'radius': 0.1, 'rate': 2},"
              "{'type': 'actuator', 'ends': ['Mass 0', 'Mass 1'], 'waveform': {'expression': '1 + 0.1*sin(t)^2'}},"
              "{'type': 'rope', 'ends': ['Support 0', 'Mass 1'], 'length': 2.25},"
              "{'type': 'wind', 'drag_quadratic': 0.3, 'drag': 0.1}, {'type': 'wind', 'velocity': [3, 0], 'drag': 1}");
    check_sums(scene, 3, FALSE);
}

/* Values ----------------------------------------------------------------------------------------------------------- */

/* The force of a block on another at the start; `kind` -1: any. */
static const TinkerActingForce *find(TinkerScene *scene, const GArray *out, const char *by, const char *on, int kind)
{
    for (guint i = 0; i < out->len; i++) {
        const TinkerActingForce *force = &g_array_index(out, TinkerActingForce, i);
        if (g_str_equal(tinker_scene_block_name(scene, force->by), by) &&
            g_str_equal(tinker_scene_block_name(scene, force->on), on) && (kind < 0 || kind == (int)force->kind))
            return force;
    }
    g_error("%s does not act on %s", by, on);
}

static void assert_force(const TinkerActingForce *force, double fx, double fy, double x, double y)
{
    physics_assert_near("fx", force->fx, fx, 1e-12 * (1 + hypot(fx, fy)));
    physics_assert_near("fy", force->fy, fy, 1e-12 * (1 + hypot(fx, fy)));
    physics_assert_near("x", force->x, x, 1e-12);
    physics_assert_near("y", force->y, y, 1e-12);
}

static GArray *at_start(TinkerScene *scene)
{
    g_autoptr(GError) error = NULL;
    GArray *out = tinker_acting_forces_array();
    g_assert_true(tinker_acting_forces_at_start(scene, out, &error));
    g_assert_no_error(error);
    return out;
}

/* A mass hangs at rest from two springs side by side, which the model merges, and a third that hangs below holds
 * nothing. */
static void test_hanging(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [5, 3]},"
                            "{'type': 'mass', 'mass': 2, 'position': [5, 1]}, {'type': 'mass', 'position': [5, 0]},"
                            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 9.81, 'rest_length': 1},"
                            "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'stiffness': 4.905, 'rest_length': 0},"
                            "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 7, 'rest_length': 1},"
                            "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 3}");
    g_autoptr(GArray) out = at_start(scene);
    assert_force(find(scene, out, "Gravity 0", "Mass 0", TINKER_ACTING_FIELD), 0, -2 * G, 5, 1);
    assert_force(find(scene, out, "Spring 0", "Mass 0", TINKER_ACTING_LINE), 0, G, 5, 1);
    assert_force(find(scene, out, "Spring 1", "Mass 0", TINKER_ACTING_LINE), 0, G, 5, 1);
    assert_force(find(scene, out, "Spring 0", "Support 0", TINKER_ACTING_LINE), 0, -G, 5, 3);
    assert_force(find(scene, out, "Spring 2", "Mass 1", TINKER_ACTING_LINE), 0, 0, 5, 0);
    assert_force(find(scene, out, "Damper 0", "Mass 0", TINKER_ACTING_LINE), 0, 0, 5, 1);
    g_assert_cmpuint(out->len, ==, 2 + 4 * 2);
}

/* A pendulum that turns: tension m (g cos + v^2 / L); a motor at its bob, and air. */
static void test_turning(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'wind', 'drag': 0.5},"
                            "{'type': 'mass', 'mass': 3, 'position': [0, -2], 'velocity': [4, 0]},"
                            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                            "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 7, 'frequency': 0, 'angle': 1.2}");
    g_autoptr(GArray) out = at_start(scene);
    const TinkerActingForce *motor = find(scene, out, "Motor 0", "Mass 0", TINKER_ACTING_ELEMENT);
    g_assert_cmpfloat(fabs(hypot(motor->fx, motor->fy) - 7), <, 1e-12);
    assert_force(find(scene, out, "Wind 0", "Mass 0", TINKER_ACTING_FIELD), -2, 0, 0, -2);
    double tension = 3 * (G + 16 / 2.0) - motor->fy;
    assert_force(find(scene, out, "Rod 0", "Mass 0", TINKER_ACTING_CONSTRAINT), 0, tension, 0, -2);
    assert_force(find(scene, out, "Rod 0", "Support 0", TINKER_ACTING_CONSTRAINT), 0, -tension, 0, 0);
}

/* A block sticks on an incline: m g cos across it and m g sin along it, where they touch. */
static void test_incline(void)
{
    double angle = 0.3, c = cos(angle), s = sin(angle), off = 0.05 + 0.2;
    g_autofree char *blocks = g_strdup_printf(
        "{'type': 'gravity'}, {'type': 'support', 'orientation': %.17g, 'width': 6, 'height': 0.1, 'static_friction': "
        "0.5, 'dynamic_friction': 0.4}, {'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g], 'height': 0.4}",
        angle, -off * s + 0.5 * c, off * c + 0.5 * s);
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    g_autoptr(GArray) out = at_start(scene);
    double normal = 2 * G * c, friction = 2 * G * s, x = -0.05 * s + 0.5 * c, y = 0.05 * c + 0.5 * s;
    assert_force(find(scene, out, "Support 0", "Mass 0", TINKER_ACTING_NORMAL), -normal * s, normal * c, x, y);
    assert_force(find(scene, out, "Support 0", "Mass 0", TINKER_ACTING_FRICTION), friction * c, friction * s, x, y);
    assert_force(find(scene, out, "Mass 0", "Support 0", TINKER_ACTING_NORMAL), normal * s, -normal * c, x, y);
    g_assert_cmpuint(out->len, ==, 1 + 4);
}

/* Scenes without bodies, and scenes that cannot run. */
static void test_odd_scenes(void)
{
    static const char *const empty[] = {"", "{'type': 'gravity'}", "{'type': 'support'}, {'type': 'gravity'}"};
    for (gsize i = 0; i < G_N_ELEMENTS(empty); i++) {
        g_autoptr(TinkerScene) scene = physics_scene(NULL, empty[i]);
        g_autoptr(GArray) out = tinker_acting_forces_array();
        g_autoptr(GError) error = NULL;
        gboolean done = tinker_acting_forces_at_start(scene, out, &error);
        g_assert_true(done == (error == NULL));
        g_assert_cmpuint(out->len, ==, 0);
    }
    g_autoptr(TinkerScene) scene = physics_scene(NULL, "{'type': 'mass'}, {'type': 'spring', 'ends': ['Mass 0', [1, "
                                                       "1]]}");
    g_autoptr(GArray) out = tinker_acting_forces_array();
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_acting_forces_at_start(scene, out, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE);
}

/* The same bits ---------------------------------------------------------------------------------------------------- */

static const char rods_and_springs[] =
    "{'type': 'gravity'}, {'type': 'wind', 'drag': 0.05, 'drag_quadratic': 0.02}, {'type': 'support', 'solid': false},"
    "{'type': 'support', 'solid': false, 'position': [4, 1]}, {'type': 'mass', 'position': [1, 0.3]},"
    "{'type': 'mass', 'mass': 2, 'position': [2.1, -0.4]}, {'type': 'mass', 'mass': 0.5, 'position': [3, 0]},"
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
    "{'type': 'spring', 'ends': ['Mass 1', 'Mass 2'], 'rest_length': 1}, {'type': 'rod', 'ends': ['Mass 2', 'Support "
    "1']}, {'type': 'damper', 'ends': ['Mass 0', 'Mass 2']},"
    "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.2, 'frequency': 5},"
    "{'type': 'motor', 'ends': ['Mass 1'], 'waveform': {'expression': '5*square(3*t) + sin(t)'}}";

static const char contacts[] =
    "{'type': 'gravity'}, {'type': 'support', 'width': 20, 'orientation': 0.1, 'static_friction': 0.3, "
    "'dynamic_friction': 0.2, 'restitution': 0.6}, {'type': 'mass', 'position': [0, 2]}, {'type': 'mass', 'position': "
    "[-3, 1.5]}, {'type': 'mass', 'position': [-1.6, 1.5]}, {'type': 'rod', 'ends': ['Mass 1', 'Mass 2']},"
    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 2'], 'rest_length': 1.5}";

/* All samples of a run, with its end state behind. */
static GArray *run_watched(const char *blocks, const PhysicsOptions *how, gboolean looks, gboolean with_columns)
{
    g_autoptr(PhysicsRun) run = physics_prepare(how, "%s", blocks);
    Watch watch;
    open_watch(&watch, run->scene, run->model);
    watch.look = looks;
    watch.samples = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) none = tinker_columns_new();
    GArray *all = watch.columns;
    if (!with_columns) watch.columns = none;
    tinker_simulation_run(run->simulation, watch.columns, look, &watch, &run->error);
    g_assert_no_error(run->error);
    g_assert_cmpint(watch.allotted, ==, 0);
    g_assert_cmpint(watch.looked, ==, looks ? 151 : 0);
    watch.columns = all;
    const TinkerSummary *summary = tinker_simulation_summary(run->simulation);
    double counts[2] = {(double)summary->steps, (double)summary->evaluations};
    g_array_append_vals(watch.samples, counts, 2);
    g_array_append_vals(watch.samples, summary->books, TINKER_BOOK_COUNT);
    for (guint i = 0; i < watch.bodies->len; i++) {
        double state[4];
        tinker_simulation_state(run->simulation, g_array_index(watch.bodies, TinkerBlockId, i), state, state + 2);
        g_array_append_vals(watch.samples, state, 4);
    }
    close_watch(&watch);
    return watch.samples;
}

static void check_same_bits(const char *blocks, PhysicsOptions how)
{
    how.duration = 3;
    how.interval = 0.02;
    if (how.tolerance == 0) how.tolerance = 1e-7;
    for (int with_columns = 0; with_columns < 2; with_columns++) {
        g_autoptr(GArray) plain = run_watched(blocks, &how, FALSE, with_columns);
        g_autoptr(GArray) looked = run_watched(blocks, &how, TRUE, with_columns);
        g_assert_cmpmem(plain->data, plain->len * sizeof(double), looked->data, looked->len * sizeof(double));
    }
}

static void test_same_bits(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    if (method->flags & TINKER_INTEGRATOR_LINEAR) return;
    check_same_bits(rods_and_springs, (PhysicsOptions){.method = method->id});
}

static void test_same_bits_of_contacts(void)
{
    check_same_bits(contacts, (PhysicsOptions){.method = "auto"});
    check_same_bits(contacts, (PhysicsOptions){.method = "verlet", .step = 0.001});
    check_same_bits(contacts, (PhysicsOptions){.method = "auto", .step = 0.002, .impulses = TRUE});
}

/* Islands of their own: the whole model is not stepped itself. And what is stepped along a line. */
static void test_same_bits_of_islands(void)
{
    check_same_bits("{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [2, 0]},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1}, {'type': 'motor', 'ends': "
                    "['Mass 0'], 'frequency': 5}, {'type': 'mass', 'position': [0, 3]}, {'type': 'spring', 'ends': "
                    "['Support 0', 'Mass 1'], 'rest_length': 1}, {'type': 'damper', 'ends': ['Support 0', 'Mass 1']}",
                    (PhysicsOptions){.method = "auto"});
}

/* The set-up state is the first sample. */
static void test_start_is_first_sample(void)
{
    static const double start[] = {0};
    g_autoptr(PhysicsRun) once = physics_prepare(&(PhysicsOptions){.at = start, .at_count = 1}, "%s", contacts);
    Watch first;
    open_watch(&first, once->scene, once->model);
    tinker_simulation_run(once->simulation, first.columns, look, &first, &once->error);
    g_autoptr(GArray) out = at_start(once->scene);
    g_assert_cmpint(first.looked, ==, 1);
    g_assert_cmpuint(out->len, ==, first.out->len);
    for (guint i = 0; i < out->len; i++) { /* member by member: what lies between them is anything */
        const TinkerActingForce *l = &g_array_index(out, TinkerActingForce, i);
        const TinkerActingForce *r = &g_array_index(first.out, TinkerActingForce, i);
        g_assert_true(l->by == r->by && l->on == r->on && l->kind == r->kind);
        const double left[] = {l->x, l->y, l->fx, l->fy}, right[] = {r->x, r->y, r->fx, r->fy};
        g_assert_cmpmem(left, sizeof left, right, sizeof right);
    }
    close_watch(&first);
}

static void add_tests(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(scene_cases); i++) {
        g_autofree char *name = g_strdup_printf("/physics/acting-forces/sums/%s", scene_cases[i].name);
        g_test_add_data_func(name, &scene_cases[i], test_scene);
    }
    g_test_add_func("/physics/acting-forces/sums/other-roles", test_other_roles);
    g_test_add_func("/physics/acting-forces/hanging", test_hanging);
    g_test_add_func("/physics/acting-forces/turning", test_turning);
    g_test_add_func("/physics/acting-forces/incline", test_incline);
    g_test_add_func("/physics/acting-forces/odd-scenes", test_odd_scenes);
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        g_autofree char *name = g_strdup_printf("/physics/acting-forces/same-bits/%s", (*method)->id);
        g_test_add_data_func(name, *method, test_same_bits);
    }
    g_test_add_func("/physics/acting-forces/same-bits/contacts", test_same_bits_of_contacts);
    g_test_add_func("/physics/acting-forces/same-bits/islands", test_same_bits_of_islands);
    g_test_add_func("/physics/acting-forces/start-is-first-sample", test_start_is_first_sample);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
