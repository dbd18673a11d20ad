/* Where the installation lies, in a prefix or in a build tree: plugins, bundled scenes, the other programs. */
#ifndef TINKER_HOST_INSTALLATION_H
#define TINKER_HOST_INSTALLATION_H

#include "plugin/catalogue/catalogue.h"

/* The catalogue: folders of --plugins (absolute; NULL: none), TINKER_PLUGIN_PATH, the user's and the installed one. In
 * a build tree that is not installed, the installed folder is the tree's own. Libraries without a manifest are probed
 * by the program without a window. (transfer full) */
TinkerCatalogue *tinker_installation_catalogue(const char *const *plugin_folders);

/* The folder of the bundled scenes, and the path of one of them, "spring-mass.tinker.json". (transfer full) */
char *tinker_installation_scene_folder(void);
char *tinker_installation_scene(const char *name);

/* The folder of the documentation, whose README.md lists its pages. (transfer full) */
char *tinker_installation_document_folder(void);

/* The folder of the translations. (transfer full) */
char *tinker_installation_locale_folder(void);

#endif
