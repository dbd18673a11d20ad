/* Numbers and quantities as text: for people with a fixed number of decimals, for files with as few digits as give the
 * same bits back. The decimal point is '.' in every locale. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "units/quantity/units-private.h"

#define MOST_DECIMALS 20
#define FIXED_ROOM    (DBL_MAX_10_EXP + MOST_DECIMALS + 8) /* "-", all digits of DBL_MAX, ".", decimals */

static void print_digits(double value, int digits, char *text, gsize room)
{
    char format[8];
    g_snprintf(format, sizeof format, "%%.%dg", digits);
    g_ascii_formatd(text, (int)room, format, value);
}

/* The unit's factor; 1 for what is no unit of this dimension, so that the number is at least right in SI. */
static double factor_of(const char *unit, TinkerDimension dimension, const char **shown)
{
    TinkerUnit read;
    if (tinker_unit_parse(unit, &read, NULL) && tinker_dimension_equal(read.dimension, dimension)) {
        *shown = unit;
        return read.factor;
    }
    *shown = tinker_unit_si_symbol(dimension);
    return 1;
}

/* Next to a power of two the doubles below lie twice as close as those above, and the shortest number that reads back
 * may not be the nearest of its length but the one above it. Counts the last of 16 digits up; TRUE where it reads back.
 */
static gboolean print_digits_above(double value, char *text, gsize room)
{
    int exponent;
    if (fabs(frexp(value, &exponent)) != 0.5) return FALSE;
    g_ascii_formatd(text, (int)room, "%.15e", value);
    char *digit = strchr(text, 'e') - 1;
    if (*digit == '9') return FALSE;
    (*digit)++;
    const double above = g_ascii_strtod(text, NULL);
    if (above != value) return FALSE;
    g_autofree char *mantissa = g_strndup(text, (gsize)(digit + 1 - text));
    const int power = (int)g_ascii_strtoll(digit + 2, NULL, 10);
    g_snprintf(text, room, "%se%+03d", mantissa, power);
    return TRUE;
}

/* A zero has no sign for people. */
static char *number_with_unit(const char *number, const char *unit)
{
    const char *digits = number;
    if (*digits == '-' && strspn(digits + 1, "0.") == strlen(digits + 1)) digits++;
    return *unit != '\0' ? g_strdup_printf("%s %s", digits, unit) : g_strdup(digits);
}

char *tinker_quantity_format(double si, TinkerDimension dimension, const char *unit, TinkerUnitSystem system,
                             int decimals)
{
    const char *shown;
    const double factor = factor_of(unit != NULL ? unit : tinker_unit_for(dimension, system), dimension, &shown);

    char format[8];
    char number[FIXED_ROOM];
    g_snprintf(format, sizeof format, "%%.%df", CLAMP(decimals, 0, MOST_DECIMALS));
    g_ascii_formatd(number, sizeof number, format, si / factor);
    return number_with_unit(number, shown);
}

char *tinker_quantity_significant(double si, TinkerDimension dimension, const char *unit, TinkerUnitSystem system,
                                  int digits)
{
    const char *shown;
    const double factor = factor_of(unit != NULL ? unit : tinker_unit_for(dimension, system), dimension, &shown);
    char number[G_ASCII_DTOSTR_BUF_SIZE], format[8];
    g_snprintf(format, sizeof format, "%%.%dg", CLAMP(digits, 1, DBL_DECIMAL_DIG));
    return number_with_unit(g_ascii_formatd(number, sizeof number, format, si / factor), shown);
}

char *tinker_quantity_brief(double si, TinkerDimension dimension, TinkerUnitSystem system)
{
    return tinker_quantity_significant(si, dimension, NULL, system, 4);
}

char *tinker_load_brief(double si, gboolean is_torque, TinkerUnitSystem system)
{
    static const TinkerDimension force = {1, 1, -2, 0}, torque = {1, 2, -2, 0};
    g_autofree char *size = tinker_quantity_brief(fabs(si), is_torque ? torque : force, system);
    const gboolean joules = g_str_has_suffix(size, "J"); /* of energies alone */
    if (joules) size[strlen(size) - 1] = '\0';
    return g_strconcat(si < 0 ? "−" : "", size, joules ? "N·m" : "", NULL);
}

char *tinker_quantity_to_text(double si, TinkerDimension dimension, TinkerUnitSystem system)
{
    char number[32];
    const char *unit;
    const double factor = factor_of(tinker_unit_for(dimension, system), dimension, &unit);
    if (*unit != '\0' && isfinite(si / factor)) {
        /* the product with the factor rounds, so a neighbour of the quotient may be the one that reads back */
        const double quotient = si / factor;
        const double candidates[] = {quotient, nextafter(quotient, -INFINITY), nextafter(quotient, INFINITY)};
        for (int digits = 1; digits <= DBL_DECIMAL_DIG; digits++) {
            for (gsize i = 0; i < G_N_ELEMENTS(candidates); i++) {
                print_digits(candidates[i], digits, number, sizeof number);
                const double read = g_ascii_strtod(number, NULL);
                if (read * factor != si) continue;
                tinker_number_to_text(read, number, sizeof number); /* "30", where few digits made it "3e+01" */
                return g_strdup_printf("%s %s", number, unit);
            }
        }
    }
    tinker_number_to_text(si, number, sizeof number);
    return g_strdup(number);
}

void tinker_number_to_text(double value, char *text, gsize room)
{
    /* every decimal of up to 15 digits survives the way through a normal double, so 15 digits show the shortest */
    const int fewest = fabs(value) < DBL_MIN ? 1 : DBL_DIG;
    for (int digits = fewest; digits < DBL_DECIMAL_DIG; digits++) {
        print_digits(value, digits, text, room);
        if (g_ascii_strtod(text, NULL) == value) return;
    }
    if (print_digits_above(value, text, room)) return;
    print_digits(value, DBL_DECIMAL_DIG, text, room);
}

/* Rounded to the digits first, so that %g never has need of an exponent. */
char *tinker_duration_text(double seconds, int digits)
{
    static const struct {
        double size;
        const char *unit;
    } units[] = {{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}, {1e-9, "ns"}};
    char text[64];
    gsize i = 0;
    print_digits(seconds, digits, text, sizeof text);
    double rounded = g_ascii_strtod(text, NULL);
    while (i + 1 < G_N_ELEMENTS(units) && fabs(rounded) < (i == 0 ? 0.1 : 1) * units[i].size)
        i++;
    print_digits(rounded / units[i].size, 12, text, sizeof text);
    return g_strdup_printf("%s %s", text, units[i].unit);
}
