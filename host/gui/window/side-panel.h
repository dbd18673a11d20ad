/* The panel at the right: what the scene is about, the properties of what is selected or how it starts, and below them
 * the outline of the scene. */
#ifndef TINKER_GUI_SIDE_PANEL_H
#define TINKER_GUI_SIDE_PANEL_H

#include <gtk/gtk.h>

#include "gui/document/player.h"

/* `start` is the widget that says how things start, `card` the one that says what the scene is about, which is shown
 * when a scene with a description is opened, `equations` the one with the model. (transfer floating) */
GtkWidget *tinker_side_panel_new(TinkerDocument *document, TinkerPlayer *player, GtkWidget *start, GtkWidget *card,
                                 GtkWidget *equations);

/* Shows one of its pages, "scene", "properties", "start" or "equations"; FALSE where there is no such page. */
gboolean tinker_side_panel_show(GtkWidget *side_panel, const char *page);

/* The panel of properties and the outline in it. (transfer none) */
GtkWidget *tinker_side_panel_properties(GtkWidget *side_panel);
GtkWidget *tinker_side_panel_outline(GtkWidget *side_panel);

#endif
