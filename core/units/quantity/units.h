/* Units: a table of exact factors, and the way from text to a number in SI and back.
 *
 * A unit is a product of powers of table entries, "N/m", "lbf*s/ft", "m/s^2", "N s/m", "kg·m^2"; `/` divides by the one
 * factor behind it. A number with a unit is a decimal number, optional space, and a unit: "12 in", "-3.5 ft/s",
 * "30deg".
 */
#ifndef TINKER_CORE_UNITS_H
#define TINKER_CORE_UNITS_H

#include <glib.h>

#include <tinker/types.h>

typedef enum {
    TINKER_UNIT_SYSTEM_SI,
    TINKER_UNIT_SYSTEM_ENGLISH,
} TinkerUnitSystem;

/* A unit as read: value in SI = factor * number. */
typedef struct {
    double factor;
    TinkerDimension dimension;
} TinkerUnit;

typedef enum {
    TINKER_UNITS_ERROR_SYNTAX,    /* not a number, or not a unit */
    TINKER_UNITS_ERROR_UNKNOWN,   /* a unit that the table does not have */
    TINKER_UNITS_ERROR_DIMENSION, /* another dimension than the one that is asked for */
} TinkerUnitsError;
#define TINKER_UNITS_ERROR (tinker_units_error_quark())
GQuark tinker_units_error_quark(void);

/* Reads a unit, "lbf/ft". On failure answers FALSE with an error whose message begins with "column N: " (N counts
 * characters from 1), and which suggests the nearest unit where one is near. */
gboolean tinker_unit_parse(const char *text, TinkerUnit *unit, GError **error);

/* Reads a number with a unit, "12 in", into SI. `wanted` is the dimension that the value must have; a number without a
 * unit is accepted as SI. Errors as above; a wrong dimension names both, in words and units: "a mass (kg) was expected,
 * "12 in" is a length (m)". Rejects NaN, infinities and overflow. */
gboolean tinker_quantity_parse(const char *text, TinkerDimension wanted, double *si, GError **error);

/* The unit that values of this dimension are displayed in: "N/m" or "lbf/ft"; "" where it has none. Angles are in
 * degrees in both systems, angular velocities in rad/s. The text is static or interned. */
const char *tinker_unit_for(TinkerDimension dimension, TinkerUnitSystem system);

/* The SI symbol of a dimension made of base and derived units, "N s/m", "kg m^2/s": what headers of records show.
 * Angles are "rad" here. Interned. */
const char *tinker_unit_si_symbol(TinkerDimension dimension);

/* A unit in the spelling of files, "N s^2/m" of "N·s²/m", and as people read it, "N·s²/m" of "N*s^2/m". Interned. */
const char *tinker_unit_in_ascii(const char *unit);
const char *tinker_unit_in_print(const char *unit);

/* A value for people: `decimals` digits behind the point and the unit, "0.06852 slug". `unit` is text as
 * tinker_unit_parse takes it, or NULL for tinker_unit_for. (transfer full) */
char *tinker_quantity_format(double si, TinkerDimension dimension, const char *unit, TinkerUnitSystem system,
                             int decimals);

/* The same in at most so many significant digits, with an exponent where it is very large or small, "1e-07 m".
 * (transfer full) */
char *tinker_quantity_significant(double si, TinkerDimension dimension, const char *unit, TinkerUnitSystem system,
                                  int digits);

/* A value within a sentence or on a picture: four significant digits and the unit, "2.6 m/s". (transfer full) */
char *tinker_quantity_brief(double si, TinkerDimension dimension, TinkerUnitSystem system);

/* A force (N) or a torque (N m) beside an arrow or beneath a term: as brief, with a minus as it is printed, "−12.5
 * N·m". (transfer full) */
char *tinker_load_brief(double si, gboolean is_torque, TinkerUnitSystem system);

/* A value for a file: the shortest decimal number which, read back with its unit, gives the same bits, and the unit:
 * "12 in". Falls back to a plain SI number where no decimal does. (transfer full) */
char *tinker_quantity_to_text(double si, TinkerDimension dimension, TinkerUnitSystem system);

/* The shortest decimal text that reads back as the same double, '.' whatever the locale. `room` is at least 32. */
void tinker_number_to_text(double value, char *text, gsize room);

/* A length of time for people, in the unit that suits its size and without a power of ten: "680 ns", "49.1 µs", "0.5
 * s", "12 s" from there on. `digits` significant ones, 1 to 6. (transfer full) */
char *tinker_duration_text(double seconds, int digits);

static inline gboolean tinker_dimension_equal(TinkerDimension a, TinkerDimension b)
{
    return a.mass == b.mass && a.length == b.length && a.time == b.time && a.angle == b.angle;
}

/* What a dimension is called: "mass", "length", "stiffness", "damping"; its SI symbol where it has no name. Interned.
 */
const char *tinker_dimension_name(TinkerDimension dimension);

/* The candidate nearest to `word` by edit distance, or NULL where none is near enough for a "did you mean". Borrowed
 * from `candidates`, which ends with NULL. */
const char *tinker_nearest_word(const char *word, const char *const *candidates);

#endif
