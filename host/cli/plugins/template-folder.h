/* Folders of files made from the templates that are compiled into the program (sdk/templates). */
#ifndef TINKER_CLI_TEMPLATE_FOLDER_H
#define TINKER_CLI_TEMPLATE_FOLDER_H

#include <glib.h>

/* What stands in for @name@, @title@, @role@ and @sentence@. Borrowed. */
typedef struct {
    const char *name, *title, *role, *sentence;
} TinkerTemplateWords;

/* A file to be written. */
typedef struct {
    char *path; /* relative to the folder, "scenes/a.tinker.json" */
    char *text;
} TinkerTemplateFile;

/* No files yet; of TinkerTemplateFile, which it frees. (transfer full) */
GPtrArray *tinker_template_files_new(void);

/* Adds all files of one template, "line-law", with the words put in. Scenes go below `scene_folder`; NULL: beside the
 * others. */
void tinker_template_files_add(GPtrArray *files, const char *template_name, const TinkerTemplateWords *words,
                               const char *scene_folder);

/* Makes the folder, which must not exist, and writes the files, by name. TINKER_CLI_ERROR_FILE where it cannot; nothing
 * is left behind then. */
gboolean tinker_template_files_write(GPtrArray *files, const char *folder, GError **error);

#endif
