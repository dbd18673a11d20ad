/* Drawn in the colours of the theme, so that it can be read in the dark and in high contrast. */
#include "gui/instrument/meter-face.h"

#include <math.h>

#include "gui/widget/enlargement.h"
#include "render/plot/plot.h"

#define DIAL_WIDTH  150
#define DIAL_HEIGHT 88
#define BAR_WIDTH   190
#define BAR_HEIGHT  38
#define MARGIN      16.0 /* beside a bar and about a dial, for numbers */
#define TICK        5.0
#define TEXT        10.0
#define MOST_TICKS  6

struct _TinkerMeterFace {
    GtkWidget parent_instance;
    gboolean dial;
    double low, high, value;
    int tick_count, decimals;
    double ticks[MOST_TICKS];
};

G_DEFINE_FINAL_TYPE(TinkerMeterFace, tinker_meter_face, GTK_TYPE_WIDGET)

typedef struct {
    cairo_t *cairo;
    double width, height; /* without the enlargement */
    GdkRGBA ink, accent;
} Sheet;

static double share_of(const TinkerMeterFace *face, double value)
{
    return CLAMP((value - face->low) / (face->high - face->low), 0, 1);
}

/* In the middle of (x, y). */
static void write_number(const Sheet *sheet, const TinkerMeterFace *face, double number, double x, double y)
{
    char text[32];
    cairo_text_extents_t extents;
    g_snprintf(text, sizeof text, "%.*f", face->decimals, number == 0 ? 0.0 : number); /* no "-0" */
    cairo_text_extents(sheet->cairo, text, &extents);
    const double left = CLAMP(x - extents.width / 2, 0, fmax(sheet->width - extents.width - 2, 0));
    cairo_move_to(sheet->cairo, left, y + TEXT / 3);
    cairo_show_text(sheet->cairo, text);
}

static void paint_dial(const TinkerMeterFace *face, const Sheet *sheet)
{
    cairo_t *cairo = sheet->cairo;
    const double radius = fmin(sheet->width / 2 - 2 * MARGIN, sheet->height - MARGIN - 6), x = sheet->width / 2,
                 y = sheet->height - 6;
    cairo_set_line_width(cairo, 1.5);
    cairo_arc(cairo, x, y, radius, -G_PI, 0);
    cairo_stroke(cairo);
    for (int i = 0; i < face->tick_count; i++) {
        const double angle = G_PI * (share_of(face, face->ticks[i]) - 1), far = radius + 11;
        cairo_move_to(cairo, x + (radius - TICK) * cos(angle), y + (radius - TICK) * sin(angle));
        cairo_line_to(cairo, x + radius * cos(angle), y + radius * sin(angle));
        cairo_stroke(cairo);
        write_number(sheet, face, face->ticks[i], x + 1.15 * far * cos(angle), y + far * sin(angle));
    }
    if (isnan(face->value)) return;
    const double angle = G_PI * (share_of(face, face->value) - 1);
    gdk_cairo_set_source_rgba(cairo, &sheet->accent);
    cairo_set_line_width(cairo, 3);
    cairo_move_to(cairo, x, y);
    cairo_line_to(cairo, x + (radius - TICK) * cos(angle), y + (radius - TICK) * sin(angle));
    cairo_stroke(cairo);
    cairo_arc(cairo, x, y, 4, 0, 2 * G_PI);
    cairo_fill(cairo);
}

static void paint_bar(const TinkerMeterFace *face, const Sheet *sheet)
{
    cairo_t *cairo = sheet->cairo;
    const double length = sheet->width - 2 * MARGIN, thick = 14, top = 2;
    for (int i = 0; i < face->tick_count; i++) {
        const double x = MARGIN + length * share_of(face, face->ticks[i]);
        cairo_set_line_width(cairo, 1);
        cairo_move_to(cairo, x, top + thick);
        cairo_line_to(cairo, x, top + thick + TICK);
        cairo_stroke(cairo);
        write_number(sheet, face, face->ticks[i], x, top + thick + TICK + 10);
    }
    cairo_rectangle(cairo, MARGIN, top, length, thick);
    cairo_stroke(cairo);
    if (isnan(face->value)) return;
    const double zero = MARGIN + length * share_of(face, 0), now = MARGIN + length * share_of(face, face->value);
    gdk_cairo_set_source_rgba(cairo, &sheet->accent);
    cairo_rectangle(cairo, fmin(zero, now), top + 1, fmax(fabs(now - zero), 1), thick - 2);
    cairo_fill(cairo);
}

static void tinker_meter_face_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    TinkerMeterFace *face = TINKER_METER_FACE(widget);
    const double larger = tinker_enlargement(widget);
    const int width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    Sheet sheet = {.width = width / larger, .height = height / larger};
    GtkStyleContext *style = gtk_widget_get_style_context(widget);
    gtk_style_context_get_color(style, &sheet.ink);
    if (!gtk_style_context_lookup_color(style, "accent_color", &sheet.accent)) sheet.accent = sheet.ink;
    sheet.cairo = gtk_snapshot_append_cairo(snapshot, &GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height));
    cairo_scale(sheet.cairo, larger, larger);
    gdk_cairo_set_source_rgba(sheet.cairo, &sheet.ink);
    cairo_set_font_size(sheet.cairo, TEXT);
    if (face->dial)
        paint_dial(face, &sheet);
    else
        paint_bar(face, &sheet);
    cairo_destroy(sheet.cairo);
}

static void tinker_meter_face_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *least,
                                      int *natural, int *least_baseline, int *natural_baseline)
{
    const gboolean dial = TINKER_METER_FACE(widget)->dial, across = orientation == GTK_ORIENTATION_HORIZONTAL;
    const int size = dial ? (across ? DIAL_WIDTH : DIAL_HEIGHT) : (across ? BAR_WIDTH : BAR_HEIGHT);
    *least = *natural = (int)ceil(size * tinker_enlargement(widget));
}

void tinker_meter_face_set_range(TinkerMeterFace *face, double low, double high)
{
    double before[2] = {face->low, face->high};
    low = fmin(low, 0);
    high = fmax(high, 0);
    if (!(high > low)) high = low + 1;
    /* Out to the next round numbers. */
    double ticks[MOST_TICKS];
    int decimals, count = tinker_plot_ticks(low, high, MOST_TICKS - 2, ticks, &decimals);
    const double step = count > 1 ? ticks[1] - ticks[0] : high - low;
    face->low = step * floor(low / step + 1e-9);
    face->high = step * ceil(high / step - 1e-9);
    face->tick_count = tinker_plot_ticks(face->low, face->high, MOST_TICKS, face->ticks, &face->decimals);
    if (face->low != before[0] || face->high != before[1]) gtk_widget_queue_draw(GTK_WIDGET(face));
}

void tinker_meter_face_set_value(TinkerMeterFace *face, double value)
{
    if (value == face->value || (isnan(value) && isnan(face->value))) return;
    face->value = value;
    gtk_widget_queue_draw(GTK_WIDGET(face));
}

static void tinker_meter_face_class_init(TinkerMeterFaceClass *class)
{
    GTK_WIDGET_CLASS(class)->snapshot = tinker_meter_face_snapshot;
    GTK_WIDGET_CLASS(class)->measure = tinker_meter_face_measure;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "meterface");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_PRESENTATION);
}

static void tinker_meter_face_init(TinkerMeterFace *face)
{
    face->value = NAN;
}

GtkWidget *tinker_meter_face_new(gboolean dial)
{
    TinkerMeterFace *face = g_object_new(TINKER_TYPE_METER_FACE, NULL);
    face->dial = dial;
    tinker_meter_face_set_range(face, 0, 1);
    return GTK_WIDGET(face);
}
