/* New scenes: units and width as asked for, and why a width is refused. */
#include <math.h>
#include <string.h>

#include "files-fixture.h"
#include "gui/document/examples.h"
#include "gui/document/new-scene.h"

static const double foot = 0.3048; /* m, by definition */

static void test_width(void)
{
    static const struct {
        const char *text;
        TinkerUnitSystem units;
        double width;
    } good[] = {
        {"10 m", TINKER_UNIT_SYSTEM_SI, 10},         {" 12 in ", TINKER_UNIT_SYSTEM_SI, 0.3048},
        {"2.5", TINKER_UNIT_SYSTEM_SI, 2.5},         {"30", TINKER_UNIT_SYSTEM_ENGLISH, 9.144},
        {"30ft", TINKER_UNIT_SYSTEM_ENGLISH, 9.144}, {"4 m", TINKER_UNIT_SYSTEM_ENGLISH, 4},
        {"1 km", TINKER_UNIT_SYSTEM_SI, 1000},
    };
    static const char *const bad[] = {"",       "  ",      "0",   "-3 m", "12 kg",     "ten",
                                      "1e99 m", "1e-30 m", "nan", "inf",  "5 furlongs"};
    for (gsize i = 0; i < G_N_ELEMENTS(good); i++) {
        g_autoptr(GError) error = NULL;
        double width = 0;
        tinker_new_scene_parse_width(good[i].text, good[i].units, &width, &error);
        g_assert_no_error(error);
        g_assert_cmpfloat_with_epsilon(width, good[i].width, 1e-12 * good[i].width);
    }
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        g_autoptr(GError) error = NULL;
        double width = 0;
        g_assert_false(tinker_new_scene_parse_width(bad[i], TINKER_UNIT_SYSTEM_SI, &width, &error));
        g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
        g_assert_true(strstr(error->message, "10 m") != NULL || strstr(error->message, "between") != NULL);
    }
    g_autoptr(GError) comma = NULL;
    double width;
    g_assert_false(tinker_new_scene_parse_width("2,5 m", TINKER_UNIT_SYSTEM_SI, &width, &comma));
    g_assert_nonnull(strstr(comma->message, "with a point"));
}

/* 1, 2 or 5 times a power of ten. */
static gboolean is_round(double value)
{
    double digit = value / pow(10, floor(log10(value) + 1e-9));
    return fabs(digit - 1) < 1e-9 || fabs(digit - 2) < 1e-9 || fabs(digit - 5) < 1e-9;
}

static void test_start(void)
{
    static const double widths[] = {1e-6, 0.03, 0.5, 2.5, 10, 99, 1e6};
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(widths); i++) {
        g_autoptr(GError) error = NULL;
        gboolean english = i % 2 == 1;
        TinkerNewScene settings = {english ? TINKER_UNIT_SYSTEM_ENGLISH : TINKER_UNIT_SYSTEM_SI, widths[i / 2]};
        g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
        tinker_new_scene_start(document, &settings, &error);
        g_assert_no_error(error);
        TinkerScene *scene = tinker_document_scene(document);
        const TinkerSceneHead *head = tinker_scene_head(scene);
        g_assert_cmpint(head->units, ==, settings.units);
        g_assert_cmpfloat(head->canvas_width, ==, settings.width);
        g_assert_true(is_round(head->canvas_grid / (english ? foot : 1)));
        g_assert_cmpfloat(head->canvas_grid, <=, settings.width / 49.9);
        g_assert_cmpfloat(head->canvas_grid, >=, settings.width / 126);
        g_assert_cmpint(tinker_scene_block_count(scene), ==, 1);
        g_assert_cmpstr(files_fixture_first_name(document), ==, "Gravity");
        g_assert_true(tinker_document_is_empty(document));
        g_assert_false(tinker_document_is_modified(document));
        g_assert_null(tinker_document_path(document));
    }
}

static void test_empty(void)
{
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_assert_false(tinker_document_is_empty(document));
}

static void add_tests(void)
{
    g_test_add_func("/gui/new-scene/width", test_width);
    g_test_add_func("/gui/new-scene/start", test_start);
    g_test_add_func("/gui/new-scene/empty", test_empty);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
