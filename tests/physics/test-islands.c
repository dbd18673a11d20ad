/* Islands: what belongs together, and that parts which are stepped apart move as each does alone. */
#include "physics-fixture.h"

#include "numerics/methods/integrators.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/partition.h"
#include "physics/system/summary.h"

#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

/* --- how many there are --- */

static void assert_islands(guint expected, const char *blocks)
{
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    g_autoptr(GPtrArray) islands = tinker_islands_new(model, &error);
    g_assert_no_error(error);
    g_assert_cmpuint(islands->len, ==, expected);
    int bodies = 0;
    for (guint i = 0; i < islands->len; i++) {
        const TinkerIsland *island = g_ptr_array_index(islands, i);
        bodies += tinker_model_sizes(island->model).bodies;
    }
    g_assert_cmpint(bodies, ==, tinker_model_sizes(model).bodies);
}

#define THREE_MASSES                                                                                                   \
    "{'type': 'mass'}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', 'position': [2, 1]}, {'type': "          \
    "'support', "                                                                                                      \
    "'position': [0, 3]}"

static void test_number(void)
{
    assert_islands(1, "{'type': 'mass'}");
    assert_islands(3, THREE_MASSES);
    /* A support links nobody, nor do motors, a motion of it, gravity or wind. */
    assert_islands(3, THREE_MASSES ", {'type': 'spring', 'ends': ['Support 0', 'Mass 0']},"
                                   "{'type': 'rod', 'ends': ['Support 0', 'Mass 1']},"
                                   "{'type': 'damper', 'ends': ['Support 0', 'Mass 2']}");
    assert_islands(3, THREE_MASSES ", {'type': 'motor', 'ends': ['Mass 0']}, {'type': 'motor', 'ends': ['Mass 1']},"
                                   "{'type': 'gravity'}, {'type': 'wind', 'drag': 1},"
                                   "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 1}");
    /* Connectors, constraints and elements of several ends do. */
    assert_islands(2, THREE_MASSES ", {'type': 'spring', 'ends': ['Mass 2', 'Mass 0']}");
    assert_islands(2, THREE_MASSES ", {'type': 'rod', 'ends': ['Mass 1', 'Mass 0']}");
    assert_islands(2, THREE_MASSES ", {'type': 'damper', 'ends': ['Mass 1', 'Mass 0']},"
                                   "{'type': 'spring', 'ends': ['Mass 1', 'Mass 0']}");
    assert_islands(1, THREE_MASSES ", {'type': 'damper', 'ends': ['Mass 2', 'Mass 0']},"
                                   "{'type': 'rod', 'ends': ['Mass 1', 'Mass 2']}");
    assert_islands(1, THREE_MASSES ", {'type': 'torsion', 'ends': ['Mass 0', 'Mass 1', 'Mass 2']}");
    /* A field that couples bodies joins all of them. */
    assert_islands(1, THREE_MASSES ", {'type': 'attraction'}");
    assert_islands(1, "{'type': 'support'}, {'type': 'spring', 'ends': ['Support 0', {'block': 'Support 0', 'at': [0, "
                      "1]}]}, {'type': 'mass', 'position': [3, 0]}");
}

/* --- each part moves as it does alone --- */

/* Parts of a scene, of which each stands alone as well; the first block of each is the mass that is compared. */
static const char *const parts[] = {
    /* linear, along a line */
    "{'type': 'mass', 'name': 'A', 'position': [1.3, 0]}, {'type': 'support', 'name': 'SA'},"
    "{'type': 'spring', 'ends': ['SA', 'A'], 'rest_length': 1, 'stiffness': 30},"
    "{'type': 'damper', 'ends': ['SA', 'A'], 'damping': 0.3},"
    "{'type': 'motor', 'ends': ['A'], 'amplitude': 2, 'frequency': 3}",
    /* a pendulum on a moving support */
    "{'type': 'mass', 'name': 'B', 'position': [11, 5]}, {'type': 'support', 'name': 'SB', 'position': [10, 5]},"
    "{'type': 'rod', 'ends': ['SB', 'B']},"
    "{'type': 'support-motion', 'ends': ['SB'], 'amplitude': 0.1, 'frequency': 4, 'angle': '30 deg'}",
    /* a spring that swings, with a load that switches */
    "{'type': 'mass', 'name': 'C', 'position': [-4, -3.2], 'mass': 2}, {'type': 'support', 'name': 'SC', 'position': "
    "[-5, -2]}, {'type': 'spring', 'ends': ['C', 'SC'], 'rest_length': 1.25, 'stiffness': 50},"
    "{'type': 'motor', 'ends': ['C'], 'waveform': {'expression': '3*square(5*t)'}, 'angle': '70 deg'}",
};
static const char *const part_masses[] = {"A", "B", "C"};
#define SHARED ",{'type': 'gravity'}, {'type': 'wind', 'drag': 0.1, 'velocity': [1, 2]}"

static void assert_same_state(const PhysicsRun *left, const PhysicsRun *right, const char *mass)
{
    double l[4], r[4];
    physics_state(left, mass, l);
    physics_state(right, mass, r);
    g_assert_cmpmem(l, sizeof(l), r, sizeof(r));
}

static void test_as_alone(gconstpointer method)
{
    PhysicsOptions options = {.method = method, .duration = 3, .step = 0.0125, .tolerance = 1e-8, .interval = 0.1};
    g_autofree char *all = g_strdup_printf("%s, %s, %s" SHARED, parts[0], parts[1], parts[2]);
    options.columns = "A.x, A.y, B.x, B.y, C.x, C.y";
    g_autoptr(PhysicsRun) together = physics_run(&options, "%s", all);
    g_assert_cmpuint(together->summary->islands->len, ==, 3);
    gint64 steps = 0;
    double energy = 0;
    for (gsize p = 0; p < G_N_ELEMENTS(parts); p++) {
        g_autofree char *columns = g_strdup_printf("%s.x, %s.y", part_masses[p], part_masses[p]);
        options.columns = columns;
        g_autoptr(PhysicsRun) alone = physics_run(&options, "%s" SHARED, parts[p]);
        assert_same_state(together, alone, part_masses[p]);
        for (gsize i = 0; i < physics_samples(alone); i++)
            for (gsize k = 0; k < 2; k++)
                physics_assert_near("place", physics_value(together, i, 2 * p + k), physics_value(alone, i, k), 1e-14);
        steps += alone->summary->steps;
        energy += alone->summary->kinetic_end;
        const TinkerIslandSummary *island = g_ptr_array_index(together->summary->islands, p);
        g_assert_cmpstr(island->method, ==, alone->summary->method);
        g_assert_cmpuint(island->bodies->len, ==, 1);
        g_assert_cmpstr(tinker_scene_block_name(together->scene, g_array_index(island->bodies, TinkerBlockId, 0)), ==,
                        part_masses[p]);
    }
    g_assert_cmpint(together->summary->steps, ==, steps);
    physics_assert_near("kinetic energy", together->summary->kinetic_end, energy, 1e-13 * energy);
}

/* Oscillators of which one is far faster than the other have their solution, a pendulum beside them has none. */
static void test_methods_of_their_own(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 100, .tolerance = 1e-9, .columns = "Mass 0.x, Mass 1.x"},
        "{'type': 'support'}, {'type': 'mass', 'position': [1.5, 0]}, {'type': 'mass', 'position': [3, 0]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 1e4},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 1, 'stiffness': 1}, %s",
        parts[1]);
    const GPtrArray *islands = run->summary->islands;
    g_assert_cmpuint(islands->len, ==, 2);
    g_assert_cmpstr(((TinkerIslandSummary *)g_ptr_array_index(islands, 0))->method, ==, "exact");
    g_assert_cmpstr(((TinkerIslandSummary *)g_ptr_array_index(islands, 1))->method, !=, "exact");
    g_assert_cmpstr(run->summary->method, ==, "auto");
}

/* --- very many --- */

#define MANY           3000
#define COMMON_SUPPORT "{'type': 'support', 'position': [-3, 0]}"
#define OSCILLATOR                                                                                                     \
    ", {'type': 'mass', 'name': 'M%d', 'position': [1.5, %d]},"                                                        \
    "{'type': 'spring', 'ends': [{'block': 'Support 0', 'at': [3, %d]}, 'M%d'],"                                       \
    "'rest_length': 1, 'stiffness': %.17g}"

/* Oscillators of their own stiffness each, side by side, all on one support: each is an island, moves as it would
 * alone, and is where its solution is. */
static void test_many(gconstpointer method)
{
    GString *text = g_string_new(COMMON_SUPPORT), *columns = g_string_new(NULL);
    for (int i = 0; i < MANY; i++) {
        g_string_append_printf(text, OSCILLATOR, i, i, i, i, 10 + 0.1 * i);
        g_string_append_printf(columns, "%sM%d.x", i > 0 ? ", " : "", i);
    }
    PhysicsOptions options = {.method = method,
                              .duration = 0.5,
                              .interval = 0.125,
                              .step = 5e-4,
                              .tolerance = 1e-11,
                              .columns = columns->str};
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", text->str);
    g_string_free(text, TRUE);
    g_string_free(columns, TRUE);
    g_assert_cmpuint(run->summary->islands->len, ==, MANY);
    for (gsize i = 0; i < physics_samples(run); i++)
        for (int k = 0; k < MANY; k++)
            physics_assert_near("x", physics_value(run, i, (gsize)k),
                                1 + 0.5 * cos(sqrt(10 + 0.1 * k) * physics_time(run, i)), 1e-8);
    for (int k = 0; k < MANY; k += 299) {
        const TinkerIslandSummary *island = g_ptr_array_index(run->summary->islands, (guint)k);
        g_autofree char *name = g_strdup_printf("M%d", k);
        options.columns = NULL;
        g_autoptr(PhysicsRun) alone = physics_run(&options, COMMON_SUPPORT OSCILLATOR, k, k, k, k, 10 + 0.1 * k);
        g_assert_cmpuint(island->bodies->len, ==, 1);
        assert_same_state(run, alone, name);
    }
}

/* Pairs on one shaken support, in gravity, and as many that only lie about. */
static gint64 blocks_asked(int pairs)
{
    GString *text = g_string_new("{'type': 'support'}, {'type': 'gravity'},"
                                 "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1}");
    for (int i = 0; i < pairs; i++)
        g_string_append_printf(text,
                               ", {'type': 'mass', 'name': 'A%d', 'position': [1, %d]},"
                               "{'type': 'mass', 'name': 'B%d', 'position': [2, %d]}, {'type': 'mass'},"
                               "{'type': 'spring', 'ends': ['A%d', 'B%d']},"
                               "{'type': 'damper', 'ends': [{'block': 'Support 0', 'at': [1, 2]}, 'A%d']}",
                               i, i, i, i, i, i, i);
    g_autoptr(TinkerScene) scene = physics_scene(NULL, text->str);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    g_autoptr(TinkerPartition) partition = tinker_partition_new(model);
    g_assert_cmpint(partition->count, ==, 2 * pairs);
    /* of a pair: two masses, two connectors, support, motion and gravity; of a mass alone: that, the support, which has
     * a solid top, its motion, and gravity */
    g_assert_cmpuint(partition->numbers->len, ==, (guint)(pairs * (7 + 4)));
    g_string_free(text, TRUE);
    return partition->blocks_asked;
}

/* What finding the islands looks at goes with the number of blocks: three times as many are three times the work. */
static void test_partition_is_linear(void)
{
    gint64 few = blocks_asked(500);
    g_assert_cmpint(few, >, 0);
    g_assert_cmpint(blocks_asked(1500), ==, 3 * few);
}

/* --- breaks, supports, samples, warnings --- */

/* A table drives one part: its rows are breaks of that part alone. */
static void test_breaks_of_one(void)
{
    g_autofree char *folder = g_dir_make_tmp("tinker-islands-XXXXXX", NULL);
    g_autofree char *table = g_build_filename(folder, "table.csv", NULL);
    g_autofree char *path = g_build_filename(folder, "scene.tinker.json", NULL);
    g_autoptr(GError) error = NULL;
    g_file_set_contents(table, "time,force\n0,3\n0.371,-4\n0.905,8\n0.93,8\n1.6,0.5\n", -1, &error);
    g_assert_no_error(error);
    static const char *const methods[] = {"rk4", "dop853", "verlet"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        const PhysicsOptions options = {
            .method = methods[m], .duration = 2, .step = 0.01, .tolerance = 1e-9, .path = path, .columns = "B.x"};
        g_autoptr(PhysicsRun) alone = physics_run(&options, "%s", parts[1]);
        g_autoptr(PhysicsRun) beside =
            physics_run(&options,
                        "%s, {'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'table': 'table.csv',"
                        "'column': 1}}",
                        parts[1]);
        g_autoptr(PhysicsRun) driven = physics_run(
            &options, "{'type': 'mass', 'name': 'B'}, {'type': 'motor', 'ends': ['B'], 'waveform': {'table':"
                      "'table.csv', 'column': 1}}");
        assert_same_state(beside, alone, "B");
        g_assert_cmpint(beside->summary->steps, ==, alone->summary->steps + driven->summary->steps);
    }
    g_unlink(table);
    g_rmdir(folder);
}

/* One support shakes a pendulum, an oscillator across it and one along it. */
#define SHAKEN                                                                                                         \
    "{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [0.6, -0.8]},"                             \
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"                                                                \
    "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1, 'frequency': 3}"
#define ALONG                                                                                                          \
    ",{'type': 'mass', 'position': [2, 5]},"                                                                           \
    "{'type': 'spring', 'ends': [{'block': 'Support 0', 'at': [1, 5]}, 'Mass 1'], 'rest_length': 1, 'stiffness': 25}"

static const char forces_on_support[] = "Rod 0.tension, Spring 0.tension, Spring 0.length, Support 0.x, Support 0.vx, "
                                        "Support 0.ax, Mass 0.ax, Mass 1.ax, Mass 1.x";

static void test_shared_support(void)
{
    static const char *const methods[] = {"auto", "dop853", "rk4"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        PhysicsOptions options = {.method = methods[m],
                                  .duration = 3,
                                  .interval = 0.1,
                                  .step = 1e-3,
                                  .tolerance = 1e-11,
                                  .columns = "Mass 0.x, Mass 0.y, Rod 0.tension"};
        g_autoptr(PhysicsRun) alone = physics_run(&options, SHAKEN);
        options.columns = forces_on_support;
        g_autoptr(PhysicsRun) run = physics_run(&options, SHAKEN ALONG);
        g_assert_cmpuint(run->summary->islands->len, ==, 2);
        assert_same_state(run, alone, "Mass 0");
        for (gsize i = 0; i < physics_samples(run); i++) {
            double t = physics_time(run, i), u = 0.1 * sin(3 * t), stretch = physics_value(run, i, 2) - 1;
            physics_assert_near("rod's tension", physics_value(run, i, 0), physics_value(alone, i, 2), 1e-11);
            physics_assert_near("spring's tension", physics_value(run, i, 1), 25 * stretch, 1e-11);
            physics_assert_near("support's x", physics_value(run, i, 3), u, 1e-14);
            physics_assert_near("support's vx", physics_value(run, i, 4), 0.3 * cos(3 * t), 1e-14);
            physics_assert_near("support's ax", physics_value(run, i, 5), -9 * u, 1e-13);
            physics_assert_near("mass's ax", physics_value(run, i, 7),
                                -25 * stretch * (physics_value(run, i, 8) - 1 - u) / (1 + stretch), 1e-11);
        }
    }
}

/* x'' + 25 x = 25 u, with nothing across the spring: a second gravity undoes the first. */
static void test_shaken_oscillator(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 3, .interval = 0.1, .columns = "Mass 1.x, Mass 1.y"},
        SHAKEN ALONG ", {'type': 'gravity', 'acceleration': 9.81, 'angle': '90 deg'}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i), x = 0.1 * 25 * (sin(3 * t) - 0.6 * sin(5 * t)) / (25 - 9);
        physics_assert_near("x", physics_value(run, i, 0), 2 + x, 1e-10);
        physics_assert_near("y", physics_value(run, i, 1), 5, 1e-10);
    }
}

/* The energy books of the whole are the sums of the parts', and balance. */
static void test_books(void)
{
    const PhysicsOptions options = {.method = "dop853", .duration = 3, .tolerance = 1e-11};
    g_autoptr(PhysicsRun) together = physics_run(&options, "%s, %s, %s" SHARED, parts[0], parts[1], parts[2]);
    double sum[TINKER_BOOK_COUNT] = {0}, before = 0, after = 0;
    for (gsize p = 0; p < G_N_ELEMENTS(parts); p++) {
        g_autoptr(PhysicsRun) alone = physics_run(&options, "%s" SHARED, parts[p]);
        for (int book = 0; book < TINKER_BOOK_COUNT; book++)
            sum[book] += alone->summary->books[book];
    }
    const TinkerSummary *summary = together->summary;
    before = summary->kinetic_start + summary->potential_start;
    after = summary->kinetic_end + summary->potential_end;
    for (int book = 0; book < TINKER_BOOK_COUNT; book++) {
        physics_assert_near("book", summary->books[book], sum[book], 1e-12);
        before += summary->books[book];
    }
    physics_assert_near("energy", after, before, 1e-8);
}

static int count_warnings(const PhysicsRun *run, const char *words)
{
    int count = 0;
    for (guint i = 0; i < run->summary->warnings->len; i++)
        if (strstr(tinker_warnings_text(run->summary->warnings, i), words) != NULL) count++;
    return count;
}

/* What a part warns of is said once, and of that part alone. */
static void test_warnings_once(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .duration = 1},
                    "{'type': 'support'}, {'type': 'mass', 'position': [0.6, -0.8], 'velocity': [1, 2]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'mass', 'position': [5, 5]},"
                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 1']}, {'type': 'mass', 'position': [8, 5]}");
    for (guint i = 0; i < run->summary->warnings->len; i++)
        g_test_message("%s", tinker_warnings_text(run->summary->warnings, i));
    g_assert_cmpint(count_warnings(run, "velocities"), ==, 1);
    for (guint i = 0; i < run->summary->warnings->len; i++)
        for (guint k = 0; k < i; k++)
            g_assert_cmpstr(tinker_warnings_text(run->summary->warnings, i), !=,
                            tinker_warnings_text(run->summary->warnings, k));
    g_assert_cmpuint(run->summary->events->len, ==, 1);
}

/* The part that fails stops the run at its own time; the others are not blamed. */
static void test_one_fails(void)
{
    g_autoptr(PhysicsRun) run = physics_try(
        &(PhysicsOptions){.method = "dop853", .duration = 3, .interval = 0.25, .columns = "B.x, Mass 0.x"},
        "%s, {'type': 'mass', 'position': [0, 9]}, {'type': 'faulty', 'ends': ['Mass 0'], 'mode': 0}", parts[1]);
    physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "Faulty 0", "is not a number", NULL);
    g_assert_cmpfloat(run->summary->simulated_s, <=, 1.25);
    g_assert_cmpuint(physics_samples(run), >=, 4);
    g_assert_cmpfloat(run->summary->valid_until, <=, run->summary->simulated_s);
}

/* Each part is computed about its own place: what lies a thousand kilometres from it changes no bit of it. */
static void test_far_apart(void)
{
    const PhysicsOptions options = {
        .method = "dop853", .duration = 3, .interval = 0.25, .columns = "Spring 0.length, Rod 0.length error"};
    static const char here[] =
        "{'type': 'support', 'position': [1e6, -1e6]}, {'type': 'mass', 'position': [1000001.5, -1000000.5]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 30},"
        "{'type': 'mass', 'position': [1000003, -999999]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 1']},"
        "{'type': 'gravity'}";
    static const char *const others[] = {
        "{'type': 'mass'}", "{'type': 'support'}",
        ("{'type': 'support'}, {'type': 'mass', 'position': [0, 2]}, {'type': 'spring',"
         "'ends': ['Support 1', 'Mass 2']}")};
    g_autoptr(PhysicsRun) alone = physics_run(&options, "%s", here);
    for (gsize o = 0; o < G_N_ELEMENTS(others); o++) {
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s, %s", here, others[o]);
        assert_same_state(alone, run, "Mass 0");
        assert_same_state(alone, run, "Mass 1");
        for (gsize i = 0; i < physics_samples(alone); i++)
            for (gsize k = 0; k < 2; k++)
                physics_assert_near("sample", physics_value(run, i, k), physics_value(alone, i, k), 1e-9);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/islands/number", test_number);
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        if ((*method)->flags & TINKER_INTEGRATOR_LINEAR) continue;
        g_autofree char *name = g_strdup_printf("/physics/islands/as-alone/%s", (*method)->id);
        g_test_add_data_func(name, (*method)->id, test_as_alone);
    }
    g_test_add_data_func("/physics/islands/as-alone/auto", "auto", test_as_alone);
    g_test_add_func("/physics/islands/methods-of-their-own", test_methods_of_their_own);
    g_test_add_data_func("/physics/islands/many/auto", "auto", test_many);
    g_test_add_data_func("/physics/islands/many/rk4", "rk4", test_many);
    g_test_add_data_func("/physics/islands/many/dop853", "dop853", test_many);
    g_test_add_func("/physics/islands/partition-is-linear", test_partition_is_linear);
    g_test_add_func("/physics/islands/breaks-of-one", test_breaks_of_one);
    g_test_add_func("/physics/islands/shared-support", test_shared_support);
    g_test_add_func("/physics/islands/shaken-oscillator", test_shaken_oscillator);
    g_test_add_func("/physics/islands/books", test_books);
    g_test_add_func("/physics/islands/warnings-once", test_warnings_once);
    g_test_add_func("/physics/islands/one-fails", test_one_fails);
    g_test_add_func("/physics/islands/far-apart", test_far_apart);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
