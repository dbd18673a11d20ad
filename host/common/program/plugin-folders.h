/* Folders of plugins as they are named on a command line. */
#ifndef TINKER_HOST_PLUGIN_FOLDERS_H
#define TINKER_HOST_PLUGIN_FOLDERS_H

#include <glib.h>

/* The folders of --plugins as the catalogue takes them, absolute; NULL for NULL. What is no folder is left out, with a
 * warning on standard error; one without any library is warned of. (transfer full) */
char **tinker_plugin_folders(char **given);

/* What a folder has that was named where a library is expected: "check one of its libraries: DIR/a.so, DIR/b.so".
 * (transfer full) */
char *tinker_plugin_folder_hint(const char *folder);

#endif
