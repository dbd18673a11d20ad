/* Modes of what lies on supports, sticks to them or hangs on ropes, against closed forms. Masses are 1 m high, so that
 * they lie 0.5 m off a top at 0.1 m, the underside of which nobody sees. */
#include <math.h>

#include "modes-fixture.h"

static const double g = 9.81;

/* Smooth, of 0.2 m; its top is at -0.5. */
#define SMOOTH                                                                                                         \
    "{'type': 'support', 'name': 'Floor', 'position': [0, -0.6], 'width': 40, 'height': 0.2, 'static_friction': 0, "   \
    "'dynamic_friction': 0},"
#define ROUGH                                                                                                          \
    "{'type': 'support', 'name': 'Floor', 'position': [0, -0.6], 'width': 40, 'height': 0.2, 'static_friction': 0.5, " \
    "'dynamic_friction': 0.4},"
#define GRAVITY "{'type': 'gravity'},"
#define ANCHOR(x, y)                                                                                                   \
    "{'type': 'support', 'name': 'Anchor', 'position': [" x ", " y "], 'solid': false, 'width': 0.1, 'height': 0.1},"

/* Its modes have these frequencies (rad/s), in order. */
static void assert_modes(const ModesFixture *a, guint count, const double *truth, double bound)
{
    g_assert_cmpuint(a->analysis->modes->len, ==, count);
    for (guint i = 0; i < count; i++) {
        const TinkerMode *mode = g_ptr_array_index(a->analysis->modes, i);
        g_assert_cmpint(mode->kind, ==, truth[i] > 0 ? TINKER_MODE_OSCILLATION : TINKER_MODE_RIGID);
        if (fabs(mode->natural - truth[i]) <= bound * truth[i]) continue;
        g_test_message("mode %u: %.17g instead of %.17g", i, mode->natural, truth[i]);
        g_test_fail();
    }
}

static TinkerStillContact assumed(const ModesFixture *a, guint place)
{
    g_autoptr(GArray) list = tinker_still_contacts_list(a->analysis->contacts);
    g_assert_cmpuint(place, <, list->len);
    return g_array_index(list, TinkerStillContact, place);
}

/* A block of 1 kg on 100 N/m beside it: sqrt(k / m), and no other motion; on the floor, or let fall onto it. */
static void test_block_on_floor(void)
{
    static const double height[] = {0, 1.5, 0.3};
    for (gsize i = 0; i < G_N_ELEMENTS(height); i++) {
        g_autofree char *blocks = g_strdup_printf(
            GRAVITY SMOOTH ANCHOR("-3", "0") "{'type': 'mass', 'position': [0.2, %g], 'height': 1},"
                                             "{'type': 'spring', 'ends': ['Anchor', 'Mass 0'], 'stiffness': 100, "
                                             "'rest_length': 3}",
            height[i]);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        g_assert_true(a->analysis->about_rest);
        assert_modes(a, 1, (const double[]){10}, 1e-12);
        TinkerStillContact contact = assumed(a, 0);
        g_assert_cmpint(contact.kind, ==, TINKER_STILL_SLIDES);
        g_assert_false(contact.rough);
        physics_assert_near("force", contact.force, g, 1e-9);
        double origin[2];
        tinker_model_origin(a->analysis->model, origin);
        physics_assert_near("x", origin[0] + a->analysis->q[0], 0, 1e-12);
        physics_assert_near("y", origin[1] + a->analysis->q[1], 0, 1e-12);
    }
}

/* About the start, where the spring pulls it along: the floor is there as well. */
static void test_about_the_start(void)
{
    g_autoptr(ModesFixture) a = modes_fixture_new(
        FALSE, GRAVITY SMOOTH ANCHOR("-3", "0") "{'type': 'mass', 'position': [0.5, 0], 'height': 1},"
                                                "{'type': 'spring', 'ends': ['Anchor', 'Mass 0'], 'stiffness': 100, "
                                                "'rest_length': 3}");
    g_assert_false(a->analysis->about_rest);
    assert_modes(a, 1, (const double[]){10}, 1e-12);
    physics_assert_near("unbalanced", a->analysis->linear->force[0], -50, 1e-12);
    physics_assert_near("carried", a->analysis->linear->force[1], 0, 1e-12);
}

/* A spring of 400 N/m at 60 degrees along the slope of a smooth wedge: sqrt(k / m) whatever the angle. */
static void test_slope(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        GRAVITY "{'type': 'support', 'name': 'Wedge', 'orientation': '60 deg', 'width': 20, 'height': 0.2, "
                "'static_friction': 0, 'dynamic_friction': 0},"
                "{'type': 'mass', 'mass': 4, 'height': 0.8, 'position': [-0.4330127018922193, 0.25]},"
                "{'type': 'support', 'name': 'Anchor', 'solid': false, 'position': "
                "[0.5669872981077807, 1.9820508075688772]},"
                "{'type': 'spring', 'ends': ['Anchor', 'Mass 0'], 'stiffness': 400, 'rest_length': 2}");
    assert_modes(a, 1, (const double[]){10}, 1e-10);
    /* it hangs m g sin 60 / k below, and presses with m g cos 60 */
    physics_assert_near("force", assumed(a, 0).force, 4 * g / 2, 1e-9);
    double down = 4 * g * sqrt(0.75) / 400, origin[2];
    tinker_model_origin(a->analysis->model, origin);
    physics_assert_near("x", origin[0] + a->analysis->q[0], -0.4330127018922193 - down / 2, 1e-9);
    physics_assert_near("y", origin[1] + a->analysis->q[1], 0.25 - down * sqrt(0.75), 1e-9);
}

/* A trolley of 10 kg that rolls along a beam, with 5 kg on a rod of 2 m: it rolls away, and swings with
 * sqrt(g / L (1 + m / M)). */
static void test_crane(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest(GRAVITY SMOOTH "{'type': 'mass', 'mass': 10, 'height': 1},"
                                        "{'type': 'mass', 'mass': 5, 'position': [0.5, -1.9364916731037085]},"
                                        "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1'], 'length': 2}");
    assert_modes(a, 2, (const double[]){0, sqrt(g / 2 * 1.5)}, 1e-9);
    physics_assert_near("force", assumed(a, 0).force, 15 * g, 1e-8);
}

/* What slides at the start, or is pulled so that it does, swings with sqrt(k / m); what friction holds stays. */
static void test_rough_floor(void)
{
    static const struct {
        double x, speed;
        guint modes;
        TinkerStillContactKind kind;
    } rows[] = {{1, 0, 1, TINKER_STILL_SLIDES},
                {0, 2, 1, TINKER_STILL_SLIDES},
                {0.11, 0, 0, TINKER_STILL_STICKS},
                {0.13, 0, 1, TINKER_STILL_SLIDES}}; /* mu m g = 4.905 N is 0.122625 m of the spring */
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *blocks = g_strdup_printf(
            GRAVITY ROUGH ANCHOR("-3", "0") "{'type': 'mass', 'position': [%g, 0], 'velocity': [%g, 0], "
                                            "'height': 1}, {'type': 'spring', 'ends': ['Anchor', 'Mass 0'], "
                                            "'stiffness': 40, 'rest_length': 3}",
            rows[i].x, rows[i].speed);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        g_assert_true(a->analysis->about_rest);
        assert_modes(a, rows[i].modes, (const double[]){sqrt(40)}, 1e-12);
        g_assert_cmpint(assumed(a, 0).kind, ==, rows[i].kind);
        g_assert_cmpint(assumed(a, 0).rough, ==, rows[i].kind == TINKER_STILL_SLIDES);
    }
}

/* On a slope below the angle of friction one block sticks, and another swings on it by a spring; above, both slide
 * away. */
static void test_rough_slope(void)
{
    for (int steep = 0; steep <= 1; steep++) {
        double angle = steep ? 0.8 : 0.3, along[2] = {cos(angle), sin(angle)}; /* atan 0.5 = 0.464 */
        g_autofree char *blocks = g_strdup_printf(
            GRAVITY "{'type': 'support', 'name': 'Slope', 'orientation': '%.17g rad', 'width': 20, 'height': 0.2, "
                    "'static_friction': 0.5, 'dynamic_friction': 0.4},"
                    "{'type': 'mass', 'mass': 2, 'height': 0.2, 'position': [%.17g, %.17g]},"
                    "{'type': 'mass', 'mass': 0.25, 'height': 0.2, 'position': [%.17g, %.17g]},"
                    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 25, 'rest_length': 1}",
            angle, -0.2 * along[1], 0.2 * along[0], -0.2 * along[1], 0.2 * along[0] - 1.2);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        if (steep) {
            g_assert_false(a->analysis->about_rest);
            continue;
        }
        /* hung below the slope, on whose solid side it does not lie: it swings up and down and as a pendulum of 1.0981
         * m */
        assert_modes(a, 2, (const double[]){sqrt(g / (1 + 0.25 * g / 25)), 10}, 1e-9);
        g_assert_cmpint(assumed(a, 0).kind, ==, TINKER_STILL_STICKS);
        physics_assert_near("force", assumed(a, 0).force, 2.25 * g * cos(angle), 1e-8);
    }
}

/* A spring above that pulls with more than the weight lifts the block off: the floor is not there, as about the start,
 * where it still is. */
static void test_lifted(void)
{
    static const char blocks[] =
        GRAVITY SMOOTH ANCHOR("0", "2") "{'type': 'mass', 'height': 1},"
                                        "{'type': 'spring', 'ends': ['Anchor', 'Mass 0'], 'stiffness': 100, "
                                        "'rest_length': 1}";
    /* at rest 1.0981 m long with the weight: sqrt(g / L) */
    g_autoptr(ModesFixture) a = modes_about_rest(blocks);
    assert_modes(a, 2, (const double[]){sqrt(g / 1.0981), 10}, 1e-9);
    g_autoptr(GArray) list = tinker_still_contacts_list(a->analysis->contacts);
    g_assert_cmpuint(list->len, ==, 0);
}

/* A rope from which a mass hangs is a rod; one that is longer than the way is nothing. */
static void test_ropes(void)
{
    static const double from[][2] = {{0, -2}, {1.2, -1.6}, {0.3, -0.5}};
    for (gsize i = 0; i < G_N_ELEMENTS(from); i++) {
        g_autofree char *blocks = g_strdup_printf(
            GRAVITY "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 3, 'position': [%g, %g]},"
                    "{'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 2},"
                    "{'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 2.5}",
            from[i][0], from[i][1]);
        g_autoptr(ModesFixture) a = modes_about_rest(blocks);
        g_assert_true(a->analysis->about_rest);
        assert_modes(a, 1, (const double[]){sqrt(g / 2)}, 1e-9);
        g_assert_cmpint(assumed(a, 0).kind, ==, TINKER_STILL_TAUT);
        physics_assert_near("force", assumed(a, 0).force, 3 * g, 1e-8);
        g_assert_cmpint(assumed(a, 1).kind, ==, TINKER_STILL_SLACK);
    }
}

/* Two like loads on a rope over two wheels, one 0.1 m below its wheel and one 10 m: each swings as a pendulum on its
 * own part, however long the rope is, and nothing brings them back that goes up as the other goes down. */
static void test_rope_with_short_part(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        GRAVITY "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [5, 0]},"
                "{'type': 'mass', 'position': [0, -0.1]}, {'type': 'mass', 'position': [5, -10]},"
                "{'type': 'rope', 'ends': ['Mass 0', 'Support 0', 'Support 1', 'Mass 1']}");
    g_assert_true(a->analysis->about_rest);
    assert_modes(a, 3, (const double[]){0, sqrt(g / 10), sqrt(g / 0.1)}, 1e-9);
}

/* Two blocks of 1 kg and 3 kg on one floor with a spring of 12 N/m between them: both drift, and swing with
 * sqrt(k (1 / m + 1 / M)). */
static void test_two_blocks(void)
{
    g_autoptr(ModesFixture) a =
        modes_about_rest(GRAVITY SMOOTH "{'type': 'mass', 'height': 1}, {'type': 'mass', 'mass': 3, 'height': 1, "
                                        "'position': [2, 0]},"
                                        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 12, "
                                        "'rest_length': 1.5}");
    assert_modes(a, 2, (const double[]){0, 4}, 1e-9);
}

/* Between two tops that are just its height apart, without weight: it moves along them alone. */
static void test_between_two_tops(void)
{
    g_autoptr(ModesFixture) a = modes_about_rest(
        SMOOTH "{'type': 'support', 'name': 'Ceiling', 'position': [0, 0.6], 'width': 40, 'height': 0.2, "
               "'orientation': '180 deg', 'static_friction': 0, 'dynamic_friction': 0}," ANCHOR(
                   "-3", "0") "{'type': 'mass', 'position': [0.2, 0], 'height': 1},"
                              "{'type': 'spring', 'ends': ['Anchor', 'Mass 0'], 'stiffness': 100, 'rest_length': 3}");
    assert_modes(a, 1, (const double[]){10}, 1e-12);
}

/* A table that moves up and down carries a block, on which another stands on a spring: the transmissibility 1 / (1 -
 * r^2). */
static void test_carried(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(ModesFixture) a = modes_about_rest(
        GRAVITY SMOOTH
        "{'type': 'support-motion', 'name': 'Motion', 'ends': ['Floor'], 'angle': '90 deg', 'amplitude': 0.01, "
        "'frequency': 1}, {'type': 'mass', 'mass': 5, 'height': 1},"
        "{'type': 'mass', 'mass': 1, 'position': [0, 1.5]},"
        "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 100, 'rest_length': 1}");
    const TinkerModeAnalysis *modes = a->analysis;
    TinkerLinearInput input;
    TinkerLinearOutput output;
    g_autoptr(GArray) columns = tinker_columns_new();
    g_assert_true(tinker_columns_add(columns, a->scene, "Mass 1.y", &error));
    g_assert_true(tinker_linear_input_find(modes->model, "Motion", &input, &error));
    g_assert_true(tinker_linear_output_find(modes->model, modes->q, &g_array_index(columns, TinkerColumn, 0), &input,
                                            &output, &error));
    TinkerFrequencyResponse *response =
        tinker_frequency_response_new(modes->linear, modes->basis, &input, &output, &error);
    g_assert_no_error(error);
    static const double ratios[] = {0.3, 0.9, 1.5, 7};
    for (gsize i = 0; i < G_N_ELEMENTS(ratios); i++) {
        double complex value = tinker_frequency_response_at(response, 10 * ratios[i]);
        physics_assert_near("transmissibility", creal(value) * (1 - ratios[i] * ratios[i]), 1, 1e-9);
        physics_assert_near("in step", cimag(value), 0, 1e-12);
    }
    tinker_frequency_response_free(response);
    tinker_linear_input_clear(&input);
    tinker_linear_output_clear(&output);
}

static void add_tests(void)
{
    g_test_add_func("/analysis/modes-contacts/block-on-floor", test_block_on_floor);
    g_test_add_func("/analysis/modes-contacts/about-the-start", test_about_the_start);
    g_test_add_func("/analysis/modes-contacts/slope", test_slope);
    g_test_add_func("/analysis/modes-contacts/crane", test_crane);
    g_test_add_func("/analysis/modes-contacts/rough-floor", test_rough_floor);
    g_test_add_func("/analysis/modes-contacts/rough-slope", test_rough_slope);
    g_test_add_func("/analysis/modes-contacts/lifted", test_lifted);
    g_test_add_func("/analysis/modes-contacts/ropes", test_ropes);
    g_test_add_func("/analysis/modes-contacts/rope-with-short-part", test_rope_with_short_part);
    g_test_add_func("/analysis/modes-contacts/two-blocks", test_two_blocks);
    g_test_add_func("/analysis/modes-contacts/between-two-tops", test_between_two_tops);
    g_test_add_func("/analysis/modes-contacts/carried", test_carried);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
