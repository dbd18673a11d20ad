/* Opening: the catalogue as the program sets it up, and a scene from it. */
#ifndef TINKER_CLI_OPEN_SCENE_H
#define TINKER_CLI_OPEN_SCENE_H

#include "cli/command/options.h"
#include "common/program/file-set.h"
#include "plugin/catalogue/catalogue.h"
#include "scene/read/scene-json.h"

/* The catalogue, with the folders of --plugins (NULL: none) searched first; tells of those that are not there.
 * (transfer full) */
TinkerCatalogue *tinker_open_catalogue(char **plugin_folders);

/* A scene together with what it came from. */
typedef struct {
    TinkerCatalogue *catalogue;
    TinkerScene *scene;
    char *path;          /* as given */
    char *name;          /* as messages call it: the path, or "standard input" */
    GPtrArray *warnings; /* of char *: of the catalogue, of the reader, and of bodies that start in a plate */
    guint finding_count; /* of the reader */
    guint missing_types; /* of these: blocks that keep the scene from running */
} TinkerOpenScene;

/* Opens the scene at `path`; "-" is standard input. Reports what is wrong; answers the exit status, 0 where it is
 * open. */
int tinker_open_scene(TinkerOpenScene *open, char **plugin_folders, const char *path);

/* Reads the command line of a verb whose first operand is a scene, and opens that. TRUE: go on, `status` is 0. FALSE:
 * the help was printed or an error was reported; `status` is then the exit status. */
gboolean tinker_open_scene_of_line(TinkerOpenScene *open, TinkerCommandLine *line, const TinkerVerbHelp *help,
                                   const GOptionEntry *entries, int argc, char **argv, int *status);

/* Reports the warnings, for a verb that has none of its own. */
void tinker_open_scene_report_warnings(const TinkerOpenScene *open);

/* Reports the error that an open scene ended in, as tinker_report_error does. Where the scene itself is refused, its
 * warnings are reported as well, and a last line tells where `tinker check` has more to say. */
int tinker_open_scene_report_error(const TinkerOpenScene *open, const GError *error);

/* What a command with this scene reads: the scene, its tables, its plugins. (transfer full) */
TinkerFileSet *tinker_open_scene_files(const TinkerOpenScene *open);

void tinker_open_scene_clear(TinkerOpenScene *open);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerOpenScene, tinker_open_scene_clear)

/* "FILE:LINE:COLUMN: MESSAGE" of a finding; FILE alone where no place is known. (transfer full) */
char *tinker_finding_text(const TinkerFinding *finding, const char *name);

#endif
