/* Units and quantities against published exact factors and the strings that the display promises. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "units/quantity/units.h"

static const TinkerDimension mass = {1, 0, 0, 0}, length = {0, 1, 0, 0}, angle = {0, 0, 0, 1};
static const TinkerDimension plain = {0, 0, 0, 0}, stiffness = {1, 0, -2, 0}, turning = {0, 0, -1, 1};
static const TinkerDimension energy = {1, 2, -2, 0};

static double parse(const char *text, TinkerDimension dimension)
{
    g_autoptr(GError) error = NULL;
    double value = NAN;
    g_assert_true(tinker_quantity_parse(text, dimension, &value, &error));
    g_assert_no_error(error);
    return value;
}

static void assert_refused(const char *text, TinkerDimension dimension, TinkerUnitsError code, const char *message)
{
    g_autoptr(GError) error = NULL;
    double value = 7;
    g_assert_false(tinker_quantity_parse(text, dimension, &value, &error));
    g_assert_error(error, TINKER_UNITS_ERROR, (gint)code);
    if (message != NULL) g_assert_cmpstr(error->message, ==, message);
    g_assert_true(g_str_has_prefix(error->message, "column "));
    g_assert_cmpfloat(value, ==, 7);
}

static void test_display(void)
{
    static const struct {
        double si;
        TinkerDimension dimension;
        const char *metric, *english;
    } cases[] = {
        {3.2, {0, 1, 0, 0}, "3.20000 m", "10.49869 ft"},        {2.4, {0, 1, 0, 0}, "2.40000 m", "7.87402 ft"},
        {1, {1, 0, 0, 0}, "1.00000 kg", "0.06852 slug"},        {0.8, {0, 1, 0, 0}, "0.80000 m", "2.62467 ft"},
        {-1e-9, {0, 1, -1, 0}, "0.00000 m/s", "0.00000 ft/s"},  {2, {0, 0, -1, 1}, "2.00000 rad/s", "2.00000 rad/s"},
        {G_PI, {0, 0, 0, 1}, "180.00000 deg", "180.00000 deg"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *metric =
            tinker_quantity_format(cases[i].si, cases[i].dimension, NULL, TINKER_UNIT_SYSTEM_SI, 5);
        g_autofree char *english =
            tinker_quantity_format(cases[i].si, cases[i].dimension, NULL, TINKER_UNIT_SYSTEM_ENGLISH, 5);
        g_assert_cmpstr(metric, ==, cases[i].metric);
        g_assert_cmpstr(english, ==, cases[i].english);
    }
    g_autofree char *chosen = tinker_quantity_format(4 * G_PI, turning, "rpm", TINKER_UNIT_SYSTEM_SI, 1);
    g_assert_cmpstr(chosen, ==, "120.0 rpm");
    g_autofree char *brief = tinker_quantity_brief(-10 / 3.0, length, TINKER_UNIT_SYSTEM_SI);
    g_assert_cmpstr(brief, ==, "-3.333 m");
    g_autofree char *foot = tinker_quantity_brief(0.3048, length, TINKER_UNIT_SYSTEM_ENGLISH);
    g_assert_cmpstr(foot, ==, "1 ft");
    g_autofree char *nothing = tinker_quantity_brief(-0.0, length, TINKER_UNIT_SYSTEM_SI);
    g_assert_cmpstr(nothing, ==, "0 m");
    g_autofree char *force = tinker_load_brief(-25, FALSE, TINKER_UNIT_SYSTEM_SI);
    g_assert_cmpstr(force, ==, "−25 N");
    g_autofree char *torque = tinker_load_brief(-12.5, TRUE, TINKER_UNIT_SYSTEM_SI);
    g_assert_cmpstr(torque, ==, "−12.5 N·m");
    g_autofree char *pounds = tinker_load_brief(1.3558179483314004, TRUE, TINKER_UNIT_SYSTEM_ENGLISH); /* lbf by ft */
    g_assert_cmpstr(pounds, ==, "1 ft·lbf");
    g_autofree char *huge = tinker_quantity_format(-DBL_MAX, length, NULL, TINKER_UNIT_SYSTEM_SI, 99);
    g_assert_cmpuint(strlen(huge), ==, 1 + 309 + 1 + 20 + 2);
}

static void test_durations(void)
{
    static const struct {
        double seconds;
        int digits;
        const char *text;
    } cases[] = {
        {0.0004, 2, "400 µs"},    {4.96e-4, 2, "500 µs"}, {9.996e-4, 3, "1 ms"}, {6.81e-7, 3, "681 ns"},
        {49.12e-6, 3, "49.1 µs"}, {1234.6, 3, "1230 s"},  {0.5, 3, "0.5 s"},     {0.05, 3, "50 ms"},
        {0, 3, "0 ns"},           {2e-12, 2, "0.002 ns"}, {1, 2, "1 s"},         {0.0996, 2, "0.1 s"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = tinker_duration_text(cases[i].seconds, cases[i].digits);
        g_assert_cmpstr(text, ==, cases[i].text);
    }
}

static void test_names(void)
{
    g_assert_cmpstr(tinker_unit_for(stiffness, TINKER_UNIT_SYSTEM_SI), ==, "N/m");
    g_assert_cmpstr(tinker_unit_for(stiffness, TINKER_UNIT_SYSTEM_ENGLISH), ==, "lbf/ft");
    g_assert_cmpstr(tinker_unit_for((TinkerDimension){1, 0, -1, 0}, TINKER_UNIT_SYSTEM_ENGLISH), ==, "lbf·s/ft");
    g_assert_cmpstr(tinker_unit_for(plain, TINKER_UNIT_SYSTEM_SI), ==, "");
    g_assert_cmpstr(tinker_unit_si_symbol((TinkerDimension){1, 0, -1, 0}), ==, "N s/m");
    g_assert_cmpstr(tinker_unit_si_symbol((TinkerDimension){1, 2, -1, 0}), ==, "kg m^2/s");
    g_assert_cmpstr(tinker_unit_si_symbol(angle), ==, "rad");
    g_assert_cmpstr(tinker_unit_in_print("N*s^2/m^3"), ==, "N·s²/m³");
    g_assert_cmpstr(tinker_unit_in_ascii("N·s²/m³"), ==, "N s^2/m^3");
    g_assert_cmpstr(tinker_unit_si_symbol((TinkerDimension){0, 0, -3, -1}), ==, "1/s^3/rad");
    g_assert_cmpstr(tinker_dimension_name(stiffness), ==, "stiffness");
    g_assert_cmpstr(tinker_dimension_name((TinkerDimension){2, 1, 0, 0}), ==, "kg^2 m");
}

/* Whatever is displayed can be read, in both systems, for all small exponents. */
static void test_every_symbol_reads_back(void)
{
    for (int code = 0; code < 4 * 4 * 4 * 4; code++) {
        const TinkerDimension dimension = {(int8_t)(code % 4 - 1), (int8_t)(code / 4 % 4 - 1),
                                           (int8_t)(code / 16 % 4 - 2), (int8_t)(code / 64 - 1)};
        const char *texts[] = {tinker_unit_for(dimension, TINKER_UNIT_SYSTEM_SI),
                               tinker_unit_for(dimension, TINKER_UNIT_SYSTEM_ENGLISH),
                               tinker_unit_si_symbol(dimension)};
        for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
            TinkerUnit unit;
            g_assert_true(tinker_unit_parse(texts[i], &unit, NULL));
            g_assert_true(tinker_dimension_equal(unit.dimension, dimension));
            if (i == 2) g_assert_cmpfloat(unit.factor, ==, 1);
        }
    }
}

static void test_parse(void)
{
    g_assert_cmpfloat(parse("1 in", length), ==, 0.0254);
    g_assert_cmpfloat_with_epsilon(parse("12 in", length), 0.3048, 1e-16);
    g_assert_cmpfloat(parse("-3.5 ft/s", (TinkerDimension){0, 1, -1, 0}), ==, -1.0668);
    g_assert_cmpfloat(parse("30deg", angle), ==, G_PI / 6);
    g_assert_cmpfloat(parse("180 deg", angle), ==, G_PI);
    g_assert_cmpfloat(parse("90°", angle), ==, G_PI / 2);
    g_assert_cmpfloat_with_epsilon(parse("120 rpm", turning), 4 * G_PI, 2e-15);
    g_assert_cmpfloat(parse("1 Hz", turning), ==, 2 * G_PI);
    g_assert_cmpfloat(parse("2 1/s", (TinkerDimension){0, 0, -1, 0}), ==, 2);
    g_assert_cmpfloat(parse(" 1e3 ", mass), ==, 1000);
    g_assert_cmpfloat(parse("+.5e-1", plain), ==, 0.05);
    /* NIST SP 811 (2008), appendix B.8: 1 slug = 14.59390 kg, 1 lbf/ft = 14.59390 N/m, 1 mi/h = 0.44704 m/s */
    g_assert_cmpfloat(parse("1 slug", mass), ==, 14.593902937206364829);
    g_assert_cmpfloat_with_epsilon(parse("100 lbf/ft", stiffness), 1459.390, 5e-4);
    g_assert_cmpfloat(parse("1 mph", (TinkerDimension){0, 1, -1, 0}), ==, 0.44704);
    g_assert_cmpfloat(parse("1 g0", (TinkerDimension){0, 1, -2, 0}), ==, 9.80665);

    static const char *const dampings[] = {"2 N s/m",   "2 N*s/m",       "2 N·s/m",  "2 N-s/m",
                                           "2 N * s/m", "2 kg/m s^-1 m", "2 kg·s⁻¹", "2N / m s"};
    for (gsize i = 0; i < G_N_ELEMENTS(dampings); i++)
        g_assert_cmpfloat(parse(dampings[i], (TinkerDimension){1, 0, -1, 0}), ==, 2);
    static const char *const accelerations[] = {"3 m/s^2", "3 m/s²", "3 m/s/s", "3 m s^-2"};
    for (gsize i = 0; i < G_N_ELEMENTS(accelerations); i++)
        g_assert_cmpfloat(parse(accelerations[i], (TinkerDimension){0, 1, -2, 0}), ==, 3);
}

static void test_refused(void)
{
    assert_refused("12 parsecs-ish", length, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 4: unknown unit \"parsecs\"; did you mean \"m\", \"mm\", \"cm\", \"km\", \"um\", \"in\", "
                   "\"ft\", \"yd\" or \"mi\"?");
    assert_refused("1 slgu", mass, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 3: unknown unit \"slgu\"; did you mean \"slug\"?");
    assert_refused("1 N/M", stiffness, TINKER_UNITS_ERROR_UNKNOWN, "column 5: unknown unit \"M\"; did you mean \"m\"?");
    /* letters that run together, and powers without a sign; what does not fit is not proposed */
    assert_refused("3 Nm", energy, TINKER_UNITS_ERROR_UNKNOWN, "column 3: unknown unit \"Nm\"; did you mean \"N m\"?");
    assert_refused("3 Nm", length, TINKER_UNITS_ERROR_UNKNOWN, "column 3: unknown unit \"Nm\"; did you mean \"m\"?");
    assert_refused("3 Nm", mass, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 3: unknown unit \"Nm\"; did you mean \"kg\", \"g\", \"mg\", \"t\", \"slug\" or \"lb\"?");
    assert_refused("3 kgm", mass, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 3: unknown unit \"kgm\"; did you mean \"kg\"?"); /* rather than km, which is as near */
    assert_refused("2 kgm2/s2", energy, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 3: unknown unit \"kgm2\"; did you mean \"kg m^2\"?");
    assert_refused("2 kg m^2/s2", energy, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 10: unknown unit \"s2\"; did you mean \"s^2\"?");
    assert_refused("2 Nms/rad", (TinkerDimension){1, 2, -1, -1}, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 3: unknown unit \"Nms\"; did you mean \"N m s\"?");
    assert_refused("2 kg/ss", stiffness, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 6: unknown unit \"ss\"; did you mean \"s/s\"?");
    assert_refused("2 kg/s2", stiffness, TINKER_UNITS_ERROR_UNKNOWN,
                   "column 6: unknown unit \"s2\"; did you mean \"s^2\"?");
    assert_refused("1,5 kg", mass, TINKER_UNITS_ERROR_SYNTAX,
                   "column 2: decimals stand behind a point, not a comma; did you mean \"1.5\"?");
    assert_refused("-,5 kg", mass, TINKER_UNITS_ERROR_SYNTAX,
                   "column 2: decimals stand behind a point, not a comma; did you mean \"-.5\"?");
    assert_refused("1,000.5 kg", mass, TINKER_UNITS_ERROR_SYNTAX,
                   "column 2: no commas stand between thousands; did you mean \"1000.5\"?");
    assert_refused("1,5e3 kg", mass, TINKER_UNITS_ERROR_SYNTAX,
                   "column 2: decimals stand behind a point, not a comma; did you mean \"1.5e3\"?");
    assert_refused("1,500,000 kg", mass, TINKER_UNITS_ERROR_SYNTAX,
                   "column 2: no commas stand between thousands; did you mean \"1500000\"?");
    assert_refused("1 °x", angle, TINKER_UNITS_ERROR_UNKNOWN, NULL);
    assert_refused("12 in", mass, TINKER_UNITS_ERROR_DIMENSION,
                   "column 4: a mass (kg) was expected, \"12 in\" is a length (m)");
    assert_refused("2 1/s", turning, TINKER_UNITS_ERROR_DIMENSION,
                   "column 3: an angular velocity (rad/s) was expected, \"2 1/s\" is a rate (1/s)");
    assert_refused("2 m", plain, TINKER_UNITS_ERROR_DIMENSION,
                   "column 3: a plain number was expected, \"2 m\" is a length (m)");
    assert_refused("", length, TINKER_UNITS_ERROR_SYNTAX, "column 1: a number is expected here, as in 12 or 12 in");
    assert_refused("3 m^", length, TINKER_UNITS_ERROR_SYNTAX,
                   "column 4: a whole number is expected as the power, as in m^2");
    assert_refused("3 m·", length, TINKER_UNITS_ERROR_SYNTAX, "column 5: a unit is missing at the end");
    static const char *const texts[] = {
        "nan",      "inf m",       "0x10 m",      "1e999 m", "1,5 m",          "3 ft)", "3 (m)",  "1 km^101",
        "1 m//s",   "1 /s",        "1 m^-",       "--1 m",   "1 m^9999999999", "\xff",  "3 \xc3", "3 1 m",
        "1 km^100", "1e300 km^99", "1 m^99 m^99", "m",       "1 m s- 1",       ". m"};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        g_autoptr(GError) error = NULL;
        double value;
        g_assert_false(tinker_quantity_parse(texts[i], length, &value, &error));
        g_assert_true(g_str_has_prefix(error->message, "column "));
    }
    g_autofree char *long_text = g_strnfill(100000, 'm');
    long_text[0] = '1';
    assert_refused(long_text, length, TINKER_UNITS_ERROR_UNKNOWN, NULL);
}

/* Numbers over the whole range come back with the same bits, with and without a unit. */
static void test_round_trip(void)
{
    g_autoptr(GRand) rand = g_rand_new_with_seed(5);
    const TinkerDimension dimensions[] = {mass, length, angle, stiffness, turning, plain};
    for (int i = 0; i < 20000; i++) {
        const double value = ldexp(g_rand_double_range(rand, -1, 1), g_rand_int_range(rand, -300, 300));
        char number[32];
        tinker_number_to_text(value, number, sizeof number);
        g_assert_cmpfloat(g_ascii_strtod(number, NULL), ==, value);
        const TinkerDimension dimension = dimensions[i % G_N_ELEMENTS(dimensions)];
        g_autofree char *text = tinker_quantity_to_text(value, dimension, i % 2 ? TINKER_UNIT_SYSTEM_ENGLISH : 0);
        g_assert_cmpfloat(parse(text, dimension), ==, value);
    }
    g_autofree char *feet = tinker_quantity_to_text(0.3048, length, TINKER_UNIT_SYSTEM_ENGLISH);
    g_assert_cmpstr(feet, ==, "1 ft");
    g_autofree char *degrees = tinker_quantity_to_text(G_PI / 6, angle, TINKER_UNIT_SYSTEM_SI);
    g_assert_cmpstr(degrees, ==, "30 deg");
}

/* The shortest texts, as D. Gay's dtoa (mode 0) and other shortest printers have them. */
static void test_shortest(void)
{
    static const struct {
        double value;
        const char *text;
    } cases[] = {{0.1, "0.1"},
                 {1.0 / 3, "0.3333333333333333"},
                 {0.1 + 0.2, "0.30000000000000004"},
                 {5e-324, "5e-324"},
                 {1e23, "1e+23"},
                 {0x1p-44, "5.684341886080802e-14"},
                 {-0.0, "-0"},
                 {1e15, "1e+15"},
                 {DBL_MAX, "1.7976931348623157e+308"},
                 {100, "100"},
                 {2e-308, "2e-308"},
                 {9007199254740993.0, "9007199254740992"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        char text[32];
        tinker_number_to_text(cases[i].value, text, sizeof text);
        g_assert_cmpstr(text, ==, cases[i].text);
    }
}

static void test_nearest(void)
{
    static const char *const words[] = {"stiffness", "damping", "mass", "t", NULL};
    g_assert_cmpstr(tinker_nearest_word("stifness", words), ==, "stiffness");
    g_assert_cmpstr(tinker_nearest_word("amss", words), ==, "mass");
    g_assert_cmpstr(tinker_nearest_word("Damping", words), ==, "damping");
    g_assert_cmpstr(tinker_nearest_word("T", words), ==, "t");
    g_assert_null(tinker_nearest_word("x", words));
    g_assert_null(tinker_nearest_word("", words));
    g_assert_null(tinker_nearest_word("velocity", words));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/units/display", test_display);
    g_test_add_func("/units/durations", test_durations);
    g_test_add_func("/units/names", test_names);
    g_test_add_func("/units/every-symbol-reads-back", test_every_symbol_reads_back);
    g_test_add_func("/units/parse", test_parse);
    g_test_add_func("/units/refused", test_refused);
    g_test_add_func("/units/round-trip", test_round_trip);
    g_test_add_func("/units/shortest", test_shortest);
    g_test_add_func("/units/nearest", test_nearest);
    return g_test_run();
}
