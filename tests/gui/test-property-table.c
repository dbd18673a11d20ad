/* A table that is chosen as a waveform in the panel: what it is read as, against values worked out by hand; as one step
 * that leads back. */
#include <glib/gstdio.h>
#include <string.h>

#include "table-fixture.h"

static void assert_written(TablePanel *panel, const char *part)
{
    g_autofree char *text = table_panel_scene_text(panel);
    if (strstr(text, part) == NULL) g_error("“%s” lacks “%s”", text, part);
}

/* The table record.csv of the scene's folder. */
static void choose_record(TablePanel *panel, const char *group)
{
    g_autofree char *path = g_build_filename(panel->folder, "record.csv", NULL);
    table_panel_choose_file(panel, group, path);
}

/* One step leads back to the very text, and there was none before it. */
static void assert_one_step(TablePanel *panel, const char *before)
{
    g_autofree char *after = table_panel_scene_text(panel);
    g_assert_cmpstr(after, !=, before);
    tinker_document_undo(panel->document);
    g_autofree char *undone = table_panel_scene_text(panel);
    g_assert_cmpstr(undone, ==, before);
    g_assert_null(tinker_history_can_undo(tinker_document_history(panel->document)));
    tinker_document_redo(panel->document);
    g_autofree char *redone = table_panel_scene_text(panel);
    g_assert_cmpstr(redone, ==, after);
}

static void test_chosen(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), RECORD, "F");
    g_autofree char *before = table_panel_scene_text(&panel);
    table_panel_assert_absent(&panel, "Force", "File");
    choose_record(&panel, "Force");
    assert_one_step(&panel, before);
    table_panel_assert_shown(&panel, "Force", "Type", "Table");
    table_panel_assert_shown(&panel, "Force", "File", "record.csv");
    table_panel_assert_shown(&panel, "Force", "Rows", "3");
    table_panel_assert_shown(&panel, "Force", "Column", "1");
    table_panel_assert_shown(&panel, "Force", "Scale", "1");
    table_panel_assert_absent(&panel, "Force", "Kind"); /* a force is no place */
    assert_written(&panel, "\"waveform\": {\"table\": \"record.csv\"}");
    table_panel_assert_names(&panel, "record.csv scene.tinker.json");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 0.5), ==, 1);
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 2), ==, 4);
}

static void test_column_and_scale(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), RECORD, "F");
    choose_record(&panel, "Force");
    table_panel_set(&panel, "Force", "Scale", "-0.5");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 2), ==, -2);
    table_panel_set(&panel, "Force", "Column", "2");
    assert_written(&panel, "{\"table\": \"record.csv\", \"column\": 2, \"scale\": -0.5}");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 2), ==, -1);

    /* Refused: the former column stays. */
    static const char *const wrong[][2] = {{"3", "record.csv:2:6: the value is missing (column 3)"},
                                           {"0", "whole number from 1"},
                                           {"1.5", "whole number from 1"},
                                           {"1e300", "whole number from 1"},
                                           {"two", "number"}};
    g_autofree char *before = table_panel_scene_text(&panel);
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autoptr(TinkerPropertyRow) column = table_panel_find_row(&panel, "Force", "Column");
        g_autoptr(GError) error = NULL;
        g_assert_false(tinker_property_row_set(panel.document, column, wrong[i][0], &error));
        if (strstr(error->message, wrong[i][1]) == NULL) g_error("“%s” lacks “%s”", error->message, wrong[i][1]);
        g_autofree char *after = table_panel_scene_text(&panel);
        g_assert_cmpstr(after, ==, before);
    }
}

/* A constant acceleration of 2 m/s^2 from rest moves the support by t^2. The motion is a block of its own, added in the
 * same step. */
static void test_motion_by_acceleration(void)
{
    g_auto(TablePanel) panel = table_panel_with(SUPPORT, RECORD, "S");
    g_autofree char *before = table_panel_scene_text(&panel);
    choose_record(&panel, "Motion");
    assert_one_step(&panel, before);
    table_panel_assert_shown(&panel, "Motion", "Kind", "Displacement");
    TinkerScene *scene = tinker_document_scene(panel.document);
    const char *motion = tinker_scene_block_name(scene, tinker_scene_block_at(scene, 1));
    g_assert_cmpfloat(table_panel_reopened_value(&panel, motion, 2), ==, 4);
    table_panel_set(&panel, "Motion", "Column", "2");
    table_panel_set(&panel, "Motion", "Kind", "Acceleration");
    g_assert_cmpfloat_with_epsilon(table_panel_reopened_value(&panel, motion, 1), 1, 1e-14);
    g_assert_cmpfloat_with_epsilon(table_panel_reopened_value(&panel, motion, 2.5), 6.25, 1e-14);
}

/* Another table is read as the one before it, and what another program has written of that is kept. */
static void test_another(void)
{
    g_auto(TablePanel) panel =
        table_panel_with(MOTOR(", \"waveform\": {\"note\": [1, 1e400], \"table\": \"record.csv\", "
                               "\"column\": 2, \"scale\": \"3\"}"),
                         RECORD, "F");
    g_autofree char *other = g_build_filename(panel.folder, "other.csv", NULL);
    g_assert_true(g_file_set_contents(other, "0;1;5\n", -1, NULL));
    table_panel_choose_file(&panel, "Force", other);
    table_panel_assert_shown(&panel, "Force", "Rows", "1");
    assert_written(&panel, "{\"table\": \"other.csv\", \"column\": 2, \"scale\": 3, \"note\": [1, 1e400]}");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 7), ==, 15);
}

/* The same file is read anew where another program has written it. */
static void test_read_anew(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), RECORD, "F");
    g_autofree char *path = g_build_filename(panel.folder, "record.csv", NULL);
    table_panel_choose_file(&panel, "Force", path);
    g_assert_true(g_file_set_contents(path, "0 1\n1 2\n2 3\n3 4\n", -1, NULL));
    table_panel_choose_file(&panel, "Force", path);
    table_panel_assert_shown(&panel, "Force", "Rows", "4");
}

static void test_several(void)
{
    g_auto(TablePanel) panel =
        table_panel_with(MOTOR("}, {\"type\": \"motor\", \"name\": \"G\", \"ends\": [\"M\"]"), RECORD, "F");
    TinkerScene *scene = tinker_document_scene(panel.document);
    const TinkerBlockId both[] = {tinker_scene_find_block(scene, "F"), tinker_scene_find_block(scene, "G")};
    tinker_document_select_all_of(panel.document, both, 2);
    g_autofree char *before = table_panel_scene_text(&panel);
    choose_record(&panel, "Force");
    assert_one_step(&panel, before);
    table_panel_assert_shown(&panel, "Force", "Rows", "3");
    table_panel_set(&panel, "Force", "Column", "2");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 1), ==, 2);
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "G", 2), ==, 2);
    tinker_document_select(panel.document, both[0]);
    table_panel_set(&panel, "Force", "Column", "1");
    tinker_document_select_all_of(panel.document, both, 2);
    table_panel_assert_absent(&panel, "Force", "Column"); /* they differ */
}

/* The file went away after it was read: it cannot be read in another way, and what was read is kept. */
static void test_file_is_gone(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(", \"waveform\": {\"table\": \"record.csv\"}"), RECORD, "F");
    g_autofree char *path = g_build_filename(panel.folder, "record.csv", NULL);
    g_autoptr(TinkerPropertyRow) scale = table_panel_find_row(&panel, "Force", "Scale");
    g_autoptr(GError) error = NULL;
    g_assert_cmpint(g_unlink(path), ==, 0);
    g_assert_false(tinker_property_row_set(panel.document, scale, "2", &error));
    g_assert_nonnull(strstr(error->message, "record.csv"));
    table_panel_assert_shown(&panel, "Force", "Rows", "3");
    table_panel_assert_shown(&panel, "Force", "Scale", "1");
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-table/chosen", test_chosen);
    g_test_add_func("/gui/property-table/column-and-scale", test_column_and_scale);
    g_test_add_func("/gui/property-table/motion-by-acceleration", test_motion_by_acceleration);
    g_test_add_func("/gui/property-table/another", test_another);
    g_test_add_func("/gui/property-table/read-anew", test_read_anew);
    g_test_add_func("/gui/property-table/several", test_several);
    g_test_add_func("/gui/property-table/file-is-gone", test_file_is_gone);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
