/* The canvas as a widget: what it listens to, its switches, its life. */
#include "gui/canvas/canvas-private.h"

#include <glib/gi18n.h>

#include "gui/widget/desktop-theme.h"
#include "gui/widget/unparent.h"

#define MOST_FACTOR 1e4 /* of arrows of forces */

G_DEFINE_FINAL_TYPE(TinkerCanvas, tinker_canvas, GTK_TYPE_WIDGET)

enum {
    PROP_0,
    PROP_SHOW_LABELS,
    PROP_SHOW_FORCES,
    PROP_SHOW_VELOCITIES,
    PROP_SHOW_ACCELERATIONS,
    PROP_SHOW_NET_FORCES,
    PROP_SHOW_TRAILS,
    PROP_SHOW_LOCAL_ORIGINS,
    PROP_SHOW_GRID,
    PROP_THIS_BODY_ONLY,
    PROP_FOLLOW,
    PROP_LARGE,
    PROPERTIES
};
static GParamSpec *properties[PROPERTIES];

static void on_replaced(TinkerCanvas *canvas)
{
    canvas_cancel_gesture(canvas);
    canvas->placing = canvas->highlighted = canvas->followed = TINKER_NO_BLOCK;
    g_array_set_size(canvas->marked, 0);
    canvas->velocity_scale = 0;
    canvas_forces_forget(canvas->forces);
    canvas_renew_memory(canvas);
    canvas->view_is_set = FALSE;
}

/* Whoever wants to edit meanwhile goes first. */
static void on_interrupted(TinkerCanvas *canvas)
{
    canvas_cancel_gesture(canvas);
    tinker_canvas_place_cancel(canvas);
}

static void on_moved(TinkerCanvas *canvas)
{
    canvas_follow(canvas);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

static void on_selection_changed(TinkerCanvas *canvas)
{
    canvas_follow(canvas);
    canvas_describe_view(canvas);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

static void on_changed(TinkerCanvas *canvas)
{
    if (!canvas->view_is_set) tinker_canvas_show_first(canvas);
    /* Names stay on their side while things move; what was edited may need another. */
    if (canvas->gesture == CANVAS_IDLE && canvas->placing == TINKER_NO_BLOCK) canvas_renew_memory(canvas);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

void tinker_canvas_set_player(TinkerCanvas *canvas, TinkerDocument *document, TinkerPlayer *player)
{
    canvas->document = g_object_ref(document);
    canvas->player = g_object_ref(player);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), canvas, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "interrupted", G_CALLBACK(on_interrupted), canvas, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), canvas, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "selection-changed", G_CALLBACK(on_selection_changed), canvas, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "pointed-changed", G_CALLBACK(gtk_widget_queue_draw), canvas, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), canvas, G_CONNECT_SWAPPED);
    g_signal_connect_object(tinker_player_kept(player), "changed", G_CALLBACK(gtk_widget_queue_draw), canvas,
                            G_CONNECT_SWAPPED);
    tinker_desktop_theme_redraws(GTK_WIDGET(canvas));
}

void tinker_canvas_set_cover(TinkerCanvas *canvas, GtkWidget *cover)
{
    g_set_weak_pointer(&canvas->cover, cover);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

void tinker_canvas_show_over(TinkerCanvas *canvas, TinkerFrame *frame)
{
    canvas->over = frame;
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

void tinker_canvas_set_marked(TinkerCanvas *canvas, const TinkerBlockId *blocks, int count)
{
    g_array_set_size(canvas->marked, 0);
    if (count > 0) g_array_append_vals(canvas->marked, blocks, (guint)count);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

void tinker_canvas_scale_forces(TinkerCanvas *canvas, double factor)
{
    canvas->force_factor = CLAMP(factor * canvas->force_factor, 1 / MOST_FACTOR, MOST_FACTOR);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

/* The switches ----------------------------------------------------------------------------------------------------- */

static gboolean *switch_of(TinkerCanvas *canvas, guint property)
{
    switch (property) {
    case PROP_SHOW_LABELS:
        return &canvas->show_labels;
    case PROP_SHOW_FORCES:
        return &canvas->show_forces;
    case PROP_SHOW_VELOCITIES:
        return &canvas->show_vectors.kinds[TINKER_VECTOR_VELOCITY];
    case PROP_SHOW_ACCELERATIONS:
        return &canvas->show_vectors.kinds[TINKER_VECTOR_ACCELERATION];
    case PROP_SHOW_NET_FORCES:
        return &canvas->show_vectors.kinds[TINKER_VECTOR_NET_FORCE];
    case PROP_SHOW_TRAILS:
        return &canvas->show_trails;
    case PROP_SHOW_LOCAL_ORIGINS:
        return &canvas->show_local_origins;
    case PROP_FOLLOW:
        return &canvas->follow;
    case PROP_LARGE:
        return &canvas->large;
    case PROP_THIS_BODY_ONLY:
        return &canvas->this_body_only;
    default:
        return &canvas->show_grid;
    }
}

static void tinker_canvas_get_property(GObject *object, guint property, GValue *value, GParamSpec *spec)
{
    g_value_set_boolean(value, *switch_of(TINKER_CANVAS(object), property));
}

static void tinker_canvas_set_property(GObject *object, guint property, const GValue *value, GParamSpec *spec)
{
    *switch_of(TINKER_CANVAS(object), property) = g_value_get_boolean(value);
    if (property == PROP_LARGE && TINKER_CANVAS(object)->document != NULL) canvas_renew_memory(TINKER_CANVAS(object));
    if (property == PROP_FOLLOW && TINKER_CANVAS(object)->document != NULL) canvas_follow(TINKER_CANVAS(object));
    gtk_widget_queue_draw(GTK_WIDGET(object));
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_canvas_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerCanvas *canvas = TINKER_CANVAS(widget);
    /* Menus ask for another size through their parent. */
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        if (GTK_IS_POPOVER(child)) gtk_popover_present(GTK_POPOVER(child));
    canvas_set_size(canvas, width, height);
}

static void tinker_canvas_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    canvas_snapshot(TINKER_CANVAS(widget), snapshot);
}

static void tinker_canvas_dispose(GObject *object)
{
    TinkerCanvas *canvas = TINKER_CANVAS(object);
    if (canvas->document != NULL) canvas_cancel_gesture(canvas);
    g_clear_handle_id(&canvas->keeping_below, g_source_remove);
    tinker_unparent_children(GTK_WIDGET(canvas));
    g_clear_weak_pointer(&canvas->cover);
    g_clear_object(&canvas->player);
    g_clear_object(&canvas->document);
    G_OBJECT_CLASS(tinker_canvas_parent_class)->dispose(object);
}

static void tinker_canvas_finalize(GObject *object)
{
    tinker_paint_memory_free(TINKER_CANVAS(object)->memory);
    g_hash_table_unref(TINKER_CANVAS(object)->faults);
    g_clear_handle_id(&TINKER_CANVAS(object)->telling, g_source_remove);
    canvas_forces_free(TINKER_CANVAS(object)->forces);
    g_free(TINKER_CANVAS(object)->reached_text);
    g_array_unref(TINKER_CANVAS(object)->marked);
    G_OBJECT_CLASS(tinker_canvas_parent_class)->finalize(object);
}

static void tinker_canvas_class_init(TinkerCanvasClass *class)
{
    GObjectClass *object_class = G_OBJECT_CLASS(class);
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    object_class->get_property = tinker_canvas_get_property;
    object_class->set_property = tinker_canvas_set_property;
    object_class->dispose = tinker_canvas_dispose;
    object_class->finalize = tinker_canvas_finalize;
    widget_class->size_allocate = tinker_canvas_size_allocate;
    widget_class->snapshot = tinker_canvas_snapshot;
    const GParamFlags flags = G_PARAM_READWRITE | G_PARAM_STATIC_STRINGS;
    properties[PROP_SHOW_LABELS] = g_param_spec_boolean("show-labels", NULL, NULL, TRUE, flags);
    properties[PROP_SHOW_FORCES] = g_param_spec_boolean("show-forces", NULL, NULL, FALSE, flags);
    properties[PROP_SHOW_VELOCITIES] = g_param_spec_boolean("show-velocities", NULL, NULL, FALSE, flags);
    properties[PROP_SHOW_ACCELERATIONS] = g_param_spec_boolean("show-accelerations", NULL, NULL, FALSE, flags);
    properties[PROP_SHOW_NET_FORCES] = g_param_spec_boolean("show-net-forces", NULL, NULL, FALSE, flags);
    properties[PROP_SHOW_TRAILS] = g_param_spec_boolean("show-trails", NULL, NULL, FALSE, flags);
    properties[PROP_SHOW_LOCAL_ORIGINS] = g_param_spec_boolean("show-local-origins", NULL, NULL, FALSE, flags);
    properties[PROP_SHOW_GRID] = g_param_spec_boolean("show-grid", NULL, NULL, TRUE, flags);
    properties[PROP_THIS_BODY_ONLY] = g_param_spec_boolean("forces-on-this-body-only", NULL, NULL, TRUE, flags);
    properties[PROP_LARGE] = g_param_spec_boolean("large", NULL, NULL, FALSE, flags);
    properties[PROP_FOLLOW] = g_param_spec_boolean("follow", NULL, NULL, FALSE, flags);
    g_object_class_install_properties(object_class, PROPERTIES, properties);
    g_signal_new("view-changed", TINKER_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    g_signal_new("faults", TINKER_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    g_signal_new("panels", TINKER_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_POINTER);
    g_signal_new("menu", TINKER_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2, G_TYPE_DOUBLE,
                 G_TYPE_DOUBLE);
    g_signal_new("dropped", TINKER_TYPE_CANVAS, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 2, G_TYPE_INT,
                 G_TYPE_DOUBLE);
    gtk_widget_class_set_css_name(widget_class, "canvas");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_IMG);
}

static void tinker_canvas_init(TinkerCanvas *canvas)
{
    canvas->show_labels = canvas->show_grid = canvas->this_body_only = TRUE;
    canvas->force_factor = 1;
    canvas->reached = tinker_pointed_block(TINKER_NO_BLOCK);
    canvas->view = (TinkerView){.scale = 100, .origin_x = 0, .origin_y = 0};
    canvas->highlighted = canvas->placing = canvas->followed = canvas->pressed.block = TINKER_NO_BLOCK;
    canvas->faults = g_hash_table_new_full(NULL, NULL, NULL, g_free);
    canvas->memory = tinker_paint_memory_new();
    canvas->forces = canvas_forces_new();
    canvas->marked = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    gtk_widget_set_focusable(GTK_WIDGET(canvas), TRUE);
    gtk_widget_set_overflow(GTK_WIDGET(canvas), GTK_OVERFLOW_HIDDEN);
    gtk_accessible_update_property(GTK_ACCESSIBLE(canvas), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Canvas"), -1);
    canvas_add_input(canvas);
}
