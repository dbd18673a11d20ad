/* Motion along a line: where it is recognised, where it is not stable, and that it is the motion of the plane. */
#include "one-island.h"

#include "numerics/methods/integrators.h"
#include "physics/line/linear-form.h"

#include <math.h>
#include <string.h>

static TinkerModel *compile(const char *blocks, TinkerScene **scene)
{
    *scene = physics_scene(NULL, blocks);
    g_autoptr(GError) error = NULL;
    TinkerModel *model = tinker_model_new(*scene, &error);
    g_assert_no_error(error);
    return model;
}

/* --- where it is recognised --- */

/* Two masses of 1 and 2 kg between two supports, on a line through (2, 3): springs, dampers, a motor, a moving support,
 * gravity and wind, all along it. What is added may leave the line. */
static char *line_scene(double angle, const char *more)
{
    double c = cos(angle), s = sin(angle);
    return g_strdup_printf(
        "{'type': 'support', 'solid': false, 'position': [2, 3]}, {'type': 'support', 'solid': false, 'position': "
        "[%.17g, %.17g]},"
        "{'type': 'mass', 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g]},"
        "{'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 30},"
        "{'type': 'spring', 'ends': ['Mass 1', 'Mass 0'], 'rest_length': 1, 'stiffness': 20},"
        "{'type': 'spring', 'ends': ['Mass 1', 'Support 1'], 'rest_length': 1.25, 'stiffness': 50},"
        "{'type': 'damper', 'ends': ['Mass 1', 'Support 1'], 'damping': 0.4},"
        "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 0.2},"
        "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3, 'frequency': 4, 'angle': %.17g},"
        "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.1, 'frequency': 3, 'angle': %.17g},"
        "{'type': 'gravity', 'acceleration': 2, 'angle': %.17g},"
        "{'type': 'wind', 'drag': 0.1, 'velocity': [%.17g, %.17g]}%s",
        2 + 4 * c, 3 + 4 * s, 2 + 1.1 * c, 3 + 1.1 * s, -0.5 * c, -0.5 * s, 2 + 2.3 * c, 3 + 2.3 * s, angle,
        angle + G_PI, angle, 1.5 * c, 1.5 * s, more);
}

static const double angles[] = {0, G_PI / 2, 37 * G_PI / 180, -2.5};

static void test_straight(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(angles); i++) {
        g_autofree char *blocks = line_scene(angles[i], "");
        g_autoptr(TinkerScene) scene = NULL;
        g_autoptr(TinkerModel) model = compile(blocks, &scene);
        TinkerLinearForm *form = tinker_linear_form_new(model);
        double direction[2] = {0, 0};
        g_assert_nonnull(form);
        g_assert_true(tinker_linear_form_is_straight(form, direction));
        physics_assert_near("across", direction[0] * sin(angles[i]) - direction[1] * cos(angles[i]), 0, 1e-14);
        physics_assert_near("unit", hypot(direction[0], direction[1]), 1, 1e-15);
        g_assert_cmpint(tinker_linear_form_system(form)->size, ==, 2);
        g_assert_cmpfloat(tinker_model_sideways_growth(model), ==, 0);
        tinker_linear_form_free(form);
    }
}

/* Anything across the line leaves it; by less than 1e-12 of its own kind it is rounding. */
static void test_not_straight(void)
{
    static const char *const across[] = {
        ",{'type': 'gravity', 'acceleration': 1e-6, 'angle': '90 deg'}",
        ",{'type': 'wind', 'drag': 0.1, 'velocity': [0, 0.001]}",
        ",{'type': 'motor', 'ends': ['Mass 1'], 'amplitude': 1e-3, 'angle': '89 deg'}",
        ",{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 1e-3, 'angle': '1 deg'}",
        ",{'type': 'mass', 'position': [3, 3.00000001]}, {'type': 'spring', 'ends': ['Mass 2', 'Mass 0']}",
        (",{'type': 'mass', 'position': [5, 3], 'velocity': [0, 1e-6]},"
         "{'type': 'spring', 'ends': ['Mass 2', 'Mass 0']}"),
        ",{'type': 'mass', 'position': [5, 3]}, {'type': 'rod', 'ends': ['Mass 2', 'Mass 0']}",
        ",{'type': 'support', 'solid': false, 'position': [4, 9]}, {'type': 'damper', 'ends': ['Support 2', 'Mass 0']}",
        ",{'type': 'torsion', 'ends': ['Support 0', 'Mass 0', 'Mass 1']}",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(across); i++) {
        g_autofree char *blocks = line_scene(0, across[i]);
        g_autoptr(TinkerScene) scene = NULL;
        g_autoptr(TinkerModel) model = compile(blocks, &scene);
        TinkerLinearForm *form = tinker_linear_form_new(model);
        if (form != NULL) g_test_fail_printf("still linear: %s", across[i]);
        tinker_linear_form_free(form);
    }
}

/* --- across the line --- */

static double growth_of(const char *blocks)
{
    g_autoptr(TinkerScene) scene = NULL;
    g_autoptr(TinkerModel) model = compile(blocks, &scene);
    double growth = tinker_model_sideways_growth(model);
    TinkerLinearForm *form = tinker_linear_form_new(model);
    g_assert_true((form != NULL && tinker_linear_form_is_straight(form, NULL)) == (growth == 0));
    tinker_linear_form_free(form);
    return growth;
}

/* A spring of tension T and length L is one of stiffness T / L across: 2 kg between 20 N/m at 1 m and 40 N/m at 2 m,
 * both of which are compressed by half a metre at rest. The plane's motion leaves the line at that rate. */
static void test_pressed_mass(void)
{
    double across = -(20 * 0.5 / 1 + 40 * 0.25 / 2), growth = sqrt(-across / 2);
    static const char pressed[] =
        "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [3, 0]}, {'type': "
        "'mass', 'mass': 2, 'position': [1, "
        "%s]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1.5, 'stiffness': 20},"
        "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'rest_length': 2.25, 'stiffness': 40}";
    g_auto(GStrv) halves = g_strsplit(pressed, "%s", 2);
    g_autofree char *on = g_strjoinv("0", halves), *off = g_strjoinv("1e-9", halves);
    physics_assert_near("growth", growth_of(on), growth, 1e-9);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "dop853", .tolerance = 1e-13, .duration = 5, .columns = "Mass 0.y"}, "%s", off);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double y = 1e-9 * cosh(growth * physics_time(run, i));
        physics_assert_near("y", physics_value(run, i, 0), y, 1e-4 * y);
    }
}

/* A spring without length in the middle of a pressed mass holds it on the line, with all of its stiffness where its
 * ends are at one place: 2 * 50 * 0.2 / 1 = 20 N/m push it off. */
static void test_guyed_mass(void)
{
    static const double stiffnesses[] = {0, 19, 21};
    for (gsize i = 0; i < G_N_ELEMENTS(stiffnesses); i++) {
        g_autofree char *blocks = g_strdup_printf(
            "{'type': 'support', 'solid': false, 'position': [-1, 0]},"
            "{'type': 'support', 'solid': false, 'position': [1, 0]}, {'type': 'support', 'solid': false},"
            "{'type': 'mass', 'velocity': [1, 0]},"
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1.2, 'stiffness': 50},"
            "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'rest_length': 1.2, 'stiffness': 50},"
            "{'type': 'spring', 'ends': ['Support 2', 'Mass 0'], 'rest_length': 0, 'stiffness': %g}",
            stiffnesses[i]);
        physics_assert_near("growth", growth_of(blocks), sqrt(fmax(20 - stiffnesses[i], 0)), 1e-9);
    }
}

/* On 50 N/m, 9.81 N stand 0.1962 m lower: sqrt(g / L) is the rate of the inverted pendulum of that length. Hung up, the
 * same is stable; so is one that stands between a lower spring that is pressed and an upper one that pulls enough. */
static void test_columns(void)
{
    physics_assert_near(
        "standing",
        growth_of("{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 1]}, {'type': 'gravity',"
                  "'acceleration': 9.81},"
                  "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 50}"),
        sqrt(9.81 / (1 - 0.1962)), 1e-9);
    physics_assert_near(
        "hanging",
        growth_of("{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, -1]}, {'type': 'gravity'},"
                  "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 50}"),
        0, 0);
    physics_assert_near(
        "guyed",
        growth_of("{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 1]}, {'type': 'gravity'},"
                  "{'type': 'support', 'solid': false, 'position': [0, 3]},"
                  "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 50},"
                  "{'type': 'spring', 'ends': ['Support 1', 'Mass 0'], 'rest_length': 0.5, 'stiffness': 50}"),
        0, 0);
}

/* Two unit masses stand on each other, 100 N/m each and 10 m/s^2: the lower spring bears 20 N at 0.8 m, the upper one
 * 10 N at 0.9 m, so K = [-20/0.8 - 10/0.9, 10/0.9; 10/0.9, -10/0.9]. */
static void test_standing_pair(void)
{
    double a = -20 / 0.8 - 10 / 0.9, b = 10 / 0.9, d = -10 / 0.9;
    double least = (a + d) / 2 - sqrt((a - d) * (a - d) / 4 + b * b);
    double growth = growth_of(
        "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 1]}, {'type': 'mass', 'position':"
        "[0, 2]}, {'type': 'gravity', 'acceleration': 10},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 100},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 1, 'stiffness': 100}");
    physics_assert_near("growth", growth, sqrt(-least), 1e-6);
}

/* What hangs on nothing is free of tension at rest, however it starts, and while it falls. */
static void test_free_chains(void)
{
    static const char chain[] =
        "{'type': 'mass', 'position': [0, 0]}, {'type': 'mass', 'mass': 3, 'position': [0, 0.7]},"
        "{'type': 'mass', 'position': [0, 2]},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 1, 'stiffness': 100},"
        "{'type': 'spring', 'ends': ['Mass 1', 'Mass 2'], 'rest_length': 1, 'stiffness': 100}";
    static const char *const more[] = {"", ",{'type': 'gravity'}", ",{'type': 'gravity', 'angle': '90 deg'}"};
    for (gsize i = 0; i < G_N_ELEMENTS(more); i++) {
        g_autofree char *blocks = g_strconcat(chain, more[i], NULL);
        physics_assert_near(more[i], growth_of(blocks), 0, 0);
    }
}

/* --- the same motion as in the plane --- */

/* Stepped to the end along its line or, `plane`, with two coordinates a body. */
static void line_run(OneIsland *self, const char *blocks, const TinkerChoice *choice, gboolean plane, double end)
{
    g_autoptr(GError) error = NULL;
    one_island_open(self, blocks);
    g_assert_nonnull(self->island.linear);
    if (plane) self->island.linear = NULL;
    one_island_start(self, choice, end);
    g_assert_cmpint(self->run->system.system.size, ==, (plane ? 2 : 1) * self->model->bodies);
    while (self->run->state.t < end)
        if (!tinker_island_run_step(self->run, end, &error)) break;
    g_assert_no_error(error);
    tinker_island_run_close(self->run, end, &error);
    g_assert_no_error(error);
    tinker_island_run_place(self->run);
}

static gboolean is_adaptive(const TinkerIntegrator *method)
{
    return (method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
}

/* Adaptive methods weigh one coordinate a body otherwise than two, so that their steps differ. */
static void assert_same_motion(const OneIsland *line, const OneIsland *plane, double bound)
{
    for (int32_t i = 0; i < line->model->coordinates; i++) {
        physics_assert_near("place", line->run->q[i], plane->run->q[i], bound);
        physics_assert_near("speed", line->run->v[i], plane->run->v[i], 10 * bound);
    }
    for (int32_t book = 0; book < line->run->system.system.books; book++)
        physics_assert_near("book", line->run->state.books[book], plane->run->state.books[book], 10 * bound);
    const TinkerSummary *l = &line->run->summary, *p = &plane->run->summary;
    physics_assert_near("kinetic", l->kinetic_end, p->kinetic_end, 10 * bound);
    physics_assert_near("potential", l->potential_end - l->potential_start, p->potential_end - p->potential_start,
                        10 * bound);
    if (!is_adaptive(line->run->choice.method)) g_assert_cmpint(l->steps, ==, p->steps);
}

static void test_as_in_the_plane(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    const TinkerChoice choice = {.method = method, .step = 0.01, .tolerance = 1e-13};
    for (gsize i = 0; i < G_N_ELEMENTS(angles); i++) {
        g_autofree char *blocks = line_scene(angles[i], "");
        g_auto(OneIsland) line = {0}, plane = {0};
        line_run(&line, blocks, &choice, FALSE, 4);
        line_run(&plane, blocks, &choice, TRUE, 4);
        assert_same_motion(&line, &plane, is_adaptive(method) ? 1e-11 : 1e-12);
    }
}

/* Along the line the energy balances to the method's order, with dampers, a motor, wind and a moving support. */
static void test_books(void)
{
    static const char *const methods[] = {"dop853", "exact"};
    for (gsize i = 0; i < G_N_ELEMENTS(angles); i++) {
        g_autofree char *blocks = line_scene(angles[i], "");
        double books[2][TINKER_BOOK_COUNT];
        for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
            g_autoptr(PhysicsRun) run =
                physics_run(&(PhysicsOptions){.method = methods[m], .duration = 4, .tolerance = 1e-12}, "%s", blocks);
            g_test_message("%s: %g", methods[m], run->summary->energy_balance_error);
            g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-10);
            memcpy(books[m], run->summary->books, sizeof(books[m]));
            g_assert_cmpfloat(fabs(books[m][TINKER_BOOK_DAMPERS]), >, 0.01);
            g_assert_cmpfloat(fabs(books[m][TINKER_BOOK_MOTORS]), >, 0.01);
            g_assert_cmpfloat(fabs(books[m][TINKER_BOOK_SUPPORT_MOTION]), >, 0.01);
            g_assert_cmpfloat(fabs(books[m][TINKER_BOOK_FIELDS]), >, 0.01);
        }
        for (int book = 0; book < TINKER_BOOK_COUNT; book++)
            physics_assert_near("book", books[0][book], books[1][book], 1e-9);
    }
}

/* --- through the anchor --- */

/* x'' = -4 (x - sign(x)) from 1.2 m with -5 m/s, side by side: within a side an oscillation about its own +-1. */
static void through_anchor(double t, double *x, double *v)
{
    double side = 1, x0 = 1.2, v0 = -5;
    for (;;) {
        /* side * x - 1 = a cos 2t + b sin 2t = r cos(2t - phase); it is at 0 where that is -1, going down */
        double a = side * x0 - 1, b = side * v0 / 2, r = hypot(a, b), phase = atan2(b, a);
        double leave = r > 1 ? fmod(acos(-1 / r) + phase + 2 * G_PI, 2 * G_PI) / 2 : INFINITY;
        if (leave < 1e-9) leave += G_PI;
        double now = fmin(t, leave);
        *x = side * (1 + a * cos(2 * now) + b * sin(2 * now));
        *v = side * 2 * (b * cos(2 * now) - a * sin(2 * now));
        if (t <= leave) return;
        t -= leave;
        side = -side;
        x0 = 0;
        v0 = *v;
    }
}

#define THROUGH                                                                                                        \
    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0, 1.2], 'velocity': [0, -5]},"                \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 4}"

static void test_through_anchor(void)
{
    static const struct {
        const char *method;
        double bound;
    } cases[] = {{"exact", 1e-12}, {"auto", 1e-12},  {"dop853", 1e-5},  {"dopri5", 1e-5},
                 {"rk4", 5e-2},    {"verlet", 5e-2}, {"newmark", 5e-2}, {"generalized-alpha", 5e-2}};
    for (gsize c = 0; c < G_N_ELEMENTS(cases); c++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = cases[c].method,
                                                                  .duration = 10,
                                                                  .interval = 0.05,
                                                                  .step = 1e-3,
                                                                  .tolerance = 1e-11,
                                                                  .columns = "Mass 0.y, Mass 0.vy, Mass 0.x"},
                                                THROUGH);
        double most = 0;
        for (gsize i = 0; i < physics_samples(run); i++) {
            double x, v;
            through_anchor(physics_time(run, i), &x, &v);
            most = fmax(most, fmax(fabs(physics_value(run, i, 0) - x), fabs(physics_value(run, i, 1) - v)));
            physics_assert_near("x", physics_value(run, i, 2), 0, 0);
        }
        g_test_message("%s: off by %.3g", cases[c].method, most);
        physics_assert_near(cases[c].method, most, 0, cases[c].bound);
        g_assert_cmpfloat(run->summary->energy_balance_error, <, cases[c].bound);
    }
}

static void test_through_anchor_as_in_the_plane(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    const TinkerChoice choice = {.method = method, .step = 1e-3, .tolerance = 1e-9};
    g_auto(OneIsland) line = {0}, plane = {0};
    line_run(&line, THROUGH, &choice, FALSE, 4);
    line_run(&plane, THROUGH, &choice, TRUE, 4);
    assert_same_motion(&line, &plane, is_adaptive(method) ? 1e-5 : 1e-10);
}

static void add_tests(void)
{
    g_test_add_func("/physics/linear-form/straight", test_straight);
    g_test_add_func("/physics/linear-form/not-straight", test_not_straight);
    g_test_add_func("/physics/linear-form/pressed-mass", test_pressed_mass);
    g_test_add_func("/physics/linear-form/guyed-mass", test_guyed_mass);
    g_test_add_func("/physics/linear-form/columns", test_columns);
    g_test_add_func("/physics/linear-form/standing-pair", test_standing_pair);
    g_test_add_func("/physics/linear-form/free-chains", test_free_chains);
    g_test_add_func("/physics/linear-form/books", test_books);
    g_test_add_func("/physics/linear-form/through-anchor", test_through_anchor);
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        if ((*method)->flags & TINKER_INTEGRATOR_LINEAR) continue;
        g_autofree char *name = g_strdup_printf("/physics/linear-form/as-in-the-plane/%s", (*method)->id);
        g_autofree char *through = g_strdup_printf("/physics/linear-form/through-anchor/%s", (*method)->id);
        g_test_add_data_func(name, *method, test_as_in_the_plane);
        g_test_add_data_func(through, *method, test_through_anchor_as_in_the_plane);
    }
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
