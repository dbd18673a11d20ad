/* Documents and their files: what is saved is what was opened and edited, whatever happens on the way. */
#include <glib/gstdio.h>
#include <string.h>

#include "files-fixture.h"

static void test_modified(void)
{
    g_autofree char *folder = files_fixture_folder(), *path = g_build_filename(folder, "a.tinker.json", NULL);
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_assert_false(tinker_document_is_modified(document));
    files_fixture_rename(document, "One");
    g_assert_true(tinker_document_is_modified(document));
    tinker_document_undo(document);
    g_assert_false(tinker_document_is_modified(document));
    tinker_document_redo(document);
    g_assert_true(tinker_document_is_modified(document));
    g_assert_true(tinker_document_save(document, path, NULL));
    g_assert_false(tinker_document_is_modified(document));
    g_assert_cmpstr(tinker_document_path(document), ==, path);
    tinker_document_undo(document);
    g_assert_true(tinker_document_is_modified(document));
    tinker_document_redo(document);
    g_assert_false(tinker_document_is_modified(document));
}

/* What nobody provides is written back as it was, with what the reader did not know. */
static void test_placeholders(void)
{
    static const char text[] = "{\"tinker\": 1, \"blocks\": [\n"
                               "  {\"type\": \"gravity\", \"name\": \"Pull\"},\n"
                               "  {\"type\": \"mass\", \"name\": \"Weight\", \"position\": [0, 2]},\n"
                               "  {\"type\": \"flux-capacitor\", \"name\": \"Flux\", \"ends\": [\"Weight\"],"
                               " \"power\": \"1.21 GW\", \"list\": [1, {\"deep\": null}]}\n"
                               "]}\n";
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    g_autofree char *path = files_fixture_file("flux.tinker.json", text), *saved = NULL;
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    tinker_document_open(document, path, findings, &error);
    g_assert_no_error(error);
    g_assert_cmpuint(findings->len, ==, 1);
    g_assert_cmpint(((TinkerFinding *)findings->pdata[0])->code, ==, TINKER_SCENE_ERROR_TYPE);
    files_fixture_rename(document, "Heavy");
    g_assert_true(tinker_document_save(document, path, &error));
    g_assert_true(g_file_get_contents(path, &saved, NULL, NULL));
    static const char *const parts[] = {"flux-capacitor", "1.21 GW", "deep", "\"Flux\"", "\"Heavy\""};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        g_assert_nonnull(strstr(saved, parts[i]));
}

/* All mistakes are told with their places, and the document stays. */
static void test_findings(void)
{
    static const char text[] = "{\"tinker\": 1, \"blocks\": [\n"
                               "  {\"type\": \"mass\", \"name\": \"A\", \"mass\": -1},\n"
                               "  {\"type\": \"mass\", \"name\": \"A\"},\n"
                               "  {\"type\": \"spring\", \"ends\": [\"A\", \"Nobody\"]}\n"
                               "]}\n";
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) findings = tinker_findings_new();
    g_autofree char *path = files_fixture_file("wrong.tinker.json", text);
    g_autoptr(TinkerDocument) document = files_fixture_document();
    files_fixture_rename(document, "Edited");
    g_assert_false(tinker_document_open(document, path, findings, &error));
    g_assert_cmpuint(findings->len, ==, 3);
    for (guint i = 0; i < 3; i++)
        g_assert_cmpint(((TinkerFinding *)findings->pdata[i])->line, ==, (int)i + 2);
    g_assert_cmpstr(files_fixture_first_name(document), ==, "Edited");
    g_assert_true(tinker_document_is_modified(document));
    g_assert_null(tinker_document_path(document));
}

static void test_changed_on_disk(void)
{
    g_autofree char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    g_autofree char *other = g_strconcat(files_fixture_scene, "\n", NULL);
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_document_open(document, path, NULL, NULL));
    g_assert_false(tinker_document_changed_on_disk(document));
    g_assert_true(g_file_set_contents(path, files_fixture_scene, -1, NULL)); /* the same again */
    g_assert_false(tinker_document_changed_on_disk(document));
    g_assert_true(g_file_set_contents(path, other, -1, NULL));
    g_assert_true(tinker_document_changed_on_disk(document));
    g_assert_true(tinker_document_save(document, path, NULL));
    g_assert_false(tinker_document_changed_on_disk(document));
    g_assert_cmpint(g_unlink(path), ==, 0);
    g_assert_false(tinker_document_changed_on_disk(document));
}

static void test_save_fails(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = files_fixture_file("swing.tinker.json", files_fixture_scene), *kept = NULL;
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_document_open(document, path, NULL, NULL));
    files_fixture_rename(document, "Edited");
    g_assert_false(tinker_document_save(document, "/nowhere/at/all.tinker.json", &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE);
    g_assert_cmpstr(tinker_document_path(document), ==, path);
    g_assert_true(tinker_document_is_modified(document));
    g_assert_cmpstr(files_fixture_first_name(document), ==, "Edited");
    g_assert_true(g_file_get_contents(path, &kept, NULL, NULL));
    g_assert_cmpstr(kept, ==, files_fixture_scene);
}

/* A copy of the bundled scene that reads a table can be opened where it was saved. */
static void test_tables_go_along(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), "el-centro-block.tinker.json", NULL);
    g_autofree char *folder = files_fixture_folder(), *saved = g_build_filename(folder, "mine.tinker.json", NULL);
    g_autofree char *text = NULL, *table = g_build_filename(folder, "el-centro-1940-ns.csv", NULL);
    gsize length;
    g_assert_true(g_file_get_contents(path, &text, &length, NULL));
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    tinker_document_start(document, text, length, path, &error);
    g_assert_no_error(error);
    g_assert_null(tinker_document_path(document));
    tinker_document_save(document, saved, &error);
    g_assert_no_error(error);
    g_autoptr(TinkerDocument) reopened = tinker_document_new(files_fixture_catalogue());
    tinker_document_open(reopened, saved, NULL, &error);
    g_assert_no_error(error);

    /* Another table of that name is not overwritten. */
    g_assert_true(g_file_set_contents(table, "time,x\n0,0\n1,1\n", -1, NULL));
    g_autoptr(TinkerDocument) again = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_document_start(again, text, length, path, NULL));
    g_assert_false(tinker_document_save(again, saved, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE);
    g_assert_null(tinker_document_path(again));
}

static void test_recovered(void)
{
    g_autofree char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    TinkerDocumentOrigin origin = {path, path, (char *)"what the file held then"};
    g_assert_true(tinker_document_recover(document, files_fixture_scene, strlen(files_fixture_scene), &origin, NULL));
    g_assert_true(tinker_document_is_modified(document));
    g_assert_true(tinker_document_changed_on_disk(document));
    g_assert_true(tinker_document_save(document, path, NULL));
    g_assert_false(tinker_document_is_modified(document));
}

/* A drag keeps a step open; whatever else is done meanwhile comes before it. */
static void abort_step(TinkerDocument *document, int *times)
{
    ++*times;
    tinker_document_abort(document);
}

static void test_interrupted(void)
{
    g_autoptr(TinkerDocument) document = files_fixture_document();
    TinkerScene *scene = tinker_document_scene(document);
    TinkerBlockId first = tinker_scene_block_at(scene, 0);
    int times = 0;
    g_signal_connect(document, "interrupted", G_CALLBACK(abort_step), &times);
    files_fixture_rename(document, "Beam");
    g_assert_cmpint(times, ==, 0);
    tinker_document_select(document, first);
    g_autofree char *before = tinker_scene_to_text(scene, TINKER_WRITE_SI);

    void (*const commands[])(TinkerDocument * document) = {tinker_document_undo, tinker_document_redo,
                                                           tinker_document_interrupt};
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        tinker_document_begin(document, "Move", NULL);
        tinker_document_shift_selected(document, 1, 2);
        commands[i](document);
        g_assert_cmpint(times, ==, (int)i + 1);
        g_autofree char *after = tinker_scene_to_text(scene, TINKER_WRITE_SI);
        g_assert_cmpstr(after, ==, before);
    }
    tinker_document_begin(document, "Move", NULL);
    tinker_document_shift_selected(document, 1, 2);
    tinker_document_remove_selected(document);
    g_assert_false(tinker_scene_has_block(scene, first));
    tinker_document_undo(document);
    g_autofree char *undone = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_cmpstr(undone, ==, before);

    tinker_document_begin(document, "Move", NULL);
    g_assert_true(tinker_document_start(document, files_fixture_scene, strlen(files_fixture_scene), NULL, NULL));
    g_assert_cmpint(times, ==, 5);
    g_assert_false(tinker_document_is_modified(document));
}

static void add_tests(void)
{
    g_test_add_func("/gui/document/modified", test_modified);
    g_test_add_func("/gui/document/placeholders", test_placeholders);
    g_test_add_func("/gui/document/findings", test_findings);
    g_test_add_func("/gui/document/changed-on-disk", test_changed_on_disk);
    g_test_add_func("/gui/document/save-fails", test_save_fails);
    g_test_add_func("/gui/document/tables-go-along", test_tables_go_along);
    g_test_add_func("/gui/document/recovered", test_recovered);
    g_test_add_func("/gui/document/interrupted", test_interrupted);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
