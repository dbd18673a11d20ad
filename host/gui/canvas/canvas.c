/* The canvas paints into an image of its own and shows that. */
#include "gui/canvas/canvas-private.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "gui/text/block-words.h"
#include "gui/widget/desktop-theme.h"
#include "gui/widget/image-texture.h"
#include "gui/widget/unparent.h"
#include "render/draw/text.h"

#define GHOST        0.3 /* how much of a run that is kept is seen, */
#define OVER         0.7 /* and of what is shown over the scene */
#define MOST_FACTOR  1e4 /* of arrows of forces */
#define FIT_MARGIN   48.0
#define NOTICE       48.0 /* widget units: a notice over the top, of which the margin leaves no room for as much */
#define CANVAS_SHAPE 0.6  /* height of a canvas over its width, where only that is known */

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

/* The view ------------------------------------------------------------------------------------------------------------
 */

void tinker_canvas_zoom(TinkerCanvas *canvas, double factor)
{
    tinker_view_zoom(&canvas->view, factor, canvas->view.width / 2, canvas->view.height / 2);
    canvas_view_changed(canvas);
}

void tinker_canvas_scale_forces(TinkerCanvas *canvas, double factor)
{
    canvas->force_factor = CLAMP(factor * canvas->force_factor, 1 / MOST_FACTOR, MOST_FACTOR);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
}

/* `above` widget units at the top stay free. */
static void show_box(TinkerCanvas *canvas, const double box[4], double margin, double above)
{
    double width = canvas->view.width, height = canvas->view.height;
    if (!(width > 0) || !(height > above)) return;
    canvas->view = tinker_view_fit(box, width, height - above, margin);
    tinker_view_pan(&canvas->view, 0, above);
    canvas->view.height = height;
    canvas->view_is_set = TRUE;
    canvas_view_changed(canvas);
}

/* As show_box; when the canvas gets another size it shows the same, as long as nobody looks elsewhere meanwhile. */
static void fit_box(TinkerCanvas *canvas, const double box[4], double margin, double above)
{
    show_box(canvas, box, margin, above);
    memmove(canvas->fitted, box, sizeof canvas->fitted);
    canvas->fitted_margin = margin;
    canvas->fitted_above = above;
    canvas->view_is_fitted = TRUE;
}

/* What stays free at the top: the place of a notice of one line, or of the one that is there. */
static double room_above(const TinkerCanvas *canvas)
{
    return fmax(NOTICE, canvas_seen_from(canvas));
}

/* Graphs that float are part of what there is to see. */
static void include_graphs(TinkerScene *scene, double box[4])
{
    GPtrArray *graphs = tinker_scene_graphs(scene);
    for (guint i = 0; i < graphs->len; i++) {
        const TinkerSceneGraph *graph = g_ptr_array_index(graphs, i);
        double width = graph->has_size ? graph->size[0] : 0, height = graph->has_size ? graph->size[1] : 0;
        if (!graph->has_place) continue;
        box[0] = fmin(box[0], graph->place[0]);
        box[1] = fmin(box[1], graph->place[1] - height);
        box[2] = fmax(box[2], graph->place[0] + width);
        box[3] = fmax(box[3], graph->place[1]);
    }
}

/* The box of everything there is to see; FALSE where there is none. */
static gboolean box_of_all(TinkerCanvas *canvas, double box[4])
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    if (frame == NULL) return FALSE;
    tinker_painter_bounds(frame, box);
    include_graphs(tinker_frame_scene(frame), box);
    return TRUE;
}

void tinker_canvas_fit(TinkerCanvas *canvas)
{
    double box[4];
    if (box_of_all(canvas, box)) fit_box(canvas, box, FIT_MARGIN, room_above(canvas));
}

double tinker_canvas_covered(TinkerCanvas *canvas)
{
    return canvas_seen_from(canvas);
}

/* Shows the same below what lies over it, where that covers something of the scene. */
static gboolean keep_below_cover(gpointer data)
{
    TinkerCanvas *canvas = data;
    double box[4], x, top;
    canvas->keeping_below = 0;
    if (canvas->covered_told != canvas_seen_from(canvas)) {
        canvas->covered_told = canvas_seen_from(canvas);
        g_signal_emit_by_name(canvas, "view-changed");
    }
    if (room_above(canvas) <= canvas->fitted_above) return G_SOURCE_REMOVE;
    if (!canvas->view_is_fitted || canvas->gesture != CANVAS_IDLE || !box_of_all(canvas, box)) return G_SOURCE_REMOVE;
    tinker_view_to_canvas(&canvas->view, 0, box[3], &x, &top);
    if (top < canvas_seen_from(canvas)) fit_box(canvas, canvas->fitted, canvas->fitted_margin, room_above(canvas));
    return G_SOURCE_REMOVE;
}

void tinker_canvas_cover_placed(TinkerCanvas *canvas)
{
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
    /* not while widgets get their places */
    if (canvas->keeping_below == 0)
        canvas->keeping_below = g_idle_add_full(G_PRIORITY_DEFAULT, keep_below_cover, canvas, NULL);
}

void tinker_canvas_show_width(TinkerCanvas *canvas)
{
    double half = tinker_scene_head(tinker_document_scene(canvas->document))->canvas_width / 2;
    show_box(canvas, (double[]){-half, 0, half, 0}, 0, 0);
}

/* Widens a range about its middle. */
static void widen(double *low, double *high, double length)
{
    double room = (length - (*high - *low)) / 2;
    if (room <= 0) return;
    *low -= room;
    *high += room;
}

static void renew_memory(TinkerCanvas *canvas)
{
    tinker_paint_memory_free(canvas->memory);
    canvas->memory = tinker_paint_memory_new();
}

/* A scene is first shown as wide as it says, because it will move, and wholly; an empty one as wide as it says. */
void tinker_canvas_show_first(TinkerCanvas *canvas)
{
    double box[4], canvas_width = tinker_scene_head(tinker_document_scene(canvas->document))->canvas_width;
    renew_memory(canvas);
    if (tinker_document_is_empty(canvas->document) || !box_of_all(canvas, box)) {
        tinker_canvas_show_width(canvas);
        return;
    }
    widen(&box[0], &box[2], canvas_width);
    widen(&box[1], &box[3], CANVAS_SHAPE * canvas_width);
    fit_box(canvas, box, 0, room_above(canvas));
}

static void tinker_canvas_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerCanvas *canvas = TINKER_CANVAS(widget);
    /* Menus ask for another size through their parent. */
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        if (GTK_IS_POPOVER(child)) gtk_popover_present(GTK_POPOVER(child));
    if (width == (int)canvas->view.width && height == (int)canvas->view.height) return;
    tinker_view_pan(&canvas->view, (width - canvas->view.width) / 2, (height - canvas->view.height) / 2);
    canvas->view.width = width;
    canvas->view.height = height;
    if (!canvas->view_is_set && canvas->document != NULL)
        tinker_canvas_show_first(canvas);
    else if (canvas->view_is_fitted)
        fit_box(canvas, canvas->fitted, canvas->fitted_margin, fmin(canvas->fitted_above, room_above(canvas)));
    else
        canvas_view_changed(canvas);
}

/* Painting ------------------------------------------------------------------------------------------------------------
 */

/* What is pointed at somewhere else. */
static TinkerBlockId lit_block(TinkerCanvas *canvas)
{
    return canvas->points ? TINKER_NO_BLOCK : tinker_document_pointed(canvas->document);
}

static TinkerPaintOptions paint_options(TinkerCanvas *canvas)
{
    TinkerPaintOptions options = tinker_paint_options_default();
    options.theme = tinker_desktop_theme();
    options.show_labels = canvas->show_labels && !canvas->show_forces; /* arrows have labels of their own */
    options.show_grid = canvas->show_grid;
    options.show_local_origins = canvas->show_local_origins;
    options.highlighted = canvas->highlighted != TINKER_NO_BLOCK ? canvas->highlighted : lit_block(canvas);
    options.selected = tinker_document_selection(canvas->document, &options.selected_count);
    options.quick = TRUE;
    options.memory = canvas->memory;
    options.faults = canvas->faults;
    return options;
}

static void paint_band(TinkerCanvas *canvas, cairo_t *cairo, const TinkerTheme *theme)
{
    const double *colour = theme->colours[TINKER_COLOUR_SELECTED];
    cairo_rectangle(cairo, canvas->press[0], canvas->press[1], canvas->pointer[0] - canvas->press[0],
                    canvas->pointer[1] - canvas->press[1]);
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], 0.15);
    cairo_fill_preserve(cairo);
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], 0.9);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
}

/* The view in units of what is drawn larger. */
static TinkerView larger(const TinkerView *view, double factor)
{
    return (TinkerView){.scale = view->scale / factor,
                        .origin_x = view->origin_x / factor,
                        .origin_y = view->origin_y / factor,
                        .width = view->width / factor,
                        .height = view->height / factor,
                        .covered = view->covered / factor};
}

/* A frame as a ghost over the scene, of which `alpha` is seen. */
static void paint_ghost(TinkerCanvas *canvas, cairo_t *cairo, TinkerFrame *frame, double alpha,
                        const TinkerPaintOptions *as)
{
    TinkerPaintOptions options = *as;
    TinkerTheme theme = *as->theme;
    theme.background[3] = theme.colours[TINKER_COLOUR_FIELD][3] = theme.colours[TINKER_COLOUR_TEXT][3] = 0;
    options.theme = &theme;
    options.show_grid = options.show_labels = options.show_local_origins = FALSE;
    options.highlighted = TINKER_NO_BLOCK;
    options.selected_count = 0;
    options.memory = NULL;
    options.texts = NULL;
    cairo_push_group(cairo);
    tinker_paint_scene(cairo, frame, &canvas->view, &options);
    cairo_pop_group_to_source(cairo);
    cairo_paint_with_alpha(cairo, alpha);
}

/* Where runs that are kept are at this time, and what is shown over the scene. */
static void paint_ghosts(TinkerCanvas *canvas, cairo_t *cairo, const TinkerPaintOptions *as)
{
    TinkerKeptRuns *runs = tinker_player_kept(canvas->player);
    for (guint i = 0; i < tinker_kept_runs_count(runs); i++) {
        TinkerFrame *frame = tinker_kept_run_frame(tinker_kept_runs_at(runs, i), tinker_player_time(canvas->player));
        if (frame != NULL) paint_ghost(canvas, cairo, frame, GHOST, as);
    }
    if (canvas->over != NULL) paint_ghost(canvas, cairo, canvas->over, OVER, as);
}

/* Forces, vectors and trails over the scene that was painted with these options. */
static void paint_arrows(TinkerCanvas *canvas, cairo_t *cairo, const TinkerPaintOptions *as, TinkerBlockId lit)
{
    const CanvasForcesLook look = {.theme = as->theme,
                                   .factor = canvas->force_factor,
                                   .lit = lit,
                                   .others = !canvas->this_body_only,
                                   .forces = canvas->show_forces,
                                   .trails = canvas->show_trails,
                                   .vectors = canvas->show_vectors,
                                   .texts = as->texts};
    canvas_forces_draw(canvas->forces, cairo, canvas->document, canvas->player, &canvas->view, &look);
}

static void paint(TinkerCanvas *canvas, cairo_t *cairo)
{
    g_autoptr(GPtrArray) texts = NULL;
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    TinkerPaintOptions options = paint_options(canvas);
    if (frame == NULL) return;
    canvas->view.covered = canvas_seen_from(canvas);
    const TinkerView seen = canvas->view;
    const double factor = canvas_magnification(canvas);
    texts = canvas_panels(canvas, factor);
    cairo_save(cairo);
    cairo_scale(cairo, factor, factor);
    canvas->view = larger(&seen, factor);
    options.texts = texts;
    tinker_paint_scene(cairo, frame, &canvas->view, &options);
    paint_ghosts(canvas, cairo, &options);
    canvas_paint_marks(canvas, cairo, frame, options.theme, texts);
    paint_arrows(canvas, cairo, &options, lit_block(canvas));
    canvas_paint_edge_marks(canvas, cairo, frame, options.theme); /* over the key of the forces */
    canvas->view = seen;
    cairo_restore(cairo);
    if (canvas->gesture == CANVAS_BAND && canvas->moved) paint_band(canvas, cairo, options.theme);
}

void tinker_canvas_draw_for_paper(TinkerCanvas *canvas, cairo_t *cairo)
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    TinkerPaintOptions options = paint_options(canvas);
    g_autoptr(GPtrArray) texts = NULL;
    if (frame == NULL) return;
    options.theme = tinker_theme_find("light");
    options.highlighted = TINKER_NO_BLOCK;
    options.selected_count = 0;
    options.quick = FALSE;
    options.memory = NULL;
    options.faults = NULL;
    canvas->view.covered = 0; /* no notice lies over it there */
    options.texts = texts = canvas_panels(canvas, 1);
    tinker_paint_scene(cairo, frame, &canvas->view, &options);
    paint_arrows(canvas, cairo, &options, TINKER_NO_BLOCK);
}

GList *tinker_canvas_faults(TinkerCanvas *canvas)
{
    return g_hash_table_get_values(canvas->faults);
}

static gboolean tell_faults(gpointer data)
{
    TinkerCanvas *canvas = data;
    canvas->telling = 0;
    g_signal_emit_by_name(canvas, "faults");
    return G_SOURCE_REMOVE;
}

/* Not while the window is drawn: whoever is told of it shows it. */
static void look_for_faults(TinkerCanvas *canvas)
{
    const guint count = g_hash_table_size(canvas->faults);
    if (count == canvas->faults_told || canvas->telling != 0) return;
    canvas->faults_told = count;
    canvas->telling = g_idle_add(tell_faults, canvas);
}

static void tinker_canvas_snapshot(GtkWidget *widget, GtkSnapshot *snapshot)
{
    TinkerCanvas *canvas = TINKER_CANVAS(widget);
    if (canvas->player == NULL || !(canvas->view.width > 0) || !(canvas->view.height > 0)) return;
    cairo_surface_t *image =
        tinker_image_new((int)canvas->view.width, (int)canvas->view.height, gtk_widget_get_scale_factor(widget));
    cairo_t *cairo = cairo_create(image);
    paint(canvas, cairo);
    look_for_faults(canvas);
    cairo_destroy(cairo);
    g_autoptr(GdkTexture) texture = tinker_image_to_texture(image);
    graphene_rect_t bounds = GRAPHENE_RECT_INIT(0, 0, (float)canvas->view.width, (float)canvas->view.height);
    gtk_snapshot_append_texture(snapshot, texture, &bounds);
}

/* The widget ----------------------------------------------------------------------------------------------------------
 */

static void on_replaced(TinkerCanvas *canvas)
{
    canvas_cancel_gesture(canvas);
    canvas->placing = canvas->highlighted = canvas->followed = TINKER_NO_BLOCK;
    g_array_set_size(canvas->marked, 0);
    canvas->velocity_scale = 0;
    canvas_forces_forget(canvas->forces);
    renew_memory(canvas);
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
    if (canvas->gesture == CANVAS_IDLE && canvas->placing == TINKER_NO_BLOCK) renew_memory(canvas);
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
    if (property == PROP_LARGE && TINKER_CANVAS(object)->document != NULL) renew_memory(TINKER_CANVAS(object));
    if (property == PROP_FOLLOW && TINKER_CANVAS(object)->document != NULL) canvas_follow(TINKER_CANVAS(object));
    gtk_widget_queue_draw(GTK_WIDGET(object));
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
