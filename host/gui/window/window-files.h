/* What the files of the window that open and save share. */
#ifndef TINKER_GUI_WINDOW_FILES_H
#define TINKER_GUI_WINDOW_FILES_H

#include "gui/window/window-parts.h"

#define WINDOW_SCENE_ENDING ".tinker.json"

/* `subject` may be NULL. */
typedef void (*WindowThen)(TinkerWindow *window, const char *subject);

/* Does it at once where there is nothing to save; else asks first, and does it when the user has saved or discarded. */
void window_ask_first(TinkerWindow *window, WindowThen then, const char *subject);

/* Scenes, and all files. */
void window_add_filters(GtkFileChooserNative *dialog);

/* Among the files that were used lately. */
void window_note_recent(const char *path);

#endif
