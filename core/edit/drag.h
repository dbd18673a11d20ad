/* Editing on the canvas: hit, drag, connect, snap. No window: whoever has one passes world coordinates. */
#ifndef TINKER_CORE_DRAG_H
#define TINKER_CORE_DRAG_H

#include "scene/frame/frame.h"
#include "scene/history/history.h"

/* What lies under a point. */
typedef struct {
    TinkerBlockId block; /* or TINKER_NO_BLOCK */
    int32_t part;        /* TINKER_PART_... of edit.h */
} TinkerHit;

/* The topmost part within `reach` (m) of the point: ends and handles before whole blocks, what is drawn later before
 * what is drawn earlier. `skip` (or TINKER_NO_BLOCK) is passed over. Fields, which have no place in the world, are not
 * hit. */
TinkerHit tinker_hit(TinkerFrame *frame, double x, double y, double reach, TinkerBlockId skip);

/* The connectable block under the point that the end of this block's type would accept, or TINKER_NO_BLOCK. */
TinkerBlockId tinker_hit_connectable(TinkerFrame *frame, TinkerBlockId connector, double x, double y, double reach);

/* The handle of one block (a selected one: only those are drawn) under the point; the block is TINKER_NO_BLOCK where
 * there is none. */
TinkerHit tinker_hit_handle(TinkerFrame *frame, TinkerBlockId block, double x, double y, double reach);

/* The nearest point of a grid. */
void tinker_snap(double grid, double *x, double *y);

/* Lays a body on the solid top that it is dropped on, so that it goes along where that is moved or turned: one whose
 * foot lies within the top's width, and whose side is less than `reach` (m) above it, or sunk into it by less than half
 * the body's height. Answers whether it lay on one then. */
gboolean tinker_snap_onto_top(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, double reach);

/* One drag, from press to release; one undo step. */
typedef struct _TinkerDrag TinkerDrag;

/* Begins to drag what was hit at (x, y). NULL where nothing was. (transfer full) */
TinkerDrag *tinker_drag_begin(TinkerHistory *history, TinkerScene *scene, TinkerHit hit, double x, double y);

/* Tells how large symbols are drawn (m; see tinker_frame_set_symbol_size): handles stand by it. */
void tinker_drag_set_symbol_size(TinkerDrag *drag, double symbol_size);

/* The pointer is at (x, y): moves the part there; with `grid` > 0 the part's own point is snapped to the grid. Answers
 * the block that releasing here would connect to (to be highlighted), or TINKER_NO_BLOCK. */
TinkerBlockId tinker_drag_to(TinkerDrag *drag, double x, double y, double grid, double reach);

/* Releases: a connector's end over a block that it accepts is connected to its centre, or, where `at_point` is set and
 * the block is not a point mass, to the point under it; a body is put onto the top that it is dropped on, see
 * tinker_snap_onto_top (`reach` of 0: it is not). Frees the drag. */
void tinker_drag_end(TinkerDrag *drag, gboolean at_point, double reach);

/* Takes everything back. Frees the drag. */
void tinker_drag_cancel(TinkerDrag *drag);

#endif
