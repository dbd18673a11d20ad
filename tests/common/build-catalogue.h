/* The plugins of the build that a program lies in. */
#ifndef TEST_BUILD_CATALOGUE_H
#define TEST_BUILD_CATALOGUE_H

#include "plugin/catalogue/catalogue.h"

/* A catalogue of the plugins of TINKER_PLUGIN_PATH, else of the build tree: `build/tests/FOLDER/PROGRAM` finds
 * `build/plugins`. (transfer full) */
TinkerCatalogue *test_build_catalogue(void);

#endif
