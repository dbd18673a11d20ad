/* Nothing that depends on the clock may be in the picture: animations are off, and the run is waited for to its end,
 * because the time line shows how far it has come. What is measured holds times of the machine: that alone differs from
 * picture to picture. */
#include "gui/app/screenshot.h"

#include <glib/gi18n.h>
#include <math.h>

#include "common/program/exit-status.h"
#include "files/replace-file.h"
#include "gui/graph/graph-plot.h"
#include "gui/text/settings.h"
#include "gui/window/side-panel.h"
#include "gui/window/window-parts.h"

#define FRAMES_BEFORE                                                                                                  \
    24 /* that the window is given to settle, once the plan is known: docks and lines follow some time after */
#define MOST_TRIES   100 /* to find the window laid out */
#define FRAMES_AFTER 3   /* likewise, once the view is set */

/* One that is being taken. */
typedef struct {
    const TinkerScreenshot *wanted;
    TinkerWindow *window;
    TinkerScreenshotDone done;
    gpointer data;
    int frames;
    int tries;
} Shot;

void tinker_screenshot_prepare(const TinkerScreenshot *screenshot)
{
    g_setenv("GSK_RENDERER", "cairo", TRUE);
    g_setenv("GTK_A11Y", "none", TRUE);
    g_setenv("ADW_DISABLE_PORTAL", "1", TRUE);
    g_setenv("ADW_DEBUG_COLOR_SCHEME", screenshot->dark ? "prefer-dark" : "prefer-light", TRUE);
    g_setenv("ADW_DEBUG_HIGH_CONTRAST", screenshot->high_contrast ? "1" : "0", TRUE);
    tinker_settings_disable();
}

static void finish(Shot *shot, int status)
{
    shot->done(status, shot->data);
    g_free(shot);
}

/* The scene -------------------------------------------------------------------------------------------------------- */

static int usage_error(const char *option, const char *value, const char *right)
{
    tinker_report_note(_("--%s: there is no %s “%s”"), option, right, value);
    return TINKER_EXIT_USAGE;
}

/* A run that fails behind the time that is wanted is good enough. */
static int run_to(TinkerWindow *window, double time)
{
    g_autoptr(GError) error = NULL;
    TinkerBlockId culprit;
    double duration = tinker_player_duration(window->player);
    if (time > duration) {
        tinker_report_note(_("--time: the run of this scene ends at %g s"), duration);
        return TINKER_EXIT_USAGE;
    }
    if (!tinker_player_play(window->player, &culprit, &error)) return tinker_report_error(NULL, error);
    tinker_player_pause(window->player);
    if (!tinker_player_wait(window->player, INFINITY, &error) && tinker_player_reached(window->player) < time)
        return tinker_report_error(NULL, error);
    tinker_player_seek(window->player, time);
    return TINKER_EXIT_DONE;
}

/* As a copy without a name: in which folder it lies must not be seen. */
static int open_scene(TinkerWindow *window, const TinkerScreenshot *wanted)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_canonicalize_filename(wanted->scene, NULL), *text = NULL;
    gsize length;
    if (!g_file_get_contents(path, &text, &length, &error) ||
        !tinker_document_start(window->document, text, length, path, &error))
        return tinker_report_error(NULL, error);
    return isnan(wanted->time) ? TINKER_EXIT_DONE : run_to(window, wanted->time);
}

static int select_block(TinkerWindow *window, const char *name)
{
    TinkerBlockId block = tinker_scene_find_block(tinker_document_scene(window->document), name);
    if (block == TINKER_NO_BLOCK) return usage_error("select", name, _("block"));
    tinker_document_select(window->document, block);
    return TINKER_EXIT_DONE;
}

static int show_page(TinkerWindow *window, const char *page)
{
    if (adw_view_stack_get_child_by_name(window->pages, page) == NULL) return usage_error("page", page, _("page"));
    adw_view_stack_set_visible_child_name(window->pages, page);
    return TINKER_EXIT_DONE;
}

static int show_panel(TinkerWindow *window, const char *panel)
{
    GtkWidget *side_panel = gtk_widget_get_first_child(GTK_WIDGET(window->panel));
    return tinker_side_panel_show(side_panel, panel) ? TINKER_EXIT_DONE : usage_error("panel", panel, _("panel"));
}

static int check_output(TinkerWindow *window, const char *path)
{
    g_autoptr(TinkerFileSet) files = tinker_document_files(window->document);
    g_autoptr(GError) error = NULL;
    return tinker_file_set_add_output(files, "--screenshot", path, &error) ? TINKER_EXIT_DONE
                                                                           : tinker_report_error(NULL, error);
}

static int show(TinkerWindow *window, const TinkerScreenshot *wanted)
{
    g_object_set(window->canvas, "show-forces", wanted->forces, "show-velocities", wanted->velocity,
                 "show-accelerations", wanted->acceleration, "show-net-forces", wanted->net_force, "show-trails",
                 wanted->trail, NULL);
    int status = wanted->scene != NULL ? open_scene(window, wanted) : TINKER_EXIT_DONE;
    if (status == TINKER_EXIT_DONE) status = check_output(window, wanted->file);
    if (status == TINKER_EXIT_DONE && wanted->select != NULL) status = select_block(window, wanted->select);
    if (status == TINKER_EXIT_DONE && wanted->page != NULL) status = show_page(window, wanted->page);
    if (status == TINKER_EXIT_DONE && wanted->panel != NULL) status = show_panel(window, wanted->panel);
    return status;
}

/* The picture ------------------------------------------------------------------------------------------------------ */

static int write_picture(GdkTexture *texture, const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GBytes) bytes = gdk_texture_save_to_png_bytes(texture);
    gsize length;
    const char *data = g_bytes_get_data(bytes, &length);
    if (tinker_replace_file(path, data, length, 0666, &error)) return TINKER_EXIT_DONE;
    tinker_report_note("%s: %s", path, error->message);
    return TINKER_EXIT_FILE;
}

/* What the window shows; NULL as long as it is not laid out. */
static GskRenderNode *look(Shot *shot, int width, int height)
{
    g_autoptr(GdkPaintable) paintable = gtk_widget_paintable_new(GTK_WIDGET(shot->window));
    g_autoptr(GtkSnapshot) snapshot = gtk_snapshot_new();
    gdk_paintable_snapshot(paintable, GDK_SNAPSHOT(snapshot), width, height);
    return gtk_snapshot_to_node(snapshot);
}

/* FALSE where it has to be tried again after the next frame. */
static gboolean take(Shot *shot, int *status)
{
    GtkWidget *widget = GTK_WIDGET(shot->window);
    int width = gtk_widget_get_width(widget), height = gtk_widget_get_height(widget);
    GskRenderNode *node = look(shot, width, height);
    if (node == NULL && shot->tries++ < MOST_TRIES) return FALSE;
    if (node == NULL) {
        tinker_report_note(_("the window shows nothing"));
        *status = TINKER_EXIT_RUN_FAILED;
        return TRUE;
    }
    GskRenderer *renderer = gtk_native_get_renderer(GTK_NATIVE(shot->window));
    g_autoptr(GdkTexture) texture =
        gsk_renderer_render_texture(renderer, node, &GRAPHENE_RECT_INIT(0, 0, (float)width, (float)height));
    gsk_render_node_unref(node);
    *status = write_picture(texture, shot->wanted->file);
    return TRUE;
}

static gboolean on_frame(GtkWidget *widget, GdkFrameClock *clock, gpointer data);

static gboolean on_idle(gpointer data)
{
    Shot *shot = data;
    int status;
    if (take(shot, &status))
        finish(shot, status);
    else
        gtk_widget_add_tick_callback(GTK_WIDGET(shot->window), on_frame, shot, NULL);
    return G_SOURCE_REMOVE;
}

/* The last thing that is done once the window has been drawn some times. */
static gboolean on_frame(GtkWidget *widget, GdkFrameClock *clock, gpointer data)
{
    Shot *shot = data;
    /* Whether the desktop gives it the focus is chance. */
    gtk_widget_unset_state_flags(widget, GTK_STATE_FLAG_BACKDROP);
    if (shot->frames == 0 && tinker_plan_task_is_due(shot->window->plan)) return G_SOURCE_CONTINUE;
    if (tinker_accuracy_page_is_measuring(shot->window->accuracy)) return G_SOURCE_CONTINUE;
    if (tinker_equations_page_is_behind(TINKER_EQUATIONS_PAGE(shot->window->equations))) return G_SOURCE_CONTINUE;
    if (tinker_graph_plot_any_behind(widget)) shot->frames = MIN(shot->frames, FRAMES_BEFORE + 1);
    /* It was set for a canvas that may have been larger. */
    if (shot->frames == FRAMES_BEFORE) tinker_canvas_show_first(shot->window->canvas);
    if (shot->frames++ < FRAMES_BEFORE + FRAMES_AFTER) return G_SOURCE_CONTINUE;
    g_idle_add_full(G_PRIORITY_LOW + 100, on_idle, shot, NULL);
    return G_SOURCE_REMOVE;
}

void tinker_screenshot_take(AdwApplication *application, TinkerCatalogue *catalogue, const TinkerScreenshot *screenshot,
                            TinkerScreenshotDone done, gpointer data)
{
    g_object_set(gtk_settings_get_default(), "gtk-enable-animations", FALSE, "gtk-cursor-blink", FALSE, NULL);
    Shot *shot = g_new0(Shot, 1);
    *shot = (Shot){screenshot, tinker_window_new(application, catalogue), done, data, 0};
    int status = show(shot->window, screenshot);
    if (status != TINKER_EXIT_DONE) {
        finish(shot, status);
        return;
    }
    gtk_window_set_default_size(GTK_WINDOW(shot->window), screenshot->width, screenshot->height);
    gtk_widget_realize(GTK_WIDGET(shot->window));
    /* Frame or shadow, by what the display can do. */
    gtk_widget_remove_css_class(GTK_WIDGET(shot->window), "solid-csd");
    gtk_widget_remove_css_class(GTK_WIDGET(shot->window), "csd");
    gtk_window_set_focus_visible(GTK_WINDOW(shot->window), FALSE);
    gtk_window_present(GTK_WINDOW(shot->window));
    tinker_plan_task_demand(shot->window->plan);
    if (screenshot->measure) tinker_accuracy_page_measure(shot->window->accuracy);
    gtk_widget_add_tick_callback(GTK_WIDGET(shot->window), on_frame, shot, NULL);
}
