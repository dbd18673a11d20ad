/* The painter's parts: what is in the picture (pieces), where its fields and labels stand. */
#ifndef TINKER_RENDER_PAINTER_PRIVATE_H
#define TINKER_RENDER_PAINTER_PRIVATE_H

#include "plugin/call/call.h"
#include "render/draw/strokes.h"
#include "render/picture/painter.h"
#include "scene/frame/drawing-order.h"

/* How a block takes part in the picture. */
typedef enum {
    TINKER_PIECE_BODY,      /* has a place */
    TINKER_PIECE_CONNECTOR, /* has ends */
    TINKER_PIECE_FIELD,     /* has neither: it is shown in a corner of the canvas */
    TINKER_PIECE_UNKNOWN,   /* of a type that nobody provides, but with a place */
} TinkerPieceKind;

/* One block, ready to be drawn. The instance's memory is the frame's: valid until the next piece is made. */
typedef struct {
    TinkerBlockId block;
    const TinkerBlockClass *block_class; /* NULL for an unknown type */
    TinkerPieceKind kind;
    TinkerInstance instance;
    double width, height; /* m, of a body */
} TinkerPiece;

/* Of the shorter side of a picture: what stays free around the world in a file. */
#define TINKER_PICTURE_MARGIN 0.08

/* A picture in the making. */
typedef struct {
    cairo_t *cairo;  /* our own, on what the caller's draws on: draw-watch.h */
    cairo_t *caller; /* the caller's */
    TinkerFrame *frame;
    const TinkerView *view;
    const TinkerPaintOptions *options;
    TinkerStyleBrush brush;
    int32_t block_count, id_limit;
    guint panels;                   /* of the options' texts, those that were there before */
    guint8 *selected;               /* by id: 1 where the options select it; NULL: none is */
    GArray *visible[TINKER_LAYERS]; /* of TinkerBlockId: what lies on the canvas, in drawing order */
    GArray *bodies;                 /* likewise: those of them with a place, in the scene's order */
    GArray *connectors; /* likewise: those of them with ends, but for those that are part of another block */
} TinkerPicture;

/* Kind and size by class and instance, which are known. */
void tinker_piece_classify(TinkerPiece *piece);

/* Looks a block up. */
void tinker_piece_init(TinkerPiece *piece, TinkerFrame *frame, TinkerBlockId block);

/* The box that the drawing stays within, m. FALSE where it is nowhere (not finite). */
gboolean tinker_piece_box(const TinkerPiece *piece, const TinkerStyle *style, double box[4]);

/* How large blocks of the scene typically are (m), by a sample; 0: unknown. Does not change while a scene moves. */
double tinker_frame_typical_size(TinkerFrame *frame);

/* A block's symbol by its own drawing, or a plain one; painter-block.c. NULL, or what it did to the context, as
 * tinker_draw_watch_end says. (transfer full) */
char *tinker_piece_draw(const TinkerPiece *piece, cairo_t *cairo, const TinkerStyle *style);

/* Draws a piece in a picture, within the world; what is broken is told and made anew. */
void tinker_picture_draw_piece(TinkerPicture *picture, const TinkerPiece *piece);

/* The title of the scene at the top of a canvas of that width (canvas units), behind what takes `left` of it. Borrows
 * the scene's. */
TinkerText tinker_picture_title(TinkerFrame *frame, double width, double left);

/* Fields, side by side in the upper left corner, each with its name beneath; painter-fields.c. Widens `corner` (least
 * and greatest x and y, canvas units) to what they take. */
void tinker_picture_draw_fields(TinkerPicture *picture, double corner[4]);

/* Widens `corner` likewise without drawing. */
void tinker_fields_corner(TinkerFrame *frame, const TinkerView *view, const TinkerPaintOptions *options,
                          double corner[4]);

/* Names beside bodies and connectors, not over boxes (of 4 numbers) that are taken already; painter-labels.c. */
void tinker_picture_draw_labels(TinkerPicture *picture, double (*taken)[4], int taken_count);
/* Whether there are so many bodies in sight that names and dots would cover all. */
gboolean tinker_picture_is_crowded(const TinkerPicture *picture);

/* TINKER_STATE_... of a block in this picture. */
uint32_t tinker_picture_state(const TinkerPicture *picture, const TinkerPiece *piece);

/* tinker_paint_scene, which also notes every text it writes in `written` (may be NULL). */
void tinker_paint_scene_noting(cairo_t *cairo, TinkerFrame *frame, const TinkerView *view,
                               const TinkerPaintOptions *options, GPtrArray *written);

#endif
