/* Straight bars of point masses on rods in one line, one rod as long as others together: compound pendulums, bars that
 * are thrown, loaded across or hinged to one another, against closed forms and an independent integration. */
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "test-systems.h"

#include <math.h>
#include <string.h>

static const double g = 9.81;

/* Methods with the error (of the length) that their order leaves in 2 s at steps of 2 ms, h w being 0.01. */
static const struct {
    const char *method;
    double bound;
} methods[] = {
    {"dop853", 1e-8},
    {"dopri5", 1e-7},
    {"rk4", 1e-7},
    {"verlet", 1e-3},
    {"verlet6", 1e-9},
    {"newmark", 2e-3},
    {"generalized-alpha", 5e-3},
    {"semi-implicit-euler", 0.2},
};

/* Where the masses are on a bar, in m from the pivot, and which they are, in kg. */
#define MOST 5
typedef struct {
    int count;
    double at[MOST], mass[MOST];
    const char *rods; /* pairs of digits: 0 the pivot, 1 the first mass, ... */
} BarCase;

static const BarCase bars[] = {
    {2, {0.5, 1}, {2.0 / 3, 1.0 / 6}, "01 12 02"},                 /* a uniform bar by Simpson's rule: 2/3 m */
    {3, {0.25, 0.5, 1}, {1, 3, 0.5}, "01 12 23 03"},               /* one rod over three */
    {4, {0.2, 0.5, 0.9, 1}, {1, 2, 3, 4}, "02 01 12 24 34 23 13"}, /* rods over one another, the ends never tied */
    {3, {0.25, 0.5, 1}, {1, 3, 0.5}, "01 02 03 12 13 23"},         /* each to each */
};

/* The pivot is Support 0, at (x, y), unless it is a mass of its own. */
static void add_bar(GString *text, const BarCase *bar, const double pivot[2], double angle, const char *first)
{
    for (int i = 0; i < bar->count; i++)
        g_string_append_printf(text, "{'type': 'mass', 'name': 'M%d', 'mass': %.17g, 'position': [%.17g, %.17g]},",
                               i + 1, bar->mass[i], pivot[0] + bar->at[i] * sin(angle),
                               pivot[1] - bar->at[i] * cos(angle));
    for (const char *c = bar->rods; *c != '\0'; c += c[2] == ' ' ? 3 : 2) {
        g_autofree char *a = c[0] == '0' ? g_strdup(first) : g_strdup_printf("M%c", c[0]);
        g_string_append_printf(text, "{'type': 'rod', 'ends': ['%s', 'M%c']}%s", a, c[1], c[2] == ' ' ? "," : "");
    }
}

/* Of the pendulum with one mass that swings alike. */
static double reduced_length(const BarCase *bar)
{
    double first = 0, second = 0;
    for (int i = 0; i < bar->count; i++) {
        first += bar->mass[i] * bar->at[i];
        second += bar->mass[i] * bar->at[i] * bar->at[i];
    }
    return second / first;
}

/* Every bar hangs on a pivot far from the origin's axes, and is let go at 2 rad. */
static void test_compound_pendulum(void)
{
    const double pivot[2] = {3, -7}, start = 2;
    for (gsize b = 0; b < G_N_ELEMENTS(bars); b++)
        for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
            const BarCase *bar = &bars[b];
            Pendulum p;
            pendulum_init(&p, reduced_length(bar), g, start, 0);
            g_autoptr(GString) text =
                g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': "
                             "[3, -7]},");
            add_bar(text, bar, pivot, start, "Support 0");
            g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = methods[m].method,
                                                                      .duration = 2,
                                                                      .step = 2e-3,
                                                                      .tolerance = 1e-11,
                                                                      .columns = "M1.x, M1.y, M2.x, M2.y"},
                                                    "%s", text->str);
            g_test_message("bar %zu, %s", b, methods[m].method);
            g_assert_cmpint(tinker_model_sizes(run->model).degrees_of_freedom, ==, 1);
            for (gsize i = 0; i < physics_samples(run); i++) {
                double q[2], v[2];
                pendulum_exact(&p, physics_time(run, i), q, v);
                for (gsize k = 0; k < 4; k++)
                    physics_assert_near(k % 2 == 0 ? "x" : "y", physics_value(run, i, k),
                                        pivot[k % 2] + bar->at[k / 2] * q[k % 2] / p.length, methods[m].bound);
            }
            g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-12);
        }
}

/* A bar of 1 kg, 2 kg and 5 kg at -1, 0.2 and 0.9 m that is thrown: its centre flies along a parabola, and it turns on
 * as fast as ever, also where that is a thousand times a second. What pulls its end inwards is m w^2 r. */
static void test_thrown(void)
{
    static const double mass[3] = {1, 2, 5}, at[3] = {-1, 0.2, 0.9}, spins[] = {3, 6283};
    double centre = 0;
    for (int i = 0; i < 3; i++)
        centre += mass[i] * at[i] / 8;
    for (gsize s = 0; s < G_N_ELEMENTS(spins); s++) {
        double spin = spins[s], angle = 0.4;
        g_autoptr(GString) text = g_string_new("{'type': 'gravity'},");
        for (int i = 0; i < 3; i++) {
            double r = at[i] - centre;
            g_string_append_printf(
                text, "{'type': 'mass', 'mass': %g, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g]},", mass[i],
                r * cos(angle), r * sin(angle), 2 - spin * r * sin(angle), 5 + spin * r * cos(angle));
        }
        g_string_append(text, "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}, {'type': 'rod', 'ends': ['Mass 1', 'Mass "
                              "2']}, {'type': 'rod', 'ends': ['Mass 2', 'Mass 0']}");
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 6 / spin,
                              .columns = "Mass 0.x, Mass 0.y, Mass 2.x, Mass 2.y, Rod 1.tension, Rod 2.tension"},
            "%s", text->str);
        g_assert_cmpint(tinker_model_sizes(run->model).degrees_of_freedom, ==, 3);
        for (gsize i = 0; i < physics_samples(run); i++) {
            double t = physics_time(run, i), now = angle + spin * t, x = 2 * t, y = 5 * t - g * t * t / 2;
            physics_assert_near("x", physics_value(run, i, 0), x + (at[0] - centre) * cos(now), 1e-8);
            physics_assert_near("y", physics_value(run, i, 1), y + (at[0] - centre) * sin(now), 1e-8);
            physics_assert_near("x", physics_value(run, i, 2), x + (at[2] - centre) * cos(now), 1e-8);
            physics_assert_near("y", physics_value(run, i, 3), y + (at[2] - centre) * sin(now), 1e-8);
            double pull = mass[2] * spin * spin * (at[2] - centre);
            physics_assert_near("pull", (physics_value(run, i, 4) + physics_value(run, i, 5)) / pull, 1, 1e-8);
        }
        g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-12);
    }
}

/* A beam of 2 m that hangs on rods at its ends carries 6 kg at 0.5 m from the left one: it stays as it is, and the rods
 * share the load by the lever rule, 3 : 1, beside what the ends weigh. Pressed together the bar stays straight, too. */
static void test_loaded_across(void)
{
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[m].method,
                              .duration = 3,
                              .tolerance = 1e-9,
                              .columns = "Load.x, Load.y, Left rod.tension, Right rod.tension"},
            "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [0, 1]},"
            "{'type': 'support', 'solid': false, 'position': [2, 1]},"
            "{'type': 'mass', 'name': 'L'}, {'type': 'mass', 'name': 'Load', 'mass': 6, 'position': [0.5, 0]},"
            "{'type': 'mass', 'name': 'R', 'position': [2, 0]}, {'type': 'spring', 'ends': ['L', 'R'], 'stiffness': "
            "50, "
            "'rest_length': 1}, {'type': 'rod', 'name': 'Left rod', 'ends': ['Support 0', 'L']},"
            "{'type': 'rod', 'name': 'Right rod', 'ends': ['Support 1', 'R']}, {'type': 'rod', 'ends': ['L', 'Load']},"
            "{'type': 'rod', 'ends': ['Load', 'R']}, {'type': 'rod', 'ends': ['L', 'R']}");
        g_assert_cmpint(tinker_model_sizes(run->model).degrees_of_freedom, ==, 1);
        for (gsize i = 0; i < physics_samples(run); i++) {
            physics_assert_near("x", physics_value(run, i, 0), 0.5, 1e-9);
            physics_assert_near("y", physics_value(run, i, 1), 0, 1e-9);
            physics_assert_near("left", physics_value(run, i, 2), g * (1 + 4.5), 1e-8);
            physics_assert_near("right", physics_value(run, i, 3), g * (1 + 1.5), 1e-8);
        }
    }
}

/* Masses in a line of rods between two supports that are just as far apart cannot move, whatever pulls. */
static void test_between_supports(void)
{
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[m].method,
                              .duration = 2,
                              .tolerance = 1e-9,
                              .columns = "Mass 0.x, Mass 0.y, Mass 1.x, Mass 1.y, Mass 0.vx, Mass 1.vy"},
            "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [-1, -0.5]},"
            "{'type': 'support', 'solid': false, 'position': [2, 1]},"
            "{'type': 'mass'}, {'type': 'mass', 'mass': 9, 'position': [1, 0.5]},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
            "{'type': 'rod', 'ends': ['Mass 1', 'Support 1']}");
        static const double places[6] = {0, 0, 1, 0.5, 0, 0};
        g_assert_cmpint(tinker_model_sizes(run->model).degrees_of_freedom, ==, 0);
        for (gsize i = 0; i < physics_samples(run); i++)
            for (gsize k = 0; k < 6; k++)
                physics_assert_near("place", physics_value(run, i, k), places[k], 1e-12);
    }
}

/* Two bars on one line at the start, hinged at the mass that they share: a double pendulum. */
typedef struct {
    double a, b, c, load[2];
} Hinged;

/* a t1'' + b cos(t1 - t2) t2'' = -b sin(t1 - t2) t2'^2 - G1 sin t1, and likewise for t2. */
static void hinged_rate(double t, const double *y, double *rate, const void *data)
{
    const Hinged *h = data;
    double s = h->b * sin(y[0] - y[1]), k = h->b * cos(y[0] - y[1]);
    double first = -s * y[3] * y[3] - h->load[0] * sin(y[0]), second = s * y[2] * y[2] - h->load[1] * sin(y[1]);
    double determinant = h->a * h->c - k * k;
    rate[0] = y[2];
    rate[1] = y[3];
    rate[2] = (h->c * first - k * second) / determinant;
    rate[3] = (h->a * second - k * first) / determinant;
}

static void test_hinged(void)
{
    /* 1 kg at 0.5 m and 2 kg at 1 m; from there 3 kg at 0.4 m and 1 kg at 1 m */
    const Hinged h = {1 * 0.25 + 2 + 4, 1 * (3 * 0.4 + 1), 3 * 0.16 + 1, {g * (0.5 + 2 + 4), g * (1.2 + 1)}};
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 2, .interval = 0.25, .columns = "B.x, B.y, D.x, D.y, C.x, C.y"},
                    "{'type': 'gravity'}, {'type': 'support', 'solid': false},"
                    "{'type': 'mass', 'name': 'A', 'position': [0.5, 0]},"
                    "{'type': 'mass', 'name': 'B', 'mass': 2, 'position': [1, 0]},"
                    "{'type': 'mass', 'name': 'C', 'mass': 3, 'position': [1.4, 0]},"
                    "{'type': 'mass', 'name': 'D', 'position': [2, 0]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'A']}, {'type': 'rod', 'ends': ['A', 'B']},"
                    "{'type': 'rod', 'ends': ['B', 'Support 0']}, {'type': 'rod', 'ends': ['B', 'C']},"
                    "{'type': 'rod', 'ends': ['C', 'D']}, {'type': 'rod', 'ends': ['D', 'B']}");
    g_assert_cmpint(tinker_model_sizes(run->model).degrees_of_freedom, ==, 2);
    double y[4] = {G_PI / 2, G_PI / 2, 0, 0};
    for (gsize i = 0; i < physics_samples(run); i++) {
        if (i > 0) physics_rk4(4, y, physics_time(run, i - 1), physics_time(run, i), 4000, hinged_rate, &h);
        double end[2] = {sin(y[0]) + sin(y[1]), -cos(y[0]) - cos(y[1])};
        physics_assert_near("hinge x", physics_value(run, i, 0), sin(y[0]), 1e-8);
        physics_assert_near("hinge y", physics_value(run, i, 1), -cos(y[0]), 1e-8);
        physics_assert_near("end x", physics_value(run, i, 2), end[0], 1e-8);
        physics_assert_near("end y", physics_value(run, i, 3), end[1], 1e-8);
        physics_assert_near("between x", physics_value(run, i, 4), 0.6 * sin(y[0]) + 0.4 * end[0], 1e-8);
        physics_assert_near("between y", physics_value(run, i, 5), -0.6 * cos(y[0]) + 0.4 * end[1], 1e-8);
    }
}

/* Places and lengths that are typed with a few digits: the middle mass is up to 1e-5 rad off the line, and lengths miss
 * by up to 5e-7. It is the uniform bar all the same, as exactly as that. */
static void test_few_digits(void)
{
    static const double off[] = {1e-9, 1e-7, 1e-6, 4e-6, 6e-6, 1e-5, 2e-5}, miss[] = {0, 3e-7, -5e-7};
    static const char *const some[] = {"dop853", "rk4", "verlet6"};
    for (gsize k = 0; k < G_N_ELEMENTS(off) * G_N_ELEMENTS(miss); k++)
        for (gsize m = 0; m < G_N_ELEMENTS(some); m++) {
            double d = off[k / G_N_ELEMENTS(miss)], wrong = miss[k % G_N_ELEMENTS(miss)];
            Pendulum p;
            pendulum_init(&p, 2.0 / 3, g, G_PI / 2, 0);
            g_autoptr(PhysicsRun) run = physics_run(
                &(PhysicsOptions){.method = some[m], .duration = 1, .step = 2e-3, .columns = "End.x, End.y"},
                "{'type': 'gravity'}, {'type': 'support', 'solid': false},"
                "{'type': 'mass', 'name': 'Mid', 'mass': %.17g, 'position': [0.5, %.17g]},"
                "{'type': 'mass', 'name': 'End', 'mass': %.17g, 'position': [1, 0]},"
                "{'type': 'rod', 'ends': ['Support 0', 'Mid']}, {'type': 'rod', 'ends': ['Mid', 'End']},"
                "{'type': 'rod', 'ends': ['Support 0', 'End'], 'length': %.17g}",
                2.0 / 3, d, 1.0 / 6, 1 + wrong);
            for (gsize i = 0; i < physics_samples(run); i++) {
                double q[2], v[2];
                pendulum_exact(&p, physics_time(run, i), q, v);
                physics_assert_near("x", physics_value(run, i, 0), 1.5 * q[0], 10 * d + 5e-7);
                physics_assert_near("y", physics_value(run, i, 1), 1.5 * q[1], 10 * d + 5e-7);
            }
        }
}

/* Lengths that make no bar are refused, with what would be right. */
static void test_wrong_length(void)
{
    static const double lengths[] = {1.1, 1 + 3e-6, 1 - 3e-6};
    for (gsize k = 0; k < G_N_ELEMENTS(lengths); k++) {
        g_autoptr(PhysicsRun) run = physics_try(
            &(PhysicsOptions){.columns = "Mass 1.x"},
            "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [0.5, 0]}, {'type': 'mass', 'position': "
            "[1, "
            "0]},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 1'], 'length': %.17g}",
            lengths[k]);
        physics_assert_refused(run, TINKER_MODEL_ERROR_SCENE, "Rod 2", "its ends are 1 m apart", NULL);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/straight-bars/compound-pendulum", test_compound_pendulum);
    g_test_add_func("/physics/straight-bars/thrown", test_thrown);
    g_test_add_func("/physics/straight-bars/loaded-across", test_loaded_across);
    g_test_add_func("/physics/straight-bars/between-supports", test_between_supports);
    g_test_add_func("/physics/straight-bars/hinged", test_hinged);
    g_test_add_func("/physics/straight-bars/few-digits", test_few_digits);
    g_test_add_func("/physics/straight-bars/wrong-length", test_wrong_length);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
