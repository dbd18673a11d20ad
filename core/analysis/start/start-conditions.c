/* Applying a start condition: each kind says where bodies are to start, and one function writes that as one step. */
#include "analysis/start/start-conditions.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/start-private.h"

/* Of half a plate's width: how near to its end a body is placed at most. */
#define INSIDE (1 - 1e-9)

typedef struct {
    TinkerScene *scene;
    const TinkerFrame *frame;
    const TinkerStartOption *option;
    double value;
    GArray *places; /* of StartPlace: the answer */
} Asked;

static gboolean refuse(const Asked *asked, const char *why, GError **error)
{
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, "%s: %s",
                tinker_scene_block_name(asked->scene, asked->option->block), why);
    return FALSE;
}

static void centre_of(const TinkerFrame *frame, TinkerBlockId body, double place[2])
{
    double orientation;
    tinker_frame_centre(frame, body, &place[0], &place[1], &orientation);
}

static void set_velocity(Asked *asked, double x, double y)
{
    StartPlace place = START_PLACE_AS_IT_IS(asked->option->block);
    place.velocity[0] = x;
    place.velocity[1] = y;
    g_array_append_val(asked->places, place);
}

/* The link of the body by the connector; FALSE where the scene has changed since it was offered. */
static gboolean find_link(const Asked *asked, StartLink *link, GError **error)
{
    g_autoptr(GArray) links = start_links_new(asked->scene, asked->option->block);
    for (guint i = 0; i < links->len; i++) {
        *link = g_array_index(links, StartLink, i);
        if (link->connector == asked->option->other) return TRUE;
    }
    return refuse(asked, _("it is no longer connected as it was (select it again)"), error);
}

/* Equilibrium ------------------------------------------------------------------------------------------------------ */

static gboolean at_equilibrium(Asked *asked, gboolean displaced, GError **error)
{
    const TinkerBlockId body = asked->option->block;
    g_autoptr(StartRest) rest = start_rest_new(asked->scene, body, error);
    double direction[2] = {0, 0};
    if (rest == NULL) return FALSE;
    g_autofree gboolean *group = start_group_new(asked->scene, body, START_TIED_RIGIDLY, TINKER_NO_BLOCK, NULL);
    if (displaced) start_direction_at(asked->scene, asked->frame, body, rest, direction);
    for (guint i = 0; i < rest->bodies->len; i++) {
        StartPlace place = g_array_index(rest->bodies, StartPlace, i);
        for (int k = 0; k < 2 && displaced && group[place.body]; k++)
            place.place[k] += asked->value * direction[k];
        g_array_append_val(asked->places, place);
    }
    return TRUE;
}

/* Connectors ------------------------------------------------------------------------------------------------------- */

/* What is tied to the body rigidly is shifted with it. */
static void shift_group(Asked *asked, const double shift[2])
{
    const TinkerBlockId body = asked->option->block;
    g_autofree gboolean *group = start_group_new(asked->scene, body, START_TIED_RIGIDLY, TINKER_NO_BLOCK, NULL);
    for (TinkerBlockId id = 0; id < tinker_scene_id_limit(asked->scene); id++) {
        if (!group[id]) continue;
        StartPlace place = START_PLACE_AS_IT_IS(id);
        centre_of(asked->frame, id, place.place);
        for (int k = 0; k < 2; k++)
            place.place[k] += shift[k];
        g_array_append_val(asked->places, place);
    }
}

static gboolean stretched(Asked *asked, GError **error)
{
    StartLink link;
    double own[2], far[2];
    if (!find_link(asked, &link, error)) return FALSE;
    double length = tinker_frame_meaning(asked->frame, link.connector, TINKER_MEANING_LENGTH, 0, NAN) + asked->value;
    if (!(length > 0))
        return refuse(asked, _("nothing can be compressed by its whole rest length or more (ask for less)"), error);
    tinker_frame_end(asked->frame, link.own, own);
    tinker_frame_end(asked->frame, link.far, far);
    double dx = own[0] - far[0], dy = own[1] - far[1], distance = hypot(dx, dy);
    if (!(distance > 0)) {
        dy = -1; /* ends at one place show no direction: down */
        distance = 1;
    }
    const double scale = length / distance;
    shift_group(asked, (double[]){far[0] + scale * dx - own[0], far[1] + scale * dy - own[1]});
    return TRUE;
}

/* Turns a body of the frame about a pivot, with its velocity, and shifts it. */
static void add_turned(Asked *asked, TinkerBlockId body, const double pivot[2], double turn, const double shift[2])
{
    StartPlace place = START_PLACE_AS_IT_IS(body);
    double centre[2], velocity[2], c = cos(turn), s = sin(turn);
    centre_of(asked->frame, body, centre);
    start_velocity_of(asked->frame, body, velocity);
    double dx = centre[0] - pivot[0], dy = centre[1] - pivot[1];
    place.place[0] = pivot[0] + c * dx - s * dy + shift[0];
    place.place[1] = pivot[1] + s * dx + c * dy + shift[1];
    if (start_turns(asked->scene, body))
        place.orientation = tinker_frame_meaning(asked->frame, body, TINKER_MEANING_ORIENTATION, 0, 0) + turn;
    place.velocity[0] = c * velocity[0] - s * velocity[1];
    place.velocity[1] = s * velocity[0] + c * velocity[1];
    g_array_append_val(asked->places, place);
}

/* The body goes to length * (sin, -cos) of the angle from the pivot. What hangs on it by constraints turns with it,
 * unless it is tied to the pivot or to a support by another way. */
static gboolean at_angle(Asked *asked, GError **error)
{
    StartLink link;
    double own[2], pivot[2];
    gboolean anchored;
    if (!find_link(asked, &link, error)) return FALSE;
    const TinkerBlockId body = asked->option->block;
    tinker_frame_end(asked->frame, link.own, own);
    tinker_frame_end(asked->frame, link.far, pivot);
    double dx = own[0] - pivot[0], dy = own[1] - pivot[1], drawn = hypot(dx, dy), length = drawn;
    if (start_is_rigid(tinker_scene_block_class(asked->scene, link.connector)))
        length = tinker_frame_meaning(asked->frame, link.connector, TINKER_MEANING_LENGTH, 0, NAN);
    if (!(drawn > 0))
        return refuse(asked, _("it lies on the point that it would swing about (move it away first)"), error);
    const double turn = asked->value - atan2(dx, -dy);
    const double end[2] = {pivot[0] + length * sin(asked->value), pivot[1] - length * cos(asked->value)};
    const double c = cos(turn), s = sin(turn);
    const double shift[2] = {end[0] - (pivot[0] + c * dx - s * dy), end[1] - (pivot[1] + s * dx + c * dy)};
    g_autofree gboolean *group =
        start_group_new(asked->scene, body, START_TIED_BY_CONSTRAINTS, link.connector, &anchored);
    const gboolean alone = anchored || group[link.far.block];
    for (TinkerBlockId id = 0; id < tinker_scene_id_limit(asked->scene); id++)
        if (alone ? id == body : group[id]) add_turned(asked, id, pivot, turn, shift);
    return TRUE;
}

/* Plates ----------------------------------------------------------------------------------------------------------- */

static gboolean find_top(const Asked *asked, TinkerTop *top, GError **error)
{
    *top = tinker_top_nearest(asked->frame, asked->option->block);
    return top->plate == asked->option->other ||
           refuse(asked, _("it is nearer to another plate by now (select it again)"), error);
}

static gboolean on_top(Asked *asked, GError **error)
{
    TinkerTop top;
    double along, gap;
    if (!find_top(asked, &top, error)) return FALSE;
    tinker_top_foot(asked->frame, &top, asked->option->block, &along, &gap);
    along = tinker_top_round(&top, CLAMP(along, -INSIDE * top.half_width, INSIDE * top.half_width));
    StartPlace place = START_PLACE_AS_IT_IS(asked->option->block);
    if (tinker_body_can_stand(asked->frame, place.body)) {
        place.orientation = tinker_top_flat(asked->frame, &top, place.body);
        const double reach = tinker_top_reach(asked->frame, &top, place.body, place.orientation);
        tinker_top_centre(&top, along, reach, place.place);
    } else {
        place.lies = TRUE;
        place.plate = top.plate;
        place.along = along;
    }
    g_array_append_val(asked->places, place);
    return TRUE;
}

static gboolean along_top(Asked *asked, GError **error)
{
    TinkerTop top;
    if (!find_top(asked, &top, error)) return FALSE;
    set_velocity(asked, asked->value * top.uphill[0], asked->value * top.uphill[1]);
    if (asked->option->kind != TINKER_START_ROLLING) return TRUE;
    StartPlace *place = &g_array_index(asked->places, StartPlace, asked->places->len - 1);
    const double forward = asked->value * (top.uphill[0] * top.along[0] + top.uphill[1] * top.along[1]);
    place->rate = -forward / tinker_top_reach(asked->frame, &top, place->body, 0);
    return TRUE;
}

/* Velocities ------------------------------------------------------------------------------------------------------- */

static gboolean thrown(Asked *asked, GError **error)
{
    double v[2];
    start_velocity_of(asked->frame, asked->option->block, v);
    const double speed = hypot(v[0], v[1]);
    if (asked->option->kind == TINKER_START_DIRECTION) {
        set_velocity(asked, speed * cos(asked->value), speed * sin(asked->value));
        return TRUE;
    }
    if (asked->value < 0) return refuse(asked, _("a speed is not negative (turn its direction instead)"), error);
    if (speed > 0)
        set_velocity(asked, asked->value * (v[0] / speed), asked->value * (v[1] / speed));
    else
        set_velocity(asked, asked->value, 0);
    return TRUE;
}

/* Lengths ---------------------------------------------------------------------------------------------------------- */

static gboolean set_length(TinkerHistory *history, const Asked *asked, const char *title, GError **error)
{
    const TinkerBlockId connector = asked->option->block;
    double length = start_distance(asked->frame, tinker_scene_end(asked->scene, connector, 0),
                                   tinker_scene_end(asked->scene, connector, 1));
    if (asked->option->kind == TINKER_START_LENGTH_STRETCHED) length -= asked->value;
    tinker_history_begin(history, title, NULL);
    gboolean set = start_set_meaning(history, asked->scene, connector, TINKER_MEANING_LENGTH, &length, error);
    if (set)
        tinker_history_end(history);
    else
        tinker_history_abort(history);
    return set;
}

/* All -------------------------------------------------------------------------------------------------------------- */

static gboolean find_places(Asked *asked, GError **error)
{
    switch (asked->option->kind) {
    case TINKER_START_AT_EQUILIBRIUM:
    case TINKER_START_FROM_EQUILIBRIUM:
        return at_equilibrium(asked, asked->option->kind == TINKER_START_FROM_EQUILIBRIUM, error);
    case TINKER_START_STRETCHED:
        return stretched(asked, error);
    case TINKER_START_AT_ANGLE:
        return at_angle(asked, error);
    case TINKER_START_ON_TOP:
        return on_top(asked, error);
    case TINKER_START_ALONG_TOP:
    case TINKER_START_ROLLING:
        return along_top(asked, error);
    case TINKER_START_SPEED:
    case TINKER_START_DIRECTION:
        return thrown(asked, error);
    default:
        set_velocity(asked, 0, 0);
        if (start_turns(asked->scene, asked->option->block))
            g_array_index(asked->places, StartPlace, asked->places->len - 1).rate = 0;
        return TRUE;
    }
}

static gboolean is_of_length(TinkerStartKind kind)
{
    return kind == TINKER_START_LENGTH_AS_DRAWN || kind == TINKER_START_LENGTH_STRETCHED;
}

gboolean tinker_start_apply(TinkerHistory *history, TinkerScene *scene, const TinkerStartOption *option, double value,
                            GError **error)
{
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(StartPlace));
    Asked asked = {scene, NULL, option, option->asks ? value : 0, places};
    if (!tinker_scene_has_block(scene, option->block)) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, _("the block that was to start so is gone"));
        return FALSE;
    }
    if (!isfinite(asked.value)) return refuse(&asked, _("a start condition needs a finite number"), error);
    g_autofree char *title = g_strdup_printf("%s: %s", tinker_scene_block_name(scene, option->block), option->label);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    asked.frame = frame;
    if (frame == NULL) return FALSE;
    if (is_of_length(option->kind)) return set_length(history, &asked, title, error);
    if (start_turn_is(option->kind)) {
        g_clear_pointer(&frame, tinker_frame_free);
        return start_turn_apply(history, scene, option, asked.value, title, error);
    }
    if (!find_places(&asked, error)) return FALSE;
    g_clear_pointer(&frame, tinker_frame_free); /* it must not outlive the scene as it is */
    return start_places_write(history, scene, title, places, error);
}
