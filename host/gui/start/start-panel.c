/* Options cost a search for equilibrium, so they are asked for when the loop has nothing else to do, at most ten times
 * a second, and less often where they take long. Rows stay as they are as long as the same is offered: only their
 * values change, and what is being typed is left alone. */
#include "gui/start/start-panel.h"

#include <glib/gi18n.h>

#include "gui/start/start-offer.h"
#include "gui/start/start-row.h"
#include "gui/widget/unparent.h"

#define REFRESH_AFTER 100 /* ms */
#define SHARE_OF_TIME 10  /* a refresh may take the tenth part of the time */

struct _TinkerStartPanel {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    GPtrArray *options; /* of TinkerStartOption *: those shown */
    GPtrArray *rows;    /* of TinkerStartRow *, borrowed: those of options that ask for a value */
    guint timer;
    gboolean outdated;
    gboolean trims;
    gint64 cost; /* us: of the last refresh */
    GtkWidget *expander, *note, *hint, *choices, *list;
};

G_DEFINE_FINAL_TYPE(TinkerStartPanel, tinker_start_panel, GTK_TYPE_WIDGET)

enum { PROP_TRIMS = 1 };

static guint refused_signal;

/* Applying
 * -------------------------------------------------------------------------------------------------------------- */

static const TinkerStartOption *option_of(TinkerStartPanel *panel, GtkWidget *widget)
{
    return g_ptr_array_index(panel->options, GPOINTER_TO_UINT(g_object_get_data(G_OBJECT(widget), "option")));
}

static void on_apply(TinkerStartRow *row, const char *text, TinkerStartPanel *panel)
{
    g_autoptr(GError) error = NULL;
    double value;
    const TinkerStartOption *option = option_of(panel, GTK_WIDGET(row));
    if (!tinker_start_value_parse(tinker_document_scene(panel->document), option, text, &value, &error) ||
        !tinker_start_do(panel->document, panel->player, option, value, &error))
        tinker_start_row_refuse(row, error->message);
}

static void on_choice(GtkWidget *button, TinkerStartPanel *panel)
{
    g_autoptr(GError) error = NULL;
    if (!tinker_start_do(panel->document, panel->player, option_of(panel, button), 0, &error))
        g_signal_emit(panel, refused_signal, 0, error->message);
}

static void add_row(TinkerStartPanel *panel, const TinkerStartOption *option, guint number)
{
    TinkerStartRow *row = tinker_start_row_new(option->label);
    g_object_set_data(G_OBJECT(row), "option", GUINT_TO_POINTER(number));
    g_signal_connect(row, "apply", G_CALLBACK(on_apply), panel);
    gtk_list_box_append(GTK_LIST_BOX(panel->list), GTK_WIDGET(row));
    g_ptr_array_add(panel->rows, row);
}

static void add_choice(TinkerStartPanel *panel, const TinkerStartOption *option, guint number)
{
    g_autofree char *text = tinker_start_button_label(option);
    GtkWidget *button = gtk_button_new_with_label(text);
    GtkLabel *words = GTK_LABEL(gtk_button_get_child(GTK_BUTTON(button)));
    gtk_label_set_wrap(words, TRUE);
    gtk_label_set_wrap_mode(words, PANGO_WRAP_WORD_CHAR);
    gtk_label_set_justify(words, GTK_JUSTIFY_CENTER);
    gtk_widget_set_tooltip_text(button, option->description);
    g_object_set_data(G_OBJECT(button), "option", GUINT_TO_POINTER(number));
    g_signal_connect(button, "clicked", G_CALLBACK(on_choice), panel);
    gtk_box_append(GTK_BOX(panel->choices), button);
}

/* Refreshing
 * ------------------------------------------------------------------------------------------------------------ */

static void remove_children(GtkWidget *parent, void (*remove)(GtkWidget *parent, GtkWidget *child))
{
    GtkWidget *child;
    while ((child = gtk_widget_get_first_child(parent)) != NULL)
        remove(parent, child);
}

static void remove_from_box(GtkWidget *box, GtkWidget *child)
{
    gtk_box_remove(GTK_BOX(box), child);
}

static void remove_from_list(GtkWidget *list, GtkWidget *child)
{
    gtk_list_box_remove(GTK_LIST_BOX(list), child);
}

/* The option whose entry has the focus, or NULL. */
static const TinkerStartOption *focused_option(TinkerStartPanel *panel)
{
    for (guint i = 0; i < panel->rows->len; i++)
        if (tinker_start_row_has_focus(g_ptr_array_index(panel->rows, i)))
            return option_of(panel, g_ptr_array_index(panel->rows, i));
    return NULL;
}

static gboolean is_same(const TinkerStartOption *a, const TinkerStartOption *b)
{
    return a->kind == b->kind && a->block == b->block && a->other == b->other && g_str_equal(a->label, b->label);
}

/* Makes the rows anew; the focus goes to the row that asks for the same as the one that had it. (transfer full) */
static void rebuild(TinkerStartPanel *panel, GPtrArray *options)
{
    const TinkerStartOption *focused = focused_option(panel);
    g_autoptr(GPtrArray) before = panel->options;
    panel->options = options;
    g_ptr_array_set_size(panel->rows, 0);
    remove_children(panel->choices, remove_from_box);
    remove_children(panel->list, remove_from_list);
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        if (!option->asks) {
            add_choice(panel, option, i);
            continue;
        }
        add_row(panel, option, i);
        if (focused != NULL && is_same(focused, option))
            tinker_start_row_focus(g_ptr_array_index(panel->rows, panel->rows->len - 1));
    }
    gtk_widget_set_visible(panel->choices, gtk_widget_get_first_child(panel->choices) != NULL);
    gtk_widget_set_visible(panel->list, panel->rows->len > 0);
}

static gboolean offers_the_same(const GPtrArray *a, const GPtrArray *b)
{
    if (a->len != b->len) return FALSE;
    for (guint i = 0; i < a->len; i++)
        if (!is_same(g_ptr_array_index(a, i), g_ptr_array_index(b, i))) return FALSE;
    return TRUE;
}

static void show_values(TinkerStartPanel *panel)
{
    TinkerScene *scene = tinker_document_scene(panel->document);
    for (guint i = 0; i < panel->rows->len; i++) {
        TinkerStartRow *row = g_ptr_array_index(panel->rows, i);
        const TinkerStartOption *option = option_of(panel, GTK_WIDGET(row));
        g_autofree char *text = tinker_start_value_text(scene, option, panel->trims);
        tinker_start_row_show(row, text, option->description);
    }
}

/* The hint stands where there is nothing to choose: it says what to select, or that what is selected has its properties
 * alone, as a force has. */
static void show_parts(TinkerStartPanel *panel)
{
    int count;
    tinker_document_selection(panel->document, &count);
    const gboolean offers = panel->options->len > 0;
    g_autofree char *plain = count == 1
                                 ? g_strdup_printf(_("%s starts as its properties say."),
                                                   tinker_scene_block_name(tinker_document_scene(panel->document),
                                                                           tinker_document_selected(panel->document)))
                                 : NULL;
    gtk_label_set_text(GTK_LABEL(panel->hint),
                       plain != NULL ? plain : _("Select one body or connector to say how it starts."));
    gtk_widget_set_visible(panel->hint, !offers);
    gtk_widget_set_visible(panel->note, offers && tinker_player_time(panel->player) > 0);
}

static void refresh(TinkerStartPanel *panel)
{
    gint64 from = g_get_monotonic_time();
    panel->outdated = FALSE;
    GPtrArray *options =
        tinker_start_options_new(tinker_document_scene(panel->document), tinker_document_selected(panel->document));
    panel->cost = g_get_monotonic_time() - from;
    if (offers_the_same(panel->options, options)) {
        g_ptr_array_unref(panel->options);
        panel->options = options;
    } else {
        rebuild(panel, options);
    }
    show_values(panel);
    show_parts(panel);
}

static gboolean on_timer(gpointer data)
{
    TinkerStartPanel *panel = data;
    panel->timer = 0;
    refresh(panel);
    return G_SOURCE_REMOVE;
}

/* While it cannot be seen, it is remembered. */
static void refresh_after(TinkerStartPanel *panel, guint milliseconds)
{
    panel->outdated = TRUE;
    if (!gtk_widget_get_mapped(GTK_WIDGET(panel)) || panel->timer != 0) return;
    guint pause = MAX(milliseconds, (guint)(SHARE_OF_TIME * panel->cost / 1000));
    panel->timer = g_timeout_add_full(G_PRIORITY_LOW, pause, on_timer, panel, NULL);
}

static void on_changed(TinkerStartPanel *panel)
{
    refresh_after(panel, REFRESH_AFTER);
}

static void on_selection_changed(TinkerStartPanel *panel)
{
    refresh_after(panel, 0);
}

static void on_moved(TinkerStartPanel *panel)
{
    gtk_widget_set_visible(panel->note, panel->options->len > 0 && tinker_player_time(panel->player) > 0);
}

static void tinker_start_panel_map(GtkWidget *widget)
{
    TinkerStartPanel *panel = TINKER_START_PANEL(widget);
    GTK_WIDGET_CLASS(tinker_start_panel_parent_class)->map(widget);
    if (panel->outdated) refresh_after(panel, 0);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_start_panel_init(TinkerStartPanel *panel)
{
    GtkWidget *title = gtk_label_new(_("Start")), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 8);
    gtk_widget_add_css_class(title, "heading");
    panel->options = g_ptr_array_new();
    panel->rows = g_ptr_array_new();
    panel->note = tinker_start_wrapping_label(_("Changes the start: goes back to 0 s."));
    panel->hint = tinker_start_wrapping_label("");
    panel->choices = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    panel->list = gtk_list_box_new();
    gtk_list_box_set_selection_mode(GTK_LIST_BOX(panel->list), GTK_SELECTION_NONE);
    gtk_widget_add_css_class(panel->list, "boxed-list");
    gtk_widget_add_css_class(panel->note, "caption");
    gtk_widget_add_css_class(panel->note, "dim-label");
    gtk_widget_add_css_class(panel->hint, "dim-label");
    GtkWidget *parts[] = {panel->note, panel->hint, panel->choices, panel->list};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        gtk_widget_set_visible(parts[i], FALSE);
        gtk_box_append(GTK_BOX(box), parts[i]);
    }
    gtk_widget_set_margin_top(box, 8);
    panel->expander = gtk_expander_new(NULL);
    gtk_expander_set_label_widget(GTK_EXPANDER(panel->expander), title);
    gtk_accessible_update_property(GTK_ACCESSIBLE(panel->expander), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   gtk_label_get_text(GTK_LABEL(title)), -1);
    gtk_expander_set_child(GTK_EXPANDER(panel->expander), box);
    gtk_expander_set_expanded(GTK_EXPANDER(panel->expander), TRUE);
    gtk_widget_add_css_class(panel->expander, "start-panel");
    gtk_widget_set_parent(panel->expander, GTK_WIDGET(panel));
}

GtkWidget *tinker_start_panel_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerStartPanel *panel = g_object_new(TINKER_TYPE_START_PANEL, NULL);
    panel->document = g_object_ref(document);
    panel->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), panel, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "selection-changed", G_CALLBACK(on_selection_changed), panel, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(on_moved), panel, G_CONNECT_SWAPPED);
    panel->outdated = TRUE;
    return GTK_WIDGET(panel);
}

static void tinker_start_panel_get_property(GObject *object, guint id, GValue *value, GParamSpec *spec)
{
    g_value_set_boolean(value, TINKER_START_PANEL(object)->trims);
}

static void tinker_start_panel_set_property(GObject *object, guint id, const GValue *value, GParamSpec *spec)
{
    TinkerStartPanel *panel = TINKER_START_PANEL(object);
    if (panel->trims == g_value_get_boolean(value)) return;
    panel->trims = !panel->trims;
    refresh_after(panel, 0);
    g_object_notify_by_pspec(object, spec);
}

static void tinker_start_panel_dispose(GObject *object)
{
    TinkerStartPanel *panel = TINKER_START_PANEL(object);
    g_clear_handle_id(&panel->timer, g_source_remove);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&panel->player);
    g_clear_object(&panel->document);
    G_OBJECT_CLASS(tinker_start_panel_parent_class)->dispose(object);
}

static void tinker_start_panel_finalize(GObject *object)
{
    g_ptr_array_unref(TINKER_START_PANEL(object)->rows);
    g_ptr_array_unref(TINKER_START_PANEL(object)->options);
    G_OBJECT_CLASS(tinker_start_panel_parent_class)->finalize(object);
}

static void tinker_start_panel_class_init(TinkerStartPanelClass *class)
{
    GObjectClass *object_class = G_OBJECT_CLASS(class);
    object_class->get_property = tinker_start_panel_get_property;
    object_class->set_property = tinker_start_panel_set_property;
    object_class->dispose = tinker_start_panel_dispose;
    const GParamFlags flags = G_PARAM_READWRITE | G_PARAM_STATIC_STRINGS | G_PARAM_EXPLICIT_NOTIFY;
    g_object_class_install_property(object_class, PROP_TRIMS, g_param_spec_boolean("trims", NULL, NULL, FALSE, flags));
    G_OBJECT_CLASS(class)->finalize = tinker_start_panel_finalize;
    GTK_WIDGET_CLASS(class)->map = tinker_start_panel_map;
    refused_signal = g_signal_new("refused", TINKER_TYPE_START_PANEL, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                  G_TYPE_NONE, 1, G_TYPE_STRING);
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "startpanel");
}
