/* A run that sees bodies pass through each other says so once, with the time of the sample: against all pairs of boxes
 * that fly straight on. */
#include "physics-fixture.h"

#include <math.h>
#include <string.h>

/* The warnings of that kind: how many, and the last of them. */
static guint told(const PhysicsRun *run, const TinkerWarning **said)
{
    guint count = 0;
    for (guint i = 0; i < run->summary->warnings->len; i++) {
        const TinkerWarning *warning = g_ptr_array_index(run->summary->warnings, i);
        if (strstr(warning->text, "pass through each other") == NULL) continue;
        count++;
        *said = warning;
    }
    return count;
}

/* The sides are 3.2 m apart and come nearer by 4 m/s: they have met by the first sample behind 0.8 s. */
static void test_two(void)
{
    static const struct {
        double interval;
        const char *time;
    } rows[] = {{0.25, "at 1 s"}, {0.3, "at 0.9 s"}, {0.05, "at 0.85 s"}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 3, .interval = rows[i].interval},
                        "{'type': 'mass', 'name': 'A', 'position': [-3, 0.2], 'velocity': [3, 0]},"
                        "{'type': 'mass', 'name': 'B', 'position': [1, 0.2], 'velocity': [-1, 0]}");
        const TinkerWarning *said = NULL;
        g_assert_cmpuint(told(run, &said), ==, 1);
        g_assert_nonnull(strstr(said->text, "A and B overlap"));
        g_assert_nonnull(strstr(said->text, rows[i].time));
        g_assert_cmpint(said->kind, ==, TINKER_WARNING_SCENE);
    }
}

/* Nothing is told of what passes by, of points without an extent, and of what only touches. */
static void test_nothing(void)
{
    static const char *const rows[] = {
        "{'type': 'mass', 'position': [-3, 1], 'velocity': [3, 0]}, {'type': 'mass', 'position': [1, 0]}",
        "{'type': 'mass', 'position': [-3, 0], 'velocity': [3, 0], 'width': 0}, {'type': 'mass', 'position': [1, 0]}",
        "{'type': 'mass', 'position': [0, 0]}, {'type': 'mass', 'position': [0.8, 0]}",
        "{'type': 'mass', 'velocity': [1, 2]}",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 4}, "%s", rows[i]);
        const TinkerWarning *said = NULL;
        g_assert_cmpuint(told(run, &said), ==, 0);
    }
}

enum { BODIES = 40 };

typedef struct {
    double x, y, vx, vy, width, height;
} Flight;

/* Both sides overlap by more than touching. */
static gboolean overlap_at(const Flight *a, const Flight *b, double t)
{
    const double dx = b->x - a->x + (b->vx - a->vx) * t, dy = b->y - a->y + (b->vy - a->vy) * t;
    return fabs(dx) < 0.5 * (a->width + b->width) - 1e-9 && fabs(dy) < 0.5 * (a->height + b->height) - 1e-9;
}

/* "B3 and B17 overlap at 0.4 s" of the first sample at which some do, and there of the least pair. */
static char *expected(const Flight *flights, double interval, double duration)
{
    for (int sample = 0; sample * interval <= duration * (1 + 1e-12); sample++)
        for (int i = 0; i < BODIES; i++)
            for (int k = i + 1; k < BODIES; k++)
                if (overlap_at(&flights[i], &flights[k], sample * interval))
                    return g_strdup_printf("B%d and B%d overlap at %.6g s: ", i, k, sample * interval);
    return NULL;
}

/* Spread wide in x, wide in y, and square, so that the boxes are sorted along either axis and change their order. */
static void test_many(void)
{
    static const double spread[][2] = {{60, 4}, {4, 60}, {20, 20}};
    int seen = 0, none = 0;
    for (int round = 0; round < 60; round++) {
        Flight flights[BODIES];
        g_autoptr(GString) blocks = g_string_new(NULL);
        for (int i = 0; i < BODIES; i++) {
            const double *size = spread[round % 3];
            const double scale = round < 30 ? 1 : 0.1;
            flights[i] = (Flight){g_test_rand_double_range(-size[0], size[0]),
                                  g_test_rand_double_range(-size[1], size[1]),
                                  g_test_rand_double_range(-4, 4),
                                  g_test_rand_double_range(-4, 4),
                                  scale * g_test_rand_double_range(0.1, 1),
                                  scale * g_test_rand_double_range(0.1, 1)};
            const Flight *at = &flights[i];
            g_string_append_printf(blocks,
                                   "%s{'type': 'mass', 'name': 'B%d', 'position': [%.17g, %.17g], 'velocity': [%.17g, "
                                   "%.17g], 'width': %.17g, 'height': %.17g}",
                                   i > 0 ? ", " : "", i, at->x, at->y, at->vx, at->vy, at->width, at->height);
        }
        const double duration = 2, interval = 0.1;
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = duration, .interval = interval}, "%s", blocks->str);
        g_autofree char *truth = expected(flights, interval, duration);
        const TinkerWarning *said = NULL;
        g_assert_cmpuint(told(run, &said), ==, truth != NULL);
        if (truth != NULL) {
            g_assert_true(g_str_has_prefix(said->text, truth));
            seen++;
        } else {
            none++;
        }
    }
    g_assert_cmpint(seen, >, 10);
    g_assert_cmpint(none, >, 2);
}

/* A box that lands on an incline is turned along it, and is looked at so: on a slope of 45 degrees two boxes of side 1
 * whose centres are 1.2 m apart along it do not overlap, but they would upright, where their centres are 0.85 m apart
 * both ways. */
static void test_turned(void)
{
    static const char *const blocks =
        "{'type': 'gravity'}, {'type': 'support', 'name': 'Slope', 'orientation': '45 deg', 'width': 20, "
        "'static_friction': 2, 'dynamic_friction': 2},"
        "{'type': 'mass', 'name': 'A', 'width': 1, 'height': 1, 'on': 'Slope', 'along': -0.6},"
        "{'type': 'mass', 'name': 'B', 'width': 1, 'height': 1, 'on': 'Slope', 'along': 0.6}";
    const TinkerWarning *said = NULL;
    g_autoptr(PhysicsRun) lie = physics_run(&(PhysicsOptions){.duration = 1}, "%s", blocks);
    g_assert_cmpuint(told(lie, &said), ==, 0);
    g_autoptr(PhysicsRun) upright = physics_run(&(PhysicsOptions){.duration = 1},
                                                "{'type': 'mass', 'name': 'A', 'width': 1, 'height': 1},"
                                                "{'type': 'mass', 'name': 'B', 'width': 1, 'height': 1, 'position': "
                                                "[0.85, 0.85]}");
    g_assert_cmpuint(told(upright, &said), ==, 1);
}

static void add_tests(void)
{
    g_test_add_func("/box-watch/two", test_two);
    g_test_add_func("/box-watch/nothing", test_nothing);
    g_test_add_func("/box-watch/many", test_many);
    g_test_add_func("/box-watch/turned", test_turned);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
