/* The legend looks for the corner, then the side, that no curve passes; where there is none it stands beside the plot,
 * and where there is no room beside it, in lines above the curves. It hides nothing of them: where there is no room at
 * all it is left out. */
#include <math.h>
#include <string.h>

#include "render/draw/occupancy.h"
#include "render/plot/plot-private.h"

#define INNER          7.0 /* canvas units: between frame and content */
#define CELL           4.0
#define WIDEST         0.45 /* of the plot: labels are cut beyond */
#define WIDEST_COMPACT 0.65
#define WIDEST_ASIDE   0.3  /* of the picture: likewise of a legend beside the plot */
#define LEAST_ASIDE    90.0 /* a narrower legend beside the plot says too little */
#define MOST_ROWS      3    /* of a legend above the plot, */
#define LEAST_COLUMN   60.0 /* in columns that are no narrower, */
#define LEAST_CURVES   40.0 /* over curves that are no lower: */
#define LEAST_SHARE    0.35 /* of the picture, either */
#define DOTS           "…"

static const char *label_of(const TinkerPlotLayout *layout, int curve)
{
    const char *label = layout->plot->curves[curve].label;
    return label && *label ? label : NULL;
}

static int count_entries(const TinkerPlotLayout *layout)
{
    int entries = 0;
    for (int i = 0; i < layout->plot->curve_count; i++)
        if (label_of(layout, i)) entries++;
    return entries;
}

static double widest_label(TinkerPlotLayout *layout, double limit)
{
    double widest = 0;
    for (int i = 0; i < layout->plot->curve_count; i++) {
        if (!label_of(layout, i)) continue;
        double width, height;
        TinkerText text = {
            .text = label_of(layout, i), .size = layout->sizes->tick_text, .limit = limit, .keeps_end = TRUE};
        tinker_text_measure(layout->pen, &text, &width, &height);
        widest = fmax(widest, width);
    }
    return widest;
}

static double width_of(const TinkerPlotLayout *layout, const char *text)
{
    const TinkerText whole = {.text = text, .size = layout->sizes->tick_text};
    double width, height;
    tinker_text_measure(layout->pen, &whole, &width, &height);
    return width;
}

/* Whether what two labels begin with alike is as much as is seen of them where their ends are cut. */
static gboolean begin_alike(const TinkerPlotLayout *layout, const char *a, const char *b, double seen)
{
    gsize alike = 0;
    while (a[alike] != '\0' && a[alike] == b[alike])
        alike++;
    if (a[alike] == b[alike]) return FALSE; /* nothing tells these apart */
    while ((a[alike] & 0xC0) == 0x80)
        alike--;
    g_autofree char *beginning = g_strndup(a, alike);
    return width_of(layout, beginning) > seen;
}

/* Of the entries that are shown. */
static gboolean must_keep_ends(const TinkerPlotLayout *layout)
{
    const double seen = layout->legend.limit - width_of(layout, DOTS);
    const char *labels[64];
    int count = 0;
    for (int i = 0; i < layout->plot->curve_count && count < MIN(layout->legend.entries, (int)G_N_ELEMENTS(labels));
         i++)
        if (label_of(layout, i)) labels[count++] = label_of(layout, i);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < i; k++)
            if (begin_alike(layout, labels[i], labels[k], seen)) return TRUE;
    return FALSE;
}

/* A label that is too long and ends with something in brackets, as the name of a run, keeps that whole; NULL where it
 * cannot. (transfer full) */
static char *cut_before_brackets(const TinkerPlotLayout *layout, const char *label)
{
    const char *brackets = g_strrstr(label, " (");
    if (brackets == NULL || brackets == label) return NULL;
    g_autofree char *name = g_strndup(label, (gsize)(brackets - label)), *tail = g_strconcat(DOTS, brackets, NULL);
    const double room = layout->legend.limit - width_of(layout, tail);
    glong letters = (glong)(fmin(room / width_of(layout, name), 1) * (double)g_utf8_strlen(name, -1));
    for (; letters > 0; letters--) {
        g_autofree char *begin = g_utf8_substring(name, 0, letters), *cut = g_strconcat(begin, tail, NULL);
        if (width_of(layout, cut) <= layout->legend.limit) return g_steal_pointer(&cut);
    }
    return NULL;
}

typedef struct {
    TinkerOccupancy map;
    double x, y;
} Trace;

static void trace_to(double x, double y, gboolean starts, gpointer data)
{
    Trace *trace = data;
    tinker_occupancy_take_line(&trace->map, starts ? x : trace->x, starts ? y : trace->y, x, y, TINKER_PLOT_LINE + 2,
                               TINKER_TAKEN_BY_DRAWING);
    trace->x = x;
    trace->y = y;
}

static void trace_points(const TinkerPlotLayout *layout, const TinkerCurve *curve, Trace *trace)
{
    for (gsize i = 0; i < curve->count; i++) {
        double x, y;
        if (!tinker_plot_place(layout, curve, i, &x, &y)) continue;
        tinker_occupancy_take_box(&trace->map, (double[]){x - 4, y - 4, x + 4, y + 4}, TINKER_TAKEN_BY_DRAWING);
    }
}

static void trace_curves(const TinkerPlotLayout *layout, Trace *trace)
{
    for (int i = 0; i < layout->plot->curve_count; i++) {
        const TinkerCurve *curve = &layout->plot->curves[i];
        if (tinker_plot_has_line(curve)) tinker_plot_walk(layout, curve, 1, trace_to, trace);
        if (tinker_plot_has_markers(curve)) trace_points(layout, curve, trace);
        if (!curve->low || !curve->high) continue;
        TinkerCurve border = *curve;
        border.index = NULL;
        border.y = curve->low;
        tinker_plot_walk(layout, &border, 1, trace_to, trace);
        border.y = curve->high;
        tinker_plot_walk(layout, &border, 1, trace_to, trace);
    }
}

/* Tries corners and sides of the plot; answers the share of the best one that curves pass. */
static double find_inside(TinkerPlotLayout *layout, double width, double height)
{
    static const double spots[8][2] = {{1, 0}, {0, 0}, {1, 1}, {0, 1}, {1, 0.5}, {0, 0.5}, {0.5, 0}, {0.5, 1}};
    Trace trace;
    double across = layout->right - layout->left - 2 * layout->sizes->legend_inset - width;
    double down = layout->bottom - layout->top - 2 * layout->sizes->legend_inset - height;
    tinker_occupancy_init(&trace.map, layout->left, layout->top, layout->right - layout->left,
                          layout->bottom - layout->top, CELL);
    trace_curves(layout, &trace);
    double best = INFINITY;
    for (int i = 0; i < 8 && best > 0; i++) {
        double x = layout->left + layout->sizes->legend_inset + spots[i][0] * across,
               y = layout->top + layout->sizes->legend_inset + spots[i][1] * down;
        const double box[4] = {x, y, x + width, y + height};
        double share = tinker_occupancy_share(&trace.map, box, TINKER_TAKEN_BY_DRAWING);
        if (share >= best) continue;
        best = share;
        for (int side = 0; side < 4; side++)
            layout->legend.box[side] = box[side];
    }
    tinker_occupancy_clear(&trace.map);
    return best;
}

/* Its size in lines above the curves; where they stand is known when these have given way. */
static void size_above(TinkerPlotLayout *layout, int entries)
{
    TinkerLegend *legend = &layout->legend;
    const double row = layout->sizes->legend_row, around = layout->sizes->legend_sample + 3 * INNER;
    const double across = layout->width - layout->left - layout->sizes->pad;
    const double spare = layout->bottom - layout->top - fmax(LEAST_CURVES, LEAST_SHARE * layout->height);
    const int most = (int)fmin(floor(spare / row), MOST_ROWS);
    legend->kind = TINKER_LEGEND_NONE;
    if (most < 1 || across < LEAST_COLUMN) return;
    const double wished = around + widest_label(layout, fmax(across - around, 1));
    const int needed = (entries + most - 1) / most;
    const int columns = CLAMP((int)(across / wished), MIN(needed, (int)(across / LEAST_COLUMN)), entries);
    const int rows = MIN((entries + columns - 1) / columns, most);
    if (columns * rows < MIN(entries, 2)) return;
    legend->kind = TINKER_LEGEND_ABOVE;
    legend->columns = columns;
    legend->column_width = fmin(wished, across / columns);
    legend->entries = columns * rows >= entries ? entries : columns * rows - 1;
    legend->limit = legend->column_width - around;
    legend->box[2] = legend->box[0] + columns * legend->column_width;
    legend->box[3] = legend->box[1] + rows * row;
}

void tinker_plot_place_legend(TinkerPlotLayout *layout)
{
    TinkerLegend *legend = &layout->legend;
    int entries = count_entries(layout);
    double room = layout->bottom - layout->top - 2 * layout->sizes->legend_inset - 2 * INNER;
    int rows = MIN(entries, (int)floor(room / layout->sizes->legend_row));
    legend->kind = TINKER_LEGEND_NONE;
    if (rows < 1) return;
    const gboolean has_room = rows > 1 || entries == 1;
    legend->entries = rows < entries ? rows - 1 : entries;
    double widest = layout->plot->compact ? WIDEST_COMPACT : WIDEST;
    legend->limit = fmax(widest * (layout->right - layout->left) - layout->sizes->legend_sample - 3 * INNER, 20);
    double width = widest_label(layout, legend->limit) + layout->sizes->legend_sample + 3 * INNER,
           height = rows * layout->sizes->legend_row + 2 * INNER - 3;
    double share = has_room ? find_inside(layout, width, height) : INFINITY;
    double aside = fmin(width, WIDEST_ASIDE * layout->width);
    legend->kind = TINKER_LEGEND_INSIDE;
    legend->columns = 1;
    if (share > 0 && has_room && !layout->plot->compact && aside >= fmin(width, LEAST_ASIDE)) {
        legend->kind = TINKER_LEGEND_OUTSIDE;
        legend->limit = fmin(legend->limit, aside - layout->sizes->legend_sample - 3 * INNER);
        legend->box[2] = legend->box[0] + aside;
    } else if (share > 0) {
        size_above(layout, entries);
    }
    legend->keeps_ends = must_keep_ends(layout);
}

/* The middle of the left end of a place in it. */
static void place_of(const TinkerPlotLayout *layout, int number, double *x, double *y)
{
    const TinkerLegend *legend = &layout->legend;
    const double inner = legend->kind == TINKER_LEGEND_ABOVE ? 0 : INNER - 1.5;
    *x = legend->box[0] + INNER + number % legend->columns * legend->column_width;
    *y = legend->box[1] + inner + (number / legend->columns + 0.5) * layout->sizes->legend_row;
}

static void draw_entry(cairo_t *cairo, const TinkerPlotLayout *layout, int curve, double x, double y)
{
    const TinkerCurve *drawn = &layout->plot->curves[curve];
    tinker_plot_set_curve_style(cairo, layout, drawn);
    if (tinker_plot_has_line(drawn) && drawn->count != 1) {
        cairo_move_to(cairo, x, y);
        cairo_line_to(cairo, x + layout->sizes->legend_sample, y);
        cairo_stroke(cairo);
    }
    if (tinker_plot_has_markers(drawn)) tinker_plot_draw_marker(cairo, drawn, x + layout->sizes->legend_sample / 2, y);
}

static void draw_label(cairo_t *cairo, const TinkerPlotLayout *layout, const char *label, double x, double y)
{
    const double *c = layout->theme->colours[TINKER_COLOUR_TEXT];
    const TinkerLegend *legend = &layout->legend;
    const gboolean is_cut = legend->keeps_ends && width_of(layout, label) > legend->limit;
    g_autofree char *cut = is_cut ? cut_before_brackets(layout, label) : NULL;
    TinkerText text = {.text = cut != NULL ? cut : label,
                       .size = layout->sizes->tick_text,
                       .limit = legend->limit,
                       .keeps_end = legend->keeps_ends,
                       .anchor_y = 0.5};
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], c[3]);
    tinker_text_draw(layout->pen, cairo, &text, x + layout->sizes->legend_sample + INNER, y);
}

/* What it stands on, where that is the plot. */
static void draw_ground(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    const double *ground = layout->theme->background, *edge = layout->theme->grid, *box = layout->legend.box;
    cairo_rectangle(cairo, floor(box[0]) + 0.5, floor(box[1]) + 0.5, round(box[2] - box[0]), round(box[3] - box[1]));
    cairo_set_source_rgba(cairo, ground[0], ground[1], ground[2], layout->plot->compact ? 0.7 : 0.85);
    cairo_fill_preserve(cairo);
    cairo_set_source_rgba(cairo, edge[0], edge[1], edge[2], edge[3]);
    cairo_set_line_width(cairo, 1);
    if (!layout->plot->compact) cairo_stroke(cairo);
    cairo_new_path(cairo);
}

void tinker_plot_draw_legend(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    const TinkerLegend *legend = &layout->legend;
    double x, y;
    if (legend->kind == TINKER_LEGEND_NONE) return;
    if (legend->kind != TINKER_LEGEND_ABOVE) draw_ground(cairo, layout);
    int shown = 0;
    for (int i = 0; i < layout->plot->curve_count && shown < legend->entries; i++) {
        if (!label_of(layout, i)) continue;
        place_of(layout, shown++, &x, &y);
        draw_entry(cairo, layout, i, x, y);
        draw_label(cairo, layout, label_of(layout, i), x, y);
    }
    int left_out = count_entries(layout) - shown;
    if (left_out == 0) return;
    g_autofree char *more = g_strdup_printf("+ %d", left_out);
    place_of(layout, shown, &x, &y);
    draw_label(cairo, layout, more, x, y);
}

gboolean tinker_plot_shortens_legend(const TinkerPlotLayout *layout)
{
    const TinkerLegend *legend = &layout->legend;
    if (legend->kind == TINKER_LEGEND_NONE) return FALSE;
    for (int i = 0; i < layout->plot->curve_count; i++)
        if (label_of(layout, i) && width_of(layout, label_of(layout, i)) > legend->limit) return TRUE;
    return count_entries(layout) > legend->entries;
}

int tinker_plot_legend_curve(const TinkerPlotLayout *layout, double x, double y)
{
    const TinkerLegend *legend = &layout->legend;
    if (legend->kind == TINKER_LEGEND_NONE || x < legend->box[0] || x > legend->box[2]) return -1;
    const double width = legend->columns > 1 ? legend->column_width : legend->box[2] - legend->box[0];
    int shown = 0;
    for (int i = 0; i < layout->plot->curve_count && shown < legend->entries; i++) {
        double left, middle;
        if (!label_of(layout, i)) continue;
        place_of(layout, shown++, &left, &middle);
        if (fabs(y - middle) <= layout->sizes->legend_row / 2 && x >= left - INNER && x < left - INNER + width)
            return i;
    }
    return -1;
}
