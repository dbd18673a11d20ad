/* The picture is kept as a texture. What is new is looked for when a frame is drawn, so however often something is said
 * to have changed, there is at most one painting a frame, and none while the graph is not to be seen. */
#include "gui/graph/graph-plot-private.h"

#include <glib/gi18n.h>

#include "gui/widget/desktop-theme.h"
#include "gui/widget/enlargement.h"
#include "gui/widget/image-texture.h"

#define HINT_LEFT    48  /* widget units, beyond the labels of the upright axis */
#define RECORDING_MS 100 /* how often the picture is renewed while the record grows and nothing plays */
#define BEHIND_MS    15  /* and while there is more of the record than one frame reads */

G_DEFINE_FINAL_TYPE(TinkerGraphPlot, tinker_graph_plot, GTK_TYPE_WIDGET)

TinkerGraphData *tinker_graph_plot_data(TinkerGraphPlot *plot)
{
    return plot->data;
}

void tinker_graph_plot_set_graph(TinkerGraphPlot *plot, const TinkerSceneGraph *graph)
{
    g_autofree char *before = g_strdup(tinker_graph_data_against(plot->data));
    tinker_graph_data_set_graph(plot->data, graph);
    const gboolean other_axis = g_strcmp0(before, graph->against) != 0;
    if (other_axis) plot->zoom = (TinkerGraphZoom){0};
    for (int i = 0; i < plot->cursor_count; i++)
        if (other_axis || plot->cursors[i].curve >= tinker_graph_data_own_curves(plot->data)) plot->cursor_count = 0;
    tinker_graph_plot_renew(plot);
}

void tinker_graph_plot_set_show_values(TinkerGraphPlot *plot, gboolean show)
{
    plot->show_values = show;
    tinker_graph_plot_renew(plot);
}

/* Painting --------------------------------------------------------------------------------------------------------- */

static void paint_hint(TinkerGraphPlot *plot, cairo_t *cairo)
{
    g_autoptr(PangoLayout) layout = gtk_widget_create_pango_layout(GTK_WIDGET(plot), _("Press Play to see the curve"));
    const double *colour = plot->picture.theme->colours[TINKER_COLOUR_TEXT];
    int width, height, left = HINT_LEFT;
    g_autoptr(PangoAttrList) attributes = pango_attr_list_new();
    pango_attr_list_insert(attributes, pango_attr_scale_new(PANGO_SCALE_SMALL));
    pango_layout_set_attributes(layout, attributes);
    pango_layout_set_width(layout, MAX(plot->picture.width - left - HINT_LEFT / 2, 1) * PANGO_SCALE);
    pango_layout_set_alignment(layout, PANGO_ALIGN_CENTER);
    pango_layout_get_pixel_size(layout, &width, &height);
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], 0.7);
    cairo_move_to(cairo, left, (plot->picture.height - height) / 2.0 - 8);
    pango_cairo_show_layout(cairo, layout);
}

/* Draws the plot with the values of the point under the pointer. */
static void paint_with_reading(TinkerGraphPlot *plot, cairo_t *cairo, const TinkerPlot *picture)
{
    TinkerGraphReading read;
    const double width = plot->picture.width, height = plot->picture.height;
    const gboolean reads = plot->show_values && plot->pointer_inside && plot->drag == TINKER_GRAPH_NO_DRAG &&
                           tinker_graph_plot_read(plot, picture, plot->pointer[0], plot->pointer[1], &read);
    if (!reads) {
        tinker_plot_draw(cairo, picture, width, height);
        return;
    }
    g_autofree char *x = read.kind == TINKER_READING_POINT
                             ? tinker_graph_data_x_text(plot->data, read.curve, read.point)
                             : tinker_graph_data_place_text(plot->data, "", read.at[0]);
    g_autofree char *y = tinker_graph_reading_text(tinker_graph_data_curve(plot->data, read.curve), &read);
    TinkerPlotReading reading = {.curve = (int)read.curve, .point = read.point, .x = x, .y = y, .at = read.at};
    TinkerPlot with_reading = *picture;
    with_reading.reading = &reading;
    tinker_plot_draw(cairo, &with_reading, width, height);
}

static void paint(TinkerGraphPlot *plot, cairo_t *cairo)
{
    TinkerPlot picture = {.theme = plot->picture.theme, .quick = plot->picture.quick, .memory = plot->memory};
    tinker_graph_plot_fill(plot, &picture);
    tinker_plot_measure(&picture, plot->picture.width, plot->picture.height, &plot->geometry);
    paint_with_reading(plot, cairo, &picture);
    if (tinker_graph_data_is_empty(plot->data))
        paint_hint(plot, cairo);
    else
        tinker_graph_plot_draw_marks(plot, cairo);
}

static gboolean on_timer(gpointer plot)
{
    TINKER_GRAPH_PLOT(plot)->timer = 0;
    gtk_widget_queue_draw(GTK_WIDGET(plot));
    return G_SOURCE_REMOVE;
}

/* While it plays, the player asks for the next picture; while it only records, nobody does. */
static void look_again_later(TinkerGraphPlot *plot)
{
    TinkerRunStatus status;
    const gboolean behind = tinker_graph_data_is_behind(plot->data);
    if (plot->timer != 0 || tinker_player_state(plot->player) == TINKER_PLAYER_PLAYING) return;
    if (behind || (tinker_player_status(plot->player, &status) && !status.finished))
        plot->timer = g_timeout_add(behind ? BEHIND_MS : RECORDING_MS, on_timer, plot);
}

static gboolean same_picture(const TinkerGraphPicture *a, const TinkerGraphPicture *b)
{
    return a->width == b->width && a->height == b->height && a->factor == b->factor && a->theme == b->theme &&
           a->quick == b->quick && a->enlargement == b->enlargement && a->revision == b->revision;
}

static void tinker_graph_plot_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    TinkerGraphPlot *plot = TINKER_GRAPH_PLOT(widget);
    TinkerGraphPicture picture = {
        .width = gtk_widget_get_width(widget),
        .height = gtk_widget_get_height(widget),
        .factor = gtk_widget_get_scale_factor(widget),
        .theme = tinker_desktop_theme(),
        .quick = tinker_player_state(plot->player) == TINKER_PLAYER_PLAYING,
        .enlargement = tinker_enlargement(widget),
        .revision = tinker_graph_data_update(plot->data),
    };
    if (picture.width < 1 || picture.height < 1) return;
    if (plot->texture == NULL || plot->is_stale || !same_picture(&picture, &plot->picture)) {
        plot->picture = picture;
        plot->is_stale = FALSE;
        cairo_surface_t *image = tinker_image_new(picture.width, picture.height, picture.factor);
        cairo_t *cairo = cairo_create(image);
        paint(plot, cairo);
        cairo_destroy(cairo);
        g_clear_object(&plot->texture);
        plot->texture = tinker_image_to_texture(image);
    }
    gtk_snapshot_append_texture(snapshot, plot->texture,
                                &GRAPHENE_RECT_INIT(0, 0, (float)picture.width, (float)picture.height));
    look_again_later(plot);
}

gboolean tinker_graph_plot_any_behind(GtkWidget *root)
{
    if (!gtk_widget_get_mapped(root)) return FALSE;
    if (TINKER_IS_GRAPH_PLOT(root) && tinker_graph_data_is_behind(TINKER_GRAPH_PLOT(root)->data)) return TRUE;
    for (GtkWidget *child = gtk_widget_get_first_child(root); child != NULL; child = gtk_widget_get_next_sibling(child))
        if (tinker_graph_plot_any_behind(child)) return TRUE;
    return FALSE;
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_graph_plot_dispose(GObject *object)
{
    TinkerGraphPlot *plot = TINKER_GRAPH_PLOT(object);
    g_clear_handle_id(&plot->timer, g_source_remove);
    g_clear_object(&plot->texture);
    g_clear_pointer(&plot->curves, g_free);
    g_clear_object(&plot->player);
    g_clear_pointer(&plot->data, tinker_graph_data_free);
    g_clear_pointer(&plot->memory, tinker_paint_memory_free);
    G_OBJECT_CLASS(tinker_graph_plot_parent_class)->dispose(object);
}

static void tinker_graph_plot_class_init(TinkerGraphPlotClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_graph_plot_dispose;
    GTK_WIDGET_CLASS(class)->snapshot = tinker_graph_plot_snapshot;
    g_signal_new("looks-changed", TINKER_TYPE_GRAPH_PLOT, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "plot");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_PRESENTATION);
}

static void tinker_graph_plot_init(TinkerGraphPlot *plot)
{
    plot->memory = tinker_paint_memory_new();
    gtk_widget_set_overflow(GTK_WIDGET(plot), GTK_OVERFLOW_HIDDEN);
}

GtkWidget *tinker_graph_plot_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerGraphPlot *plot = g_object_new(TINKER_TYPE_GRAPH_PLOT, NULL);
    plot->player = g_object_ref(player);
    plot->data = tinker_graph_data_new(document, player);
    tinker_graph_plot_add_input(plot);
    tinker_graph_plot_follow_pointing(plot);
    g_signal_connect_object(player, "moved", G_CALLBACK(gtk_widget_queue_draw), plot, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(gtk_widget_queue_draw), plot, G_CONNECT_SWAPPED);
    tinker_desktop_theme_redraws(GTK_WIDGET(plot));
    return GTK_WIDGET(plot);
}
