/* One equation: its terms on one line, or on several where there is no room, those behind the first indented to the
 * right side. */
#ifndef TINKER_GUI_EQUATION_ROW_H
#define TINKER_GUI_EQUATION_ROW_H

#include "equations/state/model-state.h"
#include "equations/write/lines.h"
#include "gui/equation/equation-term.h"

#define TINKER_TYPE_EQUATION_ROW (tinker_equation_row_get_type())
G_DECLARE_FINAL_TYPE(TinkerEquationRow, tinker_equation_row, TINKER, EQUATION_ROW, GtkWidget)

/* `shown` in MathML, `spoken` the same line as it is read out; neither is a heading. Both are read now alone. (transfer
 * floating) */
GtkWidget *tinker_equation_row_new(TinkerDocument *document, const TinkerEquationLine *shown,
                                   const TinkerEquationLine *spoken);

/* The values beneath the terms of a body's equation, by the state now; NULL: none are shown. `tell` as for terms. */
void tinker_equation_row_show_values(TinkerEquationRow *row, const TinkerModelState *state, TinkerUnitSystem units,
                                     gboolean tell);

/* Whether it has terms on both sides. */
gboolean tinker_equation_row_is_balance(TinkerEquationRow *row);
/* Those of the terms themselves, of a line with terms on both sides; `line` has the same terms; NULL: none are shown.
 */
void tinker_equation_row_show_line_values(TinkerEquationRow *row, const TinkerEquationLine *line,
                                          TinkerUnitSystem units, gboolean tell);

/* Of a row that is a value, "m = 2 kg": the one that a line has now, which is not read out. */
void tinker_equation_row_update(TinkerEquationRow *row, const TinkerEquationLine *line);

#endif
