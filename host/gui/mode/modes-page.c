/* A list whose rows the arrow keys go through; the frame that swings belongs to the result's scene and goes with it. */
#include "gui/mode/modes-page.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "common/overlay/mode-shape.h"
#include "common/words/mode-words.h"
#include "gui/text/sentence.h"
#include "gui/widget/desktop-theme.h"
#include "gui/widget/unparent.h"
#include "render/plot/plot.h"

#define MOST_MODES    40
#define MOST_LEFT_OUT 4
#define CURVE_HEIGHT  220 /* px */
#define LEAST_PERIOD  0.8 /* s: of the swing that is shown, */
#define MOST_PERIOD   3.0 /* as long as it takes, or within these */

struct _TinkerModesPage {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerCanvas *canvas; /* borrowed; weak */
    TinkerModesTask *task;
    GtkWidget *note, *list, *driven, *curve;
    TinkerFrame *frame;     /* NULL: none is shown */
    const TinkerMode *mode; /* that is shown, of the result */
    double amplitude;       /* m */
    gint64 began;           /* us */
    guint tick;             /* 0: it does not swing */
    gboolean was_selected;  /* the row that is being clicked */
};

G_DEFINE_FINAL_TYPE(TinkerModesPage, tinker_modes_page, GTK_TYPE_WIDGET)

/* The swing -------------------------------------------------------------------------------------------------------- */

static void stop_swing(TinkerModesPage *page)
{
    if (page->tick != 0) gtk_widget_remove_tick_callback(GTK_WIDGET(page), page->tick);
    page->tick = 0;
    if (page->frame != NULL && page->canvas != NULL) tinker_canvas_show_over(page->canvas, NULL);
    g_clear_pointer(&page->frame, tinker_frame_free);
    page->mode = NULL;
}

/* What does not swing is shown at its greatest. */
static double phase_of(const TinkerModesPage *page, gint64 now)
{
    if (!(page->mode->frequency > 0)) return 0;
    const double period = CLAMP(2 * G_PI / page->mode->frequency, LEAST_PERIOD, MOST_PERIOD);
    return 2 * G_PI * (double)(now - page->began) / (G_USEC_PER_SEC * period);
}

static void show_phase(TinkerModesPage *page, double phase)
{
    tinker_mode_place(page->frame, tinker_modes_task_result(page->task)->analysis, page->mode, page->amplitude, phase);
    tinker_canvas_show_over(page->canvas, page->frame);
}

static gboolean on_tick(GtkWidget *widget, GdkFrameClock *clock, G_GNUC_UNUSED gpointer data)
{
    TinkerModesPage *page = TINKER_MODES_PAGE(widget);
    show_phase(page, phase_of(page, gdk_frame_clock_get_frame_time(clock)));
    return G_SOURCE_CONTINUE;
}

static void swing(TinkerModesPage *page, guint number)
{
    const TinkerModesResult *result = tinker_modes_task_result(page->task);
    gboolean animates = TRUE;
    stop_swing(page);
    if (result == NULL || result->analysis == NULL || page->canvas == NULL) return;
    if (number >= result->analysis->modes->len) return;
    if (tinker_player_state(page->player) == TINKER_PLAYER_PLAYING) tinker_player_pause(page->player);
    page->frame = tinker_frame_new(result->scene, NULL);
    if (page->frame == NULL) return;
    page->mode = g_ptr_array_index(result->analysis->modes, number);
    tinker_mode_place(page->frame, result->analysis, NULL, 0, 0);
    page->amplitude = tinker_mode_amplitude(page->frame);
    page->began = g_get_monotonic_time();
    g_object_get(gtk_widget_get_settings(GTK_WIDGET(page)), "gtk-enable-animations", &animates, NULL);
    show_phase(page, 0);
    if (animates) page->tick = gtk_widget_add_tick_callback(GTK_WIDGET(page), on_tick, NULL, NULL);
}

/* The list --------------------------------------------------------------------------------------------------------- */

static void on_row_selected(TinkerModesPage *page, GtkListBoxRow *row)
{
    if (row == NULL)
        stop_swing(page);
    else
        swing(page, (guint)gtk_list_box_row_get_index(row));
}

static void select_none(TinkerModesPage *page)
{
    gtk_list_box_unselect_all(GTK_LIST_BOX(page->list));
}

/* On the mode that swings already; not by the second press of a double click. */
static void on_list_pressed(GtkGestureClick *click, int presses, G_GNUC_UNUSED double x, double y,
                            TinkerModesPage *page)
{
    GtkListBoxRow *row = gtk_list_box_get_row_at_y(GTK_LIST_BOX(page->list), (int)y);
    page->was_selected = row != NULL && gtk_list_box_row_is_selected(row);
    if (!page->was_selected || presses > 1) return;
    gtk_gesture_set_state(GTK_GESTURE(click), GTK_EVENT_SEQUENCE_CLAIMED); // else the list selects it again
    select_none(page);
}

/* By Return, and behind a click, which has selected the row just now. */
static void on_row_activated(TinkerModesPage *page)
{
    if (page->was_selected) select_none(page);
    page->was_selected = TRUE;
}

static gboolean on_list_key(G_GNUC_UNUSED GtkEventControllerKey *keys, guint key, G_GNUC_UNUSED guint code,
                            G_GNUC_UNUSED GdkModifierType modifiers, TinkerModesPage *page)
{
    if (key != GDK_KEY_Escape || gtk_list_box_get_selected_row(GTK_LIST_BOX(page->list)) == NULL)
        return GDK_EVENT_PROPAGATE;
    select_none(page);
    return GDK_EVENT_STOP;
}

/* The run is seen as it is. */
static void on_player_state(TinkerModesPage *page)
{
    if (tinker_player_state(page->player) == TINKER_PLAYER_PLAYING) select_none(page);
}

/* The caption with lines that end behind commas and the like, and not within "T = 1.257 s". (transfer full) */
static char *unbroken(const char *caption)
{
    GString *text = g_string_new(NULL);
    const char *values = strchr(caption, ':');
    for (const char *at = caption; *at != '\0'; at++)
        if (*at == ' ' && values != NULL && at > values && strchr(",;:", at[-1]) == NULL)
            g_string_append_unichar(text, 0x00a0);
        else
            g_string_append_c(text, *at);
    return g_string_free(text, FALSE);
}

static void add_row(TinkerModesPage *page, const TinkerModeAnalysis *analysis, guint number)
{
    const TinkerMode *mode = g_ptr_array_index(analysis->modes, number);
    g_autofree char *caption = tinker_mode_caption(analysis, mode, mode->number);
    g_autofree char *text = unbroken(caption);
    g_autofree char *ratio = tinker_mode_ratio(analysis, mode, tinker_modes_task_result(page->task)->scene);
    g_autofree char *told = ratio != NULL ? g_strdup_printf("%s\n%s", caption, ratio) : g_strdup(caption);
    g_autofree char *shown = ratio != NULL ? g_strdup_printf("%s\n%s", text, ratio) : g_strdup(text);
    GtkWidget *label = gtk_label_new(shown), *row = gtk_list_box_row_new();
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_list_box_row_set_child(GTK_LIST_BOX_ROW(row), label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(row), GTK_ACCESSIBLE_PROPERTY_LABEL, told, -1);
    gtk_list_box_append(GTK_LIST_BOX(page->list), row);
}

/* The first drive that has an answer; NULL: there is none. */
static const TinkerDriveResponse *shown_response(const TinkerModesPage *page)
{
    const TinkerModesResult *result = tinker_modes_task_result(page->task);
    return result != NULL && result->responses != NULL && result->responses->len > 0
               ? g_ptr_array_index(result->responses, 0)
               : NULL;
}

static void draw_curve(G_GNUC_UNUSED GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    const TinkerDriveResponse *response = shown_response(data);
    if (response == NULL) return;
    g_autofree char *title = g_strdup_printf(_("%s per %s"), response->quantity, response->drive);
    g_autofree char *label = g_strdup_printf(_("Amplitude [%s]"), response->unit);
    const TinkerCurve curve = {.x = (const double *)(gconstpointer)response->hertz->data,
                               .y = (const double *)(gconstpointer)response->amplitude->data,
                               .count = response->hertz->len};
    const TinkerPlot plot = {.title = title,
                             .x_label = _("Frequency [Hz]"),
                             .y_label = label,
                             .x_logarithmic = TRUE,
                             .y_logarithmic = TRUE,
                             .curves = &curve,
                             .curve_count = 1,
                             .theme = tinker_desktop_theme(),
                             .compact = TRUE,
                             .cursor = isnan(response->driven) ? NULL : &response->driven};
    tinker_plot_draw(cairo, &plot, width, height);
}

/* Which drives are near a resonance, and the response to the first one. */
static void show_drives(TinkerModesPage *page, const TinkerModesResult *result)
{
    g_autoptr(GString) text = g_string_new(NULL);
    for (guint i = 0; result != NULL && result->responses != NULL && i < result->responses->len; i++) {
        g_autofree char *sentence = tinker_drive_response_sentence(g_ptr_array_index(result->responses, i));
        if (sentence != NULL) g_string_append_printf(text, "%s%s", text->len > 0 ? "\n" : "", sentence);
    }
    gtk_label_set_text(GTK_LABEL(page->driven), text->str);
    gtk_widget_set_visible(page->driven, text->len > 0);
    const TinkerDriveResponse *response = shown_response(page);
    gtk_widget_set_visible(page->curve, response != NULL);
    if (response == NULL) return;
    g_autofree char *name = g_strdup_printf(_("Response of %s to %s"), response->quantity, response->drive);
    gtk_accessible_update_property(GTK_ACCESSIBLE(page->curve), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    gtk_widget_queue_draw(page->curve);
}

/* The note, and what does not count, a sentence a line. (transfer full) */
static char *with_left_out(const char *note, const TinkerModesResult *result)
{
    GString *text = g_string_new(note);
    g_autoptr(GPtrArray) left_out = tinker_modes_left_out(result->analysis, result->scene);
    for (guint i = 0; i < left_out->len && i < MOST_LEFT_OUT; i++)
        g_string_append_printf(text, "\n%s.", (const char *)g_ptr_array_index(left_out, i));
    if (left_out->len > MOST_LEFT_OUT) g_string_append(text, "\n…");
    return g_string_free(text, FALSE);
}

/* What is to be said beside the list; NULL: nothing. (transfer full) */
static char *note_of(TinkerModesPage *page, const TinkerModesResult *result)
{
    TinkerScene *scene = tinker_document_scene(page->document);
    if (result->analysis == NULL)
        return result->error != NULL ? tinker_sentence_in(scene, result->error->message) : NULL;
    if (result->analysis->modes->len == 0) return tinker_modes_none(result->analysis, result->scene);
    if (!result->analysis->about_rest)
        return with_left_out(
            _("The scene has no rest that it comes to: these are the modes about its start, held still."), result);
    return with_left_out(
        _("Small motions about the rest of the scene. The mode that is selected swings on the canvas; a "
          "second click, Escape or Play ends that."),
        result);
}

static void on_result(TinkerModesPage *page)
{
    const TinkerModesResult *result = tinker_modes_task_result(page->task);
    stop_swing(page);
    GtkListBoxRow *row;
    while ((row = gtk_list_box_get_row_at_index(GTK_LIST_BOX(page->list), 0)) != NULL)
        gtk_list_box_remove(GTK_LIST_BOX(page->list), GTK_WIDGET(row));
    g_autofree char *note = result != NULL ? note_of(page, result) : NULL;
    gtk_label_set_text(GTK_LABEL(page->note), note != NULL ? note : "");
    const guint count = result != NULL && result->analysis != NULL ? MIN(result->analysis->modes->len, MOST_MODES) : 0;
    for (guint i = 0; i < count; i++)
        add_row(page, result->analysis, i);
    gtk_widget_set_visible(page->list, count > 0);
    show_drives(page, result);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

static void tinker_modes_page_map(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(tinker_modes_page_parent_class)->map(widget);
    tinker_modes_task_want(TINKER_MODES_PAGE(widget)->task, TRUE);
}

static void tinker_modes_page_unmap(GtkWidget *widget)
{
    TinkerModesPage *page = TINKER_MODES_PAGE(widget);
    tinker_modes_task_want(page->task, FALSE);
    select_none(page);
    stop_swing(page);
    GTK_WIDGET_CLASS(tinker_modes_page_parent_class)->unmap(widget);
}

GtkWidget *tinker_modes_page_new(TinkerDocument *document, TinkerPlayer *player, TinkerCanvas *canvas,
                                 TinkerModesTask *task)
{
    GtkGesture *click = gtk_gesture_click_new();
    TinkerModesPage *page = g_object_new(TINKER_TYPE_MODES_PAGE, NULL);
    page->document = g_object_ref(document);
    g_set_weak_pointer(&page->canvas, canvas);
    page->player = g_object_ref(player);
    page->task = g_object_ref(task);
    g_signal_connect_object(page->task, "changed", G_CALLBACK(on_result), page, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_player_state), page, G_CONNECT_SWAPPED);
    /* what is clicked on the canvas is meant to be seen as it is */
    gtk_event_controller_set_propagation_phase(GTK_EVENT_CONTROLLER(click), GTK_PHASE_CAPTURE);
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), 0);
    g_signal_connect_object(click, "pressed", G_CALLBACK(select_none), page, G_CONNECT_SWAPPED);
    gtk_widget_add_controller(GTK_WIDGET(canvas), GTK_EVENT_CONTROLLER(click));
    return GTK_WIDGET(page);
}

static void tinker_modes_page_dispose(GObject *object)
{
    TinkerModesPage *page = TINKER_MODES_PAGE(object);
    stop_swing(page);
    if (page->list != NULL) tinker_unparent_children(GTK_WIDGET(object));
    page->list = NULL;
    g_clear_weak_pointer(&page->canvas);
    g_clear_object(&page->task);
    g_clear_object(&page->player);
    g_clear_object(&page->document);
    G_OBJECT_CLASS(tinker_modes_page_parent_class)->dispose(object);
}

static void tinker_modes_page_class_init(TinkerModesPageClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_modes_page_dispose;
    widget_class->map = tinker_modes_page_map;
    widget_class->unmap = tinker_modes_page_unmap;
    gtk_widget_class_set_layout_manager_type(widget_class, GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(widget_class, "modespage");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_GROUP);
}

static void add_list_input(TinkerModesPage *page)
{
    GtkGesture *click = gtk_gesture_click_new();
    GtkEventController *keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(GTK_EVENT_CONTROLLER(click), GTK_PHASE_CAPTURE);
    g_signal_connect(click, "pressed", G_CALLBACK(on_list_pressed), page);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_list_key), page);
    gtk_widget_add_controller(page->list, GTK_EVENT_CONTROLLER(click));
    gtk_widget_add_controller(page->list, keys);
    page->was_selected = TRUE;
}

static void tinker_modes_page_init(TinkerModesPage *page)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(page));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
    gtk_box_layout_set_spacing(GTK_BOX_LAYOUT(layout), 8);
    page->note = gtk_label_new("");
    gtk_label_set_xalign(GTK_LABEL(page->note), 0);
    gtk_label_set_wrap(GTK_LABEL(page->note), TRUE);
    gtk_widget_add_css_class(page->note, "dim-label");
    page->list = gtk_list_box_new();
    gtk_widget_add_css_class(page->list, "boxed-list");
    gtk_widget_set_visible(page->list, FALSE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(page->list), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Modes"), -1);
    gtk_widget_set_parent(page->note, GTK_WIDGET(page));
    page->driven = gtk_label_new("");
    gtk_label_set_xalign(GTK_LABEL(page->driven), 0);
    gtk_label_set_wrap(GTK_LABEL(page->driven), TRUE);
    gtk_widget_set_visible(page->driven, FALSE);
    page->curve = g_object_new(GTK_TYPE_DRAWING_AREA, "accessible-role", GTK_ACCESSIBLE_ROLE_IMG, NULL);
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(page->curve), CURVE_HEIGHT);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(page->curve), draw_curve, page, NULL);
    gtk_widget_set_visible(page->curve, FALSE);
    tinker_desktop_theme_redraws(page->curve);
    gtk_widget_set_parent(page->list, GTK_WIDGET(page));
    gtk_widget_set_parent(page->driven, GTK_WIDGET(page));
    gtk_widget_set_parent(page->curve, GTK_WIDGET(page));
    g_signal_connect_swapped(page->list, "row-selected", G_CALLBACK(on_row_selected), page);
    g_signal_connect_swapped(page->list, "row-activated", G_CALLBACK(on_row_activated), page);
    add_list_input(page);
}
