/* What each source gives is kept whole; what is shown is a list of borrowed notices that is made anew at every change.
 * The bar lies over the top of the canvas: it comes and goes by itself, so nothing may move for it. */
#include "gui/widget/notice-bar.h"

#include <glib/gi18n.h>
#include <string.h>

#include "gui/widget/beside.h"
#include "gui/widget/unparent.h"

#define LOW       300 /* px: of a picture, of which a notice hides too much if it is not cut */
#define LOW_LINES 3
#define LOW_LEAST 140 /* px: for its text beside its buttons */

struct _TinkerNoticeBar {
    GtkWidget parent_instance;
    GtkWidget *bar, *line, *text, *label, *count, *next, *cure;
    gboolean is_low;     /* what it lies over */
    guint fitting;       /* id of the idle source, or 0 */
    GHashTable *sources; /* of GPtrArray of TinkerNotice *, by name */
    GHashTable *closed;  /* of texts */
    GPtrArray *listed;   /* of TinkerNotice *, borrowed from the sources */
    guint place;         /* of the one that is shown */
};

G_DEFINE_FINAL_TYPE(TinkerNoticeBar, tinker_notice_bar, GTK_TYPE_WIDGET)

static guint done_signal;

TinkerNotice *tinker_notice_new(TinkerNoticeSeverity severity, const char *text, const char *button,
                                void (*cure)(void *data), void *data, GDestroyNotify free_data)
{
    TinkerNotice *notice = g_new(TinkerNotice, 1);
    *notice = (TinkerNotice){severity, g_strdup(text), g_strdup(button), cure, data, free_data, NULL};
    return notice;
}

void tinker_notice_free(TinkerNotice *notice)
{
    if (notice == NULL) return;
    if (notice->free_data != NULL) notice->free_data(notice->data);
    g_free(notice->text);
    g_free(notice->button);
    g_free(notice);
}

/* The list --------------------------------------------------------------------------------------------------------- */

static gboolean same_text(const void *left, const void *right)
{
    return strcmp(((const TinkerNotice *)left)->text, ((const TinkerNotice *)right)->text) == 0;
}

static int by_severity(const void *left, const void *right)
{
    const TinkerNotice *l = *(TinkerNotice *const *)left, *r = *(TinkerNotice *const *)right;
    if (l->severity != r->severity) return (int)r->severity - (int)l->severity;
    return (l->button == NULL) - (r->button == NULL);
}

static gboolean is_given(TinkerNoticeBar *bar, const char *text)
{
    GHashTableIter sources;
    gpointer notices;
    const TinkerNotice wanted = {.text = (char *)text};
    g_hash_table_iter_init(&sources, bar->sources);
    while (g_hash_table_iter_next(&sources, NULL, &notices))
        if (g_ptr_array_find_with_equal_func(notices, &wanted, same_text, NULL)) return TRUE;
    return FALSE;
}

static void list_source(TinkerNoticeBar *bar, const GPtrArray *notices)
{
    for (guint i = 0; i < notices->len; i++) {
        TinkerNotice *notice = g_ptr_array_index(notices, i);
        if (g_hash_table_contains(bar->closed, notice->text)) continue;
        if (g_ptr_array_find_with_equal_func(bar->listed, notice, same_text, NULL)) continue;
        g_ptr_array_add(bar->listed, notice);
    }
}

static void list_all(TinkerNoticeBar *bar)
{
    GHashTableIter iter;
    gpointer entry;
    g_hash_table_iter_init(&iter, bar->closed);
    while (g_hash_table_iter_next(&iter, &entry, NULL))
        if (!is_given(bar, entry)) g_hash_table_iter_remove(&iter);
    g_ptr_array_set_size(bar->listed, 0);
    g_hash_table_iter_init(&iter, bar->sources);
    while (g_hash_table_iter_next(&iter, NULL, &entry))
        list_source(bar, entry);
    g_ptr_array_sort(bar->listed, by_severity);
}

/* Showing ---------------------------------------------------------------------------------------------------------- */

/* The text, as much of it as there is room for, and its tip. */
static void fill_text(TinkerNoticeBar *bar, const TinkerNotice *notice)
{
    const char *select = notice->locate != NULL ? _("Select what this is about") : NULL;
    g_autofree char *whole = g_strjoin("\n", notice->text, select, NULL);
    gtk_label_set_text(GTK_LABEL(bar->label), notice->text);
    gtk_label_set_lines(GTK_LABEL(bar->label), bar->is_low ? LOW_LINES : -1);
    gtk_label_set_ellipsize(GTK_LABEL(bar->label), bar->is_low ? PANGO_ELLIPSIZE_END : PANGO_ELLIPSIZE_NONE);
    gtk_widget_set_tooltip_text(bar->text, bar->is_low ? whole : select);
    gtk_accessible_update_property(GTK_ACCESSIBLE(bar->text), GTK_ACCESSIBLE_PROPERTY_LABEL, notice->text, -1);
    gtk_widget_set_can_target(bar->text, bar->is_low || notice->locate != NULL);
    gtk_widget_set_focusable(bar->text, notice->locate != NULL);
    tinker_beside_set_least(TINKER_BESIDE(bar->line), bar->is_low ? LOW_LEAST : TINKER_BESIDE_LEAST);
}

static void fill(TinkerNoticeBar *bar)
{
    static const GtkMessageType types[] = {GTK_MESSAGE_INFO, GTK_MESSAGE_WARNING, GTK_MESSAGE_ERROR};
    const TinkerNotice *notice = g_ptr_array_index(bar->listed, bar->place);
    g_autofree char *count = g_strdup_printf(_("%u of %u"), bar->place + 1, bar->listed->len);
    gtk_info_bar_set_message_type(GTK_INFO_BAR(bar->bar), types[notice->severity]);
    fill_text(bar, notice);
    gtk_label_set_text(GTK_LABEL(bar->count), count);
    gtk_widget_set_visible(bar->count, bar->listed->len > 1);
    gtk_widget_set_visible(bar->next, bar->listed->len > 1);
    gtk_widget_set_visible(bar->cure, notice->button != NULL);
    gtk_button_set_label(GTK_BUTTON(bar->cure), notice->button != NULL ? notice->button : "");
    tinker_beside_wrap(bar->cure);
}

static void show(TinkerNoticeBar *bar)
{
    gboolean wanted = bar->listed->len > 0;
    bar->place = wanted ? MIN(bar->place, bar->listed->len - 1) : 0;
    if (wanted) fill(bar);
    gtk_widget_set_visible(bar->bar, wanted);
}

void tinker_notice_bar_set(TinkerNoticeBar *bar, const char *source, GPtrArray *notices)
{
    const TinkerNotice *shown = bar->listed->len > 0 ? g_ptr_array_index(bar->listed, bar->place) : NULL;
    g_autofree char *text = shown != NULL ? g_strdup(shown->text) : NULL;
    g_hash_table_replace(bar->sources, g_strdup(source), notices);
    list_all(bar);
    /* The one that is being read stays, where it still counts. */
    bar->place = 0;
    for (guint i = 0; text != NULL && i < bar->listed->len; i++)
        if (strcmp(((TinkerNotice *)g_ptr_array_index(bar->listed, i))->text, text) == 0) bar->place = i;
    show(bar);
}

static gboolean on_fit(gpointer data)
{
    TinkerNoticeBar *bar = data;
    bar->fitting = 0;
    show(bar);
    return G_SOURCE_REMOVE;
}

void tinker_notice_bar_set_room(TinkerNoticeBar *bar, int height)
{
    const gboolean is_low = height < LOW;
    if (is_low != bar->is_low && bar->fitting == 0) bar->fitting = g_idle_add(on_fit, bar);
    bar->is_low = is_low;
}

/* Buttons ---------------------------------------------------------------------------------------------------------- */

static void on_next(TinkerNoticeBar *bar)
{
    if (bar->listed->len == 0) return;
    bar->place = (bar->place + 1) % bar->listed->len;
    show(bar);
}

static void on_text(TinkerNoticeBar *bar)
{
    if (bar->listed->len == 0) return;
    const TinkerNotice *notice = g_ptr_array_index(bar->listed, bar->place);
    if (notice->locate == NULL) return;
    notice->locate(notice->data);
    g_signal_emit(bar, done_signal, 0);
}

static void on_cure(TinkerNoticeBar *bar)
{
    if (bar->listed->len == 0) return;
    const TinkerNotice *notice = g_ptr_array_index(bar->listed, bar->place);
    if (notice->cure != NULL) notice->cure(notice->data); /* which may well take the notice away */
    g_signal_emit(bar, done_signal, 0);
}

static void on_response(TinkerNoticeBar *bar, int response)
{
    if (response != GTK_RESPONSE_CLOSE || bar->listed->len == 0) return;
    g_hash_table_add(bar->closed, g_strdup(((TinkerNotice *)g_ptr_array_index(bar->listed, bar->place))->text));
    list_all(bar);
    show(bar);
    g_signal_emit(bar, done_signal, 0);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_notice_bar_dispose(GObject *object)
{
    g_clear_handle_id(&TINKER_NOTICE_BAR(object)->fitting, g_source_remove);
    tinker_unparent_children(GTK_WIDGET(object));
    G_OBJECT_CLASS(tinker_notice_bar_parent_class)->dispose(object);
}

static void tinker_notice_bar_finalize(GObject *object)
{
    TinkerNoticeBar *bar = TINKER_NOTICE_BAR(object);
    g_ptr_array_unref(bar->listed);
    g_hash_table_unref(bar->sources);
    g_hash_table_unref(bar->closed);
    G_OBJECT_CLASS(tinker_notice_bar_parent_class)->finalize(object);
}

static void tinker_notice_bar_class_init(TinkerNoticeBarClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_notice_bar_dispose;
    G_OBJECT_CLASS(class)->finalize = tinker_notice_bar_finalize;
    done_signal = g_signal_new("done", TINKER_TYPE_NOTICE_BAR, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "noticebar");
}

static void add_parts(TinkerNoticeBar *bar)
{
    bar->label = gtk_label_new(NULL);
    gtk_label_set_wrap(GTK_LABEL(bar->label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(bar->label), PANGO_WRAP_WORD_CHAR); /* a name may be one long word */
    gtk_label_set_xalign(GTK_LABEL(bar->label), 0);
    bar->text = gtk_button_new();
    gtk_button_set_child(GTK_BUTTON(bar->text), bar->label);
    gtk_widget_add_css_class(bar->text, "flat");
    bar->count = gtk_label_new(NULL);
    gtk_widget_add_css_class(bar->count, "numeric");
    bar->next = gtk_button_new_from_icon_name("go-next-symbolic");
    gtk_widget_add_css_class(bar->next, "flat");
    gtk_widget_set_tooltip_text(bar->next, _("Next Notice"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(bar->next), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Next Notice"), -1);
    bar->cure = gtk_button_new();
    GtkWidget *parts[] = {bar->count, bar->next, bar->cure}, *buttons = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        gtk_widget_set_valign(parts[i], GTK_ALIGN_CENTER);
        gtk_box_append(GTK_BOX(buttons), parts[i]);
    }
    gtk_widget_set_valign(bar->text, GTK_ALIGN_CENTER);
    bar->line = tinker_beside_new(bar->text, buttons);
    gtk_widget_set_hexpand(bar->line, TRUE);
    gtk_info_bar_add_child(GTK_INFO_BAR(bar->bar), bar->line);
    g_signal_connect_swapped(bar->text, "clicked", G_CALLBACK(on_text), bar);
    g_signal_connect_swapped(bar->next, "clicked", G_CALLBACK(on_next), bar);
    g_signal_connect_swapped(bar->cure, "clicked", G_CALLBACK(on_cure), bar);
}

/* GTK's info bar makes the cross itself, of the style class "close", and gives it no name. */
static void name_close_button(GtkWidget *widget)
{
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child)) {
        if (GTK_IS_BUTTON(child) && gtk_widget_has_css_class(child, "close")) {
            gtk_widget_set_tooltip_text(child, _("Close Notice"));
            gtk_accessible_update_property(GTK_ACCESSIBLE(child), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Close Notice"), -1);
        }
        name_close_button(child);
    }
}

static void tinker_notice_bar_init(TinkerNoticeBar *bar)
{
    bar->sources = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, (GDestroyNotify)g_ptr_array_unref);
    bar->closed = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    bar->listed = g_ptr_array_new();
    bar->bar = gtk_info_bar_new();
    gtk_widget_set_visible(bar->bar, FALSE);
    gtk_info_bar_set_show_close_button(GTK_INFO_BAR(bar->bar), TRUE);
    name_close_button(bar->bar);
    add_parts(bar);
    g_signal_connect_swapped(bar->bar, "response", G_CALLBACK(on_response), bar);
    gtk_widget_set_parent(bar->bar, GTK_WIDGET(bar));
}

TinkerNoticeBar *tinker_notice_bar_new(void)
{
    return g_object_new(TINKER_TYPE_NOTICE_BAR, NULL);
}
