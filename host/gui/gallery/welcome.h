/* The welcome: what to do with an empty canvas, and examples to open. A card that lies over the canvas as long as there
 * is nothing on it; around the card the canvas gets everything. */
#ifndef TINKER_GUI_WELCOME_H
#define TINKER_GUI_WELCOME_H

#include <gtk/gtk.h>

#include "gui/document/player.h"

#define TINKER_TYPE_WELCOME (tinker_welcome_get_type())
G_DECLARE_FINAL_TYPE(TinkerWelcome, tinker_welcome, TINKER, WELCOME, GtkWidget)

/* Adds it to what lies over the canvas, the child of `overlay`. */
void tinker_welcome_add(GtkOverlay *overlay, TinkerDocument *document, TinkerPlayer *player);

#endif
