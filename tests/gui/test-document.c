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

/* The file dialog asks about any file of the name; what drives the scene is not to be had for the asking. */
static void test_table_stays(void)
{
    static const char scene[] = "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"motor\", \"ends\": "
                                "[\"Mass 0\"], \"waveform\": {\"table\": \"motion.csv\"}}]}";
    static const char table[] = "0,1\n1,2\n";
    g_autoptr(GError) error = NULL;
    g_autofree char *path = files_fixture_file("driven.tinker.json", scene), *folder = g_path_get_dirname(path);
    g_autofree char *motion = g_build_filename(folder, "motion.csv", NULL), *kept = NULL;
    g_assert_true(g_file_set_contents(motion, table, -1, NULL));
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_document_open(document, path, NULL, &error));
    g_assert_false(tinker_document_save(document, motion, &error));
    g_assert_nonnull(strstr(error->message, motion));
    g_assert_true(g_file_get_contents(motion, &kept, NULL, NULL));
    g_assert_cmpstr(kept, ==, table);
    g_assert_cmpstr(tinker_document_path(document), ==, path);
    g_assert_true(tinker_document_save(document, path, NULL));
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

static void count(TinkerDocument *document, int *times)
{
    ++*times;
}

/* However many blocks an edit is of, those who listen are told once. */
static void test_several(void)
{
    g_autoptr(TinkerDocument) document = files_fixture_document();
    TinkerScene *scene = tinker_document_scene(document);
    g_autofree TinkerBlockId *all = g_new(TinkerBlockId, 100);
    int changes = 0, selections = 0;
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, tinker_scene_block_at(scene, 0));
    const int blocks = tinker_scene_block_count(scene);
    for (int i = 0; i < 100; i++)
        all[i] = tinker_scene_add_block(scene, block_class, NULL, NULL);
    tinker_document_select_all_of(document, all, 100);
    g_signal_connect(document, "changed", G_CALLBACK(count), &changes);
    g_signal_connect(document, "selection-changed", G_CALLBACK(count), &selections);
    tinker_document_move_selected(document, 1, 1, NULL);
    g_assert_cmpint(changes, ==, 1);
    g_assert_cmpint(selections, ==, 0);
    tinker_document_remove_selected(document);
    g_assert_cmpint(changes, ==, 2);
    g_assert_cmpint(selections, ==, 1);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, blocks);
    tinker_document_undo(document);
    g_assert_cmpint(changes, ==, 3);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, blocks + 100);
}

static void place_of(TinkerDocument *document, const char *name, double place[2])
{
    TinkerScene *scene = tinker_document_scene(document);
    const TinkerBlockId block = tinker_scene_find_block(scene, name);
    const int32_t column =
        tinker_block_class_meaning_column(tinker_scene_block_class(scene, block), TINKER_MEANING_POSITION);
    for (int k = 0; k < 2; k++)
        place[k] = tinker_scene_get(scene, block, column + k);
}

/* What lies on a support that is selected, too, goes as far as that, whichever was selected first, and goes on lying on
 * it. */
static void test_lies_on_what_moves(void)
{
    static const char text[] = "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Floor\"}, "
                               "{\"type\": \"mass\", \"name\": \"Box\", \"on\": \"Floor\", \"along\": 1}]}";
    for (int order = 0; order < 2; order++) {
        g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
        g_assert_true(tinker_document_start(document, text, strlen(text), NULL, NULL));
        TinkerScene *scene = tinker_document_scene(document);
        const TinkerBlockId both[] = {tinker_scene_find_block(scene, order == 0 ? "Floor" : "Box"),
                                      tinker_scene_find_block(scene, order == 0 ? "Box" : "Floor")};
        double from[2], to[2], along;
        TinkerBlockId plate;
        place_of(document, "Box", from);
        tinker_document_select_all_of(document, both, 2);
        tinker_document_move_selected(document, 3, -2, NULL);
        place_of(document, "Box", to);
        g_assert_cmpfloat_with_epsilon(to[0] - from[0], 3, 1e-14);
        g_assert_cmpfloat_with_epsilon(to[1] - from[1], -2, 1e-14);
        g_assert_true(tinker_scene_lies_on(scene, tinker_scene_find_block(scene, "Box"), &plate, &along));
    }
}

/* Of one contact the normal force is told from friction, and either from that on another body; all of its block lights
 * up with it. What is gone is pointed at no more. */
static void test_pointed(void)
{
    g_autoptr(TinkerDocument) document = files_fixture_document();
    const TinkerBlockId block = tinker_scene_block_at(tinker_document_scene(document), 0);
    const TinkerPointed nothing = tinker_pointed_block(TINKER_NO_BLOCK), whole = tinker_pointed_block(block);
    const TinkerPointed normal = {block, 7, TINKER_POINTED_NORMAL}, friction = {block, 7, TINKER_POINTED_FRICTION};
    const TinkerPointed elsewhere = {block, 8, TINKER_POINTED_NORMAL}, other = tinker_pointed_block(block + 1);
    const TinkerPointed *pointed = tinker_document_pointed(document);
    int told = 0;
    g_signal_connect(document, "pointed-changed", G_CALLBACK(count), &told);
    g_assert_false(tinker_pointed_lights(pointed, &whole));
    tinker_document_point(document, normal);
    tinker_document_point(document, normal);
    g_assert_cmpint(told, ==, 1);
    pointed = tinker_document_pointed(document);
    g_assert_true(tinker_pointed_is_force(pointed));
    g_assert_true(tinker_pointed_lights(pointed, &normal));
    g_assert_true(tinker_pointed_lights(pointed, &whole));
    g_assert_false(tinker_pointed_lights(pointed, &friction));
    g_assert_false(tinker_pointed_lights(pointed, &elsewhere));
    g_assert_false(tinker_pointed_lights(pointed, &other));
    g_assert_false(tinker_pointed_lights(pointed, &nothing));
    tinker_document_point_away(document, friction);
    g_assert_cmpint(told, ==, 1);
    tinker_document_point(document, whole);
    g_assert_true(tinker_pointed_lights(tinker_document_pointed(document), &friction));
    tinker_document_point_away(document, whole);
    g_assert_cmpint(tinker_document_pointed(document)->block, ==, TINKER_NO_BLOCK);
    tinker_document_point(document, whole);
    tinker_document_select(document, block);
    tinker_document_remove_selected(document);
    g_assert_cmpint(tinker_document_pointed(document)->block, ==, TINKER_NO_BLOCK);
}

static void add_tests(void)
{
    g_test_add_func("/gui/document/modified", test_modified);
    g_test_add_func("/gui/document/placeholders", test_placeholders);
    g_test_add_func("/gui/document/findings", test_findings);
    g_test_add_func("/gui/document/changed-on-disk", test_changed_on_disk);
    g_test_add_func("/gui/document/save-fails", test_save_fails);
    g_test_add_func("/gui/document/tables-go-along", test_tables_go_along);
    g_test_add_func("/gui/document/table-stays", test_table_stays);
    g_test_add_func("/gui/document/recovered", test_recovered);
    g_test_add_func("/gui/document/interrupted", test_interrupted);
    g_test_add_func("/gui/document/several", test_several);
    g_test_add_func("/gui/document/pointed", test_pointed);
    g_test_add_func("/gui/document/lies-on-what-moves", test_lies_on_what_moves);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
