/* Frequency responses against closed forms. */
#include <math.h>
#include <string.h>

#include "modes-fixture.h"

/* About rest. */
typedef struct {
    ModesFixture *scene;
    const GPtrArray *modes;
    TinkerLinearInput input;
    TinkerLinearOutput output;
    TinkerFrequencyResponse *response;
} Analysis;

static void analysis_free(Analysis *a)
{
    tinker_frequency_response_free(a->response);
    tinker_linear_input_clear(&a->input);
    tinker_linear_output_clear(&a->output);
    modes_fixture_free(a->scene);
    g_free(a);
}
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Analysis, analysis_free)

static Analysis *analyse(const char *input, const char *output, const char *blocks)
{
    g_autoptr(GError) error = NULL;
    Analysis *a = g_new0(Analysis, 1);
    a->scene = modes_fixture_new(TRUE, blocks);
    const TinkerModeAnalysis *modes = a->scene->analysis;
    a->modes = modes->modes;
    g_autoptr(GArray) columns = tinker_columns_new();
    g_assert_true(tinker_columns_add(columns, a->scene->scene, output, &error));
    g_assert_true(tinker_linear_input_find(modes->model, input, &a->input, &error));
    g_assert_true(tinker_linear_output_find(modes->model, modes->q, &g_array_index(columns, TinkerColumn, 0), &a->input,
                                            &a->output, &error));
    a->response = tinker_frequency_response_new(modes->linear, modes->basis, &a->input, &a->output, &error);
    g_assert_no_error(error);
    return a;
}

static void assert_response(Analysis *a, double omega, double complex truth, double bound)
{
    double complex value = tinker_frequency_response_at(a->response, omega);
    if (cabs(value - truth) <= bound * cabs(truth)) return;
    g_test_message("at %g rad/s: %.15g%+.15gi instead of %.15g%+.15gi", omega, creal(value), cimag(value), creal(truth),
                   cimag(truth));
    g_test_fail();
}

static const double ratios[] = {0.01, 0.3, 0.9, 0.99, 1, 1.01, 1.5, 7, 100};

#define OSCILLATOR                                                                                                     \
    "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'mass': 2, 'position': [1, 0]},"                        \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 50},"                                            \
    "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 4}"

/* What has no linear form of its own. A wheel on a torsional spring and damper: 1 / (k - I omega^2 + i c omega); the
 * reaction acts on a second wheel; a motor that turns with the wheel has the arm r sin(angle between them). */
static void test_turning(void)
{
    const char *blocks =
        "{'type': 'support', 'solid': false}, {'type': 'support', 'position': [3, 0], 'solid': false},"
        "{'type': 'disc', 'position': [0, 0], 'inertia': 0.5, 'orientation': 0.3, 'solid': false},"
        "{'type': 'disc', 'inertia': 2, 'position': [3, 0], 'solid': false},"
        "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, {'type': 'pin', 'ends': ['Support 1', 'Disc 1']},"
        "{'type': 'torsional-spring', 'stiffness': 12.5, 'ends': ['Support 0', 'Disc 0']},"
        "{'type': 'torsional-damper', 'damping': 0.4, 'ends': ['Disc 0', 'Support 0']},"
        "{'type': 'torsional-spring', 'stiffness': 50, 'ends': ['Support 1', 'Disc 1']},"
        "{'type': 'torque', 'ends': ['Disc 0', 'Disc 1'], 'amplitude': 3, 'frequency': 1},"
        "{'type': 'motor', 'ends': [{'block': 'Disc 0', 'at': [0.2, 0]}], 'follows': true, 'angle': 0.7}";
    g_autoptr(Analysis) turns = analyse("Torque 0", "Disc 0.angle", blocks);
    g_autoptr(Analysis) other = analyse("Torque 0", "Disc 1.angle", blocks);
    g_autoptr(Analysis) pushed = analyse("Motor 0", "Disc 0.angle", blocks);
    g_assert_cmpstr(turns->input.unit, ==, "N m");
    for (gsize i = 0; i < G_N_ELEMENTS(ratios); i++) {
        double omega = 5 * ratios[i];
        double complex truth = 1 / CMPLX(12.5 - 0.5 * omega * omega, 0.4 * omega);
        assert_response(turns, omega, truth, 1e-9);
        assert_response(pushed, omega, 0.2 * sin(0.7) * truth, 1e-9);
        if (ratios[i] != 1) assert_response(other, omega, -1 / CMPLX(50 - 2 * omega * omega, 0), 1e-9);
    }
}

/* 1 / (k - m omega^2 + i c omega); its velocity is i omega of that. */
static void test_force(void)
{
    const char *blocks = OSCILLATOR ", {'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3}";
    g_autoptr(Analysis) place = analyse("Motor 0", "Mass 0.x", blocks);
    g_autoptr(Analysis) speed = analyse("Motor 0", "Mass 0.vx", blocks);
    g_assert_cmpstr(place->input.unit, ==, "N");
    for (gsize i = 0; i < G_N_ELEMENTS(ratios); i++) {
        double omega = 5 * ratios[i];
        double complex truth = 1 / CMPLX(50 - 2 * omega * omega, 4 * omega);
        assert_response(place, omega, truth, 1e-10);
        assert_response(speed, omega, CMPLX(0, omega) * truth, 1e-10);
    }
}

/* |H| = sqrt((1 + (2 zeta r)^2) / ((1 - r^2)^2 + (2 zeta r)^2)) with zeta = 0.2; H itself with its phase. */
static void test_transmissibility(void)
{
    g_autoptr(Analysis) a = analyse("Support Motion 0", "Mass 0.x",
                                    OSCILLATOR ", {'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1,"
                                               " 'frequency': 3}");
    g_assert_cmpstr(a->input.unit, ==, "m");
    for (gsize i = 0; i < G_N_ELEMENTS(ratios); i++) {
        double r = ratios[i], damped = 2 * 0.2 * r;
        double truth = sqrt((1 + damped * damped) / ((1 - r * r) * (1 - r * r) + damped * damped));
        assert_response(a, 5 * r, CMPLX(1, damped) / CMPLX(1 - r * r, damped), 1e-10);
        double value = cabs(tinker_frequency_response_at(a->response, 5 * r));
        g_assert_cmpfloat_with_epsilon(value / truth, 1, 1e-10);
    }
}

/* The peak: at omega sqrt(1 - 2 zeta^2), 1 / (2 zeta k sqrt(1 - zeta^2)) high. */
static void test_peak(void)
{
    g_autoptr(Analysis) a =
        analyse("Motor 0", "Mass 0.x", OSCILLATOR ", {'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3}");
    double from, to;
    tinker_frequency_response_range(a->modes, &from, &to);
    g_assert_cmpfloat(from, <, 5);
    g_assert_cmpfloat(to, >, 5);
    g_autoptr(GArray) grid = tinker_frequency_response_grid(a->modes, from, to, 50, TRUE);
    g_assert_cmpfloat(g_array_index(grid, double, 0), ==, from);
    g_assert_cmpfloat(g_array_index(grid, double, grid->len - 1), ==, to);
    g_autoptr(GArray) peaks = tinker_frequency_response_peaks(a->response, grid);
    g_assert_cmpuint(peaks->len, ==, 1);
    TinkerResponsePeak peak = g_array_index(peaks, TinkerResponsePeak, 0);
    g_assert_cmpfloat_with_epsilon(peak.omega, 5 * sqrt(1 - 2 * 0.04), 1e-6);
    g_assert_cmpfloat_with_epsilon(cabs(peak.at), 1 / (2 * 0.2 * 50 * sqrt(1 - 0.04)), 1e-12);
}

/* Without damping the peak has no end, and between two resonances of one point lies none. */
static void test_undamped_peak(void)
{
    g_autoptr(Analysis) a = analyse("Motor 0", "Mass 0.x",
                                    "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'position': [1, 0]},"
                                    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 9},"
                                    "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3}");
    g_autoptr(GArray) grid = tinker_frequency_response_grid(a->modes, 1, 10, 100, FALSE);
    g_autoptr(GArray) peaks = tinker_frequency_response_peaks(a->response, grid);
    g_assert_cmpuint(peaks->len, ==, 1);
    g_assert_cmpfloat_with_epsilon(g_array_index(peaks, TinkerResponsePeak, 0).omega, 3, 1e-6);
    g_assert_true(isinf(cabs(g_array_index(peaks, TinkerResponsePeak, 0).at)));
}

/* A main mass with an absorber and its damper (Den Hartog, "Mechanical Vibrations", 4th edition, section 3.3): with
 * z = k2 + i c omega, x1 / F = (z - m2 omega^2) / ((k1 - m1 omega^2)(z - m2 omega^2) - m2 omega^2 z). */
static void test_absorber(void)
{
    g_autoptr(Analysis) a =
        analyse("Motor 0", "Mass 0.x",
                "{'type': 'support', 'position': [0, 0]}, {'type': 'mass', 'mass': 10, 'position': [1, 0]},"
                "{'type': 'mass', 'mass': 0.5, 'position': [2, 0]},"
                "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1000},"
                "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 45.35},"
                "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 1.21},"
                "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 5, 'frequency': 10}");
    for (double omega = 0.5; omega < 40; omega += 0.37) {
        double complex z = CMPLX(45.35, 1.21 * omega);
        double square = omega * omega;
        assert_response(a, omega, (z - 0.5 * square) / ((1000 - 10 * square) * (z - 0.5 * square) - 0.5 * square * z),
                        1e-10);
    }
}

/* The support of a pendulum moves sideways by u: x = u g / (g - L omega^2), and by the rod alone the bob stays at its
 * height. The rod's tension does not change in first order along the swing, but follows the support up and down: m u''
 * there. */
static void test_pendulum_on_moving_support(void)
{
    const char *format = "{'type': 'gravity', 'acceleration': 9}, {'type': 'support', 'position': [0, 0]},"
                         "{'type': 'mass', 'mass': 3, 'position': [0, -4]},"
                         "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4},"
                         "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1, 'angle': '%s'}";
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    g_autofree char *sideways = g_strdup_printf(format, "0 deg"), *upwards = g_strdup_printf(format, "90 deg");
#pragma GCC diagnostic pop
    g_autoptr(Analysis) place = analyse("Support Motion 0", "Mass 0.x", sideways);
    g_autoptr(Analysis) height = analyse("Support Motion 0", "Mass 0.y", upwards);
    g_autoptr(Analysis) tension = analyse("Support Motion 0", "Rod 0.tension", upwards);
    for (double omega = 0.2; omega < 10; omega *= 1.3) {
        assert_response(place, omega, 9 / (9 - 4 * omega * omega), 1e-10);
        assert_response(height, omega, 1, 1e-10);
        assert_response(tension, omega, -3 * omega * omega, 1e-9);
    }
}

/* The spring's tension under a motor's force: k x. */
static void test_tension_of_a_spring(void)
{
    g_autoptr(Analysis) a =
        analyse("Motor 0", "Spring 0.tension", OSCILLATOR ", {'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3}");
    for (gsize i = 0; i < G_N_ELEMENTS(ratios); i++) {
        double omega = 5 * ratios[i];
        assert_response(a, omega, 50 / CMPLX(50 - 2 * omega * omega, 4 * omega), 1e-9);
    }
}

/* A long chain whose dampers differ, so that its modes are all coupled: against the elimination of its own tridiagonal
 * equations from the support on, with d_i = k + i c_i omega of the link before mass i: the stiffness that is seen at
 * mass i is s_i = -m omega^2 + d_i s_(i-1) / (d_i + s_(i-1)), from s_1 = d_1 - m omega^2 on. */
static void test_damped_chain(void)
{
    enum { N = 40 };
    g_autoptr(GString) blocks = g_string_new("{'type': 'support', 'name': 'M0', 'position': [0, 0]}");
    for (int i = 1; i <= N; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'mass', 'name': 'M%d', 'position': [%d, 0]},"
                               "{'type': 'spring', 'ends': ['M%d', 'M%d'], 'stiffness': 50},"
                               "{'type': 'damper', 'ends': ['M%d', 'M%d'], 'damping': %d}",
                               i, i, i - 1, i, i - 1, i, 1 + i % 3);
    g_string_append(blocks, ", {'type': 'motor', 'ends': ['M40'], 'waveform': 'sine'}");
    g_autoptr(Analysis) a = analyse("Motor 0", "M40.x", blocks->str);
    for (double omega = 0.1; omega < 30; omega *= 1.4) {
        double complex seen = 0;
        for (int i = 1; i <= N; i++) {
            double complex link = CMPLX(50, (1 + i % 3) * omega);
            seen = (i == 1 ? link : link * seen / (link + seen)) - omega * omega;
        }
        assert_response(a, omega, 1 / seen, 1e-10);
    }
}

static void test_refusals(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(ModesFixture) a =
        modes_fixture_new(TRUE, OSCILLATOR ", {'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3}");
    static const char *const names[] = {"Motor 1", "Spring 0"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        g_auto(TinkerLinearInput) input = {0};
        g_assert_false(tinker_linear_input_find(a->analysis->model, names[i], &input, &error));
        g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME);
        g_assert_nonnull(strstr(error->message, "\"Motor 0\""));
        g_clear_error(&error);
    }
}

/* What goes with the square of a swing, or with that times the force, swings at twice its frequency. */
static void test_squares(void)
{
    static const char *const squares[] = {"Spring 0.energy", "Motor 0.power", "Scene.kinetic energy",
                                          "Damper 0.dissipated power"};
    const char *blocks = "{'type': 'support', 'position': [0.1, 0.2]}, {'type': 'mass', 'position': [1.43, 0.97]},"
                         "{'type': 'spring', 'ends': ['Support 0', 'Mass 0']},"
                         "{'type': 'damper', 'ends': ['Support 0', 'Mass 0']},"
                         "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3}";
    for (gsize i = 0; i < G_N_ELEMENTS(squares); i++) {
        g_autoptr(GError) error = NULL;
        g_autoptr(ModesFixture) a = modes_fixture_new(TRUE, blocks);
        g_auto(TinkerLinearInput) input = {0};
        g_auto(TinkerLinearOutput) output = {0};
        g_autoptr(GArray) columns = tinker_columns_new();
        g_assert_true(tinker_columns_add(columns, a->scene, squares[i], &error));
        g_assert_true(tinker_linear_input_find(a->analysis->model, "Motor 0", &input, &error));
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, 0);
        if (tinker_linear_output_find(a->analysis->model, a->analysis->q, column, &input, &output, &error))
            g_test_fail_printf("%s has a response", squares[i]);
        else
            g_assert_nonnull(strstr(error->message, "does not change with small motions"));
    }
}

/* What is divided by a product or a quotient has it in brackets. */
static void test_units(void)
{
    static const char *const units[][3] = {
        {"m", "N", "m/N"}, {"m", "m", "m/m"}, {"m", "N m", "m/(N m)"}, {"rad", "m/s", "rad/(m/s)"}};
    for (gsize i = 0; i < G_N_ELEMENTS(units); i++) {
        g_autofree char *unit = tinker_frequency_response_unit(units[i][0], units[i][1]);
        g_assert_cmpstr(unit, ==, units[i][2]);
    }
    g_autoptr(Analysis) a = analyse("Torque 0", "Bar 0.x",
                                    "{'type': 'support'}, {'type': 'bar', 'position': [0.5, 0]},"
                                    "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]},"
                                    "{'type': 'torsional-spring', 'ends': ['Support 0', 'Bar 0']},"
                                    "{'type': 'torque', 'ends': ['Bar 0', 'Support 0'], 'waveform': 'sine'}");
    g_assert_cmpstr(a->input.unit, ==, "N m");
}

static void add_tests(void)
{
    g_test_add_func("/analysis/response/squares", test_squares);
    g_test_add_func("/response/force", test_force);
    g_test_add_func("/response/turning", test_turning);
    g_test_add_func("/response/transmissibility", test_transmissibility);
    g_test_add_func("/response/peak", test_peak);
    g_test_add_func("/response/undamped-peak", test_undamped_peak);
    g_test_add_func("/response/absorber", test_absorber);
    g_test_add_func("/response/pendulum-on-moving-support", test_pendulum_on_moving_support);
    g_test_add_func("/response/tension-of-a-spring", test_tension_of_a_spring);
    g_test_add_func("/response/damped-chain", test_damped_chain);
    g_test_add_func("/response/units", test_units);
    g_test_add_func("/response/refusals", test_refusals);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
