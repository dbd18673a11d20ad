/* tinker equations: the page of a spring-mass scene as a textbook has it, numbers against closed forms, and JSON that
 * others can work out. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "written.h"

/* A mass of 2 kg on a spring of 50 N/m below a ceiling: omega is 5 rad/s, rest is m g / k below the rest length. */
#define HANGING                                                                                                        \
    "{\"tinker\": 1, \"title\": \"Hanging\", \"run\": {\"duration\": 4}, \"blocks\": ["                                \
    "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10},"                                            \
    "{\"type\": \"support\", \"name\": \"Ceiling\", \"position\": [0, 4], \"solid\": false},"                          \
    "{\"type\": \"mass\", \"name\": \"Load\", \"mass\": 2, \"position\": [0, 2]},"                                     \
    "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Ceiling\", \"Load\"], \"stiffness\": 50,"             \
    " \"rest_length\": 2}]}"

static void test_page(CliFixture *fixture, gconstpointer data)
{
    static const char expected[] = "Hanging\n"
                                   "\n"
                                   "Load\n"
                                   "  m ẍ = −T x / L               Spring 0\n"
                                   "  m ÿ = −m g + T (Y − y) / L   Gravity + Spring 0\n"
                                   "\n"
                                   "with\n"
                                   "  L = √(x² + (y − Y)²)   Spring 0: distance between the ends\n"
                                   "  T = k (L − L0)         Spring 0: tension\n"
                                   "\n"
                                   "where\n"
                                   "   m = 2 kg      Load: mass\n"
                                   "   g = 10 m/s²   Gravity: acceleration\n"
                                   "   Y = 4 m       Ceiling: position y\n"
                                   "   k = 50 N/m    Spring 0: stiffness\n"
                                   "  L0 = 2 m       Spring 0: rest length\n"
                                   "\n"
                                   "at t = 0 s\n"
                                   "  x = 0 m   Load: x\n"
                                   "  y = 2 m   Load: y\n"
                                   "  L = 2 m\n"
                                   "  T = 0 N\n";
    g_autofree char *scene = cli_write(fixture, "scene.json", HANGING);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json");
    g_autofree char *found = g_utf8_normalize(program->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted = g_utf8_normalize(expected, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_assert_cmpstr(found, ==, wanted);
}

/* x = -(m g / k) (1 - cos omega t) below the start, where the tension is 0. */
static void test_numbers(CliFixture *fixture, gconstpointer data)
{
    const double t = 0.7, down = 2 * 10 / 50.0 * (1 - cos(5 * t));
    g_autofree char *scene = cli_write(fixture, "scene.json", HANGING);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json --at 0.7 --as json");
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    const cJSON *symbols = cJSON_GetObjectItem(root, "symbols");
    const double y = cJSON_GetObjectItem(cJSON_GetObjectItem(symbols, "Load.y"), "value")->valuedouble;
    g_assert_cmpfloat(fabs(y - (2 - down)), <, 1e-8);
    cJSON_Delete(root);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --at 0.7");
    g_autofree char *tension = g_strdup_printf("T = %.6g N", 50 * down);
    cli_assert_holds(page->output, tension);
}

static void assert_expression(cJSON *root, const char *kind, const char *axis, const char *expected)
{
    const cJSON *body = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "bodies"), 0), *term;
    cJSON_ArrayForEach(term, cJSON_GetObjectItem(body, "terms"))
    {
        if (strcmp(cJSON_GetObjectItem(term, "kind")->valuestring, kind) != 0) continue;
        char *text = cJSON_PrintUnformatted(cJSON_GetObjectItem(term, axis));
        g_assert_cmpstr(text, ==, expected);
        cJSON_free(text);
        return;
    }
    g_error("no term of kind %s", kind);
}

static void test_json(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", HANGING);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json --as json");
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    g_assert_cmpstr(cJSON_GetObjectItem(root, "form")->valuestring, ==, "newton");
    assert_expression(root, "field", "y", "[\"-\",[\"*\",\"m\",\"g\"]]");
    assert_expression(root, "connector", "x", "[\"-\",[\"/\",[\"*\",\"T\",\"Load.x\"],\"L\"]]");
    cJSON_Delete(root);
}

/* The textbook's equation about rest, which is m g / k below the rest length; damped it would have c q' as well. */
static void test_matrix(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", HANGING);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix");
    g_autofree char *text = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted = g_utf8_normalize("m q̈ + k q = 0\n", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(text, wanted);
    g_autofree char *divided = g_utf8_normalize("q̈ + ω₀² q = 0\n", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(text, divided);
    cli_assert_holds(text, "q = y − 1.6 m   counted from rest");
    cli_assert_holds(text, "ω₀ = 5 rad/s ");
    cli_assert_holds(text, "T = 1.25664 s ");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json --form matrix --as json");
    cJSON *root = cJSON_Parse(program->output);
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    char *stiffness = cJSON_PrintUnformatted(cJSON_GetObjectItem(island, "K"));
    g_assert_cmpstr(stiffness, ==, "[[\"k\"]]");
    g_assert_cmpfloat(fabs(cJSON_GetArrayItem(cJSON_GetObjectItem(island, "omega"), 0)->valuedouble - 5), <, 1e-12);
    g_assert_cmpfloat(fabs(cJSON_GetObjectItem(cJSON_GetObjectItem(island, "about"), "q_1")->valuedouble - 1.6), <,
                      1e-12);
    cJSON_free(stiffness);
    cJSON_Delete(root);
}

/* Letters that pdfLaTeX has not are marked, signs that only formulas have are formulas, and what is held names its
 * unknown. */
static void test_latex_letters(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"title\": \"中 Δx − 50% ≤ ß\", \"blocks\": [{\"type\": \"support\", \"position\": [0, 4]},"
        "{\"type\": \"mass\"}, {\"type\": \"rod\", \"ends\": [\"Support 0\", \"Mass 0\"]}]}");
    g_autoptr(TestProgram) latex = cli_run_well(fixture, "equations @scene.json --as latex");
    cli_assert_holds(latex->output, "\\section*{\\letter{中} $\\Delta$x $-$ 50\\% $\\le$ ß}");
    cli_assert_holds(latex->output, "Rod 0 (unknown ${\\lambda}$: minus its tension)");
}

/* Damped and driven: q'' + 2 zeta omega q' + omega^2 q = F / m, with omega = 5 rad/s and zeta = c / (2 sqrt(k m)) =
 * 0.2. */
static void test_second_order(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"position\": [0, 4], \"solid\": false},"
        "{\"type\": \"mass\", \"mass\": 2, \"position\": [0, 2]},"
        "{\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 50, \"rest_length\": 2},"
        "{\"type\": \"damper\", \"ends\": [\"Support 0\", \"Mass 0\"], \"damping\": 4},"
        "{\"type\": \"motor\", \"ends\": [\"Mass 0\"], \"angle\": \"90 deg\", \"amplitude\": 3, \"frequency\": 2}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix");
    g_autofree char *text = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted = g_utf8_normalize("q̈ + 2 ζ ω₀ q̇ + ω₀² q = ", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(text, wanted);
    cli_assert_holds(text, "ζ = 0.2 ");
    g_autoptr(TestProgram) latex = cli_run_well(fixture, "equations @scene.json --form matrix --as latex");
    cli_assert_holds(latex->output, "^{2}");
}

/* Two masses, the first between a wall and the second: each matrix stands row by row. */
static void test_written_matrices(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"position\": [0, 0], \"solid\": false},"
                  "{\"type\": \"mass\", \"position\": [1, 0]}, {\"type\": \"mass\", \"position\": [3, 0]},"
                  "{\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"]},"
                  "{\"type\": \"damper\", \"ends\": [\"Mass 0\", \"Mass 1\"]}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix");
    cli_assert_holds(page->output, "M = ⎡ m₀   0  ⎤\n      ⎣ 0    m₁ ⎦\n");
    cli_assert_holds(page->output, "C = ⎡ c    −c ⎤\n      ⎣ −c   c  ⎦\n");
    cli_assert_holds(page->output, "K = ⎡ k   0 ⎤\n      ⎣ 0   0 ⎦\n");
    cli_assert_holds(page->output, "f = ⎡ ");
    g_autoptr(TestProgram) latex = cli_run_well(fixture, "equations @scene.json --form matrix --as latex");
    cli_assert_holds(latex->output, "\\begin{bmatrix}{k} & 0 \\\\ 0 & 0\\end{bmatrix}");
    g_autoptr(TestProgram) mathml = cli_run_well(fixture, "equations @scene.json --form matrix --as mathml");
    cli_assert_holds(mathml->output,
                     "<mtable><mtr><mtd><mrow><mi>k</mi></mrow></mtd><mtd><mrow><mn>0</mn></mrow></mtd></mtr>");
}

/* A pendulum, and one whose pivot is shaken up and down, as textbooks have them. */
static void test_angles(CliFixture *fixture, gconstpointer data)
{
    static const char pendulum[] =
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\", \"name\": \"Gravity\"},"
        "{\"type\": \"support\", \"name\": \"Pivot\", \"position\": [0, 3], \"solid\": false},"
        "{\"type\": \"mass\", \"name\": \"Bob\", \"mass\": 2, \"position\": [1, 3]},"
        "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"Bob\", \"Pivot\"]}%s]}";
    static const char shake[] = ",{\"type\": \"support-motion\", \"name\": \"Shake\", \"ends\": [\"Pivot\"],"
                                "\"amplitude\": 0.1, \"frequency\": 9, \"angle\": \"90 deg\"}";
    const char *const pages[][2] = {{"", "m l² θ̈ + m g l sin(θ) = 0\n"}, {shake, "m l² θ̈ + m (g + Ÿ) l sin(θ) = 0\n"}};
    for (gsize i = 0; i < G_N_ELEMENTS(pages); i++) {
        g_auto(GStrv) around = g_strsplit(pendulum, "%s", 2);
        g_autofree char *scene = g_strconcat(around[0], pages[i][0], around[1], NULL);
        g_autofree char *path = cli_write(fixture, "scene.json", scene);
        g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form angles");
        g_autofree char *text = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
        g_autofree char *wanted = g_utf8_normalize(pages[i][1], -1, G_NORMALIZE_DEFAULT_COMPOSE);
        cli_assert_holds(text, wanted);
        cli_assert_holds(text, "θ = 1.5708 rad   Rod, from straight down");
        if (i == 1) cli_assert_holds(text, "Ÿ = −A ω² sin(ω t)");
    }
    g_autofree char *hanging = cli_write(fixture, "scene.json", HANGING);
    g_autoptr(TestProgram) none = cli_run_well(fixture, "equations @scene.json --form angles");
    cli_assert_holds(none->output, "Load has no equations in angles: it hangs on no rod from a support");
}

/* A wall that a table moves at 1.5 m/s pulls 1 kg by a damper of 2 N s/m: T = -2 (1.5 - v), v = 1.5 (1 - exp(-2 t)). */
static void test_table(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *table = cli_write(fixture, "way.csv", "t,x\n0,0\n1,1.5\n2,3\n");
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
                  "{\"type\": \"mass\", \"name\": \"A\", \"position\": [3, 0]},"
                  "{\"type\": \"damper\", \"ends\": [\"Wall\", \"A\"], \"damping\": 2},"
                  "{\"type\": \"support-motion\", \"ends\": [\"Wall\"],"
                  "\"waveform\": {\"table\": \"way.csv\", \"column\": 1}}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --at 0.5");
    g_autofree char *found = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *tension = g_strdup_printf("T = −%.6g N\n", 2 * 1.5 * exp(-1));
    cli_assert_holds(found, "u\u0307 = 1.5 m/s");
    cli_assert_holds(found, tension);
}

/* At the instant of a jump the numbers are those that hold from there on, as in the record. */
static void test_at_jump(CliFixture *fixture, gconstpointer data)
{
    static const char *const drives[] = {
        "{\"type\": \"motor\", \"ends\": [\"A\"], \"waveform\": {\"expression\": \"5*step(t-1)\"}}",
        "{\"type\": \"law-force\", \"ends\": [\"A\"], \"force_x\": \"5*step(t-1)+x\"}",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(drives); i++) {
        g_autofree char *scene =
            g_strdup_printf("{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"A\"}, %s]}", drives[i]);
        g_autofree char *path = cli_write(fixture, "scene.json", scene);
        g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --at 1");
        cli_assert_holds(page->output, " = 5 N\n");
        cli_assert_holds(page->output, "t = 1 s");
    }
}

/* What a table moves shakes: at rest is what it would be at u = 0, and the spring's k u stays on the right side. */
static void test_table_forces(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *table = cli_write(fixture, "way.csv", "t,x\n0,0\n1,0.2\n2,0\n");
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
                  "{\"type\": \"mass\", \"name\": \"A\", \"position\": [3, 0]},"
                  "{\"type\": \"spring\", \"ends\": [\"Wall\", \"A\"], \"stiffness\": 8, \"rest_length\": 3},"
                  "{\"type\": \"support-motion\", \"ends\": [\"Wall\"],"
                  "\"waveform\": {\"table\": \"way.csv\", \"column\": 1}}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix --at 1");
    g_autofree char *found = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *wanted = g_utf8_normalize("m q̈ + k q = k u\n", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(found, wanted);
    cli_assert_holds(found, "q = x − 3 m ");
}

/* A pendulum whose pivot a table moves has no equation in its angle: what the pivot's acceleration is, nothing says. */
static void test_table_pivot(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *table = cli_write(fixture, "way.csv", "t,x\n0,0\n1,1.5\n2,3\n");
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
                  "{\"type\": \"mass\", \"name\": \"A\", \"position\": [3, 0]},"
                  "{\"type\": \"rod\", \"ends\": [\"Wall\", \"A\"]},"
                  "{\"type\": \"support-motion\", \"ends\": [\"Wall\"],"
                  "\"waveform\": {\"table\": \"way.csv\", \"column\": 1}}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form angles");
    cli_assert_holds(page->output, "A has no equations in angles: what moves its support is not written");
}

/* A mass that hangs at rest, to the last digit of its place: what is left of its weight less the spring's pull is
 * rounding and is 0 on a page, in numbers as in matrices. A place that is a nanometre off is none. JSON has all digits.
 */
static void test_rounding(CliFixture *fixture, gconstpointer data)
{
    static const double off[] = {0, 1e-9};
    for (gsize i = 0; i < G_N_ELEMENTS(off); i++) {
        const double y = 0.7 - (1.1 + 0.3 * 9.81 / 7) + off[i];
        g_autofree char *text = g_strdup_printf(
            "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
            "{\"type\": \"support\", \"name\": \"Top\", \"position\": [0, 0.7], \"solid\": false},"
            "{\"type\": \"mass\", \"name\": \"Load\", \"mass\": 0.3, \"position\": [0, %.17g]},"
            "{\"type\": \"spring\", \"ends\": [\"Top\", \"Load\"], \"stiffness\": 7, \"rest_length\": 1.1}]}",
            y);
        g_autofree char *scene = cli_write(fixture, "scene.json", text);
        g_autoptr(TestProgram) newton = cli_run_well(fixture, "equations @scene.json --at 0");
        g_autoptr(TestProgram) matrix = cli_run_well(fixture, "equations @scene.json --form matrix");
        cli_assert_holds(newton->output, i == 0 ? "−2.943 + 2.943 = 0 N\n" : "−2.943 + 2.943 = −7e-09 N\n");
        cli_assert_holds(matrix->output, i == 0 ? "q = 0 m " : "q = 1e-09 m ");
    }
}

/* A support that a plugin moves round a circle of 0.4 m at 2 rad/s and does not tell how: its velocity is a number like
 * its place, not 0, and the pull of a damper is the run's. */
static void test_motion_without_law(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"S\", \"solid\": false},"
                  "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, -1]},"
                  "{\"type\": \"damper\", \"ends\": [\"S\", \"A\"], \"damping\": 5},"
                  "{\"type\": \"orbit\", \"ends\": [\"S\"], \"radius\": 0.4, \"rate\": 2}]}");
    g_autofree char *plugins = g_test_build_filename(G_TEST_BUILT, "physics", "plugins", NULL);
    g_autofree char *command = g_strdup_printf("equations @scene.json --at 0 --plugins %s", plugins);
    g_autoptr(TestProgram) page = cli_run_well(fixture, command);
    g_autofree char *found = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    g_autofree char *rate = g_utf8_normalize("u̇y = 0.8 m/s", -1, G_NORMALIZE_DEFAULT_COMPOSE);
    cli_assert_holds(found, rate);
    cli_assert_holds(found, "T = 4 N\n");
    cli_assert_holds(found, "not written: Orbit 0 (its plugin states no law)");
}

static void test_formats(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", HANGING);
    g_autoptr(TestProgram) latex = cli_run_well(fixture, "equations @scene.json --as latex");
    g_autoptr(TestProgram) mathml = cli_run_well(fixture, "equations @scene.json --as mathml");
    cli_assert_holds(latex->output, "{T} &= {k}\\,({L}-{L}_{0})");
    cli_assert_holds(latex->output, "\\end{document}");
    cli_assert_holds(mathml->output, "<mfrac>");
    cli_assert_holds(mathml->output, "<html lang=\"en\">");
    cli_assert_holds(mathml->output, "</html>");
}

/* A number that is typed for a force is one of newtons, and stands in the equations by a symbol that says so. */
static void test_typed_number(CliFixture *fixture, gconstpointer data)
{
    static const char *const blocks[] = {
        "{\"type\": \"motor\", \"name\": \"Push\", \"ends\": [\"Load\"], \"waveform\": {\"expression\": \"10\"}}",
        "{\"type\": \"law-force\", \"name\": \"Push\", \"ends\": [\"Load\"], \"force_x\": \"10\"}",
        "{\"type\": \"law-force\", \"name\": \"Push\", \"ends\": [\"Load\"], \"potential\": \"-10*x\"}",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(blocks); i++) {
        g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"run\": {}, \"blocks\": [{\"type\": \"mass\", "
                                                "\"name\": \"Load\"}, %s]}",
                                                blocks[i]);
        g_autofree char *scene = cli_write(fixture, "scene.json", text);
        g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json --as json");
        cJSON *root = cJSON_Parse(program->output);
        g_assert_nonnull(root);
        const cJSON *body = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "bodies"), 0);
        const cJSON *term = cJSON_GetArrayItem(cJSON_GetObjectItem(body, "terms"), 0);
        const cJSON *definition, *x = cJSON_GetObjectItem(term, "x");
        const char *unit = NULL;
        if (cJSON_IsArray(x)) x = cJSON_GetArrayItem(x, 1); /* of F*cos(angle) */
        g_assert_true(cJSON_IsString(x));
        cJSON_ArrayForEach(definition, cJSON_GetObjectItem(root, "definitions"))
        {
            if (!g_str_equal(cJSON_GetObjectItem(definition, "symbol")->valuestring, x->valuestring)) continue;
            unit = cJSON_GetObjectItem(definition, "unit")->valuestring;
            g_assert_cmpfloat(cJSON_GetObjectItem(definition, "is")->valuedouble, ==, 10);
        }
        g_assert_cmpstr(unit, ==, "N");
        cJSON_Delete(root);
    }
}

static void test_refused(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", HANGING);
    g_autoptr(TestProgram) late = cli_run_badly(fixture, "equations @scene.json --at 5", 2);
    cli_assert_holds(late->error, "--at 5: the scene's run lasts 4 s (a time from 0 to that)");
    g_autoptr(TestProgram) stranger = cli_run_badly(fixture, "equations @scene.json --block Lod", 2);
    cli_assert_holds(stranger->error, "--block \"Lod\": the scene has no such block");
    g_autoptr(TestProgram) spring = cli_run_badly(fixture, "equations @scene.json --block Ceiling", 2);
    cli_assert_holds(spring->error, "--block \"Ceiling\": it has no equation of motion");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations/page", test_page);
    cli_test_add("/cli/equations/numbers", test_numbers);
    cli_test_add("/cli/equations/json", test_json);
    cli_test_add("/cli/equations/matrix", test_matrix);
    cli_test_add("/cli/equations/written-matrices", test_written_matrices);
    cli_test_add("/cli/equations/second-order", test_second_order);
    cli_test_add("/cli/equations/angles", test_angles);
    cli_test_add("/cli/equations/table", test_table);
    cli_test_add("/cli/equations/table-forces", test_table_forces);
    cli_test_add("/cli/equations/table-pivot", test_table_pivot);
    cli_test_add("/cli/equations/rounding", test_rounding);
    cli_test_add("/cli/equations/motion-without-law", test_motion_without_law);
    cli_test_add("/cli/equations/formats", test_formats);
    cli_test_add("/cli/equations/typed-number", test_typed_number);
    cli_test_add("/cli/equations/latex-letters", test_latex_letters);
    cli_test_add("/cli/equations/at-jump", test_at_jump);
    cli_test_add("/cli/equations/refused", test_refused);
    return g_test_run();
}
