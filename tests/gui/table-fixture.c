#include "table-fixture.h"

#include "property-rows.h"

TablePanel table_panel_with(const char *scene, const char *record, const char *selected)
{
    g_autofree char *path = files_fixture_file("scene.tinker.json", scene);
    TablePanel panel = {.document = tinker_document_new(files_fixture_catalogue()), .folder = g_path_get_dirname(path)};
    g_autofree char *table = g_build_filename(panel.folder, "record.csv", NULL);
    g_autoptr(GError) error = NULL;
    if (record != NULL) g_assert_true(g_file_set_contents(table, record, -1, NULL));
    tinker_document_open(panel.document, path, NULL, &error);
    g_assert_no_error(error);
    panel.player = tinker_player_new(panel.document);
    tinker_document_select(panel.document, tinker_scene_find_block(tinker_document_scene(panel.document), selected));
    return panel;
}

void table_panel_clear(TablePanel *panel)
{
    g_clear_object(&panel->player);
    g_clear_object(&panel->document);
    g_clear_pointer(&panel->folder, g_free);
}

TinkerPropertyRow *table_panel_find_row(TablePanel *panel, const char *group, const char *title)
{
    return property_rows_find(panel->document, panel->player, FALSE, group, title);
}

void table_panel_assert_shown(TablePanel *panel, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = table_panel_find_row(panel, group, title);
    g_assert_nonnull(row);
    g_assert_cmpstr(row->kind == TINKER_ROW_CHOICE ? row->choices[row->chosen] : row->text, ==, text);
}

void table_panel_assert_absent(TablePanel *panel, const char *group, const char *title)
{
    g_autoptr(TinkerPropertyRow) row = table_panel_find_row(panel, group, title);
    g_assert_null(row);
}

char *table_panel_scene_text(TablePanel *panel)
{
    return tinker_scene_to_text(tinker_document_scene(panel->document), TINKER_WRITE_SI);
}

double table_panel_reopened_value(TablePanel *panel, const char *name, double t)
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

void table_panel_choose_file(TablePanel *panel, const char *group, const char *path)
{
    g_autoptr(TinkerPropertyRow) row = table_panel_find_row(panel, group, "Type");
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    g_assert_cmpint(row->file_choice, ==, (int)g_strv_length(row->choices) - 1);
    tinker_property_row_choose_file(panel->document, row, path, &error);
    g_assert_no_error(error);
}

void table_panel_set(TablePanel *panel, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = table_panel_find_row(panel, group, title);
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    if (row->kind == TINKER_ROW_CHOICE)
        tinker_property_row_choose(panel->document, row, property_rows_choice(row, text), &error);
    else
        tinker_property_row_set(panel->document, row, text, &error);
    g_assert_no_error(error);
}

static int compare_names(const void *left, const void *right)
{
    return g_strcmp0(*(const char *const *)left, *(const char *const *)right);
}

char *table_panel_names_in_folder(TablePanel *panel)
{
    g_autoptr(GDir) dir = g_dir_open(panel->folder, 0, NULL);
    g_autoptr(GPtrArray) names = g_ptr_array_new_with_free_func(g_free);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir))
        g_ptr_array_add(names, g_strdup(name));
    g_ptr_array_sort(names, compare_names);
    g_ptr_array_add(names, NULL);
    return g_strjoinv(" ", (char **)names->pdata);
}

void table_panel_assert_names(TablePanel *panel, const char *names)
{
    g_autofree char *there = table_panel_names_in_folder(panel);
    g_assert_cmpstr(there, ==, names);
}
