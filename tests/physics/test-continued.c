/* Runs that are interrupted and continued, and runs of copies in several threads: both are the run in one go. */
#include "scene/history/continued.h"

#include <math.h>
#include <string.h>

#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"

typedef struct {
    TinkerModel *model;
    TinkerSimulation *simulation;
    TinkerFrame *frame; /* at the end; NULL: not wanted */
} Run;

static void run_clear(Run *run)
{
    tinker_frame_free(run->frame);
    tinker_simulation_free(run->simulation);
    tinker_model_free(run->model);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Run, run_clear)

static gboolean place(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    TinkerFrame *frame = data;
    (void)time, (void)values;
    return frame == NULL || tinker_simulation_place(simulation, frame, error);
}

/* By the scene's own settings but for the length and, where it is not NULL, the method. */
static gboolean run(Run *run, TinkerScene *scene, const char *method, double duration, gboolean framed, GError **error)
{
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.at = &duration;
    options.at_count = 1;
    if (method != NULL) options.method = method;
    options.tolerance = fmin(options.tolerance, 1e-11);
    run->model = tinker_model_new(scene, error);
    if (run->model == NULL) return FALSE;
    run->simulation = tinker_simulation_new(run->model, &options, error);
    if (run->simulation == NULL) return FALSE;
    if (framed) run->frame = tinker_frame_new(scene, error);
    return tinker_simulation_run(run->simulation, NULL, place, run->frame, error);
}

/* Velocities and rates by block id as a run leaves them; NaN for what does not move. (transfer full) */
static double *velocities_of(TinkerSimulation *simulation, TinkerScene *scene)
{
    double *velocities = g_new(double, 3 * (gsize)tinker_scene_id_limit(scene) + 1);
    for (int32_t id = 0; id < tinker_scene_id_limit(scene); id++) {
        TinkerBodySample body = {.vx = NAN, .vy = NAN, .rate = NAN};
        tinker_simulation_body(simulation, id, &body);
        memcpy(&velocities[3 * id], (double[]){body.vx, body.vy, body.rate}, 3 * sizeof(double));
    }
    return velocities;
}

static TinkerScene *continued(const Run *first, TinkerScene *scene, double t)
{
    g_autofree double *velocities = velocities_of(first->simulation, tinker_frame_scene(first->frame));
    g_autoptr(GError) error = NULL;
    TinkerScene *later = tinker_scene_continued(scene, first->frame, t, velocities, &error);
    g_assert_no_error(error);
    return later;
}

/* Bodies of both runs are in the same places with the same velocities, to `bound` of the largest there are. */
static void assert_same_state(const char *what, TinkerScene *scene, TinkerSimulation *left, TinkerSimulation *right,
                              double bound)
{
    double size = 1, worst = 0;
    int compared = 0;
    for (int32_t id = 0; id < tinker_scene_id_limit(scene); id++) {
        TinkerBodySample at[2];
        if (!tinker_simulation_body(left, id, &at[0])) continue;
        g_assert_true(tinker_simulation_body(right, id, &at[1]));
        const double l[] = {at[0].x, at[0].y, at[0].vx, at[0].vy, at[0].rate};
        const double r[] = {at[1].x, at[1].y, at[1].vx, at[1].vy, at[1].rate};
        for (gsize k = 0; k < G_N_ELEMENTS(l); k++) {
            size = fmax(size, fabs(l[k]));
            worst = fmax(worst, fabs(l[k] - r[k]));
        }
        compared++;
    }
    g_assert_cmpint(compared, >, 0);
    g_test_message("%s: off by %.2g of %.3g", what, worst, size);
    if (!(worst <= bound * size)) g_test_fail_printf("%s: off by %.3g, more than %.3g", what, worst, bound * size);
}

/* To 2 T in one go, and to T and on to 2 T. */
static void assert_continues(const char *what, TinkerScene *scene, const char *method, double T, double bound)
{
    g_autoptr(GError) error = NULL;
    g_auto(Run) whole = {0}, first = {0}, second = {0};
    g_assert_true(run(&whole, scene, method, 2 * T, FALSE, &error));
    g_assert_true(run(&first, scene, method, T, TRUE, &error));
    g_autoptr(TinkerScene) later = continued(&first, scene, T);
    gboolean ran = run(&second, later, method, T, FALSE, &error);
    if (!ran) g_test_fail_printf("%s: %s", what, error->message);
    if (ran) assert_same_state(what, scene, whole.simulation, second.simulation, bound);
}

/* s: what is solved of a blow through a pile begins at the impulses of the step before, which a scene does not keep,
 * and a pile magnifies every difference. So one is continued while it stands. */
#define UNTIL_BLOW 0.2

static void test_bundled(gconstpointer data)
{
    const char *name = data;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), name, NULL);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
    g_assert_no_error(error);
    const TinkerRunSettings *settings = &tinker_scene_head(scene)->run;
    const double longest = g_str_equal(settings->contacts, "impulse") ? UNTIL_BLOW : 1.0;
    assert_continues(name, scene, NULL, fmin(longest, settings->duration / 2), 1e-9);
}

static void assert_blocks_continue(const char *what, const char *blocks, double T)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    assert_continues(what, scene, "dop853", T, 1e-9);
}

#define SPRUNG                                                                                                         \
    "{'type': 'support', 'name': 'S', 'position': [0, 3], 'solid': false},"                                            \
    "{'type': 'mass', 'name': 'M', 'position': [0.3, 1]},"                                                             \
    "{'type': 'spring', 'ends': ['S', 'M'], 'stiffness': 20},"

static void test_motors(void)
{
    static const char *const waveforms[] = {
        "'cosine', 'amplitude': 3, 'frequency': 4, 'phase': 0.3", "'sine', 'amplitude': 3, 'frequency': 4",
        "{'expression': '5*square(3*t) + t'}", "{'expression': '20*pulse(t, 0.9, 1.1)'}",
        "{'expression': 'if(sin(5*t) > 0.3, 4, -t)'}"};
    for (gsize i = 0; i < G_N_ELEMENTS(waveforms); i++) {
        g_autofree char *blocks =
            g_strdup_printf(SPRUNG "{'type': 'motor', 'ends': ['M'], 'angle': 1, 'waveform': %s}", waveforms[i]);
        assert_blocks_continue(waveforms[i], blocks, 0.7);
        assert_blocks_continue(waveforms[i], blocks, 1.0);
    }
}

/* Laws that are typed, of time: with names and numbers in which there is a t, too. */
static void test_typed_laws(void)
{
    static const char *const blocks[] = {
        "{'type': 'mass', 'name': 'M'}, {'type': 'law-force', 'ends': ['M'], 'force_x': '1.5e1*tanh(t) + a*t',"
        " 'force_y': 'sqrt(t+1)*t^2', 'a': -2}",
        "{'type': 'mass', 'name': 'M'}, {'type': 'support', 'name': 'S', 'position': [2, 0], 'solid': false},"
        "{'type': 'law-connector', 'ends': ['S', 'M'], 'tension': '5*(L - 1)*step(sin(3*t)) + t'}",
        "{'type': 'mass', 'name': 'M'}, {'type': 'law-field', 'potential': 'm*x*cos(4*t)+0.5*m*y^2*exp(-t)'}"};
    for (gsize i = 0; i < G_N_ELEMENTS(blocks); i++)
        assert_blocks_continue("typed law", blocks[i], 1.3);
}

static void test_motions(void)
{
    static const char *const waveforms[] = {"'cosine', 'amplitude': 0.3, 'frequency': 4",
                                            "{'expression': '0.2*t*sin(3*t)'}"};
    for (gsize i = 0; i < G_N_ELEMENTS(waveforms); i++) {
        g_autofree char *hung =
            g_strdup_printf(SPRUNG "{'type': 'support-motion', 'ends': ['S'], 'waveform': %s}", waveforms[i]);
        assert_blocks_continue(waveforms[i], hung, 0.7);
        g_autofree char *pendulum =
            g_strdup_printf("{'type': 'gravity'}, {'type': 'support', 'name': 'S', 'position': [0, 3], 'solid': false},"
                            "{'type': 'mass', 'name': 'M', 'position': [0.8, 1.5], 'velocity': [1.5, 0.8]},"
                            "{'type': 'rod', 'ends': ['S', 'M']},"
                            "{'type': 'support-motion', 'ends': ['S'], 'angle': 1, 'waveform': %s}",
                            waveforms[i]);
        assert_blocks_continue(waveforms[i], pendulum, 0.7);
    }
}

/* Several interruptions, and a table of values and of accelerations that go on through them. */
static void test_tables(void)
{
    const double times[] = {0, 0.35, 0.8, 1.4, 2.2}, values[] = {0, 0.2, -0.1, 0.3, 0};
    for (int kind = TINKER_TABLE_VALUE; kind <= TINKER_TABLE_ACCELERATION; kind++) {
        g_autoptr(TinkerScene) scene =
            physics_scene(NULL, SPRUNG "{'type': 'support-motion', 'name': 'U', 'ends': ['S'], 'angle': 0.5}");
        g_autoptr(TinkerWaveform) table =
            tinker_waveform_new_table(times, values, G_N_ELEMENTS(times), (TinkerTableKind)kind, NULL);
        TinkerBlockId motion = tinker_scene_find_block(scene, "U");
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, motion);
        tinker_scene_set_waveform(scene, motion, tinker_block_class_property(block_class, "waveform"), table);
        g_autoptr(GError) error = NULL;
        g_auto(Run) whole = {0};
        g_assert_true(run(&whole, scene, "dop853", 3, FALSE, &error));
        g_autoptr(TinkerScene) now = tinker_scene_copy(scene);
        for (int part = 0; part < 5; part++) {
            g_auto(Run) some = {0};
            g_assert_true(run(&some, now, "dop853", 0.6, TRUE, &error));
            if (part == 4) assert_same_state("table", scene, whole.simulation, some.simulation, 1e-9);
            TinkerScene *later = continued(&some, now, 0.6);
            tinker_scene_free(now);
            now = later;
        }
    }
}

/* A slack cord on a disc that turns by w t, to a mass that goes round it by u t, through more than a turn each: with l
 * its length at the start and R the radius, l + R (u t - w t) is off the disc. The frame knows, and so does a scene
 * that goes on from there, also where it comes taut later on. */
static void test_wound(void)
{
    static const char blocks[] =
        "{'type': 'support', 'name': 'S', 'solid': false},"
        "{'type': 'disc', 'position': [0, 0], 'name': 'D', 'radius': 0.1, 'angular_velocity': 10, 'solid': false},"
        "{'type': 'pin', 'ends': ['S', 'D']}, {'type': 'rod', 'ends': ['S', 'M']},"
        "{'type': 'mass', 'name': 'M', 'position': [1, 0], 'velocity': [0, 4]},"
        "{'type': 'cord', 'name': 'C', 'ends': ['D', 'M'], 'length': 5}";
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    const TinkerBlockId cord = tinker_scene_find_block(scene, "C");
    g_autoptr(GError) error = NULL;
    g_auto(Run) first = {0};
    g_assert_true(run(&first, scene, "dop853", 2, TRUE, &error));
    physics_assert_near("length", tinker_frame_length(first.frame, cord), 5 + 0.1 * (4 - 10) * 2, 1e-9);
    g_autoptr(TinkerScene) later = continued(&first, scene, 2);
    g_auto(Run) second = {0};
    g_assert_true(run(&second, later, "dop853", 1, TRUE, &error));
    physics_assert_near("length", tinker_frame_length(second.frame, cord), 5 + 0.1 * (4 - 10) * 3, 1e-9);
    assert_blocks_continue("slack, then taut", blocks, 5);
    assert_blocks_continue("involute",
                           "{'type': 'support', 'name': 'S', 'solid': false},"
                           "{'type': 'mass', 'name': 'M', 'position': [0.2, -0.3], 'velocity': [2, 0]},"
                           "{'type': 'cord', 'ends': ['S', 'M'], 'radius': 0.2}",
                           3);
}

/* What has struck by then, or strikes at that very instant, does not strike again; what is to come does. */
static void test_blows(void)
{
    static const double times[] = {0, 0.4, 0.75, 1.1};
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++) {
        g_autofree char *blocks =
            g_strdup_printf(SPRUNG "{'type': 'impulse', 'ends': ['M'], 'impulse': 3, 'time': %.17g}", times[i]);
        assert_blocks_continue("blow", blocks, 0.75);
    }
}

/* What the user sees and sets: places, local origins, lengths; and a block that was added while the run stood still. */
static void test_properties(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'gravity'}," SPRUNG "{'type': 'damper', 'ends': ['S', 'M']}");
    g_autoptr(GError) error = NULL;
    g_auto(Run) first = {0};
    g_assert_true(run(&first, scene, "dop853", 0.5, TRUE, &error));
    TinkerBlockId mass = tinker_scene_find_block(scene, "M"), spring = tinker_scene_find_block(scene, "Spring 0");
    double position[2], velocity[2];
    g_assert_true(tinker_simulation_state(first.simulation, mass, position, velocity));

    g_autoptr(TinkerScene) edited = tinker_scene_copy(scene);
    TinkerBlockId added = tinker_scene_add_block(edited, tinker_scene_block_class(scene, mass), NULL, NULL);
    g_autoptr(TinkerScene) later = continued(&first, edited, 0.5);
    const TinkerBlockClass *masses = tinker_scene_block_class(scene, mass);
    int32_t place = tinker_block_class_meaning_column(masses, TINKER_MEANING_POSITION);
    int32_t speed = tinker_block_class_meaning_column(masses, TINKER_MEANING_VELOCITY);
    int32_t origin = tinker_block_class_meaning_column(masses, TINKER_MEANING_LOCAL_ORIGIN);
    int32_t length = tinker_block_class_meaning_column(tinker_scene_block_class(scene, spring), TINKER_MEANING_LENGTH);
    for (int k = 0; k < 2; k++) {
        g_assert_cmpfloat(tinker_scene_get(later, mass, place + k), ==, position[k]);
        g_assert_cmpfloat(tinker_scene_get(later, mass, speed + k), ==, velocity[k]);
        g_assert_cmpfloat(tinker_scene_get(later, mass, origin + k), ==, k == 0 ? 0.3 : 1);
        g_assert_cmpfloat(tinker_scene_get(later, added, place + k), ==, 0);
        g_assert_cmpfloat(tinker_scene_get(scene, mass, place + k), ==, k == 0 ? 0.3 : 1); /* the scene is as it was */
    }
    g_assert_cmpfloat(fabs(position[1] - 1), >, 0.1);
    g_assert_cmpfloat_with_epsilon(tinker_scene_get(later, spring, length), hypot(0.3, 2), 1e-15);
}

/* Runs a copy of a scene of its own, in a thread of its own. */
typedef struct {
    TinkerScene *scene;
    Run run;
    gboolean done;
} Job;

static gpointer work(gpointer data)
{
    Job *job = data;
    job->done = run(&job->run, job->scene, NULL, 1.0, TRUE, NULL);
    return NULL;
}

/* Copies share waveforms, tables that are made ready at first use, classes and the catalogue. */
static void test_threads(void)
{
    enum { JOBS = 4 };
    const double times[] = {0, 0.35, 0.8, 1.4, 2.2}, values[] = {0, 0.2, -0.1, 0.3, 0};
    for (int round = 0; round < 5; round++) {
        g_autoptr(TinkerScene) scene =
            physics_scene(NULL, "{'type': 'gravity'}," SPRUNG "{'type': 'support-motion', 'name': 'U', 'ends': ['S']},"
                                "{'type': 'motor', 'ends': ['M'], 'waveform': {'expression': 'square(9*t)'}}");
        g_autoptr(TinkerWaveform) table =
            tinker_waveform_new_table(times, values, G_N_ELEMENTS(times), TINKER_TABLE_VALUE, NULL);
        TinkerBlockId motion = tinker_scene_find_block(scene, "U");
        int32_t property = tinker_block_class_property(tinker_scene_block_class(scene, motion), "waveform");
        tinker_scene_set_waveform(scene, motion, property, table);

        Job jobs[JOBS] = {0};
        GThread *threads[JOBS];
        for (int i = 0; i < JOBS; i++)
            jobs[i].scene = tinker_scene_copy(scene);
        for (int i = 0; i < JOBS; i++)
            threads[i] = g_thread_new("run", work, &jobs[i]);
        /* the original is edited meanwhile */
        g_autoptr(TinkerScene) serial = tinker_scene_copy(scene);
        tinker_scene_rename_block(scene, motion, "V", NULL);
        tinker_scene_unset(scene, motion, property);
        tinker_scene_remove_block(scene, tinker_scene_find_block(scene, "M"));
        for (int i = 0; i < JOBS; i++)
            g_thread_join(threads[i]);

        g_autoptr(GError) error = NULL;
        g_auto(Run) alone = {0};
        g_assert_true(run(&alone, serial, NULL, 1.0, TRUE, &error));
        for (int i = 0; i < JOBS; i++) {
            g_assert_true(jobs[i].done);
            double left[4], right[4];
            TinkerBlockId mass = tinker_scene_find_block(serial, "M");
            g_assert_true(tinker_simulation_state(alone.simulation, mass, left, left + 2));
            g_assert_true(tinker_simulation_state(jobs[i].run.simulation, mass, right, right + 2));
            g_assert_cmpmem(left, sizeof left, right, sizeof right);
            run_clear(&jobs[i].run);
            tinker_scene_free(jobs[i].scene);
        }
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/continued/properties", test_properties);
    g_test_add_func("/physics/continued/motors", test_motors);
    g_test_add_func("/physics/continued/typed-laws", test_typed_laws);
    g_test_add_func("/physics/continued/motions", test_motions);
    g_test_add_func("/physics/continued/blows", test_blows);
    g_test_add_func("/physics/continued/wound", test_wound);
    g_test_add_func("/physics/continued/tables", test_tables);
    g_test_add_func("/physics/continued/threads", test_threads);
    g_autoptr(GDir) folder = g_dir_open(g_getenv("TINKER_SCENES"), 0, NULL);
    for (const char *name = g_dir_read_name(folder); name != NULL; name = g_dir_read_name(folder)) {
        if (!g_str_has_suffix(name, ".tinker.json")) continue;
        g_autofree char *path = g_strdup_printf("/physics/continued/bundled/%s", name);
        g_test_add_data_func_full(path, g_strdup(name), test_bundled, g_free);
    }
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
