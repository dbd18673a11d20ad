/* What tinker diagram draws: colours of arrows where forces are, and words that nothing crosses. */
#include <cairo.h>
#include <math.h>
#include <string.h>

#include "common/diagram/diagram-scale.h"
#include "fixture.h"
#include "render/picture/arrows.h"

#define SCENE(blocks)                                                                                                  \
    "{\"tinker\": 1, \"run\": {\"duration\": 4, \"tolerance\": 1e-12}, \"blocks\": ["                                  \
    "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10}," blocks "]}"

/* 2 kg from (1, 0) with (4, 3) m/s. */
#define THROWN                                                                                                         \
    SCENE("{\"type\": \"mass\", \"name\": \"Ball\", \"mass\": 2, \"position\": [1, 0], \"velocity\": [4, 3]}")

/* Level, at rest: the rod does not pull, and the bob falls. */
#define PENDULUM                                                                                                       \
    SCENE("{\"type\": \"support\", \"name\": \"Pivot\", \"solid\": false},"                                            \
          "{\"type\": \"mass\", \"name\": \"Bob\", \"mass\": 0.5, \"position\": [2, 0]},"                              \
          "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"Pivot\", \"Bob\"]}")

/* Whether a picture has pixels of this colour, and the middle of their places. */
static gboolean find_colour(cairo_surface_t *surface, const double colour[4], double middle[2])
{
    const int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    const unsigned char *data = cairo_image_surface_get_data(surface);
    int count = 0;
    middle[0] = middle[1] = 0;
    for (int y = 0; y < height * 4 / 5; y++) /* the list beneath has the colours, too */
        for (int x = 0; x < width; x++) {
            const unsigned char *pixel = data + y * stride + 4 * x;
            gboolean near = TRUE;
            for (int k = 0; k < 3; k++)
                near = near && fabs(pixel[2 - k] - 255 * colour[k]) < 2;
            if (!near) continue;
            middle[0] += x;
            middle[1] += y;
            count++;
        }
    for (int axis = 0; axis < 2; axis++)
        middle[axis] /= MAX(count, 1);
    return count > 20;
}

static cairo_surface_t *draw_diagram(CliFixture *fixture, const char *time, const char *size)
{
    g_autofree char *words =
        g_strdup_printf("diagram @scene.json --block Bob --time %s --size %s -o @d.png", time, size);
    g_autoptr(TestProgram) drawn = cli_run_well(fixture, words);
    g_autofree char *path = g_build_filename(fixture->folder, "d.png", NULL);
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    g_assert_cmpint(cairo_surface_status(surface), ==, CAIRO_STATUS_SUCCESS);
    return surface;
}

/* The bob begins to fall freely: the rod gives nothing yet, and no arrow of it is drawn; m a is as long as its weight,
 * and beside it. Later the rod pulls to the left and up, where the pivot is. */
static void test_picture(CliFixture *fixture, gconstpointer data)
{
    const TinkerTheme *theme = tinker_theme_find("light");
    const double *rod = tinker_arrow_colour(theme, TINKER_ARROW_CONSTRAINT);
    const double *weight = tinker_arrow_colour(theme, TINKER_ARROW_FIELD);
    const double *result = tinker_arrow_colour(theme, TINKER_ARROW_MOTION);
    double at[2], of_weight[2], of_result[2];
    g_autofree char *path = cli_write(fixture, "scene.json", PENDULUM);
    cairo_surface_t *start = draw_diagram(fixture, "0", "900x620");
    g_assert_false(find_colour(start, rod, at));
    g_assert_true(find_colour(start, weight, of_weight));
    g_assert_true(find_colour(start, result, of_result));
    g_assert_cmpfloat(fabs(of_weight[1] - of_result[1]), <, 12); /* the bars beside their labels stand apart a little */
    g_assert_cmpfloat(of_weight[0] + 100, <, of_result[0]);
    cairo_surface_destroy(start);
    cairo_surface_t *later = draw_diagram(fixture, "0.5", "900x620");
    g_assert_true(find_colour(later, rod, at));
    g_assert_true(find_colour(later, weight, of_weight));
    g_assert_cmpfloat(at[0], <, of_weight[0]);
    g_assert_cmpfloat(at[1], <, of_weight[1]);
    cairo_surface_destroy(later);
}

/* In little room, titles and names are shorter and columns fewer: nothing is cut by the paper's edge. */
static void test_small_picture(CliFixture *fixture, gconstpointer data)
{
    static const char *const sizes[] = {"200x180", "260x220", "340x260"};
    g_autofree char *path = cli_write(fixture, "scene.json", PENDULUM);
    for (gsize i = 0; i < G_N_ELEMENTS(sizes); i++) {
        cairo_surface_t *picture = draw_diagram(fixture, "0.5", sizes[i]);
        const int width = cairo_image_surface_get_width(picture), height = cairo_image_surface_get_height(picture);
        const int stride = cairo_image_surface_get_stride(picture);
        const unsigned char *pixels = cairo_image_surface_get_data(picture);
        for (int y = 0; y < height; y++) {
            const guint32 *row = (const guint32 *)(gconstpointer)(pixels + y * stride);
            g_assert_cmphex(row[0], ==, ((const guint32 *)(gconstpointer)pixels)[0]);
            g_assert_cmphex(row[width - 1], ==, row[0]);
        }
        cairo_surface_destroy(picture);
    }
}

/* As wide as in the window, long names are told from one another wherever they differ: none is cut. */
static void test_long_names(CliFixture *fixture, gconstpointer data)
{
    static const char *const names[] = {"Soft spring from the ceiling", "Soft spRING FRom the ceiling",
                                        "Soft spring from the CEILINg"};
    static const char *const verbs[] = {"diagram --block Bob --time 0.5", "books --block Bob --to 0.5"};
    for (gsize verb = 0; verb < G_N_ELEMENTS(verbs); verb++) {
        g_autofree char *words = g_strdup_printf("%s @scene.json --size 416x700 -o @d.png", verbs[verb]), *first = NULL;
        gsize first_length = 0;
        for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
            g_autofree char *scene =
                g_strdup_printf(SCENE("{\"type\": \"support\", \"name\": \"Pivot\", \"solid\": false},"
                                      "{\"type\": \"mass\", \"name\": \"Bob\", \"position\": [2, 0]},"
                                      "{\"type\": \"spring\", \"name\": \"%s\", \"ends\": [\"Pivot\", \"Bob\"]}"),
                                names[i]);
            g_autofree char *path = cli_write(fixture, "scene.json", scene), *content = NULL;
            g_autoptr(TestProgram) drawn = cli_run_well(fixture, words);
            g_autofree char *file = g_build_filename(fixture->folder, "d.png", NULL);
            gsize length;
            g_assert_true(g_file_get_contents(file, &content, &length, NULL));
            if (i > 0 && length == first_length && memcmp(content, first, length) == 0)
                g_error("%s: \"%s\" looks as \"%s\" does", verbs[verb], names[i], names[0]);
            if (i > 0) continue;
            first = g_steal_pointer(&content);
            first_length = length;
        }
    }
}

static gsize differences_above_list(cairo_surface_t *one, cairo_surface_t *other)
{
    const gsize size = (gsize)cairo_image_surface_get_stride(one) * 620;
    const unsigned char *left = cairo_image_surface_get_data(one), *right = cairo_image_surface_get_data(other);
    gsize differences = 0;
    for (gsize i = 0; i < size * 2 / 3; i++)
        differences += left[i] != right[i];
    return differences;
}

/* What only turns a body is drawn: the other way round it is another arrow, and more of it another number there. */
static void test_torque_picture(CliFixture *fixture, gconstpointer data)
{
    static const int amplitudes[] = {2, -2, 3};
    cairo_surface_t *pictures[G_N_ELEMENTS(amplitudes)];
    for (gsize i = 0; i < G_N_ELEMENTS(amplitudes); i++) {
        g_autofree char *torque = g_strdup_printf(
            SCENE("{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Bob\"},"
                  "{\"type\": \"torque\", \"name\": \"Torque\", \"ends\": [\"Bob\"], \"amplitude\": %d}"),
            amplitudes[i]);
        g_autofree char *path = cli_write(fixture, "scene.json", torque);
        pictures[i] = draw_diagram(fixture, "0", "900x620");
        g_assert_cmpint(cairo_image_surface_get_height(pictures[i]), ==, 620);
    }
    g_assert_cmpuint(differences_above_list(pictures[0], pictures[1]), >, 100);
    g_assert_cmpuint(differences_above_list(pictures[0], pictures[2]), >, 20);
    for (gsize i = 0; i < G_N_ELEMENTS(amplitudes); i++)
        cairo_surface_destroy(pictures[i]);
}

/* Beside a torque's arrow its name is cut, never its value: 21.63 N m is not 41.63. */
static void test_torque_value(CliFixture *fixture, gconstpointer data)
{
    static const char *const amplitudes[] = {"21.63", "41.63"};
    cairo_surface_t *pictures[G_N_ELEMENTS(amplitudes)];
    gsize differences = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(amplitudes); i++) {
        g_autofree char *torque = g_strdup_printf(
            SCENE("{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Bob\"}, {\"type\": \"torque\", \"name\": "
                  "\"Torque of the second motor\", \"ends\": [\"Bob\"], \"amplitude\": %s}"),
            amplitudes[i]);
        g_autofree char *path = cli_write(fixture, "scene.json", torque);
        pictures[i] = draw_diagram(fixture, "0", "640x470");
    }
    const int stride = cairo_image_surface_get_stride(pictures[0]);
    const unsigned char *one = cairo_image_surface_get_data(pictures[0]),
                        *two = cairo_image_surface_get_data(pictures[1]);
    for (int y = 0; y < 300; y++) /* above the list, and left of the kinetic diagram */
        for (int x = 0; x < 4 * 320; x++)
            differences += one[y * stride + x] != two[y * stride + x];
    g_assert_cmpuint(differences, >, 20);
    for (gsize i = 0; i < G_N_ELEMENTS(amplitudes); i++)
        cairo_surface_destroy(pictures[i]);
}

/* Red, green and blue of a pixel are near these. */
static gboolean is_near(const guint8 *pixel, int red, int green, int blue)
{
    return ABS(pixel[2] - red) < 25 && ABS(pixel[1] - green) < 25 && ABS(pixel[0] - blue) < 25;
}

/* The label of the torque of a drive makes way for the arrow of a pin beside it: no pixel of a text touches one of an
 * arrow. */
static void test_torque_label_is_not_crossed(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *words = g_strdup_printf(
        "diagram '%s/quick-return.tinker.json' --block Crank --time 0.3 -o @crank.png", g_getenv("TINKER_SCENES"));
    g_autoptr(TestProgram) drawn = cli_run_well(fixture, words);
    g_autofree char *path = cli_path(fixture, "crank.png");
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    g_assert_cmpint(cairo_surface_status(surface), ==, CAIRO_STATUS_SUCCESS);
    const guint8 *pixels = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface), width = cairo_image_surface_get_width(surface);
    int arrows = 0, crossed = 0;
    for (int y = 1; y < 6 * cairo_image_surface_get_height(surface) / 10; y++) /* above the table */
        for (int x = 1; x < width - 1; x++) {
            if (!is_near(pixels + y * stride + 4 * x, 0xcc, 0x79, 0xa7)) continue;
            arrows++;
            for (int k = 0; k < 9; k++)
                crossed += is_near(pixels + (y + k / 3 - 1) * stride + 4 * (x + k % 3 - 1), 0x24, 0x24, 0x24);
        }
    g_assert_cmpint(arrows, >, 300);
    g_assert_cmpint(crossed, ==, 0);
    cairo_surface_destroy(surface);
}

/* How many lines of texts there are at the left of the right column of accounts. */
static int count_lines(CliFixture *fixture, const char *size)
{
    g_autofree char *words = g_strdup_printf("books @a.json --block Ball --to 0.5 -o @books.png --size %s", size);
    g_autoptr(TestProgram) drawn = cli_run_well(fixture, words);
    g_autofree char *path = cli_path(fixture, "books.png");
    cairo_surface_t *surface = cairo_image_surface_create_from_png(path);
    const guint8 *pixels = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface), half = cairo_image_surface_get_width(surface) / 2;
    int lines = 0;
    gboolean was_dark = FALSE;
    for (int y = 0; y < cairo_image_surface_get_height(surface); y++) {
        gboolean dark = FALSE;
        for (int x = half + 5; x < half + 50; x++) {
            const guint8 *pixel = pixels + y * stride + 4 * x;
            dark = dark || MAX(pixel[0], MAX(pixel[1], pixel[2])) < 120;
        }
        lines += dark && !was_dark;
        was_dark = dark;
    }
    cairo_surface_destroy(surface);
    return lines;
}

/* In a narrow picture the longest title of an account takes two lines, and nothing is cut off it. */
static void test_long_title(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", THROWN);
    const int wide = count_lines(fixture, "1000x720");
    g_assert_cmpint(wide, >, 6);
    g_assert_cmpint(count_lines(fixture, "640x720"), >, wide);
}

/* The mean height of what is written in a part of a picture. */
static double written_at(cairo_surface_t *surface, int left, int top, int right, int bottom)
{
    const guint8 *pixels = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    double sum = 0, count = 0;
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++)
            if (is_near(pixels + y * stride + 4 * x, 0x24, 0x24, 0x24)) {
                sum += y;
                count++;
            }
    g_assert_cmpfloat(count, >, 10);
    return sum / count;
}

/* That of a torque goes no farther than its length asks for: an arrow that ends behind a short one is not in its way
 * where a long one would stand. Beside the sign of equality is the middle. */
static void test_torque_label_is_measured(CliFixture *fixture, gconstpointer data)
{
    static const char scene[] =
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Bob\", \"radius\": 0.5}, "
        "{\"type\": \"torque\", "
        "\"name\": \"M\", \"ends\": [\"Bob\"], \"amplitude\": 3}, {\"type\": \"motor\", \"name\": \"F\", \"ends\": "
        "[{\"block\": \"Bob\", \"at\": [0.4, 0.4]}], \"angle\": \"-24 deg\", \"amplitude\": 10}]}";
    g_autofree char *path = cli_write(fixture, "scene.json", scene);
    cairo_surface_t *surface = draw_diagram(fixture, "0", "900x620");
    const double label = written_at(surface, 325, 240, 395, 340), middle = written_at(surface, 505, 240, 540, 340);
    g_assert_cmpfloat(label - middle, >, 5);
    g_assert_cmpfloat(label - middle, <, 20);
    cairo_surface_destroy(surface);
}

/* A picture's name never holds a text, nor a text's a picture. */
static void test_endings(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *words, *says;
    } cases[] = {
        {"diagram @scene.json --block Bob --as text -o @x.png", "would be a picture by its ending"},
        {"books @scene.json --as csv -o @x.svg", "would be a picture by its ending"},
        {"equations @scene.json -o @x.png", "equations are written as text"},
        {"diagram @scene.json --block Bob --theme dark", "--theme belongs to a picture"},
        {"diagram @scene.json --block Bob --kind kinetic", "--kind belongs to a picture"},
        {"diagram @scene.json --block Pivot --kind kinetic -o @x.svg", "cannot move"},
        {"books @scene.json --size 5x5 -o @x.csv", "--size belongs to a picture"},
    };
    static const struct {
        const char *words, *file, *begins;
    } pictures[] = {
        {"diagram @scene.json --block Pivot -o @p.svg", "p.svg", "<?xml"},
        {"diagram @scene.json --block Bob --kind kinetic --theme print -o @p.pdf", "p.pdf", "%PDF"},
        {"books @scene.json --to 0.5 --theme contrast-dark -o @p.png", "p.png", "\x89PNG"},
    };
    g_autofree char *path = cli_write(fixture, "scene.json", PENDULUM);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, cases[i].words, 2);
        cli_assert_holds(program->error, cases[i].says);
    }
    for (gsize i = 0; i < G_N_ELEMENTS(pictures); i++) {
        g_autoptr(TestProgram) program = cli_run_well(fixture, pictures[i].words);
        g_autofree char *file = g_build_filename(fixture->folder, pictures[i].file, NULL), *content = NULL;
        g_assert_true(g_file_get_contents(file, &content, NULL, NULL));
        g_assert_true(g_str_has_prefix(content, pictures[i].begins));
    }
}

/* As many as can be within 20 to 1; of as many, the greater ones. */
static void test_scale(void)
{
    const double all[] = {3, 1, 20}, far[] = {1, 2, 3, 1000}, small[] = {5, 9.81, 1e-6}, none[] = {0, 0},
                 two[] = {1, 500};
    g_assert_cmpfloat(tinker_diagram_greatest_to_scale(all, 3), ==, 20);
    g_assert_cmpfloat(tinker_diagram_greatest_to_scale(far, 4), ==, 3);
    g_assert_cmpfloat(tinker_diagram_greatest_to_scale(small, 3), ==, 9.81);
    g_assert_cmpfloat(tinker_diagram_greatest_to_scale(none, 2), ==, 0);
    g_assert_cmpfloat(tinker_diagram_greatest_to_scale(two, 2), ==, 500);
}

/* A bar at rest, held by a pin and a torsional spring against its weight: forces and moments have their bars, but
 * nothing does work, however large what rounding leaves of it may be drawn. */
static void test_books_of_rest(CliFixture *fixture, gconstpointer data)
{
    static const char scene[] =
        SCENE("{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
              "{\"type\": \"bar\", \"name\": \"Bob\", \"mass\": 1.5, \"position\": [0.6, 0], \"width\": 1.2,"
              "\"height\": 0.05, \"orientation\": 0, \"solid\": false},"
              "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [{\"block\": \"Wall\", \"at\": [0, 0]},"
              "{\"block\": \"Bob\", \"at\": [-0.6, 0]}]},"
              "{\"type\": \"torsional-spring\", \"name\": \"Spring\", \"ends\": [\"Wall\", \"Bob\"],"
              "\"stiffness\": 30, \"rest_angle\": 0.3}");
    const TinkerTheme *theme = tinker_theme_find("light");
    const double *given = theme->colours[TINKER_COLOUR_STRETCHED], *taken = theme->colours[TINKER_COLOUR_COMPRESSED];
    g_autofree char *path = cli_write(fixture, "scene.json", scene);
    g_autoptr(TestProgram) drawn =
        cli_run_well(fixture, "books @scene.json --block Bob --to 1 --size 410x840 -o @b.png");
    g_autofree char *file = g_build_filename(fixture->folder, "b.png", NULL);
    cairo_surface_t *whole = cairo_image_surface_create_from_png(file);
    for (int account = 1; account < 4; account++) { /* along y; work and energy; moments: each a sixth of the picture */
        cairo_surface_t *part = cairo_surface_create_for_rectangle(whole, 0, 36 + account * 134, 410, 134);
        cairo_surface_t *copy = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 410, 134 * 5 / 4);
        cairo_t *cairo = cairo_create(copy);
        double at[2];
        cairo_set_source_surface(cairo, part, 0, 0);
        cairo_paint(cairo);
        cairo_destroy(cairo);
        cairo_surface_flush(copy);
        g_assert_cmpint(find_colour(copy, given, at), ==, account != 2);
        g_assert_cmpint(find_colour(copy, taken, at), ==, account != 2);
        cairo_surface_destroy(copy);
        cairo_surface_destroy(part);
    }
    cairo_surface_destroy(whole);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/diagram-pictures/picture", test_picture);
    cli_test_add("/cli/diagram-pictures/small-picture", test_small_picture);
    cli_test_add("/cli/diagram-pictures/long-names", test_long_names);
    cli_test_add("/cli/diagram-pictures/torque-picture", test_torque_picture);
    cli_test_add("/cli/diagram-pictures/torque-value", test_torque_value);
    cli_test_add("/cli/diagram-pictures/torque-label", test_torque_label_is_not_crossed);
    cli_test_add("/cli/diagram-pictures/long-title", test_long_title);
    cli_test_add("/cli/diagram-pictures/torque-label-measured", test_torque_label_is_measured);
    cli_test_add("/cli/diagram-pictures/books-of-rest", test_books_of_rest);
    cli_test_add("/cli/diagram-pictures/endings", test_endings);
    g_test_add_func("/cli/diagram-pictures/scale", test_scale);
    return g_test_run();
}
