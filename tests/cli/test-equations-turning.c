/* Equations, diagrams and books of bodies that turn, against closed forms: the compound pendulum, a beam that is held
 * more often than it needs, a rope over a wheel. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "fixture.h"
#include "written.h"

/* A bar of 2 kg and 1.2 m that is let go at 0.5 rad from straight down, on a pin at its end. */
#define MASS     2.0
#define LENGTH   1.2
#define GRAVITY  9.81
#define AT_START 0.5

static char *pendulum(void)
{
    return g_strdup_printf(
        "{\"tinker\": 1, \"run\": {\"duration\": 2, \"tolerance\": 1e-12}, \"blocks\": ["
        "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": %g},"
        "{\"type\": \"support\", \"name\": \"Pivot\", \"position\": [0, 3], \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Bar\", \"mass\": %g, \"length\": %g, \"position\": [%.17g, %.17g],"
        " \"orientation\": %.17g},"
        "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [\"Pivot\", {\"block\": \"Bar\", \"at\": [%g, 0]}]}]}",
        GRAVITY, MASS, LENGTH, LENGTH / 2 * sin(AT_START), 3 - LENGTH / 2 * cos(AT_START), AT_START - G_PI_2,
        -LENGTH / 2);
}

/* alpha = -m g d sin(theta) / (I + m d^2) with d = l/2, I = m l^2/12; the pin gives m a - m g, a = d alpha along the
 * path at the start. */
static void test_pendulum(CliFixture *fixture, gconstpointer data)
{
    const double d = LENGTH / 2, inertia = MASS * LENGTH * LENGTH / 12;
    const double alpha = -MASS * GRAVITY * d * sin(AT_START) / (inertia + MASS * d * d);
    g_autofree char *text = pendulum(), *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_near(written_symbol(root, "Bar.angle"), AT_START - G_PI_2, 1e-15);
    written_assert_near(written_symbol(root, "I"), inertia, 1e-15);
    written_assert_near(written_symbol(root, "λx"), MASS * d * alpha * cos(AT_START), 1e-12);
    written_assert_near(written_symbol(root, "λy"), MASS * (GRAVITY + d * alpha * sin(AT_START)), 1e-12);
    const cJSON *body = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "bodies"), 0);
    g_assert_cmpstr(cJSON_GetObjectItem(body, "inertia")->valuestring, ==, "I");
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "constraints")), ==, 2);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "not_written")), ==, 0);
    cJSON_Delete(root);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json");
    g_autofree char *shown = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted = g_utf8_normalize("I θ̈ = r₂x λy − r₂y λx   Pin\n", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(shown, wanted);
    g_autoptr(TestProgram) values = cli_run_well(fixture, "equations @scene.json --at 0.1");
    g_assert_nonnull(strstr(values->output, " N·m\n")); /* a moment is no energy */
    g_assert_null(strstr(values->output, " J\n"));

    root = written_json(fixture, "diagram @scene.json --block Bar --time 0 --as json");
    const cJSON *kinetic = cJSON_GetObjectItem(root, "kinetic");
    written_assert_near(cJSON_GetObjectItem(kinetic, "torque")->valuedouble, inertia * alpha, 1e-12);
    written_assert_near(cJSON_GetObjectItem(root, "inertia")->valuedouble, inertia, 1e-15);
    cJSON_Delete(root);
}

/* A disc of 3 N m/rad that is turned by 0.2 rad: the spring's torque stands in the diagram, and is all there is. */
static void test_torque(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"Disc\", \"solid\": false, \"orientation\": 0.2},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"Disc\"]},"
        "{\"type\": \"torsional-spring\", \"name\": \"Coil\", \"ends\": [\"Axle\", \"Disc\"], \"stiffness\": 3, "
        "\"rest_angle\": 0}]}");
    cJSON *root = written_json(fixture, "diagram @scene.json --block Disc --time 0 --as json");
    const cJSON *each, *forces = cJSON_GetObjectItem(root, "forces");
    double torque = 0;
    cJSON_ArrayForEach(each, forces) if (strcmp(cJSON_GetObjectItem(each, "from")->valuestring, "Coil") == 0) torque +=
        cJSON_GetObjectItem(each, "torque")->valuedouble;
    written_assert_near(torque, -0.6, 1e-15);
    written_assert_near(cJSON_GetObjectItem(cJSON_GetObjectItem(root, "kinetic"), "torque")->valuedouble, -0.6, 1e-15);
    cJSON_Delete(root);
}

/* The compound pendulum of a textbook, (m a^2 + I) theta'' + m g a sin theta = 0, with a = -a_x: the pin is behind the
 * centre. A rod that hangs on its other end makes it a double pendulum, in two angles. */
static void test_angles(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *text = pendulum(), *scene = cli_write(fixture, "scene.json", text);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form angles");
    g_autofree char *shown = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted = g_utf8_normalize("(m a² + I) θ̈ + m g a sin(θ) = 0\n", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(shown, wanted);
    cli_assert_holds(shown, "θ = 0.5 rad   Bar, from straight down");
    cli_assert_holds(shown, "Bar: from its joint to its centre of mass\n");
    cli_assert_holds(shown, "a = 0.6 m\n");
    static const char more[] =
        ",{\"type\": \"mass\", \"name\": \"Bob\", \"mass\": 1, \"position\": [0.6, 1]},"
        "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"Bob\", {\"block\": \"Bar\", \"at\": "
        "[0.6, 0]}]}]}";
    text[strlen(text) - 2] = '\0';
    g_autofree char *longer = g_strconcat(text, more, NULL), *second = cli_write(fixture, "scene.json", longer);
    cJSON *root = written_json(fixture, "equations @scene.json --form angles --as json");
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    const cJSON *rod = cJSON_GetArrayItem(cJSON_GetObjectItem(island, "angles"), 1);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(island, "equations")), ==, 2);
    g_assert_cmpstr(cJSON_GetObjectItem(rod, "block")->valuestring, ==, "Rod");
    const double x = LENGTH * sin(AT_START), y = 3 - LENGTH * cos(AT_START);
    written_assert_near(cJSON_GetObjectItem(rod, "value")->valuedouble, atan2(0.6 - x, y - 1), 1e-12);
    cJSON_Delete(root);
}

/* Two bars, of which the second hangs on the end of the first, and two pendulums as one: textbooks' equations, with the
 * masses that the same length moves put together, and lengths that are not negative whichever way the bars lie. */
static void test_double_pendulums(CliFixture *fixture, gconstpointer data)
{
    static const char bars[] =
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Pivot\", \"position\": [0, 3], \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"B1\", \"length\": 1.2, \"position\": [0.6, 3]},"
        "{\"type\": \"bar\", \"name\": \"B2\", \"length\": 1, \"position\": [1.7, 3], \"orientation\": \"180 deg\"},"
        "{\"type\": \"pin\", \"ends\": [\"Pivot\", {\"block\": \"B1\", \"at\": [-0.6, 0]}]},"
        "{\"type\": \"pin\", \"ends\": [{\"block\": \"B1\", \"at\": [0.6, 0]}, {\"block\": \"B2\", \"at\": [0.5, "
        "0]}]}]}";
    static const char masses[] =
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Pivot\", \"position\": [0, 3], \"solid\": false},"
        "{\"type\": \"mass\", \"name\": \"M1\", \"position\": [1, 3]}, {\"type\": \"mass\", \"name\": \"M2\", "
        "\"position\": [2, 3]},"
        "{\"type\": \"rod\", \"name\": \"R1\", \"ends\": [\"Pivot\", \"M1\"]}, {\"type\": \"rod\", \"name\": \"R2\", "
        "\"ends\": [\"M1\", \"M2\"]}]}";
    static const char *const of_bars[] = {
        "(m₁ a₁² + m₂ l₁² + I₁) θ̈₁ + m₂ l₁ a₂ cos(θ₁ − θ₂) θ̈₂ + m₂ l₁ a₂ sin(θ₁ − θ₂) θ̇₂² + (m₁ a₁ + m₂ l₁) g sin(θ₁) "
        "= 0\n",
        " m₂ l₁ a₂ cos(θ₁ − θ₂) θ̈₁ − m₂ l₁ a₂ sin(θ₁ − θ₂) θ̇₁² + (m₂ a₂² + I₂) θ̈₂ + m₂ g a₂ sin(θ₂) = 0\n",
        "l₁ = a_1,1x − a_0,2x ",
        "l₁ = 1.2 m\n",
        "a₂ = a_1,2x ",
        "a₂ = 0.5 m\n",
        NULL};
    static const char *const of_masses[] = {
        "(m₁ + m₂) l₁² θ̈₁ + m₂ l₁ l₂ cos(θ₁ − θ₂) θ̈₂ + m₂ l₁ l₂ sin(θ₁ − θ₂) θ̇₂² + (m₁ + m₂) g l₁ sin(θ₁) = 0\n", NULL};
    g_autofree char *first = cli_write(fixture, "scene.json", bars);
    written_assert_page(fixture, "equations @scene.json --form angles", of_bars);
    g_autofree char *second = cli_write(fixture, "scene.json", masses);
    written_assert_page(fixture, "equations @scene.json --form angles", of_masses);
}

/* Every equation in the angles is 0 with the accelerations of the run, to the limit times its largest term. */
static void assert_equations_hold(const cJSON *root, const double accelerations[2])
{
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0), *each;
    WrittenValues known = written_values(root);
    int angles = 0;
    known.definitions[1] = cJSON_GetObjectItem(island, "definitions");
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(island, "angles"))
    {
        written_know(&known, cJSON_GetObjectItem(each, "symbol")->valuestring,
                     cJSON_GetObjectItem(each, "value")->valuedouble);
        written_know(&known, cJSON_GetObjectItem(each, "rate")->valuestring,
                     cJSON_GetObjectItem(each, "rate_value")->valuedouble);
        written_know(&known, cJSON_GetObjectItem(each, "acceleration")->valuestring, accelerations[angles++]);
    }
    g_assert_cmpint(angles, ==, 2);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(island, "blocks")), ==, 2);
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(island, "equations"))
        written_assert_near(written_value(&known, each), 0, 1e-9);
    g_hash_table_unref(known.values);
}

/* A box on a pin, and a bar that hangs on the box, with joints on either axis of the box and on none: the equations in
 * angles are those of the run. */
static void test_joints_off_axes(CliFixture *fixture, gconstpointer data)
{
    static const double places[][4] = {{0, 0.5, 0, -0.5},     {0, -0.5, 0.3, 0.2}, {-0.3, 0.4, 0, 0},
                                       {0.3, 0.2, -0.4, 0.1}, {0, 0, 0.2, 0.3},    {0.4, 0, -0.1, 0.3}};
    for (gsize i = 0; i < G_N_ELEMENTS(places); i++) {
        const double *at = places[i], turn = 0.4;
        const double x = -(at[0] * cos(turn) - at[1] * sin(turn)), y = 3 - (at[0] * sin(turn) + at[1] * cos(turn));
        const double joint_x = x + at[2] * cos(turn) - at[3] * sin(turn),
                     joint_y = y + at[2] * sin(turn) + at[3] * cos(turn);
        g_autofree char *text = g_strdup_printf(
            "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
            "{\"type\": \"support\", \"name\": \"Pivot\", \"position\": [0, 3], \"solid\": false},"
            "{\"type\": \"box\", \"name\": \"Box\", \"mass\": 2, \"position\": [%.17g, %.17g], \"orientation\": %g,"
            " \"angular_velocity\": 1.5, \"solid\": false},"
            "{\"type\": \"bar\", \"name\": \"Bar\", \"mass\": 0.7, \"length\": 1, \"orientation\": 0,"
            " \"position\": [%.17g, %.17g]},"
            "{\"type\": \"pin\", \"ends\": [\"Pivot\", {\"block\": \"Box\", \"at\": [%g, %g]}]},"
            "{\"type\": \"pin\", \"ends\": [{\"block\": \"Box\", \"at\": [%g, %g]}, {\"block\": \"Bar\", \"at\":"
            " [-0.5, 0]}]}]}",
            x, y, turn, joint_x + 0.5, joint_y, at[0], at[1], at[2], at[3]);
        g_autofree char *scene = cli_write(fixture, "scene.json", text);
        g_autoptr(TestProgram) run = cli_run_well(
            fixture,
            "run @scene.json --csv - --at 0.2 --columns \"Box.angular acceleration,Bar.angular acceleration\"");
        const char *row = strchr(run->output, '\n') + 1;
        char *end = strchr(row, ',') + 1;
        double accelerations[2];
        accelerations[0] = g_ascii_strtod(end, &end);
        accelerations[1] = g_ascii_strtod(end + 1, NULL);
        cJSON *root = written_json(fixture, "equations @scene.json --form angles --at 0.2 --as json");
        assert_equations_hold(root, accelerations);
        cJSON_Delete(root);
    }
}

/* A rope from a load to a place on a beam that hangs upside down, to another and to a second load: each part of it has
 * a name, and what is known of a beam upside down is not left as sin and cos. */
static void test_spans(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
                  "{\"type\": \"support\", \"name\": \"Beam\", \"position\": [0, 3], \"orientation\": \"180 deg\", "
                  "\"solid\": false},"
                  "{\"type\": \"mass\", \"name\": \"M1\", \"position\": [-1, 0]}, {\"type\": \"mass\", \"name\": "
                  "\"M2\", \"position\": [1, 0]},"
                  "{\"type\": \"rope\", \"name\": \"Rope\", \"ends\": [\"M1\", {\"block\": \"Beam\", \"at\": [1, 0]},"
                  "{\"block\": \"Beam\", \"at\": [-1, 0]}, \"M2\"]}]}");
    static const char *const lines[] = {"L = L₁ + L₂ + L₃ ",
                                        "L₁ = √((−a₂x − x₁)² + (Y − y₁)²) ",
                                        "Rope: span 1, from M1 to Beam\n",
                                        "Rope: span 3, from Beam to M2\n",
                                        "L₃ = 3 m\n",
                                        NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    const double expected = 9.81;
    written_assert_near(written_symbol(root, "λ"), -expected, 1e-12);
    cJSON_Delete(root);
    static const char *const rows[] = {"Rope, end 2  constraint", "on to M1 and Beam\n", "Rope, end 3  constraint",
                                       "on to Beam and M2\n", NULL};
    written_assert_page(fixture, "diagram @scene.json --block Beam", rows);
}

/* Wheels of I1, I2 and I3 that a torque M sets going, the second geared to the first by i, the third inside the second
 * by k: theta_2 = -i theta_1, theta_3 = k theta_2, so that (I1 + i^2 I2 + i^2 k^2 I3) alpha_1 = M. What the first gear
 * carries is what turns the second and the third. */
static void test_gears(CliFixture *fixture, gconstpointer data)
{
    const double inertia[] = {0.5, 2, 3}, i = 0.4, k = 1.5, torque = 7;
    const double alpha = torque / (inertia[0] + i * i * inertia[1] + i * i * k * k * inertia[2]);
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"A\", \"solid\": false, \"inertia\": 0.5},"
        "{\"type\": \"disc\", \"name\": \"B\", \"solid\": false, \"inertia\": 2, \"orientation\": 0.3},"
        "{\"type\": \"disc\", \"name\": \"C\", \"solid\": false, \"inertia\": 3},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"A\"]}, {\"type\": \"pin\", \"ends\": [\"Axle\", \"B\"]},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"C\"]},"
        "{\"type\": \"gear\", \"name\": \"Outer\", \"ends\": [\"A\", \"B\"], \"ratio\": 0.4},"
        "{\"type\": \"gear\", \"name\": \"Inner\", \"ends\": [\"B\", \"C\"], \"ratio\": 1.5, \"internal\": true},"
        "{\"type\": \"torque\", \"name\": \"Motor\", \"ends\": [\"A\", \"Axle\"], \"amplitude\": 7}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "λ_4"), -i * alpha * (inertia[1] + k * k * inertia[2]), 1e-12);
    written_assert_near(written_symbol(root, "λ_5"), -i * k * alpha * inertia[2], 1e-12);
    cJSON_Delete(root);
    /* the wheels' bearings carry what gears do to them together: it is on no other wheel */
    root = written_json(fixture, "books @scene.json --block A --block B --block C --to 2 --as json");
    const cJSON *angular = cJSON_GetObjectItem(root, "angular");
    const double scale = cJSON_GetObjectItem(angular, "scale")->valuedouble;
    written_assert_near(cJSON_GetArrayItem(cJSON_GetObjectItem(angular, "angular_momentum"), 1)->valuedouble,
                        (inertia[0] - i * inertia[1] - i * k * inertia[2]) * alpha * 2, 1e-9 * scale);
    written_assert_near(cJSON_GetObjectItem(angular, "residual")->valuedouble, 0, 1e-9 * scale);
    g_assert_nonnull(cJSON_GetObjectItem(cJSON_GetObjectItem(angular, "impulses"), "Outer"));
    cJSON_Delete(root);
    static const char *const lines[] = {"0 = θ₂ − θ0_4,2 + i₄ (θ₁ − θ0_4,1) ", "0 = θ₃ − θ0_5,2 − i₅ (θ₂ − θ0_5,1) ",
                                        "+ M   Outer + Motor", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A crank that is driven as n t + A cos(omega t): it takes I theta'' = -I A omega^2 at the start. */
static void test_drive(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"Crank\", \"solid\": false, \"inertia\": 0.5},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"Crank\"]},"
        "{\"type\": \"drive\", \"name\": \"Drive\", \"ends\": [\"Crank\", \"Axle\"], \"speed\": 2, \"waveform\": "
        "\"cosine\", \"amplitude\": 0.3, \"frequency\": 5}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "λ_2"), -0.5 * 0.3 * 25, 1e-12);
    cJSON_Delete(root);
    static const char *const lines[] = {"− n t − (u − u0)   Drive", "u0 = A ", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A disc and a hoop that roll down a plank of slope a: with k = I / m r^2, N = m g cos a, f = m g sin a k / (1 + k) up
 * the plank, and f turns it by f r. A box that slides is pushed at two corners, with N in sum m g cos a. */
static void test_rolling(CliFixture *fixture, gconstpointer data)
{
    const double slope = 0.3, g = 9.81, c = cos(slope), s = sin(slope), mass = 2, r = 0.25;
    g_autofree char *text = g_strdup_printf(
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\", \"name\": \"Gravity\"},"
        "{\"type\": \"support\", \"name\": \"Plank\", \"width\": 40, \"height\": 0.4, \"orientation\": %.17g,"
        " \"static_friction\": 0.6, \"dynamic_friction\": 0.1},"
        "{\"type\": \"disc\", \"name\": \"Disc\", \"mass\": 2, \"radius\": %g, \"position\": [%.17g, %.17g]},"
        "{\"type\": \"disc\", \"name\": \"Hoop\", \"mass\": 2, \"radius\": %g, \"inertia\": 0.125, \"position\": "
        "[%.17g, "
        "%.17g]}]}",
        -slope, r, s * (0.2 + r), c * (0.2 + r), r, s * (0.2 + r) + 3 * c, c * (0.2 + r) - 3 * s);
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "N_1"), mass * g * c, 1e-9);
    written_assert_near(written_symbol(root, "N_2"), mass * g * c, 1e-9);
    written_assert_near(written_symbol(root, "f_1"), -mass * g * s / 3, 1e-9);
    written_assert_near(written_symbol(root, "f_2"), -mass * g * s / 2, 1e-9);
    cJSON_Delete(root);
    static const char *const lines[] = {"I₁ θ̈₁ = f₁ R₁",
                                        "− (H / 2 + R₁) ",
                                        "+ R₁ θ₁ − s0₁ ",
                                        "I₂ θ̈₂ = f₂ R₂",
                                        "friction force, sticks while |f₁| ≤ µs N₁)",
                                        "µs = 0.6 ",
                                        NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A box that slides: pushed at its two lower corners, whose forces make up its weight, and whose moments with
 * friction's cancel, so that the front carries more, N2 - N1 = mu m g h / w. */
static void test_sliding_box(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\", \"name\": \"Gravity\"},"
        "{\"type\": \"support\", \"name\": \"Floor\", \"width\": 40, \"height\": 0.4, \"static_friction\": 0.3, "
        "\"dynamic_friction\": 0.3},"
        "{\"type\": \"box\", \"name\": \"Box\", \"mass\": 2, \"width\": 0.8, \"height\": 0.4, \"position\": [0, 0.4], "
        "\"velocity\": [2, 0]}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    const double weight = 2 * 9.81, a = written_symbol(root, "N_1"), b = written_symbol(root, "N_2");
    written_assert_near(a + b, weight, 1e-9);
    written_assert_near(fabs(b - a), 0.3 * weight * 0.4 / 0.8, 1e-9);
    cJSON_Delete(root);
    static const char *const lines[] = {"I θ̈ = r₁x N₁ + r₁y σ₁ µd N₁ + r₂x N₂ + r₂y σ₂ µd N₂", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A heavy wheel between two loads on cords, of 2 kg, 3 kg and 5 kg: a = (5 - 3) g / (3 + 5 + 2/2), with the tensions
 * 3 (g + a) and 5 (g - a), which turn the wheel by their radius. */
static void test_cords(CliFixture *fixture, gconstpointer data)
{
    const double g = 9.81, a = (5 - 3) * g / (3 + 5 + 1);
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\", \"name\": \"Gravity\"},"
        "{\"type\": \"support\", \"name\": \"Axle\", \"position\": [0, 5], \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"Wheel\", \"mass\": 2, \"radius\": 0.3, \"position\": [0, 5], \"solid\": "
        "false},"
        "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [\"Axle\", \"Wheel\"]},"
        "{\"type\": \"mass\", \"name\": \"Light\", \"mass\": 3, \"position\": [-0.3, 3]},"
        "{\"type\": \"mass\", \"name\": \"Heavy\", \"mass\": 5, \"position\": [0.3, 3]},"
        "{\"type\": \"cord\", \"name\": \"To light\", \"ends\": [\"Wheel\", \"Light\"], \"side\": \"right\"},"
        "{\"type\": \"cord\", \"name\": \"To heavy\", \"ends\": [\"Wheel\", \"Heavy\"], \"side\": \"left\"}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --at 0.3 --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "λ_2"), -3 * (g + a), 1e-9);
    written_assert_near(written_symbol(root, "λ_3"), -5 * (g - a), 1e-9);
    cJSON_Delete(root);
    static const char *const lines[] = {"I₁ θ̈₁ = λ₂ (1 − 2 f₂) R₂ + λ₃ R₃", "m₂ ÿ₂ = −m₂ g + λ₂ e_2,2y", "2π R₂", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A damper from a place on a beam that swings: its end there moves by omega x r. */
static void test_turned_support(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Beam\", \"solid\": false},"
                  "{\"type\": \"support-turn\", \"ends\": [\"Beam\"], \"waveform\": \"sine\", \"amplitude\": 0.5, "
                  "\"frequency\": 3},"
                  "{\"type\": \"mass\", \"name\": \"Bob\", \"position\": [1, -2]},"
                  "{\"type\": \"damper\", \"ends\": [{\"block\": \"Beam\", \"at\": [1, 0]}, \"Bob\"]}]}");
    static const char *const lines[] = {
        "φ̇ = A ω cos(ω t)", "((x − a₁x cos(φ)) (ẋ + φ̇ a₁x sin(φ)) + (y − a₁x sin(φ)) (ẏ − φ̇ a₁x cos(φ))) / L", NULL};
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    cJSON_Delete(root);
    written_assert_page(fixture, "equations @scene.json", lines);
}

static const cJSON *account(const cJSON *root, const char *section, const char *list, const char *block)
{
    return cJSON_GetObjectItemCaseSensitive(cJSON_GetObjectItem(cJSON_GetObjectItem(root, section), list), block);
}

/* The pin does no work; about itself it gives no angular impulse, and gravity gives all of it. */
static void test_books(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *text = pendulum(), *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = written_json(fixture, "books @scene.json --block Bar --from 0 --to 1 --about 0,3 --as json");
    const cJSON *energy = cJSON_GetObjectItem(root, "energy"), *angular = cJSON_GetObjectItem(root, "angular");
    const double kinetic = cJSON_GetArrayItem(cJSON_GetObjectItem(energy, "kinetic"), 1)->valuedouble;
    written_assert_near(account(root, "energy", "work", "Pin")->valuedouble, 0, 1e-9);
    written_assert_near(account(root, "energy", "work", "Gravity")->valuedouble, kinetic, 1e-9);
    written_assert_near(account(root, "angular", "impulses", "Pin")->valuedouble, 0, 1e-9);
    const double spin = cJSON_GetArrayItem(cJSON_GetObjectItem(angular, "angular_momentum"), 1)->valuedouble;
    written_assert_near(account(root, "angular", "impulses", "Gravity")->valuedouble, spin, 1e-9);
    /* h = J omega and T = J omega^2 / 2 about the pin, with J = m l^2 / 3 */
    written_assert_near(kinetic, spin * spin / (2 * MASS * LENGTH * LENGTH / 3), 1e-9);
    cJSON_Delete(root);
}

/* A chain of 200 rods is not written out in its angles, and says so at once. */
static void test_long_chain(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(GString) text = g_string_new("{\"tinker\": 1, \"run\": {\"duration\": 1}, \"blocks\": ["
                                           "{\"type\": \"support\", \"name\": \"M0\", \"solid\": false}");
    for (int i = 1; i <= 200; i++)
        g_string_append_printf(text,
                               ",{\"type\": \"mass\", \"name\": \"M%d\", \"position\": [%d, %g]},"
                               "{\"type\": \"rod\", \"name\": \"R%d\", \"ends\": [\"M%d\", \"M%d\"]}",
                               i, i, 0.1 * (i % 2), i, i - 1, i);
    g_string_append(text, "]}");
    g_autofree char *scene = cli_write(fixture, "scene.json", text->str);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form angles");
    cli_assert_holds(page->output, "M1 has no equations in angles: it has too many angles to be written out");
}

/* A level beam pinned at both ends: the two pins share what pushes along it as they like, and each carries half of its
 * weight. */
static void test_redundant(CliFixture *fixture, gconstpointer data)
{
    static const char beam[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 1}, \"blocks\": ["
        "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10},"
        "{\"type\": \"support\", \"name\": \"Left\", \"position\": [-1, 0], \"solid\": false},"
        "{\"type\": \"support\", \"name\": \"Right\", \"position\": [1, 0], \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Beam\", \"mass\": 3, \"length\": 2, \"position\": [0, 0]},"
        "{\"type\": \"pin\", \"name\": \"Pin 0\", \"ends\": [\"Left\", {\"block\": \"Beam\", \"at\": [-1, 0]}]},"
        "{\"type\": \"pin\", \"name\": \"Pin 1\", \"ends\": [\"Right\", {\"block\": \"Beam\", \"at\": [1, 0]}]}]}";
    g_autofree char *scene = cli_write(fixture, "scene.json", beam);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    const cJSON *rows = cJSON_GetObjectItem(root, "constraints"), *row;
    cJSON_ArrayForEach(row, rows)
    {
        const char *multiplier = cJSON_GetObjectItem(row, "multiplier")->valuestring;
        const gboolean along = strstr(multiplier, "λx") != NULL;
        g_assert_cmpint(cJSON_IsTrue(cJSON_GetObjectItem(row, "redundant")), ==, along);
        written_assert_near(written_symbol(root, multiplier), along ? 0 : 15, 1e-9);
    }
    g_assert_cmpint(cJSON_GetArraySize(rows), ==, 4);
    cJSON_Delete(root);
}

/* A rope names its neighbours: at its first end the wheel, at the wheel both loads. Its tension is 2 m M g / (m + M).
 */
static void test_rope(CliFixture *fixture, gconstpointer data)
{
    static const char atwood[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10},"
        "{\"type\": \"support\", \"name\": \"Wheel\", \"position\": [0, 3], \"solid\": false},"
        "{\"type\": \"mass\", \"name\": \"Light\", \"mass\": 1, \"position\": [-0.001, 1]},"
        "{\"type\": \"mass\", \"name\": \"Heavy\", \"mass\": 3, \"position\": [0.001, 1]},"
        "{\"type\": \"rope\", \"name\": \"Rope\", \"ends\": [\"Light\", \"Wheel\", \"Heavy\"]}]}";
    g_autofree char *scene = cli_write(fixture, "scene.json", atwood);
    cJSON *root = written_json(fixture, "diagram @scene.json --block Light --time 0.1 --as json");
    const cJSON *force = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "forces"), 1);
    g_assert_cmpstr(cJSON_GetObjectItem(force, "from")->valuestring, ==, "Rope");
    g_assert_cmpstr(cJSON_GetObjectItem(force, "partner")->valuestring, ==, "Wheel");
    written_assert_near(cJSON_GetArrayItem(cJSON_GetObjectItem(force, "force"), 1)->valuedouble, 15, 1e-4);
    cJSON_Delete(root);
    root = written_json(fixture, "diagram @scene.json --block Wheel --time 0.1 --as json");
    const cJSON *both = cJSON_GetObjectItem(cJSON_GetArrayItem(cJSON_GetObjectItem(root, "forces"), 0), "partner");
    g_assert_cmpint(cJSON_GetArraySize(both), ==, 2);
    g_assert_cmpstr(cJSON_GetArrayItem(both, 0)->valuestring, ==, "Light");
    g_assert_cmpstr(cJSON_GetArrayItem(both, 1)->valuestring, ==, "Heavy");
    cJSON_Delete(root);
    root = written_json(fixture, "equations @scene.json --at 0.1 --as json");
    written_assert_near(written_symbol(root, "λ"), -15, 1e-4);
    cJSON_Delete(root);
}

/* Two wheels on an arm: what a gear does to one of the three has its opposite on no single one of the others. */
static void test_gear_has_no_partner(CliFixture *fixture, gconstpointer data)
{
    static const char gear[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"support\", \"name\": \"Axle\", \"position\": [0, 0], \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Arm\", \"length\": 0.5, \"position\": [0.25, 0], \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"D1\", \"radius\": 0.3, \"position\": [0, 0], \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"D2\", \"radius\": 0.2, \"position\": [0.5, 0], \"solid\": false},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", {\"block\": \"Arm\", \"at\": [-0.25, 0]}]},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"D1\"]},"
        "{\"type\": \"pin\", \"ends\": [{\"block\": \"Arm\", \"at\": [0.25, 0]}, \"D2\"]},"
        "{\"type\": \"torque\", \"name\": \"Drive\", \"ends\": [\"D1\"], \"amplitude\": 3},"
        "{\"type\": \"gear\", \"name\": \"G\", \"ends\": [\"D1\", \"D2\", \"Arm\"]}]}";
    static const char *const bodies[] = {"D1", "D2", "Arm"};
    g_autofree char *scene = cli_write(fixture, "scene.json", gear);
    for (gsize i = 0; i < G_N_ELEMENTS(bodies); i++) {
        g_autofree char *command = g_strdup_printf("diagram @scene.json --block %s --time 0.1", bodies[i]);
        g_autofree char *as_json = g_strconcat(command, " --as json", NULL);
        g_autoptr(TestProgram) page = cli_run_well(fixture, command);
        g_assert_null(strstr(page->output, "G, end"));
        g_assert_null(strstr(page->output, "on to"));
        cJSON *root = written_json(fixture, as_json);
        const cJSON *force;
        int found = 0;
        cJSON_ArrayForEach(force, cJSON_GetObjectItem(root, "forces"))
        {
            if (strcmp(cJSON_GetObjectItem(force, "from")->valuestring, "G") != 0) continue;
            g_assert_true(cJSON_IsNull(cJSON_GetObjectItem(force, "partner")));
            found++;
        }
        g_assert_cmpint(found, ==, 1);
        cJSON_Delete(root);
    }
}

/* The couple that a diagram has from a block. */
static double couple_from(CliFixture *fixture, const char *command, const char *from)
{
    cJSON *root = written_json(fixture, command);
    const cJSON *force;
    double couple = NAN;
    cJSON_ArrayForEach(force, cJSON_GetObjectItem(root, "forces"))
    {
        if (strcmp(cJSON_GetObjectItem(force, "from")->valuestring, from) == 0)
            couple = cJSON_GetObjectItem(force, "torque")->valuedouble;
    }
    cJSON_Delete(root);
    return couple;
}

/* A beam of length L welded at its root, loaded by F at its tip: the root holds it with the moment F L. */
static void test_welded_beam(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Beam\", \"mass\": 2, \"length\": 3, \"position\": [1.5, 0],"
        " \"orientation\": 0},"
        "{\"type\": \"weld\", \"name\": \"Root\", \"ends\": [\"Wall\", {\"block\": \"Beam\", \"at\": [-1.5, 0]}]},"
        "{\"type\": \"law-force\", \"name\": \"Load\", \"ends\": [{\"block\": \"Beam\", \"at\": [1.5, 0]}],"
        " \"force_y\": \"-a\", \"a\": \"7 N\"}]}");
    written_assert_near(couple_from(fixture, "diagram @scene.json --block Beam --time 0.2 --as json", "Root"), 7 * 3,
                        1e-12);
}

/* A drive that holds a bar level: m g L/2 about the pin. */
static void test_holding_drive(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10},"
        "{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Bar\", \"mass\": 2, \"length\": 3, \"position\": [1.5, 0],"
        " \"orientation\": 0},"
        "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [\"Wall\", {\"block\": \"Bar\", \"at\": [-1.5, 0]}]},"
        "{\"type\": \"drive\", \"name\": \"Drive\", \"ends\": [\"Wall\", \"Bar\"], \"speed\": 0}]}");
    written_assert_near(couple_from(fixture, "diagram @scene.json --block Bar --time 0.2 --as json", "Drive"),
                        2 * 10 * 1.5, 1e-12);
}

/* Torques are in N m, energies in J. */
static void test_units(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
                  "{\"type\": \"disc\", \"name\": \"A\", \"solid\": false}, {\"type\": \"disc\", \"name\": \"B\", "
                  "\"solid\": false},"
                  "{\"type\": \"pin\", \"ends\": [\"Axle\", \"A\"]}, {\"type\": \"pin\", \"ends\": [\"Axle\", \"B\"]},"
                  "{\"type\": \"gear\", \"name\": \"Pair\", \"ends\": [\"A\", \"B\"]},"
                  "{\"type\": \"torsional-spring\", \"name\": \"Spring\", \"ends\": [\"Axle\", \"A\"]},"
                  "{\"type\": \"torque\", \"name\": \"Motor\", \"ends\": [\"A\", \"Axle\"], \"amplitude\": 7}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    const cJSON *each;
    int torques = 0, energies = 0;
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(root, "symbols"))
    {
        const char *unit = cJSON_GetObjectItem(each, "unit")->valuestring;
        g_assert_cmpstr(unit, !=, "J");
        torques += strcmp(unit, "N m") == 0;
    }
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(root, "definitions"))
    {
        const cJSON *means = cJSON_GetObjectItem(each, "means");
        const gboolean stored = means != NULL && strcmp(means->valuestring, "stored energy") == 0;
        g_assert_true((strcmp(cJSON_GetObjectItem(each, "unit")->valuestring, "J") == 0) == stored);
        energies += stored;
    }
    g_assert_cmpint(torques, ==, 2); /* the gear's multiplier, the motor's amplitude */
    g_assert_cmpint(energies, ==, 1);
    cJSON_Delete(root);
}

/* A weld's multipliers have Greek letters in their indices, which LaTeX knows as commands alone. A real LaTeX reads the
 * page where there is one. */
static void test_latex(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Beam\", \"length\": 3, \"position\": [1.5, 0], \"orientation\": 0},"
        "{\"type\": \"weld\", \"name\": \"Root\", \"ends\": [\"Wall\", {\"block\": \"Beam\", \"at\": [-1.5, 0]}]}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --as latex");
    g_assert_true(g_str_is_ascii(strstr(page->output, "\\begin{document}")));
    cli_assert_holds(page->output, "{\\lambda}_{\\theta}");
    g_autofree char *program = g_find_program_in_path("pdflatex");
    if (program == NULL) return;
    g_autofree char *folder = g_path_get_dirname(scene), *source = cli_write(fixture, "page.tex", page->output);
    const char *command[] = {program, "-interaction=nonstopmode", "-halt-on-error", source, NULL};
    g_autoptr(GError) error = NULL;
    g_autofree char *said = NULL;
    int status = 0;
    g_spawn_sync(folder, (char **)command, NULL, G_SPAWN_DEFAULT, NULL, NULL, &said, NULL, &status, &error);
    g_assert_no_error(error);
    if (status != 0) g_error("LaTeX does not read the page: %s", said);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-turning/pendulum", test_pendulum);
    cli_test_add("/cli/equations-turning/angles", test_angles);
    cli_test_add("/cli/equations-turning/joints-off-axes", test_joints_off_axes);
    cli_test_add("/cli/equations-turning/double-pendulums", test_double_pendulums);
    cli_test_add("/cli/equations-turning/torque", test_torque);
    cli_test_add("/cli/equations-turning/long-chain", test_long_chain);
    cli_test_add("/cli/equations-turning/books", test_books);
    cli_test_add("/cli/equations-turning/redundant", test_redundant);
    cli_test_add("/cli/equations-turning/rope", test_rope);
    cli_test_add("/cli/equations-turning/gear-has-no-partner", test_gear_has_no_partner);
    cli_test_add("/cli/equations-turning/spans", test_spans);
    cli_test_add("/cli/equations-turning/gears", test_gears);
    cli_test_add("/cli/equations-turning/drive", test_drive);
    cli_test_add("/cli/equations-turning/welded-beam", test_welded_beam);
    cli_test_add("/cli/equations-turning/holding-drive", test_holding_drive);
    cli_test_add("/cli/equations-turning/latex", test_latex);
    cli_test_add("/cli/equations-turning/units", test_units);
    cli_test_add("/cli/equations-turning/rolling", test_rolling);
    cli_test_add("/cli/equations-turning/cords", test_cords);
    cli_test_add("/cli/equations-turning/sliding-box", test_sliding_box);
    cli_test_add("/cli/equations-turning/turned-support", test_turned_support);
    return g_test_run();
}
