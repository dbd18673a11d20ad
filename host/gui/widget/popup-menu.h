/* Menus that come up where the pointer is, and go for good when they are closed. */
#ifndef TINKER_GUI_POPUP_MENU_H
#define TINKER_GUI_POPUP_MENU_H

#include <gtk/gtk.h>

/* Shows the menu over `parent` at a place in its coordinates. */
void tinker_popup_menu(GtkWidget *parent, GMenuModel *model, double x, double y);

#endif
