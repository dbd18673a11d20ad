/* Which way the arrows point: who may include whom, what is linked, and that no block is known by name where none must
 * be. The table below is the architecture; docs/architecture.md draws it. */
#include <glib.h>
#include <string.h>

#include "source-text.h"

/* A folder, and what its files may include: folders of core and of the hosts, and libraries by the beginning of the
 * header's name. */
typedef struct {
    const char *folder;
    const char *core[16];
    const char *libraries[12];
} Layer;

static const Layer layers[] = {
    {"core/files", {"files"}, {"glib"}},
    {"core/units", {"units"}, {"tinker/types.h", "tinker/integrator.h", "tinker/typed-law.h", "glib", NULL}},
    {"core/plugin", {"plugin", "files", "units"}, {"tinker/", "glib", "gmodule", "cjson/"}},
    {"core/law", {"law", "plugin", "numerics", "units"}, {"tinker/", "glib"}},
    {"core/scene", {"scene", "law", "files", "plugin", "units"}, {"tinker/", "glib", "cjson/"}},
    {"core/numerics",
     {"numerics"},
     {"tinker/integrator.h", "tinker/types.h", "tinker/unconstrained.h", "glib", "suitesparse/amd.h", "lapacke.h",
      "arpack/"}},
    {"core/physics", {"physics", "numerics", "scene", "plugin", "units"}, {"tinker/", "glib"}},
    {"core/equations", {"equations", "law", "physics", "scene", "plugin", "units"}, {"tinker/", "glib", "lapacke.h"}},
    {"core/render", {"render", "files", "law", "scene", "plugin", "units"}, {"tinker/", "glib", "cairo", "pango/"}},
    {"core/edit", {"edit", "scene", "plugin", "units"}, {"tinker/", "glib"}},
    {"core/measure",
     {"measure", "physics", "numerics", "law", "scene", "plugin", "units"},
     {"tinker/", "glib", "kissfft/"}},
    {"core/analysis", {"analysis", "physics", "numerics", "scene", "plugin", "units"}, {"tinker/", "glib"}},
    {"core/conformance",
     {"conformance", "law", "physics", "render", "scene", "plugin", "units"},
     {"tinker/", "glib", "cairo"}},
    {"host/common",
     {"common", "equations", "measure", "analysis", "physics", "numerics", "render", "edit", "scene", "plugin", "files",
      "units"},
     {"tinker/", "glib", "gmodule", "cairo", "cjson/"}},
    {"host/cli",
     {"cli", "common", "equations", "measure", "conformance", "analysis", "physics", "numerics", "render", "edit",
      "law", "scene", "plugin", "files", "units"},
     {"tinker/", "glib", "gmodule", "gio/", "cairo", "pango/", "cjson/"}},
    {"host/gui",
     {"gui", "common", "equations", "measure", "analysis", "physics", "numerics", "render", "edit", "law", "scene",
      "plugin", "files", "units"},
     {"tinker/", "glib", "gio/", "gtk/", "adwaita.h", "graphene", "libintl.h", "cairo", "cjson/"}},
    {"plugins", {NULL}, {"tinker/"}},
    {"plugins/cvode-bdf", {NULL}, {"tinker/", "cvodes/", "nvector/", "sundials/", "sunlinsol/", "sunmatrix/"}},
    {"docs/examples", {NULL}, {"tinker/"}},
    {"sdk/templates", {NULL}, {"tinker/"}},
    {"sdk/examples", {NULL}, {"tinker/"}},
    {"sdk/include/tinker", {NULL}, {NULL}},
};

/* The rooms of a folder, in order: each uses those before it. What other folders see of them is their face. */
typedef struct {
    const char *folder;
    const char *rooms[20];
    const char *face[28];
} Rooms;

static const Rooms folders_with_rooms[] = {
    {"core/units",
     {"quantity", "expression", "compiled", "waveform"},
     {"quantity/units.h", "quantity/plain-text.h", "quantity/point-text.h", "expression/expression-tree.h",
      "compiled/compiled.h", "compiled/typed-energy.h", "waveform/table-columns.h", "waveform/waveform.h",
      "waveform/times.h", "waveform/waveform-pole.h"}},
    {"core/scene",
     {"json", "store", "value", "frame", "change", "read", "write", "history"},
     {"store/scene.h",           "store/conditions.h",   "store/quantities.h",   "store/scene-expression.h",
      "history/history.h",       "history/difference.h", "history/fragment.h",   "history/continued.h",
      "frame/drawing-order.h",   "frame/frame.h",        "frame/tops.h",         "frame/overlaps.h",
      "frame/boxes.h",           "frame/small-wheels.h", "frame/idle-turns.h",   "frame/batch.h",
      "frame/batch-waveforms.h", "frame/block-index.h",  "frame/motions.h",      "frame/lanes.h",
      "frame/frame-quantity.h",  "read/scene-json.h",    "value/table-source.h", "history/first-size.h"}},
    {"core/numerics",
     {"sharing", "sines", "solve", "roots", "contact", "integrate", "exact", "methods", "stability"},
     {"methods/integrators.h",
      "sharing/sharing.h",
      "sines/sines.h",
      "solve/dense-solve.h",
      "solve/disjoint-sets.h",
      "solve/largest.h",
      "solve/eigen.h",
      "solve/lapack.h",
      "solve/null-space.h",
      "solve/rank.h",
      "solve/pivoted-solve.h",
      "solve/sparse-ldl.h",
      "solve/sparse-ldu.h",
      "solve/symmetric-eigen.h",
      "solve/symmetric-solver.h",
      "roots/step-roots.h",
      "roots/quadrature.h",
      "contact/contact-laws.h",
      "contact/tolerances.h",
      "contact/impact-law.h",
      "exact/exact.h",
      "stability/amplification.h",
      "stability/coupled.h"}},
    {"core/physics",
     {"model", "constraint", "force", "shapes", "contact", "compile", "line", "system", "impulse", "record",
      "linearise", "plan", "island", "event", "run"},
     {"model/model.h",         "model/breaks.h",     "constraint/jolts.h",    "compile/assemble.h",
      "compile/compile.h",     "system/summary.h",   "impulse/impulse.h",     "record/columns.h",
      "record/sample-times.h", "record/record.h",    "linearise/linearise.h", "linearise/linear-probe.h",
      "plan/islands.h",        "plan/plan.h",        "plan/run-options.h",    "event/still-contacts.h",
      "run/simulation.h",      "run/accurate-run.h", "run/acting-forces.h",   "run/plan-trial.h"}},
    {"core/plugin",
     {"trust", "descriptor", "call", "catalogue"},
     {"call/call.h", "call/crash.h", "call/guarded.h", "call/library.h", "call/process-state.h", "call/words.h",
      "catalogue/catalogue.h"}},
    {"core/render",
     {"draw", "formula", "picture", "plot"},
     {"draw/draw-watch.h", "draw/style.h", "draw/surface.h", "draw/text.h", "draw/theme.h", "draw/view.h",
      "formula/formula.h", "picture/arrows.h", "picture/ghost.h", "picture/icon.h", "picture/painter.h", "plot/plot.h",
      "plot/curve-index.h", "plot/plot-stack.h"}},
    {"core/equations",
     {"state", "newton", "balance", "matrix", "angles", "write"},
     {"state/model-state.h", "newton/equations.h", "balance/books.h", "balance/diagram.h", "matrix/matrix.h",
      "angles/angles.h", "write/lines.h", "write/write.h"}},
    {"core/analysis",
     {"modes", "start", "trade"},
     {"modes/mode-analysis.h", "start/advice.h", "start/joined.h", "start/start-conditions.h", "trade/trade.h"}},
    {"core/conformance", {"probe", "rule"}, {"rule/conformance.h"}},
    {"host/common",
     {"program", "words", "overlay", "graph", "diagram", "film"},
     {"program/csv-writer.h",
      "program/exit-status.h",
      "program/file-set.h",
      "program/installation.h",
      "program/plugin-folders.h",
      "program/print.h",
      "program/program-start.h",
      "words/event-words.h",
      "words/mode-words.h",
      "words/plan-words.h",
      "words/trade-words.h",
      "overlay/force-arrows.h",
      "overlay/mode-shape.h",
      "overlay/motion-trail.h",
      "overlay/motion-vectors.h",
      "overlay/pointed.h",
      "graph/drive-response.h",
      "graph/graph-axis.h",
      "graph/graph-names.h",
      "graph/trade-chart.h",
      "diagram/books-picture.h",
      "diagram/diagram-picture.h",
      "film/film-arrows.h",
      "film/film-pictures.h",
      "film/film.h",
      "film/motion-film.h"}},
    {"host/cli", {"command", "report", "plugins", "verb"}, {NULL}},
    {"host/gui",
     {"text", "widget", "document", "curve", "canvas", "mode", "equation", "property", "start", "graph", "instrument",
      "accuracy", "film", "gallery", "window", "app"},
     {NULL}},
};

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

static gboolean begins_with_one_of(const char *text, const char *const *beginnings)
{
    for (; *beginnings != NULL; beginnings++)
        if (g_str_has_prefix(text, *beginnings)) return TRUE;
    return FALSE;
}

static gboolean library_is_allowed(const Layer *layer, const char *header)
{
    if (g_strv_contains(c_headers, header) || begins_with_one_of(header, layer->libraries)) return TRUE;
    const gboolean bound_to_c = layer->core[0] == NULL;
    return !bound_to_c && begins_with_one_of(header, system_headers);
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
    for (gsize i = 0; i < G_N_ELEMENTS(folders_with_rooms); i++)
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
    for (gsize i = 0; i < G_N_ELEMENTS(layers); i++) {
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
        for (gsize i = 0; i < G_N_ELEMENTS(layers); i++)
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

/* The libraries that a binary asks the loader for; of char *. (transfer full) */
static GPtrArray *needed_libraries(const char *binary)
{
    const char *arguments[] = {"readelf", "--dynamic", "--wide", binary, NULL};
    g_autofree char *output = NULL;
    g_autoptr(GError) error = NULL;
    int wait_status = 0;
    g_spawn_sync(NULL, (char **)arguments, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, &output, NULL, &wait_status, &error);
    g_assert_no_error(error);
    g_assert_true(g_spawn_check_wait_status(wait_status, NULL));
    GPtrArray *needed = g_ptr_array_new_with_free_func(g_free);
    g_auto(GStrv) lines = g_strsplit(output, "\n", -1);
    for (char **line = lines; *line != NULL; line++) {
        const char *name = strchr(*line, '[');
        if (strstr(*line, "(NEEDED)") == NULL || name == NULL) continue;
        g_ptr_array_add(needed, g_strndup(name + 1, strcspn(name + 1, "]")));
    }
    return needed;
}

/* A plugin links to nothing of ours: the C library and the mathematics alone, and what a sanitizer adds. The method on
 * SUNDIALS links to that. */
static void test_plugins_link_to_c_alone(void)
{
    static const char *const allowed[] = {"libc.so", "libm.so", "libasan.so", "libubsan.so", "libtsan.so", NULL};
    const char *folder = g_getenv("TINKER_TEST_PLUGINS");
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(dir);
    guint seen = 0;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(name, ".so")) continue;
        g_autofree char *path = g_build_filename(folder, name, NULL);
        g_autoptr(GPtrArray) needed = needed_libraries(path);
        for (guint i = 0; i < needed->len; i++)
            if (!begins_with_one_of(needed->pdata[i], allowed) &&
                !(strcmp(name, "tinker-cvode-bdf.so") == 0 && g_str_has_prefix(needed->pdata[i], "libsundials_"))) {
                g_test_message("%s links to %s", name, (char *)needed->pdata[i]);
                g_test_fail();
            }
        seen++;
    }
    g_assert_cmpuint(seen, >=, G_N_ELEMENTS(block_ids) - 1);
}

/* The command line runs where there is no display and no desktop. */
static void test_program_links_to_no_desktop(void)
{
    static const char *const desktop[] = {"libgtk", "libadwaita", "libgdk", "libX11", "libwayland", "libtinker", NULL};
    g_autoptr(GPtrArray) needed = needed_libraries(g_getenv("TINKER_PROGRAM"));
    g_assert_cmpuint(needed->len, >, 0);
    for (guint i = 0; i < needed->len; i++)
        g_assert_false(begins_with_one_of(needed->pdata[i], desktop));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(layers); i++) {
        g_autofree char *path = g_strconcat("/includes/", layers[i].folder, NULL);
        g_test_add_data_func(path, &layers[i], test_includes);
    }
    g_test_add_func("/includes/table-is-complete", test_table_is_complete);
    for (gsize i = 0; i < G_N_ELEMENTS(folders_with_rooms); i++) {
        g_autofree char *path = g_strconcat("/rooms/", folders_with_rooms[i].folder, NULL);
        g_test_add_data_func(path, &folders_with_rooms[i], test_rooms_are_complete);
    }
    g_test_add_data_func("/folders/core", "core", test_folders_are_small);
    g_test_add_data_func("/folders/host", "host", test_folders_are_small);
    g_test_add_data_func("/folders/sdk", "sdk", test_folders_are_small);
    g_test_add_data_func("/folders/plugins", "plugins", test_folders_are_small);
    g_test_add_func("/tests/are-built", test_tests_are_built);
    g_test_add_data_func("/names/core", "core", test_no_block_is_named);
    g_test_add_data_func("/names/host", "host", test_no_block_is_named);
    g_test_add_func("/links/plugins", test_plugins_link_to_c_alone);
    g_test_add_func("/links/program", test_program_links_to_no_desktop);
    return g_test_run();
}
