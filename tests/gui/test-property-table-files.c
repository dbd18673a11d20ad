/* The file of a table that is chosen in the panel: where it ends up, and that nothing is changed where it is refused.
 */
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#include "table-fixture.h"

/* Neither may change anything; the sentence has the part. */
static void assert_file_refused(TablePanel *panel, const char *path, const char *part)
{
    g_autoptr(TinkerPropertyRow) row = table_panel_find_row(panel, "Force", "Type");
    g_autoptr(GError) checked = NULL, refused = NULL;
    g_autofree char *before = table_panel_scene_text(panel), *files = table_panel_names_in_folder(panel), *copy = NULL;
    const char *step = tinker_history_can_undo(tinker_document_history(panel->document));
    g_assert_false(tinker_property_row_check_file(panel->document, row, path, &copy, &checked));
    g_assert_null(copy);
    g_assert_nonnull(strstr(checked->message, part));
    g_assert_false(tinker_property_row_choose_file(panel->document, row, path, &refused));
    g_assert_nonnull(strstr(refused->message, part));
    g_autofree char *after = table_panel_scene_text(panel);
    g_assert_cmpstr(after, ==, before);
    g_assert_true(tinker_history_can_undo(tinker_document_history(panel->document)) == step);
    table_panel_assert_names(panel, files);
}

/* Where the file is ------------------------------------------------------------------------------------------------ */

static void test_in_a_folder_within(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), NULL, "F");
    g_autofree char *data = g_build_filename(panel.folder, "data", NULL);
    g_autofree char *path = g_build_filename(data, "tab\"le.csv", NULL);
    g_assert_cmpint(g_mkdir(data, 0700), ==, 0);
    g_assert_true(g_file_set_contents(path, RECORD, -1, NULL));
    table_panel_choose_file(&panel, "Force", path);
    table_panel_assert_shown(&panel, "Force", "File", "data/tab\"le.csv");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 2), ==, 4);
    table_panel_assert_names(&panel, "data scene.tinker.json");
}

static char *copy_name(TablePanel *panel, const char *path)
{
    g_autoptr(TinkerPropertyRow) row = table_panel_find_row(panel, "Force", "Type");
    g_autoptr(GError) error = NULL;
    char *name;
    tinker_property_row_check_file(panel->document, row, path, &name, &error);
    g_assert_no_error(error);
    return name;
}

static void test_copied(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), NULL, "F");
    g_autofree char *path = files_fixture_file("record.csv", RECORD);
    g_autofree char *name = copy_name(&panel, path);
    g_assert_cmpstr(name, ==, "record.csv");
    table_panel_assert_names(&panel, "scene.tinker.json"); /* asking makes nothing */
    table_panel_choose_file(&panel, "Force", path);
    table_panel_assert_names(&panel, "record.csv scene.tinker.json");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 2), ==, 4);
    table_panel_choose_file(&panel, "Force", path); /* it is there already */
    table_panel_assert_names(&panel, "record.csv scene.tinker.json");
    g_autofree char *kept = NULL;
    g_assert_true(g_file_get_contents(path, &kept, NULL, NULL));
    g_assert_cmpstr(kept, ==, RECORD);
}

/* Another file of that name stays as it is; so does a link, also one to the very table, which no scene may read. */
static void test_never_overwritten(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), "mine", "F");
    g_autofree char *path = files_fixture_file("record.csv", RECORD), *text = NULL;
    g_autofree char *own = g_build_filename(panel.folder, "record.csv", NULL);
    g_autofree char *link = g_build_filename(panel.folder, "record-2.csv", NULL);
    g_assert_cmpint(symlink(path, link), ==, 0);
    g_autofree char *name = copy_name(&panel, path), *through_link = copy_name(&panel, link);
    g_assert_cmpstr(name, ==, "record-3.csv");
    g_assert_cmpstr(through_link, ==, "record-2-2.csv");
    table_panel_choose_file(&panel, "Force", path);
    table_panel_assert_shown(&panel, "Force", "File", "record-3.csv");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 2), ==, 4);
    g_assert_true(g_file_get_contents(own, &text, NULL, NULL));
    g_assert_cmpstr(text, ==, "mine");
    g_assert_true(g_file_test(link, G_FILE_TEST_IS_SYMLINK));
}

/* Refusing --------------------------------------------------------------------------------------------------------- */

static void test_refused(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(", \"waveform\": \"cosine\""), "time,x\n0,1\n1,one\n", "F");
    g_autofree char *here = g_build_filename(panel.folder, "record.csv", NULL);
    g_autofree char *elsewhere = files_fixture_file("falling.csv", "0,1\n2,3\n1,3\n");
    g_autofree char *empty = files_fixture_file("empty.csv", "");
    assert_file_refused(&panel, here, "record.csv:3:3: the value must be a number, not \"one\"");
    assert_file_refused(&panel, elsewhere, "falling.csv:3:1: the time 1 must be greater than 2");
    assert_file_refused(&panel, empty, "no rows of numbers");
    assert_file_refused(&panel, panel.folder, "must be a file");
    assert_file_refused(&panel, "/nowhere/at/all.csv", "/nowhere/at/all.csv");
    table_panel_assert_shown(&panel, "Force", "Type", "Cosine");
}

/* No JSON text can hold such a name: where it lies it is refused, but a copy gets another one. */
static void test_name_that_is_no_text(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), NULL, "F");
    g_autofree char *here = g_build_filename(panel.folder, "\xff.csv", NULL);
    g_autofree char *elsewhere = files_fixture_file("\xfe.csv", RECORD);
    g_autofree char *before = table_panel_scene_text(&panel);
    g_autoptr(TinkerPropertyRow) row = table_panel_find_row(&panel, "Force", "Type");
    g_autoptr(GError) error = NULL;
    g_assert_true(g_file_set_contents(here, RECORD, -1, NULL));
    g_assert_false(tinker_property_row_choose_file(panel.document, row, here, &error));
    g_assert_nonnull(strstr(error->message, "UTF-8"));
    g_autofree char *after = table_panel_scene_text(&panel);
    g_assert_cmpstr(after, ==, before);
    table_panel_choose_file(&panel, "Force", elsewhere);
    table_panel_assert_shown(&panel, "Force", "File", "\xef\xbf\xbd.csv");
    g_assert_cmpfloat(table_panel_reopened_value(&panel, "F", 2), ==, 4);
}

static void test_not_saved_yet(void)
{
    g_auto(TablePanel) panel = table_panel_with(MOTOR(""), RECORD, "F");
    g_autofree char *path = g_build_filename(panel.folder, "record.csv", NULL);
    const char *text = MOTOR("");
    g_assert_true(tinker_document_start(panel.document, text, strlen(text), path, NULL));
    tinker_document_select(panel.document, tinker_scene_find_block(tinker_document_scene(panel.document), "F"));
    assert_file_refused(&panel, path, "Save the scene first");
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-table-files/in-a-folder-within", test_in_a_folder_within);
    g_test_add_func("/gui/property-table-files/copied", test_copied);
    g_test_add_func("/gui/property-table-files/never-overwritten", test_never_overwritten);
    g_test_add_func("/gui/property-table-files/refused", test_refused);
    g_test_add_func("/gui/property-table-files/name-that-is-no-text", test_name_that_is_no_text);
    g_test_add_func("/gui/property-table-files/not-saved-yet", test_not_saved_yet);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
