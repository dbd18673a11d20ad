/* Plates near a body: the top, as in scene/overlaps.c, is the +y side of the plate's own axes. */
#include <math.h>

#include "analysis/start-private.h"
#include "scene/overlaps.h"

/* A slope less than this is rounding of the angle. */
#define LEVEL 1e-9

static gboolean is_plate(const TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    const TinkerPhysics *physics = block_class == NULL ? NULL : block_class->physics;
    return physics != NULL && physics->body != NULL && physics->body->shape == TINKER_SHAPE_PLATE &&
           tinker_frame_meaning(frame, block, TINKER_MEANING_SOLID, 0, 1) != 0 &&
           tinker_frame_meaning(frame, block, TINKER_MEANING_WIDTH, 0, 0) > 0;
}

static StartTop top_of(const TinkerFrame *frame, TinkerBlockId plate)
{
    double x, y, half = 0.5 * tinker_frame_meaning(frame, plate, TINKER_MEANING_HEIGHT, 0, 0);
    StartTop top = {.plate = plate};
    tinker_frame_centre(frame, plate, &x, &y, &top.angle);
    double c = cos(top.angle), s = sin(top.angle);
    top.along[0] = top.normal[1] = c;
    top.along[1] = s;
    top.normal[0] = -s;
    top.middle[0] = x + half * top.normal[0];
    top.middle[1] = y + half * top.normal[1];
    top.half_width = 0.5 * tinker_frame_meaning(frame, plate, TINKER_MEANING_WIDTH, 0, 0);
    top.level = fabs(s) < LEVEL;
    double sign = (top.level ? c : s) < 0 ? -1 : 1;
    top.uphill[0] = sign * c;
    top.uphill[1] = sign * s;
    return top;
}

void start_foot(const TinkerFrame *frame, const StartTop *top, TinkerBlockId body, double *along, double *gap)
{
    double x, y, orientation;
    tinker_frame_centre(frame, body, &x, &y, &orientation);
    double dx = x - top->middle[0], dy = y - top->middle[1];
    *along = top->along[0] * dx + top->along[1] * dy;
    *gap = top->normal[0] * dx + top->normal[1] * dy -
           0.5 * tinker_frame_meaning(frame, body, TINKER_MEANING_HEIGHT, 0, 0);
}

gboolean start_touches(const TinkerFrame *frame, const StartTop *top, TinkerBlockId body)
{
    double along, gap;
    if (top->plate == TINKER_NO_BLOCK) return FALSE;
    start_foot(frame, top, body, &along, &gap);
    return fabs(gap) <= TINKER_TOUCHING && fabs(along) <= top->half_width;
}

StartTop start_nearest_top(const TinkerFrame *frame, TinkerBlockId body)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    StartTop nearest = {.plate = TINKER_NO_BLOCK};
    double least = INFINITY;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        if (!is_plate(frame, block)) continue;
        StartTop top = top_of(frame, block);
        double along, gap;
        start_foot(frame, &top, body, &along, &gap);
        double distance = hypot(fmax(fabs(along) - top.half_width, 0), gap);
        if (!(distance < least)) continue;
        least = distance;
        nearest = top;
    }
    return nearest;
}
