/* How large what is drawn by hand is to be written: as large as the texts of the desktop's own widgets. */
#ifndef TINKER_GUI_ENLARGEMENT_H
#define TINKER_GUI_ENLARGEMENT_H

#include <gtk/gtk.h>

/* How much larger the widget's font is than the desktop's, as on a projector; 1 at least. */
double tinker_enlargement(GtkWidget *widget);

#endif
