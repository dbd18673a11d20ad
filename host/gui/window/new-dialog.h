/* The dialog before a new scene: units, and how wide the canvas is.
 *
 * The signal "create" (const TinkerNewScene *) tells the settings; the dialog has closed itself then. */
#ifndef TINKER_GUI_NEW_DIALOG_H
#define TINKER_GUI_NEW_DIALOG_H

#include <adwaita.h>

#define TINKER_TYPE_NEW_DIALOG (tinker_new_dialog_get_type())
G_DECLARE_FINAL_TYPE(TinkerNewDialog, tinker_new_dialog, TINKER, NEW_DIALOG, AdwWindow)

/* (transfer none: GTK keeps it as long as it is open) */
GtkWidget *tinker_new_dialog_new(GtkWindow *parent);

#endif
