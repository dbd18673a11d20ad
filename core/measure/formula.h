/* Formulas: expressions of quantities, worked out from the columns of a record. */
#ifndef TINKER_CORE_FORMULA_H
#define TINKER_CORE_FORMULA_H

#include "scene/store/scene-expression.h"

typedef struct _TinkerFormula TinkerFormula;

/* Reads "0.5*{Mass 0.mass}*{Mass 0.vx}^2" (scene-expression.h). The columns (TinkerColumn) that it needs are added to
 * `columns` unless they are there. Properties have the value that they have at the start. Errors begin with "column N:
 * ". (transfer full) */
TinkerFormula *tinker_formula_new(TinkerScene *scene, const char *text, GArray *columns, GError **error);
void tinker_formula_free(TinkerFormula *formula);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFormula, tinker_formula_free)

/* Its value at t, by those of the columns. */
double tinker_formula_value(const TinkerFormula *formula, double t, const double *columns);

/* How far it may be off where each column may be off by its band: to first order. NAN where a band is. */
double tinker_formula_band(const TinkerFormula *formula, double t, const double *columns, const double *bands);

/* The dimension of the value. Angles count as numbers. FALSE where none comes out, and `why` says so (transfer full;
 * may be NULL). */
gboolean tinker_formula_dimension(const TinkerFormula *formula, TinkerDimension *dimension, char **why);

/* Of a torque or an energy, which have one dimension: the unit that its quantities are shown in, of one alone, of sums
 * of such, and of their products with plain numbers. NULL for all else, as a force times a length: then it is that of
 * the dimension. Static. */
const char *tinker_formula_unit(const TinkerFormula *formula, TinkerUnitSystem system);

/* Whether it is a comparison, whose value is 1 where it holds. */
gboolean tinker_formula_is_comparison(const TinkerFormula *formula);

#endif
