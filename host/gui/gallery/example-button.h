/* A button for an example: its picture and title. What it does is for who asks for it. */
#ifndef TINKER_GUI_EXAMPLE_BUTTON_H
#define TINKER_GUI_EXAMPLE_BUTTON_H

#include "gui/document/examples.h"
#include "gui/gallery/example-pictures.h"

/* (transfer floating) */
GtkWidget *tinker_example_button_new(const TinkerExample *example, TinkerExamplePictures *pictures);
/* With its picture half as large, where there is little room; or as large as it is at first. */
void tinker_example_button_set_small(GtkWidget *button, gboolean small);

#endif
