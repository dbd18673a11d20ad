/* Building a block class out of what a plugin declares. */
#ifndef TINKER_PLUGIN_CLASS_BUILD_H
#define TINKER_PLUGIN_CLASS_BUILD_H

#include "plugin/descriptor/block-class.h"

/* Checks a block type and copies it, with its properties, quantities and interfaces. `type` is a copy of the host's
 * size that lives as long as the arena, as does the class. NULL when refused; the message begins with the type's id. */
const TinkerBlockClass *tinker_block_class_build(TinkerBlockType *type, const TinkerPlugin *plugin, const char *path,
                                                 GPtrArray *arena, GError **error);

/* Checks every property of a class whose properties, quantities and type are in place. */
gboolean tinker_block_class_check_properties(const TinkerBlockClass *block_class, GError **error);

/* Copies and checks the interfaces of a class whose properties and quantities have passed. */
gboolean tinker_block_class_add_interfaces(TinkerBlockClass *block_class, GPtrArray *arena, GError **error);

/* The copy of "tinker.physics/1", with its roles; NULL when refused. */
const TinkerPhysics *tinker_physics_copy(const void *vtable, const TinkerBlockClass *block_class, GPtrArray *arena,
                                         GError **error);

#endif
