/* Continuing a run: what a run has changed is written into the properties that it started from. */
#include "scene/history/continued.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "scene/store/scene-data.h"
#include "units/expression/expression-tree.h"

typedef struct {
    TinkerScene *scene; /* the copy */
    const TinkerFrame *now;
    double t;
    const double *velocities; /* vx, vy and the rate by block id */
} Continuation;

static void values_of(const Continuation *continuation, TinkerBlockId block, int32_t property, double values[2])
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    for (int32_t c = 0; c < tinker_kind_columns(block_class->properties[property].kind); c++)
        values[c] = tinker_scene_get(continuation->scene, block, block_class->first_columns[property] + c);
}

/* What equals another property by default is not to follow it to where the run has brought that. */
static gboolean fix_followers(Continuation *continuation, TinkerBlockId block, GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    for (int32_t property = 0; property < block_class->property_count; property++) {
        if (!(block_class->properties[property].flags & TINKER_DEFAULT_SAME_AS) ||
            tinker_scene_property_given(continuation->scene, block, property))
            continue;
        double values[2];
        values_of(continuation, block, property, values);
        if (!tinker_scene_set(continuation->scene, block, property, values, error)) return FALSE;
    }
    return TRUE;
}

/* Sets the property of this meaning, where there is one and it is not so already. */
static gboolean set_meaning(Continuation *continuation, TinkerBlockId block, int32_t meaning, const double *values,
                            GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    int32_t property = block_class->meanings[meaning];
    if (property < 0) return TRUE;
    double old[2];
    values_of(continuation, block, property, old);
    gboolean vector = block_class->properties[property].kind == TINKER_KIND_VECTOR;
    if (old[0] == values[0] && (!vector || old[1] == values[1])) return TRUE;
    return tinker_scene_set(continuation->scene, block, property, values, error);
}

static gboolean continue_body(Continuation *continuation, TinkerBlockId block, GError **error)
{
    const double *velocity = &continuation->velocities[3 * block];
    double place[2], orientation;
    tinker_frame_centre(continuation->now, block, &place[0], &place[1], &orientation);
    return fix_followers(continuation, block, error) &&
           set_meaning(continuation, block, TINKER_MEANING_POSITION, place, error) &&
           set_meaning(continuation, block, TINKER_MEANING_ORIENTATION, &orientation, error) &&
           set_meaning(continuation, block, TINKER_MEANING_VELOCITY, velocity, error) &&
           set_meaning(continuation, block, TINKER_MEANING_ANGULAR_VELOCITY, &velocity[2], error);
}

/* "As placed" means at the start of the run, not of its continuation. */
static gboolean fix_placed_lengths(Continuation *continuation, TinkerBlockId block, GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    for (int32_t property = 0; property < block_class->property_count; property++) {
        if (!(block_class->properties[property].flags & TINKER_DEFAULT_AS_PLACED) ||
            tinker_scene_property_given(continuation->scene, block, property))
            continue;
        double length = tinker_frame_column(continuation->now, block, block_class->first_columns[property]);
        if (isnan(length)) continue; /* an end was detached: there was no run with it */
        if (!tinker_scene_set(continuation->scene, block, property, &length, error)) return FALSE;
    }
    return TRUE;
}

/* What is wound counts from how bodies are turned at the start, which is then now. */
static gboolean set_wound_length(Continuation *continuation, TinkerBlockId block, GError **error)
{
    const double length = tinker_frame_length(continuation->now, block);
    /* Not wound; an end was detached, so that there was no run with it; or whoever placed the bodies did not tell it:
     * what the scene has is kept. */
    if (isnan(length)) return TRUE;
    return set_meaning(continuation, block, TINKER_MEANING_LENGTH, &length, error);
}

static void shift_waveforms(Continuation *continuation, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    for (int32_t property = 0; property < block_class->property_count; property++) {
        if (block_class->properties[property].kind != TINKER_KIND_WAVEFORM) continue;
        TinkerWaveform *waveform = tinker_scene_get_waveform(continuation->scene, block, property);
        g_autoptr(TinkerWaveform) shifted = tinker_waveform_shifted(waveform, continuation->t);
        if (shifted != waveform) tinker_scene_set_waveform(continuation->scene, block, property, shifted);
    }
}

/* Typed laws that depend on time. */
static void shift_laws(Continuation *continuation, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    for (int32_t property = 0; continuation->t != 0 && property < block_class->property_count; property++) {
        if ((block_class->properties[property].flags & TINKER_TEXT_LAW) == 0) continue;
        const char *law = tinker_scene_get_text(continuation->scene, block, property);
        g_autofree char *later = tinker_expression_shift_text(law, continuation->t);
        if (strcmp(law, later) != 0) tinker_scene_set_text(continuation->scene, block, property, later);
    }
}

/* What has happened by now does not happen again. */
static gboolean shift_instant(Continuation *continuation, TinkerBlockId block, GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    const int32_t property = block_class->meanings[TINKER_MEANING_INSTANT];
    if (property < 0 || continuation->t == 0) return TRUE;
    double instant = tinker_scene_get(continuation->scene, block, block_class->first_columns[property]);
    instant = instant == continuation->t ? -DBL_MIN : instant - continuation->t;
    return tinker_scene_set(continuation->scene, block, property, &instant, error);
}

static gboolean continue_block(Continuation *continuation, TinkerBlockId block, GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(continuation->scene, block);
    if (block_class == NULL) return TRUE;
    shift_waveforms(continuation, block);
    shift_laws(continuation, block);
    if (!shift_instant(continuation, block, error)) return FALSE;
    const TinkerScene *ran = tinker_frame_scene(continuation->now);
    if (!tinker_scene_has_block(ran, block) || tinker_scene_block_class(ran, block) != block_class) return TRUE;
    if (tinker_block_class_moves(block_class) && !continue_body(continuation, block, error)) return FALSE;
    return set_wound_length(continuation, block, error) && fix_placed_lengths(continuation, block, error);
}

TinkerScene *tinker_scene_continued(const TinkerScene *scene, const TinkerFrame *now, double t,
                                    const double *velocities, GError **error)
{
    g_autoptr(TinkerScene) copy = tinker_scene_copy(scene);
    for (int32_t place = 0; place < tinker_scene_block_count(copy); place++)
        if (scene_place_on(copy, tinker_scene_block_at(copy, place)) != NULL)
            scene_fix_place(copy, tinker_scene_block_at(copy, place)); /* motions go on, and would take it along */
    Continuation continuation = {copy, now, t, velocities};
    for (int32_t place = 0; place < tinker_scene_block_count(copy); place++)
        if (!continue_block(&continuation, tinker_scene_block_at(copy, place), error)) return NULL;
    return g_steal_pointer(&copy);
}
