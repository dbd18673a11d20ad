/* Formulas typeset: fractions, roots, powers, indices, dots for derivatives, brackets that grow, cases.
 *
 * They come as presentation MathML, the way that equations are written for a browser: one text then serves both, and
 * what is drawn is what is copied. */
#ifndef TINKER_RENDER_FORMULA_H
#define TINKER_RENDER_FORMULA_H

#include "render/draw/text.h"

typedef struct _TinkerMathText TinkerMathText;

/* Reads and lays out; `size` is that of its letters in canvas units. Known are mrow, mi, mn, mo, mtext, mfrac, msup,
 * msub, msqrt, mover (dots above, by its ˙ or ¨), mtable, mtr, mtd; the text may be several of them in a row. Errors:
 * G_MARKUP_ERROR for what is none of these. (transfer full) */
TinkerMathText *tinker_math_text_new(const char *mathml, double size, GError **error);
void tinker_math_text_free(TinkerMathText *formula);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerMathText, tinker_math_text_free)

/* Its extent to the right of and above and below the place where it is drawn. */
void tinker_math_text_measure(const TinkerMathText *formula, double *width, double *above, double *below);

/* Draws it in the context's present colour, with its left end on the line at (x, y). */
void tinker_math_text_draw(const TinkerMathText *formula, cairo_t *cairo, double x, double y);

#endif
