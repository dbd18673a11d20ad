/* Equations of pendulums that turn, in their coordinates and in their angles, against closed forms and the run. */
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

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-angles/pendulum", test_pendulum);
    cli_test_add("/cli/equations-angles/angles", test_angles);
    cli_test_add("/cli/equations-angles/double-pendulums", test_double_pendulums);
    cli_test_add("/cli/equations-angles/joints-off-axes", test_joints_off_axes);
    cli_test_add("/cli/equations-angles/long-chain", test_long_chain);
    cli_test_add("/cli/equations-angles/books", test_books);
    return g_test_run();
}
