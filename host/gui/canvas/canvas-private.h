/* What the files of the canvas share. */
#ifndef TINKER_GUI_CANVAS_PRIVATE_H
#define TINKER_GUI_CANVAS_PRIVATE_H

#include "edit/drag.h"
#include "gui/canvas/canvas-forces.h"
#include "gui/canvas/canvas.h"

#define CANVAS_TOP   12.0 /* widget units: how near to a top a body is dropped on it */
#define CANVAS_REACH 8.0  /* widget units: how near to a thing is on it */

/* What a press with the first button has become. */
typedef enum {
    CANVAS_IDLE,
    CANVAS_DRAG,  /* of a part of one block */
    CANVAS_GROUP, /* of all that is selected */
    CANVAS_BAND,  /* around blocks that are to be selected */
} CanvasGesture;

struct _TinkerCanvas {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    gboolean show_labels, show_forces, show_trails, show_local_origins, show_grid;
    TinkerVectorChoice show_vectors;
    gboolean large;          /* what is drawn */
    gboolean follow;         /* the selected body takes the view along */
    gboolean this_body_only; /* of forces, with a body selected */
    double force_factor;     /* how much longer than usual their arrows are */

    TinkerView view;
    gboolean view_is_set;
    gboolean view_is_fitted; /* it shows `fitted`, whatever the size, until somebody looks elsewhere */
    double fitted[4], fitted_margin, fitted_above;
    guint keeping_below; /* the source that shows it below the cover */
    double covered_told; /* widget units: how much the cover took when that was told last */
    TinkerPaintMemory *memory;
    GHashTable *faults; /* of drawings, as TinkerPaintOptions has them */
    guint faults_told;  /* of them */
    guint telling;      /* the source that tells of more */
    CanvasForces *forces;
    TinkerFrame *over;     /* shown over the scene; borrowed, may be NULL */
    GArray *marked;        /* of TinkerBlockId */
    double velocity_scale; /* m per m/s, of the arrows drawn last: what the next ones keep to */

    CanvasGesture gesture;
    TinkerHit pressed;
    double press[2], pointer[2]; /* widget units */
    double grip[2];              /* where on what is dragged it was taken hold of, m in its own axes */
    gboolean moved;
    TinkerDrag *drag;
    TinkerBlockId highlighted;
    gboolean points;          /* what is pointed at, is pointed at here: a block, which shows that anyway, */
    gboolean points_at_arrow; /* or an arrow or its label */
    TinkerPointed reached;    /* what keys have come to, */
    char *reached_text;       /* and what it says, of an arrow; else NULL */
    double group_moved[2];    /* m: so far */
    double panned[2];         /* widget units: so far, with the middle button */

    GtkWidget *cover; /* over the top; weak, may be NULL */

    TinkerBlockId followed; /* TINKER_NO_BLOCK: none */
    double followed_at[2];  /* m: where it was when the view was set by it */

    TinkerBlockId placing; /* the block on its way from the palette */
};

#define CANVAS_LARGE 1.6 /* how much larger things are drawn for those who sit at the back */
static inline double canvas_magnification(const TinkerCanvas *canvas)
{
    return canvas->large ? CANVAS_LARGE : 1;
}

/* Reach in m. */
double canvas_reach(TinkerCanvas *canvas);
/* m: how near to a top a body is dropped on it */
double canvas_top_reach(TinkerCanvas *canvas);
/* The grid to snap to (m), or 0. */
double canvas_grid(TinkerCanvas *canvas, GdkModifierType modifiers);
void canvas_to_world(TinkerCanvas *canvas, double x, double y, double world[2]);
/* Tells those who cannot see the canvas: what it shows, and what is selected. */
void canvas_describe_view(TinkerCanvas *canvas);
void canvas_view_changed(TinkerCanvas *canvas);

/* Names are placed anew. canvas-fit.c. */
void canvas_renew_memory(TinkerCanvas *canvas);
/* The view of a canvas of this size (widget units): first the scene, then the same as before. canvas-fit.c. */
void canvas_set_size(TinkerCanvas *canvas, int width, int height);

/* Paints all of it and tells of drawings with faults; canvas-paint.c. */
void canvas_snapshot(TinkerCanvas *canvas, GtkSnapshot *snapshot);

/* What lies over the canvas, in units that are larger by a factor, as texts without words: what names keep clear of.
 * (transfer full) */
GPtrArray *canvas_panels(TinkerCanvas *canvas, double factor);

/* Start velocities and warning marks over the scene, clear of the panels among these texts; canvas-marks.c. */
void canvas_paint_marks(TinkerCanvas *canvas, cairo_t *cairo, TinkerFrame *frame, const TinkerTheme *theme,
                        const GPtrArray *texts);

/* From which height on the canvas can be seen (widget units): notices lie over its top. canvas-follow.c. */
double canvas_seen_from(const TinkerCanvas *canvas);

/* Marks of bodies that are out of the view; takes the view along with what is followed. canvas-follow.c. */
void canvas_paint_edge_marks(TinkerCanvas *canvas, cairo_t *cairo, TinkerFrame *frame, const TinkerTheme *theme);
void canvas_follow(TinkerCanvas *canvas);

/* Sets up gestures, controllers and keys; canvas-input.c. */
void canvas_add_input(TinkerCanvas *canvas);
/* The gesture of the primary button; canvas-drag.c. */
void canvas_add_drag(TinkerCanvas *canvas);

/* What lies under a point, fields in their corner too; canvas-hit.c. `handles`: those of what is selected come first,
 * for only they are drawn, and only of the scene as placed; that of a force can be taken while it plays. */
TinkerHit canvas_hit_at(TinkerCanvas *canvas, double x, double y, gboolean handles);
/* A force may be taken by its handle while the scene plays: what it becomes acts from then on. */
gboolean canvas_acts_at_once(TinkerCanvas *canvas, TinkerHit hit);

/* Points at an arrow that is at a place (widget units), else at the block under it; at nothing any more.
 * canvas-point.c. */
void canvas_point_at(TinkerCanvas *canvas, double x, double y, TinkerBlockId under);
void canvas_point_away(TinkerCanvas *canvas);

/* Points at what keys have come to, until they leave the canvas: a block; the arrow so many behind the last one, in the
 * order in which they are drawn, which is told (FALSE: there is none). canvas-point.c. */
void canvas_reach_block(TinkerCanvas *canvas, TinkerBlockId block);
gboolean canvas_reach_arrow(TinkerCanvas *canvas, int step);
void canvas_reach_away(TinkerCanvas *canvas);
/* Ends whatever gesture is under way without an effect. */
void canvas_cancel_gesture(TinkerCanvas *canvas);

#endif
