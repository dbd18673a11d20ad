/* The dialog before a film: what it is to be, and what that comes to.
 *
 * The signal "chosen" (const TinkerFilmSettings *) tells the settings; their path is the ending alone, ".gif" and so
 * on. The dialog has closed itself then. */
#ifndef TINKER_GUI_FILM_DIALOG_H
#define TINKER_GUI_FILM_DIALOG_H

#include <adwaita.h>

#include "gui/film/film-task.h"

#define TINKER_TYPE_FILM_DIALOG (tinker_film_dialog_get_type())
G_DECLARE_FINAL_TYPE(TinkerFilmDialog, tinker_film_dialog, TINKER, FILM_DIALOG, AdwWindow)

/* A kind of file that films can be: its name for people, marked for translation, and its ending. */
typedef struct {
    const char *name, *ending;
} TinkerFilmFormat;

/* Those that are possible here, ended by one without a name. */
const TinkerFilmFormat *tinker_film_formats(void);

/* For a run of so many seconds. (transfer none: GTK keeps it as long as it is open) */
GtkWidget *tinker_film_dialog_new(GtkWindow *parent, double duration);

#endif
