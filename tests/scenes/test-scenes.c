/* Runs every bundled scene and holds it against what is known about it: closed forms, amplitudes of linear systems,
 * conserved quantities worked out here from the record alone. Whatever the scene, the energy books must balance and the
 * rods must keep their lengths. */
#include <complex.h>
#include <glib.h>
#include <math.h>
#include <string.h>

#include "contact-cases.h"
#include "measures.h"
#include "mechanism-cases.h"
#include "meeting-cases.h"
#include "mistake-cases.h"
#include "program.h"
#include "rolling-cases.h"
#include "woodpecker-case.h"

typedef struct {
    const char *name;
    const char *duration; /* of the run whose books are looked at */
    void (*check)(const char *path);
    double books; /* what the balance of the books may miss, of the energy exchanged; 0: 1e-6 */
} SceneCase;

/* A throw by steps of first order loses m g^2 h / 2 a second, of each kilogram 0.05 W at a millisecond. */
#define FIRST_ORDER 0.005

/* y = y0 - m g / k (1 - cos(sqrt(k / m) t)). */
static void check_spring_mass(const char *path)
{
    const double times[] = {0.3, 2.0 * G_PI / 5.0, 5.0, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        const double t = times[row];
        CLOSE(test_table_value(record, row, "Mass 0.y"), 2.0 - GRAVITY / 25.0 * (1.0 - cos(5.0 * t)), 1e-8);
        CLOSE(test_table_value(record, row, "Mass 0.x"), 0.0, 1e-12);
    }
}

/* About its rest (4 - 2 - m g / k), with z = 0.1: -a exp(-z w t) (cos(v t) + z w / v sin(v t)), v = w sqrt(1 - z^2). */
static void check_damped_oscillator(const char *path)
{
    const double w = 5.0, z = 0.1, v = w * sqrt(1.0 - z * z), rest = 2.0 - GRAVITY / 25.0, a = rest - 1.1076;
    const double times[] = {0.3, 2.0 * G_PI / v, 4.0, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        const double t = times[row], swing = cos(v * t) + z * w / v * sin(v * t);
        CLOSE(test_table_value(record, row, "Mass 0.y"), rest - a * exp(-z * w * t) * swing, 1e-9);
    }
    /* a whole swing later */
    CLOSE((rest - test_table_value(record, 1, "Mass 0.y")) / a, 0.532, 5e-4);
}

static void check_network(const char *path)
{
    measure_check_energy(path, GRAVITY, "10");
}

/* Period 4 sqrt(L/g) K(sin(a/2)) for the amplitude a; at the bottom the rod pulls with m g (3 - 2 cos a). */
static void check_pendulum(const char *path)
{
    const double angle = G_PI / 3.0, length = 2.5;
    const double quarter = sqrt(length / GRAVITY) * measure_quarter_period(angle);
    const double times[] = {quarter, 2.0 * quarter, 4.0 * quarter};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 0, "Bob.x"), 0.0, 1e-8);
    CLOSE(test_table_value(record, 0, "Rod.tension"), GRAVITY * (3.0 - 2.0 * cos(angle)), 1e-7);
    CLOSE(test_table_value(record, 1, "Bob.x"), -length * sin(angle), 1e-8);
    CLOSE(test_table_value(record, 2, "Bob.x"), length * sin(angle), 1e-8);
}

static void check_motor_on_mass(const char *path)
{
    g_autoptr(TestTable) record = measure_last_period(path, 3.0, 60.0);
    CLOSE(measure_amplitude(record, "Mass 0.x", 3.0), 4.0 / cabs(25.0 - 9.0 + 3.0 * I), 1e-8);
}

/* A mass on a spring k to a support that moves by A sin(wt), with a damper c to the ground: k A / |k - m w^2 + i c w|.
 */
static void check_support_motion(const char *path)
{
    g_autoptr(TestTable) record = measure_last_period(path, 4.0, 100.0);
    CLOSE(measure_amplitude(record, "Mass 0.y", 4.0), 25.0 * 0.1 / cabs(25.0 - 16.0 + 0.5 * 4.0 * I), 1e-8);
}

/* The same fall as the table that a graph exports: two columns, trailing zeros dropped. */
static void check_free_fall_table(const char *path)
{
    static const char *const published =
        "Time,Y Position\n0,0\n0.01,-0.00049\n0.02,-0.00196\n0.03,-0.00441\n0.04,-0.00785\n0.05,-0.01226\n"
        "0.06,-0.01766\n0.07,-0.02403\n0.08,-0.03139\n0.09,-0.03973\n0.1,-0.04905\n";
    const char *arguments[] = {"graph", path, "Mass 0.y", "--decimals", "5", "-o", "-", NULL};
    g_autoptr(TestProgram) program = test_program_run(arguments);
    g_assert_cmpint(program->status, ==, 0);
    g_assert_true(g_str_has_prefix(program->output, published));
}

/* The first ten rows as they were published for this fall, five decimals each. */
static void check_free_fall(const char *path)
{
    static const char *const published[] = {"-0.00049", "-0.00196", "-0.00441", "-0.00785", "-0.01226",
                                            "-0.01766", "-0.02403", "-0.03139", "-0.03973", "-0.04905"};
    const char *options[] = {NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    g_assert_cmpuint(run->record->rows, ==, 101);
    for (gsize row = 0; row < G_N_ELEMENTS(published); row++) {
        const double y = test_table_value(run->record, row + 1, "Mass 0.y"), t = 0.01 * (double)(row + 1);
        g_autofree char *text = g_strdup_printf("%.5f", y);
        g_assert_cmpstr(text, ==, published[row]);
        CLOSE(y, -0.5 * GRAVITY * t * t, 1e-14);
    }
    check_free_fall_table(path);
}

/* Peaks of the drift for this record, from the exact recurrence for piecewise linear input in 30 digits; the one at the
 * samples agrees with Chopra, Dynamics of Structures, sec. 6.4 (2.67 in). */
static void check_base_excitation(const char *path)
{
    const char *options[] = {"--tolerance", "1e-11", "--method", "auto", "--columns", "Columns.extension", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    double least = 0.0;
    g_assert_cmpuint(run->record->rows, ==, 1560);
    for (gsize row = 0; row < run->record->rows; row++)
        least = fmin(least, test_table_value(run->record, row, "Columns.extension"));
    CLOSE(least, -0.0679400697200715, 1e-7 * 0.0679);

    const double peak_time = 2.35260413318;
    const char *at[] = {"--at", "2.35260413318", "--tolerance", "1e-11", "--columns", "Columns.extension", NULL};
    g_autoptr(TestSceneRun) peak = test_scene_run(path, at);
    const gsize row = test_table_row(peak->record, peak_time);
    CLOSE(test_table_value(peak->record, row, "Columns.extension"), -0.0682745772274636, 1e-7 * 0.0683);
}

static void check_double_pendulum(const char *path)
{
    measure_check_energy(path, GRAVITY, "10");
}

/* After half a minute those with an even count are back where they were and the others on the far side; after a minute
 * all are back. */
static void check_pendulum_wave(const char *path)
{
    const double times[] = {0.0, 30.0, 60.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (int count = 20; count <= 34; count++) {
        g_autofree char *column = g_strdup_printf("Bob %d.x", count);
        const double start = test_table_value(record, 0, column);
        g_assert_cmpfloat(start, >, 0.3);
        CLOSE(test_table_value(record, 1, column), count % 2 == 0 ? start : -start, 1e-6);
        CLOSE(test_table_value(record, 2, column), start, 1e-6);
    }
}

/* Displacements of three masses after 10 s, from an exponential of the chain's matrix in quadruple precision: a series
 * of 23 terms and 33 doublings. */
static void check_stiff_chain(const char *path)
{
    const double times[] = {10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 0, "Mass 1.x"), 0.2 - 0.039405348006644858, 1e-10);
    CLOSE(test_table_value(record, 0, "Mass 25.x"), 5.0 - 0.22589290755500446, 1e-10);
    CLOSE(test_table_value(record, 0, "Mass 50.x"), 10.0 - 0.23318212317135215, 1e-10);
}

/* Two modes: both masses together with k = 25, and against each other with k = 25 + 2 * 2. */
static void check_beats(const char *path)
{
    const double times[] = {1.0, 4.0, G_PI / (sqrt(29.0) - 5.0), 40.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        const double together = 0.3 * cos(5.0 * times[row]), apart = 0.3 * cos(sqrt(29.0) * times[row]);
        CLOSE(test_table_value(record, row, "Mass 0.x"), -1.5 + together + apart, 1e-8);
        CLOSE(test_table_value(record, row, "Mass 1.x"), 1.5 + together - apart, 1e-8);
    }
}

/* Alone, at resonance from rest: x = F / (2 m w^2) (sin wt - wt cos wt). With the absorber the steady amplitude of the
 * two-mass system. */
static void check_tuned_mass_damper(const char *path)
{
    const double times[] = {3.3, 10.0};
    g_autoptr(TestTable) alone = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < alone->rows; row++) {
        const double phase = 10.0 * times[row];
        CLOSE(test_table_value(alone, row, "Main mass alone.x"),
              -0.5 + 5.0 / (2.0 * 1000.0) * (sin(phase) - phase * cos(phase)), 1e-8);
    }
    const double w = 10.0, m2 = 0.5, k2 = 45.35, c2 = 1.21;
    const double complex link = k2 + I * c2 * w, main_mass = 1000.0 - 10.0 * w * w;
    const double complex absorber = link - m2 * w * w;
    const double complex steady = 5.0 / (main_mass + link - link * link / absorber);
    g_autoptr(TestTable) record = measure_last_period(path, w, 100.0);
    CLOSE(measure_amplitude(record, "Main mass with absorber.x", w), cabs(steady), 1e-8);
    CLOSE(measure_amplitude(record, "Absorber.x", w), cabs(steady * link / absorber), 1e-8);
}

/* No force from outside: momentum stays 0 and the angular momentum what it was, 4 m w r^2. */
static void check_rotating_square(const char *path)
{
    const double times[] = {0.0, 1.3, 5.0, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    double radius[G_N_ELEMENTS(times)] = {0.0};
    for (gsize row = 0; row < record->rows; row++) {
        double momentum = 0.0, angular = 0.0;
        for (int i = 0; i < 4; i++) {
            double state[4];
            const char *const quantities[] = {"x", "y", "vx", "vy"};
            for (int q = 0; q < 4; q++) {
                g_autofree char *column = g_strdup_printf("Mass %d.%s", i, quantities[q]);
                state[q] = test_table_value(record, row, column);
            }
            momentum += state[2];
            angular += state[0] * state[3] - state[1] * state[2];
            radius[row] = hypot(state[0], state[1]);
        }
        CLOSE(momentum, 0.0, 1e-10);
        CLOSE(angular, 16.0, 1e-9);
    }
    g_assert_cmpfloat(fabs(radius[1] - radius[0]), >, 0.01);
}

/* At rest every link pulls with the same horizontal force, and the ends carry the weight of 19 beads. */
static void check_hanging_cable(const char *path)
{
    const double times[] = {100.0};
    g_autoptr(TestTable) record = measure_at(path, times, 1);
    double from[2] = {-3.0, 2.0}, first = 0.0, up_left = 0.0, up_right = 0.0;
    for (int i = 1; i <= 20; i++) {
        g_autofree char *x = g_strdup_printf("Bead %d.x", i), *y = g_strdup_printf("Bead %d.y", i);
        g_autofree char *tension = g_strdup_printf("Link %d.tension", i);
        const double to[2] = {i < 20 ? test_table_value(record, 0, x) : 3.0,
                              i < 20 ? test_table_value(record, 0, y) : 2.0};
        const double pull = test_table_value(record, 0, tension), length = hypot(to[0] - from[0], to[1] - from[1]);
        const double across = pull * (to[0] - from[0]) / length;
        CLOSE(length, 0.4, 1e-12);
        if (i == 1) {
            first = across;
            up_left = pull * (from[1] - to[1]) / length;
        }
        up_right = pull * (to[1] - from[1]) / length;
        CLOSE(across, first, 1e-6);
        from[0] = to[0];
        from[1] = to[1];
    }
    CLOSE(up_left + up_right, 19 * 0.1 * GRAVITY, 1e-6);
    CLOSE(up_left, up_right, 1e-6);
}

/* y = -(v^2 / g) log(cosh(g t / v)) with v = sqrt(m g / drag). */
static void check_terminal_velocity(const char *path)
{
    const struct {
        const char *y, *vy;
        double mass;
    } bodies[] = {{"Light.y", "Light.vy", 1.0}, {"Heavy.y", "Heavy.vy", 4.0}};
    const double times[] = {0.5, 2.0, 5.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize body = 0; body < G_N_ELEMENTS(bodies); body++) {
        const double v = sqrt(bodies[body].mass * GRAVITY / 0.1);
        for (gsize row = 0; row < record->rows; row++) {
            CLOSE(test_table_value(record, row, bodies[body].y), -v * v / GRAVITY * log(cosh(GRAVITY * times[row] / v)),
                  1e-8);
            CLOSE(test_table_value(record, row, bodies[body].vy), -v * tanh(GRAVITY * times[row] / v), 1e-8);
        }
    }
}

static void check_four_bar(const char *path)
{
    measure_check_energy(path, 0.0, "10");
}

/* The mean motion is that of a particle in the potential -g L cos + (A w sin)^2 / 4 (Kapitza): upright is stable, so
 * the bob never comes further down than three times the start angle. */
static void check_kapitza(const char *path)
{
    const char *options[] = {NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    double leftmost = 0.0;
    for (gsize row = 0; row < run->record->rows; row++) {
        g_assert_cmpfloat(test_table_value(run->record, row, "Bob.y"), >, cos(G_PI / 6.0) - 0.08);
        leftmost = fmin(leftmost, test_table_value(run->record, row, "Bob.x"));
    }
    g_assert_cmpfloat(leftmost, <, -0.1);
}

static void check_falling_chain(const char *path)
{
    measure_check_energy(path, GRAVITY, "2");
}

/* Springs k to a beam that moves by A sin(wt), air drag c on the masses: k A / |k - m w^2 + i c w| each. */
static void check_resonance(const char *path)
{
    const double w = 6.0;
    g_autoptr(TestTable) record = measure_last_period(path, w, 200.0);
    for (int i = 0; i < 7; i++) {
        const double own = 4.5 + 0.5 * i;
        g_autofree char *column = g_strdup_printf("Reed %g.y", own);
        CLOSE(measure_amplitude(record, column, w), own * own * 0.06 / cabs(own * own - w * w + I * 0.25 * w), 1e-8);
    }
}

static void check_projectiles(const char *path)
{
    const double times[] = {0.7, 14.0 / GRAVITY, 2.4};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (int degrees = 30; degrees <= 60; degrees += 15) {
        g_autofree char *x = g_strdup_printf("Thrown at %d.x", degrees),
                        *y = g_strdup_printf("Thrown at %d.y", degrees);
        const double angle = degrees * G_PI / 180.0;
        for (gsize row = 0; row < record->rows; row++) {
            const double t = times[row];
            CLOSE(test_table_value(record, row, x), 14.0 * cos(angle) * t, 1e-12 * 30.0);
            CLOSE(test_table_value(record, row, y), 14.0 * sin(angle) * t - 0.5 * GRAVITY * t * t, 1e-12 * 30.0);
        }
    }
}

static void check_spring_pendulum(const char *path)
{
    measure_check_energy(path, GRAVITY, "40");
}

static const SceneCase scene_cases[] = {
    {"balanced-arm", "6", check_balanced_arm},
    {"ball-in-a-box", "3", check_ball_in_a_box},
    {"base-excitation", "10", check_base_excitation},
    {"beats", "10", check_beats},
    {"block-and-tackle", "3", check_block_and_tackle},
    {"bouncing-balls", "8", check_bouncing_balls},
    {"compound-pendulum", "10", check_compound_pendulum},
    {"damped-oscillator", "10", check_damped_oscillator},
    {"dominoes", "1.5", check_dominoes},
    {"double-bar-pendulum", "10", check_double_bar_pendulum},
    {"double-pendulum", "10", check_double_pendulum},
    {"el-centro-block", "10", check_el_centro_block},
    {"falling-chain", "1", check_falling_chain},
    {"four-bar-coupler-curve", "8", check_four_bar_coupler_curve},
    {"four-bar-linkage", "10", check_four_bar},
    {"free-fall", "1", check_free_fall},
    {"friction-incline", "10", check_friction_incline},
    {"friction-oscillator", "6", check_friction_oscillator},
    {"gear-train", "3", check_gear_train},
    {"geneva-wheel", "2", check_geneva_wheel},
    {"hanging-cable", "3", check_hanging_cable},
    {"heavy-pulley", "1.2", check_heavy_pulley},
    {"incline-landing", "4", check_incline_landing},
    {"kapitza-pendulum", "4", check_kapitza},
    {"ladder-on-wall", "1", check_ladder_on_wall},
    {"lift-off", "4", check_lift_off},
    {"motor-on-mass", "10", check_motor_on_mass},
    {"newtons-cradle", "3.5", check_newtons_cradle},
    {"newtons-cradle-at-once", "2", check_newtons_cradle_at_once},
    {"normal-forces", "2", check_normal_forces},
    {"one-sided-support", "1.5", check_one_sided_support},
    {"pendulum", "10", check_pendulum},
    {"pendulum-wave", "10", check_pendulum_wave},
    {"pile-and-ball", "1.5", check_pile_and_ball, .books = FIRST_ORDER},
    {"pin-friction", "14", check_pin_friction},
    {"planetary-gear", "12", check_planetary_gear},
    {"projectiles", "2.5", check_projectiles},
    {"pulled-spool", "2", check_pulled_spool},
    {"quick-return", "6", check_quick_return},
    {"resonance", "10", check_resonance},
    {"rocking-block", "3", check_rocking_block},
    {"rod-tension", "3", check_rod_tension},
    {"rolling-resistance", "9", check_rolling_resistance},
    {"rolling-race", "2", check_rolling_race},
    {"rotating-spring-square", "10", check_rotating_square},
    {"scotch-yoke", "6", check_scotch_yoke},
    {"slider-crank", "2", check_slider_crank},
    {"sliding-ladder", "3", check_sliding_ladder},
    {"slipping-to-rolling", "2", check_slipping_to_rolling},
    {"spring-mass", "10", check_spring_mass},
    {"spring-mass-network", "5", check_network},
    {"spring-pendulum", "10", check_spring_pendulum},
    {"stick-slip-belt", "12", check_stick_slip_belt},
    {"stiff-chain", "10", check_stiff_chain},
    {"support-motion", "10", check_support_motion},
    {"terminal-velocity", "5", check_terminal_velocity},
    {"thrown-up", "1.2", check_thrown_up},
    {"tip-or-slide", "1.2", check_tip_or_slide},
    {"tuned-mass-damper", "10", check_tuned_mass_damper},
    {"woodpecker", "2.2", check_woodpecker},
    {"yo-yo", "1.5", check_yo_yo},
};

/* The scene as it is, with its own settings but for a shorter run, and then what is known about it. */
static void test_scene(gconstpointer data)
{
    const SceneCase *scene = data;
    g_autofree char *file = g_strconcat(scene->name, ".tinker.json", NULL);
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), file, NULL);
    cJSON *text = test_read_json(path);
    g_assert_true(cJSON_IsString(cJSON_GetObjectItemCaseSensitive(text, "title")));
    g_assert_true(cJSON_IsString(cJSON_GetObjectItemCaseSensitive(text, "description")));
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItemCaseSensitive(text, "graphs")), >, 0);
    cJSON_Delete(text);

    const char *check[] = {"check", path, NULL};
    g_autoptr(TestProgram) checked = test_program_run(check);
    g_assert_cmpint(checked->status, ==, 0);

    const char *options[] = {"--duration", scene->duration, NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    g_assert_cmpfloat(test_summary_number(run, "energy_balance_error"), <, scene->books> 0 ? scene->books : 1e-6);
    g_assert_cmpfloat(test_summary_number(run, "constraint_position_error"), <, 1e-10);
    scene->check(path);
}

/* Every scene of the folder is among the cases. */
static void test_all_are_here(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GDir) folder = g_dir_open(g_getenv("TINKER_SCENES"), 0, &error);
    g_assert_no_error(error);
    guint scenes = 0;
    for (const char *name = g_dir_read_name(folder); name != NULL; name = g_dir_read_name(folder))
        scenes += g_str_has_suffix(name, ".tinker.json");
    g_assert_cmpuint(scenes, ==, G_N_ELEMENTS(scene_cases));
}

/* The earthquake record is the file it is said to be. */
static void test_record_is_unchanged(void)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), "el-centro-1940-ns.csv", NULL);
    g_autofree char *text = test_read_file(path);
    g_autofree char *sum = g_compute_checksum_for_string(G_CHECKSUM_SHA256, text, -1);
    g_assert_cmpstr(sum, ==, "c8db38c6a99e08c5b2446f4ce51b68d96a549ce4f6bab415aa4e5ba7c60c014d");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(scene_cases); i++) {
        g_autofree char *path = g_strconcat("/scenes/", scene_cases[i].name, NULL);
        g_test_add_data_func(path, &scene_cases[i], test_scene);
    }
    g_test_add_func("/folder/all-are-here", test_all_are_here);
    g_test_add_func("/folder/record-is-unchanged", test_record_is_unchanged);
    return g_test_run();
}
