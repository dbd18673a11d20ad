/* The documentation in a window of its own, as it is installed: without a network, and without another program. */
#ifndef TINKER_GUI_HELP_WINDOW_H
#define TINKER_GUI_HELP_WINDOW_H

#include <adwaita.h>

#define TINKER_TYPE_HELP_WINDOW (tinker_help_window_get_type())
G_DECLARE_FINAL_TYPE(TinkerHelpWindow, tinker_help_window, TINKER, HELP_WINDOW, AdwWindow)

/* Shows the list of all pages in the help window of this one, which is made where there is none. */
void tinker_help_show(GtkWindow *window);

#endif
