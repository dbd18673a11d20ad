/* Tables of a scene lie in its folder; they go along when it is saved into another one. */
#ifndef TINKER_GUI_CARRY_TABLES_H
#define TINKER_GUI_CARRY_TABLES_H

#include "scene/scene.h"

/* Copies the tables that the scene names from the folder of the file `from` into that of `to`. What is there already stays;
 * where it is something else than the table, that is an error. */
gboolean carry_tables(TinkerScene *scene, const char *from, const char *to, GError **error);

#endif
