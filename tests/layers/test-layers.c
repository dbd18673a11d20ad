/* Which way the arrows point: who may include whom, as the table has it, how large folders are, and that no block is
 * known by name where none must be. */
#include <glib.h>
#include <string.h>

#include "layers-table.h"
#include "source-text.h"

/* Headers of C, POSIX and Linux that anybody may use; plugins and the SDK have those of C alone. */
static const char *const c_headers[] = {"assert.h",  "ctype.h",     "errno.h",  "fenv.h",   "float.h",  "inttypes.h",
                                        "libintl.h", "limits.h",    "locale.h", "math.h",   "stdarg.h", "stdbool.h",
                                        "stddef.h",  "stdint.h",    "stdio.h",  "stdlib.h", "string.h", "time.h",
                                        "complex.h", "stdatomic.h", NULL};
static const char *const system_headers[] = {"dlfcn.h",    "elf.h",      "fcntl.h", "grp.h",    "immintrin.h",
                                             "langinfo.h", "link.h",     "linux/",  "malloc.h", "poll.h",
                                             "pthread.h",  "pwd.h",      "sched.h", "signal.h", "sys/",
                                             "unistd.h",   "ucontext.h", "utime.h", NULL};

static const char *const block_ids[] = {"mass",  "support",        "spring",  "damper", "rod",
                                        "motor", "support-motion", "gravity", "wind",   NULL};

static char *source_path(const char *folder)
{
    return g_build_filename(g_getenv("TINKER_SOURCES"), folder, NULL);
}

static gboolean library_is_allowed(const Layer *layer, const char *header)
{
    if (g_strv_contains(c_headers, header) || source_begins_with_one_of(header, layer->libraries)) return TRUE;
    const gboolean bound_to_c = layer->core[0] == NULL;
    return !bound_to_c && source_begins_with_one_of(header, system_headers);
}

/* What is beside a template once it is written out. */
static gboolean is_of_templates(const Layer *layer, const char *header)
{
    g_autofree char *shared = source_path("sdk/templates/shared"), *path = g_build_filename(shared, header, NULL);
    return strcmp(layer->folder, "sdk/templates") == 0 && g_file_test(path, G_FILE_TEST_EXISTS);
}

static int room_number(const Rooms *rooms, const char *room)
{
    for (int i = 0; rooms->rooms[i] != NULL; i++)
        if (strcmp(rooms->rooms[i], room) == 0) return i;
    return -1;
}

/* "physics/plan/plan.h": a room uses itself and those before it, and no private header but its own; other folders use
 * the face. */
static gboolean room_is_allowed(const Rooms *rooms, const Layer *layer, const char *file_folder, const char *inside)
{
    g_autofree char *own_room = g_path_get_basename(file_folder), *room = g_path_get_dirname(inside);
    if (strcmp(layer->folder, rooms->folder) != 0) return g_strv_contains(rooms->face, inside);
    const int from = room_number(rooms, own_room), to = room_number(rooms, room);
    if (from < 0 || to < 0 || to > from) return FALSE;
    return to == from || !g_str_has_suffix(inside, "-private.h");
}

/* "scene/store/scene.h" of core, "common/film/film.h" of the hosts; "x.h" beside the file itself; a private header only
 * within its own folder. */
static gboolean own_is_allowed(const Layer *layer, const char *file_folder, const char *header)
{
    g_autofree char *beside = g_build_filename(file_folder, header, NULL);
    if (strchr(header, '/') == NULL && g_file_test(beside, G_FILE_TEST_EXISTS)) return TRUE;
    if (is_of_templates(layer, header)) return TRUE;
    g_auto(GStrv) parts = g_strsplit(header, "/", 2);
    if (parts[1] == NULL || !g_strv_contains(layer->core, parts[0])) return FALSE;
    for (gsize i = 0; folders_with_rooms[i].folder != NULL; i++)
        if (g_str_has_suffix(folders_with_rooms[i].folder, parts[0]))
            return room_is_allowed(&folders_with_rooms[i], layer, file_folder, parts[1]);
    const gboolean own_folder = g_str_has_suffix(layer->folder, parts[0]);
    return own_folder || !g_str_has_suffix(header, "-private.h");
}

static gboolean include_is_allowed(const Layer *layer, const char *file_folder, const char *include)
{
    g_autofree char *header = g_strndup(include + 1, strcspn(include + 1, ">\""));
    return include[0] == '<' ? library_is_allowed(layer, header) : own_is_allowed(layer, file_folder, header);
}

/* A folder within a layer's folder may have a row of its own. */
static const Layer *layer_of(const char *path)
{
    const Layer *nearest = NULL;
    for (gsize i = 0; layers[i].folder != NULL; i++) {
        g_autofree char *folder = source_path(layers[i].folder), *beginning = g_strconcat(folder, "/", NULL);
        if (!g_str_has_prefix(path, beginning)) continue;
        if (nearest == NULL || strlen(layers[i].folder) > strlen(nearest->folder)) nearest = &layers[i];
    }
    return nearest;
}

static void test_includes(gconstpointer data)
{
    const Layer *layer = data;
    g_autofree char *root = source_path(layer->folder);
    g_autoptr(GPtrArray) files = source_files(root);
    g_assert_cmpuint(files->len, >, 0);
    for (guint i = 0; i < files->len; i++) {
        g_autofree char *path = g_build_filename(root, files->pdata[i], NULL);
        if (layer_of(path) != layer) continue;
        g_autofree char *file_folder = g_path_get_dirname(path), *text = source_without_comments(path);
        g_autoptr(GPtrArray) includes = source_includes(text);
        for (guint k = 0; k < includes->len; k++)
            if (!include_is_allowed(layer, file_folder, includes->pdata[k])) {
                g_test_message("%s/%s must not include %s", layer->folder, (char *)files->pdata[i],
                               (char *)includes->pdata[k]);
                g_test_fail();
            }
    }
}

/* No folder of core escapes the table. */
static void test_table_is_complete(void)
{
    g_autofree char *core = source_path("core");
    g_autoptr(GDir) dir = g_dir_open(core, 0, NULL);
    g_assert_nonnull(dir);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        g_autofree char *path = g_build_filename(core, name, NULL), *folder = g_build_filename("core", name, NULL);
        gboolean listed = !g_file_test(path, G_FILE_TEST_IS_DIR);
        for (gsize i = 0; layers[i].folder != NULL; i++)
            listed = listed || strcmp(layers[i].folder, folder) == 0;
        if (!listed) g_test_message("%s has no row in the table of layers", folder);
        g_assert_true(listed);
    }
}

/* Every file of a folder with rooms stands in one of them, and a room says in a few lines what it is. */
static void test_rooms_are_complete(gconstpointer data)
{
    const Rooms *rooms = data;
    g_autofree char *root = source_path(rooms->folder);
    guint sources[G_N_ELEMENTS(rooms->rooms)] = {0};
    g_autoptr(GPtrArray) files = source_files(root);
    for (guint i = 0; i < files->len; i++) {
        g_autofree char *room = g_path_get_dirname(files->pdata[i]);
        const int number = room_number(rooms, room);
        if (number < 0) g_test_message("%s/%s stands in no room", rooms->folder, (char *)files->pdata[i]);
        g_assert_cmpint(number, >=, 0);
        if (g_str_has_suffix(files->pdata[i], ".c")) sources[number]++;
    }
    for (int i = 0; rooms->rooms[i] != NULL; i++) {
        g_autofree char *readme = g_build_filename(root, rooms->rooms[i], "README.md", NULL), *text = NULL;
        g_assert_cmpuint(sources[i], >, 0);
        if (!g_file_get_contents(readme, &text, NULL, NULL)) g_error("%s is missing", readme);
        g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
        g_assert_cmpuint(g_strv_length(lines), <=, 31);
    }
}

/* A folder holds what one can look over: at most 25 .c files beside one another. */
static void test_folders_are_small(gconstpointer data)
{
    const char *top = data;
    g_autofree char *root = source_path(top);
    g_autoptr(GHashTable) sources = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    g_autoptr(GPtrArray) files = source_files(root);
    for (guint i = 0; i < files->len; i++) {
        if (!g_str_has_suffix(files->pdata[i], ".c")) continue;
        char *folder = g_path_get_dirname(files->pdata[i]);
        const guint count = GPOINTER_TO_UINT(g_hash_table_lookup(sources, folder)) + 1;
        if (count == 26) {
            g_test_message("%s/%s holds more than 25 .c files: divide it into rooms", top, folder);
            g_test_fail();
        }
        g_hash_table_insert(sources, folder, GUINT_TO_POINTER(count));
    }
    g_assert_cmpuint(g_hash_table_size(sources), >, 0);
}

/* Every test's source is built: the meson.build of its folder names it, whole or by what stands behind "test-". */
static void test_tests_are_built(void)
{
    g_autofree char *root = source_path("tests");
    g_autoptr(GPtrArray) files = source_files(root);
    for (guint i = 0; i < files->len; i++) {
        g_autofree char *base = g_path_get_basename(files->pdata[i]), *folder = g_path_get_dirname(files->pdata[i]);
        if (!g_str_has_prefix(base, "test-") || !g_str_has_suffix(base, ".c")) continue;
        g_autofree char *build = g_build_filename(root, folder, "meson.build", NULL), *text = NULL;
        g_autofree char *whole = g_strdup_printf("'%s'", base), *name = g_strndup(whole, strlen(whole) - strlen(".c'"));
        g_autofree char *short_name = g_strdup_printf("'%s'", name + strlen("'test-"));
        if (!g_file_get_contents(build, &text, NULL, NULL)) g_error("%s is missing", build);
        if (strstr(text, whole) || strstr(text, short_name)) continue;
        g_test_message("%s does not name %s", build, base);
        g_test_fail();
    }
}

/* "mass" is also the name of a dimension, which the units know, and a key of what is written of bodies as JSON. */
static gboolean names_block(const char *folder, const char *file, const char *literal)
{
    const gboolean of_units = strcmp(folder, "core") == 0 && g_str_has_prefix(file, "units/");
    const gboolean is_quantity = strcmp(literal, "mass") == 0 && (of_units || g_str_has_suffix(file, "-json.c"));
    return g_strv_contains(block_ids, literal) && !is_quantity;
}

/* Neither the core nor a host knows a block: no string in them is a type's name. */
static void test_no_block_is_named(gconstpointer data)
{
    const char *folder = data;
    g_autofree char *root = source_path(folder);
    g_autoptr(GPtrArray) files = source_files(root);
    g_assert_cmpuint(files->len, >, 0);
    for (guint i = 0; i < files->len; i++) {
        g_autofree char *path = g_build_filename(root, files->pdata[i], NULL), *text = source_without_comments(path);
        g_autoptr(GPtrArray) literals = source_literals(text);
        for (guint k = 0; k < literals->len; k++)
            if (names_block(folder, files->pdata[i], literals->pdata[k])) {
                g_test_message("%s/%s names the block \"%s\"", folder, (char *)files->pdata[i],
                               (char *)literals->pdata[k]);
                g_test_fail();
            }
    }
}

/* A name that begins with TINKER_ is one for all: what headers define under it has one meaning. */
static void test_names_mean_one(gconstpointer data)
{
    g_autofree char *folder = source_path(data);
    g_autoptr(GPtrArray) files = source_files(folder);
    g_autoptr(GHashTable) defined = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    g_autoptr(GRegex) define = g_regex_new("^#define (TINKER_[A-Z0-9_]+)", G_REGEX_MULTILINE, 0, NULL);
    for (guint i = 0; i < files->len; i++) {
        const char *file = g_ptr_array_index(files, i);
        if (!g_str_has_suffix(file, ".h")) continue;
        g_autofree char *path = g_build_filename(folder, file, NULL), *text = source_without_comments(path);
        g_autoptr(GMatchInfo) found = NULL;
        for (g_regex_match(define, text, 0, &found); g_match_info_matches(found); g_match_info_next(found, NULL)) {
            char *name = g_match_info_fetch(found, 1);
            const char *other = g_hash_table_lookup(defined, name);
            if (other != NULL && strcmp(other, file) != 0)
                g_test_fail_printf("%s is defined in %s and in %s", name, other, file);
            g_hash_table_insert(defined, name, (gpointer)file);
        }
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; layers[i].folder != NULL; i++) {
        g_autofree char *path = g_strconcat("/includes/", layers[i].folder, NULL);
        g_test_add_data_func(path, &layers[i], test_includes);
    }
    g_test_add_func("/includes/table-is-complete", test_table_is_complete);
    for (gsize i = 0; folders_with_rooms[i].folder != NULL; i++) {
        g_autofree char *path = g_strconcat("/rooms/", folders_with_rooms[i].folder, NULL);
        g_test_add_data_func(path, &folders_with_rooms[i], test_rooms_are_complete);
    }
    g_test_add_data_func("/folders/core", "core", test_folders_are_small);
    g_test_add_data_func("/folders/host", "host", test_folders_are_small);
    g_test_add_data_func("/folders/sdk", "sdk", test_folders_are_small);
    g_test_add_data_func("/folders/plugins", "plugins", test_folders_are_small);
    g_test_add_func("/tests/are-built", test_tests_are_built);
    g_test_add_data_func("/names/core", "core", test_no_block_is_named);
    g_test_add_data_func("/names/mean-one/core", "core", test_names_mean_one);
    g_test_add_data_func("/names/mean-one/host", "host", test_names_mean_one);
    g_test_add_data_func("/names/host", "host", test_no_block_is_named);
    return g_test_run();
}
