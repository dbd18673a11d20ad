/* Editing of blocks that bring no edit interface of their own: connectors by their ends, anything else as a spot around
 * its centre. They know no columns, so that the latter are selected but not moved. */
#include <math.h>

#include <tinker/shapes.h>

#include "edit/edit-private.h"

#define SPOT 0.8 /* of the symbol size: half the box that the host draws for such a block */

static int32_t hit_ends(const TinkerInstance *instance, double x, double y, double reach)
{
    int32_t part = tinker_ends_hit(instance, x, y, reach);
    for (int32_t k = 1; k < instance->ends && part == TINKER_PART_NONE; k++) {
        const TinkerEnd *a = &instance->end[k - 1], *b = &instance->end[k];
        if (tinker_segment_distance(x, y, a->x, a->y, b->x, b->y) <= reach) part = TINKER_PART_WHOLE;
    }
    return part;
}

static int32_t hit_spot(const TinkerInstance *instance, double x, double y, double reach)
{
    double room = SPOT * tinker_instance_symbol_size(instance) + reach;
    gboolean inside = fabs(x - instance->x) <= room && fabs(y - instance->y) <= room;
    return inside ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static void stay(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor) {}

const TinkerEdit *edit_of(const TinkerBlockClass *block_class)
{
    static const TinkerEdit of_connectors = {
        .struct_size = sizeof(TinkerEdit),
        .hit = hit_ends,
        .move = tinker_ends_move,
        .move_absolute = tinker_ends_move_absolute,
    };
    static const TinkerEdit of_others = {
        .struct_size = sizeof(TinkerEdit),
        .hit = hit_spot,
        .move = stay,
        .move_absolute = stay,
    };
    if (block_class != NULL && block_class->edit != NULL) return block_class->edit;
    return block_class != NULL && block_class->type->least_ends > 0 ? &of_connectors : &of_others;
}

const TinkerBlockClass *edit_owner(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->edit != NULL ? block_class : NULL;
}

int32_t edit_hit(const TinkerBlockClass *block_class, const TinkerInstance *instance, double x, double y, double reach)
{
    return TINKER_CALL_INSTANCE(edit_owner(block_class), "hit", instance,
                                edit_of(block_class)->hit(instance, x, y, reach));
}

int32_t edit_handles(const TinkerBlockClass *block_class, const TinkerInstance *instance, TinkerHandle *handles,
                     int32_t room)
{
    const TinkerEdit *edit = edit_of(block_class);
    if (edit->handles == NULL) return 0;
    int32_t count =
        TINKER_CALL_INSTANCE(edit_owner(block_class), "handles", instance, edit->handles(instance, handles, room));
    return CLAMP(count, 0, room);
}
