/* Piles that friction wedges, with contact as impulses: every step of them is solved for, and none gains energy. */
#include <math.h>
#include <string.h>

#include "contact-checks.h"

#define BODIES 12

/* Between two walls that stand or lean, boxes, discs and bars of chance, one above another, rough and some heavy; some
 * on rods. (transfer full) */
static char *funnel(guint32 seed, gboolean tied)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(seed);
    const double friction = 0.3 + 0.4 * g_rand_int_range(random, 0, 4), lean = seed % 2 ? 0 : 0.3;
    g_autofree char *surface = g_strdup_printf("'static_friction': %g, 'dynamic_friction': %g, 'restitution': %g",
                                               friction, 0.8 * friction, seed % 3 ? 0 : 0.3);
    g_autofree char *floor = contact_plate(0, 0, 0, 20, surface);
    g_autofree char *left = contact_plate(-0.6 - 2 * sin(lean), 2, -G_PI / 2 + lean, 12, surface);
    g_autofree char *right = contact_plate(0.6 + 2 * sin(lean), 2, G_PI / 2 - lean, 12, surface);
    GString *blocks = g_string_new(CONTACT_WEIGHT);
    g_string_append_printf(blocks, "%s, %s, %s", floor, left, right);
    for (int i = 0; i < BODIES; i++) {
        static const char *const kinds[] = {"'box', 'width': 0.5, 'height': 0.4", "'disc', 'radius': 0.22",
                                            "'bar', 'length': 0.7, 'width': 0.08, 'solid': true"};
        const char *kind = kinds[g_rand_int_range(random, 0, 3)];
        const double x = g_rand_double_range(random, -0.2, 0.2), angle = g_rand_double_range(random, -0.6, 0.6);
        g_string_append_printf(blocks,
                               ", {'type': %s, 'name': 'Body %d', 'mass': %d, 'position': [%.17g, %.17g], "
                               "'orientation': %.17g, 'static_friction': %g, 'dynamic_friction': %g}",
                               kind, i, g_rand_int_range(random, 0, 4) ? 1 : 10, x, 0.6 + 0.75 * i, angle, friction,
                               0.8 * friction);
        if (tied && i % 3 > 0)
            g_string_append_printf(
                blocks, ", {'type': 'rod', 'ends': ['Body %d', {'block': 'Body %d', 'at': [0.1, 0]}]}", i - 1, i);
    }
    return g_string_free(blocks, FALSE);
}

static void check_all_solved(gboolean tied)
{
    for (guint32 seed = 0; seed < 12; seed++) {
        const double h = seed % 4 < 2 ? 1.0 / 60 : 1.0 / 200;
        g_autofree char *blocks = funnel(seed, tied);
        const PhysicsOptions options = {.duration = 2, .step = h, .impulses = TRUE};
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
        const TinkerSummary *summary = run->summary;
        for (guint i = 0; i < summary->warnings->len; i++)
            g_assert_null(strstr(tinker_warnings_text(summary->warnings, i), "before the impulses"));
        const double end = summary->kinetic_end + summary->potential_end;
        g_assert_cmpfloat(end, <, summary->kinetic_start + summary->potential_start);
        g_assert_cmpfloat(summary->books[TINKER_BOOK_CONTACTS], <, 0);
        /* to first order: some 5 m/s, and as many metres of height */
        g_assert_cmpfloat(summary->energy_balance_error, <, 4 * h);
    }
}

static void test_alone(void)
{
    check_all_solved(FALSE);
}

static void test_tied(void)
{
    check_all_solved(TRUE);
}

static void add_tests(void)
{
    g_test_add_func("/physics/pile-wedged/alone", test_alone);
    g_test_add_func("/physics/pile-wedged/tied", test_tied);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
