/* The theme of drawings that goes with the desktop's style: light or dark, ordinary or of high contrast. */
#ifndef TINKER_GUI_DESKTOP_THEME_H
#define TINKER_GUI_DESKTOP_THEME_H

#include <gtk/gtk.h>

#include "render/draw/theme.h"

/* As the desktop is now. Borrowed. */
const TinkerTheme *tinker_desktop_theme(void);

/* Has the widget drawn again, at least, when that changes. */
void tinker_desktop_theme_redraws(GtkWidget *widget);

#endif
