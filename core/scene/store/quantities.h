/* Quantities of a scene: those that a block's class declares, and those that every block, pair of blocks or scene has,
 * whatever its plugins declare.
 *
 * A quantity is known by its block and its number. Numbers up to the class's count are the class's own; a class that
 * declares a quantity of the same name goes before what is implied. A block with two ends has "length", "angle" and
 * "angle rate"; a body that can move "path length"; a block with a place "distance to OTHER". The scene, which is
 * called "Scene" where no block is, has energies and momenta; its block is TINKER_NO_BLOCK. */
#ifndef TINKER_CORE_QUANTITIES_H
#define TINKER_CORE_QUANTITIES_H

#include "scene/store/scene.h"

/* Numbers of what is implied. */
enum {
    TINKER_IMPLIED_LENGTH = 0x10000, /* m: distance between the two ends */
    /* rad: of the way from the first end to the second, from +x, in (-pi, pi]; of a class that is about turning, by
     * which what its second end is on is turned against what its first is on, counting turns */
    TINKER_IMPLIED_ANGLE,
    TINKER_IMPLIED_ANGLE_RATE,           /* rad/s */
    TINKER_IMPLIED_PATH_LENGTH,          /* m: of the way since the start of the run */
    TINKER_IMPLIED_DISTANCE = 0x1000000, /* m: between the centres; the other block's id is added to it */
};

/* What the title of a distance begins with; the other block's name follows. */
#define TINKER_DISTANCE_TITLE "Distance to "

/* Numbers of the scene's quantities. */
typedef enum {
    TINKER_SCENE_KINETIC,    /* J */
    TINKER_SCENE_POTENTIAL,  /* J: of fields, 0 at the origin */
    TINKER_SCENE_STORED,     /* J: in springs and the like */
    TINKER_SCENE_TOTAL,      /* J: the sum of these three */
    TINKER_SCENE_DAMPERS,    /* J: taken since the start by dampers, */
    TINKER_SCENE_FRICTION,   /* by friction */
    TINKER_SCENE_IMPACTS,    /* and by impacts; */
    TINKER_SCENE_DISSIPATED, /* the sum of these three */
    TINKER_SCENE_SUPPLIED,   /* J: given since the start by motors, fields without potential and moved supports */
    TINKER_SCENE_X_MOMENTUM, /* kg m/s */
    TINKER_SCENE_Y_MOMENTUM,
    TINKER_SCENE_QUANTITIES,
} TinkerSceneQuantity;

/* What "Scene" or a block's name stands for; TINKER_NO_BLOCK is the scene. FALSE where it is neither. */
gboolean tinker_scene_find_owner(const TinkerScene *scene, const char *name, TinkerBlockId *block);
const char *tinker_scene_owner_name(const TinkerScene *scene, TinkerBlockId block);

/* What stands behind the block's name, or the scene's, and a dot: "x" of "Mass 0.x". The name is the longest that there
 * is. NULL where the text begins with none. */
const char *tinker_scene_split_name(const TinkerScene *scene, const char *text, TinkerBlockId *block);

/* The number of a quantity; -1 where there is none of this name. */
int32_t tinker_scene_find_quantity(const TinkerScene *scene, TinkerBlockId block, const char *id);

/* What is known of the quantity of this number, which there is. Its texts are the class's, static or interned. */
TinkerQuantityType tinker_scene_quantity_type(const TinkerScene *scene, TinkerBlockId block, int32_t number);

/* What every block of a class can show, of TinkerQuantityType: the class's own, then what is implied, the last of which
 * is "distance to BLOCK". (transfer full) */
GArray *tinker_class_quantities(const TinkerBlockClass *block_class);

/* The names of all quantities of a block, or of the scene, likewise. (transfer full) */
GStrv tinker_scene_quantity_names(const TinkerScene *scene, TinkerBlockId block);

/* The block that a quantity is of besides its own: the other of a distance; TINKER_NO_BLOCK. */
static inline TinkerBlockId tinker_quantity_other(int32_t number)
{
    return number >= TINKER_IMPLIED_DISTANCE ? number - TINKER_IMPLIED_DISTANCE : TINKER_NO_BLOCK;
}

/* The name of the distance to a block of this name, "distance to Mass 1". (transfer full) */
char *tinker_quantity_distance_to(const char *other);

/* The name of the other block in the name of a distance, "distance to Mass 1"; NULL where it is none. */
const char *tinker_quantity_other_name(const char *id);

/* The quantity's name once the block called `from` is called `to`; NULL where it does not change. (transfer full) */
char *tinker_quantity_renamed(const char *id, const char *from, const char *to);

#endif
