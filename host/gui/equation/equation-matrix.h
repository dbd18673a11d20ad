/* A matrix entry by entry, in brackets: each entry has its terms, which light up, are reached by keys and have values.
 */
#ifndef TINKER_GUI_EQUATION_MATRIX_H
#define TINKER_GUI_EQUATION_MATRIX_H

#include "equations/write/lines.h"
#include "gui/equation/equation-term.h"

#define TINKER_TYPE_EQUATION_MATRIX (tinker_equation_matrix_get_type())
G_DECLARE_FINAL_TYPE(TinkerEquationMatrix, tinker_equation_matrix, TINKER, EQUATION_MATRIX, GtkWidget)

/* As equation rows; both lines have a matrix. (transfer floating) */
GtkWidget *tinker_equation_matrix_new(TinkerDocument *document, const TinkerEquationLine *shown,
                                      const TinkerEquationLine *spoken);

/* The value of each entry, beneath all of its terms; `line` has the same terms; NULL: none are shown. */
void tinker_equation_matrix_show_values(TinkerEquationMatrix *matrix, const TinkerEquationLine *line,
                                        TinkerUnitSystem units, gboolean tell);

/* Terms in a list of them, beneath which their values are shown, or not; beneath several that make up one their sum. */
void tinker_equation_terms_show_values(GtkWidget *first, const GArray *terms, TinkerUnitSystem units, gboolean tell);

#endif
