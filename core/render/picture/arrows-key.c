/* Rows from the bottom up, over a ground that lets what lies beneath shine through: the kinds, above them the marks of
 * paths, and above those the lengths. */
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
#define MARKS        3   /* of a path */
#define MARK         2.5 /* their radius */
#define GROUND_ALPHA 0.86

double tinker_arrows_key_value(const TinkerView *view, double scale, double unit)
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
    case TINKER_ARROW_ACCELERATION:
        return theme->curves[1];
    case TINKER_ARROW_NET:
        return theme->curves[6];
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

static void draw_marks(cairo_t *cairo, double x, double y, double length)
{
    for (int k = 0; k < MARKS; k++) {
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, x + MARK + k * (length - 2 * MARK) / (MARKS - 1), y, MARK, 0, 2 * G_PI);
    }
    cairo_fill(cairo);
}

static void draw_swatch(cairo_t *cairo, double x, double y, double length)
{
    cairo_rectangle(cairo, x, y - SHAFT / 2, length, SHAFT);
    cairo_fill(cairo);
}

static gsize scale_rows(const TinkerArrowKey *key)
{
    return key->length_count + (key->marks != NULL);
}

/* Whether the kinds have room: in a small picture the key would lie over most of it. */
static gboolean has_room_for_words(const TinkerView *view, const TinkerArrowKey *key)
{
    return ROW * (double)(key->word_count + scale_rows(key)) + 2 * PAD <= view->height / 3;
}

/* One row: what stands before its text, and the text. */
typedef struct {
    double before;        /* canvas units */
    const char *label;    /* borrowed, as is */
    const double *colour; /* of what is drawn */
    void (*draw)(cairo_t *cairo, double x, double y, double length);
} Row;

/* From the top down. Element: Row. (transfer full) */
static GArray *rows_of(const TinkerTheme *theme, const TinkerView *view, const TinkerArrowKey *key)
{
    GArray *rows = g_array_new(FALSE, FALSE, sizeof(Row));
    const double *ink = theme->colours[TINKER_COLOUR_TEXT];
    for (gsize i = 0; i < key->length_count; i++) {
        const TinkerArrowLength *length = &key->lengths[i];
        const Row row = {length->length, length->label, length->colour != NULL ? length->colour : ink, draw_line};
        if (length->length > 0 && isfinite(length->length)) g_array_append_val(rows, row);
    }
    const Row marks = {SWATCH, key->marks, theme->colours[TINKER_COLOUR_MOTION], draw_marks};
    if (key->marks != NULL) g_array_append_val(rows, marks);
    if (rows->len == 0 && key->length_count > 0) return rows;
    for (gsize i = 0; i < key->word_count && has_room_for_words(view, key); i++) {
        const Row row = {SWATCH, key->words[i].word, tinker_arrow_colour(theme, key->words[i].kind), draw_swatch};
        g_array_append_val(rows, row);
    }
    return rows;
}

/* The box of the rows, with the room around them. */
static void box_of(const TinkerView *view, const GArray *rows, double box[4])
{
    double widest = 0;
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    for (guint i = 0; i < rows->len; i++) {
        const Row *row = &g_array_index(rows, Row, i);
        const TinkerText text = {.text = row->label, .size = TINKER_STYLE_TEXT};
        double width, height;
        tinker_text_measure(&pen, &text, &width, &height);
        widest = fmax(widest, row->before + width);
    }
    tinker_text_pen_clear(&pen);
    box[0] = CORNER;
    box[1] = view->height - CORNER - 2 * PAD - ROW * rows->len;
    box[2] = CORNER + widest + GAP + 2 * PAD;
    box[3] = view->height - CORNER;
}

gboolean tinker_arrows_key_box(const TinkerView *view, const TinkerTheme *theme, const TinkerArrowKey *key,
                               double box[4])
{
    g_autoptr(GArray) rows = rows_of(theme, view, key);
    if (rows->len > 0) box_of(view, rows, box);
    return rows->len > 0;
}

void tinker_arrows_draw_key(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, const TinkerArrowKey *key,
                            GPtrArray *written)
{
    g_autoptr(GArray) rows = rows_of(theme, view, key);
    if (rows->len == 0) return;
    double box[4];
    box_of(view, rows, box);
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerText text = {.size = TINKER_STYLE_TEXT, .anchor_y = 0.5};
    pen.written = written;
    const double x = box[0] + PAD;
    double y = box[1] + PAD + ROW / 2;
    cairo_save(cairo);
    set_colour(cairo, theme->background, GROUND_ALPHA);
    cairo_rectangle(cairo, box[0], box[1], box[2] - box[0], box[3] - box[1]);
    cairo_fill(cairo);
    for (guint i = 0; i < rows->len; i++, y += ROW) {
        const Row *row = &g_array_index(rows, Row, i);
        set_colour(cairo, row->colour, 1);
        row->draw(cairo, x, y, row->before);
        set_colour(cairo, theme->colours[TINKER_COLOUR_TEXT], 1);
        text.text = row->label;
        tinker_text_draw(&pen, cairo, &text, x + row->before + GAP, y);
    }
    cairo_restore(cairo);
    tinker_text_pen_clear(&pen);
}
