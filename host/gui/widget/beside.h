/* Two widgets side by side, the first with the room that the second leaves; one below the other where that would be too
 * little for the first, a text that wraps. */
#ifndef TINKER_GUI_BESIDE_H
#define TINKER_GUI_BESIDE_H

#include <gtk/gtk.h>

#define TINKER_TYPE_BESIDE (tinker_beside_get_type())
G_DECLARE_FINAL_TYPE(TinkerBeside, tinker_beside, TINKER, BESIDE, GtkWidget)

GtkWidget *tinker_beside_new(GtkWidget *first, GtkWidget *second);

#define TINKER_BESIDE_LEAST 380 /* px: what it is at first */

/* How wide (px) the first one is to be beside the second at least, unless it wants less. */
void tinker_beside_set_least(TinkerBeside *beside, int least);

/* Lets the text of a button wrap where all of its place is too narrow for it, and nowhere else. Once the button has its
 * text. */
void tinker_beside_wrap(GtkWidget *button);

#endif
