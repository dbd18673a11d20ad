/* The page shows one of three views, by the state of its task: nothing measured yet, measuring, a result. */
#include "gui/accuracy/accuracy-page.h"

#include <adwaita.h>
#include <glib/gi18n.h>
#include <math.h>

#include "gui/accuracy/trade-table.h"
#include "gui/accuracy/trade-task.h"
#include "gui/accuracy/trade-view.h"
#include "gui/document/run-choice.h"
#include "gui/widget/unparent.h"

#define SECONDS     15.0 /* that measuring may take, about */
#define LEAST_ERROR 1e-15

struct _TinkerAccuracyPage {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerTradeTask *task;
    const TinkerTrade *shown; /* what chart and table borrow */

    /* Parts of accuracy-page.ui. */
    GtkEntryBuffer *wished; /* of both entries */
    GtkStack *views;
    AdwStatusPage *empty;
    GtkEntry *wished_first, *wished_again;
    GtkWidget *measure, *measure_again, *cancel, *use_advised;
    GtkProgressBar *progress;
    GtkRevealer *stale;
    GtkLabel *advice, *reference;
    TinkerTradeView *chart;
    TinkerTradeTable *table;
};

G_DEFINE_FINAL_TYPE(TinkerAccuracyPage, tinker_accuracy_page, GTK_TYPE_WIDGET)

static guint told_signal;

static void tell(TinkerAccuracyPage *page, const char *text)
{
    g_signal_emit(page, told_signal, 0, text);
}

/* Measuring -------------------------------------------------------------------------------------------------------- */

static gboolean read_wished(TinkerAccuracyPage *page, double *error)
{
    g_autofree char *text = g_strstrip(g_strdup(gtk_entry_buffer_get_text(page->wished)));
    char *end;
    g_strdelimit(text, ",", '.');
    *error = g_ascii_strtod(text, &end);
    return end != text && *end == '\0' && *error >= LEAST_ERROR && *error < 1;
}

static void mark(GtkWidget *entry, GtkWidget *button, gboolean good)
{
    gtk_widget_set_sensitive(button, good);
    gtk_widget_set_tooltip_text(entry, good ? _("Relative to the size of the whole motion: 1e-6 is a millionth of it")
                                            : _("A number between 1e-15 and 1, such as 1e-6"));
    gtk_accessible_update_state(GTK_ACCESSIBLE(entry), GTK_ACCESSIBLE_STATE_INVALID,
                                good ? GTK_ACCESSIBLE_INVALID_FALSE : GTK_ACCESSIBLE_INVALID_TRUE, -1);
    if (good)
        gtk_widget_remove_css_class(entry, "error");
    else
        gtk_widget_add_css_class(entry, "error");
}

static void on_wished_changed(TinkerAccuracyPage *page)
{
    double error;
    gboolean good = read_wished(page, &error);
    mark(GTK_WIDGET(page->wished_first), page->measure, good);
    mark(GTK_WIDGET(page->wished_again), page->measure_again, good);
}

static void on_measure(TinkerAccuracyPage *page)
{
    double error;
    if (!read_wished(page, &error)) return;
    tinker_trade_task_start(page->task, error, SECONDS);
    gtk_widget_grab_focus(page->cancel);
}

static void on_cancel(TinkerAccuracyPage *page)
{
    tinker_trade_task_cancel(page->task);
    gtk_progress_bar_set_text(page->progress, _("Stopping…"));
}

static void on_progress(TinkerAccuracyPage *page)
{
    double share = tinker_trade_task_progress(page->task);
    gtk_progress_bar_set_fraction(page->progress, share);
}

/* Using ------------------------------------------------------------------------------------------------------------ */

static void use(TinkerAccuracyPage *page, const TinkerTradeRow *row)
{
    g_autoptr(GError) error = NULL;
    if (isnan(row->error)) {
        tell(page, _("This one has no result: choose another"));
        return;
    }
    g_autofree char *setting = tinker_run_choice_text(&row->setting);
    g_autofree char *text = g_strdup_printf(_("%s is used from now on"), setting);
    tell(page, tinker_run_choice_use(page->document, row, &error) ? text : error->message);
}

static void on_chosen(GtkWidget *widget, const TinkerTradeRow *row, TinkerAccuracyPage *page)
{
    use(page, row);
}

static void on_use_advised(TinkerAccuracyPage *page)
{
    const TinkerTrade *trade = tinker_trade_task_result(page->task);
    if (trade != NULL && trade->advice.kind != TINKER_TRADE_ADVICE_NONE) use(page, &trade->advice.row);
}

/* Showing ---------------------------------------------------------------------------------------------------------- */

static void show_trade(TinkerAccuracyPage *page)
{
    const TinkerTrade *trade = tinker_trade_task_result(page->task);
    if (trade == page->shown) return;
    page->shown = trade;
    tinker_trade_view_set_trade(page->chart, trade);
    tinker_trade_table_set_trade(page->table, trade);
    if (trade == NULL) return;
    g_autofree char *advice = trade->interrupted ? g_strdup_printf(_("Stopped; of what was measured up to then: %s"),
                                                                   tinker_trade_task_advice(page->task))
                                                 : g_strdup(tinker_trade_task_advice(page->task));
    gtk_label_set_text(page->advice, advice);
    gtk_label_set_text(page->reference, tinker_trade_task_reference(page->task));
    gtk_widget_set_visible(page->use_advised, trade->advice.kind != TINKER_TRADE_ADVICE_NONE);
}

static void show_failure(TinkerAccuracyPage *page)
{
    const char *failure = tinker_trade_task_failure(page->task);
    adw_status_page_set_title(page->empty, failure != NULL ? _("Could Not Measure") : _("Speed and Accuracy"));
    adw_status_page_set_icon_name(page->empty,
                                  failure != NULL ? "dialog-warning-symbolic" : "tinker-accuracy-symbolic");
    g_autofree char *markup = failure != NULL ? g_markup_escape_text(failure, -1) : NULL;
    adw_status_page_set_description(
        page->empty,
        markup != NULL
            ? markup
            : _("Tries every installed method on this scene over a range of steps or tolerances, and compares each run "
                "with a reference. The chart then shows the error of each over the time that it takes to compute: "
                "click "
                "the one to use."));
}

static void on_task_changed(TinkerAccuracyPage *page)
{
    gboolean running = tinker_trade_task_is_running(page->task);
    gboolean had_focus = gtk_widget_is_focus(page->cancel);
    show_trade(page);
    show_failure(page);
    gboolean has_result = page->shown != NULL && tinker_trade_task_failure(page->task) == NULL;
    gtk_stack_set_visible_child_name(page->views, running ? "measuring" : has_result ? "result" : "empty");
    if (had_focus && !running) gtk_widget_grab_focus(has_result ? page->use_advised : page->measure);
    gtk_revealer_set_reveal_child(page->stale, tinker_trade_task_is_stale(page->task));
    gtk_progress_bar_set_text(page->progress, NULL);
    on_progress(page);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

void tinker_accuracy_page_set_document(TinkerAccuracyPage *page, TinkerDocument *document)
{
    page->document = g_object_ref(document);
    page->task = tinker_trade_task_new(document);
    g_signal_connect_object(page->task, "changed", G_CALLBACK(on_task_changed), page, G_CONNECT_SWAPPED);
    g_signal_connect_object(page->task, "progress", G_CALLBACK(on_progress), page, G_CONNECT_SWAPPED);
    on_task_changed(page);
    on_wished_changed(page);
}

void tinker_accuracy_page_measure(TinkerAccuracyPage *page)
{
    on_measure(page);
}

gboolean tinker_accuracy_page_is_measuring(TinkerAccuracyPage *page)
{
    return tinker_trade_task_is_running(page->task);
}

static void tinker_accuracy_page_dispose(GObject *object)
{
    TinkerAccuracyPage *page = TINKER_ACCURACY_PAGE(object);
    gtk_widget_dispose_template(GTK_WIDGET(object), TINKER_TYPE_ACCURACY_PAGE);
    tinker_unparent_children(GTK_WIDGET(object)); /* those without a name */
    g_clear_object(&page->task);
    g_clear_object(&page->document);
    G_OBJECT_CLASS(tinker_accuracy_page_parent_class)->dispose(object);
}

#define BIND(part)     gtk_widget_class_bind_template_child(widget_class, TinkerAccuracyPage, part)
#define CALLBACK(name) gtk_widget_class_bind_template_callback(widget_class, name)

static void tinker_accuracy_page_class_init(TinkerAccuracyPageClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_accuracy_page_dispose;
    gtk_widget_class_set_layout_manager_type(widget_class, GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(widget_class, "accuracypage");
    told_signal = g_signal_new("told", TINKER_TYPE_ACCURACY_PAGE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                               1, G_TYPE_STRING);
    g_type_ensure(TINKER_TYPE_TRADE_VIEW);
    g_type_ensure(TINKER_TYPE_TRADE_TABLE);
    gtk_widget_class_set_template_from_resource(widget_class, "/org/tinker/Tinker/accuracy-page.ui");
    BIND(wished);
    BIND(views);
    BIND(empty);
    BIND(wished_first);
    BIND(wished_again);
    BIND(measure);
    BIND(measure_again);
    BIND(cancel);
    BIND(use_advised);
    BIND(progress);
    BIND(stale);
    BIND(advice);
    BIND(reference);
    BIND(chart);
    BIND(table);
    CALLBACK(on_wished_changed);
    CALLBACK(on_measure);
    CALLBACK(on_cancel);
    CALLBACK(on_use_advised);
    CALLBACK(on_chosen);
}

static void tinker_accuracy_page_init(TinkerAccuracyPage *page)
{
    gtk_widget_init_template(GTK_WIDGET(page));
}
