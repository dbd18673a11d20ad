/* The panel at the right: the properties of what is selected or how it starts, and below them the outline of the scene. */
#ifndef TINKER_GUI_SIDE_PANEL_H
#define TINKER_GUI_SIDE_PANEL_H

#include <gtk/gtk.h>

#include "player.h"

/* `start` is the widget that says how things start. (transfer floating) */
GtkWidget *tinker_side_panel_new(TinkerDocument *document, TinkerPlayer *player, GtkWidget *start);

/* Shows one of its pages, "properties" or "start"; FALSE where there is no such page. */
gboolean tinker_side_panel_show(GtkWidget *side_panel, const char *page);

#endif
