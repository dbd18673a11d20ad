/* The helpers' ink: within its bounds, at both ends, at the tip; and what the states make of it. */
#include <math.h>
#include <tinker/shapes.h>

#include "picture.h"
#include "render/draw/style.h"

#define SIZE  400
#define SCALE 50.0

typedef struct {
    TestPicture *picture;
    TinkerView view;
    TinkerStyleBrush brush;
    const TinkerStyle *style;
    cairo_t *cairo;
} Sheet;

static void sheet_begin(Sheet *sheet, uint32_t state)
{
    sheet->picture = test_picture_new(SIZE, SIZE);
    sheet->view =
        (TinkerView){.scale = SCALE, .origin_x = SIZE / 2, .origin_y = SIZE / 2, .width = SIZE, .height = SIZE};
    sheet->cairo = sheet->picture->cairo;
    tinker_style_begin(&sheet->brush, sheet->cairo, tinker_theme_find("light"), &sheet->view, 0.4);
    sheet->brush.style.state = state;
    sheet->style = &sheet->brush.style;
    tinker_style_enter_world(sheet->style, sheet->cairo);
}

static void sheet_end(Sheet *sheet)
{
    cairo_restore(sheet->cairo);
    tinker_style_end(&sheet->brush);
    test_picture_free(sheet->picture);
}

static gboolean ink_at(const Sheet *sheet, double x, double y, int reach)
{
    double canvas_x, canvas_y;
    tinker_view_to_canvas(&sheet->view, x, y, &canvas_x, &canvas_y);
    return test_picture_has_ink(sheet->picture, canvas_x, canvas_y, reach);
}

typedef enum { LINE, COIL, DASHPOT, BAR, ARROW, HATCH, SYMBOLS } Symbol;

static void draw_symbol(const TinkerStyle *style, cairo_t *cairo, Symbol symbol, const double l[4], double rest)
{
    switch (symbol) {
    case LINE:
        style->line(style, cairo, TINKER_COLOUR_CONNECTOR, l[0], l[1], l[2], l[3]);
        break;
    case COIL:
        style->coil(style, cairo, TINKER_COLOUR_CONNECTOR, l[0], l[1], l[2], l[3], rest);
        break;
    case DASHPOT:
        style->dashpot(style, cairo, TINKER_COLOUR_CONNECTOR, l[0], l[1], l[2], l[3]);
        break;
    case BAR:
        style->bar(style, cairo, TINKER_COLOUR_CONNECTOR, l[0], l[1], l[2], l[3]);
        break;
    case ARROW:
        style->arrow(style, cairo, TINKER_COLOUR_FORCE, l[0], l[1], l[2], l[3]);
        break;
    default:
        style->hatch(style, cairo, TINKER_COLOUR_CONNECTOR, l[0], l[1], l[2], l[3]);
    }
}

/* Ink of a symbol, as least and greatest x and y in the world; FALSE where there is none. */
static gboolean ink_box(Symbol symbol, const double l[4], double rest, uint32_t state, double *margin, double box[4])
{
    cairo_surface_t *surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cairo = cairo_create(surface);
    TinkerView view = {.scale = SCALE, .origin_x = SIZE / 2, .origin_y = SIZE / 2, .width = SIZE, .height = SIZE};
    TinkerStyleBrush brush;
    double x, y, width, height;
    tinker_style_begin(&brush, cairo, tinker_theme_find("light"), &view, 0.4);
    brush.style.state = state;
    *margin = tinker_drawing_margin(&brush.style);
    tinker_style_enter_world(&brush.style, cairo);
    draw_symbol(&brush.style, cairo, symbol, l, rest);
    g_assert_cmpint(cairo_status(cairo), ==, CAIRO_STATUS_SUCCESS);
    cairo_restore(cairo);
    tinker_style_end(&brush);
    cairo_destroy(cairo);
    cairo_recording_surface_ink_extents(surface, &x, &y, &width, &height);
    cairo_surface_destroy(surface);
    tinker_view_to_world(&view, x, y + height, &box[0], &box[1]);
    tinker_view_to_world(&view, x + width, y, &box[2], &box[3]);
    return width > 0 && height > 0;
}

/* The margin that the SDK tells blocks to declare holds every helper's ink, whatever its state and direction. */
static void test_bounds(void)
{
    for (int i = 0; i < 600; i++) {
        Symbol symbol = (Symbol)(i % SYMBOLS);
        double l[4], box[4], margin;
        for (int n = 0; n < 4; n++)
            l[n] = g_test_rand_double_range(-3, 3);
        uint32_t state = 1u << g_test_rand_int_range(0, 4);
        if (!ink_box(symbol, l, g_test_rand_double_range(-1, 8), state, &margin, box)) continue;
        g_assert_cmpfloat(box[0], >=, fmin(l[0], l[2]) - margin);
        g_assert_cmpfloat(box[1], >=, fmin(l[1], l[3]) - margin);
        g_assert_cmpfloat(box[2], <=, fmax(l[0], l[2]) + margin);
        g_assert_cmpfloat(box[3], <=, fmax(l[1], l[3]) + margin);
    }
}

static void test_ends(void)
{
    for (int i = 0; i < 60; i++) {
        double angle = g_test_rand_double_range(-G_PI, G_PI), length = g_test_rand_double_range(0.1, 3);
        const double l[4] = {0.1, -0.2, 0.1 + length * cos(angle), -0.2 + length * sin(angle)};
        for (Symbol symbol = LINE; symbol <= BAR; symbol++) {
            Sheet sheet;
            sheet_begin(&sheet, 0);
            draw_symbol(sheet.style, sheet.cairo, symbol, l, 1);
            /* A bar's ends are round about the points, and those lie inside it. */
            int reach = symbol == BAR ? 4 : 1;
            g_assert_true(ink_at(&sheet, l[0], l[1], reach));
            g_assert_true(ink_at(&sheet, l[2], l[3], reach));
            sheet_end(&sheet);
        }
    }
}

/* The tip is at the second point, nothing lies beyond it, and the head is wider than the shaft. */
static void test_arrow(void)
{
    static const double lengths[] = {0.05, 0.4, 2};
    for (int i = 0; i < 24; i++) {
        double angle = i * G_PI / 12, length = lengths[i % 3], ux = cos(angle), uy = sin(angle);
        Sheet sheet;
        sheet_begin(&sheet, 0);
        draw_symbol(sheet.style, sheet.cairo, ARROW, (double[]){0, 0, length * ux, length * uy}, 0);
        g_assert_true(ink_at(&sheet, (length - 0.06) * ux, (length - 0.06) * uy, 1));
        g_assert_false(ink_at(&sheet, (length + 0.08) * ux, (length + 0.08) * uy, 1));
        double wide = length - 0.28, side = 0.09;
        g_assert_true(ink_at(&sheet, wide * ux - side * uy, wide * uy + side * ux, 0));
        g_assert_true(ink_at(&sheet, wide * ux + side * uy, wide * uy - side * ux, 0));
        if (length > 1) g_assert_false(ink_at(&sheet, 0.5 * ux - side * uy, 0.5 * uy + side * ux, 0));
        sheet_end(&sheet);
    }
}

/* Turns: counted as crossings of the axis along the coil. */
static int crossings(double length, double rest)
{
    Sheet sheet;
    sheet_begin(&sheet, 0);
    sheet.style->coil(sheet.style, sheet.cairo, TINKER_COLOUR_CONNECTOR, -length / 2, 0, length / 2, 0, rest);
    /* A line over the axis and below the tips crosses each turn twice. */
    int runs = 0;
    gboolean inside = FALSE;
    for (double x = 0; x < SIZE; x++) {
        gboolean ink = test_picture_has_ink(sheet.picture, x, SIZE / 2 - 0.06 * SCALE, 0);
        runs += ink && !inside;
        inside = ink;
    }
    sheet_end(&sheet);
    return runs;
}

static void test_coil_turns(void)
{
    int at_rest = crossings(3, 2);
    g_assert_cmpint(at_rest, >=, 6);
    g_assert_cmpint(crossings(5, 2), ==, at_rest);
    g_assert_cmpint(crossings(2.4, 2), ==, at_rest);
    g_assert_cmpint(crossings(5, 3.5), >, at_rest);
}

/* Hatching lies on the right-hand side of its line. */
static void test_hatch_side(void)
{
    double box[4], margin;
    g_assert_true(ink_box(HATCH, (double[]){-1, 0, 1, 0}, 0, 0, &margin, box));
    g_assert_cmpfloat(box[3], <, 0.05);
    g_assert_cmpfloat(box[1], <, -0.1);
    g_assert_true(ink_box(HATCH, (double[]){1, 0, -1, 0}, 0, 0, &margin, box));
    g_assert_cmpfloat(box[1], >, -0.05);
    g_assert_cmpfloat(box[3], >, 0.1);
}

/* Detached: grey whatever the colour asked for, and with gaps along the line. */
static void test_detached(void)
{
    const double *grey = tinker_theme_find("light")->colours[TINKER_COLOUR_DETACHED];
    const double *red = tinker_theme_find("light")->colours[TINKER_COLOUR_COMPRESSED];
    for (int detached = 0; detached < 2; detached++) {
        Sheet sheet;
        sheet_begin(&sheet, detached ? TINKER_STATE_DETACHED : 0);
        sheet.style->line(sheet.style, sheet.cairo, TINKER_COLOUR_COMPRESSED, -2, 0, 2, 0);
        int gaps = 0;
        for (int x = SIZE / 2 - 99; x < SIZE / 2 + 99; x++)
            gaps += !test_picture_has_ink(sheet.picture, x, SIZE / 2, 0) &&
                    !test_picture_has_ink(sheet.picture, x, SIZE / 2 - 1, 0);
        if (detached) {
            g_assert_cmpint(gaps, >, 20);
            g_assert_cmpint(test_picture_count(sheet.picture, red), ==, 0);
            g_assert_cmpint(test_picture_count(sheet.picture, grey), >, 20);
        } else {
            g_assert_cmpint(gaps, ==, 0);
            g_assert_cmpint(test_picture_count(sheet.picture, red), >, 100);
        }
        sheet_end(&sheet);
    }
}

static void test_end_marks(void)
{
    const double *red = tinker_theme_find("light")->colours[TINKER_COLOUR_COMPRESSED];
    for (int attached = 0; attached < 2; attached++) {
        Sheet sheet;
        sheet_begin(&sheet, TINKER_STATE_DETACHED);
        sheet.style->end_mark(sheet.style, sheet.cairo, 0, 0, attached);
        /* A cross has ink at its centre, a ring has none. */
        g_assert_cmpint(ink_at(&sheet, 0, 0, 0), ==, attached);
        g_assert_cmpint(test_picture_count(sheet.picture, red) > 5, ==, attached);
        sheet_end(&sheet);
    }
}

/* Selected and highlighted blocks have more ink about them, in the colour of their state. */
static void test_emphasis(void)
{
    for (Symbol symbol = LINE; symbol <= ARROW; symbol++) {
        const double l[4] = {-2, -1, 2, 1};
        double plain[4], selected[4], margin;
        g_assert_true(ink_box(symbol, l, 3, 0, &margin, plain));
        g_assert_true(ink_box(symbol, l, 3, TINKER_STATE_SELECTED, &margin, selected));
        g_assert_cmpfloat(selected[0], <, plain[0] - 0.5 / SCALE);
        g_assert_cmpfloat(selected[3], >, plain[3] + 0.5 / SCALE);
    }
}

/* However far away the view is, a line is at least about a device pixel wide. */
static void test_least_width(void)
{
    for (double scale = 1e-3; scale < 1e3; scale *= 10) {
        g_autoptr(TestPicture) picture = test_picture_new(64, 64);
        TinkerView view = {.scale = scale, .origin_x = 32, .origin_y = 32, .width = 64, .height = 64};
        TinkerStyleBrush brush;
        tinker_style_begin(&brush, picture->cairo, tinker_theme_find("light"), &view, 1e-3);
        g_assert_cmpfloat(brush.style.line_width * scale, >=, 1 - 1e-9);
        tinker_style_enter_world(&brush.style, picture->cairo);
        brush.style.line(&brush.style, picture->cairo, TINKER_COLOUR_CONNECTOR, -20 / scale, 0, 20 / scale, 0);
        cairo_restore(picture->cairo);
        g_assert_true(test_picture_has_ink(picture, 32, 32, 1));
        tinker_style_end(&brush);
    }
}

/* Nothing that a block asks for breaks the context. */
static void test_odd_numbers(void)
{
    static const double odd[] = {0, 1, NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-300, 1e7, -1};
    Sheet sheet;
    sheet_begin(&sheet, 0);
    const TinkerStyle *style = sheet.style;
    for (int i = 0; i < 3000; i++) {
        double n[6];
        for (int k = 0; k < 6; k++)
            n[k] = odd[g_test_rand_int_range(0, G_N_ELEMENTS(odd))];
        sheet.brush.style.state = (uint32_t)g_test_rand_int_range(0, 8);
        draw_symbol(style, sheet.cairo, (Symbol)g_test_rand_int_range(0, SYMBOLS), n, n[4]);
        style->box(style, sheet.cairo, 0, i % 3 - 1, n[0], n[1], n[2], n[3], n[4]);
        style->circle(style, sheet.cairo, i % 3 - 1, 99, n[0], n[1], n[2]);
        style->end_mark(style, sheet.cairo, n[0], n[1], i % 2);
        g_assert_cmpint(cairo_status(sheet.cairo), ==, CAIRO_STATUS_SUCCESS);
    }
    style->text(style, sheet.cairo, -5, NAN, 0, "x");
    style->text(style, sheet.cairo, 77, 0, 0, "\xff\xfe not UTF-8");
    style->text(style, sheet.cairo, TINKER_COLOUR_TEXT, 0, 0, NULL);
    style->text(style, sheet.cairo, TINKER_COLOUR_TEXT, 0, 0, "");
    sheet_end(&sheet);
}

static void test_text_is_upright(void)
{
    Sheet sheet;
    sheet_begin(&sheet, 0);
    /* An L has its bar at the bottom. */
    sheet.style->text(sheet.style, sheet.cairo, TINKER_COLOUR_TEXT, 0, 0, "LLLLLLLL");
    int upper = 0, lower = 0;
    for (int x = SIZE / 2 - 40; x < SIZE / 2 + 40; x++)
        for (int y = 1; y <= 8; y++) {
            upper += test_picture_has_ink(sheet.picture, x, SIZE / 2 - y, 0);
            lower += test_picture_has_ink(sheet.picture, x, SIZE / 2 + y, 0);
        }
    g_assert_cmpint(lower, >, upper);
    sheet_end(&sheet);
}

/* Numbers of two blocks at one body: neither lies on the other, one that is drawn again is where it was, and what is
 * far away is not moved. */
static void test_texts_keep_apart(void)
{
    static const struct {
        double x, y;
        const char *text;
    } written[] = {{0, 0, "1.234 m"}, {0.05, 0.02, "45.0\302\260"}, {0.05, 0.02, "45.0\302\260"}, {0, -1, "2 m"}};
    Sheet sheet;
    sheet_begin(&sheet, 0);
    g_autoptr(GPtrArray) texts = sheet.brush.pen.written = tinker_written_texts_new();
    double middle[G_N_ELEMENTS(written)][2], half = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(written); i++) {
        cairo_save(sheet.cairo);
        sheet.style->text(sheet.style, sheet.cairo, TINKER_COLOUR_TEXT, written[i].x, written[i].y, written[i].text);
        cairo_restore(sheet.cairo);
        const double *box = ((const TinkerWrittenText *)texts->pdata[i])->box;
        for (int k = 0; k < 2; k++)
            middle[i][k] = (k == 0 ? SCALE * written[i].x : -SCALE * written[i].y) + (box[k] + box[2 + k]) / 2;
        half = (box[3] - box[1]) / 2;
    }
    g_assert_cmpfloat_with_epsilon(middle[0][1], 0, 1e-9);
    g_assert_cmpfloat(fabs(middle[1][1] - middle[0][1]), >=, 2 * half - 1);
    g_assert_cmpfloat(fabs(middle[1][1] - middle[0][1]), <, 4 * half);
    g_assert_cmpfloat_with_epsilon(middle[2][1], middle[1][1], 1e-9);
    g_assert_cmpfloat_with_epsilon(middle[3][1], SCALE, 1e-9);
    sheet_end(&sheet);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/helpers/bounds", test_bounds);
    g_test_add_func("/render/helpers/ends", test_ends);
    g_test_add_func("/render/helpers/arrow", test_arrow);
    g_test_add_func("/render/helpers/coil-turns", test_coil_turns);
    g_test_add_func("/render/helpers/hatch-side", test_hatch_side);
    g_test_add_func("/render/helpers/detached", test_detached);
    g_test_add_func("/render/helpers/end-marks", test_end_marks);
    g_test_add_func("/render/helpers/emphasis", test_emphasis);
    g_test_add_func("/render/helpers/least-width", test_least_width);
    g_test_add_func("/render/helpers/odd-numbers", test_odd_numbers);
    g_test_add_func("/render/helpers/text-is-upright", test_text_is_upright);
    g_test_add_func("/render/helpers/texts-keep-apart", test_texts_keep_apart);
    return g_test_run();
}
