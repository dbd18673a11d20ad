/* After every change of the scene the views are brought in line with its instruments. The layer itself is not there for
 * the pointer. */
#include "gui/instrument/instrument-layer.h"

#include <math.h>

#include "gui/instrument/instrument-layer-private.h"
#include "gui/widget/unparent.h"

G_DEFINE_FINAL_TYPE(TinkerInstrumentLayer, tinker_instrument_layer, GTK_TYPE_WIDGET)

static void tinker_instrument_layer_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerInstrumentLayer *layer = TINKER_INSTRUMENT_LAYER(widget);
    instrument_layer_arrange(layer);
    gtk_widget_queue_draw(GTK_WIDGET(layer->canvas)); /* names make way */
    for (guint i = 0; i < layer->views->len; i++) {
        GtkWidget *view = g_ptr_array_index(layer->views, i);
        const float factor = (float)instrument_layer_shrinkage(layer);
        const TinkerGraphBox box = g_array_index(layer->boxes, TinkerGraphBox, i);
        GskTransform *there = gsk_transform_translate(NULL, &GRAPHENE_POINT_INIT((float)box.x, (float)box.y));
        gtk_widget_allocate(view, (int)round(box.width / factor), (int)round(box.height / factor), -1,
                            gsk_transform_scale(there, factor, factor));
    }
}

static gboolean tinker_instrument_layer_contains(GtkWidget *widget, double x, double y)
{
    return FALSE;
}

void tinker_instrument_layer_draw(TinkerInstrumentLayer *layer, cairo_t *cairo)
{
    instrument_layer_arrange(layer);
    for (guint i = 0; i < layer->views->len; i++) {
        const TinkerGraphBox box = g_array_index(layer->boxes, TinkerGraphBox, i);
        g_autoptr(GdkPaintable) seen = gtk_widget_paintable_new(g_ptr_array_index(layer->views, i));
        GtkSnapshot *snapshot = gtk_snapshot_new();
        gdk_paintable_snapshot(seen, snapshot, box.width / instrument_layer_shrinkage(layer),
                               box.height / instrument_layer_shrinkage(layer));
        GskRenderNode *node = gtk_snapshot_free_to_node(snapshot);
        if (node == NULL) continue;
        cairo_save(cairo);
        cairo_translate(cairo, box.x, box.y);
        cairo_scale(cairo, instrument_layer_shrinkage(layer), instrument_layer_shrinkage(layer));
        gsk_render_node_draw(node, cairo);
        cairo_restore(cairo);
        gsk_render_node_unref(node);
    }
}

static void add_panels(TinkerInstrumentLayer *layer, GArray *boxes)
{
    for (guint i = 0; layer->boxes != NULL && i < layer->boxes->len; i++) {
        const TinkerGraphBox box = g_array_index(layer->boxes, TinkerGraphBox, i);
        g_array_append_vals(boxes, ((double[]){box.x, box.y, box.x + box.width, box.y + box.height}), 1);
    }
}

/* Keeping up ------------------------------------------------------------------------------------------------------- */

static TinkerInstrumentView *view_new(TinkerInstrumentLayer *layer, int number)
{
    TinkerInstrumentView *view = tinker_instrument_view_new(layer->document, layer->player, layer->hand, number);
    gtk_widget_set_parent(GTK_WIDGET(view), GTK_WIDGET(layer));
    instrument_layer_let_move(layer, view);
    return view;
}

/* The first of the old ones that fits, or a new one. */
static TinkerInstrumentView *view_for(TinkerInstrumentLayer *layer, GPtrArray *old, int number)
{
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(layer->document));
    for (guint i = 0; i < old->len; i++)
        if (tinker_instrument_view_fits(g_ptr_array_index(old, i), g_ptr_array_index(all, (guint)number)))
            return g_ptr_array_steal_index(old, i);
    return view_new(layer, number);
}

static void on_changed(TinkerInstrumentLayer *layer)
{
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(layer->document));
    g_autoptr(GPtrArray) old = g_steal_pointer(&layer->views);
    layer->views = g_ptr_array_new();
    for (guint i = 0; i < all->len; i++) {
        TinkerInstrumentView *view = view_for(layer, old, (int)i);
        tinker_instrument_view_set_number(view, (int)i);
        g_ptr_array_add(layer->views, view);
    }
    for (guint i = 0; i < old->len; i++) {
        if (g_ptr_array_index(old, i) == layer->dragged) layer->dragged = NULL;
        gtk_widget_unparent(g_ptr_array_index(old, i));
    }
    gtk_widget_set_visible(GTK_WIDGET(layer), layer->views->len > 0);
    instrument_layer_look_again(layer);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_instrument_layer_dispose(GObject *object)
{
    TinkerInstrumentLayer *layer = TINKER_INSTRUMENT_LAYER(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_pointer(&layer->views, g_ptr_array_unref);
    g_clear_pointer(&layer->boxes, g_array_unref);
    instrument_room_clear(&layer->room);
    g_clear_pointer(&layer->hand, tinker_hand_free);
    g_clear_object(&layer->canvas);
    g_clear_object(&layer->graphs);
    g_clear_object(&layer->player);
    g_clear_object(&layer->document);
    G_OBJECT_CLASS(tinker_instrument_layer_parent_class)->dispose(object);
}

static void tinker_instrument_layer_class_init(TinkerInstrumentLayerClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_instrument_layer_dispose;
    GTK_WIDGET_CLASS(class)->size_allocate = tinker_instrument_layer_size_allocate;
    GTK_WIDGET_CLASS(class)->contains = tinker_instrument_layer_contains;
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "instrument-layer");
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_instrument_layer_init(TinkerInstrumentLayer *layer)
{
    layer->views = g_ptr_array_new();
    layer->boxes = g_array_new(FALSE, FALSE, sizeof(TinkerGraphBox));
    instrument_room_init(&layer->room);
    gtk_widget_set_overflow(GTK_WIDGET(layer), GTK_OVERFLOW_HIDDEN);
}

GtkWidget *tinker_instrument_layer_new(TinkerCanvas *canvas, TinkerGraphLayer *graphs, TinkerDocument *document,
                                       TinkerPlayer *player)
{
    TinkerInstrumentLayer *layer = g_object_new(TINKER_TYPE_INSTRUMENT_LAYER, NULL);
    layer->canvas = g_object_ref(canvas);
    layer->graphs = g_object_ref(graphs);
    layer->document = g_object_ref(document);
    layer->player = g_object_ref(player);
    layer->hand = tinker_hand_new(document, player);
    g_signal_connect_object(canvas, "view-changed", G_CALLBACK(instrument_layer_look_again), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(canvas, "panels", G_CALLBACK(add_panels), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(instrument_layer_on_state_changed), layer,
                            G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(instrument_layer_on_moved), layer, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), layer, G_CONNECT_SWAPPED);
    on_changed(layer);
    return GTK_WIDGET(layer);
}
