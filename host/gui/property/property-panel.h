/* The panel with the properties of what is selected. */
#ifndef TINKER_GUI_PROPERTY_PANEL_H
#define TINKER_GUI_PROPERTY_PANEL_H

#include <gtk/gtk.h>

#include "gui/document/player.h"
#include "gui/mode/modes-task.h"

#define TINKER_TYPE_PROPERTY_PANEL (tinker_property_panel_get_type())
G_DECLARE_FINAL_TYPE(TinkerPropertyPanel, tinker_property_panel, TINKER, PROPERTY_PANEL, GtkWidget)

/* Takes references. The property "trims" (a switch): numbers have no zeros at the end of their decimals. */
GtkWidget *tinker_property_panel_new(TinkerDocument *document, TinkerPlayer *player);

/* Takes a reference to the task that tells which frequencies are near a resonance. */
void tinker_property_panel_set_modes(TinkerPropertyPanel *panel, TinkerModesTask *task);

/* Puts the keyboard focus on the first property. */
void tinker_property_panel_focus(TinkerPropertyPanel *panel);

/* Opens the group in which the law of impact is, where the scene's properties are shown, and puts the focus on it. */
void tinker_property_panel_focus_law_of_impact(TinkerPropertyPanel *panel);

#endif
