/* The window: one document, with everything to look at it, edit it and run it. */
#ifndef TINKER_GUI_WINDOW_H
#define TINKER_GUI_WINDOW_H

#include <adwaita.h>

#include "plugin/catalogue/catalogue.h"

#define TINKER_TYPE_WINDOW (tinker_window_get_type())
G_DECLARE_FINAL_TYPE(TinkerWindow, tinker_window, TINKER, WINDOW, AdwApplicationWindow)

/* With an empty scene of the blocks in this catalogue, which outlives it. (transfer none: the application keeps it) */
TinkerWindow *tinker_window_new(AdwApplication *application, TinkerCatalogue *catalogue);

/* Whether nothing has been done in it, so that a file may be opened here. */
gboolean tinker_window_is_untouched(TinkerWindow *window);

/* Opens a file; of one without a local path it says what to do. */
void tinker_window_open_file(TinkerWindow *window, GFile *file);

/* The dialog that begins a new scene in it. */
void tinker_window_new_scene(TinkerWindow *window);

/* The keys of all actions. */
void tinker_window_set_accels(GtkApplication *application);

#endif
