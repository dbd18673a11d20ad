/* Bodies that lie on a top instead of having a position: where that is, by the rotation of the support's axes; what
 * becomes of it when the scene is edited, saved and copied. */
#include <math.h>
#include <string.h>

#include "scene-fixture.h"
#include "scene/frame/overlaps.h"
#include "scene/history/continued.h"
#include "scene/history/fragment.h"
#include "scene/history/history.h"

static const TinkerBlockClass *class_of(const TinkerScene *scene, const char *name)
{
    return tinker_scene_block_class(scene, tinker_scene_find_block(scene, name));
}

static double value(const TinkerScene *scene, const char *name, int32_t meaning, int component)
{
    const int32_t column = tinker_block_class_meaning_column(class_of(scene, name), meaning);
    return tinker_scene_get(scene, tinker_scene_find_block(scene, name), column + component);
}

/* The body's centre is (along, H/2 + h/2) in the axes of a support that is turned by `angle` around (cx, cy). */
static void expect_on(const TinkerScene *scene, const char *name, double cx, double cy, double angle, double along,
                      double up)
{
    const double x = cx + along * cos(angle) - up * sin(angle), y = cy + along * sin(angle) + up * cos(angle);
    g_assert_cmpfloat_with_epsilon(value(scene, name, TINKER_MEANING_POSITION, 0), x, 4e-15 * (1 + fabs(x)));
    g_assert_cmpfloat_with_epsilon(value(scene, name, TINKER_MEANING_POSITION, 1), y, 4e-15 * (1 + fabs(y)));
    g_assert_cmpfloat(value(scene, name, TINKER_MEANING_ORIENTATION, 0), ==, angle);
}

static void expect_lies(const TinkerScene *scene, const char *name, const char *plate)
{
    TinkerBlockId on = TINKER_NO_BLOCK;
    double along;
    const gboolean lies = tinker_scene_lies_on(scene, tinker_scene_find_block(scene, name), &on, &along);
    g_assert_cmpint(lies, ==, plate != NULL);
    if (plate != NULL) g_assert_cmpint(on, ==, tinker_scene_find_block(scene, plate));
}

#define INCLINE                                                                                                        \
    "{\"type\": \"support\", \"name\": \"Incline\", \"position\": [1, 2], \"orientation\": \"30 deg\", \"width\": "    \
    "12, "                                                                                                             \
    "\"height\": 0.5}"
#define BOX(more) "{\"type\": \"mass\", \"name\": \"Box\", \"on\": \"Incline\", \"height\": 0.7" more "}"

static void test_places(void)
{
    static const struct {
        const char *more;
        double along;
    } rows[] = {{"", 0}, {", \"along\": 2.5", 2.5}, {", \"along\": -3", -3}, {", \"along\": \"10 in\"", 0.254}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *box = g_strdup_printf(BOX("%s"), rows[i].more);
        /* the support may come first or last */
        g_autofree char *after = g_strconcat(INCLINE ", ", box, NULL), *before = g_strconcat(box, ", " INCLINE, NULL);
        const char *const orders[] = {after, before};
        for (int k = 0; k < 2; k++) {
            g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(orders[k]);
            expect_on(scene, "Box", 1, 2, value(scene, "Incline", TINKER_MEANING_ORIENTATION, 0), rows[i].along,
                      0.25 + 0.35);
            g_autoptr(GPtrArray) warnings = g_ptr_array_new_with_free_func(g_free);
            tinker_overlaps_tell(scene, warnings);
            g_assert_cmpuint(warnings->len, ==, 0);
        }
    }
}

/* A box by its side, or, turned by 45 degrees against the top, by a corner; a disc by its rim. */
static void test_bodies_that_turn(void)
{
    static const char *const bodies[] = {
        "{\"type\": \"box\", \"name\": \"B\", \"on\": \"Incline\", \"along\": 2, \"width\": 0.4, \"height\": 0.8}",
        "{\"type\": \"disc\", \"name\": \"B\", \"on\": \"Incline\", \"along\": 2, \"radius\": 0.4}",
        ("{\"type\": \"box\", \"name\": \"B\", \"on\": \"Incline\", \"along\": 2, \"width\": 0.4, \"height\": 0.4, "
         "\"orientation\": \"75 deg\"}")};
    for (gsize i = 0; i < G_N_ELEMENTS(bodies); i++) {
        g_autofree char *blocks = g_strconcat(bodies[i], ", " INCLINE, NULL);
        g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks);
        const double angle = G_PI / 6, up = 0.25 + (i < 2 ? 0.4 : 0.2 * G_SQRT2);
        g_assert_cmpfloat_with_epsilon(value(scene, "B", TINKER_MEANING_POSITION, 0),
                                       1 + 2 * cos(angle) - up * sin(angle), 1e-14);
        g_assert_cmpfloat_with_epsilon(value(scene, "B", TINKER_MEANING_POSITION, 1),
                                       2 + 2 * sin(angle) + up * cos(angle), 1e-14);
        g_assert_cmpfloat_with_epsilon(value(scene, "B", TINKER_MEANING_ORIENTATION, 0), i < 2 ? angle : 2.5 * angle,
                                       1e-14);
        g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
        g_autoptr(TinkerScene) again = scene_fixture_read(text);
        expect_lies(again, "B", "Incline");
    }
}

/* The support is where its motions have it at t = 0. */
static void test_moved_support(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        BOX(", \"along\": 1") ", " INCLINE ", {\"type\": \"support-motion\", \"ends\": [\"Incline\"], \"waveform\": "
                              "\"cosine\", \"amplitude\": 0.5, \"frequency\": 3, \"angle\": 0}, {\"type\": "
                              "\"support-motion\", \"name\": \"M\", \"ends\": [\"Incline\"], \"waveform\": "
                              "{\"expression\": \"0.25 + t\"}, \"angle\": \"90 deg\"}");
    const double angle = value(scene, "Incline", TINKER_MEANING_ORIENTATION, 0);
    expect_on(scene, "Box", 1.5, 2.25, angle, 1, 0.6);
    /* one motion less */
    tinker_scene_remove_block(scene, tinker_scene_find_block(scene, "M"));
    expect_on(scene, "Box", 1.5, 2, angle, 1, 0.6);
}

/* An orientation that is given stands; one that is not is the support's. */
static void test_orientation(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(BOX(", \"orientation\": 0.125") ", " INCLINE);
    g_assert_cmpfloat(value(scene, "Box", TINKER_MEANING_ORIENTATION, 0), ==, 0.125);
    expect_lies(scene, "Box", "Incline");
}

/* A property by its meaning. */
static void set(TinkerHistory *history, TinkerScene *scene, const char *name, int32_t meaning, double x, double y)
{
    const double values[2] = {x, y};
    tinker_history_set(history, tinker_scene_find_block(scene, name), class_of(scene, name)->meanings[meaning], values,
                       NULL);
}

/* It follows the support and its own height; undo brings it back to the bit. */
static void test_follows(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(BOX(", \"along\": 2") ", " INCLINE);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    const double angle = value(scene, "Incline", TINKER_MEANING_ORIENTATION, 0);
    const double x = value(scene, "Box", TINKER_MEANING_POSITION, 0);
    set(history, scene, "Incline", TINKER_MEANING_POSITION, -3, 7);
    expect_on(scene, "Box", -3, 7, angle, 2, 0.6);
    set(history, scene, "Incline", TINKER_MEANING_ORIENTATION, -0.5, 0);
    expect_on(scene, "Box", -3, 7, -0.5, 2, 0.6);
    set(history, scene, "Box", TINKER_MEANING_HEIGHT, 0.2, 0);
    expect_on(scene, "Box", -3, 7, -0.5, 2, 0.35);
    expect_lies(scene, "Box", "Incline");
    for (int i = 0; i < 3; i++)
        tinker_history_undo(history);
    g_assert_cmpfloat(value(scene, "Box", TINKER_MEANING_POSITION, 0), ==, x);
    g_autofree char *after = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_cmpstr(after, ==, before);
}

/* Laid on a top it goes along with it, as if the file had said so; undo gives it its own place back, to the bit. */
static void test_laid(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"mass\", \"name\": \"Box\", \"position\": [7, 9], \"orientation\": 1, \"height\": 0.7}, " INCLINE);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    const TinkerBlockId box = tinker_scene_find_block(scene, "Box"),
                        incline = tinker_scene_find_block(scene, "Incline");
    const double angle = value(scene, "Incline", TINKER_MEANING_ORIENTATION, 0);
    g_assert_true(tinker_history_lay_on(history, box, incline, -1.5, NULL));
    expect_on(scene, "Box", 1, 2, angle, -1.5, 0.6);
    set(history, scene, "Incline", TINKER_MEANING_ORIENTATION, 0.25, 0);
    expect_on(scene, "Box", 1, 2, 0.25, -1.5, 0.6);
    tinker_history_undo(history);
    tinker_history_undo(history);
    g_autofree char *after = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_cmpstr(after, ==, before);
    g_autoptr(GError) beyond = NULL, itself = NULL;
    g_assert_false(tinker_history_lay_on(history, box, incline, 6.5, &beyond));
    g_assert_nonnull(strstr(beyond->message, "from -6 m to 6 m"));
    g_assert_false(tinker_history_lay_on(history, incline, box, 0, &itself));
    g_assert_nonnull(strstr(itself->message, "Incline cannot lie on Box"));
}

/* A move makes a position of it, with the orientation that it had; undo takes that back. */
static void test_moved(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(BOX("") ", " INCLINE);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    const double angle = value(scene, "Incline", TINKER_MEANING_ORIENTATION, 0);
    set(history, scene, "Box", TINKER_MEANING_POSITION, 4, 5);
    expect_lies(scene, "Box", NULL);
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_autoptr(TinkerScene) again = scene_fixture_read(text);
    g_assert_null(strstr(text, "\"on\""));
    g_assert_cmpfloat(value(again, "Box", TINKER_MEANING_POSITION, 0), ==, 4);
    g_assert_cmpfloat(value(again, "Box", TINKER_MEANING_POSITION, 1), ==, 5);
    g_assert_cmpfloat(value(again, "Box", TINKER_MEANING_ORIENTATION, 0), ==, angle);
    tinker_history_undo(history);
    expect_lies(scene, "Box", "Incline");
    expect_on(scene, "Box", 1, 2, angle, 0, 0.6);
    tinker_history_redo(history);
    expect_lies(scene, "Box", NULL);
}

static void test_saved(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(BOX(", \"along\": -1.25") ", " INCLINE);
    g_assert_true(tinker_scene_rename_block(scene, tinker_scene_find_block(scene, "Incline"), "Slope \"1\"", NULL));
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_nonnull(strstr(text, "{\"type\": \"mass\", \"name\": \"Box\", \"on\": \"Slope \\\"1\\\"\", \"along\": "
                                  "-1.25, \"height\": 0.7}"));
    g_autoptr(TinkerScene) again = scene_fixture_read(text);
    expect_lies(again, "Box", "Slope \"1\"");
    for (int k = 0; k < 2; k++)
        g_assert_cmpfloat(value(again, "Box", TINKER_MEANING_POSITION, k), ==,
                          value(scene, "Box", TINKER_MEANING_POSITION, k));
}

/* What lies on a support stays where it is when that is removed, and lies on it again when it comes back. */
static void test_removed(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(BOX(", \"along\": 2") ", " INCLINE);
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    g_autofree char *before = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    const double angle = value(scene, "Incline", TINKER_MEANING_ORIENTATION, 0);
    tinker_history_remove_block(history, tinker_scene_find_block(scene, "Incline"));
    expect_lies(scene, "Box", NULL);
    expect_on(scene, "Box", 1, 2, angle, 2, 0.6);
    tinker_history_undo(history);
    g_autofree char *after = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_cmpstr(after, ==, before);
    tinker_history_redo(history);
    expect_lies(scene, "Box", NULL);
    expect_on(scene, "Box", 1, 2, angle, 2, 0.6);
}

static TinkerScene *paste(TinkerScene *scene, const char *const *names)
{
    TinkerBlockId ids[2];
    int32_t count = 0;
    for (; names[count] != NULL; count++)
        ids[count] = tinker_scene_find_block(scene, names[count]);
    g_autofree char *text = tinker_fragment_to_text(scene, ids, count);
    TinkerScene *copy = tinker_scene_copy(scene);
    g_autoptr(TinkerHistory) history = tinker_history_new(copy);
    g_assert_true(tinker_fragment_paste(history, text, 10, -1, NULL, NULL));
    return copy;
}

/* Pasted together with its support it lies on the copy of that; alone it has its position. */
static void test_pasted(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(BOX(", \"along\": 2") ", " INCLINE);
    const double angle = value(scene, "Incline", TINKER_MEANING_ORIENTATION, 0);
    g_autoptr(TinkerScene) both = paste(scene, (const char *[]){"Box", "Incline", NULL});
    expect_lies(both, "Mass 0", "Support 0");
    expect_on(both, "Mass 0", 11, 1, angle, 2, 0.6);
    expect_on(both, "Box", 1, 2, angle, 2, 0.6);
    g_autoptr(TinkerScene) alone = paste(scene, (const char *[]){"Box", NULL});
    expect_lies(alone, "Mass 0", NULL);
    expect_on(alone, "Mass 0", 11, 1, angle, 2, 0.6);
}

/* A run that goes on from later begins where the body is then, not where it lay. */
static void test_continued(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        BOX("") ", " INCLINE ", {\"type\": \"support-motion\", \"ends\": [\"Incline\"], \"amplitude\": 1, "
                "\"frequency\": 1}");
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    g_autofree double *velocities = g_new0(double, 3 * (gsize)tinker_scene_id_limit(scene));
    g_assert_true(tinker_frame_set_time(frame, 1.5, NULL));
    g_autoptr(TinkerScene) later = tinker_scene_continued(scene, frame, 1.5, velocities, NULL);
    for (int k = 0; k < 2; k++)
        g_assert_cmpfloat(value(later, "Box", TINKER_MEANING_POSITION, k), ==,
                          value(scene, "Box", TINKER_MEANING_POSITION, k));
}

static void test_mistakes(void)
{
    static const struct {
        const char *keys, *finding; /* of a box whose keys begin at 2:33 */
    } rows[] = {
        {"\"on\": \"Slope\", \"position\": [0, 1]",
         "2:48: Box: position is given beside on, which places it (leave one of them out)\n"},
        {"\"on\": \"Slop\"", "2:39: Box: on names no block \"Slop\" (did you mean \"Slope\"?)\n"},
        {"\"on\": \"Box\"", "2:39: Box: on names the block itself\n"},
        {"\"on\": \"Ball\"", "2:39: Box: on names \"Ball\", a mass, which has no top to lie on\n"},
        {"\"on\": 7", "2:39: Box: on: a text was expected, a number is given\n"},
        {"\"along\": 1",
         "2:33: Box: along is measured on a top, and none is named (give \"on\", the name of a support)\n"},
        {"\"on\": \"Slope\", \"along\": \"1 kg\"",
         "2:57: Box: along: a length (m) was expected, \"1 kg\" is a mass (kg)\n"},
        {"\"on\": \"Slope\", \"along\": -2.5",
         "2:57: warning: Box: along is -2.5 m, beyond the end of the top of \"Slope\" (it reaches from -2 m to 2 "
         "m)\n"},
        {"\"on\": \"Pin\"", "2:39: warning: Box: on names \"Pin\", which is not solid and carries nothing (set its "
                            "\"solid\" to true)\n"},
        {"\"onn\": \"Slope\"", "2:33: warning: Box: unknown key \"onn\" (did you mean \"on\"?)\n"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *text = g_strdup_printf(
            "{\"tinker\": 1, \"blocks\": [\n{\"type\": \"mass\", \"name\": \"Box\", %s},\n{\"type\": \"support\", "
            "\"name\": \"Slope\"}, {\"type\": \"mass\", \"name\": \"Ball\", \"position\": [9, 9]},\n{\"type\": "
            "\"support\", \"name\": \"Pin\", \"solid\": false}]}",
            rows[i].keys);
        g_autofree char *findings = scene_fixture_findings(text, -1, NULL);
        g_assert_cmpstr(findings, ==, rows[i].finding);
    }
}

/* A support of a type that nobody provides is kept, and so is what lies on it. */
static void test_missing_type(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks("{\"type\": \"mass\", \"on\": \"Hill\"}, {\"type\": \"hill\", \"name\": \"Hill\"}");
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_nonnull(strstr(text, "\"on\": \"Hill\""));
}

static void add_tests(void)
{
    g_test_add_func("/scene/place-on/bodies-that-turn", test_bodies_that_turn);
    g_test_add_func("/place-on/places", test_places);
    g_test_add_func("/place-on/moved-support", test_moved_support);
    g_test_add_func("/place-on/orientation", test_orientation);
    g_test_add_func("/place-on/follows", test_follows);
    g_test_add_func("/place-on/laid", test_laid);
    g_test_add_func("/place-on/moved", test_moved);
    g_test_add_func("/place-on/saved", test_saved);
    g_test_add_func("/place-on/removed", test_removed);
    g_test_add_func("/place-on/pasted", test_pasted);
    g_test_add_func("/place-on/continued", test_continued);
    g_test_add_func("/place-on/mistakes", test_mistakes);
    g_test_add_func("/place-on/missing-type", test_missing_type);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
