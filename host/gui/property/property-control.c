/* The control of a property: an entry, a list, a switch or a reading. */
#include <glib/gi18n.h>

#include "gui/property/property-field-private.h"
#include "gui/property/table-chooser.h"
#include "gui/widget/choices.h"

static void show_choices(TinkerPropertyField *field)
{
    GtkDropDown *control = GTK_DROP_DOWN(field->control);
    GListModel *model = gtk_drop_down_get_model(control);
    guint count = g_strv_length(field->row->choices);
    gboolean same = model != NULL && g_list_model_get_n_items(model) == count;
    for (guint i = 0; same && i < count; i++)
        same = g_str_equal(gtk_string_list_get_string(GTK_STRING_LIST(model), i), field->row->choices[i]);
    if (!same) {
        g_autoptr(GtkStringList) choices = gtk_string_list_new((const char *const *)field->row->choices);
        gtk_drop_down_set_model(control, G_LIST_MODEL(choices));
    }
    gtk_drop_down_set_selected(control,
                               field->row->chosen >= 0 ? (guint)field->row->chosen : GTK_INVALID_LIST_POSITION);
}

void property_control_show(TinkerPropertyField *field)
{
    field->showing = TRUE;
    gtk_widget_set_sensitive(field->control, field->row->sensitive);
    switch (field->row->kind) {
    case TINKER_ROW_CHOICE:
        show_choices(field);
        break;
    case TINKER_ROW_SWITCH:
        gtk_switch_set_active(GTK_SWITCH(field->control), field->row->chosen == 1);
        break;
    case TINKER_ROW_READING:
        gtk_label_set_text(GTK_LABEL(field->control), field->row->text);
        break;
    default:
        property_entry_show(field);
        break;
    }
    field->showing = FALSE;
}

static void choose(TinkerPropertyField *field, int choice)
{
    g_autoptr(GError) error = NULL;
    if (field->showing || field->document == NULL || choice == field->row->chosen) return;
    if (choice == field->row->file_choice) {
        property_control_show(field); /* until there is a file */
        tinker_choose_table(GTK_WIDGET(field), field->document, field->row);
        return;
    }
    if (tinker_property_row_choose(field->document, field->row, choice, &error)) {
        property_field_set_problem(field, NULL);
        return;
    }
    property_field_set_problem(field, error->message);
    property_control_show(field);
}

static void on_chosen(TinkerPropertyField *field)
{
    guint chosen = gtk_drop_down_get_selected(GTK_DROP_DOWN(field->control));
    if (chosen != GTK_INVALID_LIST_POSITION) choose(field, (int)chosen);
}

static void on_switched(TinkerPropertyField *field)
{
    choose(field, gtk_switch_get_active(GTK_SWITCH(field->control)) ? 1 : 0);
}

static void on_detach(TinkerPropertyField *field)
{
    g_autoptr(GError) error = NULL;
    field->dirty = FALSE;
    if (!tinker_property_row_set(field->document, field->row, "", &error))
        property_field_set_problem(field, error->message);
}

static GtkWidget *make_drop_down(TinkerPropertyField *field)
{
    GtkWidget *drop_down = gtk_drop_down_new(NULL, NULL);
    tinker_choices_cut_off(GTK_DROP_DOWN(drop_down));
    g_signal_connect_swapped(drop_down, "notify::selected", G_CALLBACK(on_chosen), field);
    return drop_down;
}

static GtkWidget *make_switch(TinkerPropertyField *field)
{
    GtkWidget *control = gtk_switch_new();
    gtk_widget_set_halign(control, GTK_ALIGN_START);
    gtk_widget_set_valign(control, GTK_ALIGN_CENTER);
    g_signal_connect_swapped(control, "notify::active", G_CALLBACK(on_switched), field);
    return control;
}

static GtkWidget *make_label(void)
{
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    gtk_widget_add_css_class(label, "numeric");
    gtk_widget_add_css_class(label, "reading");
    return label;
}

GtkWidget *property_control_new(TinkerPropertyField *field)
{
    switch (field->row->kind) {
    case TINKER_ROW_CHOICE:
        return make_drop_down(field);
    case TINKER_ROW_SWITCH:
        return make_switch(field);
    case TINKER_ROW_READING:
        return make_label();
    default:
        return property_entry_new(field);
    }
}

GtkWidget *property_control_detach_new(TinkerPropertyField *field)
{
    GtkWidget *button = gtk_button_new_from_icon_name("list-remove-symbolic");
    g_autofree char *label = g_strdup_printf(_("Detach %s"), field->row->title);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_set_tooltip_text(button, label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    g_signal_connect_swapped(button, "clicked", G_CALLBACK(on_detach), field);
    return button;
}
