/* The picture is made when it is drawn; screen readers are told the numbers of the present. */
#include "gui/graph/energy-chart.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/curve/energy-data.h"
#include "gui/widget/desktop-theme.h"

#define BARS      150.0 /* widget units: width of the bars beside the layers */
#define ROW       17.0
#define SAMPLE    9.0 /* of the colour, beside the name */
#define LEAST     220
#define AGAIN_MS  50      /* while the record grows */
#define TELL_US   1000000 /* at most so often is it told while it plays */
#define FONT_SIZE 11.0

typedef struct {
    GtkWidget *area;
    TinkerPlayer *player;
    TinkerEnergyData *data;
    TinkerPaintMemory *memory;
    guint timer; /* or 0 */
    gint64 told;
} Chart;

static void chart_free(gpointer data)
{
    Chart *chart = data;
    g_clear_handle_id(&chart->timer, g_source_remove);
    tinker_energy_data_free(chart->data);
    tinker_paint_memory_free(chart->memory);
    g_object_unref(chart->player);
    g_free(chart);
}

static void set_colour(cairo_t *cairo, const double colour[4])
{
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
}

static char *number_text(double value)
{
    return g_strdup_printf("%.4g J", fabs(value) < 1e-12 ? 0 : value);
}

/* `share` of the text lies to the left of x. */
static void write_text(Chart *chart, cairo_t *cairo, const char *text, double x, double y, double share)
{
    g_autoptr(PangoLayout) layout = gtk_widget_create_pango_layout(chart->area, text);
    g_autoptr(PangoAttrList) attributes = pango_attr_list_new();
    int width, height;
    pango_attr_list_insert(attributes, pango_attr_size_new_absolute((int)(FONT_SIZE * PANGO_SCALE)));
    pango_layout_set_attributes(layout, attributes);
    pango_layout_get_pixel_size(layout, &width, &height);
    cairo_move_to(cairo, x - share * width, y);
    pango_cairo_show_layout(cairo, layout);
}

/* One bar a layer, as long as it is of the whole, and beneath them the whole. */
static void draw_bars(Chart *chart, cairo_t *cairo, const TinkerTheme *theme, double left)
{
    double layers[TINKER_ENERGY_LAYERS], sum, all = 0, y = ROW / 2;
    if (!tinker_energy_data_now(chart->data, layers, &sum)) return;
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++)
        all += fmax(layers[k], 0);
    for (int k = 0; k <= TINKER_ENERGY_LAYERS; k++) {
        if (k < TINKER_ENERGY_LAYERS && !tinker_energy_data_has(chart->data, (TinkerEnergyLayer)k)) continue;
        const double value = k < TINKER_ENERGY_LAYERS ? layers[k] : sum, whole = fmax(all, fabs(sum));
        g_autofree char *number = number_text(value);
        const char *name = k < TINKER_ENERGY_LAYERS ? tinker_energy_layer_name((TinkerEnergyLayer)k) : _("In All");
        const double *colour = k < TINKER_ENERGY_LAYERS ? theme->curves[k] : theme->axis;
        cairo_rectangle(cairo, left, y + (ROW - SAMPLE) / 2, SAMPLE, SAMPLE); /* a bar may be too short to be seen */
        set_colour(cairo, colour);
        cairo_fill(cairo);
        set_colour(cairo, theme->colours[TINKER_COLOUR_TEXT]);
        write_text(chart, cairo, name, left + 1.5 * SAMPLE, y, 0);
        write_text(chart, cairo, number, left + BARS - ROW, y, 1);
        cairo_rectangle(cairo, left, y + ROW - 1, whole > 0 ? (BARS - ROW) * fmin(fabs(value) / whole, 1) : 0, ROW / 3);
        set_colour(cairo, colour);
        cairo_fill(cairo);
        y += 1.6 * ROW;
    }
}

static gboolean on_timer(gpointer data)
{
    Chart *chart = data;
    chart->timer = 0;
    gtk_widget_queue_draw(chart->area);
    return G_SOURCE_REMOVE;
}

static void look_again_later(Chart *chart)
{
    TinkerRunStatus status;
    const gboolean grows = tinker_player_status(chart->player, &status) && !status.finished;
    if (chart->timer == 0 && (grows || tinker_energy_data_is_behind(chart->data)))
        chart->timer = g_timeout_add(AGAIN_MS, on_timer, chart);
}

static void draw(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    Chart *chart = data;
    const TinkerTheme *theme = tinker_desktop_theme();
    TinkerPlot plot = {.theme = theme, .compact = TRUE, .memory = chart->memory, .quick = TRUE};
    double range[2];
    tinker_energy_data_update(chart->data);
    set_colour(cairo, theme->background);
    cairo_paint(cairo);
    look_again_later(chart);
    if (tinker_energy_data_count(chart->data) == 0) {
        set_colour(cairo, theme->colours[TINKER_COLOUR_TEXT]);
        write_text(chart, cairo, _("Press Play to see where the energy goes"), width / 2.0, height / 2.0, 0.5);
        return;
    }
    tinker_energy_data_fill_plot(chart->data, &plot);
    if (tinker_time_span_get(tinker_player_span(chart->player), range)) plot.x_range = range;
    tinker_plot_draw(cairo, &plot, fmax(width - BARS, 1), height);
    draw_bars(chart, cairo, theme, width - BARS);
}

/* "Kinetic 0.5 J, ..., given 1 J". */
static void tell(Chart *chart)
{
    double layers[TINKER_ENERGY_LAYERS], sum;
    const gboolean playing = tinker_player_state(chart->player) == TINKER_PLAYER_PLAYING;
    gtk_widget_queue_draw(chart->area);
    if (!gtk_widget_get_mapped(chart->area) || (playing && g_get_monotonic_time() < chart->told + TELL_US)) return;
    GString *text = g_string_new(NULL);
    tinker_energy_data_update(chart->data);
    if (tinker_energy_data_now(chart->data, layers, &sum)) {
        for (int k = 0; k < TINKER_ENERGY_LAYERS; k++)
            if (tinker_energy_data_has(chart->data, (TinkerEnergyLayer)k))
                g_string_append_printf(text, "%s %.4g J, ", tinker_energy_layer_name((TinkerEnergyLayer)k), layers[k]);
        g_string_append_printf(text, "%s %.4g J", _("In All"), sum);
    }
    gtk_accessible_update_property(GTK_ACCESSIBLE(chart->area), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text->str, -1);
    g_string_free(text, TRUE);
    chart->told = g_get_monotonic_time();
}

static void on_moved(GtkWidget *area)
{
    tell(g_object_get_data(G_OBJECT(area), "chart"));
}

GtkWidget *tinker_energy_chart_new(TinkerDocument *document, TinkerPlayer *player)
{
    Chart *chart = g_new0(Chart, 1);
    chart->area = g_object_new(GTK_TYPE_DRAWING_AREA, "accessible-role", GTK_ACCESSIBLE_ROLE_IMG, NULL);
    chart->player = g_object_ref(player);
    chart->data = tinker_energy_data_new(document, player);
    chart->memory = tinker_paint_memory_new();
    g_object_set_data_full(G_OBJECT(chart->area), "chart", chart, chart_free);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(chart->area), draw, chart, NULL);
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(chart->area), LEAST);
    gtk_accessible_update_property(GTK_ACCESSIBLE(chart->area), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Energy"), -1);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), chart->area, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_moved), chart->area, G_CONNECT_SWAPPED);
    g_signal_connect_object(tinker_player_span(player), "changed", G_CALLBACK(gtk_widget_queue_draw), chart->area,
                            G_CONNECT_SWAPPED);
    tinker_desktop_theme_redraws(chart->area);
    return chart->area;
}
