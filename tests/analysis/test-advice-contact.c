/* Advice about what overlaps, meets and passes. */
#include <math.h>
#include <string.h>

#include "advice-checks.h"

/* The top lies at 0.2, the mass reaches down to -0.1. */
static void test_overlap(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support', 'name': 'Floor', 'position': [0, 0], 'width': 4, 'height': 0.4},"
                          "{'type': 'mass', 'position': [0, 0.3], 'height': 0.8}");
    advice_assert_only(f, TINKER_ADVICE_OVERLAP, FALSE, "Mass 0", "Floor", "Move it out by 0.3 m");
    advice_repair(f);
    physics_assert_near("y", start_fixture_get(f, "Mass 0", TINKER_MEANING_POSITION, 1), 0.6, 1e-15);
}

/* Of 40 boxes within a floor, all at one height, five are told of one by one and the other 35 at once; mended one after
 * another the last is told of in the end. */
static void test_many_overlaps(void)
{
    g_autoptr(GString) blocks =
        g_string_new("{'type': 'support', 'name': 'Floor', 'position': [0, 0], 'width': 100, 'height': 0.4}");
    for (int i = 0; i < 40; i++)
        g_string_append_printf(blocks, ",{'type': 'mass', 'position': [%d, 0.3], 'height': 0.8}", i - 20);
    g_autoptr(StartFixture) f = start_fixture_new(blocks->str);
    for (guint left = 40; left > 0; left--) {
        g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
        g_assert_cmpuint(all->len, ==, MIN(left, 6));
        for (guint i = 0; i < MIN(left, 5); i++)
            g_assert_nonnull(((const TinkerAdvice *)g_ptr_array_index(all, i))->repair);
        if (left > 5) {
            const TinkerAdvice *more = g_ptr_array_index(all, 5);
            g_autofree char *text = g_strdup_printf("and %u more start", left - 5);
            g_assert_true(g_str_has_prefix(more->message, text));
            g_assert_null(more->repair);
            g_assert_cmpuint(more->blocks->len, ==, left - 5);
        }
        g_assert_true(tinker_advice_repair(f->history, f->scene, g_ptr_array_index(all, 0), NULL));
    }
    g_autoptr(GPtrArray) none = tinker_advice_new(f->scene);
    g_assert_cmpuint(none->len, ==, 0);
}

/* The sides are 3.2 m apart and come nearer by 4 m/s, so they meet within the 10 s; there is nothing to repair. */
static void test_meeting(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'mass', 'position': [-3, 0], 'velocity': [3, 0]},"
                                                  "{'type': 'mass', 'position': [1, 0], 'velocity': [-1, 0]}");
    advice_assert_only(f, TINKER_ADVICE_MEETING, FALSE, "Mass 0", "Mass 0 and Mass 1 meet at 0.8 s", NULL);
}

/* A bar that nothing holds, over a floor or leaning at it, would pass it; not where it is solid, hangs, is beside the
 * floor, or nothing pulls it. */
static void test_passing(void)
{
    static const char floor[] = "{'type': 'support', 'name': 'Floor', 'position': [0, -0.5], 'height': 1, 'width': 4}",
                      pull[] = "{'type': 'gravity', 'name': 'G'}";
    static const struct {
        const char *bar, *more;
        gboolean passes;
    } cases[] = {{"'position': [1, 3]", pull, TRUE},
                 {"'position': [1, 3], 'solid': true", pull, FALSE},
                 {"'position': [2.5, 3]", pull, FALSE},
                 {"'position': [1, 3]", NULL, FALSE},
                 {"'position': [1, -3]", pull, FALSE},
                 {"'position': [1, 3]", "{'type': 'wind', 'drag': 1}", FALSE},
                 {"'position': [1, 3]", "{'type': 'gravity', 'acceleration': 0}", FALSE},
                 {"'position': [1, 3]", "{'type': 'gravity', 'angle': '90 deg'}", FALSE},
                 {"'position': [1, 3]", "{'type': 'gravity', 'angle': '-45 deg'}", FALSE},
                 {"'position': [-3, 3]", "{'type': 'gravity', 'angle': '-45 deg'}", TRUE},
                 {"'position': [0, 0.5], 'orientation': '90 deg', 'width': 0", NULL, TRUE},
                 {"'position': [1, 3]",
                  "{'type': 'gravity', 'name': 'G'}, {'type': 'support', 'name': 'Hook', 'position': [1, 5], "
                  "'orientation': '180 deg'}, {'type': 'spring', 'name': 'K', 'ends': ['Hook', 'Bar']}",
                  FALSE}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *blocks =
            g_strdup_printf("%s, {'type': 'bar', 'name': 'Bar', 'length': 1, %s}%s%s", floor, cases[i].bar,
                            cases[i].more != NULL ? ", " : "", cases[i].more != NULL ? cases[i].more : "");
        g_autoptr(StartFixture) f = start_fixture_new(blocks);
        g_test_message("case %d", (int)i);
        if (cases[i].passes) {
            advice_assert_only(f, TINKER_ADVICE_PASSING, FALSE, "Bar", "passes through Floor", "Make It Solid");
            advice_repair(f);
        } else {
            g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
            g_assert_cmpuint(all->len, ==, 0);
        }
    }
}

static void add_tests(void)
{
    g_test_add_func("/advice-contact/overlap", test_overlap);
    g_test_add_func("/advice-contact/many-overlaps", test_many_overlaps);
    g_test_add_func("/advice-contact/meeting", test_meeting);
    g_test_add_func("/advice-contact/passing", test_passing);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
