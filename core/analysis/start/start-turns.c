/* Starts of bodies that turn: level, upright, at an angle, spinning. What is joined to them goes along. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/joined.h"
#include "analysis/start/start-private.h"

gboolean start_turns(const TinkerScene *scene, TinkerBlockId body)
{
    return start_can_move(scene, body) && tinker_block_class_turns(tinker_scene_block_class(scene, body));
}

gboolean start_is_long(const TinkerScene *scene, TinkerBlockId body)
{
    return start_turns(scene, body) && tinker_scene_block_class(scene, body)->meanings[TINKER_MEANING_WIDTH] >= 0;
}

/* The angle that the body is to have: of those that look alike the one that it has least far to turn to. */
static double angle_asked(TinkerStartKind kind, double value, double now)
{
    if (kind == TINKER_START_LEVEL) return G_PI * round(now / G_PI) + 0.0;
    if (kind == TINKER_START_UPRIGHT) return G_PI * round(now / G_PI - 0.5) + 0.5 * G_PI;
    return value;
}

static gboolean turn(TinkerHistory *history, TinkerScene *scene, const TinkerStartOption *option, double value,
                     GError **error)
{
    const TinkerPlacement before = tinker_placement_of(scene, option->block);
    const double angle = angle_asked(option->kind, value, before.orientation);
    return start_set_meaning(history, scene, option->block, TINKER_MEANING_ORIENTATION, &angle, error) &&
           tinker_joined_follow(history, scene, &before, error);
}

static gboolean spin(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, double rate, GError **error)
{
    return start_set_meaning(history, scene, body, TINKER_MEANING_ANGULAR_VELOCITY, &rate, error) &&
           tinker_joined_spin(history, scene, body, error);
}

gboolean start_turn_is(TinkerStartKind kind)
{
    return kind == TINKER_START_LEVEL || kind == TINKER_START_UPRIGHT || kind == TINKER_START_INCLINED ||
           kind == TINKER_START_SPINNING;
}

gboolean start_turn_apply(TinkerHistory *history, TinkerScene *scene, const TinkerStartOption *option, double value,
                          const char *title, GError **error)
{
    tinker_history_begin(history, title, NULL);
    const gboolean done = option->kind == TINKER_START_SPINNING ? spin(history, scene, option->block, value, error)
                                                                : turn(history, scene, option, value, error);
    if (done)
        tinker_history_end(history);
    else
        tinker_history_abort(history);
    return done;
}
