/* The section "Start" of the panel on the right: how the selected block is to start, in the words of problem
 * statements. */
#ifndef TINKER_GUI_START_PANEL_H
#define TINKER_GUI_START_PANEL_H

#include <gtk/gtk.h>

#include "gui/document/player.h"

#define TINKER_TYPE_START_PANEL (tinker_start_panel_get_type())
G_DECLARE_FINAL_TYPE(TinkerStartPanel, tinker_start_panel, TINKER, START_PANEL, GtkWidget)

/* Takes references. Invisible where the selected block has nothing to offer. The signal "refused" (char *message) tells
 * why a condition without a value could not be met; those with a value say so beneath their row. The property "trims"
 * is as that of the panel of properties. */
GtkWidget *tinker_start_panel_new(TinkerDocument *document, TinkerPlayer *player);

#endif
