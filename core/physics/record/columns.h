/* Columns of a record: quantities of blocks. */
#ifndef TINKER_CORE_COLUMNS_H
#define TINKER_CORE_COLUMNS_H

#include "scene/store/quantities.h"

typedef struct {
    TinkerBlockId block; /* TINKER_NO_BLOCK: of the scene */
    int32_t quantity;    /* its number, see quantities.h */
    char *name;          /* "Mass 0.x"; owned */
    const char *title;   /* of the quantity, "Y Position" */
    TinkerDimension dimension;
    const char *unit; /* SI symbol, "m/s" */
} TinkerColumn;

/* An array of TinkerColumn that frees their names. (transfer full) */
GArray *tinker_columns_new(void);

/* The default columns: the quantities that are marked as recorded, those of connectable blocks first, then the others',
 * each in scene order. (transfer full) */
GArray *tinker_columns_default(TinkerScene *scene);

/* Adds a quantity of a block or of the scene, by its number. */
void tinker_columns_add_quantity(GArray *columns, TinkerScene *scene, TinkerBlockId block, int32_t quantity);

/* Adds the column called "BLOCK.QUANTITY"; the quantity begins behind the last dot that has a block's
 * name, or "Scene", before it. Errors (TINKER_SCENE_ERROR_NAME)
 * name the nearest block, or the quantities that the block has; TINKER_SCENE_ERROR_TYPE says why the block's type is
 * missing. */
gboolean tinker_columns_add(GArray *columns, TinkerScene *scene, const char *name, GError **error);

/* Of each column whether its values start again after 2 pi, as those of an angle. (transfer full) */
gboolean *tinker_columns_turn(const GArray *columns);

/* Of each column whether it tells places: a length or an angle, which no impact changes at once. (transfer full) */
gboolean *tinker_columns_place(const GArray *columns);

/* Adds the columns of a comma-separated list. A name with a comma in it is found as well. */
gboolean tinker_columns_add_list(GArray *columns, TinkerScene *scene, const char *list, GError **error);

#endif
