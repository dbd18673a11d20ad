/* Pictures of motion by their pixels: a mass that falls freely from rest is known at every instant, v = g t, a = g, and
 * by what it has fallen, g t^2 / 2. Its arrows and its path stand upright, in the one column that has most of their
 * colour. */
#include <cairo.h>
#include <math.h>
#include <string.h>

#include "fixture.h"
#include "render/draw/theme.h"
#include "render/picture/arrows.h"

#define GRAVITY 9.81
#define NEAR    0.06
#define KEY     150 /* pixels: the key is left of it */

static const TinkerTheme *theme(void)
{
    return tinker_theme_find("light");
}

static const double *motion_colour(void)
{
    return tinker_arrow_colour(theme(), TINKER_ARROW_MOTION);
}

static gboolean shows(cairo_surface_t *surface, int x, int y, const double colour[4])
{
    const unsigned char *row =
        cairo_image_surface_get_data(surface) + (gsize)y * (gsize)cairo_image_surface_get_stride(surface);
    guint32 pixel;
    memcpy(&pixel, row + 4 * (gsize)x, sizeof(pixel));
    return fabs(((pixel >> 16) & 255) / 255.0 - colour[0]) < NEAR &&
           fabs(((pixel >> 8) & 255) / 255.0 - colour[1]) < NEAR && fabs((pixel & 255) / 255.0 - colour[2]) < NEAR;
}

static cairo_surface_t *draw(CliFixture *fixture, const char *options)
{
    g_autofree char *words = g_strdup_printf("render @a.json -o @a.png --no-grid --no-labels %s", options);
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) drawn = cli_run_well(fixture, words);
    g_autofree char *path = cli_path(fixture, "a.png");
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    g_assert_cmpint(cairo_surface_status(surface), ==, CAIRO_STATUS_SUCCESS);
    return surface;
}

/* How many pixels of a column have the colour, and the first and last of them. */
static int count_column(cairo_surface_t *surface, int x, const double colour[4], int ends[2])
{
    int count = 0;
    ends[0] = ends[1] = 0;
    for (int y = 0; y < cairo_image_surface_get_height(surface); y++) {
        if (!shows(surface, x, y, colour)) continue;
        if (count++ == 0) ends[0] = y;
        ends[1] = y;
    }
    return count;
}

static int find_column(cairo_surface_t *surface, const double colour[4])
{
    int best = KEY, most = 0, ends[2];
    for (int x = KEY; x < cairo_image_surface_get_width(surface); x++) {
        const int count = count_column(surface, x, colour, ends);
        if (count > most) best = x;
        most = MAX(most, count);
    }
    return best;
}

/* How long the upright arrow of this colour is; 0: there is none. */
static int arrow_length(CliFixture *fixture, const char *options, TinkerArrowKind kind)
{
    cairo_surface_t *surface = draw(fixture, options);
    const double *colour = tinker_arrow_colour(theme(), kind);
    int ends[2];
    const int count = count_column(surface, find_column(surface, colour), colour, ends);
    cairo_surface_destroy(surface);
    return count > 0 ? ends[1] - ends[0] + 1 : 0;
}

static gboolean key_shows(CliFixture *fixture, const char *options, TinkerArrowKind kind)
{
    cairo_surface_t *surface = draw(fixture, options);
    int count = 0;
    for (int y = 300; y < cairo_image_surface_get_height(surface); y++)
        for (int x = 0; x < KEY; x++)
            count += shows(surface, x, y, tinker_arrow_colour(theme(), kind));
    cairo_surface_destroy(surface);
    return count > 20;
}

/* One scale for the run: half the time, half the speed, half the arrow. What does not change has one length. */
static void test_vectors(CliFixture *fixture, gconstpointer data)
{
    const int whole = arrow_length(fixture, "--velocity --time 1", TINKER_ARROW_MOTION);
    g_assert_cmpint(whole, >, 40);
    g_assert_cmpint(ABS(2 * arrow_length(fixture, "--velocity --time 0.5", TINKER_ARROW_MOTION) - whole), <=, 3);
    g_assert_cmpint(arrow_length(fixture, "--velocity --time 0", TINKER_ARROW_MOTION), ==, 0);
    const int fall = arrow_length(fixture, "--acceleration --time 1", TINKER_ARROW_ACCELERATION);
    g_assert_cmpint(fall, >, 40);
    g_assert_cmpint(arrow_length(fixture, "--acceleration --time 0", TINKER_ARROW_ACCELERATION), ==, fall);
    /* the one force there is, and the sum of all */
    const int weight = arrow_length(fixture, "--forces --time 0.7", TINKER_ARROW_FIELD);
    g_assert_cmpint(weight, >, 40);
    g_assert_cmpint(ABS(arrow_length(fixture, "--net-force --time 0.7", TINKER_ARROW_NET) - weight), <=, 2);
    g_assert_true(key_shows(fixture, "--velocity --time 1", TINKER_ARROW_MOTION));
    g_assert_false(key_shows(fixture, "--velocity --time 1", TINKER_ARROW_ACCELERATION));
    g_assert_true(key_shows(fixture, "--acceleration --time 1", TINKER_ARROW_ACCELERATION));
}

/* A force that is a hundred times that of the start is seen whole, in a scale of its own. */
static void test_grown_force(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "grown.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"mass\": 1000}, {\"type\": \"motor\", \"ends\": "
                  "[\"Mass 0\"], \"waveform\": {\"expression\": \"1 + 99*t\"}, \"angle\": \"90 deg\"}]}");
    g_autoptr(TestProgram) program =
        cli_run_well(fixture, "render @grown.json -o @grown.png --no-grid --no-labels --forces --time 1");
    g_autofree char *path = cli_path(fixture, "grown.png");
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    const double *colour = tinker_arrow_colour(theme(), TINKER_ARROW_APPLIED);
    int ends[2];
    g_assert_cmpint(count_column(surface, find_column(surface, colour), colour, ends), >, 30);
    g_assert_cmpint(ends[1] - ends[0], <, cairo_image_surface_get_height(surface) / 2);
    cairo_surface_destroy(surface);
}

/* Where marks are, from top to bottom: beside the path, which is thinner than they are. */
static int find_marks(cairo_surface_t *surface, int middle, double places[], int most)
{
    const double *colour = motion_colour();
    int count = 0, run = 0;
    for (int y = 0; y < cairo_image_surface_get_height(surface); y++) {
        const gboolean on = shows(surface, middle - 2, y, colour) || shows(surface, middle + 2, y, colour);
        run = on ? run + 1 : 0;
        if (run == 1 && count < most) places[count] = y;
        if (run == 1) count++;
    }
    return count;
}

/* At equal times a falling mass is at 0, 1, 4, 9, 16 and 25 parts of its way, and is seen there: the edge of its box,
 * whose side is 0.8 m, stands 0.4 m beside the mark. */
static void test_trail(CliFixture *fixture, gconstpointer data)
{
    double places[8] = {0};
    cairo_surface_t *surface = draw(fixture, "--trail --marks 0.2");
    const int middle = find_column(surface, motion_colour());
    const int count = find_marks(surface, middle, places, G_N_ELEMENTS(places));
    const double part = (places[5] - places[0]) / 25;
    const int half = (int)(0.4 * 25 * part / (GRAVITY / 2)), third = (int)places[3];
    int edge = 0;
    g_assert_cmpint(count, ==, 6);
    for (int k = 0; k < count; k++)
        g_assert_cmpfloat(fabs(places[k] - places[0] - part * k * k), <, 1.5);
    for (int x = middle + half - 3; x <= middle + half + 3; x++)
        edge += !shows(surface, x, third, theme()->background);
    g_assert_cmpint(edge, >, 0);
    g_assert_true(shows(surface, middle + half + 8, third, theme()->background));
    cairo_surface_destroy(surface);
    surface = draw(fixture, "--time 1");
    g_assert_cmpint(find_marks(surface, middle, places, G_N_ELEMENTS(places)), ==, 0);
    cairo_surface_destroy(surface);
}

/* A trail ends where the run does: after a fall of 2.2 m, at 0.67 s of 1 s. */
static void test_trail_until(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *until = g_strdup(FREE_FALL);
    char **parts = g_strsplit(until, "\"duration\": 1,", 2);
    g_autofree char *text = g_strjoinv("\"duration\": 1, \"until\": \"{Mass 0.y} = -2.2\",", parts);
    g_strfreev(parts);
    g_autofree char *scene = cli_write(fixture, "b.json", text);
    g_autoptr(TestProgram) drawn =
        cli_run_well(fixture, "render @b.json -o @b.png --no-grid --no-labels --trail --marks 0.2");
    g_autofree char *path = cli_path(fixture, "b.png");
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    double places[8] = {0};
    g_assert_cmpint(find_marks(surface, find_column(surface, motion_colour()), places, G_N_ELEMENTS(places)), ==, 4);
    cairo_surface_destroy(surface);
}

/* The picture of a film of 1 s at this tenth; a view of a fall is that of all pictures. */
static cairo_surface_t *film_picture(CliFixture *fixture, const char *options, int tenth)
{
    g_autofree char *words =
        g_strdup_printf("animate @a.json -o @f.png --no-grid --no-labels --duration 1 --fps 10 %s", options);
    g_autofree char *name = g_strdup_printf("f-%04d.png", tenth + 1), *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) drawn = cli_run_well(fixture, words);
    g_autofree char *path = cli_path(fixture, name);
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    g_assert_cmpint(cairo_surface_status(surface), ==, CAIRO_STATUS_SUCCESS);
    return surface;
}

static int film_arrow(CliFixture *fixture, const char *options, TinkerArrowKind kind, int tenth)
{
    cairo_surface_t *surface = film_picture(fixture, options, tenth);
    const double *colour = tinker_arrow_colour(theme(), kind);
    int ends[2];
    const int count = count_column(surface, find_column(surface, colour), colour, ends);
    cairo_surface_destroy(surface);
    return count > 0 ? ends[1] - ends[0] + 1 : 0;
}

/* One scale for a film: v = g t goes with the time, a = g and the one force there is stay as long as they are. */
static void test_film_vectors(CliFixture *fixture, gconstpointer data)
{
    const int whole = film_arrow(fixture, "--velocity", TINKER_ARROW_MOTION, 10);
    g_assert_cmpint(whole, >, 30);
    g_assert_cmpint(ABS(2 * film_arrow(fixture, "--velocity", TINKER_ARROW_MOTION, 5) - whole), <=, 3);
    g_assert_cmpint(film_arrow(fixture, "--velocity", TINKER_ARROW_MOTION, 0), ==, 0);
    const int fall = film_arrow(fixture, "--acceleration", TINKER_ARROW_ACCELERATION, 2);
    g_assert_cmpint(fall, >, 30);
    g_assert_cmpint(film_arrow(fixture, "--acceleration", TINKER_ARROW_ACCELERATION, 9), ==, fall);
    const int net = film_arrow(fixture, "--net-force", TINKER_ARROW_NET, 1);
    g_assert_cmpint(net, >, 30);
    g_assert_cmpint(film_arrow(fixture, "--net-force", TINKER_ARROW_NET, 8), ==, net);
    g_assert_cmpint(film_arrow(fixture, "", TINKER_ARROW_MOTION, 10), ==, 0);
}

/* Paths grow with the film, and their marks, at 0, 0.3, 0.6 and 0.9 s, lie between the pictures' times, too: a picture
 * every 0.25 s has them at 0, 1, 4 and 9 parts of the way none the less. */
static void test_film_trail(CliFixture *fixture, gconstpointer data)
{
    double places[8] = {0};
    cairo_surface_t *surface = film_picture(fixture, "--trail --marks 0.3 --fps 4", 4);
    const int middle = find_column(surface, motion_colour());
    g_assert_cmpint(find_marks(surface, middle, places, G_N_ELEMENTS(places)), ==, 4);
    for (int k = 0; k < 4; k++)
        g_assert_cmpfloat(fabs(places[k] - places[0] - (places[3] - places[0]) / 9 * k * k), <, 1.5);
    cairo_surface_destroy(surface);
    surface = film_picture(fixture, "--trail --marks 0.3 --fps 4", 2);
    g_assert_cmpint(find_marks(surface, middle, places, G_N_ELEMENTS(places)), ==, 2);
    cairo_surface_destroy(surface);
}

static void test_mistakes(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) alone = cli_run_badly(fixture, "render @a.json -o @a.png --marks 0.1", 2);
    cli_assert_holds(alone->error, "add --trail");
    g_autoptr(TestProgram) many = cli_run_badly(fixture, "render @a.json -o @a.png --trail --marks 1e-9", 2);
    cli_assert_holds(many->error, "choose a time of 0.001 s or more");
    g_autoptr(TestProgram) none = cli_run_badly(fixture, "render @a.json -o @a.png --trail --marks 0", 2);
    cli_assert_holds(none->error, "--marks");
    g_autoptr(TestProgram) film = cli_run_badly(fixture, "animate @a.json -o @a.png --marks 0.1", 2);
    cli_assert_holds(film->error, "add --trail");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/motion-pictures/vectors", test_vectors);
    cli_test_add("/cli/motion-pictures/grown-force", test_grown_force);
    cli_test_add("/cli/motion-pictures/trail", test_trail);
    cli_test_add("/cli/motion-pictures/trail-until", test_trail_until);
    cli_test_add("/cli/motion-pictures/film-vectors", test_film_vectors);
    cli_test_add("/cli/motion-pictures/film-trail", test_film_trail);
    cli_test_add("/cli/motion-pictures/mistakes", test_mistakes);
    return g_test_run();
}
