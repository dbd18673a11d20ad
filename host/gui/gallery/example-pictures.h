/* Pictures of examples, painted one at a time when there is nothing else to do. No more are painted once their owner is
 * gone, and all anew where the desktop goes dark. */
#ifndef TINKER_GUI_EXAMPLE_PICTURES_H
#define TINKER_GUI_EXAMPLE_PICTURES_H

#include <gtk/gtk.h>

#include "plugin/catalogue/catalogue.h"

#define TINKER_EXAMPLE_WIDTH  136 /* widget units of a picture */
#define TINKER_EXAMPLE_HEIGHT 96

typedef struct _TinkerExamplePictures TinkerExamplePictures;

/* The catalogue is borrowed. (transfer full) */
TinkerExamplePictures *tinker_example_pictures_new(TinkerCatalogue *catalogue);
void tinker_example_pictures_free(TinkerExamplePictures *pictures);

/* Wants a picture of the scene in that file in a GtkPicture. */
void tinker_example_pictures_add(TinkerExamplePictures *pictures, GtkWidget *picture, const char *path);

#endif
