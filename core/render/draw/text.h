/* Text by Pango, the same on every surface: sizes in canvas units, no hinting, so that a text is as wide on the screen
 * as in a file. Nothing of Pango is touched before the first text is drawn. */
#ifndef TINKER_RENDER_TEXT_H
#define TINKER_RENDER_TEXT_H

#include <cairo.h>
#include <glib.h>

/* What a pen has written: the text's box on the canvas, as least and greatest x and y. */
typedef struct {
    double box[4];
    char *text;
} TinkerWrittenText;

/* Texts that have been laid out, for pens that write the same ones again and again. */
typedef struct _TinkerTextMemory TinkerTextMemory;
TinkerTextMemory *tinker_text_memory_new(void);
void tinker_text_memory_free(TinkerTextMemory *memory);

/* What it takes to write. Begin with TINKER_TEXT_PEN_INIT and end with tinker_text_pen_clear. */
typedef struct {
    void *layout;             /* PangoLayout, made at the first text */
    GPtrArray *written;       /* of TinkerWrittenText, for whoever wants to know; or NULL. Borrowed */
    TinkerTextMemory *memory; /* or NULL. Borrowed */
    GArray *apart;            /* where those that keep apart are; made at the first */
} TinkerTextPen;
#define TINKER_TEXT_PEN_INIT                                                                                           \
    {                                                                                                                  \
        NULL, NULL, NULL, NULL                                                                                         \
    }

/* What a text is written in: that of formulas has serifs, its letters are slanted. */
typedef enum { TINKER_FACE_PLAIN, TINKER_FACE_FORMULA, TINKER_FACE_LETTER } TinkerFace;

/* One text. */
typedef struct {
    const char *text; /* UTF-8; what is not is replaced */
    double size;      /* canvas units */
    TinkerFace face;
    gboolean bold;
    double limit;              /* canvas units: what is longer is cut at its end with an ellipsis; 0: none */
    gboolean keeps_end;        /* what is longer is cut in its middle, as a value stands at its end; of one line */
    int lines;                 /* where there is a limit, lines that it may be broken into; 0 and 1: one */
    double angle;              /* rad, clockwise on the canvas */
    double anchor_x, anchor_y; /* the point of the text's own box that lies at the place: 0, 0 its upper left corner */
    gboolean passing;          /* will hardly be written again: no memory keeps it */
} TinkerText;

void tinker_text_pen_clear(TinkerTextPen *pen);

/* Width and height before it is turned, canvas units. */
void tinker_text_measure(TinkerTextPen *pen, const TinkerText *text, double *width, double *height);

double tinker_text_width(TinkerTextPen *pen, const TinkerText *text);

/* How far the text takes the pen along, and how far its ink reaches above and below the line that it stands on. */
void tinker_text_measure_ink(TinkerTextPen *pen, const TinkerText *text, double *width, double *above, double *below);
/* Writes with the pen at (x, y) on the line that it stands on; anchors and angle do not matter. */
void tinker_text_draw_on_line(TinkerTextPen *pen, cairo_t *cairo, const TinkerText *text, double x, double y);

/* Writes at (x, y) in the context's present colour. */
void tinker_text_draw(TinkerTextPen *pen, cairo_t *cairo, const TinkerText *text, double x, double y);

/* Writes at the origin in the present colour, but a line or two higher or lower where it would lie on another that this
 * pen has written so. What is written at the very same place again stays with the first. */
void tinker_text_draw_apart(TinkerTextPen *pen, cairo_t *cairo, const TinkerText *text);

/* An array for TinkerTextPen.written. (transfer full) */
GPtrArray *tinker_written_texts_new(void);

/* Appends a number as people write it: "-1.5e-09" becomes "−1.5×10⁻⁹". */
void tinker_text_append_number(GString *to, const char *number);
/* Appends "10" and the exponent raised. */
void tinker_text_append_power(GString *to, int exponent);

#endif
