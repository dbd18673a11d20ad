#include "files-fixture.h"
#include "folders.h"

#include <gio/gio.h>
#include <glib/gstdio.h>
#include <string.h>

static TinkerCatalogue *catalogue;
static char *root;

const char files_fixture_scene[] = "{\"tinker\": 1, \"title\": \"A swing\", \"blocks\": [\n"
                                   "  {\"type\": \"support\", \"name\": \"Ceiling\", \"position\": [0, 4]},\n"
                                   "  {\"type\": \"mass\", \"name\": \"Weight\", \"position\": [0, 2]},\n"
                                   "  {\"type\": \"spring\", \"name\": \"Coil\", \"ends\": [\"Ceiling\", \"Weight\"]}\n"
                                   "]}\n";

TinkerCatalogue *files_fixture_catalogue(void)
{
    return catalogue;
}

char *files_fixture_folder(void)
{
    static int number;
    g_autofree char *name = g_strdup_printf("%d", ++number);
    char *folder = g_build_filename(root, name, NULL);
    g_assert_cmpint(g_mkdir(folder, 0700), ==, 0);
    return folder;
}

char *files_fixture_file(const char *name, const char *text)
{
    g_autofree char *folder = files_fixture_folder();
    char *path = g_build_filename(folder, name, NULL);
    g_assert_true(g_file_set_contents(path, text, -1, NULL));
    return path;
}

TinkerDocument *files_fixture_document(void)
{
    g_autoptr(GError) error = NULL;
    TinkerDocument *document = tinker_document_new(catalogue);
    tinker_document_start(document, files_fixture_scene, strlen(files_fixture_scene), NULL, &error);
    g_assert_no_error(error);
    return document;
}

void files_fixture_rename(TinkerDocument *document, const char *name)
{
    g_autoptr(GError) error = NULL;
    TinkerBlockId first = tinker_scene_block_at(tinker_document_scene(document), 0);
    tinker_document_begin(document, "Rename", NULL);
    tinker_history_rename_block(tinker_document_history(document), first, name, &error);
    g_assert_no_error(error);
    tinker_document_end(document);
}

const char *files_fixture_first_name(TinkerDocument *document)
{
    TinkerScene *scene = tinker_document_scene(document);
    return tinker_scene_block_name(scene, tinker_scene_block_at(scene, 0));
}

static void open_catalogue(void)
{
    const char *folders[] = {g_getenv("TINKER_TEST_PLUGINS"), NULL};
    const TinkerCatalogueOptions options = {.folders = folders, .probe_program = g_getenv("TINKER_PROGRAM")};
    catalogue = tinker_catalogue_new(&options);
}

int files_fixture_main(int argc, char **argv, void (*add_tests)(void), void (*child)(const char *word))
{
    if (argc > 2 && g_str_equal(argv[1], "child")) {
        open_catalogue();
        child(argv[2]);
        tinker_catalogue_free(catalogue);
        return 0;
    }
    root = g_dir_make_tmp("tinker-gui-XXXXXX", NULL);
    g_autofree char *state = g_build_filename(root, "state", NULL);
    g_setenv("XDG_STATE_HOME", state, TRUE);
    g_test_init(&argc, &argv, NULL);
    open_catalogue();
    add_tests();
    int status = g_test_run();
    tinker_catalogue_free(catalogue);
    test_remove_all(root);
    g_free(root);
    return status;
}
