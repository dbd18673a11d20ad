/* What has landed on a support is drawn along it from then on. The corners of a box stand in an SVG in world
 * coordinates, as exactly as cairo keeps paths: 1/256 of a pixel. */
#include <math.h>
#include <string.h>

#include "fixture.h"

#define SCENE       "incline-landing.tinker.json"
#define BODY_COLOUR "fill:rgb(83.921569%,89.411765%,94.901961%)"
#define EXACT       3e-4 /* m, in a picture with more than 50 pixels to the metre */

/* Corners of the only body in the picture. */
static void corners_of(const CliFixture *fixture, const char *name, double corners[4][2])
{
    g_autofree char *text = cli_read(fixture, name);
    const char *body = strstr(text, BODY_COLOUR);
    g_assert_nonnull(body);
    g_assert_true(g_strrstr(text, BODY_COLOUR) == body);
    const char *place = strstr(body, " d=\"M ");
    g_assert_nonnull(place);
    place += strlen(" d=\"M ");
    for (int k = 0; k < 4; k++) {
        char *end = NULL;
        corners[k][0] = g_ascii_strtod(place, &end);
        corners[k][1] = g_ascii_strtod(end, &end);
        g_assert_true(g_str_has_prefix(end, k < 3 ? " L " : " Z"));
        place = end + 3;
    }
}

/* The bundled scene with its mass at (x, y) from the start, turned by so many degrees. */
static void write_placed(const CliFixture *fixture, const char *path, double x, double y, double degrees)
{
    cJSON *scene = test_read_json(path), *block;
    cJSON_ArrayForEach(block, cJSON_GetObjectItem(scene, "blocks"))
    {
        if (strcmp(cJSON_GetStringValue(cJSON_GetObjectItem(block, "type")), "mass") != 0) continue;
        const double position[2] = {x, y};
        cJSON_ReplaceItemInObject(block, "position", cJSON_CreateDoubleArray(position, 2));
        cJSON_AddNumberToObject(block, "orientation", degrees * G_PI / 180);
    }
    g_autofree char *text = cJSON_Print(scene);
    g_autofree char *written = cli_write(fixture, "placed.json", text);
    cJSON_Delete(scene);
}

/* Every corner of one box lies at a corner of the other: turned by half a turn a box is the same. */
static void assert_same_box(double a[4][2], double b[4][2])
{
    for (int i = 0; i < 4; i++) {
        double nearest = INFINITY;
        for (int k = 0; k < 4; k++)
            nearest = fmin(nearest, hypot(a[i][0] - b[k][0], a[i][1] - b[k][1]));
        g_assert_cmpfloat(nearest, <, EXACT);
    }
}

/* Falling, sliding on the incline, in the air behind its end, at rest on the floor. */
static void test_turned(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        double time, degrees;
    } rows[] = {{0.3, 0}, {1.5, -25}, {2.4, -25}, {3.8, 0}};
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), SCENE, NULL);
    g_autofree char *run = g_strdup_printf("run '%s' --at 0.3,1.5,2.4,3.8 --csv -", path);
    g_autoptr(TestProgram) program = cli_run_well(fixture, run);
    g_autoptr(TestTable) record = test_table_new(program->output);
    for (gsize row = 0; row < G_N_ELEMENTS(rows); row++) {
        double drawn[4][2], expected[4][2];
        g_autofree char *later =
            g_strdup_printf("render '%s' --no-labels --time %g -o @later.svg", path, rows[row].time);
        g_autoptr(TestProgram) rendered = cli_run_well(fixture, later);
        corners_of(fixture, "later.svg", drawn);
        write_placed(fixture, path, test_table_value(record, row, "Mass 0.x"),
                     test_table_value(record, row, "Mass 0.y"), rows[row].degrees);
        g_autoptr(TestProgram) placed = cli_run_well(fixture, "render @placed.json --no-labels -o @placed.svg");
        corners_of(fixture, "placed.svg", expected);
        assert_same_box(drawn, expected);
    }
}

/* That corners tell an angle: the box as placed, and turned. */
static void test_corners(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), SCENE, NULL);
    double corners[4][2];
    write_placed(fixture, path, 1, 2, -25);
    g_autoptr(TestProgram) rendered = cli_run_well(fixture, "render @placed.json --no-labels -o @placed.svg");
    corners_of(fixture, "placed.svg", corners);
    const double c = cos(-25 * G_PI / 180), s = sin(-25 * G_PI / 180);
    double expected[4][2];
    for (int k = 0; k < 4; k++) {
        const double along = k == 1 || k == 2 ? 0.5 : -0.5, up = k > 1 ? 0.3 : -0.3;
        expected[k][0] = 1 + c * along - s * up;
        expected[k][1] = 2 + s * along + c * up;
    }
    assert_same_box(corners, expected);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/contact-pictures/corners", test_corners);
    cli_test_add("/contact-pictures/turned", test_turned);
    return g_test_run();
}
