/* Everything is laid out in canvas units, y down, on a context that is scaled so; lines first, then all of them. */
#include "render/picture/note.h"

#include <math.h>
#include <string.h>

#include "law/written-formula.h"
#include "render/draw/strokes.h"
#include "render/formula/formula.h"

#define LEAST_LETTERS 3.0 /* canvas units: smaller ones cannot be read */
#define ABOVE         0.8 /* of the letters: of a line, at the least */
#define BELOW         0.25
#define APART         0.3 /* between two lines */

/* A part of a line: text, or a formula. */
typedef struct {
    char *text;
    TinkerMathText *formula; /* NULL: text */
    double width;
} Part;

typedef struct {
    GArray *parts; /* of Part */
    double width, above, below;
} Line;

static void clear_part(gpointer data)
{
    Part *part = data;
    g_free(part->text);
    g_clear_pointer(&part->formula, tinker_math_text_free);
}

static void clear_line(gpointer data)
{
    g_array_unref(((Line *)data)->parts);
}

static TinkerText plain_text(const Part *part, double size)
{
    return (TinkerText){.text = part->text, .size = size};
}

/* What is no formula in the grammar is written as it was typed, dollar signs and all: so it can be seen that it is
 * none.
 */
static void add_part(Line *line, TinkerTextPen *pen, const char *text, gsize length, gboolean is_formula, double size)
{
    if (length == 0) return;
    Part part = {.text = g_strndup(text, length)};
    double above, below = 0;
    g_autofree char *mathml = is_formula ? tinker_written_formula_mathml(part.text, NULL) : NULL;
    if (mathml != NULL) part.formula = tinker_math_text_new(mathml, size, NULL);
    if (part.formula != NULL) {
        tinker_math_text_measure(part.formula, &part.width, &above, &below);
    } else {
        if (is_formula) {
            g_free(part.text);
            part.text = g_strndup(text - 1, length + 2);
        }
        const TinkerText plain = plain_text(&part, size);
        tinker_text_measure_ink(pen, &plain, &part.width, &above, &below);
    }
    line->width += part.width;
    line->above = fmax(line->above, above);
    line->below = fmax(line->below, below);
    g_array_append_val(line->parts, part);
}

/* A dollar sign without another after it is one. */
static Line lay_out(TinkerTextPen *pen, const char *text, double size)
{
    Line line = {.parts = g_array_new(FALSE, FALSE, sizeof(Part)), .above = ABOVE * size, .below = BELOW * size};
    g_array_set_clear_func(line.parts, clear_part);
    for (const char *open = strchr(text, '$'), *close; open != NULL; open = strchr(text, '$')) {
        close = strchr(open + 1, '$');
        if (close == NULL) break;
        add_part(&line, pen, text, (gsize)(open - text), FALSE, size);
        add_part(&line, pen, open + 1, (gsize)(close - open - 1), TRUE, size);
        text = close + 1;
    }
    add_part(&line, pen, text, strlen(text), FALSE, size);
    return line;
}

static void draw_line(TinkerTextPen *pen, cairo_t *cairo, const Line *line, double x, double y, double size)
{
    for (guint i = 0; i < line->parts->len; i++) {
        const Part *part = &g_array_index(line->parts, Part, i);
        if (part->formula != NULL) {
            tinker_math_text_draw(part->formula, cairo, x, y);
        } else {
            const TinkerText plain = plain_text(part, size);
            tinker_text_draw_on_line(pen, cairo, &plain, x, y);
        }
        x += part->width;
    }
}

/* (transfer full) */
static GArray *lines_of(TinkerTextPen *pen, const char *text, double size)
{
    GArray *lines = g_array_new(FALSE, FALSE, sizeof(Line));
    g_autofree char *valid = g_utf8_make_valid(text, -1);
    g_auto(GStrv) halves = g_strsplit(valid, "\\n", -1);
    g_autofree char *joined = g_strjoinv("\n", halves);
    g_auto(GStrv) rows = g_strsplit(joined, "\n", -1);
    g_array_set_clear_func(lines, clear_line);
    for (char **row = rows; *row != NULL; row++) {
        const Line line = lay_out(pen, *row, size);
        g_array_append_val(lines, line);
    }
    return lines;
}

static void draw_lines(TinkerTextPen *pen, cairo_t *cairo, const GArray *lines, double size)
{
    double width = 0, height = -APART * size;
    for (guint i = 0; i < lines->len; i++) {
        const Line *line = &g_array_index(lines, Line, i);
        width = fmax(width, line->width);
        height += line->above + line->below + APART * size;
    }
    double y = -height / 2;
    for (guint i = 0; i < lines->len; i++) {
        const Line *line = &g_array_index(lines, Line, i);
        draw_line(pen, cairo, line, -width / 2, y + line->above, size);
        y += line->above + line->below + APART * size;
    }
}

void tinker_note_draw(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x, double y, double height,
                      const char *text)
{
    const double unit = tinker_style_unit(style), size = height / unit;
    if (!isfinite(x) || !isfinite(y) || !(size >= LEAST_LETTERS) || !isfinite(size) || text == NULL) return;
    const double *c = style->colours[CLAMP(colour, 0, TINKER_COLOUR_COUNT - 1)];
    g_autoptr(GArray) lines = lines_of(style->context, text, size);
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_scale(cairo, unit, -unit);
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], c[3]);
    draw_lines(style->context, cairo, lines, size);
    cairo_restore(cairo);
}
