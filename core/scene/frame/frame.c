/* A frame holds a snapshot of the scene and one place per block id. "As placed" lengths are worked out once, from the
 * ends at t = 0. */
#include "scene/frame/frame.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include <tinker/shapes.h>

#include "plugin/call/process-state.h"
#include "scene/frame/batch.h"
#include "scene/frame/lanes.h"
#include "scene/frame/motions.h"
#include "scene/frame/paths.h"
#include "scene/frame/spans.h"

/* Of the symbol size: the distance of two connectors side by side. */
#define LANE_SHARE 1.2

typedef struct {
    double x, y, orientation;
} Pose;

typedef struct {
    TinkerBlockBatch *batch; /* NULL: a placeholder, or no block at all */
    int32_t row;
} Location;

/* How long a block is that is wound, as it was told when bodies had been placed so often. */
typedef struct {
    double length;
    guint64 placings;
} WoundLength;

struct _TinkerFrame {
    TinkerScene *scene;
    double time;
    GPtrArray *batches;
    int32_t limit;
    Pose *placed; /* by block id, without motions */
    Pose *poses;  /* by block id, now */
    TinkerMotions *motions;
    Location *locations;
    double *columns;      /* of the instance handed out last */
    const char **texts;   /* likewise; borrowed from the scene */
    GArray *ends;         /* likewise, of TinkerEnd */
    double symbol_size;   /* m, that instances report */
    double *lanes;        /* by block id: see lanes.h */
    GArray *wound;        /* of TinkerBlockId: what is wound on bodies */
    WoundLength *lengths; /* by block id; of other blocks unused */
    guint64 placings;     /* how often a body has been placed: what was told of lengths before holds no longer */
    TinkerPaths *paths;   /* of the blocks that leave one; NULL where there are none */
    TinkerSpans *spans;   /* of the blocks that have one; NULL where there are none */
};

static void locate(TinkerFrame *frame)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        for (int32_t row = 0; row < batch->count; row++) {
            TinkerBlockId id = batch->ids[row];
            frame->locations[id] = (Location){batch, row};
            frame->placed[id] = (Pose){tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, 0, NAN),
                                       tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, 1, NAN),
                                       tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0.0)};
            frame->poses[id] = frame->placed[id];
        }
    }
}

static gboolean stands(const TinkerFrame *frame, TinkerBlockId block)
{
    return tinker_block_class_stands(tinker_scene_block_class(frame->scene, block));
}

static void end_place(const TinkerFrame *frame, const TinkerSceneEnd *end, TinkerEnd *out)
{
    *out = (TinkerEnd){end->x, end->y, 0, 0, 0};
    if (end->block == TINKER_NO_BLOCK) return;
    const Pose *pose = &frame->poses[end->block];
    double c = cos(pose->orientation), s = sin(pose->orientation);
    *out = (TinkerEnd){pose->x + c * end->x - s * end->y, pose->y + s * end->x + c * end->y,
                       stands(frame, end->block) ? TINKER_ATTACHED_TO_SUPPORT : 1, 0, pose->orientation};
}

/* Of the path from end to end, in their order; NAN where there are not two. */
static double placed_length(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count)
{
    TinkerEnd here, next;
    if (count < 2) return NAN;
    double length = 0;
    end_place(frame, &ends[0], &here);
    for (int32_t k = 1; k < count; k++, here = next) {
        end_place(frame, &ends[k], &next);
        length += hypot(next.x - here.x, next.y - here.y);
    }
    return length;
}

/* From what the first end is on to what the second is on; NAN where there are not two. */
static double placed_angle(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count)
{
    TinkerEnd first, second;
    if (count < 2) return NAN;
    end_place(frame, &ends[0], &first);
    end_place(frame, &ends[1], &second);
    return second.angle - first.angle;
}

/* Of what the first end is on; NAN where that is not round. */
static double placed_radius(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count)
{
    if (count < 1 || ends[0].block == TINKER_NO_BLOCK) return NAN;
    return tinker_frame_meaning(frame, ends[0].block, TINKER_MEANING_RADIUS, 0, NAN);
}

/* Of the tangent from a circle about the first end to the second; 0 where there is none. */
static double placed_tangent(const TinkerFrame *frame, const TinkerSceneEnd *ends, int32_t count, double radius)
{
    const double distance = placed_length(frame, ends, count);
    return distance <= radius ? 0 : sqrt((distance - radius) * (distance + radius));
}

static gboolean is_angle(TinkerDimension d)
{
    return d.mass == 0 && d.length == 0 && d.time == 0 && d.angle == 1;
}

static double placed_value(const TinkerFrame *frame, const TinkerBlockBatch *batch, int32_t row, int32_t property)
{
    const TinkerBlockClass *block_class = batch->block_class;
    const TinkerSceneEnd *ends = &batch->end[batch->end_offsets[row]];
    const int32_t count = batch->end_offsets[row + 1] - batch->end_offsets[row];
    const int32_t round = tinker_block_class_meaning_column(block_class, TINKER_MEANING_RADIUS);
    if (block_class->properties[property].meaning == TINKER_MEANING_RADIUS) return placed_radius(frame, ends, count);
    if (is_angle(block_class->properties[property].dimension)) return placed_angle(frame, ends, count);
    return round >= 0 ? placed_tangent(frame, ends, count, batch->columns[round][row])
                      : placed_length(frame, ends, count);
}

static void resolve_placed(TinkerFrame *frame, TinkerBlockBatch *batch, int32_t property)
{
    const TinkerBlockClass *block_class = batch->block_class;
    if (property < 0 || !(block_class->properties[property].flags & TINKER_DEFAULT_AS_PLACED)) return;
    double *column = batch->columns[block_class->first_columns[property]];
    for (int32_t row = 0; row < batch->count; row++)
        if (isnan(column[row])) column[row] = placed_value(frame, batch, row, property);
}

/* Radii, which lengths go by; then lengths from end to end, and angles between two. */
static void resolve_placed_lengths(TinkerFrame *frame)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        resolve_placed(frame, batch, batch->block_class->meanings[TINKER_MEANING_RADIUS]);
        for (int32_t property = 0; property < batch->block_class->property_count; property++)
            resolve_placed(frame, batch, property);
    }
}

/* What bodies work out of their other properties where it is left out. */
static gboolean resolve_shaped(TinkerBlockBatch *batch, int32_t property, GError **error)
{
    const TinkerBlockClass *block_class = batch->block_class;
    const TinkerBody *body = block_class->physics->body;
    const int32_t first = block_class->first_columns[property];
    const int32_t width = tinker_kind_columns(block_class->properties[property].kind);
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    g_autofree double *values = g_new0(double, (gsize)width *(gsize)MAX(batch->count, 1));
    if (TINKER_CALL_BATCH(batch, "as_shaped", &view, body->as_shaped(&view, property, values)) != TINKER_OK) {
        g_autofree char *why = tinker_block_batch_refusal(batch, &view, _("its plugin refuses these properties"));
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, why);
        return FALSE;
    }
    for (int32_t row = 0; row < batch->count; row++)
        for (int32_t c = 0; c < width; c++)
            if (isnan(batch->columns[first + c][row])) batch->columns[first + c][row] = values[row * width + c];
    return TRUE;
}

static gboolean has_shape(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    return physics != NULL && physics->body != NULL && physics->body->as_shaped != NULL;
}

static gboolean resolve_all_shaped(TinkerFrame *frame, GError **error)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        const TinkerBlockClass *block_class = batch->block_class;
        for (int32_t p = 0; p < block_class->property_count; p++) {
            if (!(block_class->properties[p].flags & TINKER_DEFAULT_AS_SHAPED) || !has_shape(block_class)) continue;
            if (!resolve_shaped(batch, p, error)) return FALSE;
        }
    }
    return TRUE;
}

static gboolean move_supports(TinkerFrame *frame, GError **error)
{
    if (!tinker_motions_evaluate(frame->motions, frame->time)) {
        const char *name = tinker_scene_block_name(frame->scene, tinker_motions_failure(frame->motions));
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
                    _("%s: its motion at t = %g s is not a number (give it one that is finite at all times)"), name,
                    frame->time);
        return FALSE;
    }
    int32_t count;
    const TinkerBlockId *moved = tinker_motions_blocks(frame->motions, &count);
    for (int32_t i = 0; i < count; i++) {
        const TinkerPlace *place = tinker_motions_place(frame->motions, moved[i]);
        frame->poses[moved[i]].x = frame->placed[moved[i]].x + place->x;
        frame->poses[moved[i]].y = frame->placed[moved[i]].y + place->y;
        if (place->turns) frame->poses[moved[i]].orientation = frame->placed[moved[i]].orientation + place->angle;
    }
    return TRUE;
}

/* A motion may look into the scratch that its `prepare` fills. */
static gboolean prepare_motions(TinkerFrame *frame, GError **error)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics == NULL || physics->motion == NULL || physics->prepare == NULL) continue;
        TinkerBatch view = tinker_block_batch_view(batch, 0.0);
        if (TINKER_CALL_BATCH(batch, "prepare", &view, tinker_prepare(physics, &view)) == TINKER_OK) continue;
        g_autofree char *why = tinker_block_batch_refusal(batch, &view, _("its plugin refuses these properties"));
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, why);
        return FALSE;
    }
    return TRUE;
}

/* As placed they are as long as their properties say. */
static void list_wound(TinkerFrame *frame)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        if (tinker_block_class_is_wound(batch->block_class))
            g_array_append_vals(frame->wound, batch->ids, (guint)batch->count);
    }
    for (guint i = 0; i < frame->wound->len; i++) {
        const TinkerBlockId block = g_array_index(frame->wound, TinkerBlockId, i);
        tinker_frame_set_length(frame, block, tinker_frame_meaning(frame, block, TINKER_MEANING_LENGTH, 0, NAN));
    }
}

TinkerFrame *tinker_frame_new(TinkerScene *scene, GError **error)
{
    TinkerFrame *frame = g_new0(TinkerFrame, 1);
    frame->scene = scene;
    frame->batches = tinker_batches_new(scene, NULL);
    frame->limit = tinker_scene_id_limit(scene);
    frame->placed = g_new(Pose, MAX(frame->limit, 1));
    frame->poses = g_new(Pose, MAX(frame->limit, 1));
    for (int32_t id = 0; id < frame->limit; id++)
        frame->placed[id] = frame->poses[id] = (Pose){NAN, NAN, 0};
    frame->motions = tinker_motions_new(frame->batches);
    frame->lanes = tinker_lanes_new(scene);
    frame->paths = tinker_paths_new(scene);
    frame->spans = tinker_spans_new(scene);
    frame->locations = g_new0(Location, MAX(frame->limit, 1));
    frame->ends = g_array_new(FALSE, TRUE, sizeof(TinkerEnd));
    frame->wound = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    frame->lengths = g_new0(WoundLength, MAX(frame->limit, 1));
    locate(frame);
    int32_t widest = 1, properties = 1;
    for (guint i = 0; i < frame->batches->len; i++) {
        const TinkerBlockClass *block_class =
            ((const TinkerBlockBatch *)g_ptr_array_index(frame->batches, i))->block_class;
        widest = MAX(widest, block_class->column_count);
        properties = MAX(properties, block_class->property_count);
    }
    frame->columns = g_new0(double, widest);
    frame->texts = g_new0(const char *, properties);
    if (!resolve_all_shaped(frame, error) || !prepare_motions(frame, error) ||
        !tinker_frame_set_time(frame, 0.0, error)) {
        tinker_frame_free(frame);
        return NULL;
    }
    resolve_placed_lengths(frame);
    list_wound(frame);
    return frame;
}

void tinker_frame_free(TinkerFrame *frame)
{
    if (frame == NULL) return;
    g_ptr_array_unref(frame->batches);
    g_free(frame->placed);
    g_free(frame->poses);
    tinker_motions_free(frame->motions);
    g_free(frame->lanes);
    tinker_paths_free(frame->paths);
    tinker_spans_free(frame->spans);
    g_array_unref(frame->wound);
    g_free(frame->lengths);
    g_free(frame->locations);
    g_free(frame->columns);
    g_free(frame->texts);
    g_array_unref(frame->ends);
    g_free(frame);
}

TinkerScene *tinker_frame_scene(const TinkerFrame *frame)
{
    return frame->scene;
}

double tinker_frame_time(const TinkerFrame *frame)
{
    return frame->time;
}

gboolean tinker_frame_set_time(TinkerFrame *frame, double t, GError **error)
{
    frame->time = t;
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        if (batch->waveforms == 0) continue;
        /* A frame shows what holds from t on, so it looks just behind a break that falls on t. */
        double next = tinker_block_batch_next_break(batch, t, t + 1.0);
        tinker_block_batch_enter_piece(batch, isfinite(next) ? 0.5 * (t + next) : t + 0.5);
        tinker_block_batch_set_time(batch, t);
    }
    return move_supports(frame, error);
}

void tinker_frame_place(TinkerFrame *frame, TinkerBlockId block, double x, double y, double orientation)
{
    frame->poses[block] = (Pose){x, y, orientation};
    frame->placings++;
}

void tinker_frame_lay(TinkerFrame *frame, TinkerBlockId block, double orientation)
{
    frame->poses[block].orientation = orientation;
}

const TinkerBlockId *tinker_frame_wound(const TinkerFrame *frame, int32_t *count)
{
    *count = (int32_t)frame->wound->len;
    return (const TinkerBlockId *)(gpointer)frame->wound->data;
}

static gboolean is_wound(const TinkerFrame *frame, TinkerBlockId block)
{
    const TinkerBlockBatch *batch = block < frame->limit ? frame->locations[block].batch : NULL;
    return batch != NULL && tinker_block_class_is_wound(batch->block_class);
}

void tinker_frame_set_length(TinkerFrame *frame, TinkerBlockId block, double length)
{
    if (is_wound(frame, block)) frame->lengths[block] = (WoundLength){length, frame->placings};
}

double tinker_frame_length(const TinkerFrame *frame, TinkerBlockId block)
{
    if (!is_wound(frame, block) || frame->lengths[block].placings != frame->placings) return NAN;
    return frame->lengths[block].length;
}

void tinker_frame_centre(const TinkerFrame *frame, TinkerBlockId block, double *x, double *y, double *orientation)
{
    const Location *location = &frame->locations[block];
    *x = frame->poses[block].x;
    *y = frame->poses[block].y;
    *orientation = frame->poses[block].orientation;
    if (!isnan(*x) || location->batch == NULL) return;
    int32_t first = location->batch->end_offsets[location->row];
    int32_t count = location->batch->end_offsets[location->row + 1] - first;
    if (count == 0) return;
    *x = *y = 0;
    for (int32_t k = 0; k < count; k++) {
        TinkerEnd end;
        end_place(frame, &location->batch->end[first + k], &end);
        *x += end.x / count;
        *y += end.y / count;
    }
}

const TinkerPlace *tinker_frame_motion(const TinkerFrame *frame, TinkerBlockId block)
{
    return tinker_motions_moves(frame->motions, block) ? tinker_motions_place(frame->motions, block) : NULL;
}

void tinker_frame_to_own(const TinkerFrame *frame, TinkerBlockId block, const double place[2], double own[2])
{
    double x, y, orientation;
    tinker_frame_centre(frame, block, &x, &y, &orientation);
    const double dx = place[0] - x, dy = place[1] - y;
    own[0] = dx * cos(orientation) + dy * sin(orientation);
    own[1] = dy * cos(orientation) - dx * sin(orientation);
}

void tinker_frame_to_world(const TinkerFrame *frame, TinkerBlockId block, const double own[2], double place[2])
{
    double x, y, orientation;
    tinker_frame_centre(frame, block, &x, &y, &orientation);
    place[0] = x + own[0] * cos(orientation) - own[1] * sin(orientation);
    place[1] = y + own[0] * sin(orientation) + own[1] * cos(orientation);
}

/* The lesser side of what an end is attached to; 0 where that has no size. */
static double least_side(const TinkerFrame *frame, TinkerBlockId block)
{
    const Location *location = &frame->locations[block];
    if (location->batch == NULL) return 0;
    return fmin(tinker_block_batch_meaning(location->batch, location->row, TINKER_MEANING_WIDTH, 0, 0),
                tinker_block_batch_meaning(location->batch, location->row, TINKER_MEANING_HEIGHT, 0, 0));
}

/* Moves both ends of a connector into its lane: across the line between them, without changing its length. */
static void take_lane(TinkerFrame *frame, TinkerBlockId block, const TinkerSceneEnd *attached, TinkerInstance *instance)
{
    TinkerEnd *end = (TinkerEnd *)(void *)frame->ends->data;
    double dx = end[1].x - end[0].x, dy = end[1].y - end[0].y, length = hypot(dx, dy);
    if (!(length > 0)) return;
    double spacing = LANE_SHARE * tinker_instance_symbol_size(instance);
    for (int k = 0; k < 2; k++) {
        double side = least_side(frame, attached[k].block);
        if (side > 0) spacing = fmin(spacing, 0.5 * side);
    }
    double shift = frame->lanes[block] * spacing / length;
    for (int k = 0; k < 2; k++) {
        end[k].x -= shift * dy;
        end[k].y += shift * dx;
    }
    instance->x -= shift * dy;
    instance->y += shift * dx;
}

static void take_texts(TinkerFrame *frame, TinkerBlockId block, const TinkerBlockClass *block_class,
                       TinkerInstance *instance)
{
    for (int32_t property = 0; property < block_class->property_count; property++)
        if (block_class->properties[property].kind == TINKER_KIND_TEXT)
            frame->texts[instance->text_count++] = tinker_scene_get_text(frame->scene, block, property);
    instance->texts = frame->texts;
}

gboolean tinker_frame_instance(TinkerFrame *frame, TinkerBlockId block, TinkerInstance *instance)
{
    const Location *location = &frame->locations[block];
    *instance = (TinkerInstance){
        .struct_size = sizeof(TinkerInstance),
        .name = tinker_scene_block_name(frame->scene, block),
        .time = frame->time,
        .symbol_size = frame->symbol_size,
    };
    tinker_frame_centre(frame, block, &instance->x, &instance->y, &instance->orientation);
    if (location->batch == NULL) return FALSE;
    const TinkerBlockBatch *batch = location->batch;
    for (int32_t column = 0; column < batch->block_class->column_count; column++)
        frame->columns[column] = batch->columns[column][location->row];
    if (tinker_block_class_is_wound(batch->block_class))
        frame->columns[tinker_block_class_meaning_column(batch->block_class, TINKER_MEANING_LENGTH)] =
            tinker_frame_length(frame, block);
    int32_t first = batch->end_offsets[location->row];
    int32_t count = batch->end_offsets[location->row + 1] - first;
    g_array_set_size(frame->ends, (guint)count);
    for (int32_t k = 0; k < count; k++)
        end_place(frame, &batch->end[first + k], &g_array_index(frame->ends, TinkerEnd, k));
    instance->columns = frame->columns;
    take_texts(frame, block, batch->block_class, instance);
    instance->ends = count;
    instance->point_list_count = batch->point_list_count;
    if (batch->point_lists != NULL)
        instance->point_lists = batch->point_lists + (gsize)location->row * (gsize)batch->point_list_count;
    instance->path = tinker_paths_of(frame->paths, block, frame->time, &instance->path_count);
    instance->span = tinker_spans_of(frame->spans, block);
    instance->end = count > 0 ? (const TinkerEnd *)(void *)frame->ends->data : NULL;
    if (frame->lanes[block] != 0) take_lane(frame, block, &batch->end[first], instance);
    return TRUE;
}

gboolean tinker_frame_leaves_paths(const TinkerFrame *frame)
{
    return frame->paths != NULL;
}

void tinker_frame_note_paths(TinkerFrame *frame)
{
    int32_t count;
    const TinkerBlockId *blocks = tinker_paths_blocks(frame->paths, &count);
    if (count == 0 || frame->time <= tinker_paths_last(frame->paths)) return;
    g_autofree double *places = g_new(double, 2 * (gsize)count);
    for (int32_t i = 0; i < count; i++) {
        const Location *location = &frame->locations[blocks[i]];
        TinkerEnd end = {NAN, NAN, 0, 0};
        const int32_t first = location->batch->end_offsets[location->row];
        if (location->batch->end_offsets[location->row + 1] > first)
            end_place(frame, &location->batch->end[first], &end);
        places[2 * i] = end.x;
        places[2 * i + 1] = end.y;
    }
    tinker_paths_note(frame->paths, frame->time, places);
}

gboolean tinker_frame_has_spans(const TinkerFrame *frame)
{
    return frame->spans != NULL;
}

gboolean tinker_frame_note_spans(TinkerFrame *frame)
{
    int32_t count;
    gboolean grew = FALSE;
    const TinkerBlockId *blocks = tinker_spans_blocks(frame->spans, &count);
    for (int32_t i = 0; i < count; i++) {
        const Location *location = &frame->locations[blocks[i]];
        if (location->batch == NULL) continue;
        const int32_t first = location->batch->end_offsets[location->row];
        TinkerEnd a, b;
        if (location->batch->end_offsets[location->row + 1] < first + 2) continue;
        end_place(frame, &location->batch->end[first], &a);
        end_place(frame, &location->batch->end[first + 1], &b);
        grew |= tinker_spans_note(frame->spans, blocks[i], hypot(b.x - a.x, b.y - a.y));
    }
    return grew;
}

void tinker_frame_note_spans_of(TinkerFrame *frame, const TinkerFrame *other)
{
    int32_t count;
    const TinkerBlockId *blocks = tinker_spans_blocks(frame->spans, &count);
    for (int32_t i = 0; i < count; i++)
        tinker_spans_note(frame->spans, blocks[i], tinker_spans_of(other->spans, blocks[i]));
}

void tinker_frame_forget_spans(TinkerFrame *frame)
{
    tinker_spans_forget(frame->spans);
}

void tinker_frame_set_symbol_size(TinkerFrame *frame, double symbol_size)
{
    frame->symbol_size = symbol_size;
}

double tinker_frame_column(const TinkerFrame *frame, TinkerBlockId block, int32_t column)
{
    const Location *location = &frame->locations[block];
    return location->batch == NULL ? NAN : location->batch->columns[column][location->row];
}

double tinker_frame_meaning(const TinkerFrame *frame, TinkerBlockId block, int32_t meaning, int32_t component,
                            double otherwise)
{
    const Location *location = &frame->locations[block];
    if (location->batch == NULL) return otherwise;
    return tinker_block_batch_meaning(location->batch, location->row, meaning, component, otherwise);
}

void tinker_frame_end(const TinkerFrame *frame, TinkerSceneEnd end, double place[2])
{
    TinkerEnd at;
    end_place(frame, &end, &at);
    place[0] = at.x;
    place[1] = at.y;
}
