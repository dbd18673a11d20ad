/* tinker animate: numbered pictures and films, with graphs, without ffmpeg and interrupted. */
#include <signal.h>
#include <string.h>

#include "fixture.h"

static void test_animate(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) pictures =
        cli_run_well(fixture, "animate @a.json -o @film.png --fps 10 --duration 0.3 --size 160x120");
    for (int i = 1; i <= 4; i++) {
        g_autofree char *name = g_strdup_printf("film-%04d.png", i);
        cli_assert_png_size(fixture, name, 160, 120);
    }
    g_autofree char *fifth = cli_path(fixture, "film-0005.png");
    g_assert_false(g_file_test(fifth, G_FILE_TEST_EXISTS));

    g_autoptr(TestProgram) film =
        cli_run_well(fixture, "animate @a.json -o @film.gif --fps 10 --duration 0.3 --size 160x120");
    cli_assert_begins(fixture, "film.gif", "GIF89a");
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
        cli_assert_png_size(fixture, first, 640, 480);
    }
    gsize a_length = 0, b_length = 0, c_length = 0;
    g_autofree char *a = cli_path(fixture, "a-0001.png"), *b = cli_path(fixture, "b-0001.png"),
                    *c = cli_path(fixture, "c-0001.png"), *as = NULL, *bs = NULL, *cs = NULL;
    g_assert_true(g_file_get_contents(a, &as, &a_length, NULL) && g_file_get_contents(b, &bs, &b_length, NULL) &&
                  g_file_get_contents(c, &cs, &c_length, NULL));
    g_assert_cmpmem(as, a_length, cs, c_length);
    g_assert_cmpuint(b_length, >, c_length + 1000); /* axes, numbers and a curve */
}

/* A graph without a title is called by its curves: it looks as one that has these words as its title, and otherwise
 * than one that has others. */
static void test_animate_graph_titles(CliFixture *fixture, gconstpointer data)
{
    static const char *const titles[] = {"", ", \"title\": \"Mass 0: X Position, X Velocity\"", ", \"title\": \"B\""};
    g_autofree char *members = g_strndup(OSCILLATOR, strlen(OSCILLATOR) - 2);
    gsize lengths[3];
    char *pictures[3];
    for (int i = 0; i < 3; i++) {
        g_autofree char *name = g_strdup_printf("%d.json", i), *first = g_strdup_printf("%d-0001.png", i);
        g_autofree char *text = g_strdup_printf("%s, \"graphs\": [{\"curves\": [{\"block\": \"Mass 0\", \"quantity\": "
                                                "\"x\"}, {\"block\": \"Mass 0\", \"quantity\": \"vx\"}]%s}]}",
                                                members, titles[i]);
        g_autofree char *scene = cli_write(fixture, name, text);
        g_autofree char *words = g_strdup_printf("animate @%d.json --graphs -o @%d.png --fps 10 --duration 0.3", i, i);
        g_autoptr(TestProgram) film = cli_run_well(fixture, words);
        g_autofree char *path = cli_path(fixture, first);
        g_assert_true(g_file_get_contents(path, &pictures[i], &lengths[i], NULL));
    }
    g_assert_cmpmem(pictures[0], lengths[0], pictures[1], lengths[1]);
    g_assert_cmpuint(lengths[2], !=, lengths[0]);
    for (int i = 0; i < 3; i++)
        g_free(pictures[i]);
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
        cli_assert_png_size(fixture, name, 160, 120);
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
    cli_assert_png_size(fixture, "film-0002.png", 64, 48);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/verbs/animate", test_animate);
    cli_test_add("/verbs/animate-graphs", test_animate_graphs);
    cli_test_add("/verbs/animate-graph-titles", test_animate_graph_titles);
    cli_test_add("/verbs/animate-without-ffmpeg", test_animate_without_ffmpeg);
    cli_test_add("/verbs/animate-interrupted", test_animate_interrupted);
    return g_test_run();
}
