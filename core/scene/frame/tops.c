/* Tops from the meanings of properties; no plate is known by its type. */
#include <math.h>

#include "scene/frame/overlaps.h"
#include "scene/frame/tops.h"

#include <tinker/physics.h>

/* Pairs of a body and a top: a picture does not wait for more. */
#define MOST_PAIRS 1000000

/* A slope less than this is rounding of the angle. */
#define LEVEL 1e-9

static const TinkerBody *body_of(const TinkerBlockClass *block_class)
{
    return block_class == NULL || block_class->physics == NULL ? NULL : block_class->physics->body;
}

gboolean tinker_class_has_top(const TinkerBlockClass *block_class)
{
    const TinkerBody *body = body_of(block_class);
    return body != NULL && body->shape == TINKER_SHAPE_PLATE;
}

gboolean tinker_class_can_lie(const TinkerBlockClass *block_class)
{
    const TinkerBody *body = body_of(block_class);
    return body != NULL && body->shape == TINKER_SHAPE_BOX && body->degrees_of_freedom == 2 &&
           block_class->meanings[TINKER_MEANING_POSITION] >= 0;
}

static gboolean has_reach(const TinkerBody *body)
{
    return body->degrees_of_freedom == 3 && (body->shape == TINKER_SHAPE_BOX || body->shape == TINKER_SHAPE_DISC);
}

gboolean tinker_class_can_be_put(const TinkerBlockClass *block_class)
{
    const TinkerBody *body = body_of(block_class);
    return tinker_class_can_lie(block_class) ||
           (body != NULL && has_reach(body) && block_class->meanings[TINKER_MEANING_POSITION] >= 0);
}

gboolean tinker_body_can_stand(const TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerBody *body = body_of(tinker_scene_block_class(tinker_frame_scene(frame), block));
    return body != NULL && has_reach(body) && tinker_frame_meaning(frame, block, TINKER_MEANING_SOLID, 0, 0) != 0;
}

static gboolean is_solid(const TinkerFrame *frame, TinkerBlockId block)
{
    return tinker_class_has_top(tinker_scene_block_class(tinker_frame_scene(frame), block)) &&
           tinker_frame_meaning(frame, block, TINKER_MEANING_SOLID, 0, 1) != 0 &&
           tinker_frame_meaning(frame, block, TINKER_MEANING_WIDTH, 0, 0) > 0;
}

TinkerTop tinker_top_of(const TinkerFrame *frame, TinkerBlockId plate)
{
    double x, y, half = 0.5 * tinker_frame_meaning(frame, plate, TINKER_MEANING_HEIGHT, 0, 0);
    TinkerTop top = {.plate = plate};
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

double tinker_top_reach(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId block, double orientation)
{
    const TinkerBody *body = body_of(tinker_scene_block_class(tinker_frame_scene(frame), block));
    const double width = tinker_frame_meaning(frame, block, TINKER_MEANING_WIDTH, 0, 0);
    const double height = tinker_frame_meaning(frame, block, TINKER_MEANING_HEIGHT, 0, 0);
    if (body == NULL || body->degrees_of_freedom != 3) return 0.5 * height;
    if (body->shape == TINKER_SHAPE_DISC) return tinker_frame_meaning(frame, block, TINKER_MEANING_RADIUS, 0, 0);
    const double turned = orientation - top->angle;
    return 0.5 * (width * fabs(sin(turned)) + height * fabs(cos(turned)));
}

double tinker_top_flat(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId block)
{
    double x, y, orientation;
    tinker_frame_centre(frame, block, &x, &y, &orientation);
    const TinkerBody *body = body_of(tinker_scene_block_class(tinker_frame_scene(frame), block));
    if (body == NULL || body->shape == TINKER_SHAPE_DISC) return orientation;
    const double quarter = 0.5 * G_PI;
    return top->angle + quarter * round((orientation - top->angle) / quarter);
}

void tinker_top_foot(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body, double *along, double *gap)
{
    double x, y, orientation;
    tinker_frame_centre(frame, body, &x, &y, &orientation);
    double dx = x - top->middle[0], dy = y - top->middle[1];
    *along = top->along[0] * dx + top->along[1] * dy;
    *gap = top->normal[0] * dx + top->normal[1] * dy - tinker_top_reach(frame, top, body, orientation);
}

gboolean tinker_top_touches(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body)
{
    double along, gap;
    if (top->plate == TINKER_NO_BLOCK) return FALSE;
    tinker_top_foot(frame, top, body, &along, &gap);
    return fabs(gap) <= TINKER_TOUCHING && fabs(along) <= top->half_width;
}

double tinker_top_round(const TinkerTop *top, double along)
{
    const double rounded = round(along * 1e9) / 1e9;
    return fmax(fmin(rounded, top->half_width), -top->half_width);
}

void tinker_top_centre(const TinkerTop *top, double along, double reach, double centre[2])
{
    for (int k = 0; k < 2; k++)
        centre[k] = top->middle[k] + along * top->along[k] + reach * top->normal[k];
}

static GArray *solid_tops(const TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    GArray *tops = g_array_new(FALSE, FALSE, sizeof(TinkerTop));
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        if (!is_solid(frame, block)) continue;
        const TinkerTop top = tinker_top_of(frame, block);
        g_array_append_val(tops, top);
    }
    return tops;
}

TinkerTop tinker_top_nearest(const TinkerFrame *frame, TinkerBlockId body)
{
    g_autoptr(GArray) tops = solid_tops(frame);
    TinkerTop nearest = {.plate = TINKER_NO_BLOCK};
    double least = INFINITY;
    for (guint i = 0; i < tops->len; i++) {
        const TinkerTop *top = &g_array_index(tops, TinkerTop, i);
        double along, gap;
        tinker_top_foot(frame, top, body, &along, &gap);
        double distance = hypot(fmax(fabs(along) - top->half_width, 0), gap);
        if (!(distance < least)) continue;
        least = distance;
        nearest = *top;
    }
    return nearest;
}

double tinker_top_height(const TinkerTop *top, const double place[2])
{
    return top->normal[0] * (place[0] - top->middle[0]) + top->normal[1] * (place[1] - top->middle[1]);
}

TinkerTop tinker_top_at(const TinkerFrame *frame, const double place[2], double reach)
{
    g_autoptr(GArray) tops = solid_tops(frame);
    TinkerTop nearest = {.plate = TINKER_NO_BLOCK};
    for (guint i = 0; i < tops->len; i++) {
        const TinkerTop *top = &g_array_index(tops, TinkerTop, i);
        const double dx = place[0] - top->middle[0], dy = place[1] - top->middle[1];
        const double height = fabs(tinker_top_height(top, place));
        if (fabs(top->along[0] * dx + top->along[1] * dy) > top->half_width || height > reach) continue;
        reach = height;
        nearest = *top;
    }
    return nearest;
}

void tinker_tops_turn_bodies(TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    g_autoptr(GArray) tops = solid_tops(frame);
    if ((gint64)tops->len * tinker_scene_block_count(scene) > MOST_PAIRS) return;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId body = tinker_scene_block_at(scene, i);
        if (!tinker_class_can_lie(tinker_scene_block_class(scene, body))) continue;
        for (guint k = 0; k < tops->len; k++) {
            const TinkerTop *top = &g_array_index(tops, TinkerTop, k);
            if (!tinker_top_touches(frame, top, body)) continue;
            tinker_frame_lay(frame, body, top->angle);
            break;
        }
    }
}
