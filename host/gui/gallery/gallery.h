/* The gallery: all examples as pictures, grouped by what they are about, and searched by words of their titles and
 * descriptions. */
#ifndef TINKER_GUI_GALLERY_H
#define TINKER_GUI_GALLERY_H

#include <gtk/gtk.h>

#include "plugin/catalogue/catalogue.h"

/* Shows it over this window, whose action win.open-example opens what is chosen. */
void tinker_gallery_show(GtkWindow *window, TinkerCatalogue *catalogue);

#endif
