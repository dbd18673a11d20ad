/* Rows from the bottom up, over a ground that lets what lies beneath shine through: the kinds, and above them the
 * length. */
#include "render/picture/arrows-private.h"

#include <math.h>

#include "render/draw/strokes.h"
#include "render/draw/text.h"

/* Canvas units. */
#define LEAST_LENGTH 24.0 /* of the line, which is at most 2.5 times as long */
#define CORNER       10.0
#define PAD          6.0
#define ROW          18.0
#define GAP          6.0
#define SWATCH       16.0 /* the length of a piece of an arrow */
#define SHAFT        3.0
#define TICK         4.0 /* half the height of the line's ends */
#define GROUND_ALPHA 0.86

double tinker_arrows_key_force(const TinkerView *view, double scale, double unit)
{
    static const double mantissas[] = {1, 2, 5, 10};
    double least = LEAST_LENGTH / (scale * view->scale * unit);
    if (!(least > 0) || !isfinite(least)) return 0;
    double decade = pow(10, floor(log10(least)));
    gsize i = 0;
    while (i + 1 < G_N_ELEMENTS(mantissas) && mantissas[i] * decade < least)
        i++;
    return mantissas[i] * decade * unit;
}

const double *tinker_arrow_colour(const TinkerTheme *theme, TinkerArrowKind kind)
{
    switch (kind) {
    case TINKER_ARROW_FIELD:
        return theme->colours[TINKER_COLOUR_FIELD];
    case TINKER_ARROW_NORMAL:
        return theme->curves[2];
    case TINKER_ARROW_FRICTION:
        return theme->curves[7];
    case TINKER_ARROW_CONNECTOR:
        return theme->curves[0];
    case TINKER_ARROW_CONSTRAINT:
        return theme->curves[3];
    case TINKER_ARROW_MOTION:
        return theme->colours[TINKER_COLOUR_MOTION];
    default:
        return theme->colours[TINKER_COLOUR_FORCE];
    }
}

static void set_colour(cairo_t *cairo, const double colour[4], double alpha)
{
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], alpha * colour[3]);
}

static void draw_line(cairo_t *cairo, double x, double y, double length)
{
    cairo_move_to(cairo, x, y - TICK);
    cairo_line_to(cairo, x, y + TICK);
    cairo_move_to(cairo, x, y);
    cairo_line_to(cairo, x + length, y);
    cairo_move_to(cairo, x + length, y - TICK);
    cairo_line_to(cairo, x + length, y + TICK);
    cairo_set_line_width(cairo, 2);
    cairo_stroke(cairo);
}

/* Whether the kinds have room: in a small picture the key would lie over most of it. */
static gboolean has_room_for_words(const TinkerView *view, const TinkerArrowKey *key)
{
    return ROW * (double)(key->word_count + 1) + 2 * PAD <= view->height / 3;
}

void tinker_arrows_draw_key(cairo_t *cairo, const TinkerView *view, const TinkerArrowOptions *options,
                            const TinkerArrowKey *key, GPtrArray *written)
{
    const TinkerTheme *theme = options->theme;
    const double length = key->force * options->scale * view->scale, *ink = theme->colours[TINKER_COLOUR_TEXT];
    double widest, height;
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerText text = {.text = key->label, .size = TINKER_STYLE_TEXT, .anchor_y = 0.5};
    if (!(length > 0) || !isfinite(length)) return;
    pen.written = written;
    tinker_text_measure(&pen, &text, &widest, &height);
    widest += length;
    const gsize words = has_room_for_words(view, key) ? key->word_count : 0;
    for (gsize i = 0; i < words; i++) {
        double width;
        text.text = key->words[i].word;
        tinker_text_measure(&pen, &text, &width, &height);
        widest = fmax(widest, SWATCH + width);
    }
    const double down = ROW * (double)(words + 1);
    double x = CORNER + PAD, y = view->height - CORNER - PAD - down + ROW / 2;
    cairo_save(cairo);
    set_colour(cairo, theme->background, GROUND_ALPHA);
    cairo_rectangle(cairo, CORNER, view->height - CORNER - 2 * PAD - down, widest + GAP + 2 * PAD, down + 2 * PAD);
    cairo_fill(cairo);
    set_colour(cairo, ink, 1);
    draw_line(cairo, x, y, length);
    text.text = key->label;
    tinker_text_draw(&pen, cairo, &text, x + length + GAP, y);
    for (gsize i = 0; i < words; i++) {
        y += ROW;
        set_colour(cairo, tinker_arrow_colour(theme, key->words[i].kind), 1);
        cairo_rectangle(cairo, x, y - SHAFT / 2, SWATCH, SHAFT);
        cairo_fill(cairo);
        set_colour(cairo, ink, 1);
        text.text = key->words[i].word;
        tinker_text_draw(&pen, cairo, &text, x + SWATCH + GAP, y);
    }
    cairo_restore(cairo);
    tinker_text_pen_clear(&pen);
}
