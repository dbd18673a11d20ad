/* Tinker SDK: the render interface, "tinker.render/1".
 *
 * A block draws itself in world coordinates (m, y up) with the helpers of the style, so that a drawing is short, all
 * blocks look alike, and the same code serves the screen, PNG, SVG and PDF. A block that wants more draws on the
 * context itself and links to cairo; the helpers alone need no library. A connector that offers no drawing is drawn by
 * the host as a plain line, any other block as a labelled box.
 */
#ifndef TINKER_RENDER_H
#define TINKER_RENDER_H

#include "instance.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_RENDER_INTERFACE "tinker.render/1"

struct _cairo; /* cairo_t: a typedef of our own would clash with cairo's in C99 */

/* Colours by meaning; the theme decides what they look like. */
#define TINKER_COLOUR_BODY        0 /* fill of a body */
#define TINKER_COLOUR_BODY_EDGE   1 /* its outline */
#define TINKER_COLOUR_SUPPORT     2 /* fill of a support */
#define TINKER_COLOUR_CONNECTOR   3 /* a connector that is neither compressed nor stretched */
#define TINKER_COLOUR_COMPRESSED  4
#define TINKER_COLOUR_STRETCHED   5
#define TINKER_COLOUR_DETACHED    6
#define TINKER_COLOUR_SELECTED    7
#define TINKER_COLOUR_HIGHLIGHTED 8
#define TINKER_COLOUR_WARNING     9
#define TINKER_COLOUR_FORCE       10 /* arrows of applied forces */
#define TINKER_COLOUR_MOTION      11 /* arrows of prescribed motions */
#define TINKER_COLOUR_FIELD       12 /* arrows of fields */
#define TINKER_COLOUR_TEXT        13
#define TINKER_COLOUR_COUNT       14

/* States of the drawn block, as flags. The helpers heed them: a detached connector is grey and dashed whatever colour
 * the block asks for. */
#define TINKER_STATE_DETACHED    (1u << 0)
#define TINKER_STATE_SELECTED    (1u << 1)
#define TINKER_STATE_HIGHLIGHTED (1u << 2)

/* The drawing's surroundings and its helpers. Lengths are in m; `pixel` is the length of one device pixel in m.
 * Every helper takes the style it belongs to and draws at once. */
typedef struct TinkerStyle {
    uint32_t struct_size;
    uint32_t state; /* TINKER_STATE_... */
    double pixel;
    double line_width;  /* m: the ordinary line */
    double symbol_size; /* m: the size of coils, arrow heads and end marks that suits the scene */
    double view[4];     /* least x, least y, greatest x, greatest y of what is visible, m */
    /* world to canvas: X = transform[0] x + transform[1] y + transform[2], Y = transform[3] x + ... */
    double transform[6];
    double colours[TINKER_COLOUR_COUNT][4]; /* red, green, blue, alpha, 0 to 1 */
    void *context;                          /* the host's own */

    /* A straight line. */
    void (*line)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1, double x2,
                 double y2);
    /* A filled and outlined rectangle about its centre; width and height 0: a dot. */
    void (*box)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge, double x, double y,
                double width, double height, double orientation);
    /* Short slanted strokes on the right-hand side of the line from 1 to 2: the mark of a fixed surface. */
    void (*hatch)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1,
                  double x2, double y2);
    /* A coil between two points whose number of turns follows from `rest_length`, so that it looks denser when
     * compressed and wider when stretched. */
    void (*coil)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1, double x2,
                 double y2, double rest_length);
    /* A dashpot between two points. */
    void (*dashpot)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1,
                    double x2, double y2);
    /* A rod between two points: a bar of some thickness. */
    void (*bar)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1, double x2,
                double y2);
    /* An arrow from 1 to 2; shorter than its head it is drawn as the head alone. */
    void (*arrow)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1,
                  double x2, double y2);
    /* The mark of a connector's end: a red cross where it is attached, a ring where it is not. */
    void (*end_mark)(const struct TinkerStyle *style, struct _cairo *cairo, double x, double y, int32_t attached);
    /* A circle, filled unless fill is -1, outlined unless edge is -1. */
    void (*circle)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge, double x,
                   double y, double radius);
    /* Upright text about the point, 12 pixels high at any zoom. The texts of a picture keep apart: one that would lie
     * on another, of whatever block, that was written before it is moved a line down or up, or two, where there is
     * room. A text at the very point of one before it lies over that. */
    void (*text)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x, double y,
                 const char *text);
    /* A thin line through `count` points, given as x, y, x, y, ...: however many there are, it is drawn at once. */
    void (*polyline)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, const double *points,
                     int32_t count);
    /* A polygon with these corners, filled unless fill is -1, outlined unless edge is -1. */
    void (*polygon)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge,
                    const double *points, int32_t count);
    /* A note about the point, in upright letters of this height (m): its lines end with a line feed, or with "\n" as
     * two signs, and begin below one another; what stands between two dollar signs is a formula in the grammar of
     * expressions, "$F = -k*x$", set with fractions, roots and powers, greek letters by their names. */
    void (*note)(const struct TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x, double y,
                 double height, const char *text);
} TinkerStyle;

typedef struct TinkerRender {
    uint32_t struct_size;
    int32_t layer; /* 0, the lowest: supports (over bodies where not solid), 1 bodies, 2 connectors, 3 forces, fields */
    /* Required. */
    void (*draw)(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style);
    /* The box that the drawing stays within: least x, least y, greatest x, greatest y, m. NULL: the box about the
     * ends or about the body's size. */
    void (*bounds)(const TinkerInstance *instance, const TinkerStyle *style, double box[4]);
} TinkerRender;

#ifdef __cplusplus
}
#endif
#endif
