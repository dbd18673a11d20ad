/* A width that was not touched follows the system of units; a wrong one is marked as it is typed, and says why on
 * Create. */
#include "gui/window/new-dialog.h"

#include <glib/gi18n.h>

#include "gui/document/new-scene.h"

struct _TinkerNewDialog {
    AdwWindow parent_instance;
    gboolean width_typed, updating;

    /* Parts of new-dialog.ui. */
    AdwComboRow *units;
    AdwEntryRow *width;
    GtkLabel *fault;
    GtkRevealer *fault_revealer;
};

G_DEFINE_FINAL_TYPE(TinkerNewDialog, tinker_new_dialog, ADW_TYPE_WINDOW)

static guint create_signal;

static TinkerUnitSystem chosen_units(TinkerNewDialog *dialog)
{
    return adw_combo_row_get_selected(dialog->units) == 1 ? TINKER_UNIT_SYSTEM_ENGLISH : TINKER_UNIT_SYSTEM_SI;
}

static void show_fault(TinkerNewDialog *dialog, const char *fault)
{
    if (fault != NULL) {
        gtk_label_set_text(dialog->fault, fault);
        gtk_widget_add_css_class(GTK_WIDGET(dialog->width), "error");
    } else {
        gtk_widget_remove_css_class(GTK_WIDGET(dialog->width), "error");
    }
    gtk_revealer_set_reveal_child(dialog->fault_revealer, fault != NULL);
    gtk_accessible_update_state(GTK_ACCESSIBLE(dialog->width), GTK_ACCESSIBLE_STATE_INVALID,
                                fault != NULL ? GTK_ACCESSIBLE_INVALID_TRUE : GTK_ACCESSIBLE_INVALID_FALSE, -1);
}

static gboolean read_settings(TinkerNewDialog *dialog, TinkerNewScene *settings)
{
    g_autoptr(GError) error = NULL;
    settings->units = chosen_units(dialog);
    gboolean good = tinker_new_scene_parse_width(gtk_editable_get_text(GTK_EDITABLE(dialog->width)), settings->units,
                                                 &settings->width, &error);
    show_fault(dialog, good ? NULL : error->message);
    return good;
}

static void on_width_changed(TinkerNewDialog *dialog)
{
    TinkerNewScene settings;
    if (dialog->updating) return;
    dialog->width_typed = TRUE;
    read_settings(dialog, &settings);
}

static void set_default_width(TinkerNewDialog *dialog)
{
    dialog->updating = TRUE;
    gtk_editable_set_text(GTK_EDITABLE(dialog->width), tinker_new_scene_default_width(chosen_units(dialog)));
    dialog->updating = FALSE;
}

static void on_units_changed(TinkerNewDialog *dialog)
{
    TinkerNewScene settings;
    if (dialog->width == NULL) return; /* the template is still being read */
    if (dialog->width_typed)
        read_settings(dialog, &settings);
    else
        set_default_width(dialog);
}

static void on_create(TinkerNewDialog *dialog)
{
    TinkerNewScene settings;
    if (!read_settings(dialog, &settings)) {
        gtk_widget_grab_focus(GTK_WIDGET(dialog->width));
        return;
    }
    g_object_ref(dialog);
    gtk_window_close(GTK_WINDOW(dialog));
    g_signal_emit(dialog, create_signal, 0, &settings);
    g_object_unref(dialog);
}

static void tinker_new_dialog_dispose(GObject *object)
{
    gtk_widget_dispose_template(GTK_WIDGET(object), TINKER_TYPE_NEW_DIALOG);
    G_OBJECT_CLASS(tinker_new_dialog_parent_class)->dispose(object);
}

static void tinker_new_dialog_class_init(TinkerNewDialogClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_new_dialog_dispose;
    create_signal = g_signal_new("create", TINKER_TYPE_NEW_DIALOG, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE,
                                 1, G_TYPE_POINTER);
    gtk_widget_class_set_template_from_resource(widget_class, "/org/tinker/Tinker/new-dialog.ui");
    gtk_widget_class_bind_template_child(widget_class, TinkerNewDialog, units);
    gtk_widget_class_bind_template_child(widget_class, TinkerNewDialog, width);
    gtk_widget_class_bind_template_child(widget_class, TinkerNewDialog, fault);
    gtk_widget_class_bind_template_child(widget_class, TinkerNewDialog, fault_revealer);
    gtk_widget_class_bind_template_callback(widget_class, on_create);
    gtk_widget_class_bind_template_callback(widget_class, on_units_changed);
    gtk_widget_class_bind_template_callback(widget_class, on_width_changed);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_Escape, 0, "window.close", NULL);
}

static void tinker_new_dialog_init(TinkerNewDialog *dialog)
{
    gtk_widget_init_template(GTK_WIDGET(dialog));
    set_default_width(dialog);
    gtk_widget_grab_focus(GTK_WIDGET(dialog->width)); /* Enter creates from there */
}

GtkWidget *tinker_new_dialog_new(GtkWindow *parent)
{
    return g_object_new(TINKER_TYPE_NEW_DIALOG, "transient-for", parent, NULL);
}
