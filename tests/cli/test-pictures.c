/* tinker graph and render: tables, pictures and forces in them, and what is refused. */
#include <string.h>

#include "fixture.h"

/* Figure 30 of the thesis that the program follows. */
static void test_graph_of_thesis(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) program =
        cli_run_well(fixture, "graph @a.json 'Mass 0.y' --decimals 5 --duration 0.1 -o @fall.csv");
    g_autofree char *csv = cli_read(fixture, "fall.csv");
    g_assert_cmpstr(csv, ==,
                    "Time,Y Position\n0,0\n0.01,-0.00049\n0.02,-0.00196\n0.03,-0.00441\n0.04,-0.00785\n0.05,-0.01226\n"
                    "0.06,-0.01766\n0.07,-0.02403\n0.08,-0.03139\n0.09,-0.03973\n0.1,-0.04905\n");
    /* nine significant digits; and -0 is 0 */
    g_autoptr(TestProgram) full = cli_run_well(fixture, "graph @a.json 'Mass 0.y' --duration 0.02 -o -");
    g_assert_cmpstr(full->output, ==, "Time,Y Position\n0,0\n0.01,-0.0004905\n0.02,-0.001962\n");
    g_autoptr(TestProgram) coarse = cli_run_well(fixture, "graph @a.json 'Mass 0.y' --decimals 2 --duration 0.02 -o -");
    g_assert_cmpstr(coarse->output, ==, "Time,Y Position\n0,0\n0.01,0\n0.02,0\n");
}

/* Graphs of other axes than the first are named, with the words that draw them. */
static void test_graphs_left_out(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "a.json",
                  "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"mass\"}],"
                  "\"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"y\"},"
                  "{\"block\": \"Mass 0\", \"quantity\": \"vy\", \"against\": \"y\"}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "graph @a.json -o @a.svg");
    cli_assert_holds(program->error, "graph of Mass 0.vy left out: other axes than the first");
    cli_assert_holds(program->error, "\"Mass 0.vy\" --against \"y\"");
}

static void test_graph_forms(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) two = cli_run_well(fixture, "graph @a.json 'Mass 0.y' 'Mass 0.vy' --duration 0.01 -o -");
    g_assert_cmpstr(two->output, ==, "Time,Mass 0 Y Position,Mass 0 Y Velocity\n0,0,0\n0.01,-0.0004905,-0.0981\n");
    g_autoptr(TestProgram) phase = cli_run_well(fixture, "graph @a.json 'Mass 0.vy' --against y --duration 0.01 -o -");
    g_assert_cmpstr(phase->output, ==, "Y Position,Y Velocity\n0,0\n-0.0004905,-0.0981\n");
    g_autoptr(TestProgram) own = cli_run_well(fixture, "graph @a.json --duration 0.01 -o -");
    g_assert_cmpstr(own->output, ==, "Time,Y Position\n0,0\n0.01,-0.0004905\n");

    /* what the scene displays: 0.3048 m is a foot */
    g_autoptr(TestProgram) convert = cli_run_well(fixture, "convert @a.json --units English -o @english.json");
    g_autoptr(TestProgram) feet = cli_run_well(fixture, "graph @english.json 'Mass 0.y' --interval 1 -o -");
    g_assert_cmpstr(feet->output, ==, "Time,Y Position\n0,0\n1,-16.0925197\n"); /* 4.905 / 0.3048 */
}

static void test_pictures(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    static const char *const endings[] = {"png", "svg", "pdf"};
    static const char *const magics[] = {CLI_PNG_BEGINS, "<?xml", "%PDF-"};
    for (gsize i = 0; i < G_N_ELEMENTS(endings); i++) {
        g_autofree char *graph = g_strdup_printf("graph @a.json 'Mass 0.x' -o @graph.%s", endings[i]);
        g_autofree char *render =
            g_strdup_printf("render @a.json -o @scene.%s --time 0.3 --theme dark --no-labels", endings[i]);
        g_autofree char *graph_file = g_strdup_printf("graph.%s", endings[i]);
        g_autofree char *scene_file = g_strdup_printf("scene.%s", endings[i]);
        g_autoptr(TestProgram) drawn = cli_run_well(fixture, graph);
        g_autoptr(TestProgram) rendered = cli_run_well(fixture, render);
        cli_assert_begins(fixture, graph_file, magics[i]);
        cli_assert_begins(fixture, scene_file, magics[i]);
    }
    g_autoptr(TestProgram) small = cli_run_well(fixture, "render @a.json -o @small.png --size 321x123");
    cli_assert_png_size(fixture, "small.png", 321, 123);
}

/* The force is 0/0 at t = 1/16 s, which the companion meets at half the step and the run itself passes: the curve is
 * drawn without a band. */
static void test_graph_without_band(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "a.json",
                  "{\"tinker\": 1, \"run\": {\"duration\": 1, \"interval\": 0.125, \"method\": \"verlet\", "
                  "\"step\": 0.125}, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"motor\", \"ends\": [\"Mass 0\"], "
                  "\"waveform\": {\"expression\": \"sin(t-0.0625)/(t-0.0625)\"}}]}");
    g_autoptr(TestProgram) drawn = cli_run_well(fixture, "graph @a.json 'Mass 0.x' -o @band.svg");
    cli_assert_holds(drawn->error, "the companion run stopped");
    g_autoptr(TestProgram) alone = cli_run_well(fixture, "graph @a.json 'Mass 0.x' --no-estimate -o @alone.svg");
    g_autofree char *with = cli_read(fixture, "band.svg"), *without = cli_read(fixture, "alone.svg");
    g_assert_cmpstr(with, ==, without);
}

/* The mass moves, so the picture of another time is another picture. */
static void test_render_shows_time(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) first = cli_run_well(fixture, "render @a.json -o @first.svg --time 0.1");
    g_autoptr(TestProgram) again = cli_run_well(fixture, "render @a.json -o @again.svg --time 0.1");
    g_autoptr(TestProgram) later = cli_run_well(fixture, "render @a.json -o @later.svg --time 0.2");
    g_autofree char *a = cli_read(fixture, "first.svg"), *b = cli_read(fixture, "again.svg");
    g_autofree char *c = cli_read(fixture, "later.svg");
    g_assert_cmpstr(a, ==, b);
    g_assert_cmpstr(a, !=, c);
}

/* A block at rest on an incline, which gravity, the top and its friction act on: each has the colour of its kind, in
 * the arrow and in the key; and so has a film's picture. */
static void test_forces(CliFixture *fixture, gconstpointer data)
{
    static const char *const colours[] = {"rgb(0%,61.96",
                                          "rgb(54.90"}; /* of normal forces and of friction, as in the window */
    g_autofree char *scene = cli_write(
        fixture, "a.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"orientation\": \"20 deg\"}, {\"type\": \"mass\", \"on\": \"Support 0\"}]}");
    g_autoptr(TestProgram) with = cli_run_well(fixture, "render @a.json --forces -o @with.svg");
    g_autoptr(TestProgram) later = cli_run_well(fixture, "render @a.json --forces -o @later.svg --time 0.1");
    g_autoptr(TestProgram) without = cli_run_well(fixture, "render @a.json -o @without.svg");
    g_autofree char *a = cli_read(fixture, "with.svg"), *b = cli_read(fixture, "without.svg");
    g_autofree char *c = cli_read(fixture, "later.svg");
    for (gsize i = 0; i < G_N_ELEMENTS(colours); i++) {
        cli_assert_holds(a, colours[i]);
        cli_assert_holds(c, colours[i]);
        g_assert_null(strstr(b, colours[i]));
    }
    /* where nothing pulls along the top there is no friction, in the key neither */
    g_autofree char *level = cli_write(fixture, "level.json",
                                       "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"support\"},"
                                       "{\"type\": \"mass\", \"on\": \"Support 0\"}]}");
    g_autoptr(TestProgram) flat = cli_run_well(fixture, "render @level.json --forces -o @level.svg");
    g_autofree char *f = cli_read(fixture, "level.svg");
    cli_assert_holds(f, colours[0]);
    g_assert_null(strstr(f, colours[1]));
    g_autoptr(TestProgram) plain = cli_run_well(fixture, "animate @a.json -o @plain.png --fps 10 --size 320x240");
    g_autoptr(TestProgram) film =
        cli_run_well(fixture, "animate @a.json --forces -o @film.png --fps 10 --size 320x240");
    g_autofree char *p = cli_path(fixture, "plain-0002.png"), *q = cli_path(fixture, "film-0002.png"), *d = NULL,
                    *e = NULL;
    gsize plain_length = 0, film_length = 0;
    g_assert_true(g_file_get_contents(p, &d, &plain_length, NULL) && g_file_get_contents(q, &e, &film_length, NULL));
    g_assert_cmpuint(film_length, >, plain_length); /* there is more in it */
}

static void test_picture_mistakes(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *words;
        int status;
    } failures[] = {
        {"graph @a.json 'Mass 0.x'", 2},
        {"graph @a.json 'Mass 0.x' -o @a.gif", 2},
        {"graph @a.json -o @a.png", 2}, /* the scene has no graphs */
        {"graph @a.json 'Mass 0.q' -o @a.png", 2},
        {"graph @a.json 'Mass 0.x' -o @none/a.png", 5},
        {"graph @a.json 'Mass 0.x' -o - --decimals 99", 2},
        {"render @a.json -o -", 2},
        {"render @a.json -o @a.png --size 10", 2},
        {"render @a.json -o @a.png --size 0x9", 2},
        {"render @a.json -o @a.png --time -1", 2},
        {"render @a.json -o @a.png --theme pink", 2},
        {"render @a.json -o @none/a.png", 5},
        {"animate @a.json -o @a.txt", 2},
        {"animate @a.json -o @a.png --fps 0", 2},
        {"animate @a.json -o @a.png --fps 1e9", 2},
    };
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    for (gsize i = 0; i < G_N_ELEMENTS(failures); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, failures[i].words, failures[i].status);
        g_assert_true(g_str_has_prefix(program->error, "tinker: "));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/verbs/graphs-left-out", test_graphs_left_out);
    cli_test_add("/verbs/graph-of-thesis", test_graph_of_thesis);
    cli_test_add("/verbs/graph-forms", test_graph_forms);
    cli_test_add("/verbs/pictures", test_pictures);
    cli_test_add("/verbs/graph-without-band", test_graph_without_band);
    cli_test_add("/verbs/render-shows-time", test_render_shows_time);
    cli_test_add("/verbs/forces", test_forces);
    cli_test_add("/verbs/picture-mistakes", test_picture_mistakes);
    return g_test_run();
}
