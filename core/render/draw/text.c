/* One PangoLayout is kept by a pen and set anew for every text: layouts are dear to make and cheap to change. Where
 * texts come again in the next picture, a memory keeps one of each. Layouts belong to a context of our own and not to
 * the cairo context's, so that measuring needs no surface and the settings of a desktop (hinting, resolution) change no
 * picture. */
#include "render/draw/text.h"

#include <math.h>
#include <pango/pangocairo.h>
#include <string.h>

#define FAMILY    "DejaVu Sans, Sans"
#define FORMULAS  "DejaVu Serif, Serif"
#define MOST_KEPT 2000 /* layouts in a memory, before it begins anew */

struct _TinkerTextMemory {
    PangoLayout *layout; /* of texts that are not kept */
    GHashTable *kept;    /* of PangoLayout, by what was asked for: see key_of */
};

static void written_text_free(gpointer data)
{
    TinkerWrittenText *written = data;
    g_free(written->text);
    g_free(written);
}

GPtrArray *tinker_written_texts_new(void)
{
    return g_ptr_array_new_with_free_func(written_text_free);
}

static PangoLayout *new_layout(void)
{
    PangoContext *context = pango_font_map_create_context(pango_cairo_font_map_get_default());
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    pango_cairo_context_set_font_options(context, options);
    pango_context_set_round_glyph_positions(context, FALSE);
    cairo_font_options_destroy(options);
    PangoLayout *layout = pango_layout_new(context);
    g_object_unref(context);
    return layout;
}

TinkerTextMemory *tinker_text_memory_new(void)
{
    TinkerTextMemory *memory = g_new0(TinkerTextMemory, 1);
    memory->layout = new_layout();
    memory->kept = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_object_unref);
    return memory;
}

void tinker_text_memory_free(TinkerTextMemory *memory)
{
    if (!memory) return;
    g_hash_table_unref(memory->kept);
    g_object_unref(memory->layout);
    g_free(memory);
}

/* Everything that a layout depends on, as one string. */
static void write_key(const TinkerText *text, char *key, gsize size)
{
    g_snprintf(key, (gulong)size, "%a %a %d %d %d %d %d %s", text->size, text->limit, text->face, text->bold,
               text->lines, text->anchor_x == 0.5, text->keeps_end, text->text ? text->text : "");
}

static void set_text(PangoLayout *layout, const TinkerText *text)
{
    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family_static(font, text->face == TINKER_FACE_PLAIN ? FAMILY : FORMULAS);
    pango_font_description_set_style(font, text->face == TINKER_FACE_LETTER ? PANGO_STYLE_ITALIC : PANGO_STYLE_NORMAL);
    pango_font_description_set_weight(font, text->bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_font_description_set_absolute_size(font, text->size * PANGO_SCALE);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);

    int lines = MAX(text->lines, 1);
    pango_layout_set_single_paragraph_mode(layout, TRUE);
    pango_layout_set_width(layout, text->limit > 0 ? (int)fmin(text->limit * PANGO_SCALE, G_MAXINT / 2) : -1);
    pango_layout_set_height(layout, -lines);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    const PangoEllipsizeMode cut = text->keeps_end ? PANGO_ELLIPSIZE_MIDDLE : PANGO_ELLIPSIZE_END;
    pango_layout_set_ellipsize(layout, text->limit > 0 ? cut : PANGO_ELLIPSIZE_NONE);
    pango_layout_set_alignment(layout, text->anchor_x == 0.5 ? PANGO_ALIGN_CENTER : PANGO_ALIGN_LEFT);

    const char *utf8 = text->text ? text->text : "";
    if (g_utf8_validate(utf8, -1, NULL)) {
        pango_layout_set_text(layout, utf8, -1);
    } else {
        g_autofree char *valid = g_utf8_make_valid(utf8, -1);
        pango_layout_set_text(layout, valid, -1);
    }
}

/* The layout of this text that the memory keeps; NULL where it keeps none of such a length. */
static PangoLayout *recall(TinkerTextMemory *memory, const TinkerText *text)
{
    char key[256];
    write_key(text, key, sizeof key);
    if (strlen(key) + 1 == sizeof key) return NULL;
    PangoLayout *layout = g_hash_table_lookup(memory->kept, key);
    if (layout) return layout;
    if (g_hash_table_size(memory->kept) >= MOST_KEPT) g_hash_table_remove_all(memory->kept);
    layout = pango_layout_new(pango_layout_get_context(memory->layout));
    set_text(layout, text);
    g_hash_table_insert(memory->kept, g_strdup(key), layout);
    return layout;
}

/* A layout of this text: valid until the pen's next one. */
static PangoLayout *lay_out(TinkerTextPen *pen, const TinkerText *text)
{
    PangoLayout *layout = pen->memory && !text->passing ? recall(pen->memory, text) : NULL;
    if (layout) return layout;
    if (pen->memory) {
        layout = pen->memory->layout;
    } else {
        if (!pen->layout) pen->layout = new_layout();
        layout = pen->layout;
    }
    set_text(layout, text);
    return layout;
}

/* The box of what is laid out, from the layout's own corner. */
static void layout_box(PangoLayout *layout, double box[4])
{
    PangoRectangle logical;
    pango_layout_get_extents(layout, NULL, &logical);
    box[0] = (double)logical.x / PANGO_SCALE;
    box[1] = (double)logical.y / PANGO_SCALE;
    box[2] = (double)logical.width / PANGO_SCALE;
    box[3] = (double)logical.height / PANGO_SCALE;
}

/* Notes where the text lies, turned box and all. */
static void note(TinkerTextPen *pen, const TinkerText *text, double x, double y, double width, double height)
{
    TinkerWrittenText *written = g_new0(TinkerWrittenText, 1);
    written->text = g_strdup(text->text);
    written->box[0] = written->box[1] = INFINITY;
    written->box[2] = written->box[3] = -INFINITY;
    for (int corner = 0; corner < 4; corner++) {
        double across = ((corner & 1) - text->anchor_x) * width, down = ((corner >> 1) - text->anchor_y) * height;
        double corner_x = x + across * cos(text->angle) - down * sin(text->angle);
        double corner_y = y + across * sin(text->angle) + down * cos(text->angle);
        written->box[0] = fmin(written->box[0], corner_x);
        written->box[1] = fmin(written->box[1], corner_y);
        written->box[2] = fmax(written->box[2], corner_x);
        written->box[3] = fmax(written->box[3], corner_y);
    }
    g_ptr_array_add(pen->written, written);
}

void tinker_text_pen_clear(TinkerTextPen *pen)
{
    g_clear_object((GObject **)&pen->layout);
    g_clear_pointer(&pen->apart, g_array_unref);
}

void tinker_text_measure(TinkerTextPen *pen, const TinkerText *text, double *width, double *height)
{
    double box[4];
    layout_box(lay_out(pen, text), box);
    *width = box[2];
    *height = box[3];
}

double tinker_text_width(TinkerTextPen *pen, const TinkerText *text)
{
    double width, height;
    tinker_text_measure(pen, text, &width, &height);
    return width;
}

void tinker_text_measure_ink(TinkerTextPen *pen, const TinkerText *text, double *width, double *above, double *below)
{
    PangoLayout *layout = lay_out(pen, text);
    PangoRectangle ink, logical;
    pango_layout_get_extents(layout, &ink, &logical);
    const int line = pango_layout_get_baseline(layout);
    *width = (double)logical.width / PANGO_SCALE;
    *above = (double)(line - ink.y) / PANGO_SCALE;
    *below = (double)(ink.y + ink.height - line) / PANGO_SCALE;
}

void tinker_text_draw_on_line(TinkerTextPen *pen, cairo_t *cairo, const TinkerText *text, double x, double y)
{
    PangoLayout *layout = lay_out(pen, text);
    PangoRectangle logical;
    pango_layout_get_extents(layout, NULL, &logical);
    cairo_move_to(cairo, x - (double)logical.x / PANGO_SCALE,
                  y - (double)pango_layout_get_baseline(layout) / PANGO_SCALE);
    pango_cairo_show_layout(cairo, layout);
    cairo_new_path(cairo);
    if (!pen->written) return;
    TinkerText copy = *text;
    copy.angle = copy.anchor_x = copy.anchor_y = 0;
    note(pen, &copy, x, y - (double)pango_layout_get_baseline(layout) / PANGO_SCALE,
         (double)logical.width / PANGO_SCALE, (double)logical.height / PANGO_SCALE);
}

void tinker_text_draw(TinkerTextPen *pen, cairo_t *cairo, const TinkerText *text, double x, double y)
{
    if (!text->text || !*text->text || !isfinite(x) || !isfinite(y)) return;
    PangoLayout *layout = lay_out(pen, text);
    double box[4];
    layout_box(layout, box);
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_rotate(cairo, text->angle);
    cairo_move_to(cairo, -box[0] - text->anchor_x * box[2], -box[1] - text->anchor_y * box[3]);
    pango_cairo_show_layout(cairo, layout);
    cairo_restore(cairo);
    cairo_new_path(cairo);
    if (pen->written) note(pen, text, x, y, box[2], box[3]);
}

/* On the device: the place that was wanted, how far down from it the text is, and half its size. */
typedef struct {
    double x, y, down, across, high;
} Apart;

static gboolean meets(const GArray *others, const Apart *text)
{
    for (guint i = 0; i < others->len; i++) {
        const Apart *other = &g_array_index(others, Apart, i);
        if (fabs(other->x - text->x) < other->across + text->across &&
            fabs(other->y + other->down - text->y - text->down) < other->high + text->high)
            return TRUE;
    }
    return FALSE;
}

/* How far down from its place a text is free, in lines; 0 where it is nowhere. */
static double free_line(const GArray *others, Apart text)
{
    static const double tried[] = {0, 1, -1, 2, -2};
    const double line = 2 * text.high;
    for (guint i = 0; i < others->len; i++) {
        const Apart *other = &g_array_index(others, Apart, i);
        if (other->x == text.x && other->y == text.y) return other->down / line;
    }
    for (gsize i = 0; i < G_N_ELEMENTS(tried); i++) {
        text.down = tried[i] * line;
        if (!meets(others, &text)) return tried[i];
    }
    return 0;
}

void tinker_text_draw_apart(TinkerTextPen *pen, cairo_t *cairo, const TinkerText *text)
{
    double width, height, none = 0;
    if (!text->text || !*text->text) return;
    if (!pen->apart) pen->apart = g_array_new(FALSE, FALSE, sizeof(Apart));
    tinker_text_measure(pen, text, &width, &height);
    Apart wanted = {(0.5 - text->anchor_x) * width, (0.5 - text->anchor_y) * height, 0, width / 2, height / 2};
    cairo_user_to_device(cairo, &wanted.x, &wanted.y);
    cairo_user_to_device_distance(cairo, &wanted.across, &none);
    none = 0;
    cairo_user_to_device_distance(cairo, &none, &wanted.high);
    wanted.across = fabs(wanted.across);
    wanted.high = fabs(wanted.high);
    const double lines = free_line(pen->apart, wanted);
    wanted.down = 2 * lines * wanted.high;
    g_array_append_val(pen->apart, wanted);
    tinker_text_draw(pen, cairo, text, 0, lines * height);
}

void tinker_text_append_power(GString *to, int exponent)
{
    static const char *const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char digits[16];
    g_snprintf(digits, sizeof digits, "%d", ABS(exponent));
    g_string_append(to, "10");
    if (exponent < 0) g_string_append(to, "⁻");
    for (const char *digit = digits; *digit; digit++)
        g_string_append(to, raised[*digit - '0']);
}

void tinker_text_append_number(GString *to, const char *number)
{
    for (; *number; number++) {
        if (*number == '-') {
            g_string_append(to, "−");
        } else if (*number == 'e') {
            g_string_append(to, "×");
            tinker_text_append_power(to, (int)g_ascii_strtoll(number + 1, NULL, 10));
            return;
        } else {
            g_string_append_c(to, *number);
        }
    }
}
