/* Repairs: each is what its button says, within one undo step. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/advice.h"
#include "analysis/start/joined.h"
#include "analysis/start/start-private.h"
#include "scene/history/first-size.h"

/* A place in a block's own axes. */
static gboolean to_own(TinkerScene *scene, TinkerBlockId block, const double place[2], TinkerSceneEnd *end,
                       GError **error)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    double own[2];
    if (frame == NULL) return FALSE;
    tinker_frame_to_own(frame, block, place, own);
    *end = (TinkerSceneEnd){block, own[0], own[1]};
    return TRUE;
}

/* Whether an end that is connected to this block stays where it lies: on what turns, and on a plate, whose centre may
 * be far off; of a joint on any support. */
static gboolean stays_where_it_lies(TinkerScene *scene, TinkerBlockId connector, TinkerBlockId target)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, target);
    const int32_t freedoms = block_class->physics->body->degrees_of_freedom;
    const int32_t solid = tinker_block_class_meaning_column(block_class, TINKER_MEANING_SOLID);
    if (freedoms != 0) return freedoms == 3;
    return start_is_joint(tinker_scene_block_class(scene, connector)) ||
           (solid >= 0 && tinker_scene_get(scene, target, solid) != 0);
}

/* To the centre, or at the place where the end lies. */
static gboolean connect_end(TinkerHistory *history, TinkerScene *scene, const TinkerAdvice *advice, GError **error)
{
    TinkerBlockId connector = g_array_index(advice->blocks, TinkerBlockId, 0);
    const TinkerSceneEnd loose = tinker_scene_end(scene, connector, advice->end);
    TinkerSceneEnd to = {advice->target, 0, 0};
    if (stays_where_it_lies(scene, connector, advice->target) &&
        !to_own(scene, advice->target, (const double[]){loose.x, loose.y}, &to, error))
        return FALSE;
    return tinker_history_set_end(history, connector, advice->end, to, error);
}

/* To a support of its own, which nothing lands on. */
static gboolean add_support(TinkerHistory *history, TinkerScene *scene, const TinkerAdvice *advice, GError **error)
{
    const TinkerBlockId connector = g_array_index(advice->blocks, TinkerBlockId, 0);
    const TinkerSceneEnd loose = tinker_scene_end(scene, connector, advice->end);
    const TinkerBlockId support = tinker_history_add_block(history, advice->support, NULL, error);
    const int32_t solid = advice->support->meanings[TINKER_MEANING_SOLID];
    if (support != TINKER_NO_BLOCK) tinker_first_size(history, scene, support);
    return support != TINKER_NO_BLOCK &&
           start_set_meaning(history, scene, support, TINKER_MEANING_POSITION, (const double[]){loose.x, loose.y},
                             error) &&
           (solid < 0 ||
            start_set_meaning(history, scene, support, TINKER_MEANING_SOLID, (const double[]){0}, error)) &&
           tinker_history_set_end(history, connector, advice->end, (TinkerSceneEnd){support, 0, 0}, error);
}

static gboolean set_vectors(TinkerHistory *history, TinkerScene *scene, const TinkerAdvice *advice, int32_t meaning,
                            gboolean add, GError **error)
{
    for (guint i = 0; i < advice->vectors->len; i++) {
        const TinkerAdviceVector *vector = &g_array_index(advice->vectors, TinkerAdviceVector, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, vector->block);
        int32_t column = tinker_block_class_meaning_column(block_class, meaning);
        double values[2] = {vector->x, vector->y};
        for (int32_t k = 0; add && column >= 0 && k < 2; k++)
            values[k] += tinker_scene_get(scene, vector->block, column + k);
        if (!start_set_meaning(history, scene, vector->block, meaning, values, error)) return FALSE;
        if (!isnan(vector->rate) &&
            !start_set_meaning(history, scene, vector->block, TINKER_MEANING_ANGULAR_VELOCITY, &vector->rate, error))
            return FALSE;
    }
    return TRUE;
}

/* The first one lies loose meanwhile: nothing has both ends at one place. */
static gboolean swap_ends(TinkerHistory *history, TinkerScene *scene, TinkerBlockId connector, GError **error)
{
    const TinkerSceneEnd first = tinker_scene_end(scene, connector, 0), second = tinker_scene_end(scene, connector, 1);
    const TinkerSceneEnd loose = {TINKER_NO_BLOCK, 0, 0};
    return tinker_history_set_end(history, connector, 0, loose, error) &&
           tinker_history_set_end(history, connector, 1, first, error) &&
           tinker_history_set_end(history, connector, 0, second, error);
}

static gboolean do_repair(TinkerHistory *history, TinkerScene *scene, const TinkerAdvice *advice, GError **error)
{
    switch (advice->kind) {
    case TINKER_ADVICE_DETACHED_END:
        return advice->support != NULL ? add_support(history, scene, advice, error)
                                       : connect_end(history, scene, advice, error);
    case TINKER_ADVICE_LENGTH:
        return start_set_meaning(history, scene, g_array_index(advice->blocks, TinkerBlockId, 0), TINKER_MEANING_LENGTH,
                                 &advice->length, error);
    case TINKER_ADVICE_JOINT:
        tinker_joined_bring(history, scene, advice->target);
        return TRUE;
    case TINKER_ADVICE_VELOCITY:
        return set_vectors(history, scene, advice, TINKER_MEANING_VELOCITY, FALSE, error);
    case TINKER_ADVICE_WOUND_ENDS:
        return swap_ends(history, scene, g_array_index(advice->blocks, TinkerBlockId, 0), error);
    case TINKER_ADVICE_PASSING:
        return start_set_meaning(history, scene, g_array_index(advice->blocks, TinkerBlockId, 0), TINKER_MEANING_SOLID,
                                 (const double[]){1}, error);
    case TINKER_ADVICE_OVERLAP:
        return set_vectors(history, scene, advice, TINKER_MEANING_POSITION, TRUE, error);
    default: /* without repair */
        return FALSE;
    }
}

/* The scene may have been edited since the advice was given. */
static gboolean still_stands(TinkerScene *scene, const TinkerAdvice *advice)
{
    for (guint i = 0; i < advice->blocks->len; i++) {
        TinkerBlockId block = g_array_index(advice->blocks, TinkerBlockId, i);
        if (!tinker_scene_has_block(scene, block) || tinker_scene_block_class(scene, block) == NULL) return FALSE;
    }
    if (advice->kind == TINKER_ADVICE_JOINT) return tinker_scene_has_block(scene, advice->target);
    if (advice->kind != TINKER_ADVICE_DETACHED_END) return TRUE;
    return advice->end < tinker_scene_end_count(scene, g_array_index(advice->blocks, TinkerBlockId, 0)) &&
           (advice->support != NULL ||
            (tinker_scene_has_block(scene, advice->target) && tinker_scene_block_class(scene, advice->target) != NULL));
}

gboolean tinker_advice_repair(TinkerHistory *history, TinkerScene *scene, const TinkerAdvice *advice, GError **error)
{
    if (advice->repair == NULL || !still_stands(scene, advice)) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, "%s",
                    advice->repair == NULL
                        ? _("this cannot be repaired by itself (see what the message says)")
                        : _("the scene has changed since this was found (look at what is said now)"));
        return FALSE;
    }
    tinker_history_begin(history, advice->repair, NULL);
    gboolean repaired = do_repair(history, scene, advice, error);
    if (repaired)
        tinker_history_end(history);
    else
        tinker_history_abort(history);
    return repaired;
}
