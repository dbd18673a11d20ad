#include "panel-fixture.h"

#include <string.h>

#include "property-rows.h"

void panel_select(GuiFixture *fixture, const char *name)
{
    tinker_document_select(fixture->document, gui_fixture_block(fixture, name));
}

void panel_select_nothing(GuiFixture *fixture)
{
    tinker_document_select(fixture->document, TINKER_NO_BLOCK);
}

double panel_stored(GuiFixture *fixture, const char *name, const char *id, int component)
{
    TinkerScene *scene = tinker_document_scene(fixture->document);
    TinkerBlockId block = gui_fixture_block(fixture, name);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    int32_t property = tinker_block_class_property(block_class, id);
    g_assert_cmpint(property, >=, 0);
    return tinker_scene_get(scene, block, block_class->first_columns[property] + component);
}

TinkerPropertyRow *panel_find_row(GuiFixture *fixture, const char *group, const char *title)
{
    return property_rows_find(fixture->document, fixture->player, fixture->trims, group, title);
}

void panel_assert_shown(GuiFixture *fixture, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = panel_find_row(fixture, group, title);
    g_assert_nonnull(row);
    g_assert_cmpstr(row->text, ==, text);
}

void panel_assert_sensitive(GuiFixture *fixture, const char *group, const char *title, gboolean sensitive)
{
    g_autoptr(TinkerPropertyRow) row = panel_find_row(fixture, group, title);
    g_assert_nonnull(row);
    g_assert_cmpint(row->sensitive, ==, sensitive);
}

void panel_assert_undoes(GuiFixture *fixture, const char *before)
{
    g_autofree char *after = gui_fixture_text(fixture);
    g_assert_cmpstr(after, !=, before);
    tinker_document_undo(fixture->document);
    g_autofree char *undone = gui_fixture_text(fixture);
    g_assert_cmpstr(undone, ==, before);
    g_assert_null(tinker_history_can_undo(tinker_document_history(fixture->document)));
    tinker_document_redo(fixture->document);
    g_autofree char *redone = gui_fixture_text(fixture);
    g_assert_cmpstr(redone, ==, after);
    tinker_document_undo(fixture->document);
    tinker_document_redo(fixture->document);
}

void panel_type(GuiFixture *fixture, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = panel_find_row(fixture, group, title);
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    tinker_property_row_set(fixture->document, row, text, &error);
    g_assert_no_error(error);
}

void panel_choose(GuiFixture *fixture, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = panel_find_row(fixture, group, title);
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    tinker_property_row_choose(fixture->document, row, property_rows_choice(row, text), &error);
    g_assert_no_error(error);
}

void panel_assert_refused(GuiFixture *fixture, const char *group, const char *title, const char *text,
                          const char *const *parts)
{
    g_autoptr(TinkerPropertyRow) row = panel_find_row(fixture, group, title);
    g_autoptr(GError) error = NULL;
    g_autofree char *before = gui_fixture_text(fixture);
    const char *undo = tinker_history_can_undo(tinker_document_history(fixture->document));
    g_autofree char *last = g_strdup(undo);
    g_assert_nonnull(row);
    if (row->choices != NULL)
        g_assert_false(tinker_property_row_choose(fixture->document, row, property_rows_choice(row, text), &error));
    else
        g_assert_false(tinker_property_row_set(fixture->document, row, text, &error));
    g_assert_nonnull(error);
    for (; *parts != NULL; parts++)
        if (strstr(error->message, *parts) == NULL) g_error("“%s” lacks “%s”", error->message, *parts);
    g_assert_true(g_unichar_isupper(g_utf8_get_char(error->message)) || g_str_has_prefix(error->message, "“"));
    g_assert_nonnull(strchr(".?", error->message[strlen(error->message) - 1]));
    g_autofree char *after = gui_fixture_text(fixture);
    g_assert_cmpstr(after, ==, before);
    g_assert_cmpstr(tinker_history_can_undo(tinker_document_history(fixture->document)), ==, last);
}

void panel_go_english(GuiFixture *fixture)
{
    panel_select_nothing(fixture);
    panel_choose(fixture, "Scene", "Units", "English");
}
