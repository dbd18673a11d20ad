/* The first meeting is looked for up to a horizon that doubles until there is one: up to that horizon each box stays in
 * the rectangle around its way, and only boxes whose rectangles overlap are looked at, found by sorting the rectangles
 * along the axis that they are spread along. The mean velocity, which no meeting depends on, is taken out first. */
#include "scene/frame/boxes.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "scene/frame/tops.h"

/* The first horizon, as a share of the last; and how many pairs are looked at, most. */
#define FIRST_SHARE (1.0 / 1024)
#define MOST_PAIRS  100000000

/* The boxes of all bodies that can move and have an extent in both directions, where the frame has them, with their
 * start velocities. Element: TinkerBox. (transfer full) */
static GArray *boxes_new(const TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    GArray *boxes = g_array_new(FALSE, FALSE, sizeof(TinkerBox));
    for (TinkerBlockId id = 0; id < tinker_scene_id_limit(scene); id++) {
        if (!tinker_scene_has_block(scene, id) || !tinker_class_can_lie(tinker_scene_block_class(scene, id))) continue;
        TinkerBox box = {.block = id,
                         .width = tinker_frame_meaning(frame, id, TINKER_MEANING_WIDTH, 0, 0),
                         .height = tinker_frame_meaning(frame, id, TINKER_MEANING_HEIGHT, 0, 0),
                         .vx = tinker_frame_meaning(frame, id, TINKER_MEANING_VELOCITY, 0, 0),
                         .vy = tinker_frame_meaning(frame, id, TINKER_MEANING_VELOCITY, 1, 0),
                         .collides = tinker_frame_meaning(frame, id, TINKER_MEANING_COLLIDES, 0, 0) != 0};
        tinker_frame_centre(frame, id, &box.x, &box.y, &box.angle);
        if (box.width > 0 && box.height > 0) g_array_append_val(boxes, box);
    }
    return boxes;
}

void tinker_box_reach(const TinkerBox *box, double reach[2])
{
    const double c = fabs(cos(box->angle)), s = fabs(sin(box->angle));
    reach[0] = 0.5 * (c * box->width + s * box->height);
    reach[1] = 0.5 * (s * box->width + c * box->height);
}

/* Half the shadow of a box on a direction of length 1. */
static double shadow(const TinkerBox *box, double nx, double ny)
{
    const double c = cos(box->angle), s = sin(box->angle);
    return 0.5 * (box->width * fabs(c * nx + s * ny) + box->height * fabs(c * ny - s * nx));
}

/* Narrows [from, to] to the times at which the shadows on a direction overlap; FALSE where they never do. */
static gboolean narrow(const TinkerBox *a, const TinkerBox *b, double nx, double ny, double *from, double *to)
{
    const double reach = shadow(a, nx, ny) + shadow(b, nx, ny) - TINKER_BOXES_APART;
    const double distance = nx * (b->x - a->x) + ny * (b->y - a->y);
    const double rate = nx * (b->vx - a->vx) + ny * (b->vy - a->vy);
    if (rate == 0) return fabs(distance) < reach;
    const double first = (-copysign(reach, rate) - distance) / rate, last = (copysign(reach, rate) - distance) / rate;
    *from = fmax(*from, first);
    *to = fmin(*to, last);
    return reach > 0 && *from <= *to;
}

gboolean tinker_boxes_meet(const TinkerBox *a, const TinkerBox *b, double horizon, double *time)
{
    double from = 0, to = horizon;
    const TinkerBox *const boxes[] = {a, b};
    for (int k = 0; k < 2; k++) {
        const double c = cos(boxes[k]->angle), s = sin(boxes[k]->angle);
        if (!narrow(a, b, c, s, &from, &to) || !narrow(a, b, -s, c, &from, &to)) return FALSE;
    }
    *time = from;
    return TRUE;
}

/* The first meeting ------------------------------------------------------------------------------------------------ */

/* The rectangle around the way of a box: along the axis that the boxes are spread along, and across. */
typedef struct {
    double from[2], to[2];
    guint box;
} Way;

static int compare_from(gconstpointer a, gconstpointer b)
{
    const Way *first = a, *second = b;
    if (first->from[0] != second->from[0]) return first->from[0] < second->from[0] ? -1 : 1;
    return first->box < second->box ? -1 : first->box > second->box;
}

static void take_out_mean_velocity(GArray *boxes)
{
    double mean[2] = {0, 0};
    for (guint i = 0; i < boxes->len; i++) {
        mean[0] += g_array_index(boxes, TinkerBox, i).vx / boxes->len;
        mean[1] += g_array_index(boxes, TinkerBox, i).vy / boxes->len;
    }
    for (guint i = 0; i < boxes->len; i++) {
        g_array_index(boxes, TinkerBox, i).vx -= mean[0];
        g_array_index(boxes, TinkerBox, i).vy -= mean[1];
    }
}

/* Whether the boxes are spread upwards (1) rather than sideways (0). */
static int spread_of(const GArray *boxes)
{
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (guint i = 0; i < boxes->len; i++) {
        const TinkerBox *box = &g_array_index(boxes, TinkerBox, i);
        const double place[2] = {box->x, box->y};
        for (int k = 0; k < 2; k++) {
            least[k] = fmin(least[k], place[k]);
            most[k] = fmax(most[k], place[k]);
        }
    }
    return most[1] - least[1] > most[0] - least[0];
}

/* The ways up to a horizon, in the order of their beginnings. (transfer full) */
static GArray *ways_new(const GArray *boxes, double horizon)
{
    const int spread = spread_of(boxes);
    GArray *ways = g_array_sized_new(FALSE, FALSE, sizeof(Way), boxes->len);
    for (guint i = 0; i < boxes->len; i++) {
        const TinkerBox *box = &g_array_index(boxes, TinkerBox, i);
        const double place[2] = {box->x, box->y}, way[2] = {box->vx * horizon, box->vy * horizon};
        double reach[2];
        tinker_box_reach(box, reach);
        Way around = {.box = i};
        for (int k = 0; k < 2; k++) {
            around.from[k ^ spread] = place[k] - reach[k] + fmin(way[k], 0);
            around.to[k ^ spread] = place[k] + reach[k] + fmax(way[k], 0);
        }
        g_array_append_val(ways, around);
    }
    g_array_sort(ways, compare_from);
    return ways;
}

/* Keeps the earlier of two meetings. */
static void keep_first(TinkerMeeting *meeting, const TinkerBox *a, const TinkerBox *b, double time)
{
    const TinkerMeeting other = {MIN(a->block, b->block), MAX(a->block, b->block), time};
    const gboolean same = other.time == meeting->time;
    if (other.time < meeting->time || (same && other.first < meeting->first) ||
        (same && other.first == meeting->first && other.second < meeting->second))
        *meeting = other;
}

/* The first meeting up to a horizon, kept where it is earlier than the one that is there. FALSE where there were too
 * many pairs. */
static gboolean look_up_to(const GArray *boxes, double horizon, gint64 *pairs, TinkerMeeting *meeting)
{
    g_autoptr(GArray) ways = ways_new(boxes, horizon);
    for (guint i = 0; i < ways->len; i++) {
        const Way *way = &g_array_index(ways, Way, i);
        for (guint k = i + 1; k < ways->len && g_array_index(ways, Way, k).from[0] < way->to[0]; k++) {
            const Way *other = &g_array_index(ways, Way, k);
            if (--*pairs < 0) return FALSE;
            if (other->from[1] >= way->to[1] || way->from[1] >= other->to[1]) continue;
            const TinkerBox *a = &g_array_index(boxes, TinkerBox, way->box);
            const TinkerBox *b = &g_array_index(boxes, TinkerBox, other->box);
            double time;
            if (a->collides && b->collides) continue;
            if (tinker_boxes_meet(a, b, horizon, &time)) keep_first(meeting, a, b, time);
        }
    }
    return TRUE;
}

gboolean tinker_boxes_first_meeting(GArray *boxes, double horizon, TinkerMeeting *meeting)
{
    gint64 pairs = MOST_PAIRS;
    *meeting = (TinkerMeeting){TINKER_NO_BLOCK, TINKER_NO_BLOCK, INFINITY};
    take_out_mean_velocity(boxes);
    gboolean goes_on = look_up_to(boxes, 0, &pairs, meeting);
    for (double up_to = FIRST_SHARE * horizon; goes_on && meeting->first == TINKER_NO_BLOCK; up_to *= 2) {
        goes_on = look_up_to(boxes, fmin(up_to, horizon), &pairs, meeting) && up_to < horizon;
    }
    return meeting->first != TINKER_NO_BLOCK;
}

char *tinker_boxes_warning(const TinkerFrame *frame, double duration, TinkerMeeting *meeting)
{
    g_autoptr(GArray) boxes = boxes_new(frame);
    if (!tinker_boxes_first_meeting(boxes, duration, meeting)) return NULL;
    const char *first = tinker_scene_block_name(tinker_frame_scene(frame), meeting->first);
    const char *second = tinker_scene_block_name(tinker_frame_scene(frame), meeting->second);
    if (meeting->time > 0)
        return g_strdup_printf(
            _("%s and %s meet at %.4g s, moved on with their start velocities: they pass through each "
              "other, as not both of them have \"collides\" on"),
            first, second, meeting->time);
    return g_strdup_printf(_("%s and %s overlap at the start: they pass through each other, as not both of them have "
                             "\"collides\" on"),
                           first, second);
}

void tinker_boxes_tell(TinkerScene *scene, double duration, GPtrArray *warnings)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    TinkerMeeting meeting;
    char *warning = frame == NULL ? NULL : tinker_boxes_warning(frame, duration, &meeting);
    if (warning != NULL) g_ptr_array_add(warnings, warning);
}
