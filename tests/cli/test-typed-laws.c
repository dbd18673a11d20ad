/* Laws that are typed into a scene: what runs, what is refused and how, and the equations that are made from them. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "written.h"

#define HEAD "{\"tinker\": 1, \"run\": {\"duration\": 1, \"tolerance\": 1e-12}, \"blocks\": ["
#define WALL "{\"type\": \"support\", \"name\": \"Wall\", \"position\": [0, 0], \"solid\": false},"
#define LOAD "{\"type\": \"mass\", \"name\": \"Load\", \"mass\": 2, \"position\": [1.5, 0]},"
#define LAW  "{\"type\": \"law-connector\", \"name\": \"Law\", \"ends\": [\"Wall\", \"Load\"], "

static void assert_refused(CliFixture *fixture, const char *law, const char *why)
{
    g_autofree char *text = g_strconcat(HEAD, WALL, LOAD, LAW, law, "}]}", NULL);
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    g_autoptr(TestProgram) program = cli_run(fixture, "run @scene.json");
    g_assert_cmpint(program->status, !=, 0);
    cli_assert_holds(program->error, why);
}

static void test_refused(CliFixture *fixture, gconstpointer data)
{
    assert_refused(fixture, "\"tension\": \"L\", \"potential\": \"L^2\"", "Law: it has a tension and a potential");
    assert_refused(fixture, "\"a\": 3", "Law: it has no law");
    assert_refused(fixture, "\"tension\": \"a*L\"", "Law: tension names a, which has no value");
    assert_refused(fixture, "\"tension\": \"a*(L\", \"a\": 3", "tension: ");
    assert_refused(fixture, "\"potential\": \"t*L\"", "potential");
    assert_refused(fixture, "\"tension\": \"L\", \"a\": \"3 parrots\"", "a: ");
}

static double at_end(CliFixture *fixture, const char *law, const char *column)
{
    g_autofree char *text = g_strconcat(HEAD, WALL, LOAD, law, "}]}", NULL);
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    g_autofree char *words = g_strdup_printf("run @scene.json --at 1 --no-estimate --csv - --columns %s", column);
    g_autoptr(TestProgram) program = cli_run_well(fixture, words);
    return g_ascii_strtod(strchr(strchr(program->output, '\n'), ',') + 1, NULL);
}

/* 2 x'' = -18 (x - 1): x = 1 + cos(3 t) / 2, whichever way it is said. */
static void test_same_motion(CliFixture *fixture, gconstpointer data)
{
    static const char *const ways[] = {
        LAW "\"tension\": \"a*(L - b)\", \"a\": \"18 N/m\", \"b\": 1",
        LAW "\"potential\": \"a*(L - b)^2/2\", \"a\": 18, \"b\": \"100 cm\"",
        "{\"type\": \"law-force\", \"name\": \"Law\", \"ends\": [\"Load\"], \"force_x\": \"-9*m*(x - 1)\"",
        "{\"type\": \"law-force\", \"name\": \"Law\", \"ends\": [\"Load\"], \"potential\": \"a*(x - 1)^2\", \"a\": 9",
        "{\"type\": \"law-field\", \"name\": \"Law\", \"potential\": \"4.5*m*(x - 1)^2\"",
        "{\"type\": \"law-field\", \"name\": \"Law\", \"force_x\": \"-m*a*(x - 1)\", \"a\": \"9 1/s^2\"",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(ways); i++) {
        const double x = at_end(fixture, ways[i], "Load.x");
        if (fabs(x - (1 + cos(3.0) / 2)) > 1e-9) g_error("%s: %.15g", ways[i], x);
    }
}

/* A number that was typed for a law stands in JSON with its text, letter by letter, and on the page with its sign and
 * digits as numbers are printed. */
static void test_text_of_numbers(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *name, *text, *shown;
        double value;
    } numbers[] = {
        {"a", "+3 N/m", "a = 3 N/m ", 3},
        {"b", ".5", "b = 0.5 ", 0.5},
        {"c", "-2e1 cm", "c = −20 cm = −0.2 m ", -0.2},
    };
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  HEAD WALL LOAD LAW "\"tension\": \"+a*(L - .5) + b*c\", \"a\": \"+3 N/m\", \"b\": \".5\", "
                                     "\"c\": \"-2e1 cm\"}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    const cJSON *symbols = cJSON_GetObjectItem(root, "symbols");
    for (gsize i = 0; i < G_N_ELEMENTS(numbers); i++) {
        const cJSON *symbol = cJSON_GetObjectItem(symbols, numbers[i].name);
        g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(symbol, "text")), ==, numbers[i].text);
        written_assert_near(written_symbol(root, numbers[i].name), numbers[i].value, 1e-15);
        cli_assert_holds(page->output, numbers[i].shown);
    }
    g_assert_null(cJSON_GetObjectItem(cJSON_GetObjectItem(symbols, "m"), "text"));
    cli_assert_holds(page->output, "T = 2.9 N\n"); /* 3 (1.5 - 0.5) - 0.5 0.2 */
    cJSON_Delete(root);
}

/* Written back as it was typed. */
static void test_kept(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json",
                                       HEAD WALL LOAD LAW "\"tension\": \"a*(L - b)\", \"a\": \"18 N/m\", \"b\": 1}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "convert @scene.json");
    cli_assert_holds(program->output, "\"tension\": \"a*(L - b)\", \"a\": \"18 N/m\", \"b\": 1");
}

/* What is no number of JSON is written as a text that any reader takes, letter by letter, and the scene runs from it.
 */
static void test_texts_that_are_no_numbers_of_json(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *text;
        double value;
    } numbers[] = {{"+3", 3}, {".5", 0.5}, {"-.25", -0.25}, {"4.", 4}, {"007", 7}, {"+2e+1", 20}, {" 6 ", 6}};
    for (gsize i = 0; i < G_N_ELEMENTS(numbers); i++) {
        g_autofree char *law = g_strdup_printf("\"tension\": \"a*L\", \"a\": \"%s\"}]}", numbers[i].text);
        g_autofree char *text = g_strconcat(HEAD, WALL, LOAD, LAW, law, NULL);
        g_autofree char *scene = cli_write(fixture, "scene.json", text);
        g_autoptr(TestProgram) converted = cli_run_well(fixture, "convert @scene.json");
        cJSON *root = cJSON_Parse(converted->output);
        g_assert_nonnull(root);
        const cJSON *block = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "blocks"), 2);
        g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(block, "a")), ==, numbers[i].text);
        cJSON_Delete(root);
        g_autofree char *again = cli_write(fixture, "again.json", converted->output);
        root = written_json(fixture, "equations @again.json --as json");
        written_assert_near(written_symbol(root, "a"), numbers[i].value, 1e-15);
        cJSON_Delete(root);
    }
}

/* Numbers with units of any kind: in files, and on pages of equations, with what they are in SI where they are in none
 * of its units. A foot is 0.3048 m, a pound of force 4.4482216152605 N. */
static void test_units_are_kept(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  HEAD WALL LOAD LAW
                  "\"tension\": \"a*L^2 + b*(L - c) + d*L + e*t + f\", \"a\": \"3 kg/m\", \"b\": \"2 lbf/ft\", "
                  "\"c\": \"1 ft\", \"d\": \"25 N/m\", \"e\": \"3.0\", \"f\": \"1e3\"}]}");
    g_autoptr(TestProgram) converted = cli_run_well(fixture, "convert @scene.json");
    cli_assert_holds(converted->output, "\"a\": \"3 kg/m\", \"b\": \"2 lbf/ft\", \"c\": \"1 ft\", \"d\": \"25 N/m\", "
                                        "\"e\": \"3.0\", \"f\": \"1e3\"");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json");
    static const char *const lines[] = {
        "a = 3 kg/m ", "b = 2 lbf/ft = 29.1878 N/m", "c = 1 ft = 0.3048 m", "d = 25 N/m ", "e = 3 ", "f = 1000 "};
    for (gsize i = 0; i < G_N_ELEMENTS(lines); i++)
        cli_assert_holds(page->output, lines[i]);
    g_autoptr(TestProgram) latex = cli_run_well(fixture, "equations @scene.json --as latex");
    cli_assert_holds(latex->output, "1\\,\\text{ft} = 0.3048\\,\\text{m}");
}

/* A note where units do not come out, and none where they do. */
static void test_units(CliFixture *fixture, gconstpointer data)
{
    static const char *const laws[] = {"\"tension\": \"a*L\", \"a\": \"25 N/m\"",
                                       "\"tension\": \"a*L\", \"a\": \"25 N\""};
    for (int i = 0; i < 2; i++) {
        g_autofree char *text = g_strconcat(HEAD, WALL, LOAD, LAW, laws[i], "}]}", NULL);
        g_autofree char *scene = cli_write(fixture, "scene.json", text);
        g_autoptr(TestProgram) program = cli_run_well(fixture, "plan @scene.json");
        const gboolean told = strstr(program->output, "taken in SI") != NULL;
        g_assert_cmpint(told, ==, i == 1);
    }
}

/* T = -dV/dL with its sign, by the grammar: of a L^-1 it is a L^-2. */
static void test_equations(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json", HEAD WALL LOAD LAW "\"potential\": \"-a/L\", \"a\": \"3 J m\"}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json --as json");
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "not_written")), ==, 0);
    const cJSON *definition;
    gboolean found = FALSE;
    cJSON_ArrayForEach(definition, cJSON_GetObjectItem(root, "definitions"))
    {
        if (strcmp(cJSON_GetObjectItem(definition, "symbol")->valuestring, "T") != 0) continue;
        found = TRUE;
        g_assert_true(cJSON_IsTrue(cJSON_GetObjectItem(definition, "typed")));
    }
    g_assert_true(found);
    cJSON_Delete(root);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --at 0");
    cli_assert_holds(page->output, "T = 1.33333 N");
}

/* The forces of potentials as textbooks have them, on the page of equations. */
static void test_as_in_books(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *law, *lines[2];
    } laws[] = {
        {"\"potential\": \"-a*m/sqrt(x^2 + y^2)\", \"a\": \"3 m^3/s^2\"",
         {"Fx = −a m x / (x² + y²)^(3 / 2)", "Fy = −a m y / (x² + y²)^(3 / 2)"}},
        {"\"potential\": \"-a*x^2/2 + b*x^4/4\", \"a\": 1, \"b\": 2", {"Fx = a x − b x³", "= 0    no force"}},
        {"\"potential\": \"-a*cos(b*x)*cos(b*y)\", \"a\": 1, \"b\": 2",
         {"Fx = −a b sin(b x) cos(b y)", "Fy = −a b cos(b x) sin(b y)"}},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(laws); i++) {
        g_autofree char *text = g_strconcat(
            HEAD LOAD "{\"type\": \"law-force\", \"name\": \"Law\", \"ends\": [\"Load\"], ", laws[i].law, "}]}", NULL);
        g_autofree char *scene = cli_write(fixture, "scene.json", text);
        g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json");
        for (int k = 0; k < 2; k++)
            cli_assert_holds(page->output, laws[i].lines[k]);
    }
}

/* A field's number is one symbol, whichever body it acts on. */
static void test_one_symbol(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  HEAD LOAD "{\"type\": \"mass\", \"name\": \"Other\", \"mass\": 1, \"position\": [4, 1]},"
                            "{\"type\": \"mass\", \"name\": \"Third\", \"mass\": 3, \"position\": [5, 1]},"
                            "{\"type\": \"law-field\", \"name\": \"Law\", \"force_x\": \"-a*x\", \"a\": \"7 N/m\"}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json --as json");
    cJSON *root = cJSON_Parse(program->output);
    int found = 0;
    const cJSON *symbol;
    cJSON_ArrayForEach(symbol, cJSON_GetObjectItem(root, "symbols"))
    {
        const cJSON *property = cJSON_GetObjectItem(symbol, "property");
        found += cJSON_IsString(property) && strcmp(property->valuestring, "a") == 0;
    }
    g_assert_cmpint(found, ==, 1);
    cJSON_Delete(root);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json");
    cli_assert_holds(page->output, "F₁x = −a x₁");
    cli_assert_holds(page->output, "F₂x = −a x₂");
    cli_assert_holds(page->output, "F₃x = −a x₃");
}

/* Two numbers of the energy of a run: how much the potential energy has grown, and what a book was given. */
static void energies(CliFixture *fixture, const char *law, const char *book, double *grown, double *given)
{
    g_autofree char *text = g_strconcat(HEAD WALL "{\"type\": \"mass\", \"name\": \"Load\", \"mass\": 2, \"position\": "
                                                  "[1.5, 0.3], \"velocity\": [0.3, 0.4]},",
                                        law, "}]}", NULL);
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @scene.json --json -");
    cJSON *root = cJSON_Parse(program->output);
    const cJSON *energy = cJSON_GetObjectItem(root, "energy"), *potential = cJSON_GetObjectItem(energy, "potential");
    const cJSON *entry = cJSON_GetObjectItem(energy, book);
    g_assert_true(potential != NULL && entry != NULL);
    *grown = cJSON_GetObjectItem(potential, "end")->valuedouble - cJSON_GetObjectItem(potential, "start")->valuedouble;
    *given = entry->valuedouble;
    cJSON_Delete(root);
}

/* A tension without an antiderivative stores what it does: energy is conserved, and no damper takes any. */
static void test_stored_by_a_sum(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  HEAD WALL "{\"type\": \"mass\", \"name\": \"Load\", \"mass\": 2, \"position\": [1.5, 0.3]}," LAW
                            "\"tension\": \"18*(L - 1) + 9*exp(-L^2)\"}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @scene.json --json -");
    cJSON *root = cJSON_Parse(program->output);
    const cJSON *energy = cJSON_GetObjectItem(root, "energy");
    double grown[2];
    static const char *const kinds[] = {"kinetic", "potential"};
    for (gsize i = 0; i < G_N_ELEMENTS(kinds); i++) {
        const cJSON *kind = cJSON_GetObjectItem(energy, kinds[i]);
        grown[i] = cJSON_GetObjectItem(kind, "end")->valuedouble - cJSON_GetObjectItem(kind, "start")->valuedouble;
    }
    g_assert_cmpfloat(fabs(grown[0]), >, 0.01);
    g_assert_cmpfloat_with_epsilon(grown[0], -grown[1], 1e-8);
    g_assert_cmpfloat_with_epsilon(cJSON_GetObjectItem(energy, "dampers")->valuedouble, 0, 1e-12);
    cJSON_Delete(root);
}

/* A law is booked as the block that does the same, whichever way it is said. */
static void test_booked_as_what_it_is(CliFixture *fixture, gconstpointer data)
{
#define SPRING                                                                                                         \
    "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"Wall\", \"Load\"], \"stiffness\": 18, "                      \
    "\"rest_length\": 1"
#define DAMPER "}, {\"type\": \"damper\", \"name\": \"D\", \"ends\": [\"Wall\", \"Load\"], \"damping\": 0.5"
#define FORCE  "{\"type\": \"law-force\", \"name\": \"Law\", \"ends\": [\"Load\"], "
    static const struct {
        const char *typed, *known, *book;
    } pairs[] = {
        {LAW "\"tension\": \"18*(L - 1)\"", SPRING, "dampers"},
        {LAW "\"potential\": \"9*(L - 1)^2\"", SPRING, "dampers"},
        {LAW "\"tension\": \"18*(L - 1) + 0.5*rate\"", SPRING DAMPER, "dampers"},
        {FORCE "\"force_x\": \"-5*x\", \"force_y\": \"-5*y\"", FORCE "\"potential\": \"5*(x^2 + y^2)/2\"", "motors"},
        {FORCE "\"force_x\": \"-x/(x^2 + y^2)^1.5\", \"force_y\": \"-y/(x^2 + y^2)^1.5\"",
         FORCE "\"potential\": \"-1/sqrt(x^2 + y^2)\"", "motors"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(pairs); i++) {
        double grown[2], given[2];
        energies(fixture, pairs[i].typed, pairs[i].book, &grown[0], &given[0]);
        energies(fixture, pairs[i].known, pairs[i].book, &grown[1], &given[1]);
        g_assert_cmpfloat(fabs(grown[1]), >, 0.01);
        g_assert_cmpfloat_with_epsilon(grown[0], grown[1], 1e-9);
        g_assert_cmpfloat_with_epsilon(given[0], given[1], 1e-9);
    }
}

/* 2 v' = -c v for a second takes 1/2 m v0^2 (1 - e^(-c)), which dampers have, not motors. */
static void test_drag_is_taken(CliFixture *fixture, gconstpointer data)
{
    static const char *const books[] = {"dampers", "motors"};
    const double taken = 0.25 * (1 - exp(-0.6));
    for (int k = 0; k < 2; k++) {
        double grown, given;
        energies(fixture, FORCE "\"force_x\": \"-a*vx\", \"force_y\": \"-a*vy\", \"a\": 0.6", books[k], &grown, &given);
        g_assert_cmpfloat_with_epsilon(given, k == 0 ? -taken : 0, 1e-9);
        g_assert_cmpfloat(grown, ==, 0);
    }
    /* what changes in time gives: with F = 2 + t, v = 0.3 + t + t^2/4, and the integral of F v is 37/16 J */
    double grown, given;
    energies(fixture, FORCE "\"force_x\": \"2 + t\"", "motors", &grown, &given);
    g_assert_cmpfloat_with_epsilon(given, 37.0 / 16, 1e-9);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/typed-laws/refused", test_refused);
    cli_test_add("/cli/typed-laws/same-motion", test_same_motion);
    cli_test_add("/cli/typed-laws/kept", test_kept);
    cli_test_add("/cli/typed-laws/units", test_units);
    cli_test_add("/cli/typed-laws/equations", test_equations);
    cli_test_add("/cli/typed-laws/as-in-books", test_as_in_books);
    cli_test_add("/cli/typed-laws/one-symbol", test_one_symbol);
    cli_test_add("/cli/typed-laws/text-of-numbers", test_text_of_numbers);
    cli_test_add("/cli/typed-laws/stored-by-a-sum", test_stored_by_a_sum);
    cli_test_add("/cli/typed-laws/booked-as-what-it-is", test_booked_as_what_it_is);
    cli_test_add("/cli/typed-laws/drag-is-taken", test_drag_is_taken);
    cli_test_add("/cli/typed-laws/no-numbers-of-json", test_texts_that_are_no_numbers_of_json);
    cli_test_add("/cli/typed-laws/units-are-kept", test_units_are_kept);
    return g_test_run();
}
