/* Dialogs that ask for the name of a file to be written. */
#ifndef TINKER_GUI_SAVE_DIALOG_H
#define TINKER_GUI_SAVE_DIALOG_H

#include <gtk/gtk.h>

/* Suggests a file's name, in which what no name may hold is replaced, with this ending. (transfer full) */
GtkFileChooserNative *tinker_save_dialog_new(GtkWindow *window, const char *title, const char *suggestion,
                                             const char *ending);
void tinker_save_dialog_add_filter(GtkFileChooserNative *dialog, const char *name, const char *ending);
/* What was chosen; NULL where that is not a file of this machine. (transfer full) */
char *tinker_save_dialog_path(GtkNativeDialog *dialog);

/* One for a picture: .png, .svg or .pdf; and what was chosen, with the ending that the filter stands for where it has
 * none of these. (transfer full) */
GtkFileChooserNative *tinker_picture_dialog_new(GtkWindow *window, const char *title, const char *suggestion);
char *tinker_picture_dialog_path(GtkNativeDialog *dialog);

/* Whether the file's name ends like that, in whatever case, and is more. */
gboolean tinker_has_ending(const char *path, const char *ending);

#endif
