/* The canvas paints into an image of its own and shows that. */
#include "gui/canvas/canvas-private.h"
#include "gui/widget/desktop-theme.h"
#include "gui/widget/image-texture.h"

#define GHOST 0.3 /* how much of a run that is kept is seen, */
#define OVER  0.7 /* and of what is shown over the scene */

/* What is pointed at somewhere else, or by an arrow; NULL: nothing. */
static const TinkerPointed *lit(TinkerCanvas *canvas)
{
    const TinkerPointed *pointed = tinker_document_pointed(canvas->document);
    return canvas->points && !canvas->points_at_arrow ? NULL : pointed;
}

static TinkerBlockId lit_block(TinkerCanvas *canvas)
{
    const TinkerPointed *pointed = lit(canvas);
    return pointed != NULL ? pointed->block : TINKER_NO_BLOCK;
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
static void paint_arrows(TinkerCanvas *canvas, cairo_t *cairo, const TinkerPaintOptions *as,
                         const TinkerPointed *pointed)
{
    const CanvasForcesLook look = {.theme = as->theme,
                                   .factor = canvas->force_factor,
                                   .lit = pointed,
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
    paint_arrows(canvas, cairo, &options, lit(canvas));
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
    paint_arrows(canvas, cairo, &options, NULL);
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

void canvas_snapshot(TinkerCanvas *canvas, GtkSnapshot *snapshot)
{
    GtkWidget *widget = GTK_WIDGET(canvas);
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
