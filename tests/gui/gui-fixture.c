#include "gui-fixture.h"

#include <string.h>

void gui_fixture_start_scene(GuiFixture *fixture, const char *members)
{
    g_autofree char *text = g_strdup_printf("{\"tinker\": 1, %s}", members);
    g_autoptr(GError) error = NULL;
    g_strdelimit(text, "'", '"');
    if (!tinker_document_start(fixture->document, text, strlen(text), NULL, &error)) g_error("%s", error->message);
}

void gui_fixture_start(GuiFixture *fixture, const char *blocks)
{
    g_autofree char *members = g_strdup_printf("'blocks': [\n%s]", blocks);
    gui_fixture_start_scene(fixture, members);
}

GuiFixture *gui_fixture_new(const char *blocks)
{
    GuiFixture *fixture = g_new0(GuiFixture, 1);
    fixture->document = tinker_document_new(scene_fixture_catalogue());
    fixture->player = tinker_player_new(fixture->document);
    gui_fixture_start(fixture, blocks);
    return fixture;
}

void gui_fixture_free(GuiFixture *fixture)
{
    g_object_unref(fixture->player);
    g_object_unref(fixture->document);
    g_free(fixture);
}

char *gui_fixture_text(GuiFixture *fixture)
{
    return tinker_scene_to_text(tinker_document_scene(fixture->document), TINKER_WRITE_SI);
}

TinkerBlockId gui_fixture_block(GuiFixture *fixture, const char *name)
{
    TinkerBlockId block = tinker_scene_find_block(tinker_document_scene(fixture->document), name);
    if (block == TINKER_NO_BLOCK) g_error("no block is called %s", name);
    return block;
}

double gui_fixture_get(GuiFixture *fixture, const char *name, int32_t meaning, int32_t component)
{
    TinkerScene *scene = tinker_document_scene(fixture->document);
    TinkerBlockId block = gui_fixture_block(fixture, name);
    int32_t column = tinker_block_class_meaning_column(tinker_scene_block_class(scene, block), meaning);
    g_assert_cmpint(column, >=, 0);
    return tinker_scene_get(scene, block, column + component);
}

void gui_fixture_set(GuiFixture *fixture, const char *name, const char *property, double x, double y)
{
    TinkerBlockId block = gui_fixture_block(fixture, name);
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_document_scene(fixture->document), block);
    int32_t number = tinker_block_class_property(block_class, property);
    tinker_document_begin(fixture->document, "Set", NULL);
    g_assert_true(
        tinker_history_set(tinker_document_history(fixture->document), block, number, (double[]){x, y}, NULL));
    tinker_document_end(fixture->document);
}

static gboolean on_time(gpointer data)
{
    *(gboolean *)data = TRUE;
    return G_SOURCE_CONTINUE;
}

static gboolean never(void *data)
{
    return FALSE;
}

static gboolean wait_for(gboolean (*is_so)(void *data), void *data, guint milliseconds)
{
    gboolean over = FALSE;
    guint timer = g_timeout_add(milliseconds, on_time, &over);
    while (!over && !is_so(data))
        g_main_context_iteration(NULL, TRUE);
    g_source_remove(timer);
    return !over;
}

gboolean gui_fixture_wait(gboolean (*is_so)(void *data), void *data)
{
    return wait_for(is_so, data, 10000);
}

void gui_fixture_pass(guint milliseconds)
{
    wait_for(never, NULL, milliseconds);
}
