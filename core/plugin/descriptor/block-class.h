/* What a plugin declared of a block type, checked and copied. */
#ifndef TINKER_PLUGIN_BLOCK_CLASS_H
#define TINKER_PLUGIN_BLOCK_CLASS_H

#include <glib.h>

#include <tinker/sdk.h>

/* A block type as the host uses it. Lives as long as the process: libraries are never closed. Interfaces that are not
 * offered are NULL; those that are have the host's size, with NULL for functions the plugin does not know. */
typedef struct {
    const TinkerBlockType *type; /* its id is a copy; its spans are the plugin's own: use the arrays below */
    const TinkerPlugin *plugin;
    const char *path; /* of the library */

    int32_t property_count;
    const TinkerPropertyType *properties;   /* copies of the host's size */
    const int32_t *first_columns;           /* of each property */
    int32_t column_count;                   /* of all properties */
    int32_t meanings[TINKER_MEANING_COUNT]; /* number of the property that carries the meaning, or -1 */

    int32_t quantity_count;
    const TinkerQuantityType *quantities;

    int32_t law_count; /* 0: its law is not stated */
    const TinkerLawEquation *law;

    const TinkerPhysics *physics;
    const TinkerRender *render;
    const TinkerEdit *edit;
    const TinkerUnits *units;
    const TinkerGraph *graph;
} TinkerBlockClass;

/* Number of the property or quantity with this id, or -1. */
int32_t tinker_block_class_property(const TinkerBlockClass *block_class, const char *id);
int32_t tinker_block_class_quantity(const TinkerBlockClass *block_class, const char *id);

/* Columns that a property of this kind takes: 0 to 3. */
int32_t tinker_kind_columns(int32_t kind);

/* First column of the property that carries this meaning, or -1. */
int32_t tinker_block_class_meaning_column(const TinkerBlockClass *block_class, int32_t meaning);

/* Whether its blocks are bodies that move by themselves, that turn as well, that do not move by themselves, as
 * supports. `block_class` may be NULL, of a type that nobody knows: it is none of these. */
gboolean tinker_block_class_moves(const TinkerBlockClass *block_class);
gboolean tinker_block_class_turns(const TinkerBlockClass *block_class);
gboolean tinker_block_class_stands(const TinkerBlockClass *block_class);

/* Whether ends of its blocks may be on those of a class, which may be NULL. */
gboolean tinker_block_class_accepts(const TinkerBlockClass *block_class, const TinkerBlockClass *target);

/* Whether its blocks are bodies that have an angle: those that turn, and those that do not move by themselves. */
gboolean tinker_block_class_has_angle(const TinkerBlockClass *block_class);

/* Whether its role asks for the angles of what its ends are on. */
gboolean tinker_block_class_speaks_of_angles(const TinkerBlockClass *block_class);

/* Whether the way between its two ends says nothing of it, but how these are turned against each other does: a joint
 * that holds them at one place, or torques between them. */
gboolean tinker_block_class_is_about_turning(const TinkerBlockClass *block_class);

/* Whether its length is wound on a body, as a cord's: it counts from how that is turned at the start, and is not the
 * distance between the ends. That is a constraint of one row and two ends with `angles`, a radius and a length. */
gboolean tinker_block_class_is_wound(const TinkerBlockClass *block_class);

/* Whether it gives its ends blows (the force element's next_blow): these may come from anywhere. */
gboolean tinker_block_class_strikes(const TinkerBlockClass *block_class);

/* Whether some property of the class is shown in the panel of what it is attached to, as those of a support's motion.
 */
gboolean tinker_block_class_is_shown_elsewhere(const TinkerBlockClass *block_class);

/* The unit in which a property or quantity is displayed: the block's own choice, else the one of its dimension. */
const char *tinker_block_class_unit(const TinkerBlockClass *block_class, const char *id, TinkerDimension dimension,
                                    int english);

/* The SI unit that files and tables have it in, "N m/rad": as the block chose it where that is one of SI, as a torque's
 * "N m", which an energy's "J" is the same dimension as; else that of its dimension. Interned. */
const char *tinker_block_class_si_unit(const TinkerBlockClass *block_class, const char *id, TinkerDimension dimension);

#endif
