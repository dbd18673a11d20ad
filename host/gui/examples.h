/* The bundled scenes, by topic. No widget. */
#ifndef TINKER_GUI_EXAMPLES_H
#define TINKER_GUI_EXAMPLES_H

#include <glib.h>

typedef struct {
    char *path;
    char *title;
    char *description;
} TinkerExample;

typedef struct {
    char *title;
    GPtrArray *examples; /* of TinkerExample * */
} TinkerTopic;

/* As the README of a folder of scenes groups them, with those that it does not name in a topic of their own at the end; of
 * TinkerTopic *, which it frees. Scenes that cannot be read are left out. (transfer full) */
GPtrArray *tinker_examples_read(const char *folder);

/* Those of the installation, read once. Borrowed. */
GPtrArray *tinker_examples(void);

#endif
