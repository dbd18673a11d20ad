/* Writes the template of the texts that the window takes from descriptors: of the bundled blocks and methods, and the
 * titles and descriptions of the bundled scenes. xgettext cannot find them, since the headers of the SDK compose
 * descriptors by macros.
 *
 *     list-descriptors TINKER PLUGIN_FOLDER SCENE_FOLDER FILE */
#include <cjson/cJSON.h>
#include <glib.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "plugin/catalogue/catalogue.h"

/* As in host/gui/text/translate.c: a title that somebody gives a scene is never taken for another text. */
#define TINKER_TITLE_CONTEXT "Title of an example"

typedef struct {
    GString *text;
    GHashTable *known;
} Template;

/* An entry with a hint for the translators; each text once, and none that has nothing to translate. */
static void add_in(Template *into, const char *context, const char *hint, const char *text)
{
    if (text == NULL || *text == '\0' || !g_hash_table_add(into->known, g_strconcat(context, "\004", text, NULL)))
        return;
    GString *escaped = g_string_new(text);
    g_string_replace(escaped, "\\", "\\\\", 0);
    g_string_replace(escaped, "\"", "\\\"", 0);
    g_string_append_printf(into->text, "\n#. %s\n", hint);
    if (context[0] != '\0') g_string_append_printf(into->text, "msgctxt \"%s\"\n", context);
    g_string_append_printf(into->text, "msgid \"%s\"\nmsgstr \"\"\n", escaped->str);
    g_string_free(escaped, TRUE);
}

static void add(Template *into, const char *hint, const char *text)
{
    add_in(into, "", hint, text);
}

static void add_property(Template *into, const TinkerPropertyType *property)
{
    add(into, "Heading over properties", property->group);
    add(into, "Label of a property", property->title);
    for (int i = 0; property->kind == TINKER_KIND_VECTOR && i < 2; i++)
        add(into, "Label of a component", property->component_titles[i]);
    for (int32_t i = 0; property->kind == TINKER_KIND_CHOICE && i < property->choice_count; i++)
        add(into, "One of the values of a property", property->choices[i]);
    add(into, "Tooltip of a property", property->description);
}

static void add_block(Template *into, const TinkerBlockClass *block_class)
{
    add(into, "Type of block", block_class->type->title);
    add(into, "Tooltip of a type of block, without a full stop", block_class->type->summary);
    for (int32_t i = 0; i < block_class->property_count; i++)
        add_property(into, &block_class->properties[i]);
    for (int32_t i = 0; i < block_class->quantity_count; i++) {
        add(into, "Quantity that graphs show", block_class->quantities[i].title);
        add(into, "Tooltip of a quantity", block_class->quantities[i].description);
    }
    for (int32_t i = 0; i < block_class->law_count; i++)
        add(into, "What a symbol of its law is", block_class->law[i].means);
}

static gint compare_entries(gconstpointer left, gconstpointer right)
{
    const TinkerTypeEntry *const *l = left, *const *r = right;
    return strcmp((*l)->id, (*r)->id);
}

static void add_blocks(Template *into, TinkerCatalogue *catalogue)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    g_autoptr(GPtrArray) entries = g_ptr_array_new();
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        for (guint k = 0; k < library->types->len; k++)
            g_ptr_array_add(entries, g_ptr_array_index(library->types, k));
    }
    g_ptr_array_sort(entries, compare_entries);
    for (guint i = 0; i < entries->len; i++) {
        g_autoptr(GError) error = NULL;
        const TinkerTypeEntry *entry = g_ptr_array_index(entries, i);
        const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, entry->id, &error);
        if (block_class == NULL) g_error("%s", error->message);
        add_block(into, block_class);
    }
}

static gint compare_names(gconstpointer left, gconstpointer right)
{
    return strcmp(*(const char *const *)left, *(const char *const *)right);
}

static void add_scenes(Template *into, const char *folder)
{
    g_autoptr(GPtrArray) names = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *name = dir != NULL ? g_dir_read_name(dir) : NULL; name != NULL; name = g_dir_read_name(dir))
        if (g_str_has_suffix(name, ".tinker.json")) g_ptr_array_add(names, g_strdup(name));
    g_ptr_array_sort(names, compare_names);
    for (guint i = 0; i < names->len; i++) {
        g_autofree char *path = g_build_filename(folder, names->pdata[i], NULL), *text = NULL;
        if (!g_file_get_contents(path, &text, NULL, NULL)) continue;
        cJSON *json = cJSON_Parse(text);
        add_in(into, TINKER_TITLE_CONTEXT, "Title of an example",
               cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "title")));
        add(into, "Description of an example",
            cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "description")));
        cJSON_Delete(json);
    }
}

int main(int argc, char **argv)
{
    if (argc != 5) g_error("usage: list-descriptors TINKER PLUGIN_FOLDER SCENE_FOLDER FILE");
    g_setenv("TINKER_SAFE_MODE", "1", TRUE); /* nobody's own plugins */
    TinkerCatalogueOptions options = {.installed_folder = argv[2], .probe_program = argv[1]};
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&options);
    Template into = {g_string_new("# Texts of descriptors; made by `meson compile tinker-update-descriptors`.\n"
                                  "msgid \"\"\nmsgstr \"Content-Type: text/plain; charset=UTF-8\\n\"\n"),
                     g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL)};
    add_blocks(&into, catalogue);
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++)
        add(&into, "Method that computes the motion", (*method)->title);
    add_scenes(&into, argv[3]);
    g_autoptr(GError) error = NULL;
    if (!g_file_set_contents(argv[4], into.text->str, (gssize)into.text->len, &error)) g_error("%s", error->message);
    g_string_free(into.text, TRUE);
    g_hash_table_unref(into.known);
    return 0;
}
