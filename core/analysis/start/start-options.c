/* What can be offered for a block, and in which words. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/start-conditions.h"
#include "analysis/start/start-private.h"

/* Up to so many bodies that hang together, equilibrium is looked for when it is offered. */
#define MOST_LOOKED_FOR 24

static const TinkerDimension no_dimension = TINKER_DIMENSION_NONE, length_dimension = TINKER_DIMENSION_LENGTH,
                             angle_dimension = TINKER_DIMENSION_ANGLE, speed_dimension = TINKER_DIMENSION_VELOCITY,
                             rate_dimension = TINKER_DIMENSION_ANGULAR_FREQUENCY;

static void option_free(gpointer data)
{
    TinkerStartOption *option = data;
    g_free(option->label);
    g_free(option->description);
    g_free(option);
}

/* The words are taken over. */
static void offer(GPtrArray *options, TinkerStartOption option, char *label, char *description)
{
    TinkerStartOption *copy = g_memdup2(&option, sizeof option);
    copy->label = label;
    copy->description = description;
    copy->value += 0.0; /* no -0 */
    g_ptr_array_add(options, copy);
}

/* Equilibrium ------------------------------------------------------------------------------------------------------ */

/* Names of the bodies of a group but for one, "A, B and 3 more"; NULL where there are none. (transfer full) */
static char *others_of(TinkerScene *scene, const gboolean *group, TinkerBlockId body, int32_t *bodies)
{
    GString *names = g_string_new(NULL);
    int32_t others = 0;
    for (TinkerBlockId id = 0; id < tinker_scene_id_limit(scene); id++) {
        if (!group[id] || id == body) continue;
        if (others++ < 3)
            g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", tinker_scene_block_name(scene, id));
    }
    if (others > 3) g_string_append_printf(names, _(" and %d more"), others - 3);
    *bodies = others + 1;
    return g_string_free(names, others == 0);
}

/* How far the body is off its place at rest now, along the direction in which it would be displaced. */
static double displacement(TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body, const StartRest *rest)
{
    const StartPlace *own = &g_array_index(rest->bodies, StartPlace, rest->own);
    double direction[2], x, y, orientation;
    start_direction_at(scene, frame, body, rest, direction);
    tinker_frame_centre(frame, body, &x, &y, &orientation);
    return (x - own->place[0]) * direction[0] + (y - own->place[1]) * direction[1];
}

static void offer_equilibrium(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body,
                              gboolean anchored)
{
    int32_t bodies;
    double off = 0;
    gboolean lands = FALSE; /* from elsewhere it would come down elsewhere */
    const char *name = tinker_scene_block_name(scene, body);
    g_autofree gboolean *group = start_group_new(scene, body, START_TIED_BY_ANYTHING, TINKER_NO_BLOCK, NULL);
    g_autofree char *others = others_of(scene, group, body, &bodies);
    if (bodies <= MOST_LOOKED_FOR) {
        g_autoptr(StartRest) rest = start_rest_new(scene, body, NULL);
        if (rest == NULL) return;
        off = displacement(scene, frame, body, rest);
        lands = rest->lands;
    }
    offer(
        options, (TinkerStartOption){TINKER_START_AT_EQUILIBRIUM, body, TINKER_NO_BLOCK, .dimension = no_dimension},
        g_strdup(_("Released from equilibrium")),
        others == NULL
            ? g_strdup_printf(_("Puts %s where all forces balance, without friction, with velocity 0"), name)
            : g_strdup_printf(_("Puts %s, and with it %s where all forces balance, without friction, with velocity 0"),
                              name, others));
    if (anchored || lands) return;
    offer(options,
          (TinkerStartOption){TINKER_START_FROM_EQUILIBRIUM, body, TINKER_NO_BLOCK, .asks = TRUE,
                              .dimension = length_dimension, .value = off},
          g_strdup(_("Displaced from equilibrium by")),
          others == NULL
              ? g_strdup_printf(_("Puts %s that far from where all forces balance (along its first connector: positive "
                                  "stretches it; else down), and releases it from rest"),
                                name)
              : g_strdup_printf(_("Puts %s that far from where all forces balance (along its first connector: positive "
                                  "stretches it; else down), and with it %s, and releases it from rest"),
                                name, others));
}

/* Connectors ------------------------------------------------------------------------------------------------------- */

static void offer_stretched(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body,
                            const StartLink *link)
{
    const char *connector = tinker_scene_block_name(scene, link->connector);
    double rest = tinker_frame_meaning(frame, link->connector, TINKER_MEANING_LENGTH, 0, 0);
    offer(options,
          (TinkerStartOption){TINKER_START_STRETCHED, body, link->connector, .asks = TRUE,
                              .dimension = length_dimension,
                              .value = start_distance(frame, link->own, link->far) - rest},
          g_strdup_printf(_("%s stretched by"), connector),
          g_strdup_printf(
              _("Moves %s along %s until it is that much longer than its rest length; negative compresses it (of one "
                "that only pushes, that is how far off it is)"),
              tinker_scene_block_name(scene, body), connector));
}

static void offer_angle(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body,
                        const StartLink *link)
{
    const char *connector = tinker_scene_block_name(scene, link->connector);
    double own[2], far[2];
    tinker_frame_end(frame, link->own, own);
    tinker_frame_end(frame, link->far, far);
    offer(options,
          (TinkerStartOption){TINKER_START_AT_ANGLE, body, link->connector, .asks = TRUE, .dimension = angle_dimension,
                              .value = atan2(own[0] - far[0], far[1] - own[1])},
          g_strdup_printf(_("%s from the vertical"), connector),
          g_strdup_printf(
              _("Swings %s about %s, with what hangs on it; 0 is straight down, positive is counter-clockwise"),
              tinker_scene_block_name(scene, body), tinker_scene_block_name(scene, link->far.block)));
}

static void offer_links(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body,
                        gboolean anchored)
{
    g_autoptr(GArray) links = start_links_new(scene, body);
    g_autofree gboolean *group = start_group_new(scene, body, START_TIED_RIGIDLY, TINKER_NO_BLOCK, NULL);
    for (guint i = 0; i < links->len; i++) {
        const StartLink *link = &g_array_index(links, StartLink, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, link->connector);
        if (start_has_rest_length(block_class) && !anchored && !group[link->far.block])
            offer_stretched(options, scene, frame, body, link);
        if (start_keeps_length(block_class)) offer_angle(options, scene, frame, body, link);
    }
}

/* Plates and velocities -------------------------------------------------------------------------------------------- */

static void offer_plate(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body)
{
    const TinkerBlockClass *body_class = tinker_scene_block_class(scene, body);
    if (!tinker_class_can_lie(body_class) && !tinker_body_can_stand(frame, body)) return; /* it meets no top */
    TinkerTop top = tinker_top_nearest(frame, body);
    double velocity[2];
    if (top.plate == TINKER_NO_BLOCK) return;
    const char *name = tinker_scene_block_name(scene, body), *plate = tinker_scene_block_name(scene, top.plate);
    start_velocity_of(frame, body, velocity);
    offer(options, (TinkerStartOption){TINKER_START_ON_TOP, body, top.plate, .dimension = no_dimension},
          g_strdup_printf(_("Placed on %s"), plate),
          g_strdup_printf(_("Moves %s straight to the top of %s, which it just touches, and turns it along the top"),
                          name, plate));
    offer(options,
          (TinkerStartOption){TINKER_START_ALONG_TOP, body, top.plate, .asks = TRUE, .dimension = speed_dimension,
                              .value = velocity[0] * top.uphill[0] + velocity[1] * top.uphill[1]},
          g_strdup(top.level ? _("Speed along the top") : _("Speed up the incline")),
          g_strdup_printf(top.level ? _("%s starts with that speed along the top of %s, positive to the right")
                                    : _("%s starts with that speed along the top of %s, positive uphill"),
                          name, plate));
    if (body_class->meanings[TINKER_MEANING_RADIUS] < 0) return;
    offer(options,
          (TinkerStartOption){TINKER_START_ROLLING, body, top.plate, .asks = TRUE, .dimension = speed_dimension,
                              .value = velocity[0] * top.uphill[0] + velocity[1] * top.uphill[1]},
          g_strdup(top.level ? _("Rolling at") : _("Rolling up the incline at")),
          g_strdup_printf(top.level ? _("%s starts with that speed along the top of %s, positive to the right, and "
                                        "turns so that it rolls")
                                    : _("%s starts with that speed along the top of %s, positive uphill, and turns so "
                                        "that it rolls"),
                          name, plate));
}

static void offer_velocities(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body)
{
    const char *name = tinker_scene_block_name(scene, body);
    double velocity[2];
    start_velocity_of(frame, body, velocity);
    double speed = hypot(velocity[0], velocity[1]);
    offer(options, (TinkerStartOption){TINKER_START_AT_REST, body, TINKER_NO_BLOCK, .dimension = no_dimension},
          g_strdup(_("At rest")), g_strdup_printf(_("%s starts with velocity 0"), name));
    offer(options,
          (TinkerStartOption){TINKER_START_SPEED, body, TINKER_NO_BLOCK, .asks = TRUE, .dimension = speed_dimension,
                              .value = speed},
          g_strdup(_("Thrown at speed")),
          g_strdup_printf(speed > 0 ? _("%s starts with that speed, in its present direction")
                                    : _("%s starts with that speed, in its present direction, which is to the right"),
                          name));
    if (speed == 0) return;
    offer(options,
          (TinkerStartOption){TINKER_START_DIRECTION, body, TINKER_NO_BLOCK, .asks = TRUE, .dimension = angle_dimension,
                              .value = atan2(velocity[1], velocity[0])},
          g_strdup(_("Direction")),
          g_strdup_printf(_("%s starts with its present speed at that angle, counter-clockwise from the right"), name));
}

/* Turning ---------------------------------------------------------------------------------------------------------- */

static void offer_turned(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body)
{
    const char *name = tinker_scene_block_name(scene, body);
    offer(options, (TinkerStartOption){TINKER_START_LEVEL, body, TINKER_NO_BLOCK, .dimension = no_dimension},
          g_strdup(_("Horizontal")),
          g_strdup_printf(_("Turns %s until its length is horizontal; what is joined to it goes along"), name));
    offer(options, (TinkerStartOption){TINKER_START_UPRIGHT, body, TINKER_NO_BLOCK, .dimension = no_dimension},
          g_strdup(_("Vertical")),
          g_strdup_printf(_("Turns %s until its length is vertical; what is joined to it goes along"), name));
    offer(options,
          (TinkerStartOption){TINKER_START_INCLINED, body, TINKER_NO_BLOCK, .asks = TRUE, .dimension = angle_dimension,
                              .value = tinker_frame_meaning(frame, body, TINKER_MEANING_ORIENTATION, 0, 0)},
          g_strdup(_("Angle from the horizontal")),
          g_strdup_printf(
              _("Turns %s to that angle, counter-clockwise from the right; what is joined to it goes along"), name));
}

static void offer_spinning(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body)
{
    offer(
        options,
        (TinkerStartOption){TINKER_START_SPINNING, body, TINKER_NO_BLOCK, .asks = TRUE, .dimension = rate_dimension,
                            .value = tinker_frame_meaning(frame, body, TINKER_MEANING_ANGULAR_VELOCITY, 0, 0)},
        g_strdup(_("Spinning at")),
        g_strdup_printf(_("%s starts to turn at that rate, counter-clockwise (as in 120 rpm), about what it is joined "
                          "to; that starts as it must then"),
                        tinker_scene_block_name(scene, body)));
}

/* A block ---------------------------------------------------------------------------------------------------------- */

static void offer_for_body(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body)
{
    g_autoptr(GArray) links = start_links_new(scene, body);
    gboolean anchored;
    g_free(start_group_new(scene, body, START_TIED_RIGIDLY, TINKER_NO_BLOCK, &anchored));
    if (links->len > 0) offer_equilibrium(options, scene, frame, body, anchored);
    offer_links(options, scene, frame, body, anchored);
    offer_plate(options, scene, frame, body);
    if (start_is_long(scene, body)) offer_turned(options, scene, frame, body);
    offer_velocities(options, scene, frame, body);
    if (start_turns(scene, body)) offer_spinning(options, scene, frame, body);
}

static void offer_for_connector(GPtrArray *options, TinkerScene *scene, const TinkerFrame *frame,
                                TinkerBlockId connector)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, connector);
    TinkerSceneEnd first = tinker_scene_end(scene, connector, 0), second = tinker_scene_end(scene, connector, 1);
    if (first.block == TINKER_NO_BLOCK || second.block == TINKER_NO_BLOCK) return;
    const gboolean rests = start_has_rest_length(block_class);
    double distance = start_distance(frame, first, second);
    g_autofree char *drawn = start_quantity_text(scene, distance, length_dimension);
    offer(options, (TinkerStartOption){TINKER_START_LENGTH_AS_DRAWN, connector, connector, .dimension = no_dimension},
          g_strdup(rests ? _("Rest length as drawn") : _("Length as drawn")),
          g_strdup_printf(rests ? _("Gives %s the rest length that it is drawn with, %s")
                                : _("Gives %s the length that it is drawn with, %s"),
                          tinker_scene_block_name(scene, connector), drawn));
    if (!rests) return;
    offer(
        options,
        (TinkerStartOption){TINKER_START_LENGTH_STRETCHED, connector, connector, .asks = TRUE,
                            .dimension = length_dimension,
                            .value = distance - tinker_frame_meaning(frame, connector, TINKER_MEANING_LENGTH, 0, 0)},
        g_strdup(_("Stretched by")),
        g_strdup(_("Its rest length becomes that much less than the length it is drawn with; negative compresses it")));
}

GPtrArray *tinker_start_options_new(TinkerScene *scene, TinkerBlockId block)
{
    GPtrArray *options = g_ptr_array_new_with_free_func(option_free);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL || !tinker_scene_has_block(scene, block)) return options;
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (start_can_move(scene, block))
        offer_for_body(options, scene, frame, block);
    else if (start_has_rest_length(block_class) || start_keeps_length(block_class))
        offer_for_connector(options, scene, frame, block);
    return options;
}
