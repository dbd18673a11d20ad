/* Start conditions against what statics and trigonometry say; undo against the text of the scene. */
#include <math.h>
#include <string.h>

#include "analysis/start-conditions.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "scene/frame/overlaps.h"
#include "start-fixture.h"

#define G "{'type': 'gravity', 'acceleration': 9.81},"

/* The option of a kind for a block, about `other` (NULL: any); NULL where it is not offered. Borrowed from `options`.
 */
static const TinkerStartOption *find(const StartFixture *f, const GPtrArray *options, TinkerStartKind kind,
                                     const char *other)
{
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        if (option->kind == kind && (other == NULL || option->other == start_fixture_block(f, other))) return option;
    }
    return NULL;
}

static gboolean is_offered(const StartFixture *f, const char *block, TinkerStartKind kind, const char *other)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    return find(f, options, kind, other) != NULL;
}

/* What the entry would show. */
static double value_of(const StartFixture *f, const char *block, TinkerStartKind kind, const char *other)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    const TinkerStartOption *option = find(f, options, kind, other);
    g_assert_nonnull(option);
    g_assert_true(option->asks);
    return option->value;
}

static gboolean try_apply(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value,
                          GError **error)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    const TinkerStartOption *option = find(f, options, kind, other);
    g_assert_nonnull(option);
    return tinker_start_apply(f->history, f->scene, option, value, error);
}

/* Applies it; it must succeed, be one step, and where it asks for a value show that value from then on. */
static void apply(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value)
{
    g_autoptr(GError) error = NULL;
    g_assert_true(try_apply(f, block, kind, other, value, &error));
    g_assert_no_error(error);
    start_fixture_assert_one_step(f);
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    const TinkerStartOption *option = find(f, options, kind, other);
    if (option != NULL && option->asks) physics_assert_near(option->label, option->value, value, 1e-12);
}

static void assert_refused(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value,
                           const char *part)
{
    g_autoptr(GError) error = NULL;
    g_assert_false(try_apply(f, block, kind, other, value, &error));
    g_assert_nonnull(error);
    g_test_message("%s", error->message);
    g_assert_nonnull(strstr(error->message, part));
    start_fixture_assert_untouched(f);
}

static void assert_vector(const StartFixture *f, const char *block, int32_t meaning, double x, double y)
{
    physics_assert_near(block, start_fixture_get(f, block, meaning, 0), x, 1e-10);
    physics_assert_near(block, start_fixture_get(f, block, meaning, 1), y, 1e-10);
}

static void assert_at(const StartFixture *f, const char *block, double x, double y)
{
    assert_vector(f, block, TINKER_MEANING_POSITION, x, y);
}

static void assert_moves(const StartFixture *f, const char *block, double x, double y)
{
    assert_vector(f, block, TINKER_MEANING_VELOCITY, x, y);
}

#define HANGING                                                                                                        \
    G "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'mass': 2, 'position': [0.3, -1.2], "                 \
      "'velocity': [1, 2]}, {'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 80"

/* It hangs m g / k below its rest length. */
static void test_equilibrium(void)
{
    const double sag = 2 * 9.81 / 80;
    g_autoptr(StartFixture) f = start_fixture_new(HANGING ", 'rest_length': 1}");
    apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    assert_at(f, "Mass 0", 0, -1 - sag);
    assert_moves(f, "Mass 0", 0, 0);
    for (double d = -0.25; d < 0.5; d += 0.5) {
        g_autoptr(StartFixture) g = start_fixture_new(HANGING ", 'rest_length': 1}");
        apply(g, "Mass 0", TINKER_START_FROM_EQUILIBRIUM, NULL, d);
        assert_at(g, "Mass 0", 0, -1 - sag - d);
        assert_moves(g, "Mass 0", 0, 0);
    }
}

/* A rest length that is left to the drawing is what it was drawn with, and stays that; else the spring would hang
 * unstretched with the mass at its start. */
static void test_rest_length_stays(void)
{
    const double drawn = hypot(0.3, 1.2);
    g_autoptr(StartFixture) f = start_fixture_new(HANGING "}");
    apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    physics_assert_near("rest length", start_fixture_get(f, "Spring 0", TINKER_MEANING_LENGTH, 0), drawn, 1e-15);
    assert_at(f, "Mass 0", 0, -drawn - 2 * 9.81 / 80);
    g_autoptr(StartFixture) g = start_fixture_new(HANGING "}");
    physics_assert_near("stretch", value_of(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0"), 0, 1e-15);
    apply(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0", 0.2);
    physics_assert_near("rest length", start_fixture_get(g, "Spring 0", TINKER_MEANING_LENGTH, 0), drawn, 1e-15);
    assert_at(g, "Mass 0", 0.3 * (1 + 0.2 / drawn), -1.2 * (1 + 0.2 / drawn));
    assert_moves(g, "Mass 0", 1, 2);
    /* one that only takes another velocity is left to the drawing as it was */
    g_autoptr(StartFixture) h = start_fixture_new(HANGING "}");
    apply(h, "Mass 0", TINKER_START_AT_REST, NULL, 0);
    g_assert_true(isnan(start_fixture_get(h, "Spring 0", TINKER_MEANING_LENGTH, 0)));
}

/* Two masses of 2 and 3 kg below each other: the upper spring carries both. Both move, though one was asked about. */
static void test_equilibrium_of_chain(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        G "{'type': 'support', 'position': [1, 2]}, {'type': 'mass', 'mass': 2, 'position': [1.5, 1]},"
          "{'type': 'mass', 'mass': 3, 'position': [1, 0]}, {'type': 'mass', 'name': 'Other', 'position': [5, 5]},"
          "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 100, 'rest_length': 1},"
          "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 50, 'rest_length': 0.5}");
    const double first = 1 + 5 * 9.81 / 100, second = 0.5 + 3 * 9.81 / 50;
    apply(f, "Mass 1", TINKER_START_FROM_EQUILIBRIUM, NULL, 0.1);
    assert_at(f, "Mass 0", 1, 2 - first);
    assert_at(f, "Mass 1", 1, 2 - first - second - 0.1);
    assert_at(f, "Other", 5, 5);
    /* and nothing holds the other */
    g_assert_false(is_offered(f, "Other", TINKER_START_AT_EQUILIBRIUM, NULL));
}

#define INCLINE                                                                                                        \
    G "{'type': 'support', 'name': 'Ramp', 'position': [0, 0], 'width': 20, 'height': 0.2, 'orientation': '30 deg'},"  \
      "{'type': 'mass', 'mass': 2, 'height': 0.4, 'position': [%.17g, %.17g]}"

/* A place so far up the incline from its middle and so far above its top. */
static char *on_incline(double along, double gap, const char *more)
{
    const double c = sqrt(0.75), s = 0.5, off = 0.1 + 0.2 + gap;
    g_autofree char *blocks = g_strdup_printf(INCLINE, along * c - off * s, along * s + off * c);
    return g_strconcat(blocks, more, NULL);
}

static void test_incline(void)
{
    const double c = sqrt(0.75), s = 0.5;
    g_autofree char *blocks = on_incline(1, 0.7, "");
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    apply(f, "Mass 0", TINKER_START_ALONG_TOP, "Ramp", 3);
    assert_moves(f, "Mass 0", 3 * c, 3 * s);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    apply(g, "Mass 0", TINKER_START_ON_TOP, "Ramp", 0);
    assert_at(g, "Mass 0", c - 0.3 * s, s + 0.3 * c);
    physics_assert_near("angle", start_fixture_get(g, "Mass 0", TINKER_MEANING_ORIENTATION, 0), G_PI / 6, 1e-14);
    /* falling to the other side: uphill is to the left; and a level top */
    g_autoptr(StartFixture) left = start_fixture_new("{'type': 'support', 'name': 'Ramp', 'orientation': '-30 deg'},"
                                                     "{'type': 'mass', 'position': [0, 2]}");
    apply(left, "Mass 0", TINKER_START_ALONG_TOP, "Ramp", 3);
    assert_moves(left, "Mass 0", -3 * c, 3 * s);
    g_autoptr(StartFixture) level = start_fixture_new("{'type': 'support', 'name': 'Floor'},"
                                                      "{'type': 'mass', 'position': [0, 2]}");
    apply(level, "Mass 0", TINKER_START_ALONG_TOP, "Floor", -3);
    assert_moves(level, "Mass 0", -3, 0);
}

/* Held by a spring along the incline from above: m g sin / k beyond its rest length, and it stays on the top. */
static void test_rest_on_incline(void)
{
    const double c = sqrt(0.75), s = 0.5, k = 100, sag = 2 * 9.81 * s / k;
    g_autofree char *spring =
        g_strdup_printf(", {'type': 'support', 'name': 'Wall', 'solid': false, 'position': [%.17g, "
                        "%.17g]}, {'type': 'spring', 'ends': ['Wall', 'Mass 0'], 'stiffness': %g, "
                        "'rest_length': 2}",
                        4 * c - 0.3 * s, 4 * s + 0.3 * c, k);
    g_autofree char *blocks = on_incline(0.5, 0, spring);
    const double along = 4 - 2 - sag;
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    assert_at(f, "Mass 0", along * c - 0.3 * s, along * s + 0.3 * c);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    apply(g, "Mass 0", TINKER_START_FROM_EQUILIBRIUM, NULL, 0.3);
    assert_at(g, "Mass 0", (along - 0.3) * c - 0.3 * s, (along - 0.3) * s + 0.3 * c);
}

/* Wall, two masses on a floor, springs of 30 and 10 N/m: nothing pulls, so both are at their rest lengths, in spite of
 * gravity; without the wall the distance alone is given, and the middle stays. */
static void test_rest_on_floor(void)
{
    const char *blocks = G "{'type': 'support', 'name': 'Floor', 'position': [3, -0.6], 'width': 20, 'height': 0.4},"
                           "{'type': 'mass', 'position': [1.5, 0]}, {'type': 'mass', 'position': [4, 0]},"
                           "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 10, 'rest_length': 2}";
    g_autofree char *held = g_strconcat(blocks,
                                        ", {'type': 'support', 'name': 'Wall', 'solid': false, 'position': [0, 0]},"
                                        "{'type': 'spring', 'ends': ['Wall', 'Mass 0'], 'stiffness': 30, "
                                        "'rest_length': 1}",
                                        NULL);
    g_autoptr(StartFixture) f = start_fixture_new(held);
    apply(f, "Mass 1", TINKER_START_FROM_EQUILIBRIUM, NULL, 0.25);
    assert_at(f, "Mass 0", 1, 0);
    assert_at(f, "Mass 1", 3.25, 0);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    apply(g, "Mass 1", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    assert_at(g, "Mass 0", 1.75, 0);
    assert_at(g, "Mass 1", 3.75, 0);
}

/* L sin, -L cos; the length stays what it is, whether given or drawn. */
static void test_pendulum(void)
{
    const char *const lengths[] = {"", ", 'length': 5"};
    for (gsize i = 0; i < G_N_ELEMENTS(lengths); i++) {
        g_autofree char *blocks = g_strdup_printf(G "{'type': 'support', 'position': [1, 1]},"
                                                    "{'type': 'mass', 'position': [4, -3], 'velocity': [0.8, 0.6]},"
                                                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']%s}",
                                                  lengths[i]);
        g_autoptr(StartFixture) f = start_fixture_new(blocks);
        physics_assert_near("angle", value_of(f, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0"), atan2(3, 4), 1e-15);
        apply(f, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0", -G_PI / 6);
        assert_at(f, "Mass 0", 1 - 2.5, 1 - 5 * sqrt(0.75));
        assert_moves(f, "Mass 0", cos(G_PI / 6), -sin(G_PI / 6)); /* across as before */
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerModel) model = tinker_model_new(f->scene, &error);
        g_assert_no_error(error);
        g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 0);
        g_autoptr(StartFixture) g = start_fixture_new(blocks);
        apply(g, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
        assert_at(g, "Mass 0", 1, -4);
        g_assert_false(is_offered(f, "Mass 0", TINKER_START_FROM_EQUILIBRIUM, NULL));
    }
}

/* The second mass turns with the first; of the second alone the first stays where it is. */
static void test_double_pendulum(void)
{
    const char *blocks = G "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'position': [0, -1]},"
                           "{'type': 'mass', 'position': [0, -3]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                           "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1'], 'length': 2}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    apply(f, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0", G_PI / 2);
    assert_at(f, "Mass 0", 1, 0);
    assert_at(f, "Mass 1", 3, 0);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    apply(g, "Mass 1", TINKER_START_AT_ANGLE, "Rod 1", G_PI / 2);
    assert_at(g, "Mass 0", 0, -1);
    assert_at(g, "Mass 1", 2, -1);
    /* tied to a second point, it cannot swing */
    g_autofree char *held = g_strconcat(blocks,
                                        ", {'type': 'support', 'name': 'Pin', 'position': [1, -1]},"
                                        "{'type': 'rod', 'name': 'Stay', 'ends': ['Pin', 'Mass 0']}",
                                        NULL);
    g_autoptr(StartFixture) h = start_fixture_new(held);
    assert_refused(h, "Mass 0", TINKER_START_AT_ANGLE, "Rod 0", 0.5, "its length is");
}

/* Bodies on a rod between them are shifted together; on a rod to a support nothing is offered. */
static void test_stretched_with_rods(void)
{
    const char *blocks = "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'position': [2, 0]},"
                         "{'type': 'mass', 'position': [2, 1]}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'rest_length': 1.5}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    apply(f, "Mass 0", TINKER_START_STRETCHED, "Spring 0", -0.5);
    assert_at(f, "Mass 0", 1, 0);
    assert_at(f, "Mass 1", 1, 1);
    g_autofree char *held = g_strconcat(blocks, ", {'type': 'rod', 'ends': ['Mass 1', 'Support 0']}", NULL);
    g_autoptr(StartFixture) h = start_fixture_new(held);
    g_assert_false(is_offered(h, "Mass 0", TINKER_START_STRETCHED, NULL));
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    assert_refused(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0", -1.5, "whole rest length");
    assert_refused(g, "Mass 0", TINKER_START_STRETCHED, "Spring 0", NAN, "finite");
}

/* A support that its motion has 0.5 m to the right at t = 0. */
static void test_moved_support(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        G "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'mass': 2, 'position': [0, -1.5]},"
          "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': 'cosine', 'amplitude': 0.5},"
          "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 80, 'rest_length': 1}");
    physics_assert_near("stretch", value_of(f, "Mass 0", TINKER_START_STRETCHED, NULL), hypot(0.5, 1.5) - 1, 1e-14);
    apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    assert_at(f, "Mass 0", 0.5, -1 - 2 * 9.81 / 80);
}

static void test_thrown(void)
{
    const char *blocks = "{'type': 'mass', 'velocity': [3, 4]}, {'type': 'mass'}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    physics_assert_near("direction", value_of(f, "Mass 0", TINKER_START_DIRECTION, NULL), atan2(4, 3), 1e-15);
    apply(f, "Mass 0", TINKER_START_SPEED, NULL, 10);
    assert_moves(f, "Mass 0", 6, 8);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    apply(g, "Mass 0", TINKER_START_DIRECTION, NULL, G_PI / 2);
    assert_moves(g, "Mass 0", 0, 5);
    g_autoptr(StartFixture) h = start_fixture_new(blocks);
    g_assert_false(is_offered(h, "Mass 1", TINKER_START_DIRECTION, NULL));
    assert_refused(h, "Mass 1", TINKER_START_SPEED, NULL, -1, "negative");
    apply(h, "Mass 1", TINKER_START_SPEED, NULL, 2);
    assert_moves(h, "Mass 1", 2, 0);
}

/* A weight on a spring over a floor that is nearer than the spring would let it come rests on the floor; over one that
 * is farther it hangs m g / k below the spring's length. */
static void test_stopped_by_floor(void)
{
    const double depths[] = {1.2, 3}, sag = 1 + 9.81 / 20;
    for (gsize i = 0; i < G_N_ELEMENTS(depths); i++) {
        g_autofree char *blocks =
            g_strdup_printf(G "{'type': 'support', 'name': 'Floor', 'position': [0, %g], 'height': 0.2},"
                              "{'type': 'support', 'name': 'Nail', 'solid': false},"
                              "{'type': 'mass', 'position': [0, -0.7], 'height': 0.2},"
                              "{'type': 'spring', 'ends': ['Nail', 'Mass 0'], 'stiffness': 20, 'rest_length': 1}",
                            -depths[i] - 0.2);
        g_autoptr(StartFixture) f = start_fixture_new(blocks);
        apply(f, "Mass 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
        assert_at(f, "Mass 0", 0, -fmin(depths[i], sag));
    }
}

/* A rod that leans against a wall lies down. From where it would come down elsewhere it is not displaced. */
static void test_lies_down(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new(G "{'type': 'support', 'name': 'Floor', 'position': [3, -0.1], 'width': 10, 'height': 0.2},"
                            "{'type': 'support', 'name': 'Wall', 'position': [-0.1, 2], 'orientation': '-90 deg', "
                            "'width': 5, 'height': 0.2},"
                            "{'type': 'mass', 'name': 'Foot', 'position': [1.4, 0.2], 'height': 0.4},"
                            "{'type': 'mass', 'name': 'Head', 'position': [0.2, 1.8], 'height': 0.4},"
                            "{'type': 'rod', 'ends': ['Foot', 'Head'], 'length': 2}");
    g_assert_false(is_offered(f, "Foot", TINKER_START_FROM_EQUILIBRIUM, NULL));
    apply(f, "Foot", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    const double head = start_fixture_get(f, "Head", TINKER_MEANING_POSITION, 0);
    const char *const ends[] = {"Head", "Foot"};
    for (int i = 0; i < 2; i++) {
        physics_assert_near("x", start_fixture_get(f, ends[i], TINKER_MEANING_POSITION, 0), head + 2 * i,
                            TINKER_TOUCHING);
        physics_assert_near("y", start_fixture_get(f, ends[i], TINKER_MEANING_POSITION, 1), 0.2, TINKER_TOUCHING);
    }
}

/* A place within a plate is no start. */
static void test_plate_in_the_way(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support', 'name': 'Floor', 'position': [0, 0], 'width': 9, 'height': 0.2},"
                          "{'type': 'support', 'name': 'Ceiling', 'solid': false, 'position': [0, 5]},"
                          "{'type': 'mass', 'position': [0, 2], 'height': 0.4},"
                          "{'type': 'spring', 'ends': ['Ceiling', 'Mass 0'], 'rest_length': 3}");
    assert_refused(f, "Mass 0", TINKER_START_STRETCHED, "Spring 0", 1.9, "Floor");
}

static void test_lengths_of_connectors(void)
{
    const char *blocks = "{'type': 'support'}, {'type': 'mass', 'position': [3, 4]},"
                         "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'rest_length': 1},"
                         "{'type': 'rod', 'ends': ['Mass 0', 'Support 0'], 'length': 1}";
    g_autoptr(StartFixture) f = start_fixture_new(blocks);
    physics_assert_near("stretch", value_of(f, "Spring 0", TINKER_START_LENGTH_STRETCHED, NULL), 4, 1e-14);
    apply(f, "Spring 0", TINKER_START_LENGTH_AS_DRAWN, NULL, 0);
    physics_assert_near("rest length", start_fixture_get(f, "Spring 0", TINKER_MEANING_LENGTH, 0), 5, 1e-15);
    g_autoptr(StartFixture) g = start_fixture_new(blocks);
    apply(g, "Spring 0", TINKER_START_LENGTH_STRETCHED, NULL, 0.5);
    physics_assert_near("rest length", start_fixture_get(g, "Spring 0", TINKER_MEANING_LENGTH, 0), 4.5, 1e-15);
    assert_at(g, "Mass 0", 3, 4);
    g_autoptr(StartFixture) h = start_fixture_new(blocks);
    g_assert_false(is_offered(h, "Rod 0", TINKER_START_LENGTH_STRETCHED, NULL));
    apply(h, "Rod 0", TINKER_START_LENGTH_AS_DRAWN, NULL, 0);
    physics_assert_near("length", start_fixture_get(h, "Rod 0", TINKER_MEANING_LENGTH, 0), 5, 1e-15);
    g_autoptr(StartFixture) k = start_fixture_new(blocks);
    assert_refused(k, "Spring 0", TINKER_START_LENGTH_STRETCHED, NULL, 6, "rest_length");
}

/* A block that is gone, a support, a loose connector: nothing to offer, and nothing breaks. */
static void test_nothing_to_offer(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new("{'type': 'support'}, {'type': 'mass'}, {'type': 'spring', 'ends': ['Mass 0', [1, 1]]}");
    const char *const names[] = {"Support 0", "Spring 0"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, names[i]));
        g_assert_cmpuint(options->len, ==, 0);
    }
    g_assert_false(is_offered(f, "Mass 0", TINKER_START_STRETCHED, NULL));
    g_autoptr(GPtrArray) of_mass = tinker_start_options_new(f->scene, start_fixture_block(f, "Mass 0"));
    tinker_scene_remove_block(f->scene, start_fixture_block(f, "Mass 0"));
    for (guint i = 0; i < of_mass->len; i++) {
        g_autoptr(GError) error = NULL;
        g_assert_false(tinker_start_apply(f->history, f->scene, g_ptr_array_index(of_mass, i), 1, &error));
        g_assert_nonnull(error);
    }
}

/* Every offer for every block of a bundled scene: applied with the value that it shows it is one step or changes
 * nothing; what it shows then is that value. */
static void try_all_offers(StartFixture *f, TinkerBlockId block)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, block);
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        g_autoptr(GError) error = NULL;
        g_assert_true(isfinite(option->value));
        if (tinker_start_apply(f->history, f->scene, option, option->value, &error)) {
            g_autoptr(GPtrArray) after = tinker_start_options_new(f->scene, block);
            const TinkerStartOption *again =
                option->other == TINKER_NO_BLOCK
                    ? find(f, after, option->kind, NULL)
                    : find(f, after, option->kind, tinker_scene_block_name(f->scene, option->other));
            if (again != NULL) physics_assert_near(option->label, again->value, option->value, 1e-8);
            while (tinker_history_can_undo(f->history) != NULL)
                tinker_history_undo(f->history);
        } else {
            g_assert_nonnull(error);
            g_test_message("%s", error->message);
        }
        g_autofree char *now = tinker_scene_to_text(f->scene, TINKER_WRITE_SI);
        g_assert_cmpstr(now, ==, f->text);
    }
}

static void test_bundled_scenes(void)
{
    g_autofree char *folder = g_build_filename(g_getenv("TINKER_SOURCES"), "host", "scenes", NULL);
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(dir);
    int scenes = 0;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(name, ".tinker.json")) continue;
        g_autofree char *path = g_build_filename(folder, name, NULL);
        g_autoptr(GError) error = NULL;
        g_autoptr(StartFixture) f = g_new0(StartFixture, 1);
        f->scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
        g_assert_no_error(error);
        f->history = tinker_history_new(f->scene);
        f->text = tinker_scene_to_text(f->scene, TINKER_WRITE_SI);
        g_test_message("%s", name);
        for (int32_t i = 0; i < MIN(tinker_scene_block_count(f->scene), 40); i++)
            try_all_offers(f, tinker_scene_block_at(f->scene, i));
        scenes++;
    }
    g_assert_cmpint(scenes, >, 20);
}

/* Bodies that turn ------------------------------------------------------------------------------------------------- */

/* A bar of 1 m that hangs on a pin at its end, 30 degrees off the vertical. */
#define HANGING_BAR                                                                                                    \
    "{'type': 'support'}, {'type': 'bar', 'position': [0.25, -0.4330127018922193], 'orientation': "                    \
    "-1.0471975511965976},"                                                                                            \
    "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}"

static void assert_bar(const StartFixture *f, const char *name, double x, double y, double angle)
{
    physics_assert_near("x", start_fixture_get(f, name, TINKER_MEANING_POSITION, 0), x, 1e-9);
    physics_assert_near("y", start_fixture_get(f, name, TINKER_MEANING_POSITION, 1), y, 1e-9);
    physics_assert_near("angle", start_fixture_get(f, name, TINKER_MEANING_ORIENTATION, 0), angle, 1e-9);
}

/* It turns about its pin, the shorter way. */
static void test_turned(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(HANGING_BAR);
    apply(f, "Bar 0", TINKER_START_LEVEL, NULL, 0);
    assert_bar(f, "Bar 0", 0.5, 0, 0);
    g_autoptr(StartFixture) again = start_fixture_new(HANGING_BAR);
    apply(again, "Bar 0", TINKER_START_UPRIGHT, NULL, 0);
    assert_bar(again, "Bar 0", 0, -0.5, -G_PI / 2);
    g_autoptr(StartFixture) inclined = start_fixture_new(HANGING_BAR);
    apply(inclined, "Bar 0", TINKER_START_INCLINED, NULL, G_PI / 6);
    assert_bar(inclined, "Bar 0", 0.5 * cos(G_PI / 6), 0.25, G_PI / 6);
}

/* Spinning about the pin: the centre moves across the bar at half a metre; what hangs on its end goes along. */
static void test_spinning(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new(HANGING_BAR ", {'type': 'mass', 'position': [0.5, -0.8660254037844386]},"
                                      "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, 'Mass 0']}");
    apply(f, "Bar 0", TINKER_START_SPINNING, NULL, 3);
    physics_assert_near("vx", start_fixture_get(f, "Bar 0", TINKER_MEANING_VELOCITY, 0), 1.5 * sqrt(0.75), 1e-9);
    physics_assert_near("vy", start_fixture_get(f, "Bar 0", TINKER_MEANING_VELOCITY, 1), 1.5 * 0.5, 1e-9);
    physics_assert_near("mass vx", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 0), 3 * sqrt(0.75), 1e-9);
    physics_assert_near("mass vy", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 1), 3 * 0.5, 1e-9);
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, NULL);
    g_assert_nonnull(model);
    g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 0); /* nothing had to be changed */
    g_assert_true(try_apply(f, "Bar 0", TINKER_START_AT_REST, NULL, 0, NULL));
    g_assert_cmpfloat(start_fixture_get(f, "Bar 0", TINKER_MEANING_ANGULAR_VELOCITY, 0), ==, 0);
}

/* Free, it spins about its centre, which keeps its velocity. */
static void test_spinning_freely(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'disc', 'velocity': [2, 1]}");
    apply(f, "Disc 0", TINKER_START_SPINNING, NULL, 4 * G_PI);
    g_assert_cmpfloat(start_fixture_get(f, "Disc 0", TINKER_MEANING_VELOCITY, 0), ==, 2);
    g_assert_false(is_offered(f, "Disc 0", TINKER_START_LEVEL, NULL)); /* round */
    g_autoptr(StartFixture) mass = start_fixture_new("{'type': 'mass'}");
    g_assert_false(is_offered(mass, "Mass 0", TINKER_START_SPINNING, NULL));
}

/* At rest a bar hangs straight down from its pin, and is turned so. */
static void test_bar_at_equilibrium(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(G HANGING_BAR);
    apply(f, "Bar 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    assert_bar(f, "Bar 0", 0, -0.5, -G_PI / 2);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, &error);
    g_assert_no_error(error);
}

static void add_tests(void)
{
    g_test_add_func("/start/equilibrium", test_equilibrium);
    g_test_add_func("/start/rest-length-stays", test_rest_length_stays);
    g_test_add_func("/start/equilibrium-of-chain", test_equilibrium_of_chain);
    g_test_add_func("/start/incline", test_incline);
    g_test_add_func("/start/rest-on-incline", test_rest_on_incline);
    g_test_add_func("/start/rest-on-floor", test_rest_on_floor);
    g_test_add_func("/start/stopped-by-floor", test_stopped_by_floor);
    g_test_add_func("/start/lies-down", test_lies_down);
    g_test_add_func("/start/pendulum", test_pendulum);
    g_test_add_func("/start/double-pendulum", test_double_pendulum);
    g_test_add_func("/start/stretched-with-rods", test_stretched_with_rods);
    g_test_add_func("/start/moved-support", test_moved_support);
    g_test_add_func("/start/thrown", test_thrown);
    g_test_add_func("/start/plate-in-the-way", test_plate_in_the_way);
    g_test_add_func("/start/lengths-of-connectors", test_lengths_of_connectors);
    g_test_add_func("/start/nothing-to-offer", test_nothing_to_offer);
    g_test_add_func("/start/bundled-scenes", test_bundled_scenes);
    g_test_add_func("/start/turned", test_turned);
    g_test_add_func("/start/spinning", test_spinning);
    g_test_add_func("/start/spinning-freely", test_spinning_freely);
    g_test_add_func("/start/bar-at-equilibrium", test_bar_at_equilibrium);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
