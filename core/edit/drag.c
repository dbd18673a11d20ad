/* A drag opens its undo step with the first movement, so that a click leaves no trace. It remembers how far from the
 * part's own point the pointer took hold; each movement asks a fresh frame where that point is now and has the block's
 * own interface move it, through an editor whose calls go to the history. */
#include <math.h>

#include <tinker/shapes.h>

#include "edit/edit-private.h"
#include "edit/outline.h"
#include "scene/frame/tops.h"

#define ANGLE_SNAP (TINKER_PI / 12.0) /* rad: 15 degrees, beside the grid of places */

struct _TinkerDrag {
    TinkerHistory *history;
    TinkerScene *scene;
    TinkerHit hit;
    const TinkerBlockClass *block_class; /* NULL: a placeholder */
    double press[2];                     /* where the pointer went down */
    double grip[2];                      /* from the pointer to the part's own point */
    gboolean gripped;                    /* the grip is known */
    gboolean moved;                      /* the undo step is open */
    gboolean snaps_angles;
    double symbol_size;
    double reach; /* m: of the pointer */
    double pointer[2];
    TinkerBlockId target; /* that releasing would connect to */
};

/* The editor ------------------------------------------------------------------------------------------------------- */

/* The property that a column belongs to, or -1. */
static int32_t property_of_column(const TinkerBlockClass *block_class, int32_t column)
{
    for (int32_t i = 0; i < block_class->property_count; i++) {
        int32_t first = block_class->first_columns[i];
        if (column >= first && column < first + tinker_kind_columns(block_class->properties[i].kind)) return i;
    }
    return -1;
}

/* The nearest value that the declaration allows. */
static double held_to_range(const TinkerPropertyType *property, double value)
{
    double least = -INFINITY, greatest = INFINITY;
    if (property->flags & TINKER_HAS_MINIMUM) least = property->hard_minimum;
    if (property->flags & TINKER_HAS_MAXIMUM) greatest = property->hard_maximum;
    if (property->flags & TINKER_OPEN_MINIMUM) least = nextafter(least, INFINITY);
    if (property->flags & TINKER_OPEN_MAXIMUM) greatest = nextafter(greatest, -INFINITY);
    if (property->kind == TINKER_KIND_SWITCH) return value != 0;
    if (property->kind == TINKER_KIND_CHOICE) {
        least = 0;
        greatest = property->choice_count - 1;
    }
    if (property->kind == TINKER_KIND_INTEGER || property->kind == TINKER_KIND_CHOICE) value = round(value);
    return fmax(fmin(value, greatest), least);
}

static void editor_set(const TinkerEditor *editor, int32_t column, double value)
{
    TinkerDrag *drag = editor->context;
    int32_t number = property_of_column(drag->block_class, column);
    if (number < 0 || !isfinite(value)) return;
    const TinkerPropertyType *property = &drag->block_class->properties[number];
    if (property->kind == TINKER_KIND_WAVEFORM || (property->flags & (TINKER_READ_ONLY | TINKER_DERIVED))) return;
    int32_t first = drag->block_class->first_columns[number], count = tinker_kind_columns(property->kind);
    double values[2] = {0, 0};
    if (drag->snaps_angles &&
        column == tinker_block_class_meaning_column(drag->block_class, TINKER_MEANING_ORIENTATION))
        value = ANGLE_SNAP * round(value / ANGLE_SNAP) + 0.0;
    for (int32_t i = 0; i < MIN(count, 2); i++)
        values[i] = tinker_scene_get(drag->scene, drag->hit.block, first + i);
    values[column - first] = held_to_range(property, value);
    /* What the block refuses for another reason (one coefficient above another) stays as it is. */
    tinker_history_set(drag->history, drag->hit.block, number, values, NULL);
}

static void editor_set_end(const TinkerEditor *editor, int32_t end, double x, double y)
{
    TinkerDrag *drag = editor->context;
    if (end < 0 || end >= tinker_scene_end_count(drag->scene, drag->hit.block)) return;
    TinkerSceneEnd detached = {TINKER_NO_BLOCK, x, y};
    tinker_history_set_end(drag->history, drag->hit.block, end, detached, NULL);
}

/* The drag --------------------------------------------------------------------------------------------------------- */

static gboolean is_end(const TinkerDrag *drag)
{
    return drag->hit.part >= 0 && drag->hit.part < tinker_scene_end_count(drag->scene, drag->hit.block);
}

/* A frame of the scene as it is now; the dragged block's instance is filled. NULL where there is nothing to move. */
static TinkerFrame *look(const TinkerDrag *drag, TinkerInstance *instance)
{
    TinkerFrame *frame = tinker_frame_new(drag->scene, NULL);
    if (frame == NULL) return NULL;
    tinker_frame_set_symbol_size(frame, drag->symbol_size);
    if (drag->block_class != NULL && tinker_frame_instance(frame, drag->hit.block, instance)) return frame;
    tinker_frame_free(frame);
    return NULL;
}

/* The part's own point: an end, a handle, or the block's centre. */
static void point_of_part(const TinkerDrag *drag, const TinkerInstance *instance, double point[2])
{
    int32_t part = drag->hit.part;
    point[0] = instance->x;
    point[1] = instance->y;
    if (part >= 0 && part < instance->ends) {
        point[0] = instance->end[part].x;
        point[1] = instance->end[part].y;
    } else if (part >= TINKER_PART_HANDLE) {
        TinkerHandle handles[MOST_HANDLES];
        int32_t count = edit_handles(drag->block_class, instance, handles, MOST_HANDLES);
        for (int32_t i = 0; i < count; i++) {
            if (handles[i].part != part) continue;
            point[0] = handles[i].x;
            point[1] = handles[i].y;
        }
    }
}

/* Moves the part to where the pointer has taken its point. */
static void move_part(TinkerDrag *drag, double grid)
{
    TinkerInstance instance;
    g_autoptr(TinkerFrame) frame = look(drag, &instance);
    if (frame == NULL) return;
    double point[2];
    point_of_part(drag, &instance, point);
    if (!drag->gripped) {
        drag->grip[0] = point[0] - drag->press[0];
        drag->grip[1] = point[1] - drag->press[1];
        drag->gripped = TRUE;
    }
    double x = drag->pointer[0] + drag->grip[0], y = drag->pointer[1] + drag->grip[1];
    drag->snaps_angles = grid > 0 && drag->hit.part == TINKER_HANDLE_ROTATION;
    if (!drag->snaps_angles) tinker_snap(grid, &x, &y);
    if (!drag->moved) {
        if (x == point[0] && y == point[1]) return;
        g_autofree char *title = g_strdup_printf("Move %s", tinker_scene_block_name(drag->scene, drag->hit.block));
        tinker_history_begin(drag->history, title, NULL);
        drag->moved = TRUE;
    }
    if (drag->hit.part >= TINKER_PART_POINT && tinker_outline_is_of(drag->block_class)) {
        const double place[2] = {x, y};
        tinker_outline_move(drag->history, drag->scene, drag->hit.block, drag->hit.part - TINKER_PART_POINT, place);
        return;
    }
    const TinkerEditor editor = {sizeof editor, 0, drag, editor_set, editor_set_end};
    const TinkerEdit *edit = edit_of(drag->block_class);
    if (grid > 0)
        TINKER_CALL_VOID(edit->move_absolute(&instance, drag->hit.part, x, y, &editor), .phase = "move_absolute",
                         .block_class = edit_owner(drag->block_class), .instance = &instance);
    else
        TINKER_CALL_VOID(edit->move(&instance, drag->hit.part, x - point[0], y - point[1], &editor), .phase = "move",
                         .block_class = edit_owner(drag->block_class), .instance = &instance);
}

TinkerDrag *tinker_drag_begin(TinkerHistory *history, TinkerScene *scene, TinkerHit hit, double x, double y)
{
    if (hit.block == TINKER_NO_BLOCK || hit.part == TINKER_PART_NONE || !tinker_scene_has_block(scene, hit.block))
        return NULL;
    TinkerDrag *drag = g_new0(TinkerDrag, 1);
    *drag = (TinkerDrag){.history = history,
                         .scene = scene,
                         .hit = hit,
                         .block_class = tinker_scene_block_class(scene, hit.block),
                         .press = {x, y},
                         .pointer = {x, y},
                         .target = TINKER_NO_BLOCK};
    return drag;
}

void tinker_drag_set_symbol_size(TinkerDrag *drag, double symbol_size)
{
    drag->symbol_size = symbol_size;
}

TinkerBlockId tinker_drag_to(TinkerDrag *drag, double x, double y, double grid, double reach)
{
    if (!isfinite(x) || !isfinite(y)) return drag->target;
    drag->pointer[0] = x;
    drag->pointer[1] = y;
    drag->reach = reach;
    move_part(drag, grid);
    drag->target = TINKER_NO_BLOCK;
    if (drag->moved && is_end(drag)) {
        TinkerInstance instance;
        g_autoptr(TinkerFrame) frame = look(drag, &instance);
        if (frame != NULL) drag->target = tinker_hit_connectable(frame, drag->hit.block, x, y, reach);
    }
    return drag->target;
}

/* Of a connector whose other end is on a body that stands on the target: where the end lies along the top, as far from
 * it as that other end, so that the connector pulls and pushes along the top, the only way that the body can go. */
static gboolean place_along_top(const TinkerDrag *drag, double own[2])
{
    TinkerInstance instance;
    const int32_t other = 1 - drag->hit.part;
    if (!tinker_class_has_top(tinker_scene_block_class(drag->scene, drag->target)) ||
        tinker_scene_end_count(drag->scene, drag->hit.block) != 2)
        return FALSE;
    const TinkerBlockId body = tinker_scene_end(drag->scene, drag->hit.block, other).block;
    g_autoptr(TinkerFrame) frame = body != TINKER_NO_BLOCK && body != drag->target ? look(drag, &instance) : NULL;
    if (frame == NULL) return FALSE;
    const TinkerTop top = tinker_top_of(frame, drag->target);
    double place[2], across[2];
    if (!tinker_top_touches(frame, &top, body)) return FALSE;
    point_of_part(drag, &instance, place);
    tinker_frame_to_own(frame, drag->target, place, own);
    tinker_frame_to_own(frame, drag->target, (const double[2]){instance.end[other].x, instance.end[other].y}, across);
    own[1] = across[1];
    return TRUE;
}

/* Where the end goes, in the target's own axes: to its centre; to the point under the pointer; on a body that turns to
 * where the end lies, snapped as it is; along the top that the other end's body is on. */
static void place_on_target(const TinkerDrag *drag, gboolean at_point, double own[2])
{
    TinkerInstance instance;
    own[0] = own[1] = 0;
    if (!at_point && place_along_top(drag, own)) return;
    const TinkerBlockClass *target = tinker_scene_block_class(drag->scene, drag->target);
    const gboolean keeps = edit_keeps_places(drag->scene, drag->target);
    if (!keeps && (!at_point || target->physics->body->degrees_of_freedom == 2)) return;
    g_autoptr(TinkerFrame) frame = look(drag, &instance);
    if (frame == NULL) return;
    double place[2] = {drag->pointer[0], drag->pointer[1]};
    if (keeps && !at_point) point_of_part(drag, &instance, place);
    edit_own_place(frame, drag->target, place, at_point ? 0 : drag->reach, own);
}

static void connect_end(TinkerDrag *drag, gboolean at_point)
{
    double own[2];
    place_on_target(drag, at_point, own);
    TinkerSceneEnd to = {drag->target, own[0], own[1]};
    tinker_history_set_end(drag->history, drag->hit.block, drag->hit.part, to, NULL);
}

static gboolean is_end_of_body(const TinkerDrag *drag)
{
    TinkerInstance instance;
    g_autoptr(TinkerFrame) frame = look(drag, &instance);
    return frame != NULL && edit_is_handle_of_end(frame, drag->hit);
}

void tinker_drag_end(TinkerDrag *drag, gboolean at_point, double reach)
{
    if (drag->moved) {
        if (drag->target != TINKER_NO_BLOCK) connect_end(drag, at_point);
        if (drag->hit.part == TINKER_PART_WHOLE && reach > 0)
            tinker_snap_onto_top(drag->history, drag->scene, drag->hit.block, reach);
        if (reach > 0 && is_end_of_body(drag)) {
            const double place[2] = {drag->pointer[0] + drag->grip[0], drag->pointer[1] + drag->grip[1]};
            tinker_snap_end_onto_top(drag->history, drag->scene, drag->hit.block, place, reach);
        }
        tinker_history_end(drag->history);
    }
    g_free(drag);
}

void tinker_drag_cancel(TinkerDrag *drag)
{
    if (drag->moved) tinker_history_abort(drag->history);
    g_free(drag);
}
