/* Arrows of forces over a picture of a scene: a free-body diagram where the bodies are. */
#ifndef TINKER_CORE_ARROWS_H
#define TINKER_CORE_ARROWS_H

#include <cairo.h>
#include <glib.h>

#include "render/draw/theme.h"
#include "render/draw/view.h"

/* What an arrow means, which its colour tells. */
typedef enum {
    TINKER_ARROW_FIELD,
    TINKER_ARROW_NORMAL,
    TINKER_ARROW_FRICTION,
    TINKER_ARROW_CONNECTOR,
    TINKER_ARROW_CONSTRAINT,
    TINKER_ARROW_APPLIED,
    TINKER_ARROW_MOTION,       /* no force: a velocity, */
    TINKER_ARROW_ACCELERATION, /* or an acceleration */
    TINKER_ARROW_NET,          /* the sum of all forces on a body */
} TinkerArrowKind;
#define TINKER_ARROW_KINDS (TINKER_ARROW_NET + 1)

/* Borrowed. */
const double *tinker_arrow_colour(const TinkerTheme *theme, TinkerArrowKind kind);

/* How an arrow differs from others, as flags. */
#define TINKER_ARROW_BROKEN (1u << 0) /* longer than it is drawn: a gap in the shaft */
#define TINKER_ARROW_STUB   (1u << 1) /* shorter than it is drawn: a ring at its start */
#define TINKER_ARROW_FADED  (1u << 2) /* others are what is looked at */
#define TINKER_ARROW_PUSHES (1u << 3) /* ends where it acts: the label stands at its start */

/* One force. */
typedef struct {
    double x, y;       /* m: where it acts, in the world; the arrow starts there, or ends where it pushes */
    double fx, fy;     /* N */
    const char *label; /* UTF-8, beside the arrow's head: "Spring 0 12.3 N". NULL: none. Borrowed */
    TinkerArrowKind kind;
    guint look; /* TINKER_ARROW_... */
} TinkerForceArrow;

/* Where one was drawn, canvas units. */
typedef struct {
    gsize number;    /* of the arrow */
    double shaft[4]; /* from its start to its head */
    double label[4]; /* the box, least and greatest x and y; all 0 where it has none */
} TinkerArrowPlace;

typedef struct {
    const TinkerTheme *theme;
    double scale; /* m per N */
    const double (
        *taken)[4]; /* boxes of the canvas (least and greatest x and y) that labels keep clear of; may be NULL */
    int taken_count;
    const double (*drawn)[4]; /* likewise, of drawings that labels keep clear of where there is room; may be NULL */
    int drawn_count;
    gboolean roomy; /* there is room around the arrows: labels go farther off before they cover a drawing, and are cut
                       later */
    double reach;   /* canvas units: how far from its head a label may go where there is room; 0: anywhere */
    GArray
        *places; /* of TinkerArrowPlace: receives those that show, the strongest first; NULL: nobody asks. Borrowed */
} TinkerArrowOptions;

/* A round scale (m per N; 1, 2 or 5 times a power of ten) at which the longest arrow is about a tenth of the view's
 * longer side. `previous` (0: none) is answered as long as it is within a factor of 3 of that, so that arrows of forces
 * that change do not jump. Forces that are 0 or not finite do not count. */
double tinker_arrows_scale(const TinkerForceArrow *arrows, gsize count, const TinkerView *view, double previous);

/* Draws the arrows and then their labels, those of the greatest forces first. A label stands by the head of its arrow
 * and inside the picture; one that could only stand on another is left out; where there is room it goes over a
 * drawing before that. Arrows that would lie along each other are drawn side by side. What is too short to be seen, not
 * finite or out of the picture is passed over. The context's own units are the view's canvas units. */
void tinker_arrows_draw(cairo_t *cairo, const TinkerView *view, const TinkerForceArrow *arrows, gsize count,
                        const TinkerArrowOptions *options);

/* One kind, in a word. */
typedef struct {
    TinkerArrowKind kind;
    const char *word; /* borrowed */
} TinkerArrowWord;

/* How long an arrow is. */
typedef struct {
    double length;        /* canvas units */
    const char *label;    /* of what is so long: "5 N". Borrowed */
    const double *colour; /* of the line; borrowed. NULL: the text's */
} TinkerArrowLength;

/* What the key beside the arrows says: how long they are, how far apart in time marks on paths are, and what the
 * colours mean. */
typedef struct {
    const TinkerArrowLength *lengths; /* one a scale. Borrowed */
    gsize length_count;
    const char *marks;            /* the time from one mark to the next, "0.2 s"; NULL: there are none. Borrowed */
    const TinkerArrowWord *words; /* borrowed */
    gsize word_count;
} TinkerArrowKey;

/* A value for the key: 1, 2 or 5 times a power of ten of the unit, whose arrow is 24 to 60 canvas units long at this
 * scale (m per value of 1); 0 where there is none. */
double tinker_arrows_key_value(const TinkerView *view, double scale, double unit);

/* The box it takes in the view (canvas units), for labels to keep clear of; FALSE where it is empty. */
gboolean tinker_arrows_key_box(const TinkerView *view, const TinkerTheme *theme, const TinkerArrowKey *key,
                               double box[4]);

/* Draws it in the lower left corner of the view, without the words where it would take more than a third of the height;
 * where it would be empty, nothing. `written`: receives what it wrote (TinkerWrittenText), or NULL. */
void tinker_arrows_draw_key(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, const TinkerArrowKey *key,
                            GPtrArray *written);

#endif
