/* The tables: every unit that can be written, with its exact factor, and what the dimensions are called and displayed
 * in.
 *
 * English factors follow from four exact ones: the inch of 0.0254 m, the pound of 0.45359237 kg (international yard and
 * pound agreement, 1959), standard gravity 9.80665 m/s^2 (CGPM 1901) and the second. All else is computed from them by
 * the compiler, so no rounded constant enters. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "units/quantity/units-private.h"

#define FOOT   0.3048
#define POUND  0.45359237
#define GRAVE  9.80665 /* standard gravity, m/s^2 */
#define POUNDF 4.4482216152605
#define PI     3.14159265358979323846

/* lbf s^2/ft, 14.593902937206364829... kg; folded in long double and rounded once. */
#define SLUG ((double)(4.4482216152605L / 0.3048L))

#define DIMENSION(mass, length, time, angle)                                                                           \
    {                                                                                                                  \
        mass, length, time, angle                                                                                      \
    }

#define MASS         DIMENSION(1, 0, 0, 0)
#define LENGTH       DIMENSION(0, 1, 0, 0)
#define TIME         DIMENSION(0, 0, 1, 0)
#define ANGLE        DIMENSION(0, 0, 0, 1)
#define SPEED        DIMENSION(0, 1, -1, 0)
#define ACCELERATION DIMENSION(0, 1, -2, 0)
#define TURNING      DIMENSION(0, 0, -1, 1)
#define FORCE        DIMENSION(1, 1, -2, 0)
#define ENERGY       DIMENSION(1, 2, -2, 0)
#define POWER        DIMENSION(1, 2, -3, 0)
#define PRESSURE     DIMENSION(1, -1, -2, 0)

const TinkerUnitEntry *tinker_unit_lookup(const char *symbol)
{
    for (const TinkerUnitEntry *entry = tinker_unit_table; entry->symbol != NULL; entry++)
        if (strcmp(entry->symbol, symbol) == 0) return entry;
    return NULL;
}

const TinkerDimensionEntry *tinker_dimension_lookup(TinkerDimension dimension)
{
    for (const TinkerDimensionEntry *entry = tinker_dimension_table; entry->phrase != NULL; entry++)
        if (tinker_dimension_equal(entry->dimension, dimension)) return entry;
    return NULL;
}

const TinkerUnitEntry tinker_unit_table[] = {
    {"m", 1, LENGTH},
    {"mm", 1e-3, LENGTH},
    {"cm", 1e-2, LENGTH},
    {"km", 1e3, LENGTH},
    {"um", 1e-6, LENGTH},
    {"in", 0.0254, LENGTH},
    {"ft", FOOT, LENGTH},
    {"yd", 0.9144, LENGTH},
    {"mi", 1609.344, LENGTH},
    {"kg", 1, MASS},
    {"g", 1e-3, MASS},
    {"mg", 1e-6, MASS},
    {"t", 1e3, MASS},
    {"slug", SLUG, MASS},
    {"lb", POUND, MASS},
    {"s", 1, TIME},
    {"ms", 1e-3, TIME},
    {"us", 1e-6, TIME},
    {"min", 60, TIME},
    {"h", 3600, TIME},
    {"N", 1, FORCE},
    {"kN", 1e3, FORCE},
    {"mN", 1e-3, FORCE},
    {"MN", 1e6, FORCE},
    {"dyn", 1e-5, FORCE},
    {"lbf", POUNDF, FORCE},
    {"kip", 4448.2216152605, FORCE},
    {"J", 1, ENERGY},
    {"W", 1, POWER},
    {"Pa", 1, PRESSURE},
    {"rad", 1, ANGLE},
    {"mrad", 1e-3, ANGLE},
    {"deg", PI / 180, ANGLE},
    {"°", PI / 180, ANGLE},
    {"rev", 2 * PI, ANGLE},
    {"rpm", 2 * PI / 60, TURNING},
    {"Hz", 2 * PI, TURNING},
    {"mph", 0.44704, SPEED},
    {"g0", GRAVE, ACCELERATION},
    {NULL, 0, DIMENSION(0, 0, 0, 0)},
};

const TinkerDimensionEntry tinker_dimension_table[] = {
    {MASS, N_("a mass"), "kg", "slug"},
    {LENGTH, N_("a length"), "m", "ft"},
    {TIME, N_("a time"), "s", "s"},
    {ANGLE, N_("an angle"), "deg", "deg"},
    {SPEED, N_("a velocity"), "m/s", "ft/s"},
    {ACCELERATION, N_("an acceleration"), "m/s²", "ft/s²"},
    {TURNING, N_("an angular velocity"), "rad/s", "rad/s"},
    {DIMENSION(0, 0, -2, 1), N_("an angular acceleration"), "rad/s²", "rad/s²"},
    {DIMENSION(0, 0, -1, 0), N_("a rate"), "1/s", "1/s"},
    {FORCE, N_("a force"), "N", "lbf"},
    {DIMENSION(1, 0, -2, 0), N_("a stiffness"), "N/m", "lbf/ft"},
    {DIMENSION(1, 0, -1, 0), N_("a damping"), "N·s/m", "lbf·s/ft"},
    {DIMENSION(1, -1, 0, 0), N_("a quadratic drag"), "N·s²/m²", "lbf·s²/ft²"},
    {DIMENSION(1, 1, -1, 0), N_("a momentum"), "kg·m/s", "slug·ft/s"},
    {DIMENSION(1, 2, -1, 0), N_("an angular momentum"), "kg·m²/s", "slug·ft²/s"},
    {DIMENSION(1, 2, 0, 0), N_("a moment of inertia"), "kg·m²", "slug·ft²"},
    {ENERGY, N_("an energy"), "J", "ft·lbf"},
    {POWER, N_("a power"), "W", "ft·lbf/s"},
    {PRESSURE, N_("a pressure"), "Pa", "lbf/ft²"},
    {DIMENSION(1, 2, -2, -1), N_("a torsional stiffness"), "N·m/rad", "ft·lbf/rad"},
    {DIMENSION(1, 2, -1, -1), N_("a torsional damping"), "N·m·s/rad", "ft·lbf·s/rad"},
    {DIMENSION(0, 2, 0, 0), N_("an area"), "m²", "ft²"},
    {DIMENSION(0, 3, 0, 0), N_("a volume"), "m³", "ft³"},
    {DIMENSION(1, -3, 0, 0), N_("a density"), "kg/m³", "slug/ft³"},
    {DIMENSION(0, 0, 0, 0), N_("a plain number"), "", ""},
    {DIMENSION(0, 0, 0, 0), NULL, NULL, NULL},
};
