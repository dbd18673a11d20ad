/* The architecture as a table: which folders and rooms there are, and what each may include. */
#ifndef TEST_LAYERS_TABLE_H
#define TEST_LAYERS_TABLE_H

#include <glib.h>

/* A folder, and what its files may include: folders of core and of the hosts, and libraries by the beginning of the
 * header's name. */
typedef struct {
    const char *folder;
    const char *core[16];
    const char *libraries[12];
} Layer;

/* The rooms of a folder, in order: each uses those before it. What other folders see of them is their face. */
typedef struct {
    const char *folder;
    const char *rooms[20];
    const char *face[28];
} Rooms;

/* Each ends with an entry without a folder. */
extern const Layer layers[];
extern const Rooms folders_with_rooms[];

#endif
