/* What is wrong with an entry, below its control and for who hears the panel. */
#include "gui/property/property-field-private.h"

static void describe(TinkerPropertyField *field, const char *problem)
{
    const char *description = field->row->description != NULL ? field->row->description : "";
    g_autofree char *own = field->row->hint != NULL
                               ? g_strdup_printf("%s: %s %s", field->row->group, field->row->hint, description)
                               : g_strdup_printf("%s: %s", field->row->group, description);
    gtk_accessible_update_property(GTK_ACCESSIBLE(field->control), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   problem != NULL ? problem : own, -1);
}

void property_field_set_problem(TinkerPropertyField *field, const char *problem)
{
    GtkAccessible *accessible = GTK_ACCESSIBLE(field->control);
    gtk_label_set_text(GTK_LABEL(field->problem), problem != NULL ? problem : "");
    gtk_widget_set_visible(field->problem, problem != NULL);
    if (problem != NULL) {
        gtk_widget_add_css_class(field->control, "error");
        gtk_accessible_update_state(accessible, GTK_ACCESSIBLE_STATE_INVALID, GTK_ACCESSIBLE_INVALID_TRUE, -1);
    } else {
        gtk_widget_remove_css_class(field->control, "error");
        gtk_accessible_reset_state(accessible, GTK_ACCESSIBLE_STATE_INVALID);
    }
    describe(field, problem);
}
