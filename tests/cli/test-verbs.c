/* The verbs beside run: what they write, and their help. */
#include <signal.h>
#include <string.h>

#include "fixture.h"

static void test_help(CliFixture *fixture, gconstpointer data)
{
    static const char *const verbs[] = {"run",     "graph",   "render",       "animate",           "check",
                                        "convert", "plugins", "plugins show", "plugins describe",  "plugins refused",
                                        "bench",   "plan",    "equations",    "diagram",           "books",
                                        "demo",    "trade",   "plugins new",  "plugins new-bundle"};
    g_autoptr(TestProgram) all = cli_run_well(fixture, "--help");
    for (gsize i = 0; i < G_N_ELEMENTS(verbs); i++) {
        g_autofree char *words = g_strdup_printf("%s --help", verbs[i]);
        g_autofree char *usage = g_strdup_printf("tinker %s", verbs[i]);
        g_autoptr(TestProgram) help = cli_run_well(fixture, words);
        cli_assert_holds(help->output, usage);
        cli_assert_holds(help->output, "Examples:");
        if (strchr(verbs[i], ' ') == NULL) cli_assert_holds(all->output, verbs[i]);
    }
    g_autoptr(TestProgram) version = cli_run_well(fixture, "--version");
    g_assert_true(g_str_has_prefix(version->output, "tinker "));
    g_autoptr(TestProgram) nothing = cli_run_badly(fixture, "", 2);
}

/* Every "FILE:LINE:" of the text, in order, is at a line no less than the one before. */
static void assert_lines_ascend(const char *text, int count)
{
    g_autoptr(GRegex) place = g_regex_new("json:(\\d+):\\d+: ", 0, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    int last = 0, found = 0;
    for (g_regex_match(place, text, 0, &match); g_match_info_matches(match); g_match_info_next(match, NULL), found++) {
        g_autofree char *line = g_match_info_fetch(match, 1);
        g_assert_cmpint(atoi(line), >=, last);
        last = atoi(line);
    }
    g_assert_cmpint(found, ==, count);
}

static void test_check(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *bad = cli_write(fixture, "bad.json",
                                     "{\"tinker\": 1,\n"
                                     " \"run\": {\"duration\": -3},\n"
                                     " \"blocks\": [\n"
                                     "  {\"type\": \"mass\", \"mass\": \"3 ft\"},\n"
                                     "  {\"type\": \"spring\", \"ends\": [\"Mass 0\", \"Mass 7\"]},\n"
                                     "  {\"type\": \"mass\", \"name\": \"Mass 0\", \"widht\": 1}\n"
                                     " ]}\n");
    g_autoptr(TestProgram) program = cli_run_badly(fixture, "check @bad.json", 3);
    g_assert_cmpstr(program->output, ==, "");
    assert_lines_ascend(program->error, 4);
    cli_assert_holds(program->error, "json:2:");
    cli_assert_holds(program->error, "a mass (kg) was expected");
    cli_assert_holds(program->error, "\"Mass 7\"");
    cli_assert_holds(program->error, "did you mean \"width\"");
    cli_assert_holds(program->error, ": warning: ");

    g_autofree char *good = cli_write(fixture, "good.json", OSCILLATOR);
    g_autoptr(TestProgram) clean = cli_run_well(fixture, "check @good.json");
    g_assert_cmpstr(clean->output, ==, "no mistakes found\n");
    g_assert_cmpstr(clean->error, ==, "");
}

static void test_check_of_model(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *loose = cli_write(fixture, "loose.json",
                                       "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"},"
                                       "{\"type\": \"spring\", \"ends\": [[0, 1], [1, 2]]},"
                                       "{\"type\": \"rod\", \"ends\": [\"Mass 0\", [1, 2]]}]}");
    g_autoptr(TestProgram) detached = cli_run_badly(fixture, "check @loose.json", 3);
    cli_assert_holds(detached->error, "Spring 0: end 1 of 2 is detached");
    cli_assert_holds(detached->error, "Spring 0: end 2 of 2 is detached");
    cli_assert_holds(detached->error, "Rod 0: end 2 of 2 is detached");

    g_autofree char *long_rod =
        cli_write(fixture, "rod.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"support\","
                  "\"position\": [1, 0]}, {\"type\": \"rod\", \"ends\": [\"Mass 0\", \"Support 0\"],"
                  "\"length\": 2}]}");
    g_autoptr(TestProgram) misfit = cli_run_badly(fixture, "check @rod.json", 3);
    cli_assert_holds(misfit->error, "Rod 0");

    g_autofree char *pulley = cli_write(fixture, "pulley.json",
                                        "{\"tinker\": 1, \"blocks\": [{\"type\": \"pulley\"}, {\"type\": \"sprng\"}]}");
    g_autoptr(TestProgram) missing = cli_run_badly(fixture, "check @pulley.json", 4);
    cli_assert_holds(missing->error, "\"pulley\"");
    cli_assert_holds(missing->error, "did you mean \"spring\"");

    g_autofree char *method = cli_write(fixture, "method.json",
                                        "{\"tinker\": 1, \"run\": {\"method\": \"rk5\"},"
                                        "\"blocks\": [{\"type\": \"mass\"}]}");
    g_autoptr(TestProgram) unknown = cli_run_badly(fixture, "check @method.json", 3);
    cli_assert_holds(unknown->error, "did you mean \"rk4\"");
}

/* A verb that cannot go on tells where the rest is. */
static void test_further_findings(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *bad = cli_write(fixture, "bad.json",
                                     "{\"tinker\": 1, \"Blocks\": [], \"blocks\": ["
                                     "{\"type\": \"mass\", \"mass\": -1}]}");
    g_autoptr(TestProgram) unread = cli_run_badly(fixture, "run @bad.json", 3);
    cli_assert_holds(unread->error, "bad.json\" lists all 2 findings\n");

    g_autofree char *lone =
        cli_write(fixture, "lone.json", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"mass\": -1}]}");
    g_autoptr(TestProgram) one = cli_run_badly(fixture, "run @lone.json", 3);
    g_assert_null(strstr(one->error, "findings"));

    g_autofree char *loose = cli_write(fixture, "loose.json",
                                       "{\"tinker\": 1, \"Blocks\": [], \"blocks\": ["
                                       "{\"type\": \"spring\", \"ends\": [[0, 1], [1, 2]]}]}");
    g_autoptr(TestProgram) refused = cli_run_badly(fixture, "graph @loose.json 'Spring 0.tension' -o -", 3);
    cli_assert_holds(refused->error, "unknown key \"Blocks\"");
    cli_assert_holds(refused->error, "loose.json\" lists all 3 findings\n");
    g_autoptr(TestProgram) check = cli_run_badly(fixture, "check @loose.json", 3);
    g_auto(GStrv) lines = g_strsplit(check->error, "\n", -1);
    g_assert_cmpuint(g_strv_length(lines), ==, 3 + 1);
}

static void test_convert(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) normal = cli_run_well(fixture, "convert @a.json --units SI -o @si.json");
    g_autoptr(TestProgram) english = cli_run_well(fixture, "convert @si.json --units English -o @english.json");
    g_autoptr(TestProgram) back = cli_run_well(fixture, "convert @english.json --units SI -o -");
    g_autofree char *first = cli_read(fixture, "si.json");
    g_autofree char *middle = cli_read(fixture, "english.json");
    g_assert_cmpstr(back->output, ==, first);
    cli_assert_holds(middle, " ft\"");
    cli_assert_holds(middle, " lbf/ft\"");
    g_autoptr(TestProgram) nowhere = cli_run_badly(fixture, "convert @a.json -o @none/b.json", 5);
    g_autoptr(TestProgram) metric = cli_run_badly(fixture, "convert @a.json --units metric", 2);
}

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

static void assert_begins(const CliFixture *fixture, const char *name, const char *magic)
{
    g_autofree char *path = cli_path(fixture, name);
    g_autofree char *bytes = NULL;
    gsize length = 0;
    g_assert_true(g_file_get_contents(path, &bytes, &length, NULL));
    g_assert_cmpuint(length, >, strlen(magic));
    g_assert_cmpmem(bytes, strlen(magic), magic, strlen(magic));
}

#define PNG_MAGIC "\x89PNG\r\n\x1a\n"

/* Width and height stand big-endian at bytes 16 and 20. */
static void assert_png_size(const CliFixture *fixture, const char *name, guint width, guint height)
{
    assert_begins(fixture, name, PNG_MAGIC);
    g_autofree char *path = cli_path(fixture, name);
    g_autofree char *bytes = NULL;
    gsize length = 0;
    g_assert_true(g_file_get_contents(path, &bytes, &length, NULL));
    g_assert_cmpuint(length, >, 24);
    guint32 sides[2];
    memcpy(sides, bytes + 16, sizeof sides);
    g_assert_cmpuint(GUINT32_FROM_BE(sides[0]), ==, width);
    g_assert_cmpuint(GUINT32_FROM_BE(sides[1]), ==, height);
}

static void test_pictures(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    static const char *const endings[] = {"png", "svg", "pdf"};
    static const char *const magics[] = {PNG_MAGIC, "<?xml", "%PDF-"};
    for (gsize i = 0; i < G_N_ELEMENTS(endings); i++) {
        g_autofree char *graph = g_strdup_printf("graph @a.json 'Mass 0.x' -o @graph.%s", endings[i]);
        g_autofree char *render =
            g_strdup_printf("render @a.json -o @scene.%s --time 0.3 --theme dark --no-labels", endings[i]);
        g_autofree char *graph_file = g_strdup_printf("graph.%s", endings[i]);
        g_autofree char *scene_file = g_strdup_printf("scene.%s", endings[i]);
        g_autoptr(TestProgram) drawn = cli_run_well(fixture, graph);
        g_autoptr(TestProgram) rendered = cli_run_well(fixture, render);
        assert_begins(fixture, graph_file, magics[i]);
        assert_begins(fixture, scene_file, magics[i]);
    }
    g_autoptr(TestProgram) small = cli_run_well(fixture, "render @a.json -o @small.png --size 321x123");
    assert_png_size(fixture, "small.png", 321, 123);
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

static void test_animate(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) pictures =
        cli_run_well(fixture, "animate @a.json -o @film.png --fps 10 --duration 0.3 --size 160x120");
    for (int i = 1; i <= 4; i++) {
        g_autofree char *name = g_strdup_printf("film-%04d.png", i);
        assert_png_size(fixture, name, 160, 120);
    }
    g_autofree char *fifth = cli_path(fixture, "film-0005.png");
    g_assert_false(g_file_test(fifth, G_FILE_TEST_EXISTS));

    g_autoptr(TestProgram) film =
        cli_run_well(fixture, "animate @a.json -o @film.gif --fps 10 --duration 0.3 --size 160x120");
    assert_begins(fixture, "film.gif", "GIF89a");
}

/* Below the motion of a mass on a spring its height over time: in each picture more than without, in the second it
 * differs from the first; a scene without graphs has the film that it has without asking for them. */
static void test_animate_graphs(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *bare = cli_write(fixture, "a.json", OSCILLATOR);
    g_autofree char *members = g_strndup(OSCILLATOR, strlen(OSCILLATOR) - 2);
    g_autofree char *text = g_strconcat(members, ", \"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"x\"}]}", NULL);
    g_autofree char *graphed = cli_write(fixture, "b.json", text);
    static const char *const films[] = {"a", "b"};
    g_autoptr(TestProgram) without = cli_run_well(fixture, "animate @b.json -o @c.png --fps 10 --duration 0.3");
    g_autofree char *plain = cli_read(fixture, "c-0001.png");
    for (gsize i = 0; i < G_N_ELEMENTS(films); i++) {
        g_autofree char *words =
            g_strdup_printf("animate @%s.json --graphs -o @%s.png --fps 10 --duration 0.3", films[i], films[i]);
        g_autoptr(TestProgram) film = cli_run_well(fixture, words);
        g_autofree char *first = g_strconcat(films[i], "-0001.png", NULL);
        assert_png_size(fixture, first, 640, 480);
    }
    gsize a_length = 0, b_length = 0, c_length = 0;
    g_autofree char *a = cli_path(fixture, "a-0001.png"), *b = cli_path(fixture, "b-0001.png"),
                    *c = cli_path(fixture, "c-0001.png"), *as = NULL, *bs = NULL, *cs = NULL;
    g_assert_true(g_file_get_contents(a, &as, &a_length, NULL) && g_file_get_contents(b, &bs, &b_length, NULL) &&
                  g_file_get_contents(c, &cs, &c_length, NULL));
    g_assert_cmpmem(as, a_length, cs, c_length);
    g_assert_cmpuint(b_length, >, c_length + 1000); /* axes, numbers and a curve */
}

/* A film that cannot be joined is an error, told before anything is run, with what to install; nothing is written. Who
 * asks for the pictures gets them, whatever the output is called and is installed. */
static void test_animate_without_ffmpeg(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autofree char *first = cli_path(fixture, "film-0001.png"), *film = cli_path(fixture, "film.gif");
    g_autofree char *programs = g_strdup(g_getenv("PATH"));
    static const char *const names[] = {"film.gif", "film.webm", "film.mp4"};
    g_setenv("PATH", fixture->folder, TRUE);
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        g_autofree char *words = g_strdup_printf("animate @a.json -o @%s --fps 10 --duration 0.3", names[i]);
        g_autoptr(TestProgram) refused = cli_run_badly(fixture, words, 5);
        cli_assert_holds(refused->error, names[i]);
        cli_assert_holds(refused->error, "(apt-get install ffmpeg; --frames writes numbered pictures instead)");
        g_assert_false(g_file_test(first, G_FILE_TEST_EXISTS));
    }
    g_autoptr(TestProgram) pictures =
        cli_run_well(fixture, "animate @a.json -o @film.gif --frames --fps 10 --duration 0.3 --size 160x120");
    g_setenv("PATH", programs, TRUE);
    cli_assert_holds(pictures->error, "wrote 4 pictures, ");
    for (int i = 1; i <= 4; i++) {
        g_autofree char *name = g_strdup_printf("film-%04d.png", i);
        assert_png_size(fixture, name, 160, 120);
    }
    g_assert_false(g_file_test(film, G_FILE_TEST_EXISTS));
}

/* Waits until the program takes a Ctrl-C as the wish to stop, which is where its run begins. */
static void wait_for_run(GPid process)
{
    g_autofree char *path = g_strdup_printf("/proc/%d/status", process);
    for (gboolean caught = FALSE; !caught; g_usleep(1000)) {
        g_autofree char *text = test_read_file(path);
        const char *line = strstr(text, "\nSigCgt:");
        g_assert_nonnull(line);
        caught = (g_ascii_strtoull(line + strlen("\nSigCgt:"), NULL, 16) >> (SIGINT - 1) & 1) != 0;
    }
}

/* What was run up to the Ctrl-C is drawn, all of it. */
static void test_animate_interrupted(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    const GPid process =
        cli_start(fixture, "animate @a.json -o @film.png --fps 100 --duration 900 --step 1e-6 --size 64x48");
    wait_for_run(process);
    g_usleep(G_USEC_PER_SEC / 4); // some hundred pictures' time
    g_assert_cmpint(cli_interrupt(process), ==, 1);
    assert_png_size(fixture, "film-0002.png", 64, 48);
}

static void test_plugins(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) list = cli_run_well(fixture, "plugins");
    static const char *const types[] = {"mass",           "support", "spring", "damper", "rod", "motor",
                                        "support-motion", "gravity", "wind",   "marker", "rope"};
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        g_autofree char *row = g_strdup_printf("\n%s ", types[i]);
        cli_assert_holds(list->output, row);
    }
    cli_assert_holds(list->output, "tinker-spring.so");
    g_autoptr(TestProgram) show = cli_run_well(fixture, "plugins show spring");
    static const char *const parts[] = {"Spring",    "stiffness", "N/m",      "lbf/ft", "rest_length",
                                        "as placed", "tension",   "line law", "MIT"};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        cli_assert_holds(show->output, parts[i]);
    g_autoptr(TestProgram) mass = cli_run_well(fixture, "plugins show mass");
    static const char *const mass_parts[] = {"\"on\": NAME", "\"along\"", "normal force", "friction force",
                                             "acceleration "};
    for (gsize i = 0; i < G_N_ELEMENTS(mass_parts); i++)
        cli_assert_holds(mass->output, mass_parts[i]);
    g_assert_null(strstr(show->output, "\"on\""));
    cli_assert_holds(list->output, "\nrk4 ");
    g_autoptr(TestProgram) method = cli_run_well(fixture, "plugins show rk4 spring");
    static const char *const method_parts[] = {
        "rk4", "fixed steps, explicit", "2.828", "2.785", "built in", "Kutta", "stiffness"};
    for (gsize i = 0; i < G_N_ELEMENTS(method_parts); i++)
        cli_assert_holds(method->output, method_parts[i]);
    g_autoptr(TestProgram) unknown = cli_run_badly(fixture, "plugins show sprng", 4);
    cli_assert_holds(unknown->error, "did you mean \"spring\"");
    g_autoptr(TestProgram) unknown_method = cli_run_badly(fixture, "plugins show dop583", 4);
    cli_assert_holds(unknown_method->error, "did you mean the method \"dop853\"");
    g_autoptr(TestProgram) verb = cli_run_badly(fixture, "plugins shwo spring", 2);
    cli_assert_holds(verb->error, "did you mean \"show\"");
    g_autoptr(TestProgram) refused = cli_run_well(fixture, "plugins refused --clear");
    cli_assert_holds(refused->output, "forgotten");
}

static void test_describe(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *library = g_build_filename(g_getenv("TINKER_TEST_PLUGINS"), "tinker-spring.so", NULL);
    g_autofree char *words = g_strdup_printf("plugins describe '%s' --output -", library);
    g_autoptr(TestProgram) program = cli_run_well(fixture, words);
    cJSON *manifest = cJSON_Parse(program->output);
    g_assert_nonnull(manifest);
    const cJSON *type = cJSON_GetArrayItem(cJSON_GetObjectItem(manifest, "types"), 0);
    g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(type, "id")), ==, "spring");
    cJSON_Delete(manifest);

    /* beside the library, with its ending exchanged */
    g_autofree char *copy = cli_path(fixture, "copy.so");
    g_autofree char *bytes = NULL;
    gsize length = 0;
    g_assert_true(g_file_get_contents(library, &bytes, &length, NULL));
    g_assert_true(g_file_set_contents(copy, bytes, (gssize)length, NULL));
    g_autoptr(TestProgram) beside = cli_run_well(fixture, "plugins describe @copy.so");
    g_autofree char *path = cli_path(fixture, "copy.manifest.json");
    cJSON_Delete(test_read_json(path));

    g_autofree char *text = cli_write(fixture, "text.so", "not a library");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "plugins describe @text.so", 4);
}

static void test_bench(CliFixture *fixture, gconstpointer data)
{
    static const char *const keys[] = {
        "method", "step", "ns_per_step", "evaluations_per_step", "ns_per_evaluation", "blocks", "steps_timed"};
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program =
        cli_run_well(fixture, "bench @a.json --method rk4 --step 0.002 --seconds 0.02 --json -");
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++)
        if (!cJSON_HasObjectItem(root, keys[i])) g_error("no key %s", keys[i]);
    g_assert_cmpint(cJSON_GetArraySize(root), ==, G_N_ELEMENTS(keys));
    /* the classical method has four stages */
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "evaluations_per_step")), ==, 4);
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "step")), ==, 0.002);
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "blocks")), ==, 3);
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "ns_per_step")), >, 0);
    cJSON_Delete(root);
    g_autoptr(TestProgram) table = cli_run_well(fixture, "bench @a.json --seconds 0.02");
    cli_assert_holds(table->output, "\nverlet ");
    cli_assert_holds(table->output, "\nrk4 ");
    g_autoptr(TestProgram) unknown = cli_run_badly(fixture, "bench @a.json --method rk5", 2);
}

static void test_demo(CliFixture *fixture, gconstpointer data)
{
    g_autoptr(TestProgram) program = cli_run_well(fixture, "demo --output-folder @demo");
    assert_begins(fixture, "demo/spring-mass.csv", "time [s],");
    assert_begins(fixture, "demo/spring-mass-graph.svg", "<?xml");
    assert_png_size(fixture, "demo/spring-mass-graph.png", 800, 500);
    assert_png_size(fixture, "demo/spring-mass.png", 800, 600);
    g_auto(GStrv) lines = g_strsplit(g_strchomp(program->output), "\n", -1);
    g_assert_cmpuint(g_strv_length(lines), ==, 4);
    /* it swings 9.81 / 25 m about its rest: lowest point 2 - 2 * 0.3924, after half of 2 pi / 5 s */
    g_autofree char *csv = cli_read(fixture, "demo/spring-mass.csv");
    g_autoptr(TestTable) table = test_table_new(csv);
    double lowest = 2;
    for (gsize row = 0; row < table->rows; row++)
        lowest = MIN(lowest, test_table_value(table, row, "Mass 0.y"));
    g_assert_cmpfloat_with_epsilon(lowest, 2 - 2 * 9.81 / 25, 1e-4);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/verbs/help", test_help);
    cli_test_add("/verbs/check", test_check);
    cli_test_add("/verbs/check-of-model", test_check_of_model);
    cli_test_add("/verbs/graphs-left-out", test_graphs_left_out);
    cli_test_add("/verbs/further-findings", test_further_findings);
    cli_test_add("/verbs/convert", test_convert);
    cli_test_add("/verbs/graph-of-thesis", test_graph_of_thesis);
    cli_test_add("/verbs/graph-forms", test_graph_forms);
    cli_test_add("/verbs/pictures", test_pictures);
    cli_test_add("/verbs/graph-without-band", test_graph_without_band);
    cli_test_add("/verbs/render-shows-time", test_render_shows_time);
    cli_test_add("/verbs/forces", test_forces);
    cli_test_add("/verbs/picture-mistakes", test_picture_mistakes);
    cli_test_add("/verbs/animate", test_animate);
    cli_test_add("/verbs/animate-graphs", test_animate_graphs);
    cli_test_add("/verbs/animate-without-ffmpeg", test_animate_without_ffmpeg);
    cli_test_add("/verbs/animate-interrupted", test_animate_interrupted);
    cli_test_add("/verbs/plugins", test_plugins);
    cli_test_add("/verbs/describe", test_describe);
    cli_test_add("/verbs/bench", test_bench);
    cli_test_add("/verbs/demo", test_demo);
    return g_test_run();
}
