/* The unit table against UDUNITS-2. Left out is what it has no or another meaning for: mph (a milliphot there), Hz, rev
 * and rpm (its hertz is a plain 1/s), g0 (its name is standard_gravity), and its slug is rounded to 2e-7. */
#include <udunits2.h>

#include "units/quantity/units.h"

static void test_factors(void)
{
    static const char *const pairs[][3] = {
        /* ours, theirs, the SI unit of both */
        {"m", "m", "m"},
        {"mm", "mm", "m"},
        {"cm", "cm", "m"},
        {"km", "km", "m"},
        {"um", "um", "m"},
        {"in", "in", "m"},
        {"ft", "international_foot", "m"},
        {"yd", "international_yard", "m"},
        {"mi", "international_mile", "m"},
        {"kg", "kg", "kg"},
        {"g", "g", "kg"},
        {"mg", "mg", "kg"},
        {"t", "t", "kg"},
        {"lb", "lb", "kg"},
        {"s", "s", "s"},
        {"ms", "ms", "s"},
        {"us", "us", "s"},
        {"min", "min", "s"},
        {"h", "h", "s"},
        {"N", "N", "kg m s-2"},
        {"kN", "kN", "kg m s-2"},
        {"mN", "mN", "kg m s-2"},
        {"MN", "MN", "kg m s-2"},
        {"dyn", "dyne", "kg m s-2"},
        {"lbf", "lbf", "kg m s-2"},
        {"kip", "kip", "kg m s-2"},
        {"J", "J", "kg m2 s-2"},
        {"W", "W", "kg m2 s-3"},
        {"Pa", "Pa", "kg m-1 s-2"},
        {"rad", "rad", "rad"},
        {"mrad", "mrad", "rad"},
        {"deg", "arc_degree", "rad"},
        {"°", "degree", "rad"},
        {"g0", "standard_free_fall", "m s-2"},
        {"lbf/ft", "lbf/international_foot", "N/m"},
        {"lbf·s/ft", "lbf s/international_foot", "N s/m"},
        {"ft·lbf", "international_foot lbf", "J"},
        {"lb/in^3", "lb/in3", "kg/m3"},
        {"km/h", "km/h", "m/s"},
    };
    ut_set_error_message_handler(ut_ignore);
    ut_system *system = ut_read_xml(NULL);
    g_assert_nonnull(system);
    for (gsize i = 0; i < G_N_ELEMENTS(pairs); i++) {
        TinkerUnit unit;
        g_assert_true(tinker_unit_parse(pairs[i][0], &unit, NULL));
        ut_unit *theirs = ut_parse(system, pairs[i][1], UT_UTF8);
        ut_unit *base = ut_parse(system, pairs[i][2], UT_UTF8);
        g_test_message("%s", pairs[i][0]);
        g_assert_nonnull(theirs);
        g_assert_nonnull(base);
        cv_converter *converter = ut_get_converter(theirs, base);
        g_assert_nonnull(converter);
        g_assert_cmpfloat_with_epsilon(unit.factor / cv_convert_double(converter, 1), 1, 1e-14);
        cv_free(converter);
        ut_free(theirs);
        ut_free(base);
    }
    ut_free_system(system);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/units-oracle/factors", test_factors);
    return g_test_run();
}
