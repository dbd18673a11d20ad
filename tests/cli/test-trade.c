/* tinker trade: what it prints, writes and refuses. What it measures is tested beside core/analysis. */
#include <math.h>
#include <string.h>

#include "fixture.h"

#define HEADER "method,step,tolerance,wall_s,evaluations,error,energy_error,constraint_error,note"

/* The oscillator of the fixture, whose spring is so stiff that large steps diverge. */
#define STIFF                                                                                                          \
    "{\"tinker\": 1, \"run\": {\"duration\": 1, \"interval\": 0.5, \"method\": \"rk4\", \"step\": 0.001},\n"           \
    " \"blocks\": [{\"type\": \"support\"}, {\"type\": \"mass\", \"position\": [1.1, 0]},\n"                           \
    "  {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 1e6, \"rest_length\": 1}]}\n"

/* Fields of a line of CSV; notes may be quoted and hold commas, all others are plain. */
static char **fields_of(const char *line)
{
    return g_strsplit(line, ",", 9);
}

static void test_csv(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", STIFF);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "trade @a.json --methods rk4,dop853 --seconds 2 --csv -");
    g_auto(GStrv) lines = g_strsplit(program->output, "\n", -1);
    g_assert_cmpstr(lines[0], ==, HEADER);
    int failed = 0, measured = 0;
    for (char **line = lines + 1; **line != '\0'; line++) {
        g_auto(GStrv) fields = fields_of(*line);
        g_assert_cmpuint(g_strv_length(fields), ==, 9);
        gboolean fixed = g_str_equal(fields[0], "rk4");
        g_assert_true(fixed || g_str_equal(fields[0], "dop853"));
        /* a step or a tolerance, not both */
        g_assert_cmpint(fields[1][0] != '\0', ==, fixed);
        g_assert_cmpint(fields[2][0] != '\0', ==, !fixed);
        if (fields[5][0] == '\0') {
            g_assert_cmpstr(fields[3], ==, "");
            cli_assert_holds(fields[8], "diverged");
            failed++;
        } else {
            g_assert_cmpfloat(g_ascii_strtod(fields[3], NULL), >, 0);
            g_assert_cmpfloat(g_ascii_strtod(fields[4], NULL), >, 0);
            measured++;
        }
    }
    g_assert_cmpint(failed, >=, 1);
    g_assert_cmpint(measured, >=, 8);
    /* what is for people goes to the other stream then */
    cli_assert_holds(program->error, "OBSERVED ORDER");
    cli_assert_holds(program->error, "For an error of at most 1e-06 the cheapest is ");
}

static void test_pictures(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *name, *beginning;
    } forms[] = {{"t.svg", "<?xml"}, {"t.pdf", "%PDF"}, {"t.png", "\211PNG"}};
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    for (gsize i = 0; i < G_N_ELEMENTS(forms); i++) {
        g_autofree char *words =
            g_strdup_printf("trade @a.json --methods verlet --seconds 0.5 --error 1e-2 -o @%s", forms[i].name);
        g_autoptr(TestProgram) program = cli_run_well(fixture, words);
        cli_assert_holds(program->output, "\nverlet ");
        cli_assert_holds(program->output, "confirms it to ");
        g_autofree char *text = cli_read(fixture, forms[i].name);
        g_assert_true(g_str_has_prefix(text, forms[i].beginning));
    }
}

/* The scene runs by the advice from then on, and nothing else of it changes. */
static void test_write(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) before = cli_run_well(fixture, "convert @a.json -o @before.json");
    g_autoptr(TestProgram) program =
        cli_run_well(fixture, "trade @a.json --methods verlet --seconds 1 --error 1e-3 --write");
    cli_assert_holds(program->output, "the cheapest is verlet with a step of ");
    g_autoptr(TestProgram) run = cli_run_well(fixture, "run @a.json --json @run.json");
    g_autofree char *path = cli_path(fixture, "run.json");
    cJSON *summary = test_read_json(path);
    g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(summary, "method")), ==, "verlet");
    double step = cJSON_GetNumberValue(cJSON_GetObjectItem(summary, "step"));
    g_autofree char *said = g_strdup_printf("verlet with a step of %g s", step);
    cli_assert_holds(program->output, said);
    cJSON_Delete(summary);

    g_autofree char *old_path = cli_path(fixture, "before.json"), *new_path = cli_path(fixture, "a.json");
    cJSON *old = test_read_json(old_path), *new = test_read_json(new_path);
    cJSON *old_run = cJSON_GetObjectItem(old, "run"), *new_run = cJSON_GetObjectItem(new, "run");
    g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(old_run, "method")), ==, "rk4");
    static const char *const changed[] = {"method", "step"};
    for (gsize i = 0; i < G_N_ELEMENTS(changed); i++) {
        cJSON_DeleteItemFromObject(old_run, changed[i]);
        cJSON_DeleteItemFromObject(new_run, changed[i]);
    }
    g_assert_true(cJSON_Compare(old, new, TRUE));
    cJSON_Delete(old);
    cJSON_Delete(new);
}

/* Advice that does not keep to the wish is not written. */
static void test_no_write(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program =
        cli_run_badly(fixture, "trade @a.json --methods rk4 --seconds 0.5 --budget 1e-9 --write", 1);
    cli_assert_holds(program->output, "Nothing measured runs within 1 ns. The fastest is rk4 with a step of ");
    g_autofree char *text = cli_read(fixture, "a.json");
    g_assert_cmpstr(text, ==, OSCILLATOR);
}

/* The failures of a table stand apart from it, by an empty line. */
static void test_failures(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program = cli_run(fixture, "trade @a.json --methods rk4 --error 1e-3 --seconds 2");
    if (strstr(program->output, "no result, see below") == NULL)
        g_test_fail_printf("nothing failed: %s", program->output);
    cli_assert_holds(program->output, "\n\nrk4 at ");
    g_assert_null(strstr(program->output, "\\n"));
}

static void test_mistakes(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *words;
        int status;
        const char *message;
    } mistakes[] = {
        {"trade @a.json --methods rk4,rk5", 2, "did you mean \"rk4\""},
        {"trade @a.json --methods ''", 2, "no method is named"},
        {"trade @a.json --error 1e-6 --budget 1", 2, "exclude each other"},
        {"trade @a.json --error 0", 2, "--error"},
        {"trade @a.json --budget '3 kg'", 2, "--budget"},
        {"trade @a.json -o trade.gif", 2, ".png, .svg, .pdf"},
        {"trade @a.json --csv @a.json", 2, "is the scene itself"},
        {"trade @a.json --csv @nowhere/t.csv", 5, "does not exist"},
        {"trade @a.json --at 0", 2, "duration"},
        {"trade @none.json", 5, "none.json"},
        {"trade @bad.json", 3, "mass"},
    };
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autofree char *bad =
        cli_write(fixture, "bad.json", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"mass\": -1}]}");
    for (gsize i = 0; i < G_N_ELEMENTS(mistakes); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, mistakes[i].words, mistakes[i].status);
        cli_assert_holds(program->error, mistakes[i].message);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/trade/csv", test_csv);
    cli_test_add("/trade/pictures", test_pictures);
    cli_test_add("/trade/write", test_write);
    cli_test_add("/trade/no-write", test_no_write);
    cli_test_add("/trade/failures", test_failures);
    cli_test_add("/trade/mistakes", test_mistakes);
    return g_test_run();
}
