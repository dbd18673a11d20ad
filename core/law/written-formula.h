/* Formulas as they are written in notes: "omega = sqrt(k/m_1)", as MathML. */
#ifndef TINKER_CORE_LAW_WRITTEN_FORMULA_H
#define TINKER_CORE_LAW_WRITTEN_FORMULA_H

#include <glib.h>

/* Sides in the grammar of expressions, with equals signs between them. Any name may stand in them: that of a greek
 * letter becomes the letter, and what follows a low line an index. Errors (TINKER_WAVEFORM_ERROR) are those of a side.
 * (transfer full) */
char *tinker_written_formula_mathml(const char *text, GError **error);

#endif
