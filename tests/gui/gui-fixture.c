/* A document needs no display. */
#include "gui-fixture.h"

#include <string.h>

static TinkerCatalogue *catalogue;

int gui_fixture_main(int argc, char **argv, void (*add_tests)(void))
{
    g_test_init(&argc, &argv, NULL);
    add_tests();
    int status = g_test_run();
    g_clear_pointer(&catalogue, tinker_catalogue_free);
    return status;
}

TinkerCatalogue *gui_fixture_catalogue(void)
{
    const TinkerCatalogueOptions options = {.probe_program = g_getenv("TINKER_PROGRAM")};
    if (catalogue == NULL) catalogue = tinker_catalogue_new(&options);
    return catalogue;
}

TinkerDocument *gui_fixture_document(const char *members)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *text = g_strdup_printf("{\"tinker\": 1, %s}", members);
    TinkerDocument *document = tinker_document_new(gui_fixture_catalogue());
    tinker_document_start(document, text, strlen(text), NULL, &error);
    g_assert_no_error(error);
    return document;
}

TinkerBlockId gui_fixture_block(TinkerDocument *document, const char *name)
{
    TinkerBlockId block = tinker_scene_find_block(tinker_document_scene(document), name);
    g_assert_cmpint(block, !=, TINKER_NO_BLOCK);
    return block;
}

void gui_fixture_set(TinkerDocument *document, const char *block, const char *property, double x, double y)
{
    TinkerBlockId id = gui_fixture_block(document, block);
    int32_t number =
        tinker_block_class_property(tinker_scene_block_class(tinker_document_scene(document), id), property);
    tinker_document_begin(document, "Set", NULL);
    g_assert_true(tinker_history_set(tinker_document_history(document), id, number, (double[]){x, y}, NULL));
    tinker_document_end(document);
}

char *gui_fixture_text(TinkerDocument *document)
{
    return tinker_scene_to_text(tinker_document_scene(document), TINKER_WRITE_SI);
}
