/* Collecting the scenes of the net; see the header. */
#include "net-scenes.h"

#include <string.h>

#include "random-scenes.h"

#define RANDOM 500
#define ENDING ".tinker.json"

static void scene_free(gpointer data)
{
    NetScene *scene = data;
    g_free(scene->name);
    g_free(scene->text);
    g_free(scene);
}

static gboolean is_wanted(const char *name, const char *only)
{
    return only == NULL || strstr(name, only) != NULL;
}

static void add_scene(GPtrArray *scenes, const char *name, char *text)
{
    NetScene *scene = g_new(NetScene, 1);
    *scene = (NetScene){g_strdup(name), text};
    g_ptr_array_add(scenes, scene);
}

/* Every scene file of a folder. */
static gboolean add_folder(GPtrArray *scenes, const char *path, const char *group, const char *only, GError **error)
{
    g_autoptr(GDir) folder = g_dir_open(path, 0, error);
    if (folder == NULL) return FALSE;
    for (const char *file; (file = g_dir_read_name(folder)) != NULL;) {
        if (!g_str_has_suffix(file, ENDING)) continue;
        g_autofree char *id = g_strndup(file, strlen(file) - strlen(ENDING));
        g_autofree char *name = g_strdup_printf("%s %s", group, id), *whole = g_build_filename(path, file, NULL);
        char *text;
        if (!is_wanted(name, only)) continue;
        if (!g_file_get_contents(whole, &text, NULL, error)) return FALSE;
        add_scene(scenes, name, text);
    }
    return TRUE;
}

/* The kinds in turns, each with seeds from 1 on. */
static void add_random(GPtrArray *scenes, const char *only)
{
    const guint kinds = g_strv_length((char **)random_scene_kinds);
    for (guint i = 0; i < RANDOM; i++) {
        const guint kind = i % kinds, seed = 1 + i / kinds;
        g_autofree char *name = g_strdup_printf("random %s %02u", random_scene_kinds[kind], seed);
        if (!is_wanted(name, only)) continue;
        g_autoptr(RandomScene) random = random_scene_new(kind, seed);
        add_scene(scenes, name, g_strdup(random->text));
    }
}

char *net_scenes_folder(void)
{
    return g_build_filename(NET_SOURCES, "host", "scenes", NULL);
}

GPtrArray *net_scenes_new(const char *only, GError **error)
{
    g_autoptr(GPtrArray) scenes = g_ptr_array_new_with_free_func(scene_free);
    g_autofree char *bundled = net_scenes_folder();
    g_autofree char *reference = g_build_filename(NET_SOURCES, "tests", "reference", NULL);
    if (!add_folder(scenes, bundled, "bundled", only, error)) return NULL;
    if (!add_folder(scenes, reference, "reference", only, error)) return NULL;
    add_random(scenes, only);
    return g_steal_pointer(&scenes);
}
