/* The words of a formula. */
#ifndef TINKER_CONFORMANCE_FORMULA_H
#define TINKER_CONFORMANCE_FORMULA_H

#include <glib.h>

/* Whether a word appears by itself. */
gboolean kit_formula_has_word(const char *formula, const char *word);

/* The first symbol that nothing explains: it is none of `symbols` (NULL-terminated), none of mechanics' own (L, t, x1,
 * dL, vx, sin, pi, ...), and not defined by the formula itself ("..., e = L - L0"). NULL where there is none. Words of
 * four or more small letters are prose, or names of functions. (transfer full) */
char *kit_formula_unknown(const char *formula, const char *const *symbols);

#endif
