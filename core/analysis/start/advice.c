/* Looking a scene over: first what keeps it from being compiled, block by block; then what compiling it says. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "analysis/start/advice-private.h"
#include "analysis/start/joined.h"
#include "analysis/start/start-private.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "scene/frame/boxes.h"
#include "scene/frame/drawing-order.h"
#include "scene/frame/idle-turns.h"
#include "scene/frame/overlaps.h"
#include "scene/frame/small-wheels.h"

/* Of the canvas's width: how far a loose end may be from what it is likely meant for, about a finger's breadth of the
 * screen: what is further away was not meant. */
#define NEAR_BY 0.025

static const TinkerDimension length_dimension = TINKER_DIMENSION_LENGTH;

/* Missing types and loose ends ------------------------------------------------------------------------------------- */

static void on_placeholder(GPtrArray *all, TinkerScene *scene, TinkerBlockId block)
{
    g_autofree char *reason = tinker_scene_missing_reason(scene, block);
    char *message = g_strdup_printf("%s: %s", tinker_scene_block_name(scene, block), reason);
    advice_add_block(advice_add(all, TINKER_ADVICE_MISSING_TYPE, TRUE, message), block);
}

/* The distance of a place from a body's box, or from its rim where it is round; 0 inside. */
static double distance_from(const TinkerFrame *frame, TinkerBlockId body, const double place[2])
{
    double x, y, angle;
    tinker_frame_centre(frame, body, &x, &y, &angle);
    double c = cos(angle), s = sin(angle), dx = place[0] - x, dy = place[1] - y;
    const double radius = tinker_frame_meaning(frame, body, TINKER_MEANING_RADIUS, 0, 0);
    if (radius > 0) return fmax(hypot(dx, dy) - radius, 0);
    double across = fabs(c * dx + s * dy) - 0.5 * tinker_frame_meaning(frame, body, TINKER_MEANING_WIDTH, 0, 0);
    double up = fabs(c * dy - s * dx) - 0.5 * tinker_frame_meaning(frame, body, TINKER_MEANING_HEIGHT, 0, 0);
    return hypot(fmax(across, 0), fmax(up, 0));
}

static gboolean has_end_on(TinkerScene *scene, TinkerBlockId connector, TinkerBlockId target)
{
    for (int32_t e = 0; e < tinker_scene_end_count(scene, connector); e++)
        if (tinker_scene_end(scene, connector, e).block == target) return TRUE;
    return FALSE;
}

/* The nearest block that an end of the connector accepts and that it is not on yet, within `reach`; of those that lie
 * under the place the one that is drawn above the others, which an end that is dropped there goes to. */
static TinkerBlockId nearest_target(const TinkerFrame *frame, TinkerBlockId connector, const double place[2],
                                    double reach)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, connector);
    TinkerBlockId nearest = TINKER_NO_BLOCK;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        if (!tinker_block_class_accepts(block_class, tinker_scene_block_class(scene, block))) continue;
        double distance = distance_from(frame, block, place);
        if (!(distance <= reach) || has_end_on(scene, connector, block)) continue;
        if (distance == reach && nearest != TINKER_NO_BLOCK &&
            tinker_frame_layer(frame, block) < tinker_frame_layer(frame, nearest))
            continue;
        reach = distance;
        nearest = block;
    }
    return nearest;
}

/* A type of supports that the connector's ends accept; NULL: there is none. */
static const TinkerBlockClass *support_for(TinkerScene *scene, const TinkerBlockClass *connector)
{
    if ((connector->type->end_accepts & TINKER_ACCEPTS_SUPPORT) == 0) return NULL;
    TinkerCatalogue *catalogue = tinker_scene_catalogue(scene);
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue), types = tinker_libraries_types(libraries);
    for (guint i = 0; i < types->len; i++) {
        const TinkerTypeEntry *entry = g_ptr_array_index(types, i);
        if (g_strcmp0(entry->category, TINKER_CONNECTABLE) != 0) continue;
        const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, entry->id, NULL);
        if (tinker_block_class_stands(block_class)) return block_class;
    }
    return NULL;
}

/* Whether another end of the connector is on what moves: what holds nothing needs no support. */
static gboolean holds_something(TinkerScene *scene, TinkerBlockId connector)
{
    for (int32_t e = 0; e < tinker_scene_end_count(scene, connector); e++) {
        const TinkerBlockId block = tinker_scene_end(scene, connector, e).block;
        if (block != TINKER_NO_BLOCK && start_can_move(scene, block)) return TRUE;
    }
    return FALSE;
}

static void on_loose_ends(GPtrArray *all, const TinkerFrame *frame, TinkerBlockId block)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    for (int32_t e = 0; e < tinker_scene_end_count(scene, block); e++) {
        TinkerSceneEnd end = tinker_scene_end(scene, block, e);
        if (end.block != TINKER_NO_BLOCK) continue;
        TinkerAdvice *advice = advice_add(
            all, TINKER_ADVICE_DETACHED_END, TRUE,
            g_strdup_printf(_("%s: end %d is not connected (attach it to a block; nothing runs while an end is loose)"),
                            tinker_scene_block_name(scene, block), e + 1));
        advice_add_block(advice, block);
        advice->end = e;
        advice->target =
            nearest_target(frame, block, (double[]){end.x, end.y}, NEAR_BY * tinker_scene_head(scene)->canvas_width);
        if (advice->target != TINKER_NO_BLOCK)
            advice->repair = g_strdup_printf(_("Connect it to %s"), tinker_scene_block_name(scene, advice->target));
        else if (holds_something(scene, block))
            advice->support = support_for(scene, tinker_scene_block_class(scene, block));
        if (advice->support != NULL) advice->repair = g_strdup(_("Add a support there"));
    }
}

/* Lengths and plates ----------------------------------------------------------------------------------------------- */

static void on_length(GPtrArray *all, const TinkerFrame *frame, TinkerBlockId block)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (!start_keeps_length(block_class)) return;
    TinkerSceneEnd first = tinker_scene_end(scene, block, 0), second = tinker_scene_end(scene, block, 1);
    if (first.block == TINKER_NO_BLOCK || second.block == TINKER_NO_BLOCK) return;
    double length = tinker_frame_meaning(frame, block, TINKER_MEANING_LENGTH, 0, NAN);
    double drawn = start_distance(frame, first, second);
    double excess = start_is_rigid(block_class) ? fabs(drawn - length) : drawn - length;
    if (!(excess > START_FITS * length)) return;
    g_autofree char *given = start_quantity_text(scene, length, length_dimension);
    g_autofree char *apart = start_quantity_text(scene, drawn, length_dimension);
    TinkerAdvice *advice = advice_add(
        all, TINKER_ADVICE_LENGTH, TRUE,
        g_strdup_printf(
            _("%s: its length is %s, but its ends are %s apart at the start (move an end, or change the length)"),
            tinker_scene_block_name(scene, block), given, apart));
    advice_add_block(advice, block);
    advice->length = drawn;
    if (drawn > 0) advice->repair = g_strdup(_("Use the length as drawn"));
}

static void on_overlap(GPtrArray *all, TinkerScene *scene, const TinkerOverlap *overlap)
{
    g_autofree char *depth = start_quantity_text(scene, overlap->depth, length_dimension);
    TinkerAdvice *advice =
        advice_add(all, TINKER_ADVICE_OVERLAP, FALSE,
                   g_strdup_printf(_("%s starts %s below the top of %s, and so passes it as from behind (it would have "
                                     "to start on the top or in front of it)"),
                                   tinker_scene_block_name(scene, overlap->body), depth,
                                   tinker_scene_block_name(scene, overlap->plate)));
    advice_add_block(advice, overlap->body);
    advice_add_block(advice, overlap->plate);
    advice_add_vector(advice, overlap->body, overlap->depth * overlap->normal[0], overlap->depth * overlap->normal[1],
                      NAN);
    advice->repair = g_strdup_printf(_("Move it out by %s"), depth);
}

/* Those that are not told of one by one: the bodies are what it is about. They take their turn when the first are
 * mended. */
static void on_more_overlaps(GPtrArray *all, const GArray *overlaps)
{
    const guint more = overlaps->len - TINKER_OVERLAPS_TOLD;
    TinkerAdvice *advice =
        advice_add(all, TINKER_ADVICE_OVERLAP, FALSE,
                   g_strdup_printf(
                       g_dngettext(GETTEXT_PACKAGE,
                                   "and %u more starts below the top of a support, and so passes it as from behind",
                                   "and %u more start below the top of a support, and so pass it as from behind", more),
                       more));
    for (guint i = TINKER_OVERLAPS_TOLD; i < overlaps->len; i++)
        advice_add_block(advice, g_array_index(overlaps, TinkerOverlap, i).body);
}

static void on_overlaps(GPtrArray *all, const TinkerFrame *frame)
{
    g_autoptr(GArray) overlaps = tinker_overlaps_new(frame);
    for (guint i = 0; i < MIN(overlaps->len, TINKER_OVERLAPS_TOLD); i++)
        on_overlap(all, tinker_frame_scene(frame), &g_array_index(overlaps, TinkerOverlap, i));
    if (overlaps->len > TINKER_OVERLAPS_TOLD) on_more_overlaps(all, overlaps);
}

static void on_meeting(GPtrArray *all, const TinkerFrame *frame)
{
    const double duration = tinker_scene_head(tinker_frame_scene(frame))->run.duration;
    TinkerMeeting meeting;
    char *warning = tinker_boxes_warning(frame, duration, &meeting);
    if (warning == NULL) return;
    TinkerAdvice *advice = advice_add(all, TINKER_ADVICE_MEETING, FALSE, warning);
    advice_add_block(advice, meeting.first);
    advice_add_block(advice, meeting.second);
}

static gboolean is_round(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = block != TINKER_NO_BLOCK ? tinker_scene_block_class(scene, block) : NULL;
    return block_class != NULL && block_class->meanings[TINKER_MEANING_RADIUS] >= 0;
}

/* What is wound on its first end and has no radius of its own. */
static void on_wound_ends(GPtrArray *all, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (block_class == NULL || !tinker_block_class_is_wound(block_class)) return;
    const int32_t radius = tinker_block_class_meaning_column(block_class, TINKER_MEANING_RADIUS);
    const TinkerBlockId on[2] = {tinker_scene_end(scene, block, 0).block, tinker_scene_end(scene, block, 1).block};
    if (!isnan(tinker_scene_get(scene, block, radius)) || on[0] == TINKER_NO_BLOCK || is_round(scene, on[0]) ||
        !is_round(scene, on[1]))
        return;
    TinkerAdvice *advice = advice_add(
        all, TINKER_ADVICE_WOUND_ENDS, TRUE,
        g_strdup_printf(_("%s: it is wound on what its first end is on, but %s is not round (swap its ends, so that "
                          "the first is on %s)"),
                        tinker_scene_block_name(scene, block), tinker_scene_block_name(scene, on[0]),
                        tinker_scene_block_name(scene, on[1])));
    advice_add_block(advice, block);
    advice->repair = g_strdup(_("Swap its ends"));
}

static void on_small_wheels(GPtrArray *all, TinkerScene *scene)
{
    g_autoptr(GArray) wheels = tinker_small_wheels_of(scene);
    for (guint i = 0; i < wheels->len; i++) {
        const TinkerSmallWheel *wheel = &g_array_index(wheels, TinkerSmallWheel, i);
        if (!wheel->is_round) continue;
        TinkerAdvice *advice = advice_add(all, TINKER_ADVICE_SMALL_WHEEL, FALSE, tinker_small_wheel_text(scene, wheel));
        advice_add_block(advice, wheel->over);
        advice_add_block(advice, wheel->body);
    }
}

static void on_idle_turns(GPtrArray *all, TinkerScene *scene)
{
    g_autoptr(GArray) idle_turns = tinker_idle_turns_of(scene);
    for (guint i = 0; i < idle_turns->len; i++) {
        const TinkerIdleTurn *idle = &g_array_index(idle_turns, TinkerIdleTurn, i);
        TinkerAdvice *advice = advice_add(all, TINKER_ADVICE_IDLE_TURN, FALSE, tinker_idle_turn_text(scene, idle));
        advice_add_block(advice, idle->by);
        advice_add_block(advice, idle->body);
    }
}

/* The model -------------------------------------------------------------------------------------------------------- */

/* The model's messages begin with the names of the blocks at fault, "Rod 0, Rod 1: ...". */
static void add_named_blocks(TinkerAdvice *advice, TinkerScene *scene)
{
    const char *colon = strstr(advice->message, ": ");
    if (colon == NULL) return;
    g_autofree char *names = g_strndup(advice->message, (gsize)(colon - advice->message));
    g_auto(GStrv) parts = g_strsplit(names, ", ", -1);
    for (char **part = parts; *part != NULL; part++) {
        TinkerBlockId block = tinker_scene_find_block(scene, *part);
        if (block != TINKER_NO_BLOCK) advice_add_block(advice, block);
    }
}

/* Where it is a joint that does not fit, its bodies can be moved. */
static void offer_to_assemble(TinkerAdvice *advice, TinkerScene *scene)
{
    if (advice->blocks->len == 0) return;
    const TinkerBlockId joint = g_array_index(advice->blocks, TinkerBlockId, 0);
    if (!start_is_joint(tinker_scene_block_class(scene, joint))) return;
    const TinkerBlockId ends[2] = {tinker_scene_end(scene, joint, 0).block, tinker_scene_end(scene, joint, 1).block};
    if (!tinker_joined_can_be_brought(scene, ends[0])) return;
    advice->kind = TINKER_ADVICE_JOINT;
    advice->target = ends[0];
    advice->repair = g_strdup_printf(_("Bring %s and %s together"), tinker_scene_block_name(scene, ends[0]),
                                     tinker_scene_block_name(scene, ends[1]));
}

static void on_model(GPtrArray *all, const TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    if (model != NULL) {
        advice_on_velocities(all, frame, model);
        return;
    }
    TinkerAdvice *advice = advice_add(all, TINKER_ADVICE_MODEL, TRUE, g_strdup(error->message));
    add_named_blocks(advice, scene);
    offer_to_assemble(advice, scene);
}

GPtrArray *tinker_advice_new(TinkerScene *scene)
{
    GPtrArray *all = advice_array_new();
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, &error);
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        if (tinker_scene_block_class(scene, block) == NULL)
            on_placeholder(all, scene, block);
        else if (frame != NULL)
            on_loose_ends(all, frame, block);
    }
    if (frame == NULL) {
        add_named_blocks(advice_add(all, TINKER_ADVICE_MODEL, TRUE, g_strdup(error->message)), scene);
        return all;
    }
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        on_length(all, frame, tinker_scene_block_at(scene, i));
        on_wound_ends(all, scene, tinker_scene_block_at(scene, i));
    }
    if (all->len == 0) on_model(all, frame); /* which would say the first of these again */
    on_overlaps(all, frame);
    advice_on_passing(all, frame);
    on_small_wheels(all, scene);
    on_idle_turns(all, scene);
    on_meeting(all, frame);
    return all;
}
