/* Accuracy at a glance: the line at the bottom, the notices at the top and the page about it, fed from the plan and the
 * run. */
#include <glib/gi18n.h>
#include <math.h>

#include "gui/document/run-choice.h"
#include "gui/property/property-panel.h"
#include "gui/text/sentence.h"
#include "gui/window/side-panel.h"
#include "gui/window/window-parts.h"
#include "physics/model/warning.h"

#define PAGE    "accuracy"
#define REFRESH 200 /* ms: how often the line is brought up to date while something happens */

/* Notices ---------------------------------------------------------------------------------------------------------- */

static void choose_automatically(void *data)
{
    TinkerWindow *window = data;
    g_autoptr(GError) error = NULL;
    gboolean done = tinker_run_choice_automatic(window->document, &error);
    window_toast(window, done ? _("The method is chosen automatically from now on") : error->message);
}

static void show_accuracy(void *data)
{
    const TinkerWindow *window = data;
    adw_view_stack_set_visible_child_name(window->pages, PAGE);
}

/* Where it is chosen: among the properties of the scene. */
static void show_law_of_impact(void *data)
{
    const TinkerWindow *window = data;
    tinker_document_select(window->document, TINKER_NO_BLOCK);
    adw_view_stack_set_visible_child_name(window->pages, "model");
    gtk_widget_set_visible(GTK_WIDGET(window->panel_side), TRUE);
    tinker_side_panel_show(window->side_panel, "properties");
    tinker_property_panel_focus_law_of_impact(TINKER_PROPERTY_PANEL(window->properties));
}

/* What helps is offered by a button where it has a name. */
static char *text_of(TinkerWindow *window, const TinkerWarning *warning)
{
    return tinker_sentence_in(tinker_document_scene(window->document),
                              warning->brief != NULL ? warning->brief : warning->text);
}

static void add_notice(GPtrArray *notices, TinkerWindow *window, const TinkerWarning *warning, const char *button,
                       void (*cure)(void *data))
{
    g_autofree char *text = text_of(window, warning);
    g_ptr_array_add(notices, tinker_notice_new(TINKER_NOTICE_WARNING, text, button, cure, window, NULL));
}

/* A cure of what samples do not show. */
typedef struct {
    TinkerWindow *window;
    double interval; /* s */
} Recording;

static void record_more_often(void *data)
{
    const Recording *recording = data;
    g_autoptr(GError) error = NULL;
    if (!tinker_run_choice_record(recording->window->document, recording->interval, &error))
        window_toast(recording->window, error->message);
}

static void add_recording_notice(GPtrArray *notices, TinkerWindow *window, const TinkerWarning *warning)
{
    const Recording recording = {window, warning->number};
    g_autofree char *text = text_of(window, warning);
    g_ptr_array_add(notices, tinker_notice_new(TINKER_NOTICE_WARNING, text, _("Record More Often"), record_more_often,
                                               g_memdup2(&recording, sizeof recording), g_free));
}

static GPtrArray *new_notices(void)
{
    return g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
}

/* Of the plan's warnings those that another method avoids, and shapes that overlap at the start; what else is wrong
 * with the start, the advice tells. */
static void show_plan_notices(TinkerWindow *window)
{
    const TinkerPlanResult *result = tinker_plan_task_result(window->plan);
    GPtrArray *notices = new_notices();
    for (guint i = 0; result != NULL && result->plan != NULL && i < result->plan->warnings->len; i++) {
        TinkerWarning *warning = g_ptr_array_index(result->plan->warnings, i);
        if (g_ptr_array_find(result->avoidable, warning, NULL))
            add_notice(notices, window, warning, _("Choose Automatically"), choose_automatically);
        else if (warning->kind == TINKER_WARNING_SCENE)
            add_notice(notices, window, warning, NULL, NULL);
    }
    tinker_notice_bar_set(window->notices, "plan", notices);
}

/* A run tells at its end what it saw; the cure is another method, or a look at how they compare, where either helps. */
static void show_run_notices(TinkerWindow *window)
{
    const char *method = tinker_scene_head(tinker_document_scene(window->document))->run.method;
    gboolean automatic = g_str_equal(method, "auto");
    g_autoptr(GPtrArray) warnings = tinker_player_warnings(window->player);
    const TinkerPlanResult *result = tinker_plan_task_result(window->plan);
    GPtrArray *notices = new_notices();
    for (guint i = 0; i < warnings->len; i++) {
        const TinkerWarning *warning = g_ptr_array_index(warnings, i);
        if (result != NULL && result->plan != NULL && tinker_warnings_say(result->plan->warnings, warning->text))
            continue;
        switch (warning->kind) {
        case TINKER_WARNING_SAMPLES:
            add_recording_notice(notices, window, warning);
            break;
        case TINKER_WARNING_LAWS:
            add_notice(notices, window, warning, _("Choose the Law of Impact"), show_law_of_impact);
            break;
        case TINKER_WARNING_START:
        case TINKER_WARNING_SCENE:
            add_notice(notices, window, warning, NULL, NULL);
            break;
        case TINKER_WARNING_METHOD:
            add_notice(notices, window, warning, automatic ? _("Compare Methods") : _("Choose Automatically"),
                       automatic ? show_accuracy : choose_automatically);
            break;
        }
    }
    tinker_notice_bar_set(window->notices, "run", notices);
}

/* The line --------------------------------------------------------------------------------------------------------- */

static gboolean on_refresh(void *data);

/* While there is a run under way, again and again. */
static void refresh_later(TinkerWindow *window)
{
    if (window->refresh == 0) window->refresh = g_timeout_add(REFRESH, on_refresh, window);
}

/* The last one before the time that is shown; NULL: none. */
static const TinkerRunEvent *last_event(TinkerPlayer *player)
{
    const GPtrArray *events = tinker_player_events(player);
    const double now = tinker_player_time(player);
    const TinkerRunEvent *last = NULL;
    for (guint i = 0; i < events->len; i++) {
        const TinkerRunEvent *event = g_ptr_array_index(events, i);
        if (event->time > now) break;
        last = event;
    }
    return last;
}

static void on_give_up(void *data)
{
    const TinkerWindow *window = data;
    tinker_player_give_up(window->player);
}

/* A run that shows nothing yet says why, and can be given up. */
static void show_look(TinkerWindow *window, gboolean looks)
{
    if (looks == window->told_look) return;
    GPtrArray *notices = new_notices();
    window->told_look = looks;
    if (looks)
        g_ptr_array_add(notices, tinker_notice_new(TINKER_NOTICE_HINT, _("Looking for where the run stops…"),
                                                   _("Cancel"), on_give_up, window, NULL));
    tinker_notice_bar_set(window->notices, "until", notices);
}

static void on_run_anew(void *data)
{
    const TinkerWindow *window = data;
    tinker_player_run_anew(window->player);
}

/* A run that was changed on the way is of two scenes, one behind the other: that is told as long as it is shown. */
static void show_changed(TinkerWindow *window)
{
    const double changed = tinker_player_changed_at(window->player);
    if (changed == window->told_changed || (isnan(changed) && isnan(window->told_changed))) return;
    window->told_changed = changed;
    GPtrArray *notices = new_notices();
    if (!isnan(changed)) {
        static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
        g_autofree char *time =
            tinker_quantity_brief(changed, seconds, tinker_scene_head(tinker_document_scene(window->document))->units);
        g_autofree char *text = g_strdup_printf(
            _("The change counts from t = %s on: before, the run is that of the scene as it was."), time);
        g_ptr_array_add(
            notices, tinker_notice_new(TINKER_NOTICE_HINT, text, _("Run From the Start"), on_run_anew, window, NULL));
    }
    tinker_notice_bar_set(window->notices, "changed", notices);
}

static gboolean on_refresh(void *data)
{
    TinkerWindow *window = data;
    TinkerRunStatus status;
    gboolean has_run = tinker_player_status(window->player, &status);
    window->refresh = 0;
    TinkerStatusFacts facts = {
        .run = has_run ? &status : NULL,
        .plan = tinker_plan_task_result(window->plan),
        .event = last_event(window->player),
        .duration = tinker_player_duration(window->player),
        .speed = tinker_player_speed(window->player),
        .pace = tinker_player_pace(window->player),
    };
    tinker_status_line_show(window->status_line, &facts);
    tinker_playbar_update(window->playbar);
    show_look(window, has_run && !status.finished && status.looks);
    show_changed(window);
    gboolean over = !has_run || status.finished;
    const guint how = !has_run ? 0 : status.estimate_due ? 1 : 2; /* an estimate that follows may warn of more */
    guint told = over ? 3 * tinker_player_generation(window->player) + how : 0;
    if (over && told != window->told_run) show_run_notices(window);
    window->told_run = told;
    if (!over) refresh_later(window);
    return G_SOURCE_REMOVE;
}

static void on_plan_changed(TinkerWindow *window)
{
    show_plan_notices(window);
    refresh_later(window);
}

static void on_told(GtkWidget *page, const char *text, TinkerWindow *window)
{
    window_toast(window, text);
}

/* Keys mean the scene again; a button that has gone would keep them from it. */
static void on_notice_done(TinkerWindow *window)
{
    gtk_widget_grab_focus(GTK_WIDGET(window->canvas));
}

void window_add_accuracy(TinkerWindow *window)
{
    window->status_line = tinker_status_line_new();
    window->told_changed = NAN;
    window->notices = tinker_notice_bar_new();
    gtk_box_append(window->status, GTK_WIDGET(window->status_line));
    gtk_box_append(window->banners, GTK_WIDGET(window->notices));
    g_signal_connect_object(window->notices, "done", G_CALLBACK(on_notice_done), window, G_CONNECT_SWAPPED);
    window->accuracy = g_object_new(TINKER_TYPE_ACCURACY_PAGE, NULL);
    AdwViewStackPage *page =
        adw_view_stack_add_titled(window->pages, GTK_WIDGET(window->accuracy), PAGE, _("Accuracy"));
    adw_view_stack_page_set_icon_name(page, "tinker-accuracy-symbolic");
    tinker_accuracy_page_set_document(window->accuracy, window->document);
    g_signal_connect_object(window->accuracy, "told", G_CALLBACK(on_told), window, 0);
    g_signal_connect_object(window->plan, "changed", G_CALLBACK(on_plan_changed), window, G_CONNECT_SWAPPED);
    g_signal_connect_object(window->document, "changed", G_CALLBACK(refresh_later), window, G_CONNECT_SWAPPED);
    g_signal_connect_object(window->player, "moved", G_CALLBACK(refresh_later), window, G_CONNECT_SWAPPED);
    g_signal_connect_object(window->player, "state-changed", G_CALLBACK(refresh_later), window, G_CONNECT_SWAPPED);
}

void window_remove_accuracy(TinkerWindow *window)
{
    if (window->refresh != 0) g_source_remove(window->refresh);
    window->refresh = 0;
    g_clear_object(&window->plan);
}
