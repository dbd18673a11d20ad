/* Options cost a search for equilibrium, so they are asked for when the loop has nothing else to do, at most ten times a
 * second, and less often where they take long. Rows stay as they are as long as the same is offered: only their values change,
 * and what is being typed is left alone. */
#include "start-panel.h"

#include <glib/gi18n.h>

#include "start-offer.h"

#define REFRESH_AFTER 100 /* ms */
#define LABEL_WIDTH   10  /* characters: longer ones are broken into lines */
#define VALUE_WIDTH   11
#define SHARE_OF_TIME 10 /* a refresh may take the tenth part of the time */

/* An option that asks for a value. */
typedef struct {
    TinkerStartPanel *panel;
    guint option;
    char *shown; /* what the entry says when nobody has typed */
    GtkWidget *row, *entry, *error;
} Row;

struct _TinkerStartPanel {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    GPtrArray *options; /* of TinkerStartOption *: those shown */
    GPtrArray *rows;    /* of Row */
    guint timer;
    gboolean outdated;
    gint64 cost; /* us: of the last refresh */
    GtkWidget *expander, *note, *hint, *choices, *list;
};

G_DEFINE_FINAL_TYPE(TinkerStartPanel, tinker_start_panel, GTK_TYPE_WIDGET)

static guint refused_signal;

/* Applying -------------------------------------------------------------------------------------------------------------- */

static void show_error(Row *row, const char *message)
{
    gtk_widget_set_visible(row->error, message != NULL);
    if (message != NULL) {
        gtk_label_set_text(GTK_LABEL(row->error), message);
        gtk_widget_add_css_class(row->entry, "error");
    } else {
        gtk_widget_remove_css_class(row->entry, "error");
    }
    gtk_accessible_update_state(GTK_ACCESSIBLE(row->entry), GTK_ACCESSIBLE_STATE_INVALID,
                                message != NULL ? GTK_ACCESSIBLE_INVALID_TRUE : GTK_ACCESSIBLE_INVALID_FALSE, -1);
}

static const char *typed_in(Row *row)
{
    return gtk_editable_get_text(GTK_EDITABLE(row->entry));
}

static void set_shown(Row *row, const char *text)
{
    char *copy = g_strdup(text);
    g_free(row->shown);
    row->shown = copy;
}

static void on_set(Row *row)
{
    TinkerStartPanel *panel = row->panel;
    g_autoptr(GError) error = NULL;
    double value;
    const TinkerStartOption *option = g_ptr_array_index(panel->options, row->option);
    if (!tinker_start_value_parse(tinker_document_scene(panel->document), option, typed_in(row), &value, &error)) {
        show_error(row, error->message);
        return;
    }
    set_shown(row, typed_in(row));
    if (!tinker_start_do(panel->document, panel->player, option, value, &error)) show_error(row, error->message);
}

static void on_choice(GtkWidget *button)
{
    TinkerStartPanel *panel = TINKER_START_PANEL(gtk_widget_get_ancestor(button, TINKER_TYPE_START_PANEL));
    guint option = GPOINTER_TO_UINT(g_object_get_data(G_OBJECT(button), "option"));
    g_autoptr(GError) error = NULL;
    if (!tinker_start_do(panel->document, panel->player, g_ptr_array_index(panel->options, option), 0, &error))
        g_signal_emit(panel, refused_signal, 0, error->message);
}

/* Rows ------------------------------------------------------------------------------------------------------------------ */

static void row_free(gpointer data)
{
    Row *row = data;
    g_free(row->shown);
    g_free(row);
}

static void on_typed(Row *row)
{
    show_error(row, NULL);
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state, Row *row)
{
    if (key != GDK_KEY_Escape || g_strcmp0(typed_in(row), row->shown) == 0) return GDK_EVENT_PROPAGATE;
    gtk_editable_set_text(GTK_EDITABLE(row->entry), row->shown);
    return GDK_EVENT_STOP;
}

static GtkWidget *entry_of(Row *row, const char *label)
{
    row->entry = gtk_entry_new();
    gtk_editable_set_width_chars(GTK_EDITABLE(row->entry), VALUE_WIDTH);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(row->entry), VALUE_WIDTH);
    gtk_accessible_update_property(GTK_ACCESSIBLE(row->entry), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    GtkEventController *keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    gtk_widget_add_controller(row->entry, keys);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), row);
    g_signal_connect_swapped(row->entry, "activate", G_CALLBACK(on_set), row);
    g_signal_connect_swapped(row->entry, "changed", G_CALLBACK(on_typed), row);
    return row->entry;
}

static GtkWidget *set_button(Row *row, const char *label)
{
    g_autofree char *name = g_strdup_printf(_("Set %s"), label);
    GtkWidget *button = gtk_button_new_with_label(_("Set"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    g_signal_connect_swapped(button, "clicked", G_CALLBACK(on_set), row);
    return button;
}

/* As narrow as its container makes it. */
static GtkWidget *wrapping_label(const char *text)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_max_width_chars(GTK_LABEL(label), LABEL_WIDTH);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    return label;
}

static void add_row(TinkerStartPanel *panel, guint number)
{
    const TinkerStartOption *option = g_ptr_array_index(panel->options, number);
    Row *row = g_new0(Row, 1);
    row->panel = panel;
    row->option = number;
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *value = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 0);
    GtkWidget *label = wrapping_label(option->label), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    gtk_widget_set_hexpand(label, TRUE);
    gtk_label_set_width_chars(GTK_LABEL(label), LABEL_WIDTH);
    gtk_widget_add_css_class(value, "linked");
    gtk_widget_set_valign(value, GTK_ALIGN_CENTER);
    gtk_box_append(GTK_BOX(value), entry_of(row, option->label));
    gtk_box_append(GTK_BOX(value), set_button(row, option->label));
    gtk_box_append(GTK_BOX(line), label);
    gtk_box_append(GTK_BOX(line), value);
    row->error = wrapping_label(NULL);
    gtk_widget_add_css_class(row->error, "error");
    gtk_widget_add_css_class(row->error, "caption");
    gtk_widget_set_visible(row->error, FALSE);
    gtk_box_append(GTK_BOX(box), line);
    gtk_box_append(GTK_BOX(box), row->error);
    row->row = gtk_list_box_row_new();
    gtk_list_box_row_set_activatable(GTK_LIST_BOX_ROW(row->row), FALSE);
    gtk_widget_set_focusable(row->row, FALSE);
    gtk_list_box_row_set_child(GTK_LIST_BOX_ROW(row->row), box);
    gtk_list_box_append(GTK_LIST_BOX(panel->list), row->row);
    g_ptr_array_add(panel->rows, row);
}

static void add_choice(TinkerStartPanel *panel, guint number)
{
    const TinkerStartOption *option = g_ptr_array_index(panel->options, number);
    g_autofree char *text = tinker_start_button_text(option->label);
    GtkWidget *button = gtk_button_new_with_label(text);
    gtk_widget_set_tooltip_text(button, option->description);
    g_object_set_data(G_OBJECT(button), "option", GUINT_TO_POINTER(number));
    g_signal_connect(button, "clicked", G_CALLBACK(on_choice), NULL);
    gtk_box_append(GTK_BOX(panel->choices), button);
}

/* Refreshing ------------------------------------------------------------------------------------------------------------ */

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
    for (guint i = 0; i < panel->rows->len; i++) {
        Row *row = g_ptr_array_index(panel->rows, i);
        if (gtk_widget_get_state_flags(row->entry) & GTK_STATE_FLAG_FOCUS_WITHIN)
            return g_ptr_array_index(panel->options, row->option);
    }
    return NULL;
}

/* Makes the rows anew; the focus goes to the row that asks for the same as the one that had it. (transfer full) */
static void rebuild(TinkerStartPanel *panel, GPtrArray *options)
{
    g_autoptr(GPtrArray) before = panel->options;
    const TinkerStartOption *focused = focused_option(panel);
    panel->options = options;
    remove_children(panel->choices, remove_from_box);
    remove_children(panel->list, remove_from_list);
    g_ptr_array_set_size(panel->rows, 0);
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        if (!option->asks) {
            add_choice(panel, i);
            continue;
        }
        add_row(panel, i);
        Row *row = g_ptr_array_index(panel->rows, panel->rows->len - 1);
        if (focused != NULL && focused->kind == option->kind && focused->block == option->block &&
            focused->other == option->other)
            gtk_widget_grab_focus(row->entry);
    }
    gtk_widget_set_visible(panel->choices, gtk_widget_get_first_child(panel->choices) != NULL);
    gtk_widget_set_visible(panel->list, panel->rows->len > 0);
}

static gboolean offers_the_same(const GPtrArray *a, const GPtrArray *b)
{
    if (a->len != b->len) return FALSE;
    for (guint i = 0; i < a->len; i++) {
        const TinkerStartOption *l = g_ptr_array_index(a, i), *r = g_ptr_array_index(b, i);
        if (l->kind != r->kind || l->block != r->block || l->other != r->other || !g_str_equal(l->label, r->label))
            return FALSE;
    }
    return TRUE;
}

static void show_values(TinkerStartPanel *panel)
{
    TinkerScene *scene = tinker_document_scene(panel->document);
    for (guint i = 0; i < panel->rows->len; i++) {
        Row *row = g_ptr_array_index(panel->rows, i);
        const TinkerStartOption *option = g_ptr_array_index(panel->options, row->option);
        gboolean typed = row->shown != NULL && g_strcmp0(typed_in(row), row->shown) != 0;
        g_autofree char *text = tinker_start_value_text(scene, option);
        gboolean failed = gtk_widget_get_visible(row->error);
        gtk_widget_set_tooltip_text(row->row, option->description);
        set_shown(row, text);
        if (!typed && !failed && g_strcmp0(typed_in(row), text) != 0)
            gtk_editable_set_text(GTK_EDITABLE(row->entry), text);
    }
}

/* The hint stands where nothing is selected; a block that has nothing to offer has no section. */
static void show_parts(TinkerStartPanel *panel)
{
    int selected;
    tinker_document_selection(panel->document, &selected);
    gtk_widget_set_visible(panel->hint, selected != 1);
    gtk_widget_set_visible(panel->note, panel->options->len > 0 && tinker_player_time(panel->player) > 0);
    gtk_widget_set_visible(panel->expander, selected != 1 || panel->options->len > 0);
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

/* The widget ---------------------------------------------------------------------------------------------------------- */

static void tinker_start_panel_init(TinkerStartPanel *panel)
{
    GtkWidget *title = gtk_label_new(_("Start")), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 8);
    gtk_widget_add_css_class(title, "heading");
    panel->options = g_ptr_array_new();
    panel->rows = g_ptr_array_new_with_free_func(row_free);
    panel->note = wrapping_label(_("Sets how the motion starts: goes back to t = 0."));
    panel->hint = wrapping_label(_("Select one body or connector to say how it starts."));
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

static void tinker_start_panel_dispose(GObject *object)
{
    TinkerStartPanel *panel = TINKER_START_PANEL(object);
    GtkWidget *child;
    g_clear_handle_id(&panel->timer, g_source_remove);
    while ((child = gtk_widget_get_first_child(GTK_WIDGET(object))) != NULL)
        gtk_widget_unparent(child);
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
    G_OBJECT_CLASS(class)->dispose = tinker_start_panel_dispose;
    G_OBJECT_CLASS(class)->finalize = tinker_start_panel_finalize;
    GTK_WIDGET_CLASS(class)->map = tinker_start_panel_map;
    refused_signal = g_signal_new("refused", TINKER_TYPE_START_PANEL, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                  G_TYPE_NONE, 1, G_TYPE_STRING);
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "startpanel");
}
