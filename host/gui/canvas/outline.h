/* The outline: the scene as a list of its blocks. What is selected in it is selected in the document, and the other way
 * round. */
#ifndef TINKER_GUI_OUTLINE_H
#define TINKER_GUI_OUTLINE_H

#include <gtk/gtk.h>

#include "gui/document/document.h"

#define TINKER_TYPE_OUTLINE (tinker_outline_get_type())
G_DECLARE_FINAL_TYPE(TinkerOutline, tinker_outline, TINKER, OUTLINE, GtkWidget)

/* Takes a reference. The signal "activated" tells that the properties of what is selected are asked for; "menu" (double
 * x, y), that a menu is, at a place of the outline. */
GtkWidget *tinker_outline_new(TinkerDocument *document);

#endif
