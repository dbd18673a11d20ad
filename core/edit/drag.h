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
 * what is drawn earlier. Fields, which have no place in the world, are not hit. */
TinkerHit tinker_hit(TinkerFrame *frame, double x, double y, double reach);

/* Whether all ends of a connector are attached and lie at one place, less than a symbol from each other, as those of a
 * pin and of a drive at its bearing. */
gboolean tinker_is_at_one_place(TinkerFrame *frame, TinkerBlockId connector);

/* What a drag takes hold of that begins at a point where this was hit: of a connector whose ends are all attached,
 * which cannot be moved itself, the topmost body under the point that can, those that it is on before others; with its
 * ends at one place, as of a drive at its bearing, else the first body of its ends that can; of a long body that a
 * joint is on, not the handle that would size it but the whole, which is moved by its end then. Everything else is
 * taken hold of itself. */
TinkerHit tinker_hit_to_drag(TinkerFrame *frame, TinkerHit hit, double x, double y, double reach);

/* The connectable block under the point that the end of this block's type would accept, or TINKER_NO_BLOCK. */
TinkerBlockId tinker_hit_connectable(TinkerFrame *frame, TinkerBlockId connector, double x, double y, double reach);

/* Whether a block is a joint: two ends that lie at one place. */
gboolean tinker_is_joint(TinkerScene *scene, TinkerBlockId block);

/* Drops a joint at a place: its ends go onto the two topmost blocks there that accept them, the first one onto the
 * lower, at the place itself, or the centre or end of a body that is within `reach` (m) of it. Ends for which there is
 * none lie there loose. Inside a step. Answers how many found one. */
int32_t tinker_joint_drop(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint, double x, double y,
                          double reach);

/* Puts a joint between two blocks, where their centres or ends are nearest to each other. Inside a step. Answers how
 * many ends found their block: where the first is refused the second stays as it is. */
int32_t tinker_joint_put_between(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint,
                                 const TinkerBlockId blocks[2]);

/* Puts a joint onto one block: at an end of a long body that no joint is at yet, best where another block lies, which
 * it then joins it to, else at the upper or the left one; at the centre of any other, or where both ends have joints.
 * Where a point mass lies there it goes to the centre of that. Inside a step. Answers how many ends found a block:
 * where the first is refused the second stays as it is, and lies beside the first where there is nothing to join it to.
 */
int32_t tinker_joint_put_on(TinkerHistory *history, TinkerScene *scene, TinkerBlockId joint, TinkerBlockId block);

/* The topmost body whose centre or an end of it lies within `reach` (m) of one of this body's, both of which turn and
 * have no joint yet; TINKER_NO_BLOCK where there is none. */
TinkerBlockId tinker_body_met(TinkerScene *scene, TinkerBlockId body, double reach);

/* The handle of one block (a selected one: only those are drawn) under the point; the block is TINKER_NO_BLOCK where
 * there is none. */
TinkerHit tinker_hit_handle(TinkerFrame *frame, TinkerBlockId block, double x, double y, double reach);

/* The nearest point of a grid. */
void tinker_snap(double grid, double *x, double *y);

/* Lays a body on the solid top that it is dropped on: one whose foot lies within the top's width, and whose side is
 * less than `reach` (m) above it, or sunk into it by less than half the body's height. A mass goes along from then on
 * where that is moved or turned; a body that turns, unless something is attached to it, is put there with a side on the
 * top. Answers whether it is on one then. */
gboolean tinker_snap_onto_top(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, double reach);

/* Leans a long body that turns, and that nothing is attached to, with the end of it that is nearer to a place (m) on
 * the solid top that this end is at, less than `reach` (m) and half its own height off: a corner of the end touches it
 * then, and so does its other end where that is within half its height of a top, as one that was put there is, of a
 * ladder on a floor and a wall. Its length gives way. Answers whether it is. */
gboolean tinker_snap_end_onto_top(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, const double place[2],
                                  double reach);

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
 * the block is not a point mass, to the point under it; on a body that turns always to that, or to its centre or an end
 * of it that is near; a body is put onto the top that it is dropped on, see
 * tinker_snap_onto_top, and the end of a long one by which it was sized onto the top there, see
 * tinker_snap_end_onto_top (`reach` of 0: it is not). Frees the drag. */
void tinker_drag_end(TinkerDrag *drag, gboolean at_point, double reach);

/* Takes everything back. Frees the drag. */
void tinker_drag_cancel(TinkerDrag *drag);

#endif
