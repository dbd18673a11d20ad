/* The file is looked at once more, and only where there is something to tell: a scene does not remember its text. */
#include "cli/command/block-places.h"

#include <string.h>

/* Whether a message is about the block of this name, or about several, "NAME, OTHER: ", of which this is the first. */
static gboolean is_about(const char *message, const char *name)
{
    if (!g_str_has_prefix(message, name)) return FALSE;
    const char *rest = message + strlen(name);
    return g_str_has_prefix(rest, ": ") || (g_str_has_prefix(rest, ", ") && strstr(rest, ": ") != NULL);
}

/* The place in the drawing order of the block that a message is about; -1: of none. Of the names that fit, as "A" and
 * "A: B" may both, the longest is meant. */
static int32_t find_block(const TinkerScene *scene, const char *message)
{
    int32_t found = -1;
    gsize longest = 0;
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const char *name = tinker_scene_block_name(scene, tinker_scene_block_at(scene, place));
        if (strlen(name) <= longest || !is_about(message, name)) continue;
        longest = strlen(name);
        found = place;
    }
    return found;
}

/* Of a regular file alone: a stream does not come twice. (transfer full) */
static GArray *read_places(const char *path)
{
    GMappedFile *file = g_file_test(path, G_FILE_TEST_IS_REGULAR) ? g_mapped_file_new(path, FALSE, NULL) : NULL;
    const char *text = file != NULL ? g_mapped_file_get_contents(file) : NULL;
    GArray *places = text != NULL ? tinker_scene_block_places(text, g_mapped_file_get_length(file))
                                  : g_array_new(FALSE, FALSE, sizeof(TinkerTextPlace));
    if (file != NULL) g_mapped_file_unref(file);
    return places;
}

char *tinker_placed_message(TinkerScene *scene, const char *path, const char *name, GArray **places,
                            const char *message)
{
    const int32_t block = find_block(scene, message);
    if (block >= 0 && *places == NULL) *places = read_places(path);
    // Another number of blocks is another scene: the file was changed since.
    if (block < 0 || (*places)->len != (guint)tinker_scene_block_count(scene))
        return g_strdup_printf("%s: %s", name, message);
    const TinkerTextPlace place = g_array_index(*places, TinkerTextPlace, block);
    return g_strdup_printf("%s:%d:%d: %s", name, place.line, place.column, message);
}
