/* tinker run: statistics and spectra of what was recorded, and conditions that end it. */
#include <math.h>
#include <string.h>

#include "fixture.h"

#define DAMPED                                                                                                         \
    "{\"tinker\": 1, \"run\": {\"duration\": 40}, \"blocks\": ["                                                       \
    "{\"type\": \"support\", \"name\": \"S\", \"position\": [0, 4], \"orientation\": \"180 deg\"}, "                   \
    "{\"type\": \"mass\", \"name\": \"M\", \"position\": [0, 1], \"mass\": 1}, "                                       \
    "{\"type\": \"spring\", \"name\": \"K\", \"ends\": [\"S\", \"M\"], \"stiffness\": 25, \"rest_length\": 2}, "       \
    "{\"type\": \"damper\", \"name\": \"C\", \"ends\": [\"S\", \"M\"], \"damping\": 0.1}]}"

/* Waits until the run has written something, so that it is surely under way. */
/* The number behind a key; FALSE where it is null. */
static gboolean read_number(const char *text, const char *key, double *number)
{
    g_autofree char *quoted = g_strdup_printf("\"%s\":", key);
    const char *at = strstr(text, quoted);
    char *end;
    g_assert_nonnull(at);
    at += strlen(quoted);
    while (g_ascii_isspace(*at))
        at++;
    *number = g_ascii_strtod(at, &end);
    return end != at;
}

/* Whatever the interval of samples is, from much less than a swing to more than one, what is told is true to within its
 * error: of a mass of 1 kg on 25 N/m with 0.1 N s/m the period and the logarithmic decrement. */
static void test_coarse_samples(CliFixture *fixture, gconstpointer data)
{
    static const char *const intervals[] = {"0.01", "0.3", "0.5", "0.8", "1", "1.25", "1.2566998980017708", "2.5", "5"};
    const double period = 2 * G_PI / sqrt(25 - 0.0025);
    const struct {
        const char *key;
        double truth;
    } all[] = {{"period", period}, {"decrement", 0.05 * period}};
    g_autofree char *scene = cli_write(fixture, "damped.json", DAMPED);
    for (gsize i = 0; i < G_N_ELEMENTS(intervals); i++) {
        g_autofree char *line =
            g_strdup_printf("graph @damped.json M.y --interval %s --statistics --json -", intervals[i]);
        g_autoptr(TestProgram) run = cli_run_well(fixture, line);
        for (gsize k = 0; k < G_N_ELEMENTS(all); k++) {
            g_autofree char *quoted = g_strdup_printf("\"%s\":", all[k].key);
            const char *at = strstr(run->output, quoted);
            double value, error;
            const gboolean is_told = read_number(at, "value", &value) && read_number(at, "error", &error);
            if (is_told) g_assert_cmpfloat(fabs(value - all[k].truth), <=, error);
            if (i < 4) g_assert_true(is_told && error < 0.01 * value);
        }
    }
}

/* x = 2 + cos 10t over two periods. */
static void test_statistics(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) run = cli_run_well(fixture, "graph @a.json 'Mass 0.x' --interval 0.01 --statistics --to "
                                                       "1.2566370614359172 --json -");
    const struct {
        const char *key;
        double truth, bound;
    } all[] = {{"mean", 2, 1e-9}, {"rms", sqrt(4.5), 1e-9}, {"max", 3, 1e-9}, {"period", G_PI / 5, 1e-7}};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++) {
        g_autofree char *key = g_strdup_printf("\"%s\":", all[i].key);
        const char *at = strstr(run->output, key);
        g_assert_nonnull(at);
        const double value = g_ascii_strtod(strstr(at, "\"value\":") + strlen("\"value\":"), NULL);
        g_assert_cmpfloat(fabs(value - all[i].truth), <, all[i].bound);
    }
    /* a run in steps of 0.6 rad is off by far more than its samples are: the errors tell of that, too */
    g_autoptr(TestProgram) coarse =
        cli_run_well(fixture, "graph @a.json 'Mass 0.x' --interval 0.01 --step 0.06 --statistics --json -");
    const char *least = strstr(coarse->output, "\"min\":");
    g_assert_nonnull(least);
    const double off = fabs(g_ascii_strtod(strstr(least, "\"value\":") + strlen("\"value\":"), NULL) - 1);
    const double error = g_ascii_strtod(strstr(least, "\"error\":") + strlen("\"error\":"), NULL);
    g_assert_cmpfloat(off, >, 1e-3);
    g_assert_cmpfloat(error, >, off);
    g_assert_cmpfloat(error, <, 1);
    g_autoptr(TestProgram) text = cli_run_well(fixture, "graph @a.json 'Mass 0.x' --interval 0.01 --statistics");
    cli_assert_holds(text->output, "amplitude");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "graph @a.json 'Mass 0.x' --statistics --from 3", 2);
    cli_assert_holds(wrong->error, "--from and --to leave nothing");
}

/* It is drawn; what cannot be is refused. The numbers are those of tests/measure. */
static void test_spectrum(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) run =
        cli_run_well(fixture, "graph @a.json 'Mass 0.x' --interval 0.01 --spectrum hann -o @s.svg");
    g_autofree char *svg = cli_read(fixture, "s.svg");
    cli_assert_holds(svg, "<svg");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "graph @a.json 'Mass 0.x' --spectrum box -o @s.svg", 2);
    cli_assert_holds(wrong->error, "it must be hann or none");
    /* x = 2 + cos 10t at 5 periods of 0.2 pi s, 64 samples each: the line is the fifth */
    g_autoptr(TestProgram) table = cli_run_well(
        fixture, "graph @a.json 'Mass 0.x' '2*{Mass 0.x}' --interval 0.00981747704246810 --duration 5 --from 1 "
                 "--to 4.1337 --spectrum none -o @s.csv");
    g_autofree char *csv = cli_read(fixture, "s.csv");
    g_auto(GStrv) rows = g_strsplit(csv, "\n", -1);
    g_assert_cmpuint(g_strv_length(rows), ==, 1 + 161 + 1);
    g_assert_cmpstr(rows[0], ==, "Frequency,Mass 0 X Position,2*{Mass 0.x}");
    for (guint row = 0; row < 161; row++) {
        g_auto(GStrv) cells = g_strsplit(rows[row + 1], ",", 3);
        g_assert_cmpfloat(fabs(g_ascii_strtod(cells[0], NULL) - row / G_PI), <, 1e-6);
        g_assert_cmpfloat(fabs(g_ascii_strtod(cells[1], NULL) - (row == 5)), <, 1e-5);
        g_assert_cmpfloat(fabs(g_ascii_strtod(cells[2], NULL) - 2 * (row == 5)), <, 1e-5);
    }
    /* a graph of the scene that is one */
    g_autofree char *own = cli_write(
        fixture, "b.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"mass\"}], \"graphs\": [{\"curves\": "
        "[{\"expression\": \"sin(2*pi*3*t)\"}], \"against\": \"frequency\"}]}");
    g_autoptr(TestProgram) of_scene = cli_run_well(fixture, "graph @b.json -o @b.csv");
    g_autofree char *own_csv = cli_read(fixture, "b.csv");
    cli_assert_holds(own_csv, "Frequency,sin(2*pi*3*t)\n");
    cli_assert_holds(own_csv, "\n3,1\n");
    g_autoptr(TestProgram) short_one = cli_run_badly(fixture, "graph @b.json --from 9.98 -o @b.csv", 2);
    cli_assert_holds(short_one->error, "too few evenly spaced samples");
}

#define FREE_FALL_UNTIL(until)                                                                                         \
    "{\"tinker\": 1, \"run\": {\"until\": \"" until "\"}, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": "           \
    "\"mass\"}]}"

/* A graph, its statistics and a film end where the run does, and say so. */
static void test_until_in_pictures(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL_UNTIL("{Mass 0.y} = -1.2; t > 3"));
    g_autoptr(TestProgram) graph = cli_run_well(fixture, "graph @a.json 'Mass 0.y' -o -");
    g_auto(GStrv) lines = g_strsplit(g_strchomp(graph->output), "\n", -1);
    const char *last = lines[g_strv_length(lines) - 1];
    g_assert_cmpuint(g_strv_length(lines), ==, 52);
    g_assert_cmpfloat(fabs(g_ascii_strtod(last, NULL) - sqrt(2.4 / 9.81)), <, 1e-8);
    cli_assert_holds(graph->error, "a.json: ended at 0.494");
    cli_assert_holds(graph->error, " s, where {Mass 0.y} = -1.2\n");

    /* the mean of -g t^2 / 2 up to there is a third of its last value */
    g_autoptr(TestProgram) mean = cli_run_well(fixture, "graph @a.json 'Mass 0.y' --statistics");
    cli_assert_holds(mean->output, "-0.4");
    cli_assert_holds(mean->error, "a.json: ended at 0.494");

    /* 0, 0.1, 0.2, 0.3, 0.4 and the end */
    g_autoptr(TestProgram) film = cli_run_well(fixture, "animate @a.json --fps 10 --size 32x32 -o @film.png");
    cli_assert_holds(film->error, "wrote 6 pictures");
    cli_assert_holds(film->error, "a.json: ended at 0.494");

    g_autofree char *other = cli_write(fixture, "b.json", FREE_FALL_UNTIL("t > 30"));
    g_autoptr(TestProgram) never = cli_run_well(fixture, "graph @b.json 'Mass 0.y' -o @y.csv");
    cli_assert_holds(never->error, "b.json: no condition that would end the run came true in 10 s");
}

/* y = -9.81 t^2 / 2: at -1.2 m after sqrt(2.4 / 9.81) s, where the record and the run end. */
static void test_until(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    const double end = sqrt(2.4 / 9.81);
    g_autoptr(TestProgram) run =
        cli_run_well(fixture, "run @a.json --until '{Mass 0.vy} < -9' --until '{Mass 0.y} = -1.2' "
                              "--csv @r.csv --json @s.json");
    g_autofree char *csv = cli_read(fixture, "r.csv"), *json = cli_read(fixture, "s.json");
    g_autoptr(TestTable) table = test_table_new(csv);
    g_assert_cmpuint(table->rows, ==, 51);
    g_assert_cmpfloat(fabs(test_table_value(table, 50, "time") - end), <, 1e-9);
    g_assert_cmpfloat(fabs(test_table_value(table, 50, "Mass 0.y") + 1.2), <, 1e-8);
    g_assert_cmpfloat(test_table_value(table, 29, "time"), ==, 0.29);
    cli_assert_holds(json, "\"stopped_by\":\t\"{Mass 0.y} = -1.2\"");
    cli_assert_holds(json, "\"simulated_s\":\t0.494");
    g_autoptr(TestProgram) never = cli_run_well(fixture, "run @a.json --until 'event(impact)' --json -");
    cli_assert_holds(never->output, "\"stopped_by\":\tnull");
    cli_assert_holds(never->error, "no condition that would end the run came true in");
    cli_assert_holds(run->output, "  ended at 0.494");
    cli_assert_holds(run->output, " s, where {Mass 0.y} = -1.2\n");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "run @a.json --until '{Mass 0.y}'", 2);
    cli_assert_holds(wrong->error, "--until");
    /* a condition of the scene's own, which the option stands in place of */
    g_autofree char *own = cli_write(fixture, "b.json", FREE_FALL_UNTIL("{Mass 0.y} = -1.2; t > 3"));
    g_autoptr(TestProgram) of_scene = cli_run_well(fixture, "run @b.json");
    cli_assert_holds(of_scene->output, " s, where {Mass 0.y} = -1.2\n");
    g_autoptr(TestProgram) other = cli_run_well(fixture, "run @b.json --until 't > 0.25'");
    cli_assert_holds(other->output, "  ended at 0.25 s, where t > 0.25\n");
    g_autofree char *bad = cli_write(fixture, "c.json", FREE_FALL_UNTIL("{Mass 1.y} = 0"));
    g_autoptr(TestProgram) refused = cli_run_badly(fixture, "check @c.json", 3);
    cli_assert_holds(refused->error, "run: until: \"{Mass 1.y} = 0\": column 1: ");
    cli_assert_holds(wrong->error, "it is no condition");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/run/until", test_until);
    cli_test_add("/run/until-in-pictures", test_until_in_pictures);
    cli_test_add("/run/statistics", test_statistics);
    cli_test_add("/run/coarse-samples", test_coarse_samples);
    cli_test_add("/run/spectrum", test_spectrum);
    return g_test_run();
}
