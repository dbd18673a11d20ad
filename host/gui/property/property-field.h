/* One row of the property panel: its title, what it is edited with, and beneath it why an entry is wrong. */
#ifndef TINKER_GUI_PROPERTY_FIELD_H
#define TINKER_GUI_PROPERTY_FIELD_H

#include <gtk/gtk.h>

#include "gui/property/property-list.h"

#define TINKER_TYPE_PROPERTY_FIELD (tinker_property_field_get_type())
G_DECLARE_FINAL_TYPE(TinkerPropertyField, tinker_property_field, TINKER, PROPERTY_FIELD, GtkWidget)

/* For rows of the kind of this one; shows it. Takes references. */
GtkWidget *tinker_property_field_new(TinkerDocument *document, TinkerPropertyRow *row);

/* Shows a row of the same kind. What has been typed, and not been taken yet, stays as long as the row is of the same
 * thing. */
void tinker_property_field_show(TinkerPropertyField *field, TinkerPropertyRow *row);

/* Forgets what was typed and not taken: it belongs to a scene that is gone. */
void tinker_property_field_discard(TinkerPropertyField *field);

#endif
