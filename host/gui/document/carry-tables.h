/* Tables of a scene lie in its folder: they go along when it is saved into another one, and one that is chosen
 * elsewhere is copied. */
#ifndef TINKER_GUI_CARRY_TABLES_H
#define TINKER_GUI_CARRY_TABLES_H

#include "scene/store/scene.h"

/* Copies the tables that the scene names from the folder of the file `from` into that of `to`. What is there already
 * stays; where it is something else than the table, that is an error. */
gboolean carry_tables(TinkerScene *scene, const char *from, const char *to, GError **error);

/* How the scene of the file `scene` names a table: by its place in the scene's folder. NULL where the table lies
 * elsewhere. (transfer full) */
char *table_name_in_scene(const char *scene, const char *table);

/* The name that a copy of the table has beside the scene: its own, with a number where another file has that already.
 * (transfer full) */
char *table_name_of_copy(const char *scene, const char *table);

/* Copies a table beside the scene under that name, unless it is there already; `made` tells. Nothing is overwritten. */
gboolean table_copy_beside(const char *scene, const char *table, const char *name, gboolean *made, GError **error);

#endif
