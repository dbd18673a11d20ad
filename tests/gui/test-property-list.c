/* The property list: what a student reads and types, in both unit systems, and what it does to the scene. */
#include <math.h>
#include <string.h>

#include "gui/property/property-list.h"
#include "gui/text/block-words.h"
#include "scene-fixture.h"

#define ONE_MASS    "{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": [3.2, 2.4]}"
#define ONE_SUPPORT "{\"type\": \"support\", \"name\": \"Support 0\", \"position\": [0, 4]}"
#define ONE_SPRING  "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Support 0\", \"Mass 0\"]}"

/* Fixtures ------------------------------------------------------------------------------------------------------------
 */

typedef struct {
    TinkerDocument *document;
    TinkerPlayer *player;
    gboolean trims;
} Window;

static Window window_with(const char *blocks)
{
    Window window = {.document = tinker_document_new(scene_fixture_catalogue())};
    g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"blocks\": [\n%s]}", blocks);
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_document_start(window.document, text, strlen(text), NULL, &error));
    g_assert_no_error(error);
    window.player = tinker_player_new(window.document);
    return window;
}

static void window_clear(Window *window)
{
    g_clear_object(&window->player);
    g_clear_object(&window->document);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Window, window_clear)

static TinkerBlockId block_of(Window *window, const char *name)
{
    TinkerBlockId block = tinker_scene_find_block(tinker_document_scene(window->document), name);
    g_assert_cmpint(block, !=, TINKER_NO_BLOCK);
    return block;
}

static void select_block(Window *window, const char *name)
{
    tinker_document_select(window->document, block_of(window, name));
}

/* A column of a block by its property's id and component. */
static double stored(Window *window, const char *name, const char *id, int component)
{
    TinkerScene *scene = tinker_document_scene(window->document);
    TinkerBlockId block = block_of(window, name);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    int32_t property = tinker_block_class_property(block_class, id);
    g_assert_cmpint(property, >=, 0);
    return tinker_scene_get(scene, block, block_class->first_columns[property] + component);
}

static char *scene_text(Window *window)
{
    return tinker_scene_to_text(tinker_document_scene(window->document), TINKER_WRITE_SI);
}

/* NULL where there is no such row. (transfer full) */
static TinkerPropertyRow *find_row(Window *window, const char *group, const char *title)
{
    g_autoptr(GPtrArray) rows = tinker_property_list_new(window->document, window->player, window->trims);
    for (guint i = 0; i < rows->len; i++) {
        TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        if (g_str_equal(row->group, group) && g_str_equal(row->title, title)) return tinker_property_row_ref(row);
    }
    return NULL;
}

static void assert_shown(Window *window, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = find_row(window, group, title);
    g_assert_nonnull(row);
    g_assert_cmpstr(row->text, ==, text);
}

static void assert_sensitive(Window *window, const char *group, const char *title, gboolean sensitive)
{
    g_autoptr(TinkerPropertyRow) row = find_row(window, group, title);
    g_assert_nonnull(row);
    g_assert_cmpint(row->sensitive, ==, sensitive);
}

/* Undo must lead back to the very text, and redo to the edited one. */
static void assert_undoes(Window *window, const char *before)
{
    g_autofree char *after = scene_text(window);
    g_assert_cmpstr(after, !=, before);
    tinker_document_undo(window->document);
    g_autofree char *undone = scene_text(window);
    g_assert_cmpstr(undone, ==, before);
    g_assert_null(tinker_history_can_undo(tinker_document_history(window->document)));
    tinker_document_redo(window->document);
    g_autofree char *redone = scene_text(window);
    g_assert_cmpstr(redone, ==, after);
    tinker_document_undo(window->document);
    tinker_document_redo(window->document);
}

/* Types into a row, which must take it as one step for undo. */
static void type_into(Window *window, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = find_row(window, group, title);
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    tinker_property_row_set(window->document, row, text, &error);
    g_assert_no_error(error);
}

static void choose(Window *window, const char *group, const char *title, const char *text)
{
    g_autoptr(TinkerPropertyRow) row = find_row(window, group, title);
    g_autoptr(GError) error = NULL;
    g_assert_nonnull(row);
    int choice = 0;
    while (row->choices[choice] != NULL && !g_str_equal(row->choices[choice], text))
        choice++;
    g_assert_nonnull(row->choices[choice]);
    tinker_property_row_choose(window->document, row, choice, &error);
    g_assert_no_error(error);
}

/* Types what a row must refuse: with a sentence that has these parts, and nothing else changed. */
static void assert_refused(Window *window, const char *group, const char *title, const char *text,
                           const char *const *parts)
{
    g_autoptr(TinkerPropertyRow) row = find_row(window, group, title);
    g_autoptr(GError) error = NULL;
    g_autofree char *before = scene_text(window);
    const char *undo = tinker_history_can_undo(tinker_document_history(window->document));
    g_autofree char *last = g_strdup(undo);
    g_assert_nonnull(row);
    g_assert_false(tinker_property_row_set(window->document, row, text, &error));
    g_assert_nonnull(error);
    for (; *parts != NULL; parts++)
        if (strstr(error->message, *parts) == NULL) g_error("“%s” lacks “%s”", error->message, *parts);
    g_assert_true(g_unichar_isupper(g_utf8_get_char(error->message)) || g_str_has_prefix(error->message, "“"));
    g_assert_nonnull(strchr(".?", error->message[strlen(error->message) - 1]));
    g_autofree char *after = scene_text(window);
    g_assert_cmpstr(after, ==, before);
    g_assert_cmpstr(tinker_history_can_undo(tinker_document_history(window->document)), ==, last);
}
#define PARTS(...) ((const char *const[]){__VA_ARGS__, NULL})

static void select_nothing(Window *window)
{
    tinker_document_select(window->document, TINKER_NO_BLOCK);
}

static void go_english(Window *window)
{
    select_nothing(window);
    choose(window, "Scene", "Units", "English");
}

/* What is shown
 * --------------------------------------------------------------------------------------------------------- */

/* The strings of the thesis's figures, for one mass in both systems. */
static void test_thesis_strings(void)
{
    g_auto(Window) window = window_with(ONE_MASS);
    select_block(&window, "Mass 0");
    assert_shown(&window, "Appearance", "Name", "Mass 0");
    assert_shown(&window, "Global Position", "X", "3.20000 m");
    assert_shown(&window, "Global Position", "Y", "2.40000 m");
    assert_shown(&window, "Initial Velocity", "Vx", "0.00000 m/s");
    assert_shown(&window, "Initial Velocity", "Vy", "0.00000 m/s");
    assert_shown(&window, "Offset (Local Coordinates)", "X", "0.00000 m");
    assert_shown(&window, "Properties", "Mass", "1.00000 kg");
    assert_shown(&window, "Properties", "Orientation", "0.00000 deg");
    assert_shown(&window, "Size", "Height", "0.80000 m");
    assert_shown(&window, "Size", "Width", "0.80000 m");

    g_autofree char *before = scene_text(&window);
    go_english(&window);
    assert_undoes(&window, before);
    select_block(&window, "Mass 0");
    assert_shown(&window, "Global Position", "X", "10.49869 ft");
    assert_shown(&window, "Global Position", "Y", "7.87402 ft");
    assert_shown(&window, "Properties", "Mass", "0.06852 slug");
    assert_shown(&window, "Size", "Height", "2.62467 ft");
    assert_shown(&window, "Size", "Width", "2.62467 ft");
    g_assert_cmpfloat(stored(&window, "Mass 0", "position", 0), ==, 3.2);
}

static void test_motor_strings(void)
{
    g_auto(Window) window =
        window_with(ONE_MASS ",{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"]}");
    select_block(&window, "Motor 0");
    assert_shown(&window, "Force", "Amplitude", "1.00000 N");
    assert_shown(&window, "Force", "Angle", "0.00000 deg");
    assert_shown(&window, "Force", "Frequency", "1.00000 rad/s");
    g_autoptr(TinkerPropertyRow) type = find_row(&window, "Force", "Type");
    g_assert_cmpstr(type->choices[type->chosen], ==, "Cosine");
}

static void test_support_strings(void)
{
    g_auto(Window) window = window_with(ONE_SUPPORT);
    select_block(&window, "Support 0");
    assert_shown(&window, "Appearance", "Name", "Support 0");
    assert_shown(&window, "Friction", "Dynamic coefficient", "0.50000");
    assert_shown(&window, "Friction", "Static coefficient", "0.50000");
    assert_shown(&window, "Global Position", "Y", "4.00000 m");
    assert_shown(&window, "Properties", "Orientation", "0.00000 deg");
    assert_shown(&window, "Size", "Height", "0.40000 m");
    assert_shown(&window, "Size", "Width", "4.00000 m");
}

static void test_spring_strings(void)
{
    g_auto(Window) window =
        window_with("{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": [0, 2]}," ONE_SUPPORT "," ONE_SPRING);
    select_block(&window, "Spring 0");
    assert_shown(&window, "Spring Properties", "K", "25.00000 N/m");
    assert_shown(&window, "Spring Properties", "Length", "2.00000 m");
    assert_shown(&window, "Spring Properties", "Undeformed Length", "2.00000 m");
    assert_sensitive(&window, "Spring Properties", "Length", FALSE);
    assert_sensitive(&window, "Spring Properties", "K", TRUE);
    assert_shown(&window, "Connections", "End 1", "Support 0");
    assert_shown(&window, "Connections", "End 2", "Mass 0");
    go_english(&window);
    select_block(&window, "Spring 0");
    assert_shown(&window, "Spring Properties", "Length", "6.56168 ft");
    assert_shown(&window, "Spring Properties", "K", "1.71304 lbf/ft"); /* 25 * 0.3048 / 4.4482216152605 */
}

/* Where that is wished, the zeros behind the last digit that counts are left out; all else is as it was. */
static void test_trimmed(void)
{
    g_auto(Window) window =
        window_with(ONE_MASS ",{\"type\": \"mass\", \"name\": \"Far\", \"position\": [-100, 0.12345],"
                             "\"velocity\": [1e-9, -0.5]}," ONE_SUPPORT "," ONE_SPRING);
    window.trims = TRUE;
    select_block(&window, "Mass 0");
    assert_shown(&window, "Global Position", "X", "3.2 m");
    assert_shown(&window, "Initial Velocity", "Vx", "0 m/s");
    assert_shown(&window, "Properties", "Mass", "1 kg");
    assert_shown(&window, "Properties", "Orientation", "0 deg");
    select_block(&window, "Far");
    assert_shown(&window, "Global Position", "X", "-100 m");
    assert_shown(&window, "Global Position", "Y", "0.12345 m");
    assert_shown(&window, "Initial Velocity", "Vx", "0 m/s");
    assert_shown(&window, "Initial Velocity", "Vy", "-0.5 m/s");
    /* What is not shown stays as it is when the shown is entered again. */
    g_autoptr(TinkerPropertyRow) row = find_row(&window, "Initial Velocity", "Vx");
    g_assert_true(tinker_property_row_set(window.document, row, "0 m/s", NULL));
    g_assert_cmpfloat(stored(&window, "Far", "velocity", 0), ==, 1e-9);
    select_block(&window, "Spring 0");
    assert_shown(&window, "Spring Properties", "K", "25 N/m");
    select_nothing(&window);
    assert_shown(&window, "Run", "Duration", "10 s");
    go_english(&window);
    select_block(&window, "Mass 0");
    assert_shown(&window, "Global Position", "X", "10.49869 ft");
    assert_shown(&window, "Properties", "Mass", "0.06852 slug");
}

static void test_order(void)
{
    static const char *const selections[] = {"Mass 0", "Support 0", "Spring 0", NULL, NULL};
    g_auto(Window) window = window_with(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING);
    for (gsize i = 0; i < 4; i++) {
        if (selections[i] != NULL)
            select_block(&window, selections[i]);
        else
            select_nothing(&window);
        g_autoptr(GPtrArray) rows = tinker_property_list_new(window.document, window.player, FALSE);
        g_autoptr(GHashTable) ids = g_hash_table_new(g_str_hash, g_str_equal);
        g_assert_cmpuint(rows->len, >, 4);
        for (guint k = 0; k < rows->len; k++) {
            const TinkerPropertyRow *row = g_ptr_array_index(rows, k), *last = k > 0 ? rows->pdata[k - 1] : row;
            int by_group = strcmp(last->group, row->group);
            g_assert_cmpint(by_group, <=, 0);
            if (by_group == 0) g_assert_cmpint(strcmp(last->title, row->title), <=, 0);
            g_assert_true(g_hash_table_add(ids, row->id));
        }
    }
}

/* What is typed
 * --------------------------------------------------------------------------------------------------------- */

static void test_units(void)
{
    g_auto(Window) window = window_with(ONE_MASS);
    select_block(&window, "Mass 0");
    g_autofree char *before = scene_text(&window);
    type_into(&window, "Global Position", "X", "12 in");
    g_assert_cmpfloat_with_epsilon(stored(&window, "Mass 0", "position", 0), 0.3048, 1e-15);
    g_assert_cmpfloat(stored(&window, "Mass 0", "position", 1), ==, 2.4);
    assert_shown(&window, "Global Position", "X", "0.30480 m");
    assert_undoes(&window, before);

    /* A plain number is in the unit that is shown. */
    type_into(&window, "Properties", "Orientation", " 90 ");
    g_assert_cmpfloat_with_epsilon(stored(&window, "Mass 0", "orientation", 0), asin(1.0), 1e-15);
    type_into(&window, "Properties", "Mass", "2.5");
    g_assert_cmpfloat(stored(&window, "Mass 0", "mass", 0), ==, 2.5);
    go_english(&window);
    select_block(&window, "Mass 0");
    type_into(&window, "Global Position", "Y", "10");
    g_assert_cmpfloat_with_epsilon(stored(&window, "Mass 0", "position", 1), 3.048, 1e-15);
    assert_shown(&window, "Global Position", "Y", "10.00000 ft");
    type_into(&window, "Properties", "Mass", "1");
    g_assert_cmpfloat_with_epsilon(stored(&window, "Mass 0", "mass", 0), 14.593902937206364, 1e-12);
    type_into(&window, "Properties", "Mass", "3 kg");
    g_assert_cmpfloat(stored(&window, "Mass 0", "mass", 0), ==, 3);
}

/* Text that is left as it is shown changes nothing, although it has fewer digits than the value. */
static void test_unchanged(void)
{
    g_auto(Window) window = window_with("{\"type\": \"mass\", \"name\": \"A\", \"position\": [0.123456789, 0]}");
    select_block(&window, "A");
    type_into(&window, "Global Position", "X", "0.12346 m");
    g_assert_cmpfloat(stored(&window, "A", "position", 0), ==, 0.123456789);
    g_assert_null(tinker_history_can_undo(tinker_document_history(window.document)));
}

static void test_refused(void)
{
    g_auto(Window) window = window_with(ONE_MASS "," ONE_SUPPORT);
    select_block(&window, "Mass 0");
    assert_refused(&window, "Properties", "Mass", "12 in", PARTS("mass", "length", "12 in"));
    assert_refused(&window, "Properties", "Mass", "-1", PARTS("Mass", "greater than 0 kg", "-1 kg"));
    assert_refused(&window, "Properties", "Mass", "0 kg", PARTS("greater than 0 kg"));
    assert_refused(&window, "Properties", "Mass", "heavy", PARTS("number"));
    assert_refused(&window, "Properties", "Mass", "", PARTS("number"));
    assert_refused(&window, "Properties", "Mass", "1,5", PARTS("point"));
    assert_refused(&window, "Properties", "Mass", "1e999", PARTS("range"));
    assert_refused(&window, "Properties", "Mass", "3 kgs", PARTS("kgs", "did you mean"));
    assert_refused(&window, "Size", "Width", "-0.1 m", PARTS("Width", "at least 0 m", "-0.1 m"));
    assert_refused(&window, "Size", "Width", "\xff", PARTS("UTF-8"));
    assert_refused(&window, "Appearance", "Name", "Support 0", PARTS("Support 0", "already"));
    assert_refused(&window, "Appearance", "Name", " ", PARTS("name"));
    select_block(&window, "Support 0");
    assert_refused(&window, "Properties", "Restitution", "1.5", PARTS("at most 1", "1.5"));
    go_english(&window);
    select_block(&window, "Mass 0");
    assert_refused(&window, "Properties", "Mass", "-1", PARTS("greater than 0 slug", "-1 slug"));
    select_nothing(&window);
    assert_refused(&window, "Run", "Duration", "0", PARTS("Duration", "greater than 0 s"));
    assert_refused(&window, "Canvas", "Grid", "-1 ft", PARTS("greater than 0"));
}

static void test_name(void)
{
    g_auto(Window) window = window_with(ONE_MASS);
    select_block(&window, "Mass 0");
    g_autofree char *before = scene_text(&window);
    type_into(&window, "Appearance", "Name", "Bob");
    g_assert_cmpint(block_of(&window, "Bob"), ==, tinker_document_selected(window.document));
    assert_undoes(&window, before);
}

/* Any text is taken or refused; none harms the scene. */
static void test_any_text(void)
{
    static const char *const bits[] = {"1", "-",  ".", "e", "9", " ",   "m",   "/",
                                       "^", "ft", "°", ",", "(", "nan", "inf", "0x"};
    g_auto(Window) window = window_with(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING);
    static const char *const names[] = {"Mass 0", "Support 0", "Spring 0"};
    for (int round = 0; round < 300; round++) {
        g_autoptr(GString) text = g_string_new(NULL);
        for (int i = g_test_rand_int_range(0, 7); i > 0; i--)
            g_string_append(text, bits[g_test_rand_int_range(0, G_N_ELEMENTS(bits))]);
        TinkerBlockId block = tinker_scene_block_at(tinker_document_scene(window.document), round % 3);
        tinker_document_select(window.document, block);
        g_autoptr(GPtrArray) rows = tinker_property_list_new(window.document, window.player, FALSE);
        TinkerPropertyRow *row = rows->pdata[g_test_rand_int_range(0, (gint32)rows->len)];
        g_autoptr(GError) error = NULL;
        if (row->set == NULL) continue;
        gboolean taken = tinker_property_row_set(window.document, row, text->str, &error);
        g_assert_true(taken == (error == NULL));
    }
    g_autofree char *written = scene_text(&window);
    g_autoptr(TinkerScene) again = scene_fixture_read(written);
    g_assert_cmpint(tinker_scene_block_count(again), ==, G_N_ELEMENTS(names));
}

/* Local coordinates
 * ----------------------------------------------------------------------------------------------------- */

static void test_offset(void)
{
    g_auto(Window) window = window_with(ONE_MASS);
    select_block(&window, "Mass 0");
    g_autofree char *before = scene_text(&window);
    type_into(&window, "Offset (Local Coordinates)", "Y", "-1 m");
    g_assert_cmpfloat_with_epsilon(stored(&window, "Mass 0", "position", 1), 1.4, 1e-15);
    g_assert_cmpfloat(stored(&window, "Mass 0", "position", 0), ==, 3.2);
    g_assert_cmpfloat(stored(&window, "Mass 0", "local_origin", 0), ==, 3.2);
    g_assert_cmpfloat(stored(&window, "Mass 0", "local_origin", 1), ==, 2.4);
    assert_shown(&window, "Offset (Local Coordinates)", "Y", "-1.00000 m");
    assert_shown(&window, "Global Position", "Y", "1.40000 m");
    assert_undoes(&window, before);

    /* From then on the origin stays, and the place alone makes the offset. */
    type_into(&window, "Global Position", "Y", "2.9 m");
    assert_shown(&window, "Offset (Local Coordinates)", "Y", "0.50000 m");
}

/* A spring whose rest length was left to the drawing is stretched by an offset, as far as that leads: by 1 m straight
 * away from the support above. */
static void test_offset_stretches(void)
{
    g_auto(Window) window =
        window_with("{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": [0, 2]}," ONE_SUPPORT "," ONE_SPRING);
    select_block(&window, "Mass 0");
    g_autofree char *before = scene_text(&window);
    type_into(&window, "Offset (Local Coordinates)", "Y", "-1 m");
    g_assert_cmpfloat_with_epsilon(stored(&window, "Mass 0", "position", 1), 1, 1e-15);
    g_assert_cmpfloat_with_epsilon(stored(&window, "Spring 0", "rest_length", 0), 2, 1e-15);
    assert_undoes(&window, before);
}

/* Connections
 * ----------------------------------------------------------------------------------------------------------- */

static void test_ends(void)
{
    g_auto(Window) window = window_with(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING);
    TinkerScene *scene = tinker_document_scene(window.document);
    TinkerBlockId spring = block_of(&window, "Spring 0");
    select_block(&window, "Spring 0");
    g_autofree char *before = scene_text(&window);
    type_into(&window, "Connections", "End 2", "");
    TinkerSceneEnd end = tinker_scene_end(scene, spring, 1);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat_with_epsilon(end.x, 3.2, 1e-15);
    g_assert_cmpfloat_with_epsilon(end.y, 2.4, 1e-15);
    assert_undoes(&window, before);
    assert_shown(&window, "Connections", "End 2", "");
    assert_refused(&window, "Connections", "End 2", "Mass 1", PARTS("Mass 1", "did you mean “Mass 0”"));
    assert_refused(&window, "Connections", "End 2", "Spring 0", PARTS("itself"));
    type_into(&window, "Connections", "End 2", "Mass 0");
    g_assert_cmpint(tinker_scene_end(scene, spring, 1).block, ==, block_of(&window, "Mass 0"));
}

/* Lengths as placed
 * ------------------------------------------------------------------------------------------------------ */

static void test_as_placed(void)
{
    g_auto(Window) window =
        window_with("{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": [3, 0]}," ONE_SUPPORT "," ONE_SPRING);
    select_block(&window, "Spring 0");
    assert_shown(&window, "Spring Properties", "Undeformed Length", "5.00000 m");
    g_autofree char *before = scene_text(&window);
    type_into(&window, "Spring Properties", "Undeformed Length", "4");
    g_assert_cmpfloat(stored(&window, "Spring 0", "rest_length", 0), ==, 4);
    type_into(&window, "Spring Properties", "Undeformed Length", "");
    g_autofree char *after = scene_text(&window);
    g_assert_cmpstr(after, ==, before);
}

/* Motions of supports
 * ---------------------------------------------------------------------------------------------------- */

static void test_motion(void)
{
    g_auto(Window) window = window_with(ONE_SUPPORT "," ONE_MASS);
    TinkerScene *scene = tinker_document_scene(window.document);
    select_block(&window, "Mass 0");
    g_autoptr(TinkerPropertyRow) none = find_row(&window, "Motion", "Type");
    g_assert_null(none); /* what can move has no motion of its own */

    select_block(&window, "Support 0");
    g_autofree char *before = scene_text(&window);
    g_autoptr(TinkerPropertyRow) type = find_row(&window, "Motion", "Type"),
                                 amplitude = find_row(&window, "Motion", "Amplitude");
    g_assert_nonnull(type);
    g_assert_null(amplitude);
    g_assert_cmpstr(type->choices[type->chosen], ==, "None");

    choose(&window, "Motion", "Type", "Cosine");
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 3);
    TinkerBlockId motion = tinker_scene_block_at(scene, 2);
    g_assert_cmpint(tinker_scene_end(scene, motion, 0).block, ==, block_of(&window, "Support 0"));
    assert_undoes(&window, before);
    assert_shown(&window, "Motion", "Amplitude", "0.00000 m");
    assert_shown(&window, "Motion", "Frequency", "0.00000 rad/s");
    type_into(&window, "Motion", "Amplitude", "10 cm");
    g_assert_cmpfloat_with_epsilon(stored(&window, tinker_scene_block_name(scene, motion), "amplitude", 0), 0.1, 1e-15);
    assert_sensitive(&window, "Motion", "Frequency", TRUE);

    choose(&window, "Motion", "Type", "Expression");
    assert_shown(&window, "Motion", "Expression", "0.1*cos(0*t)");
    assert_sensitive(&window, "Motion", "Amplitude", FALSE);
    assert_sensitive(&window, "Motion", "Angle", TRUE);
    type_into(&window, "Motion", "Expression", "0.2*sin(t)^2");
    assert_refused(&window, "Motion", "Expression", "0.2*sine(t)", PARTS("sin"));
    choose(&window, "Motion", "Type", "None");
    assert_sensitive(&window, "Motion", "Frequency", FALSE);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 3);
}

/* A second motion of the same support has a group of its own, and each row sets its own block. */
static void test_two_motions(void)
{
    g_auto(Window) window =
        window_with(ONE_SUPPORT ", {\"type\": \"support-motion\", \"name\": \"A\", \"ends\": [\"Support 0\"]},"
                                "{\"type\": \"support-motion\", \"name\": \"B\", \"ends\": [\"Support 0\"]}");
    select_block(&window, "Support 0");
    type_into(&window, "Motion", "Amplitude", "1");
    type_into(&window, "Motion (B)", "Amplitude", "2");
    g_assert_cmpfloat(stored(&window, "A", "amplitude", 0), ==, 1);
    g_assert_cmpfloat(stored(&window, "B", "amplitude", 0), ==, 2);
}

/* Several blocks
 * --------------------------------------------------------------------------------------------------------- */

static void test_several(void)
{
    g_auto(Window) window =
        window_with("{\"type\": \"mass\", \"name\": \"A\", \"position\": [1, 2], \"mass\": 1},"
                    "{\"type\": \"mass\", \"name\": \"B\", \"position\": [3, 2], \"mass\": 2}," ONE_SUPPORT);
    const TinkerBlockId both[] = {block_of(&window, "A"), block_of(&window, "B"), block_of(&window, "Support 0")};
    tinker_document_select_all_of(window.document, both, 2);
    g_autofree char *before = scene_text(&window);
    g_autoptr(TinkerPropertyRow) x = find_row(&window, "Global Position", "X"),
                                 name = find_row(&window, "Appearance", "Name");
    g_assert_true(x->mixed);
    g_assert_cmpstr(x->text, ==, "");
    g_assert_null(name);
    assert_shown(&window, "Global Position", "Y", "2.00000 m");
    type_into(&window, "Properties", "Mass", "5 kg");
    g_assert_cmpfloat(stored(&window, "A", "mass", 0), ==, 5);
    g_assert_cmpfloat(stored(&window, "B", "mass", 0), ==, 5);
    assert_undoes(&window, before);
    type_into(&window, "Global Position", "X", "0");
    g_assert_cmpfloat(stored(&window, "B", "position", 0), ==, 0);
    g_assert_cmpfloat(stored(&window, "B", "position", 1), ==, 2);

    tinker_document_select_all_of(window.document, both, 3);
    g_autoptr(GPtrArray) rows = tinker_property_list_new(window.document, window.player, FALSE);
    g_autofree char *heading = tinker_property_list_heading(window.document);
    g_assert_cmpuint(rows->len, ==, 0);
    g_assert_cmpstr(heading, ==, "3 Blocks");
}

/* Of several supports each keeps its static coefficient, where that is not below the dynamic one that is typed for all.
 */
static void test_friction_of_several(void)
{
    g_auto(Window) window = window_with("{\"type\": \"support\", \"name\": \"A\", \"static_friction\": 0.9},"
                                        "{\"type\": \"support\", \"name\": \"B\", \"static_friction\": 0.6}");
    const TinkerBlockId both[] = {block_of(&window, "A"), block_of(&window, "B")};
    tinker_document_select_all_of(window.document, both, 2);
    type_into(&window, "Friction", "Dynamic coefficient", "0.8");
    g_assert_cmpfloat(stored(&window, "A", "static_friction", 0), ==, 0.9);
    g_assert_cmpfloat(stored(&window, "B", "static_friction", 0), ==, 0.8);
    tinker_document_undo(window.document);
    g_assert_cmpfloat(stored(&window, "B", "static_friction", 0), ==, 0.6);
    g_assert_cmpfloat(stored(&window, "A", "dynamic_friction", 0), ==, 0.5);
}

/* Other kinds, the scene, and the present
 * ---------------------------------------------------------------------------------- */

static void test_every_kind(void)
{
    g_auto(Window) window = window_with("{\"type\": \"every-kind\", \"name\": \"E\"}");
    select_block(&window, "E");
    g_autoptr(GPtrArray) rows = tinker_property_list_new(window.document, window.player, FALSE);
    gboolean seen[TINKER_ROW_READING + 1] = {FALSE};
    for (guint i = 0; i < rows->len; i++) {
        const TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        g_autofree char *before = scene_text(&window);
        seen[row->kind] = TRUE;
        if (row->choose == NULL) continue;
        g_assert_true(tinker_property_row_choose(window.document, row, 1 - MIN(row->chosen, 1), NULL));
        g_autofree char *after = scene_text(&window);
        g_assert_cmpstr(after, !=, before);
        tinker_document_undo(window.document);
        g_autofree char *undone = scene_text(&window);
        g_assert_cmpstr(undone, ==, before);
    }
    g_assert_true(seen[TINKER_ROW_NUMBER] && seen[TINKER_ROW_TEXT] && seen[TINKER_ROW_CHOICE] &&
                  seen[TINKER_ROW_SWITCH]);
}

/* Vectors with the same labels in one group are told apart by their own titles; components stay together in their
 * order. */
static void test_vectors(void)
{
    static const char *const titles[] = {"Centre X", "Centre Y", "Moment Along", "Moment Across", "Point X",
                                         "Point Y",  "Radius",   "X Pull",       "Y pull"};
    g_auto(Window) window = window_with("{\"type\": \"vectors\", \"name\": \"V\", \"centre\": [1, 2]}");
    select_block(&window, "V");
    g_autoptr(GPtrArray) rows = tinker_property_list_new(window.document, window.player, FALSE);
    guint shown = 0;
    for (guint i = 0; i < rows->len; i++) {
        const TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        if (!g_str_equal(row->group, "Guide")) continue;
        g_assert_cmpuint(shown, <, G_N_ELEMENTS(titles));
        g_assert_cmpstr(row->title, ==, titles[shown++]);
    }
    g_assert_cmpuint(shown, ==, G_N_ELEMENTS(titles));
    assert_shown(&window, "Guide", "Centre X", "1.00000 m");
    assert_shown(&window, "Guide", "Centre Y", "2.00000 m");
    assert_shown(&window, "Its Places", "X", "0.00000 m"); /* the heading has the title */
    type_into(&window, "Guide", "Moment Across", "3");
    g_assert_cmpfloat(stored(&window, "V", "moment", 1), ==, 3);
    g_assert_cmpfloat(stored(&window, "V", "moment", 0), ==, 0);
}

static void test_scene(void)
{
    g_auto(Window) window = window_with(ONE_MASS);
    select_nothing(&window);
    TinkerSceneHead *head = tinker_scene_head(tinker_document_scene(window.document));
    g_autofree char *before = scene_text(&window);
    type_into(&window, "Scene", "Title", "Pendulum");
    g_assert_cmpstr(head->title, ==, "Pendulum");
    assert_undoes(&window, before);
    type_into(&window, "Run", "Duration", "2 min");
    g_assert_cmpfloat(head->run.duration, ==, 120);
    type_into(&window, "Computation", "Tolerance", "1e-6");
    g_assert_cmpfloat(head->run.tolerance, ==, 1e-6);
    assert_shown(&window, "Computation", "Tolerance", "1e-06");
    assert_shown(&window, "Computation", "Accuracy", "");
    type_into(&window, "Computation", "Accuracy", "1e-5");
    g_assert_cmpfloat(head->run.accuracy, ==, 1e-5);
    assert_shown(&window, "Computation", "Accuracy", "1e-05");
    assert_sensitive(&window, "Computation", "Tolerance", FALSE); /* chosen for the accuracy */
    type_into(&window, "Computation", "Accuracy", " ");
    g_assert_cmpfloat(head->run.accuracy, ==, 0);
    assert_sensitive(&window, "Computation", "Tolerance", TRUE);
    choose(&window, "Computation", "Contacts", "Impulses");
    g_assert_cmpstr(head->run.contacts, ==, "impulse");
    choose(&window, "Computation", "Method", "Classical Runge-Kutta, order 4");
    g_assert_cmpstr(head->run.method, ==, "rk4");
    assert_sensitive(&window, "Computation", "Step", TRUE);
    assert_sensitive(&window, "Computation", "Tolerance", FALSE);
    go_english(&window);
    type_into(&window, "Canvas", "Width", "30");
    g_assert_cmpfloat_with_epsilon(head->canvas_width, 9.144, 1e-12);
}

/* A mass in free fall for half a second, by its closed form; before the run nothing is said of it. */
static void test_now(void)
{
    g_auto(Window) window = window_with("{\"type\": \"gravity\", \"name\": \"Gravity\"}," ONE_MASS "," ONE_SUPPORT
                                        "," ONE_SPRING ", {\"type\": \"mass\", \"name\": \"Free\"}");
    select_block(&window, "Free");
    g_autoptr(TinkerPropertyRow) none = find_row(&window, "Now", "Y Position");
    g_assert_null(none);
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_player_play(window.player, &culprit, &error));
    g_assert_true(tinker_player_wait(window.player, 0.5, &error));
    tinker_player_pause(window.player);
    tinker_player_seek(window.player, 0.5);
    assert_shown(&window, "Now", "Y Position", "-1.226 m");
    assert_shown(&window, "Now", "Y Velocity", "-4.905 m/s");
    assert_shown(&window, "Global Position", "Y", "0.00000 m");
    g_autoptr(TinkerPropertyRow) reading = find_row(&window, "Now", "Speed");
    g_assert_null(reading->set);

    /* The spring's length is that of the present too. */
    select_block(&window, "Spring 0");
    g_autoptr(TinkerPropertyRow) length = find_row(&window, "Spring Properties", "Length"),
                                 now = find_row(&window, "Now", "Length");
    g_assert_cmpfloat_with_epsilon(g_ascii_strtod(length->text, NULL), g_ascii_strtod(now->text, NULL), 5e-4);
    g_assert_cmpstr(length->text, !=, "3.57771 m"); /* hypot(3.2, 1.6), as placed */
}

/* What the outline says of blocks. */
static void test_words(void)
{
    g_auto(Window) window =
        window_with(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING ", {\"type\": \"gravity\", \"name\": \"G\"},"
                             "{\"type\": \"motor\", \"name\": \"M\", \"ends\": [[0, 0]]},"
                             "{\"type\": \"nobody\", \"name\": \"P\"}");
    static const char *const words[] = {"Mass 0, Mass, at (3.20000 m, 2.40000 m)",
                                        "Support 0, Support, at (0.00000 m, 4.00000 m)",
                                        "Spring 0, Spring, from Support 0 to Mass 0",
                                        "G, Gravity",
                                        "M, Motor, on a loose end",
                                        "P, nobody"};
    TinkerScene *scene = tinker_document_scene(window.document);
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        g_autofree char *said = tinker_block_words(scene, tinker_scene_block_at(scene, (int32_t)i));
        g_assert_cmpstr(said, ==, words[i]);
    }
    go_english(&window);
    g_autofree char *said = tinker_block_words(scene, tinker_scene_block_at(scene, 0));
    g_assert_cmpstr(said, ==, "Mass 0, Mass, at (10.49869 ft, 7.87402 ft)");
}

/* A block of a type that nobody provides can still be renamed. */
static void test_placeholder(void)
{
    g_auto(Window) window = window_with("{\"type\": \"nobody\", \"name\": \"P\", \"ratio\": 2}");
    select_block(&window, "P");
    g_autofree char *before = scene_text(&window);
    assert_shown(&window, "Appearance", "Type", "nobody (not installed)");
    type_into(&window, "Appearance", "Name", "Q");
    assert_undoes(&window, before);
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-list/words", test_words);
    g_test_add_func("/gui/property-list/placeholder", test_placeholder);
    g_test_add_func("/gui/property-list/thesis-strings", test_thesis_strings);
    g_test_add_func("/gui/property-list/motor-strings", test_motor_strings);
    g_test_add_func("/gui/property-list/support-strings", test_support_strings);
    g_test_add_func("/gui/property-list/spring-strings", test_spring_strings);
    g_test_add_func("/gui/property-list/trimmed", test_trimmed);
    g_test_add_func("/gui/property-list/order", test_order);
    g_test_add_func("/gui/property-list/units", test_units);
    g_test_add_func("/gui/property-list/unchanged", test_unchanged);
    g_test_add_func("/gui/property-list/refused", test_refused);
    g_test_add_func("/gui/property-list/name", test_name);
    g_test_add_func("/gui/property-list/any-text", test_any_text);
    g_test_add_func("/gui/property-list/offset", test_offset);
    g_test_add_func("/gui/property-list/offset-stretches", test_offset_stretches);
    g_test_add_func("/gui/property-list/ends", test_ends);
    g_test_add_func("/gui/property-list/as-placed", test_as_placed);
    g_test_add_func("/gui/property-list/motion", test_motion);
    g_test_add_func("/gui/property-list/two-motions", test_two_motions);
    g_test_add_func("/gui/property-list/several", test_several);
    g_test_add_func("/gui/property-list/friction-of-several", test_friction_of_several);
    g_test_add_func("/gui/property-list/every-kind", test_every_kind);
    g_test_add_func("/gui/property-list/vectors", test_vectors);
    g_test_add_func("/gui/property-list/scene", test_scene);
    g_test_add_func("/gui/property-list/now", test_now);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
