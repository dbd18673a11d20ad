/* The window in German, in a locale of the test's own: gettext translates nothing where the locale is C. That each text
 * has a translation tests/data asks. */
#include <libintl.h>
#include <math.h>
#include <string.h>

#include "equations/write/page-private.h"
#include "german.h"
#include "gui-fixture.h"
#include "gui/document/examples.h"
#include "gui/property/property-list.h"
#include "gui/start/start-offer.h"
#include "gui/text/block-words.h"
#include "gui/text/number-text.h"
#include "gui/text/translate.h"

/* The description of the bundled scene "Spring-mass system". */
#define BUNDLED                                                                                                        \
    "A mass of 1 kg is let go at the unstretched end of a spring. It swings about the place where the spring carries " \
    "its weight, 0.3924 m further down, with the period 2 π √(m/k) = 1.2566 s."

static gboolean has_row(const GPtrArray *rows, const char *group, const char *title)
{
    for (guint i = 0; i < rows->len; i++) {
        const TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        if (g_str_equal(row->group, group) && g_str_equal(row->title, title)) return TRUE;
    }
    return FALSE;
}

/* Texts of descriptors, unknown ones as they are; and no header of the catalogue for an empty one. */
static void test_descriptor_texts(void)
{
    g_assert_cmpstr(tinker_translate("Mass"), ==, "Masse");
    g_assert_cmpstr(tinker_translate("Undeformed Length"), ==, "Ungedehnte Länge");
    g_assert_cmpstr(tinker_translate_title("Spring-mass system", BUNDLED), ==, "Feder-Masse-System");
    g_assert_cmpstr(tinker_translate_title("Mass", BUNDLED), ==, "Mass"); /* the user's */
    /* of an example whose description was changed: it is the user's now, and shown as it is stored */
    g_assert_cmpstr(tinker_translate_title("Spring-mass system", "What I found"), ==, "Spring-mass system");
    g_assert_null(tinker_translate_title(NULL, BUNDLED));
    g_assert_cmpstr(tinker_translate("Flux Capacitor"), ==, "Flux Capacitor");
    g_assert_cmpstr(tinker_translate("Distance to Mass"), ==, "Abstand zu Mass"); /* the user's name stays */
    g_assert_cmpstr(tinker_translate(""), ==, "");
    g_assert_null(tinker_translate(NULL));
}

/* A bundled scene is called in the title of the window as in the gallery; the scene keeps its title. One of the user's
 * that has the same title stays as it was typed. */
static void test_name_of_a_bundled_scene(void)
{
    static const char *const own[] = {"'title': 'Spring-mass system', 'blocks': []",
                                      "'title': 'Spring-mass system', 'description': 'Mine', 'blocks': []"};
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    for (gsize i = 0; i < G_N_ELEMENTS(own); i++) {
        gui_fixture_start_scene(fixture, own[i]);
        g_autofree char *typed = tinker_document_name(fixture->document);
        g_assert_cmpstr(typed, ==, "Spring-mass system");
    }
    gui_fixture_start_scene(fixture, "'title': 'Spring-mass system', 'description': '" BUNDLED "', 'blocks': []");
    g_autofree char *name = tinker_document_name(fixture->document);
    g_assert_cmpstr(name, ==, "Feder-Masse-System");
    g_assert_cmpstr(tinker_scene_head(tinker_document_scene(fixture->document))->title, ==, "Spring-mass system");
}

/* The panel and the outline are German; what a scene holds is not. */
static void test_scene_stays_english(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'mass', 'name': 'Mass 0', 'position': [0, 2]}");
    TinkerScene *scene = tinker_document_scene(fixture->document);
    TinkerBlockId mass = gui_fixture_block(fixture, "Mass 0");
    tinker_document_select(fixture->document, mass);
    g_autoptr(GPtrArray) rows = tinker_property_list_new(fixture->document, fixture->player, FALSE);
    g_assert_true(has_row(rows, "Eigenschaften", "Masse"));
    g_assert_true(has_row(rows, "Erscheinungsbild", "Name"));
    g_assert_cmpstr(tinker_block_type_title(scene, mass), ==, "Masse");

    tinker_document_begin(fixture->document, "Add", NULL);
    TinkerBlockId added = tinker_history_add_block(tinker_document_history(fixture->document),
                                                   tinker_scene_block_class(scene, mass), NULL, NULL);
    tinker_document_end(fixture->document);
    g_assert_cmpstr(tinker_scene_block_name(scene, added), ==, "Mass 1");
    g_assert_cmpstr(tinker_scene_block_type(scene, added), ==, "mass");
}

/* Labels of the core, and those with a block's name in them. Only English ones get header capitals. */
/* A German types a comma before decimals; what could be thousands is refused. */
static void test_comma(void)
{
    static const TinkerDimension length = {0, 1, 0, 0};
    static const struct {
        const char *text;
        double metres; /* NAN: it is refused */
    } cases[] = {{"12,5", 12.5}, {"12.5", 12.5},  {" -0,25 ", -0.25},    {"12,5 cm", 0.125},
                 {"1,5e2", 150}, {"7", 7},        {"1.000,5", NAN},      {"1,000,000", NAN},
                 {"1,5.2", NAN}, {"2,5 kg", NAN}, {"a lot, really", NAN}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        double metres = NAN;
        gboolean read = tinker_number_read(cases[i].text, length, "m", &metres, &error);
        g_test_message("%s", cases[i].text);
        g_assert_cmpint(read, ==, !isnan(cases[i].metres));
        g_assert_true(read == (error == NULL));
        if (read) g_assert_cmpfloat_with_epsilon(metres, cases[i].metres, 1e-15 * fabs(cases[i].metres));
    }
}

static void test_start_labels(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(
        "{'type': 'support', 'name': 'Support 0', 'position': [0, 4]}, {'type': 'mass', 'name': 'Mass 0', "
        "'position': [0, 2]}, {'type': 'spring', 'name': 'Spring 0', 'ends': ['Support 0', 'Mass 0']}");
    TinkerScene *scene = tinker_document_scene(fixture->document);
    g_autoptr(GPtrArray) options = tinker_start_options_new(scene, gui_fixture_block(fixture, "Mass 0"));
    g_autoptr(GHashTable) labels = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (guint i = 0; i < options->len; i++)
        g_hash_table_add(labels, tinker_start_button_label(g_ptr_array_index(options, i)));
    g_assert_true(g_hash_table_contains(labels, "In Ruhe"));
    g_assert_true(g_hash_table_contains(labels, "Spring 0 gedehnt um"));
}

/* Keys of menus ---------------------------------------------------------------------------------------------------- */

typedef struct {
    GPtrArray *menus; /* each within the one before: sets of keys */
    gboolean in_label;
    int count;
} MenuReader;

static gboolean is_menu(const char *element)
{
    return g_str_equal(element, "menu") || g_str_equal(element, "submenu");
}

static void on_element(GMarkupParseContext *context, const char *element, const char **names, const char **values,
                       gpointer data, GError **error)
{
    MenuReader *reader = data;
    if (is_menu(element)) g_ptr_array_add(reader->menus, g_hash_table_new(NULL, NULL));
    reader->in_label = g_str_equal(element, "attribute") && g_strcmp0(values[0], "label") == 0;
}

static void on_element_end(GMarkupParseContext *context, const char *element, gpointer data, GError **error)
{
    MenuReader *reader = data;
    if (is_menu(element)) g_ptr_array_set_size(reader->menus, (int)reader->menus->len - 1);
    reader->in_label = FALSE;
}

/* Each language has keys of its own. */
static void check_key(MenuReader *reader, GHashTable *keys, const char *label, guint language)
{
    const char *mark = strchr(label, '_');
    if (mark == NULL) return;
    guint key = g_unichar_tolower(g_utf8_get_char(mark + 1)) * 2 + language;
    reader->count++;
    if (g_hash_table_add(keys, GUINT_TO_POINTER(key))) return;
    g_test_message("the key of “%s” is that of another item of its menu", label);
    g_test_fail();
}

/* The label of a submenu stands in it, but is seen in the menu around it. */
static void on_label(GMarkupParseContext *context, const char *text, gsize length, gpointer data, GError **error)
{
    MenuReader *reader = data;
    if (!reader->in_label || reader->menus->len == 0) return;
    const char *parent = g_markup_parse_context_get_element_stack(context)->next->data;
    guint depth = reader->menus->len - (g_str_equal(parent, "submenu") ? 2 : 1);
    GHashTable *keys = g_ptr_array_index(reader->menus, depth);
    check_key(reader, keys, text, 0);
    check_key(reader, keys, gettext(text), 1);
}

/* No two items of a menu have the same key, in English and in German. */
static void test_keys_of_menus(void)
{
    static const GMarkupParser parser = {.start_element = on_element, .end_element = on_element_end, .text = on_label};
    static const char *const files[] = {"window.ui", "menus.ui"};
    MenuReader reader = {.menus = g_ptr_array_new_with_free_func((GDestroyNotify)g_hash_table_unref)};
    for (gsize i = 0; i < G_N_ELEMENTS(files); i++) {
        g_autoptr(GError) error = NULL;
        g_autofree char *text = NULL, *path = g_build_filename(g_getenv("TINKER_SOURCES"), "host", "gui", "resources",
                                                               files[i], NULL);
        g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
        g_autoptr(GMarkupParseContext) context = g_markup_parse_context_new(&parser, 0, &reader, NULL);
        g_markup_parse_context_parse(context, text, -1, &error);
        g_assert_no_error(error);
    }
    g_assert_cmpint(reader.count, >, 40);
    g_ptr_array_unref(reader.menus);
}

/* What is told of the scenes that show common mistakes. */
static void test_mistakes(void)
{
    g_autoptr(GPtrArray) topics = tinker_examples_read(g_getenv("TINKER_SCENES"));
    guint seen = 0;
    for (guint t = 0; t < topics->len; t++) {
        const TinkerTopic *topic = g_ptr_array_index(topics, t);
        if (!g_str_equal(topic->title, "Verbreitete Irrtümer")) continue;
        for (guint i = 0; i < topic->examples->len; i++, seen++) {
            const TinkerExample *example = g_ptr_array_index(topic->examples, i);
            g_assert_cmpstr(tinker_translate_title(example->title, example->description), !=, example->title);
            g_assert_cmpstr(tinker_translate(example->description), !=, example->description);
        }
    }
    g_assert_cmpuint(seen, ==, 3);
}

/* The topics of the bundled scenes are not shown as the README has them. */
static void test_topics(void)
{
    g_autoptr(GPtrArray) topics = tinker_examples_read(g_getenv("TINKER_SCENES"));
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), "README.md", NULL), *text = NULL;
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_autofree char *readme = g_utf8_casefold(text, -1);
    for (guint t = 0; t < topics->len; t++) {
        const TinkerTopic *topic = g_ptr_array_index(topics, t);
        g_autofree char *title = g_utf8_casefold(topic->title, -1), *row = g_strdup_printf("| %s |", title);
        if (strstr(readme, row) != NULL) g_test_fail_printf("the topic %s has no translation", topic->title);
    }
    g_assert_cmpuint(topics->len, >, 3);
}

/* The list of the translators is what the descriptors say today. */
static void test_template_is_up_to_date(void)
{
    g_autofree char *made = g_build_filename(german_folder(), "descriptors.pot", NULL), *output = NULL;
    const char *list[] = {g_getenv("TINKER_LIST_DESCRIPTORS"),
                          g_getenv("TINKER_PROGRAM"),
                          g_getenv("TINKER_TEST_PLUGINS"),
                          g_getenv("TINKER_SCENES"),
                          made,
                          NULL};
    german_run_tool(list, &output);
    g_autofree char *kept = g_build_filename(g_getenv("TINKER_SOURCES"), "host", "po", "descriptors.pot", NULL);
    g_autofree char *new_text = NULL, *old_text = NULL;
    g_assert_true(g_file_get_contents(made, &new_text, NULL, NULL));
    g_assert_true(g_file_get_contents(kept, &old_text, NULL, NULL));
    if (strcmp(new_text, old_text) != 0)
        g_test_message("run: meson compile tinker-update-descriptors && meson compile tinker-update-po, and translate");
    g_assert_true(strcmp(new_text, old_text) == 0);
}

/* The program finds the catalogue of the build tree by itself. */
static void test_program_speaks_german(void)
{
    const char *help[] = {g_getenv("TINKER_GUI_PROGRAM"), "--help", NULL};
    g_autofree char *output = NULL;
    german_run_tool(help, &output);
    g_assert_nonnull(strstr(output, "Die Szene im Bild"));
}

/* What stands behind the symbols of a wind, a box on a floor and a spring, in German: what the program says itself,
 * what a plugin says of its law, and labels of properties. */
static void test_words_of_equations(void)
{
    static const char *const words[][2] = {{"angle", "Winkel"},
                                           {"speed against the air", "Geschwindigkeit gegen die Luft"},
                                           {"normal force", "Normalkraft"},
                                           {"its plugin states no law", "sein Plugin nennt kein Gesetz"},
                                           {"a constraint holds it", "eine Zwangsbedingung hält ihn"}};
    static const char *const properties[][2] = {{"rest_length", "Ungedehnte Länge"},
                                                {"stiffness", "Steifigkeit"},
                                                {"ends 0 at x", "x, wo sein Ende 1 ansetzt"}};
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++)
        g_assert_cmpstr(tinker_page_words(words[i][0]), ==, words[i][1]);
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'mass'}, {'type': 'mass', 'position': [1, 0]}, {'type': "
                                                    "'spring', 'name': 'Spring 0', 'ends': ['Mass 0', 'Mass 1']}");
    const TinkerEquations equations = {.scene = tinker_document_scene(fixture->document)};
    TinkerPage page;
    tinker_page_begin(&page, TINKER_TYPESET_MATHML, &equations, "Feder");
    g_autofree char *html = tinker_page_end(&page);
    g_assert_nonnull(strstr(html, "<html lang=\"de\">"));
    for (gsize i = 0; i < G_N_ELEMENTS(properties); i++) {
        const TinkerEquationSymbol symbol = {.block = gui_fixture_block(fixture, "Spring 0"),
                                             .property = (char *)properties[i][0]};
        g_autofree char *found = tinker_page_property_words(&equations, &symbol);
        g_assert_cmpstr(found, ==, properties[i][1]);
    }
}

static void add_tests(void)
{
    g_test_add_func("/gui/translation/words-of-equations", test_words_of_equations);
    g_test_add_func("/gui/translation/descriptors", test_descriptor_texts);
    g_test_add_func("/gui/translation/name-of-a-bundled-scene", test_name_of_a_bundled_scene);
    g_test_add_func("/gui/translation/mistakes", test_mistakes);
    g_test_add_func("/gui/translation/topics", test_topics);
    g_test_add_func("/gui/translation/scene", test_scene_stays_english);
    g_test_add_func("/gui/translation/comma", test_comma);
    g_test_add_func("/gui/translation/start", test_start_labels);
    g_test_add_func("/gui/translation/keys-of-menus", test_keys_of_menus);
    g_test_add_func("/gui/translation/template", test_template_is_up_to_date);
    g_test_add_func("/gui/translation/program", test_program_speaks_german);
}

int main(int argc, char **argv)
{
    german_begin();
    const int status = scene_fixture_main(argc, argv, add_tests);
    german_end();
    return status;
}
