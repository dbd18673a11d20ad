/* The topics of the bundled scenes stand in the README of their folder, in a table with a row for each: | topic |
 * `scene`, `scene` |. */
#include "gui/document/examples.h"

#include <cjson/cJSON.h>
#include <glib/gi18n-lib.h>
#include <string.h>

#include "common/program/installation.h"

#define ENDING ".tinker.json"

/* For the translators: what the README calls the topics. */
G_GNUC_UNUSED static const char *const topic_titles[] = {
    N_("To begin with"),
    N_("Common mistakes"),
    N_("Forces and supports that move"),
    N_("Vibration"),
    N_("Rods and mechanisms"),
    N_("Bodies and joints"),
    N_("Gears and ropes"),
    N_("Contact"),
    N_("Friction"),
    N_("Rolling and tipping"),
    N_("Bodies that meet"),
    N_("Surprises"),
};

static void example_free(gpointer data)
{
    TinkerExample *example = data;
    g_free(example->path);
    g_free(example->title);
    g_free(example->description);
    g_free(example);
}

static void topic_free(gpointer data)
{
    TinkerTopic *topic = data;
    g_free(topic->title);
    g_ptr_array_unref(topic->examples);
    g_free(topic);
}

static TinkerTopic *topic_new(const char *title)
{
    TinkerTopic *topic = g_new(TinkerTopic, 1);
    topic->title = g_strdup(title);
    topic->examples = g_ptr_array_new_with_free_func(example_free);
    return topic;
}

static char *text_member(const cJSON *json, const char *key)
{
    const cJSON *member = cJSON_GetObjectItemCaseSensitive(json, key);
    return g_strdup(cJSON_IsString(member) ? member->valuestring : "");
}

/* Takes the path over. The name stands for a title that is missing. */
static void add_example_file(TinkerTopic *topic, char *path, const char *name)
{
    g_autofree char *owned = path, *text = NULL;
    gsize length;
    if (!g_file_get_contents(path, &text, &length, NULL)) return;
    cJSON *json = cJSON_ParseWithLength(text, length);
    if (json == NULL) return;
    TinkerExample *example = g_new(TinkerExample, 1);
    example->path = g_steal_pointer(&owned);
    example->title = text_member(json, "title");
    example->description = text_member(json, "description");
    if (example->title[0] == '\0') {
        g_free(example->title);
        example->title = g_strdup(name);
    }
    g_ptr_array_add(topic->examples, example);
    cJSON_Delete(json);
}

static void add_example(TinkerTopic *topic, const char *folder, const char *name)
{
    g_autofree char *file = g_strconcat(name, ENDING, NULL);
    add_example_file(topic, g_build_filename(folder, file, NULL), name);
}

static void take_topic(GPtrArray *topics, TinkerTopic *topic)
{
    if (topic->examples->len > 0)
        g_ptr_array_add(topics, topic);
    else
        topic_free(topic);
}

/* "to begin with" as a heading, translated. */
static char *heading_of(const char *words)
{
    g_autofree char *first = g_utf8_strup(words, g_utf8_next_char(words) - words);
    g_autofree char *heading = g_strconcat(first, g_utf8_next_char(words), NULL);
    return g_strdup(_(heading));
}

/* Takes over the scenes of one line of the table, and notes their names. */
static void read_row(const char *line, const char *folder, GPtrArray *topics, GHashTable *named)
{
    g_auto(GStrv) cells = g_strsplit(line, "|", 4);
    if (g_strv_length(cells) < 4 || strchr(cells[2], '`') == NULL || g_strstrip(cells[1])[0] == '\0') return;
    g_autofree char *heading = heading_of(cells[1]);
    TinkerTopic *topic = topic_new(heading);
    g_auto(GStrv) parts = g_strsplit(cells[2], "`", -1);
    for (gsize i = 1; parts[i] != NULL && parts[i + 1] != NULL; i += 2) {
        add_example(topic, folder, parts[i]);
        g_hash_table_add(named, g_strdup(parts[i]));
    }
    take_topic(topics, topic);
}

static gint compare_names(gconstpointer a, gconstpointer b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static void add_others(const char *folder, GPtrArray *topics, GHashTable *named)
{
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    g_autoptr(GPtrArray) names = g_ptr_array_new_with_free_func(g_free);
    for (const char *file = dir != NULL ? g_dir_read_name(dir) : NULL; file != NULL; file = g_dir_read_name(dir)) {
        if (!g_str_has_suffix(file, ENDING)) continue;
        g_autofree char *name = g_strndup(file, strlen(file) - strlen(ENDING));
        if (!g_hash_table_contains(named, name)) g_ptr_array_add(names, g_steal_pointer(&name));
    }
    g_ptr_array_sort(names, compare_names);
    TinkerTopic *topic = topic_new(_("Others"));
    for (guint i = 0; i < names->len; i++)
        add_example(topic, folder, names->pdata[i]);
    take_topic(topics, topic);
}

GPtrArray *tinker_examples_read(const char *folder)
{
    GPtrArray *topics = g_ptr_array_new_with_free_func(topic_free);
    g_autoptr(GHashTable) named = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    g_autofree char *readme = g_build_filename(folder, "README.md", NULL), *text = NULL;
    if (g_file_get_contents(readme, &text, NULL, NULL)) {
        g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
        for (char **line = lines; *line != NULL; line++)
            if (g_str_has_prefix(*line, "|")) read_row(*line, folder, topics, named);
    }
    add_others(folder, topics, named);
    return topics;
}

void tinker_examples_add_bundles(GPtrArray *topics, const GPtrArray *bundles)
{
    for (guint i = 0; i < bundles->len; i++) {
        const TinkerBundleEntry *bundle = bundles->pdata[i];
        TinkerTopic *topic = topic_new(bundle->title);
        for (guint k = 0; k < bundle->scenes->len; k++) {
            const char *path = bundle->scenes->pdata[k];
            g_autofree char *file = g_path_get_basename(path);
            g_autofree char *name = g_strndup(file, strlen(file) - strlen(ENDING));
            add_example_file(topic, g_strdup(path), name);
        }
        take_topic(topics, topic);
    }
}

GPtrArray *tinker_examples(TinkerCatalogue *catalogue)
{
    static GPtrArray *topics;
    if (topics == NULL) {
        g_autofree char *folder = tinker_installation_scene_folder();
        topics = tinker_examples_read(folder);
        tinker_examples_add_bundles(topics, tinker_catalogue_bundles(catalogue));
    }
    return topics;
}
