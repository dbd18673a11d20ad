/* The scenes that the net is made of. */
#ifndef NET_SCENES_H
#define NET_SCENES_H

#include <glib.h>

typedef struct {
    char *name; /* "bundled pendulum", "reference A01_free_fall", "random landing 03" */
    char *text; /* its file */
} NetScene;

/* All bundled scenes, all reference problems that have a scene, and 500 random ones, or those of them whose name
 * contains `only` (NULL: all). Tables lie in net_scenes_folder, so that is to be the current folder where a text is
 * read. (transfer full) */
GPtrArray *net_scenes_new(const char *only, GError **error);

/* The folder of the bundled scenes. (transfer full) */
char *net_scenes_folder(void);

#endif
