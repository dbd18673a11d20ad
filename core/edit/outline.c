/* Corners are points of a list, in axes of their own that the centre of mass is told in as well. A place p in the world
 * is the point R^T (p - X) + c of the list, with X the place and R the turn of the body, c its centre of mass. Where a
 * change moves c, which is worked out from the corners unless it is given, X moves along: X <- X + R (c' - c). */
#include "edit/outline.h"

#include <math.h>
#include <string.h>

#include <tinker/shapes.h>

#include "scene/frame/frame.h"
#include "units/quantity/point-text.h"

typedef struct {
    TinkerHistory *history;
    TinkerScene *scene;
    TinkerBlockId block;
    int32_t list;                      /* the property that is the list */
    double place[2], angle, centre[2]; /* X, R, c */
    GArray *points;
} Outline;

static int32_t list_of(const TinkerBlockClass *block_class)
{
    if (block_class == NULL || block_class->meanings[TINKER_MEANING_CENTRE_OF_MASS] < 0) return -1;
    for (int32_t p = 0; p < block_class->property_count; p++)
        if ((block_class->properties[p].flags & TINKER_TEXT_POINTS) != 0) return p;
    return -1;
}

gboolean tinker_outline_is_of(const TinkerBlockClass *block_class)
{
    return list_of(block_class) >= 0;
}

static gboolean look(Outline *outline)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(outline->scene, NULL);
    const TinkerBlockClass *block_class = tinker_scene_block_class(outline->scene, outline->block);
    if (frame == NULL) return FALSE;
    tinker_frame_centre(frame, outline->block, &outline->place[0], &outline->place[1], &outline->angle);
    for (int k = 0; k < 2; k++)
        outline->centre[k] = tinker_frame_column(
            frame, outline->block, tinker_block_class_meaning_column(block_class, TINKER_MEANING_CENTRE_OF_MASS) + k);
    return isfinite(outline->centre[0] + outline->centre[1]);
}

static gboolean outline_open(Outline *outline, TinkerHistory *history, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    *outline = (Outline){.history = history, .scene = scene, .block = block, .list = list_of(block_class)};
    if (outline->list < 0) return FALSE;
    outline->points = tinker_point_text_parse(tinker_scene_get_text(scene, block, outline->list),
                                              block_class->properties[outline->list].dimension, NULL);
    return outline->points != NULL && look(outline);
}

static void outline_clear(Outline *outline)
{
    g_clear_pointer(&outline->points, g_array_unref);
}

static double *corner(const Outline *outline, guint number)
{
    return &g_array_index(outline->points, double, 2 * number);
}

static guint count_of(const Outline *outline)
{
    return outline->points->len / 2;
}

static void to_own(const Outline *outline, const double place[2], double own[2])
{
    const double c = cos(outline->angle), s = sin(outline->angle);
    const double x = place[0] - outline->place[0], y = place[1] - outline->place[1];
    own[0] = c * x + s * y + outline->centre[0];
    own[1] = c * y - s * x + outline->centre[1];
}

/* Writes the corners, and lets the body go with its centre of mass. */
static void outline_keep(Outline *outline)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(outline->scene, outline->block);
    const int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    const double c = cos(outline->angle), s = sin(outline->angle), was[2] = {outline->centre[0], outline->centre[1]};
    g_autofree char *text =
        tinker_point_text_new((const double *)(const void *)outline->points->data, (int32_t)count_of(outline));
    tinker_history_set_text(outline->history, outline->block, outline->list, text);
    if (!look(outline)) return;
    const double x = outline->centre[0] - was[0], y = outline->centre[1] - was[1];
    const double place[2] = {outline->place[0] + c * x - s * y, outline->place[1] + s * x + c * y};
    if (x != 0 || y != 0) tinker_history_set(outline->history, outline->block, position, place, NULL);
}

int32_t tinker_outline_corners(TinkerScene *scene, TinkerBlockId block)
{
    Outline outline;
    const gboolean open = outline_open(&outline, NULL, scene, block);
    const int32_t count = open ? (int32_t)count_of(&outline) : 0;
    outline_clear(&outline);
    return count;
}

void tinker_outline_move(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t number,
                         const double place[2])
{
    Outline outline;
    if (outline_open(&outline, history, scene, block) && number >= 0 && (guint)number < count_of(&outline)) {
        to_own(&outline, place, corner(&outline, (guint)number));
        outline_keep(&outline);
    }
    outline_clear(&outline);
}

void tinker_outline_add(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, const double place[2])
{
    Outline outline;
    const gboolean open = outline_open(&outline, history, scene, block);
    const guint count = open ? count_of(&outline) : 0;
    if (count >= 2 && count < TINKER_MOST_POINTS) {
        double own[2], nearest = INFINITY;
        guint behind = 0;
        to_own(&outline, place, own);
        for (guint i = 0; i < count; i++) {
            const double *a = corner(&outline, i), *b = corner(&outline, (i + 1) % count);
            const double off = tinker_segment_distance(own[0], own[1], a[0], a[1], b[0], b[1]);
            if (off >= nearest) continue;
            nearest = off;
            behind = i;
        }
        g_array_insert_vals(outline.points, 2 * (behind + 1), own, 2);
        outline_keep(&outline);
    }
    outline_clear(&outline);
}

void tinker_outline_remove(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t number)
{
    Outline outline;
    if (outline_open(&outline, history, scene, block) && count_of(&outline) > TINKER_LEAST_CORNERS && number >= 0 &&
        (guint)number < count_of(&outline)) {
        g_array_remove_range(outline.points, 2 * (guint)number, 2);
        outline_keep(&outline);
    }
    outline_clear(&outline);
}
