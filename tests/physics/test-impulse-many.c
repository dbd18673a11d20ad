/* Contact as impulses: many bodies, fast ones, and what a step may not do: allot memory, or know who looks at it. */
#include "allotments.h"
#include "contact-checks.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"

#include <math.h>

/* 100 masses of some height over ten slopes; `held`: some hang together by springs or rods. */
static char *heap(gboolean held)
{
    GString *blocks = g_string_new("{'type': 'gravity'}");
    for (int k = 0; k < 10; k++) {
        g_autofree char *plate = contact_plate(10 * k, -(k % 3), 0.1 * (k % 5 - 2), 9.5,
                                               "'static_friction': 0.3, 'dynamic_friction': 0.2, 'restitution': 0.3");
        g_string_append_printf(blocks, ", %s", plate);
    }
    g_string_append(blocks, ", {'type': 'support', 'position': [45, -20.2], 'width': 400}");
    for (int i = 0; i < 100; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'mass', 'mass': %g, 'width': 0.2, 'height': 0.2, 'position': [%g, %g], "
                               "'velocity': [%g, %g]}",
                               1 + i % 7 * 0.3, i * 0.97 - 3, 4 + (i * 37 % 11) * 0.3, sin(i), cos(3 * i));
    for (int i = 0; held && i + 1 < 100; i += 5)
        g_string_append_printf(blocks, ", {'type': '%s', 'ends': ['Mass %d', 'Mass %d']}",
                               i % 10 == 0 ? "spring" : "rod", i, i + 1);
    return g_string_free(blocks, FALSE);
}

/* Whoever is over a slope when he comes there is never below it. */
static void test_falling_masses(void)
{
    g_autofree char *blocks = heap(FALSE);
    g_autoptr(GString) columns = g_string_new("Mass 0.x, Mass 0.y");
    for (int i = 1; i < 100; i++)
        g_string_append_printf(columns, ", Mass %d.x, Mass %d.y", i, i);
    PhysicsOptions options = {
        .impulses = TRUE, .step = 0.01, .duration = 12, .interval = 0.013, .columns = columns->str};
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
    int landed = 0, lowest = 0;
    for (int i = 0; i < 100; i++) {
        gboolean over[10] = {FALSE};
        for (gsize k = 0; k < physics_samples(run); k++) {
            double x = physics_value(run, k, 2 * (gsize)i), y = physics_value(run, k, 2 * (gsize)i + 1);
            g_assert_cmpfloat(y, >=, -20 + 0.1 - 1e-12);
            for (int p = 0; p < 10; p++) {
                double angle = 0.1 * (p % 5 - 2), dx = x - 10 * p, dy = y + p % 3;
                double gap = cos(angle) * dy - sin(angle) * dx - 0.1, along = cos(angle) * dx + sin(angle) * dy;
                if (over[p] && fabs(along) <= 4.75) g_assert_cmpfloat(gap, >=, -1e-13);
                over[p] = fabs(along) <= 4.75 && gap >= -1e-13;
                if (k + 1 == physics_samples(run)) landed += over[p] && gap < 1e-13;
            }
        }
        lowest += physics_last(run, 2 * (gsize)i + 1) < -19;
    }
    g_assert_cmpint(landed, >, 40);
    g_assert_cmpint(landed + lowest, >, 95);
}

/* --- fast ones --- */

static void test_fast_bodies(void)
{
    static const double speeds[] = {1e3, 1e6};
    for (gsize s = 0; s < 2; s++)
        for (int i = 0; i < 40; i++) {
            double v = speeds[s], y = v * (0.003 + 0.0371 * i), shift = 0.01 * (i % 7);
            PhysicsOptions options = {.impulses = TRUE, .step = 0.1, .duration = 4};
            g_autoptr(PhysicsRun) run =
                physics_run(&options,
                            CONTACT_FLOOR ", 'width': 3}, {'type': 'support', 'position': [0, -5]}, " CONTACT_POINT
                                          ", 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g]}",
                            shift + y, y, -v, -v);
            double state[4];
            physics_state(run, "Mass 0", state);
            /* it stops across, and what friction takes along is the friction impulse at most: it sticks or slides on */
            physics_assert_near("y", state[1], 0, 1e-9);
            physics_assert_near("vy", state[3], 0, 0);
        }
}

/* One beside the end passes, one within it does not. */
static void test_fast_bodies_at_the_end(void)
{
    for (int side = 0; side < 2; side++) {
        double v = 1e6, y = 123456.7, x = side == 0 ? 0.999 : 1.001;
        PhysicsOptions options = {.impulses = TRUE, .step = 0.1, .duration = 1};
        g_autoptr(PhysicsRun) run = physics_run(&options,
                                                CONTACT_FLOOR ", 'width': 2}, " CONTACT_POINT
                                                              ", 'position': [%.17g, %.17g], 'velocity': [0, %.17g]}",
                                                x, y, -v);
        double state[4];
        physics_state(run, "Mass 0", state);
        physics_assert_near("y", state[1], side == 0 ? 0 : y - v, 1e-6);
    }
}

/* Between two walls, with a bounce: many meetings in one step. */
static void test_bounces_within_a_step(void)
{
    g_autofree char *left = contact_plate(-1, 0, -G_PI / 2, 10, CONTACT_SMOOTH ", 'restitution': 1");
    g_autofree char *right = contact_plate(1, 0, G_PI / 2, 10, CONTACT_SMOOTH ", 'restitution': 1");
    PhysicsOptions options = {.impulses = TRUE, .step = 0.1, .duration = 1};
    g_autoptr(PhysicsRun) run =
        physics_run(&options, "%s, %s, " CONTACT_POINT ", 'velocity': [76.5, 0.5]}", left, right);
    /* 76.5 m between -1 and 1: 1 m to the right, 37 times 2 m, and from the left 1.5 m */
    contact_assert_state(run, "Mass 0", (double[]){0.5, 0.5, 76.5, 0.5}, 1e-9);
}

/* --- what a step may not do --- */

static void test_same_bits(void)
{
    for (int held = 0; held < 2; held++) {
        g_autofree char *blocks = heap(held);
        PhysicsOptions options = {.impulses = TRUE, .step = 0.01, .duration = 3, .interval = 3};
        g_autoptr(PhysicsRun) seldom = physics_run(&options, "%s", blocks);
        options.interval = 0.0037;
        options.columns = "Mass 3.normal force, Mass 5.y, Support 2.contact force";
        g_autoptr(PhysicsRun) often = physics_run(&options, "%s", blocks);
        physics_assert_same_bits(seldom, often);
    }
}

static void test_allotments(void)
{
    for (int held = 0; held < 2; held++) {
        g_autofree char *blocks = heap(held);
        g_autoptr(PhysicsRun) run = physics_prepare(
            &(PhysicsOptions){.impulses = TRUE, .step = 0.01, .duration = 1e3, .interval = 1}, "%s", blocks);
        gboolean stepped = TRUE;
        /* while masses fall, lists of neighbours may grow */
        for (int step = 0; step < 1000 && stepped; step++)
            stepped = tinker_simulation_step(run->simulation, &run->error);
        int before = allotments;
        g_assert_cmpint(before, >, 0);
        for (int step = 0; step < 1000 && stepped; step++)
            stepped = tinker_simulation_step(run->simulation, &run->error);
        int after = allotments;
        g_assert_no_error(run->error);
        g_assert_cmpint(after, ==, before);
    }
}

/* One model after another way of taking contact: as if nothing had been. */
static void run_again(PhysicsRun *run, const TinkerRunOptions *how)
{
    g_clear_pointer(&run->simulation, tinker_simulation_free);
    run->simulation = tinker_simulation_new(run->model, how, &run->error);
    g_assert_no_error(run->error);
    g_assert_true(tinker_simulation_run(run->simulation, NULL, NULL, NULL, &run->error));
    run->summary = tinker_simulation_summary(run->simulation);
}

static void test_by_turns(void)
{
    g_autofree char *blocks = heap(TRUE);
    PhysicsOptions events = {.method = "rk4", .step = 0.01, .duration = 2, .columns = "Mass 3.normal force"};
    PhysicsOptions impulses = {.impulses = TRUE, .step = 0.01, .duration = 2, .columns = "Mass 3.normal force"};
    TinkerRunOptions how = {.duration = 2, .interval = 0.2, .method = "rk4", .step = 0.01, .spectral_radius = 0.8};
    g_autoptr(PhysicsRun) first = physics_run(&events, "%s", blocks);
    g_autoptr(PhysicsRun) second = physics_run(&impulses, "%s", blocks);
    g_autoptr(PhysicsRun) turned = physics_run(&events, "%s", blocks);
    for (int turn = 0; turn < 2; turn++) {
        how.impulses = turn == 0;
        run_again(turned, &how);
        const PhysicsRun *as = turn == 0 ? second : first;
        physics_assert_same_bits(turned, as);
        for (int book = 0; book < TINKER_BOOK_COUNT; book++)
            physics_assert_near("a book", turned->summary->books[book], as->summary->books[book], 0);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/impulse-many/falling-masses", test_falling_masses);
    g_test_add_func("/physics/impulse-many/fast-bodies", test_fast_bodies);
    g_test_add_func("/physics/impulse-many/fast-bodies-at-the-end", test_fast_bodies_at_the_end);
    g_test_add_func("/physics/impulse-many/bounces-within-a-step", test_bounces_within_a_step);
    g_test_add_func("/physics/impulse-many/same-bits", test_same_bits);
    g_test_add_func("/physics/impulse-many/allotments", test_allotments);
    g_test_add_func("/physics/impulse-many/by-turns", test_by_turns);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
