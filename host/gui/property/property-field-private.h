/* What the files of a property's field share: its parts, what is wrong, and its control. */
#ifndef TINKER_GUI_PROPERTY_FIELD_PRIVATE_H
#define TINKER_GUI_PROPERTY_FIELD_PRIVATE_H

#include "gui/property/property-field.h"

struct _TinkerPropertyField {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPropertyRow *row;
    GtkWidget *title, *control, *detach, *problem;
    GtkWidget *hint;  /* NULL: there was none yet */
    GtkWidget *law;   /* of a typed law, as it is typeset; else NULL */
    gboolean dirty;   /* something was typed, and not taken yet */
    gboolean showing; /* changes of the control are ours */
};

/* Says what is wrong below the control; NULL: nothing is. property-problem.c. */
void property_field_set_problem(TinkerPropertyField *field, const char *problem);

/* The entry of a row with a text or a number; property-entry.c. */
GtkWidget *property_entry_new(TinkerPropertyField *field);
void property_entry_show(TinkerPropertyField *field);
/* Takes back what was typed. */
void property_entry_revert(TinkerPropertyField *field);
/* What the text of the entry would be as the law, or what is wrong with it, there marked from its place on; of no law
 * nothing. */
void property_entry_preview_law(TinkerPropertyField *field);

/* The control of a row of any kind; property-control.c. */
GtkWidget *property_control_new(TinkerPropertyField *field);
/* What takes an end away. */
GtkWidget *property_control_detach_new(TinkerPropertyField *field);
/* Shows what the row has. */
void property_control_show(TinkerPropertyField *field);

#endif
