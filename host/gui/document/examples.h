/* The scenes that come with the program, and with bundles of plugins, by topic. No widget. */
#ifndef TINKER_GUI_EXAMPLES_H
#define TINKER_GUI_EXAMPLES_H

#include "plugin/catalogue/catalogue.h"

typedef struct {
    char *path;
    char *title;
    char *description;
} TinkerExample;

typedef struct {
    char *title;
    GPtrArray *examples; /* of TinkerExample * */
} TinkerTopic;

/* As the README of a folder of scenes groups them, with those that it does not name in a topic of their own at the end;
 * of TinkerTopic *, which it frees. Scenes that cannot be read are left out. (transfer full) */
GPtrArray *tinker_examples_read(const char *folder);

/* Adds a topic for each bundle (of TinkerBundleEntry) that has scenes, under its title. */
void tinker_examples_add_bundles(GPtrArray *topics, const GPtrArray *bundles);

/* Those of the installation and of the bundles that the catalogue found, read once. Borrowed. */
GPtrArray *tinker_examples(TinkerCatalogue *catalogue);

#endif
