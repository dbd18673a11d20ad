/* Where the bodies stand then is worked out by the physics' own constraints, and goes to the history as any edit does.
 */
#include "analysis/joined.h"

#include <math.h>
#include <string.h>

#include "analysis/start-private.h"
#include "physics/compile/assemble.h"

#define NO_MOVE 1e-12 /* m and rad, of 1 or of the value: rounding of the constraints is no edit */

static double component(const TinkerScene *scene, TinkerBlockId block, int32_t meaning, int32_t component)
{
    const TinkerBlockClass *block_class = block != TINKER_NO_BLOCK ? tinker_scene_block_class(scene, block) : NULL;
    const int32_t column = block_class != NULL ? tinker_block_class_meaning_column(block_class, meaning) : -1;
    return column >= 0 ? tinker_scene_get(scene, block, column + component) : 0;
}

TinkerPlacement tinker_placement_of(const TinkerScene *scene, TinkerBlockId block)
{
    return (TinkerPlacement){
        block,
        {component(scene, block, TINKER_MEANING_POSITION, 0), component(scene, block, TINKER_MEANING_POSITION, 1)},
        component(scene, block, TINKER_MEANING_ORIENTATION, 0)};
}

static gboolean differs(double a, double b)
{
    return !(fabs(a - b) <= NO_MOVE * fmax(1, fabs(b)));
}

static gboolean is_elsewhere(const TinkerPlacement *a, const TinkerPlacement *b)
{
    return differs(a->place[0], b->place[0]) || differs(a->place[1], b->place[1]);
}

/* Sets what is another than it is now. */
static void put(TinkerHistory *history, const TinkerScene *scene, const TinkerPlacement *to)
{
    const TinkerPlacement now = tinker_placement_of(scene, to->block);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, to->block);
    const int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    const int32_t orientation = block_class->meanings[TINKER_MEANING_ORIENTATION];
    if (position >= 0 && is_elsewhere(to, &now)) tinker_history_set(history, to->block, position, to->place, NULL);
    if (orientation >= 0 && differs(to->orientation, now.orientation))
        tinker_history_set(history, to->block, orientation, &to->orientation, NULL);
}

gboolean tinker_joined_can_be_brought(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerHeldBody held = {block, TRUE, TRUE, FALSE};
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, NULL);
    return bodies != NULL;
}

static void put_all(TinkerHistory *history, TinkerScene *scene, const GArray *bodies)
{
    for (guint i = 0; i < bodies->len; i++) {
        const TinkerAssembledBody *body = &g_array_index(bodies, TinkerAssembledBody, i);
        TinkerPlacement to = tinker_placement_of(scene, body->block);
        memcpy(to.place, body->place, sizeof to.place);
        if (body->turns) to.orientation = body->orientation;
        put(history, scene, &to);
    }
}

gboolean tinker_joined_follow(TinkerHistory *history, TinkerScene *scene, const TinkerPlacement *before, GError **error)
{
    const TinkerPlacement now = tinker_placement_of(scene, before->block);
    const TinkerHeldBody held = {now.block, is_elsewhere(&now, before), differs(now.orientation, before->orientation),
                                 FALSE};
    if (!held.place && !held.orientation) return TRUE;
    GError *cause = NULL;
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, &cause);
    if (bodies != NULL) {
        put_all(history, scene, bodies);
        return TRUE;
    }
    put(history, scene, before);
    if (tinker_joined_can_be_brought(scene, now.block)) {
        g_propagate_error(error, cause);
        return FALSE;
    }
    put(history, scene, &now); /* it did not fit before: whoever mends it by hand is not held up */
    g_error_free(cause);
    return TRUE;
}

void tinker_joined_bring(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerHeldBody held = {block, TRUE, TRUE, FALSE};
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, NULL);
    if (bodies != NULL) put_all(history, scene, bodies);
}

gboolean tinker_joined_spin(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, GError **error)
{
    const TinkerHeldBody held = {block, FALSE, FALSE, TRUE};
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, error);
    for (guint i = 0; bodies != NULL && i < bodies->len; i++) {
        const TinkerAssembledBody *body = &g_array_index(bodies, TinkerAssembledBody, i);
        if (!start_set_meaning(history, scene, body->block, TINKER_MEANING_VELOCITY, body->velocity, error) ||
            (body->turns &&
             !start_set_meaning(history, scene, body->block, TINKER_MEANING_ANGULAR_VELOCITY, &body->rate, error)))
            return FALSE;
    }
    return bodies != NULL;
}
