/* gap = n . (centre - top) - height / 2, with n the normal of the plate's solid side. Measured from the top, the plate
 * reaches from -(its height) to 0 and the body from gap to gap + (its height).
 *
 * Bodies are sorted along the axis that they are spread out on more; of each plate only those are looked at that lie
 * within the sides of its box there. */
#include "scene/frame/overlaps.h"

#include <math.h>

#include <tinker/physics.h>

typedef struct {
    TinkerBlockId block;
    double place[2], angle, width, height;
} Box;

static int32_t shape_of(const TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    const TinkerPhysics *physics = block_class == NULL ? NULL : block_class->physics;
    if (physics == NULL || physics->body == NULL || physics->body->degrees_of_freedom == 3) return TINKER_SHAPE_NONE;
    return physics->body->shape;
}

/* All blocks of a shape; of plates those alone that are solid and have a top. */
static GArray *boxes_of(const TinkerFrame *frame, int32_t shape)
{
    GArray *boxes = g_array_new(FALSE, FALSE, sizeof(Box));
    for (TinkerBlockId id = 0; id < tinker_scene_id_limit(tinker_frame_scene(frame)); id++) {
        if (!tinker_scene_has_block(tinker_frame_scene(frame), id) || shape_of(frame, id) != shape) continue;
        if (shape == TINKER_SHAPE_PLATE && tinker_frame_meaning(frame, id, TINKER_MEANING_SOLID, 0, 1) == 0) continue;
        Box box = {.block = id,
                   .width = tinker_frame_meaning(frame, id, TINKER_MEANING_WIDTH, 0, 0),
                   .height = tinker_frame_meaning(frame, id, TINKER_MEANING_HEIGHT, 0, 0)};
        tinker_frame_centre(frame, id, &box.place[0], &box.place[1], &box.angle);
        if (shape == TINKER_SHAPE_PLATE && !(box.width > 0)) continue;
        g_array_append_val(boxes, box);
    }
    return boxes;
}

/* 0: x, 1: y. */
static int longer_axis(const GArray *bodies)
{
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (guint i = 0; i < bodies->len; i++) {
        const double *place = g_array_index(bodies, Box, i).place;
        for (int k = 0; k < 2; k++) {
            least[k] = fmin(least[k], place[k]);
            most[k] = fmax(most[k], place[k]);
        }
    }
    return most[1] - least[1] > most[0] - least[0] ? 1 : 0;
}

static int compare_places(gconstpointer a, gconstpointer b, gpointer axis)
{
    const double first = ((const Box *)a)->place[*(int *)axis], second = ((const Box *)b)->place[*(int *)axis];
    return first < second ? -1 : first > second;
}

static int compare_pairs(gconstpointer a, gconstpointer b)
{
    const TinkerOverlap *first = a, *second = b;
    if (first->plate != second->plate) return first->plate < second->plate ? -1 : 1;
    return first->body < second->body ? -1 : first->body > second->body;
}

/* The first body whose centre does not lie before a place on the axis. */
static guint first_from(const GArray *bodies, int axis, double place)
{
    guint low = 0, high = bodies->len;
    while (low < high) {
        guint middle = low + (high - low) / 2;
        if (g_array_index(bodies, Box, middle).place[axis] < place)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Half the extent along an axis of where the centre of a body of that height may lie. */
static double reach_of(const Box *plate, int axis, double tallest)
{
    const double c = fabs(cos(plate->angle)), s = fabs(sin(plate->angle));
    const double across = 0.5 * plate->height + 0.5 * tallest;
    return axis == 0 ? c * 0.5 * plate->width + s * across : s * 0.5 * plate->width + c * across;
}

static void look(const Box *plate, const Box *body, GArray *overlaps)
{
    const double normal[2] = {-sin(plate->angle), cos(plate->angle)};
    const double dx = body->place[0] - plate->place[0], dy = body->place[1] - plate->place[1];
    const double along = normal[1] * dx - normal[0] * dy;
    const double gap = normal[0] * dx + normal[1] * dy - 0.5 * plate->height - 0.5 * body->height;
    const double above_underside = gap + body->height + plate->height;
    if (fabs(along) > 0.5 * plate->width || !(gap < -TINKER_TOUCHING && above_underside > TINKER_TOUCHING)) return;
    TinkerOverlap overlap = {body->block, plate->block, -gap, {normal[0], normal[1]}};
    g_array_append_val(overlaps, overlap);
}

GArray *tinker_overlaps_new(const TinkerFrame *frame)
{
    GArray *overlaps = g_array_new(FALSE, FALSE, sizeof(TinkerOverlap));
    g_autoptr(GArray) plates = boxes_of(frame, TINKER_SHAPE_PLATE);
    if (plates->len == 0) return overlaps;
    g_autoptr(GArray) bodies = boxes_of(frame, TINKER_SHAPE_BOX);
    double tallest = 0;
    for (guint i = 0; i < bodies->len; i++)
        tallest = fmax(tallest, g_array_index(bodies, Box, i).height);
    int axis = longer_axis(bodies);
    g_array_sort_with_data(bodies, compare_places, &axis);
    for (guint k = 0; k < plates->len; k++) {
        const Box *plate = &g_array_index(plates, Box, k);
        const double reach = reach_of(plate, axis, tallest);
        for (guint i = first_from(bodies, axis, plate->place[axis] - reach); i < bodies->len; i++) {
            const Box *body = &g_array_index(bodies, Box, i);
            if (body->place[axis] > plate->place[axis] + reach) break;
            look(plate, body, overlaps);
        }
    }
    g_array_sort(overlaps, compare_pairs);
    return overlaps;
}

/* What a cosine of 90 degrees leaves of a distance is no distance; adding 0 makes 0 of -0. */
static double shown(double distance)
{
    return round(distance / TINKER_TOUCHING) * TINKER_TOUCHING + 0.0;
}

static char *text_of(const TinkerFrame *frame, const TinkerOverlap *overlap)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const char *body = tinker_scene_block_name(scene, overlap->body);
    const char *plate = tinker_scene_block_name(scene, overlap->plate);
    return g_strdup_printf(
        "%s starts %.6g m below the top of %s and overlaps it, so it passes as from behind (to start on "
        "the top, move it by [%.6g, %.6g] m; to let it pass, set \"solid\" of %s to false)",
        body, overlap->depth, plate, shown(overlap->depth * overlap->normal[0]),
        shown(overlap->depth * overlap->normal[1]), plate);
}

void tinker_overlaps_tell(TinkerScene *scene, GPtrArray *warnings)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return;
    g_autoptr(GArray) overlaps = tinker_overlaps_new(frame);
    for (guint i = 0; i < MIN(overlaps->len, TINKER_OVERLAPS_TOLD); i++)
        g_ptr_array_add(warnings, text_of(frame, &g_array_index(overlaps, TinkerOverlap, i)));
    if (overlaps->len <= TINKER_OVERLAPS_TOLD) return;
    const guint more = overlaps->len - TINKER_OVERLAPS_TOLD;
    g_ptr_array_add(warnings, g_strdup_printf("and %u more start%s below the top of a support and so pass%s it as from "
                                              "behind (mend the first ones, and these are told of)",
                                              more, more == 1 ? "s" : "", more == 1 ? "es" : ""));
}
