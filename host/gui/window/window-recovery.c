/* The question about what was left behind when the program did not close properly. */
#include "gui/window/window-recovery.h"

#include <glib/gi18n.h>

#include "gui/document/recovery.h"
#include "gui/text/message.h"
#include "gui/window/window-parts.h"

/* The question ----------------------------------------------------------------------------------------------------- */

/* What is asked about. */
typedef struct {
    AdwApplication *application;
    TinkerWindow *window; /* owned */
    GPtrArray *list;      /* of TinkerRecovery * */
    GPtrArray *checks;    /* of GtkCheckButton *, one for each; empty where there is but one */
} Offer;

static void offer_free(Offer *offer)
{
    g_object_unref(offer->window);
    g_ptr_array_unref(offer->list);
    g_ptr_array_unref(offer->checks);
    g_free(offer);
}

static gboolean is_wanted(Offer *offer, guint number)
{
    return offer->checks->len == 0 ||
           gtk_check_button_get_active(GTK_CHECK_BUTTON(g_ptr_array_index(offer->checks, number)));
}

static TinkerWindow *window_for(Offer *offer)
{
    if (tinker_window_is_untouched(offer->window)) return offer->window;
    TinkerWindow *window = tinker_window_new(offer->application, tinker_document_catalogue(offer->window->document));
    gtk_window_present(GTK_WINDOW(window));
    return window;
}

static void recover(Offer *offer, TinkerRecovery *recovery)
{
    g_autoptr(GError) error = NULL;
    TinkerWindow *window = window_for(offer);
    if (!tinker_recovery_open(recovery, window->document, &error))
        window_message(window, _("The Scene Was Not Recovered"), error->message);
    else if (tinker_autosave_now(window->autosave))
        tinker_recovery_remove(recovery);
}

static void discard(Offer *offer, TinkerRecovery *recovery)
{
    g_autoptr(GError) error = NULL;
    if (!tinker_recovery_discard(recovery, &error))
        window_message(offer->window, _("The Scene Was Not Discarded"), error->message);
}

static void on_answer(AdwMessageDialog *dialog, const char *answer, Offer *offer)
{
    gboolean recovers = g_strcmp0(answer, "recover") == 0, discards = g_strcmp0(answer, "discard") == 0;
    for (guint i = 0; i < offer->list->len; i++) {
        if (!is_wanted(offer, i)) continue;
        if (recovers) recover(offer, g_ptr_array_index(offer->list, i));
        if (discards) discard(offer, g_ptr_array_index(offer->list, i));
    }
}

/* "12:31", with the day where that was not today. (transfer full) */
static char *time_text(gint64 seconds)
{
    g_autoptr(GDateTime) then = g_date_time_new_from_unix_local(seconds), now = g_date_time_new_now_local();
    gboolean today = g_date_time_get_year(then) == g_date_time_get_year(now) &&
                     g_date_time_get_day_of_year(then) == g_date_time_get_day_of_year(now);
    return g_date_time_format(then, today ? "%H:%M" : "%-d %B %Y, %H:%M");
}

static GtkWidget *row_of(Offer *offer, TinkerRecovery *recovery)
{
    GtkWidget *row = adw_action_row_new(), *check = gtk_check_button_new();
    g_autofree char *time = time_text(recovery->time), *title = g_markup_escape_text(recovery->name, -1);
    g_autofree char *subtitle = g_strdup_printf(_("Changed %s"), time);
    adw_preferences_row_set_title(ADW_PREFERENCES_ROW(row), title);
    adw_action_row_set_subtitle(ADW_ACTION_ROW(row), subtitle);
    gtk_check_button_set_active(GTK_CHECK_BUTTON(check), TRUE);
    gtk_widget_set_valign(check, GTK_ALIGN_CENTER);
    gtk_accessible_update_property(GTK_ACCESSIBLE(check), GTK_ACCESSIBLE_PROPERTY_LABEL, recovery->name, -1);
    adw_action_row_add_prefix(ADW_ACTION_ROW(row), check);
    adw_action_row_set_activatable_widget(ADW_ACTION_ROW(row), check);
    g_ptr_array_add(offer->checks, check);
    return row;
}

static GtkWidget *rows_of(Offer *offer)
{
    GtkWidget *scrolled = gtk_scrolled_window_new(), *list = gtk_list_box_new();
    gtk_widget_add_css_class(list, "boxed-list");
    gtk_list_box_set_selection_mode(GTK_LIST_BOX(list), GTK_SELECTION_NONE);
    for (guint i = 0; i < offer->list->len; i++)
        gtk_list_box_append(GTK_LIST_BOX(list), row_of(offer, g_ptr_array_index(offer->list, i)));
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_propagate_natural_height(GTK_SCROLLED_WINDOW(scrolled), TRUE);
    gtk_scrolled_window_set_max_content_height(GTK_SCROLLED_WINDOW(scrolled), 280);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), list);
    return scrolled;
}

/* The question, and below it what the handler of crashes said of the last of them. (transfer full) */
static char *with_blame(Offer *offer, char *question)
{
    const TinkerRecovery *last = g_ptr_array_index(offer->list, 0);
    if (last->blame == NULL) return question;
    char *both = g_strdup_printf("%s\n\n%s", question, last->blame);
    g_free(question);
    return both;
}

static char *question_of(Offer *offer)
{
    if (offer->list->len > 1) return g_strdup(_("Tinker did not close properly. These scenes were not saved:"));
    TinkerRecovery *recovery = g_ptr_array_index(offer->list, 0);
    g_autofree char *time = time_text(recovery->time);
    return g_strdup_printf(_("Tinker did not close properly. Recover “%s”, changed %s?"), recovery->name, time);
}

/* All was saved, but the user saw the window vanish. */
static void tell_of_crash(TinkerWindow *window)
{
    g_autofree char *blame = tinker_recovery_take_blame(), *text = NULL;
    if (blame == NULL) return;
    text = g_strdup_printf(_("No changes were lost.\n\n%s"), blame);
    window_message(window, _("Tinker Did Not Close Properly"), text);
}

void tinker_window_offer_recovery(TinkerWindow *window, AdwApplication *application)
{
    tinker_recovery_purge();
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    if (list->len == 0) {
        tell_of_crash(window);
        return;
    }
    Offer *offer = g_new(Offer, 1);
    *offer = (Offer){application, g_object_ref(window), g_ptr_array_ref(list), g_ptr_array_new()};
    g_autofree char *question = with_blame(offer, question_of(offer));
    GtkWidget *dialog = adw_message_dialog_new(GTK_WINDOW(window), _("Recover Unsaved Changes?"), question);
    if (list->len > 1) adw_message_dialog_set_extra_child(ADW_MESSAGE_DIALOG(dialog), rows_of(offer));
    adw_message_dialog_add_responses(ADW_MESSAGE_DIALOG(dialog), "later", _("_Later"), "discard", _("_Discard"),
                                     "recover", _("_Recover"), NULL);
    adw_message_dialog_set_response_appearance(ADW_MESSAGE_DIALOG(dialog), "discard", ADW_RESPONSE_DESTRUCTIVE);
    adw_message_dialog_set_response_appearance(ADW_MESSAGE_DIALOG(dialog), "recover", ADW_RESPONSE_SUGGESTED);
    adw_message_dialog_set_default_response(ADW_MESSAGE_DIALOG(dialog), "recover");
    adw_message_dialog_set_close_response(ADW_MESSAGE_DIALOG(dialog), "later");
    tinker_connect_answer(dialog, G_CALLBACK(on_answer), offer, (GDestroyNotify)offer_free);
    gtk_window_present(GTK_WINDOW(dialog));
}
