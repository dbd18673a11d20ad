/* Numbers with units as people type them into entries. No widget. */
#ifndef TINKER_GUI_NUMBER_TEXT_H
#define TINKER_GUI_NUMBER_TEXT_H

#include <glib.h>

#include "units/quantity/units.h"

/* Reads a quantity with any unit that fits; a bare number is in `unit` ("" for none). In the place of the number a
 * formula may stand, in the grammar of expressions and without t: "2*9.81", "sqrt(2) m"; and a sum of such, each with a
 * unit of its own: "6.13 m - 3 ft". Where the locale writes a comma before decimals, one comma is read as that. The
 * answer is in SI. FALSE with an error that says what would be right.
 */
gboolean tinker_number_read(const char *text, TinkerDimension dimension, const char *unit, double *si, GError **error);

/* A value as it is shown where it can be edited: five decimals and the unit, "3.20000 m"; trimmed without the zeros at
 * their end, "3.2 m". What decimals leave no three digits of, or is longer than a field, has an exponent, "1e-07 m";
 * what is below 1e-12 units, as rounding leaves of a place at 0, is shown as 0. `unit` as tinker_quantity_format takes
 * it. (transfer full) */
char *tinker_number_write(double si, TinkerDimension dimension, const char *unit, TinkerUnitSystem system,
                          gboolean trims);

/* A value with its unit, in at most so many significant digits. (transfer full) */
char *tinker_number_short(double si, const char *unit, int digits);
/* A value that was measured in a run, in the same form: what blows and rounding leave of 0, below 1e-30 in SI, is 0.
 * (transfer full) */
char *tinker_number_measured(double si, const char *unit, int digits);

#endif
