/* Leaving the entry applies nothing, as it moves blocks: that takes Return or the button. */
#include "gui/start/start-row.h"

#include <glib/gi18n.h>

#define LEAST_WIDTH 10 /* characters: longer texts are broken into lines */

struct _TinkerStartRow {
    GtkListBoxRow parent_instance;
    char *shown;  /* what the entry says when nobody has typed */
    char *before; /* what it was before the last that was applied */
    GtkWidget *label, *entry, *button, *error;
};

G_DEFINE_FINAL_TYPE(TinkerStartRow, tinker_start_row, GTK_TYPE_LIST_BOX_ROW)

static guint apply_signal;

static const char *typed_in(TinkerStartRow *row)
{
    return gtk_editable_get_text(GTK_EDITABLE(row->entry));
}

static void set_shown(TinkerStartRow *row, const char *text)
{
    char *copy = g_strdup(text);
    g_free(row->shown);
    row->shown = copy;
}

static void set_error(TinkerStartRow *row, const char *message)
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

/* What happens
 * ---------------------------------------------------------------------------------------------------------- */

/* What is applied counts as shown: the next value takes its place. */
static void on_apply(TinkerStartRow *row)
{
    g_autofree char *text = g_strdup(typed_in(row));
    g_autoptr(TinkerStartRow) alive = g_object_ref(row);
    set_error(row, NULL);
    g_free(row->before);
    row->before = g_strdup(row->shown);
    set_shown(row, text);
    g_signal_emit(alive, apply_signal, 0, text);
}

static void on_typed(TinkerStartRow *row)
{
    set_error(row, NULL);
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                       TinkerStartRow *row)
{
    gboolean as_shown = g_strcmp0(typed_in(row), row->shown) == 0 && !gtk_widget_get_visible(row->error);
    if (key != GDK_KEY_Escape || as_shown) return GDK_EVENT_PROPAGATE;
    gtk_editable_set_text(GTK_EDITABLE(row->entry), row->shown != NULL ? row->shown : "");
    set_error(row, NULL);
    return GDK_EVENT_STOP;
}

/* Public
 * ---------------------------------------------------------------------------------------------------------------- */

void tinker_start_row_show(TinkerStartRow *row, const char *value, const char *description)
{
    gboolean typed = row->shown != NULL && g_strcmp0(typed_in(row), row->shown) != 0;
    gboolean refused = gtk_widget_get_visible(row->error);
    gtk_widget_set_tooltip_text(GTK_WIDGET(row), description);
    set_shown(row, value);
    if (!typed && !refused && g_strcmp0(typed_in(row), value) != 0)
        gtk_editable_set_text(GTK_EDITABLE(row->entry), value);
}

void tinker_start_row_refuse(TinkerStartRow *row, const char *message)
{
    set_shown(row, row->before); /* which Escape brings back */
    set_error(row, message);
}

gboolean tinker_start_row_has_focus(TinkerStartRow *row)
{
    return (gtk_widget_get_state_flags(row->entry) & GTK_STATE_FLAG_FOCUS_WITHIN) != 0;
}

void tinker_start_row_focus(TinkerStartRow *row)
{
    gtk_widget_grab_focus(row->entry);
}

GtkWidget *tinker_start_wrapping_label(const char *text)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_max_width_chars(GTK_LABEL(label), LEAST_WIDTH);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    return label;
}

/* The widget ------------------------------------------------------------------------------------------------------- */

TinkerStartRow *tinker_start_row_new(const char *label)
{
    TinkerStartRow *row = g_object_new(TINKER_TYPE_START_ROW, NULL);
    g_autofree char *name = g_strdup_printf(_("Set %s"), label);
    gtk_label_set_text(GTK_LABEL(row->label), label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(row), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(row->entry), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(row->button), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    return row;
}

static GtkWidget *value_box(TinkerStartRow *row)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 0);
    GtkEventController *keys = gtk_event_controller_key_new();
    row->entry = gtk_entry_new();
    row->button = gtk_button_new_with_label(_("Set"));
    gtk_editable_set_width_chars(GTK_EDITABLE(row->entry), LEAST_WIDTH);
    gtk_widget_set_hexpand(row->entry, TRUE);
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    gtk_widget_add_controller(row->entry, keys);
    gtk_widget_add_css_class(box, "linked");
    gtk_box_append(GTK_BOX(box), row->entry);
    gtk_box_append(GTK_BOX(box), row->button);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), row);
    g_signal_connect_swapped(row->entry, "activate", G_CALLBACK(on_apply), row);
    g_signal_connect_swapped(row->entry, "changed", G_CALLBACK(on_typed), row);
    g_signal_connect_swapped(row->button, "clicked", G_CALLBACK(on_apply), row);
    return box;
}

static void tinker_start_row_init(TinkerStartRow *row)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    row->label = tinker_start_wrapping_label(NULL);
    row->error = tinker_start_wrapping_label(NULL);
    gtk_widget_add_css_class(row->error, "error");
    gtk_widget_add_css_class(row->error, "caption");
    gtk_box_append(GTK_BOX(box), row->label);
    gtk_box_append(GTK_BOX(box), value_box(row));
    gtk_box_append(GTK_BOX(box), row->error);
    gtk_widget_set_visible(row->error, FALSE);
    gtk_list_box_row_set_activatable(GTK_LIST_BOX_ROW(row), FALSE);
    gtk_widget_set_focusable(GTK_WIDGET(row), FALSE);
    gtk_list_box_row_set_child(GTK_LIST_BOX_ROW(row), box);
}

static void tinker_start_row_finalize(GObject *object)
{
    g_free(TINKER_START_ROW(object)->shown);
    g_free(TINKER_START_ROW(object)->before);
    G_OBJECT_CLASS(tinker_start_row_parent_class)->finalize(object);
}

static void tinker_start_row_class_init(TinkerStartRowClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_start_row_finalize;
    apply_signal = g_signal_new("apply", TINKER_TYPE_START_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1,
                                G_TYPE_STRING);
}
