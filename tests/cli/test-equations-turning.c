/* Equations, diagrams and books of bodies that turn, against closed forms: the compound pendulum, a beam that is held
 * more often than it needs, a rope over a wheel. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "fixture.h"

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

static cJSON *parsed(CliFixture *fixture, const char *command)
{
    g_autoptr(TestProgram) program = cli_run_well(fixture, command);
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    return root;
}

static double symbol_of(const cJSON *root, const char *name)
{
    const cJSON *symbol = cJSON_GetObjectItemCaseSensitive(cJSON_GetObjectItem(root, "symbols"), name);
    g_assert_nonnull(symbol);
    return cJSON_GetObjectItem(symbol, "value")->valuedouble;
}

static void assert_near(double value, double expected, double within)
{
    if (!(fabs(value - expected) <= within)) g_error("%.15g where %.15g was expected", value, expected);
}

/* alpha = -m g d sin(theta) / (I + m d^2) with d = l/2, I = m l^2/12; the pin gives m a - m g, a = d alpha along the
 * path at the start. */
static void test_pendulum(CliFixture *fixture, gconstpointer data)
{
    const double d = LENGTH / 2, inertia = MASS * LENGTH * LENGTH / 12;
    const double alpha = -MASS * GRAVITY * d * sin(AT_START) / (inertia + MASS * d * d);
    g_autofree char *text = pendulum(), *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = parsed(fixture, "equations @scene.json --as json");
    assert_near(symbol_of(root, "Bar.angle"), AT_START - G_PI_2, 1e-15);
    assert_near(symbol_of(root, "I"), inertia, 1e-15);
    assert_near(symbol_of(root, "λx"), MASS * d * alpha * cos(AT_START), 1e-12);
    assert_near(symbol_of(root, "λy"), MASS * (GRAVITY + d * alpha * sin(AT_START)), 1e-12);
    const cJSON *body = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "bodies"), 0);
    g_assert_cmpstr(cJSON_GetObjectItem(body, "inertia")->valuestring, ==, "I");
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "constraints")), ==, 2);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "not_written")), ==, 0);
    cJSON_Delete(root);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json");
    g_autofree char *shown = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted = g_utf8_normalize("I θ̈ = r₂x λy − r₂y λx   Pin\n", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(shown, wanted);

    root = parsed(fixture, "diagram @scene.json --block Bar --time 0 --as json");
    const cJSON *kinetic = cJSON_GetObjectItem(root, "kinetic");
    assert_near(cJSON_GetObjectItem(kinetic, "torque")->valuedouble, inertia * alpha, 1e-12);
    assert_near(cJSON_GetObjectItem(root, "inertia")->valuedouble, inertia, 1e-15);
    cJSON_Delete(root);
}

/* The compound pendulum of a textbook, (m d^2 + I) theta'' + m g d sin theta = 0, with d = -ax: the pin is behind the
 * centre. A rod that hangs on its other end makes it a double pendulum, in two angles. */
static void test_angles(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *text = pendulum(), *scene = cli_write(fixture, "scene.json", text);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form angles");
    g_autofree char *shown = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted =
        g_utf8_normalize("(m ax₁² + I) θ̈ − m g ax₁ sin(θ) = 0\n", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(shown, wanted);
    cli_assert_holds(shown, "θ = 0.5 rad   Bar, from straight down");
    static const char more[] =
        ",{\"type\": \"mass\", \"name\": \"Bob\", \"mass\": 1, \"position\": [0.6, 1]},"
        "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"Bob\", {\"block\": \"Bar\", \"at\": "
        "[0.6, 0]}]}]}";
    text[strlen(text) - 2] = '\0';
    g_autofree char *longer = g_strconcat(text, more, NULL), *second = cli_write(fixture, "scene.json", longer);
    cJSON *root = parsed(fixture, "equations @scene.json --form angles --as json");
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    const cJSON *rod = cJSON_GetArrayItem(cJSON_GetObjectItem(island, "angles"), 1);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(island, "equations")), ==, 2);
    g_assert_cmpstr(cJSON_GetObjectItem(rod, "block")->valuestring, ==, "Rod");
    const double x = LENGTH * sin(AT_START), y = 3 - LENGTH * cos(AT_START);
    assert_near(cJSON_GetObjectItem(rod, "value")->valuedouble, atan2(0.6 - x, y - 1), 1e-12);
    cJSON_Delete(root);
}

static const cJSON *account(const cJSON *root, const char *section, const char *list, const char *block)
{
    return cJSON_GetObjectItemCaseSensitive(cJSON_GetObjectItem(cJSON_GetObjectItem(root, section), list), block);
}

/* The pin does no work; about itself it gives no angular impulse, and gravity gives all of it. */
static void test_books(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *text = pendulum(), *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = parsed(fixture, "books @scene.json --block Bar --from 0 --to 1 --about 0,3 --as json");
    const cJSON *energy = cJSON_GetObjectItem(root, "energy"), *angular = cJSON_GetObjectItem(root, "angular");
    const double kinetic = cJSON_GetArrayItem(cJSON_GetObjectItem(energy, "kinetic"), 1)->valuedouble;
    assert_near(account(root, "energy", "work", "Pin")->valuedouble, 0, 1e-9);
    assert_near(account(root, "energy", "work", "Gravity")->valuedouble, kinetic, 1e-9);
    assert_near(account(root, "angular", "impulses", "Pin")->valuedouble, 0, 1e-9);
    const double spin = cJSON_GetArrayItem(cJSON_GetObjectItem(angular, "angular_momentum"), 1)->valuedouble;
    assert_near(account(root, "angular", "impulses", "Gravity")->valuedouble, spin, 1e-9);
    /* h = J omega and T = J omega^2 / 2 about the pin, with J = m l^2 / 3 */
    assert_near(kinetic, spin * spin / (2 * MASS * LENGTH * LENGTH / 3), 1e-9);
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
    cJSON *root = parsed(fixture, "equations @scene.json --as json");
    const cJSON *rows = cJSON_GetObjectItem(root, "constraints"), *row;
    cJSON_ArrayForEach(row, rows)
    {
        const char *multiplier = cJSON_GetObjectItem(row, "multiplier")->valuestring;
        const gboolean along = strstr(multiplier, "λx") != NULL;
        g_assert_cmpint(cJSON_IsTrue(cJSON_GetObjectItem(row, "redundant")), ==, along);
        assert_near(symbol_of(root, multiplier), along ? 0 : 15, 1e-9);
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
    cJSON *root = parsed(fixture, "diagram @scene.json --block Light --time 0.1 --as json");
    const cJSON *force = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "forces"), 1);
    g_assert_cmpstr(cJSON_GetObjectItem(force, "from")->valuestring, ==, "Rope");
    g_assert_cmpstr(cJSON_GetObjectItem(force, "partner")->valuestring, ==, "Wheel");
    assert_near(cJSON_GetArrayItem(cJSON_GetObjectItem(force, "force"), 1)->valuedouble, 15, 1e-4);
    cJSON_Delete(root);
    root = parsed(fixture, "diagram @scene.json --block Wheel --time 0.1 --as json");
    const cJSON *both = cJSON_GetObjectItem(cJSON_GetArrayItem(cJSON_GetObjectItem(root, "forces"), 0), "partner");
    g_assert_cmpint(cJSON_GetArraySize(both), ==, 2);
    g_assert_cmpstr(cJSON_GetArrayItem(both, 0)->valuestring, ==, "Light");
    g_assert_cmpstr(cJSON_GetArrayItem(both, 1)->valuestring, ==, "Heavy");
    cJSON_Delete(root);
    root = parsed(fixture, "equations @scene.json --at 0.1 --as json");
    assert_near(symbol_of(root, "λ"), -15, 1e-4);
    cJSON_Delete(root);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-turning/pendulum", test_pendulum);
    cli_test_add("/cli/equations-turning/angles", test_angles);
    cli_test_add("/cli/equations-turning/long-chain", test_long_chain);
    cli_test_add("/cli/equations-turning/books", test_books);
    cli_test_add("/cli/equations-turning/redundant", test_redundant);
    cli_test_add("/cli/equations-turning/rope", test_rope);
    return g_test_run();
}
