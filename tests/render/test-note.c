/* Notes: their ink grows with what they say, stays within the bounds that the block declares, and is where it is hit.
 */
#include <math.h>

#include "render/draw/style.h"
#include "render/picture/note.h"
#include "scene-fixture.h"
#include "scene/frame/frame.h"

#define SCALE  50.0 /* canvas units a metre */
#define SYMBOL 0.4  /* m */

typedef struct {
    double x, y, width, height; /* of the ink; canvas units, from the left and top */
} Ink;

static Ink ink_of(const TinkerInstance *instance, const TinkerRender *render, const char *text, double height)
{
    const TinkerView view = {SCALE, 500, 400, 1000, 800};
    TinkerStyleBrush brush;
    Ink ink;
    cairo_surface_t *surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cairo = cairo_create(surface);
    tinker_style_begin(&brush, cairo, tinker_theme_find("light"), &view, SYMBOL);
    brush.style.note = tinker_note_draw;
    tinker_style_enter_world(&brush.style, cairo);
    if (render != NULL)
        render->draw(instance, cairo, &brush.style);
    else
        tinker_note_draw(&brush.style, cairo, TINKER_COLOUR_TEXT, 0, 0, height, text);
    tinker_style_end(&brush);
    cairo_destroy(cairo);
    cairo_recording_surface_ink_extents(surface, &ink.x, &ink.y, &ink.width, &ink.height);
    cairo_surface_destroy(surface);
    return ink;
}

static Ink ink_of_text(const char *text)
{
    return ink_of(NULL, NULL, text, 0.4);
}

static void test_ink(void)
{
    const Ink one = ink_of_text("Hello"), two = ink_of_text("Hello\nHello"), typed = ink_of_text("Hello\\nHello");
    g_assert_cmpfloat_with_epsilon(one.x + one.width / 2, 500, 2);
    g_assert_cmpfloat(fabs(one.y + one.height / 2 - 400), <, 0.4 * SCALE);
    g_assert_cmpfloat_with_epsilon(two.width, one.width, 1e-6);
    g_assert_cmpfloat(two.height, >, one.height + 0.4 * SCALE);
    g_assert_cmpmem(&typed, sizeof typed, &two, sizeof two);
    const Ink fraction = ink_of_text("$k/m$"), plain = ink_of_text("$k$");
    g_assert_cmpfloat(fraction.height, >, 1.5 * plain.height);
    /* what is no formula is written as it was typed, and a dollar sign alone is one */
    g_assert_cmpfloat(ink_of_text("$k/$").width, >, ink_of_text("k/").width);
    g_assert_cmpfloat(ink_of_text("$2 k$").width, >, ink_of_text("$2*k$").width);
    g_assert_cmpfloat(ink_of_text("5 $").width, >, ink_of_text("5").width);
    const Ink nothing[] = {ink_of_text(""), ink_of_text("$$"), ink_of(NULL, NULL, "Hello", 0.001),
                           ink_of(NULL, NULL, "Hello", NAN)};
    for (gsize i = 0; i < G_N_ELEMENTS(nothing); i++)
        g_assert_cmpfloat(nothing[i].width, ==, 0);
}

/* The texts of an instance are those of its properties, and the default where there is none. */
static void test_block(void)
{
    static const char *const texts[] = {
        NULL,   "Hello",    "It swings with\\n$omega = sqrt(k/m_1)$ = 5 rad/s,\\nwhatever.", "$a = (b/c)^2$",
        "WWWW", "ÄÖÜ\\näöü"};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        g_autofree char *given = texts[i] != NULL ? g_strescape(texts[i], "ÄÖÜäöü") : NULL;
        g_autofree char *blocks = given != NULL
                                      ? g_strdup_printf("{\"type\": \"note\", \"text\": \"%s\", \"size\": 2}", given)
                                      : g_strdup("{\"type\": \"note\"}");
        g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks);
        g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
        const TinkerBlockId note = tinker_scene_find_block(scene, "Note 0");
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, note);
        TinkerInstance instance;
        tinker_frame_set_symbol_size(frame, SYMBOL);
        g_assert_true(tinker_frame_instance(frame, note, &instance));
        g_assert_cmpint(instance.text_count, ==, 1);
        g_assert_cmpstr(instance.texts[0], ==, texts[i] != NULL ? texts[i] : "Note");
        const Ink ink = ink_of(&instance, block_class->render, NULL, 0);
        TinkerStyle style = {.struct_size = sizeof style, .symbol_size = SYMBOL, .pixel = 1 / SCALE};
        double box[4];
        block_class->render->bounds(&instance, &style, box);
        g_assert_cmpfloat(ink.width, >, 10);
        g_assert_cmpfloat(ink.x, >=, 500 + SCALE * box[0]);
        g_assert_cmpfloat(ink.x + ink.width, <=, 500 + SCALE * box[2]);
        g_assert_cmpfloat(ink.y, >=, 400 - SCALE * box[3]);
        g_assert_cmpfloat(ink.y + ink.height, <=, 400 - SCALE * box[1]);
        const double left = (ink.x - 500) / SCALE;
        g_assert_cmpint(block_class->edit->hit(&instance, 0.5 * left, 0, 0.01), ==, TINKER_PART_WHOLE);
        g_assert_cmpint(block_class->edit->hit(&instance, box[0] - 0.1, 0, 0.01), ==, TINKER_PART_NONE);
    }
}

static void add_tests(void)
{
    g_test_add_func("/render/note/ink", test_ink);
    g_test_add_func("/render/note/block", test_block);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
