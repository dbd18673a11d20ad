/* A table that is chosen as a waveform in the panel: what it is read as, against values worked out by hand; where its
 * file ends up; and that nothing is changed where it is refused. */
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#include "files-fixture.h"
#include "gui/property/property-list.h"

/* Linear: 1 at 0.5 s, 4 at 2 s. Its second column is 2 throughout. */
#define RECORD "time,force,push\n0,0,2\n1,2,2\n3,6,2\n"

#define MOTOR(waveform)                                                                                                \
    "{\"tinker\": 1, \"blocks\": [\n{\"type\": \"mass\", \"name\": \"M\"},\n"                                          \
    "{\"type\": \"motor\", \"name\": \"F\", \"ends\": [\"M\"]" waveform "}]}"
#define SUPPORT "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"S\"}]}"

/* Fixtures --------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerDocument *document;
    TinkerPlayer *player;
    char *folder;
} Panel;

/* The scene in a folder of its own, with this text as record.csv in it, and the block selected. */
static Panel panel_with(const char *scene, const char *record, const char *selected)
{
    g_autofree char *path = files_fixture_file("scene.tinker.json", scene);
    Panel panel = {.document = tinker_document_new(files_fixture_catalogue()), .folder = g_path_get_dirname(path)};
    g_autofree char *table = g_build_filename(panel.folder, "record.csv", NULL);
    g_autoptr(GError) error = NULL;
    if (record != NULL) g_assert_true(g_file_set_contents(table, record, -1, NULL));
    tinker_document_open(panel.document, path, NULL, &error);
    g_assert_no_error(error);
    panel.player = tinker_player_new(panel.document);
    tinker_document_select(panel.document, tinker_scene_find_block(tinker_document_scene(panel.document), selected));
    return panel;
}

static void panel_clear(Panel *panel)
{
    g_clear_object(&panel->player);
    g_clear_object(&panel->document);
    g_clear_pointer(&panel->folder, g_free);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Panel, panel_clear)

static TinkerPropertyRow *find_row(Panel *panel, const char *group, const char *title)
{
    g_autoptr(GPtrArray) rows = tinker_property_list_new(panel->document, panel->player, FALSE);
    for (guint i = 0; i < rows->len; i++) {
        TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        if (g_str_equal(row->group, group) && g_str_equal(row->title, title)) return tinker_property_row_ref(row);
    }
    return NULL;
}

static void assert_shown(Panel *panel, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = find_row(panel, group, title);
    g_assert_nonnull(row);
    g_assert_cmpstr(row->kind == TINKER_ROW_CHOICE ? row->choices[row->chosen] : row->text, ==, text);
}

static void assert_absent(Panel *panel, const char *group, const char *title)
{
    g_autoptr(TinkerPropertyRow) row = find_row(panel, group, title);
    g_assert_null(row);
}

static char *scene_text(Panel *panel)
{
    return tinker_scene_to_text(tinker_document_scene(panel->document), TINKER_WRITE_SI);
}

static void assert_written(Panel *panel, const char *part)
{
    g_autofree char *text = scene_text(panel);
    if (strstr(text, part) == NULL) g_error("“%s” lacks “%s”", text, part);
}

/* Of the scene as it is once it has been saved and opened again: what the block's waveform is at t. */
static double reopened_value(Panel *panel, const char *name, double t)
{
    g_autoptr(TinkerDocument) again = tinker_document_new(files_fixture_catalogue());
    g_autoptr(GError) error = NULL;
    tinker_document_save(panel->document, tinker_document_path(panel->document), &error);
    g_assert_no_error(error);
    tinker_document_open(again, tinker_document_path(panel->document), NULL, &error);
    g_assert_no_error(error);
    TinkerScene *scene = tinker_document_scene(again);
    TinkerBlockId block = tinker_scene_find_block(scene, name);
    g_assert_cmpint(block, !=, TINKER_NO_BLOCK);
    int32_t property = tinker_block_class_property(tinker_scene_block_class(scene, block), "waveform");
    g_autoptr(TinkerWaveformEvaluator) evaluator =
        tinker_waveform_evaluator_new(tinker_scene_get_waveform(scene, block, property), 1, 1, 0, FALSE);
    double result[3];
    tinker_waveform_enter_piece(evaluator, t);
    tinker_waveform_evaluate(evaluator, t, result);
    return result[0];
}

static void choose_file(Panel *panel, const char *group, const char *path)
{
    g_autoptr(TinkerPropertyRow) row = find_row(panel, group, "Type");
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    g_assert_cmpint(row->file_choice, ==, (int)g_strv_length(row->choices) - 1);
    tinker_property_row_choose_file(panel->document, row, path, &error);
    g_assert_no_error(error);
}

/* The table record.csv of the scene's folder. */
static void choose_record(Panel *panel, const char *group)
{
    g_autofree char *path = g_build_filename(panel->folder, "record.csv", NULL);
    choose_file(panel, group, path);
}

static void set(Panel *panel, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = find_row(panel, group, title);
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    if (row->kind == TINKER_ROW_CHOICE)
        tinker_property_row_choose(panel->document, row, g_str_equal(row->choices[1], text) ? 1 : 0, &error);
    else
        tinker_property_row_set(panel->document, row, text, &error);
    g_assert_no_error(error);
}

/* One step leads back to the very text, and there was none before it. */
static void assert_one_step(Panel *panel, const char *before)
{
    g_autofree char *after = scene_text(panel);
    g_assert_cmpstr(after, !=, before);
    tinker_document_undo(panel->document);
    g_autofree char *undone = scene_text(panel);
    g_assert_cmpstr(undone, ==, before);
    g_assert_null(tinker_history_can_undo(tinker_document_history(panel->document)));
    tinker_document_redo(panel->document);
    g_autofree char *redone = scene_text(panel);
    g_assert_cmpstr(redone, ==, after);
}

static int compare_names(const void *left, const void *right)
{
    return g_strcmp0(*(const char *const *)left, *(const char *const *)right);
}

/* The names in the scene's folder, sorted, with blanks between them. (transfer full) */
static char *names_in_folder(Panel *panel)
{
    g_autoptr(GDir) dir = g_dir_open(panel->folder, 0, NULL);
    g_autoptr(GPtrArray) names = g_ptr_array_new_with_free_func(g_free);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir))
        g_ptr_array_add(names, g_strdup(name));
    g_ptr_array_sort(names, compare_names);
    g_ptr_array_add(names, NULL);
    return g_strjoinv(" ", (char **)names->pdata);
}

static void assert_names(Panel *panel, const char *names)
{
    g_autofree char *there = names_in_folder(panel);
    g_assert_cmpstr(there, ==, names);
}

/* Neither may change anything; the sentence has the part. */
static void assert_file_refused(Panel *panel, const char *path, const char *part)
{
    g_autoptr(TinkerPropertyRow) row = find_row(panel, "Force", "Type");
    g_autoptr(GError) checked = NULL, refused = NULL;
    g_autofree char *before = scene_text(panel), *files = names_in_folder(panel), *copy = NULL;
    const char *step = tinker_history_can_undo(tinker_document_history(panel->document));
    g_assert_false(tinker_property_row_check_file(panel->document, row, path, &copy, &checked));
    g_assert_null(copy);
    g_assert_nonnull(strstr(checked->message, part));
    g_assert_false(tinker_property_row_choose_file(panel->document, row, path, &refused));
    g_assert_nonnull(strstr(refused->message, part));
    g_autofree char *after = scene_text(panel);
    g_assert_cmpstr(after, ==, before);
    g_assert_true(tinker_history_can_undo(tinker_document_history(panel->document)) == step);
    assert_names(panel, files);
}

/* Choosing --------------------------------------------------------------------------------------------------------- */

static void test_chosen(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), RECORD, "F");
    g_autofree char *before = scene_text(&panel);
    assert_absent(&panel, "Force", "File");
    choose_record(&panel, "Force");
    assert_one_step(&panel, before);
    assert_shown(&panel, "Force", "Type", "Table");
    assert_shown(&panel, "Force", "File", "record.csv");
    assert_shown(&panel, "Force", "Rows", "3");
    assert_shown(&panel, "Force", "Column", "1");
    assert_shown(&panel, "Force", "Scale", "1");
    assert_absent(&panel, "Force", "Kind"); /* a force is no place */
    assert_written(&panel, "\"waveform\": {\"table\": \"record.csv\"}");
    assert_names(&panel, "record.csv scene.tinker.json");
    g_assert_cmpfloat(reopened_value(&panel, "F", 0.5), ==, 1);
    g_assert_cmpfloat(reopened_value(&panel, "F", 2), ==, 4);
}

static void test_column_and_scale(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), RECORD, "F");
    choose_record(&panel, "Force");
    set(&panel, "Force", "Scale", "-0.5");
    g_assert_cmpfloat(reopened_value(&panel, "F", 2), ==, -2);
    set(&panel, "Force", "Column", "2");
    assert_written(&panel, "{\"table\": \"record.csv\", \"column\": 2, \"scale\": -0.5}");
    g_assert_cmpfloat(reopened_value(&panel, "F", 2), ==, -1);

    /* Refused: the former column stays. */
    static const char *const wrong[][2] = {{"3", "record.csv:2:6: the value is missing (column 3)"},
                                           {"0", "whole number from 1"},
                                           {"1.5", "whole number from 1"},
                                           {"1e300", "whole number from 1"},
                                           {"two", "number"}};
    g_autofree char *before = scene_text(&panel);
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autoptr(TinkerPropertyRow) column = find_row(&panel, "Force", "Column");
        g_autoptr(GError) error = NULL;
        g_assert_false(tinker_property_row_set(panel.document, column, wrong[i][0], &error));
        if (strstr(error->message, wrong[i][1]) == NULL) g_error("“%s” lacks “%s”", error->message, wrong[i][1]);
        g_autofree char *after = scene_text(&panel);
        g_assert_cmpstr(after, ==, before);
    }
}

/* A constant acceleration of 2 m/s^2 from rest moves the support by t^2. The motion is a block of its own, added in the
 * same step. */
static void test_motion_by_acceleration(void)
{
    g_auto(Panel) panel = panel_with(SUPPORT, RECORD, "S");
    g_autofree char *before = scene_text(&panel);
    choose_record(&panel, "Motion");
    assert_one_step(&panel, before);
    assert_shown(&panel, "Motion", "Kind", "Displacement");
    TinkerScene *scene = tinker_document_scene(panel.document);
    const char *motion = tinker_scene_block_name(scene, tinker_scene_block_at(scene, 1));
    g_assert_cmpfloat(reopened_value(&panel, motion, 2), ==, 4);
    set(&panel, "Motion", "Column", "2");
    set(&panel, "Motion", "Kind", "Acceleration");
    g_assert_cmpfloat_with_epsilon(reopened_value(&panel, motion, 1), 1, 1e-14);
    g_assert_cmpfloat_with_epsilon(reopened_value(&panel, motion, 2.5), 6.25, 1e-14);
}

/* Another table is read as the one before it, and what another program has written of that is kept. */
static void test_another(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(", \"waveform\": {\"note\": [1, 1e400], \"table\": \"record.csv\", "
                                           "\"column\": 2, \"scale\": \"3\"}"),
                                     RECORD, "F");
    g_autofree char *other = g_build_filename(panel.folder, "other.csv", NULL);
    g_assert_true(g_file_set_contents(other, "0;1;5\n", -1, NULL));
    choose_file(&panel, "Force", other);
    assert_shown(&panel, "Force", "Rows", "1");
    assert_written(&panel, "{\"table\": \"other.csv\", \"column\": 2, \"scale\": 3, \"note\": [1, 1e400]}");
    g_assert_cmpfloat(reopened_value(&panel, "F", 7), ==, 15);
}

/* The same file is read anew where another program has written it. */
static void test_read_anew(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), RECORD, "F");
    g_autofree char *path = g_build_filename(panel.folder, "record.csv", NULL);
    choose_file(&panel, "Force", path);
    g_assert_true(g_file_set_contents(path, "0 1\n1 2\n2 3\n3 4\n", -1, NULL));
    choose_file(&panel, "Force", path);
    assert_shown(&panel, "Force", "Rows", "4");
}

static void test_several(void)
{
    g_auto(Panel) panel = panel_with(MOTOR("}, {\"type\": \"motor\", \"name\": \"G\", \"ends\": [\"M\"]"), RECORD, "F");
    TinkerScene *scene = tinker_document_scene(panel.document);
    const TinkerBlockId both[] = {tinker_scene_find_block(scene, "F"), tinker_scene_find_block(scene, "G")};
    tinker_document_select_all_of(panel.document, both, 2);
    g_autofree char *before = scene_text(&panel);
    choose_record(&panel, "Force");
    assert_one_step(&panel, before);
    assert_shown(&panel, "Force", "Rows", "3");
    set(&panel, "Force", "Column", "2");
    g_assert_cmpfloat(reopened_value(&panel, "F", 1), ==, 2);
    g_assert_cmpfloat(reopened_value(&panel, "G", 2), ==, 2);
    tinker_document_select(panel.document, both[0]);
    set(&panel, "Force", "Column", "1");
    tinker_document_select_all_of(panel.document, both, 2);
    assert_absent(&panel, "Force", "Column"); /* they differ */
}

/* Where the file is ------------------------------------------------------------------------------------------------ */

static void test_in_a_folder_within(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), NULL, "F");
    g_autofree char *data = g_build_filename(panel.folder, "data", NULL);
    g_autofree char *path = g_build_filename(data, "tab\"le.csv", NULL);
    g_assert_cmpint(g_mkdir(data, 0700), ==, 0);
    g_assert_true(g_file_set_contents(path, RECORD, -1, NULL));
    choose_file(&panel, "Force", path);
    assert_shown(&panel, "Force", "File", "data/tab\"le.csv");
    g_assert_cmpfloat(reopened_value(&panel, "F", 2), ==, 4);
    assert_names(&panel, "data scene.tinker.json");
}

static char *copy_name(Panel *panel, const char *path)
{
    g_autoptr(TinkerPropertyRow) row = find_row(panel, "Force", "Type");
    g_autoptr(GError) error = NULL;
    char *name;
    tinker_property_row_check_file(panel->document, row, path, &name, &error);
    g_assert_no_error(error);
    return name;
}

static void test_copied(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), NULL, "F");
    g_autofree char *path = files_fixture_file("record.csv", RECORD);
    g_autofree char *name = copy_name(&panel, path);
    g_assert_cmpstr(name, ==, "record.csv");
    assert_names(&panel, "scene.tinker.json"); /* asking makes nothing */
    choose_file(&panel, "Force", path);
    assert_names(&panel, "record.csv scene.tinker.json");
    g_assert_cmpfloat(reopened_value(&panel, "F", 2), ==, 4);
    choose_file(&panel, "Force", path); /* it is there already */
    assert_names(&panel, "record.csv scene.tinker.json");
    g_autofree char *kept = NULL;
    g_assert_true(g_file_get_contents(path, &kept, NULL, NULL));
    g_assert_cmpstr(kept, ==, RECORD);
}

/* Another file of that name stays as it is; so does a link, also one to the very table, which no scene may read. */
static void test_never_overwritten(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), "mine", "F");
    g_autofree char *path = files_fixture_file("record.csv", RECORD), *text = NULL;
    g_autofree char *own = g_build_filename(panel.folder, "record.csv", NULL);
    g_autofree char *link = g_build_filename(panel.folder, "record-2.csv", NULL);
    g_assert_cmpint(symlink(path, link), ==, 0);
    g_autofree char *name = copy_name(&panel, path), *through_link = copy_name(&panel, link);
    g_assert_cmpstr(name, ==, "record-3.csv");
    g_assert_cmpstr(through_link, ==, "record-2-2.csv");
    choose_file(&panel, "Force", path);
    assert_shown(&panel, "Force", "File", "record-3.csv");
    g_assert_cmpfloat(reopened_value(&panel, "F", 2), ==, 4);
    g_assert_true(g_file_get_contents(own, &text, NULL, NULL));
    g_assert_cmpstr(text, ==, "mine");
    g_assert_true(g_file_test(link, G_FILE_TEST_IS_SYMLINK));
}

/* Refusing --------------------------------------------------------------------------------------------------------- */

static void test_refused(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(", \"waveform\": \"cosine\""), "time,x\n0,1\n1,one\n", "F");
    g_autofree char *here = g_build_filename(panel.folder, "record.csv", NULL);
    g_autofree char *elsewhere = files_fixture_file("falling.csv", "0,1\n2,3\n1,3\n");
    g_autofree char *empty = files_fixture_file("empty.csv", "");
    assert_file_refused(&panel, here, "record.csv:3:3: the value must be a number, not \"one\"");
    assert_file_refused(&panel, elsewhere, "falling.csv:3:1: the time 1 must be greater than 2");
    assert_file_refused(&panel, empty, "no rows of numbers");
    assert_file_refused(&panel, panel.folder, "must be a file");
    assert_file_refused(&panel, "/nowhere/at/all.csv", "/nowhere/at/all.csv");
    assert_shown(&panel, "Force", "Type", "Cosine");
}

/* No JSON text can hold such a name: where it lies it is refused, but a copy gets another one. */
static void test_name_that_is_no_text(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), NULL, "F");
    g_autofree char *here = g_build_filename(panel.folder, "\xff.csv", NULL);
    g_autofree char *elsewhere = files_fixture_file("\xfe.csv", RECORD);
    g_autofree char *before = scene_text(&panel);
    g_autoptr(TinkerPropertyRow) row = find_row(&panel, "Force", "Type");
    g_autoptr(GError) error = NULL;
    g_assert_true(g_file_set_contents(here, RECORD, -1, NULL));
    g_assert_false(tinker_property_row_choose_file(panel.document, row, here, &error));
    g_assert_nonnull(strstr(error->message, "UTF-8"));
    g_autofree char *after = scene_text(&panel);
    g_assert_cmpstr(after, ==, before);
    choose_file(&panel, "Force", elsewhere);
    assert_shown(&panel, "Force", "File", "\xef\xbf\xbd.csv");
    g_assert_cmpfloat(reopened_value(&panel, "F", 2), ==, 4);
}

static void test_not_saved_yet(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(""), RECORD, "F");
    g_autofree char *path = g_build_filename(panel.folder, "record.csv", NULL);
    const char *text = MOTOR("");
    g_assert_true(tinker_document_start(panel.document, text, strlen(text), path, NULL));
    tinker_document_select(panel.document, tinker_scene_find_block(tinker_document_scene(panel.document), "F"));
    assert_file_refused(&panel, path, "Save the scene first");
}

/* The file went away after it was read: it cannot be read in another way, and what was read is kept. */
static void test_file_is_gone(void)
{
    g_auto(Panel) panel = panel_with(MOTOR(", \"waveform\": {\"table\": \"record.csv\"}"), RECORD, "F");
    g_autofree char *path = g_build_filename(panel.folder, "record.csv", NULL);
    g_autoptr(TinkerPropertyRow) scale = find_row(&panel, "Force", "Scale");
    g_autoptr(GError) error = NULL;
    g_assert_cmpint(g_unlink(path), ==, 0);
    g_assert_false(tinker_property_row_set(panel.document, scale, "2", &error));
    g_assert_nonnull(strstr(error->message, "record.csv"));
    assert_shown(&panel, "Force", "Rows", "3");
    assert_shown(&panel, "Force", "Scale", "1");
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-table/chosen", test_chosen);
    g_test_add_func("/gui/property-table/column-and-scale", test_column_and_scale);
    g_test_add_func("/gui/property-table/motion-by-acceleration", test_motion_by_acceleration);
    g_test_add_func("/gui/property-table/another", test_another);
    g_test_add_func("/gui/property-table/read-anew", test_read_anew);
    g_test_add_func("/gui/property-table/several", test_several);
    g_test_add_func("/gui/property-table/in-a-folder-within", test_in_a_folder_within);
    g_test_add_func("/gui/property-table/copied", test_copied);
    g_test_add_func("/gui/property-table/never-overwritten", test_never_overwritten);
    g_test_add_func("/gui/property-table/refused", test_refused);
    g_test_add_func("/gui/property-table/name-that-is-no-text", test_name_that_is_no_text);
    g_test_add_func("/gui/property-table/not-saved-yet", test_not_saved_yet);
    g_test_add_func("/gui/property-table/file-is-gone", test_file_is_gone);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
