/* What lies under a point. Blocks are asked from the top of the picture to its bottom, first for parts that can be
 * gripped, then for whole blocks. A block without an edit interface is hit as the host draws it. */
#include <math.h>

#include <tinker/shapes.h>

#include "edit/edit-private.h"
#include "scene/frame/drawing-order.h"

#define MOST_UNDER 16   /* bodies under a point that are looked at */
#define AT_END     1e-6 /* of the length of a body: as far off is still at the end of it */

static gboolean is_placed(const TinkerInstance *instance)
{
    return isfinite(instance->x) && isfinite(instance->y);
}

TinkerHit tinker_hit(TinkerFrame *frame, double x, double y, double reach)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    TinkerHit whole = {TINKER_NO_BLOCK, TINKER_PART_NONE};
    if (!isfinite(x) || !isfinite(y)) return whole;
    for (int32_t layer = TINKER_LAYERS - 1; layer >= 0; layer--)
        for (int32_t place = tinker_scene_block_count(scene) - 1; place >= 0; place--) {
            TinkerBlockId block = tinker_scene_block_at(scene, place);
            const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
            if (tinker_frame_layer(frame, block) != layer) continue;
            TinkerInstance instance;
            gboolean known = tinker_frame_instance(frame, block, &instance);
            if (!is_placed(&instance)) continue;
            int32_t part = edit_hit(known ? block_class : NULL, &instance, x, y, reach);
            if (part == TINKER_PART_NONE) continue;
            if (part != TINKER_PART_WHOLE) return (TinkerHit){block, part};
            if (whole.block == TINKER_NO_BLOCK) whole = (TinkerHit){block, part};
        }
    return whole;
}

/* Whether this is a handle that gives a block another size: of a body one that neither turns it nor moves its local
 * origin. */
static gboolean sizes(TinkerHit hit)
{
    return hit.block != TINKER_NO_BLOCK && hit.part >= TINKER_PART_HANDLE && hit.part < TINKER_PART_POINT &&
           hit.part != TINKER_HANDLE_ROTATION && hit.part != TINKER_HANDLE_LOCAL_ORIGIN;
}

/* Whether one of the handles is at this place of the block's own. */
static gboolean has_handle_at(const TinkerHandle *handles, int32_t count, const TinkerFrame *frame, TinkerBlockId block,
                              double x, double size, int32_t *part)
{
    for (int32_t i = 0; i < count; i++) {
        double own[2];
        tinker_frame_to_own(frame, block, (const double[]){handles[i].x, handles[i].y}, own);
        *part = handles[i].part;
        if (hypot(own[0] - x, own[1]) <= AT_END * size) return TRUE;
    }
    return FALSE;
}

gboolean edit_is_handle_of_end(TinkerFrame *frame, TinkerHit hit)
{
    TinkerInstance instance;
    TinkerHandle handles[MOST_HANDLES];
    int32_t start, end;
    if (!sizes(hit) || !edit_has_ends(frame, hit.block) || !tinker_frame_instance(frame, hit.block, &instance))
        return FALSE;
    const double width = tinker_frame_meaning(frame, hit.block, TINKER_MEANING_WIDTH, 0, 0);
    const int32_t count =
        edit_handles(tinker_scene_block_class(tinker_frame_scene(frame), hit.block), &instance, handles, MOST_HANDLES);
    return has_handle_at(handles, count, frame, hit.block, -width / 2, width, &start) &&
           has_handle_at(handles, count, frame, hit.block, width / 2, width, &end) &&
           (hit.part == start || hit.part == end);
}

int32_t edit_hit_connectables(TinkerFrame *frame, TinkerBlockId connector, double x, double y, double reach,
                              TinkerBlockId *blocks, int32_t room)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const TinkerBlockClass *connector_class = tinker_scene_block_class(scene, connector);
    int32_t count = 0;
    if (connector_class == NULL || !isfinite(x) || !isfinite(y)) return 0;
    for (int32_t layer = TINKER_LAYERS - 1; layer >= 0; layer--)
        for (int32_t place = tinker_scene_block_count(scene) - 1; place >= 0 && count < room; place--) {
            TinkerBlockId block = tinker_scene_block_at(scene, place);
            const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
            if (block == connector || tinker_frame_layer(frame, block) != layer) continue;
            if (!tinker_block_class_accepts(connector_class, block_class)) continue;
            TinkerInstance instance;
            if (!tinker_frame_instance(frame, block, &instance) || !is_placed(&instance)) continue;
            if (edit_hit(block_class, &instance, x, y, reach) != TINKER_PART_NONE) blocks[count++] = block;
        }
    return count;
}

TinkerBlockId tinker_hit_connectable(TinkerFrame *frame, TinkerBlockId connector, double x, double y, double reach)
{
    TinkerBlockId block;
    return edit_hit_connectables(frame, connector, x, y, reach, &block, 1) > 0 ? block : TINKER_NO_BLOCK;
}

/* Whether all ends are attached, and whether they lie within so much of the first one. */
static gboolean all_attached(const TinkerInstance *instance, double within)
{
    for (int32_t k = 0; k < instance->ends; k++) {
        const TinkerEnd *a = &instance->end[0], *b = &instance->end[k];
        if (!b->attached || !(hypot(b->x - a->x, b->y - a->y) <= within)) return FALSE;
    }
    return instance->ends > 0;
}

gboolean tinker_is_at_one_place(TinkerFrame *frame, TinkerBlockId connector)
{
    TinkerInstance instance;
    return tinker_frame_instance(frame, connector, &instance) && instance.ends > 1 &&
           all_attached(&instance, tinker_instance_symbol_size(&instance));
}

static gboolean is_on(TinkerScene *scene, TinkerBlockId connector, TinkerBlockId body)
{
    for (int32_t k = 0; k < tinker_scene_end_count(scene, connector); k++)
        if (tinker_scene_end(scene, connector, k).block == body) return TRUE;
    return FALSE;
}

/* The topmost body under the point that can move, of those that the connector is on before any other. */
static TinkerBlockId body_beneath(TinkerFrame *frame, TinkerBlockId connector, double x, double y, double reach)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    TinkerBlockId under[MOST_UNDER], first = TINKER_NO_BLOCK;
    const int32_t count = edit_hit_connectables(frame, connector, x, y, reach, under, MOST_UNDER);
    for (int32_t i = 0; i < count; i++) {
        if (!tinker_block_class_moves(tinker_scene_block_class(scene, under[i]))) continue;
        if (is_on(scene, connector, under[i])) return under[i];
        if (first == TINKER_NO_BLOCK) first = under[i];
    }
    return first;
}

static TinkerBlockId first_of_ends(TinkerScene *scene, TinkerBlockId connector)
{
    for (int32_t k = 0; k < tinker_scene_end_count(scene, connector); k++) {
        const TinkerBlockId on = tinker_scene_end(scene, connector, k).block;
        if (on != TINKER_NO_BLOCK && tinker_block_class_moves(tinker_scene_block_class(scene, on))) return on;
    }
    return TINKER_NO_BLOCK;
}

TinkerHit tinker_hit_to_drag(TinkerFrame *frame, TinkerHit hit, double x, double y, double reach)
{
    TinkerInstance instance;
    if (edit_is_handle_of_end(frame, hit) && edit_is_jointed(tinker_frame_scene(frame), hit.block))
        return (TinkerHit){hit.block, TINKER_PART_WHOLE};
    if (hit.block == TINKER_NO_BLOCK || hit.part != TINKER_PART_WHOLE ||
        !tinker_frame_instance(frame, hit.block, &instance) || !all_attached(&instance, INFINITY))
        return hit;
    const gboolean at_one_place = tinker_is_at_one_place(frame, hit.block);
    TinkerBlockId body = body_beneath(frame, hit.block, x, y, reach);
    if (body == TINKER_NO_BLOCK && at_one_place) body = first_of_ends(tinker_frame_scene(frame), hit.block);
    return body != TINKER_NO_BLOCK ? (TinkerHit){body, TINKER_PART_WHOLE} : hit;
}

TinkerHit tinker_hit_handle(TinkerFrame *frame, TinkerBlockId block, double x, double y, double reach)
{
    TinkerHit hit = {TINKER_NO_BLOCK, TINKER_PART_NONE};
    TinkerInstance instance;
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    if (!tinker_frame_instance(frame, block, &instance) || !is_placed(&instance)) return hit;
    TinkerHandle handles[MOST_HANDLES];
    int32_t count = edit_handles(block_class, &instance, handles, MOST_HANDLES);
    double nearest = reach;
    for (int32_t i = 0; i < count; i++) {
        double distance = hypot(handles[i].x - x, handles[i].y - y);
        if (distance > nearest) continue;
        nearest = distance;
        hit = (TinkerHit){block, handles[i].part};
    }
    return hit;
}
