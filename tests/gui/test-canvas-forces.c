/* Forces on the canvas, without a display: how long they are drawn. */
#include <math.h>
#include <string.h>

#include "gui/canvas/canvas-forces.h"
#include "gui/document/forces-now.h"
#include "physics/run/acting-forces.h"
#include "player-fixture.h"

#define SIDE 400 /* canvas units */

/* 1 N on what hardly moves, and 1000 N for a moment about 0.5 s. */
#define PUSHED                                                                                                         \
    "'run': {'duration': 1, 'interval': 0.01}, 'blocks': ["                                                            \
    "{'type': 'mass', 'name': 'M', 'mass': 1e12},"                                                                     \
    "{'type': 'motor', 'name': 'F', 'ends': ['M'], 'waveform': {'expression': '1 + 999*exp(-((t - 0.5)/0.05)^2)'}}]"

/* What is drawn at a time (s). (transfer full) */
static GBytes *drawn_at(PlayerFixture *fixture, CanvasForces *forces, double time)
{
    const TinkerView view = {.scale = 40, .origin_x = SIDE / 2, .origin_y = SIDE / 2, .width = SIDE, .height = SIDE};
    const CanvasForcesLook look = {.theme = tinker_theme_find("light"), .factor = 1, .forces = TRUE};
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, SIDE, SIDE);
    cairo_t *cairo = cairo_create(surface);
    g_assert_nonnull(look.theme);
    tinker_player_seek(fixture->player, time);
    canvas_forces_draw(forces, cairo, fixture->document, fixture->player, &view, &look);
    cairo_destroy(cairo);
    cairo_surface_flush(surface);
    GBytes *bytes =
        g_bytes_new(cairo_image_surface_get_data(surface), (gsize)cairo_image_surface_get_stride(surface) * SIDE);
    cairo_surface_destroy(surface);
    return bytes;
}

/* Whether anything is drawn in this column of the canvas, below the key. */
static gboolean reaches(GBytes *picture, int column)
{
    const guint32 *pixels = g_bytes_get_data(picture, NULL);
    for (int row = SIDE / 4; row < 3 * SIDE / 4; row++)
        if (pixels[row * SIDE + column] != 0) return TRUE;
    return FALSE;
}

/* A blow is drawn shorter than it would be, so that it is seen whole; what comes behind it, and the run when it is
 * shown again, as before it. */
static void test_peak(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(PUSHED);
    CanvasForces *forces = canvas_forces_new();
    player_play(fixture);
    player_wait_until(fixture, 1);
    tinker_player_pause(fixture->player); /* else forces of a little earlier may be shown */
    g_autoptr(GBytes) before = drawn_at(fixture, forces, 0.1), peak = drawn_at(fixture, forces, 0.5),
                      behind = drawn_at(fixture, forces, 0.9), again = drawn_at(fixture, forces, 0.1);
    g_assert_true(reaches(before, SIDE / 2 + 10));
    g_assert_true(reaches(peak, SIDE / 2 + 10));
    g_assert_false(reaches(peak, SIDE - 2));
    g_assert_false(g_bytes_equal(before, peak));
    g_assert_true(g_bytes_equal(before, behind));
    g_assert_true(g_bytes_equal(before, again));
    canvas_forces_free(forces);
}

/* A small mass lies ahead of an arrow, where its label would be: nothing is drawn over it. Where it lies elsewhere the
 * label is there. */
static void test_label_beside_a_small_body(void)
{
    static const char *const blocks =
        "'run': {'duration': 1, 'interval': 0.01}, 'blocks': [{'type': 'mass', 'name': 'M', 'mass': 1e12, 'width': "
        "0.4},"
        "{'type': 'motor', 'name': 'F', 'ends': ['M'], 'amplitude': 1},"
        "{'type': 'mass', 'name': 'N', 'mass': 1e12, 'position': [2, %g], 'width': 0.5, 'height': 0.5}]";
    for (int away = 0; away < 2; away++) {
        g_autofree char *members = g_strdup_printf(blocks, away ? 4.0 : 0.0);
        g_autoptr(PlayerFixture) fixture = player_fixture_new(members);
        CanvasForces *forces = canvas_forces_new();
        player_play(fixture);
        player_wait_until(fixture, 1);
        tinker_player_pause(fixture->player);
        g_autoptr(GBytes) picture = drawn_at(fixture, forces, 0);
        const guint32 *pixels = g_bytes_get_data(picture, NULL);
        int over = 0;
        for (int row = SIDE / 2 - 10; row < SIDE / 2 + 10; row++)
            for (int column = SIDE / 2 + 70; column < SIDE / 2 + 90; column++)
                over += pixels[row * SIDE + column] != 0;
        g_assert_cmpint(over > 0, ==, away);
        canvas_forces_free(forces);
    }
}

/* The motor pulls M to the right from (0, 0), 40 canvas units a metre: what lies there is that force, on M alone. */
static void test_arrow_at_a_place(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(PUSHED);
    CanvasForces *forces = canvas_forces_new();
    TinkerScene *scene = tinker_document_scene(fixture->document);
    g_bytes_unref(drawn_at(fixture, forces, 0));
    const TinkerSpot *spot = tinker_spots_at(canvas_forces_spots(forces), SIDE / 2 + 10, SIDE / 2 + 2, 4);
    g_assert_nonnull(spot);
    g_assert_cmpint(spot->what.block, ==, tinker_scene_find_block(scene, "F"));
    g_assert_cmpint(spot->what.on, ==, tinker_scene_find_block(scene, "M"));
    g_assert_true(g_str_has_prefix(spot->text, "F "));
    g_assert_null(tinker_spots_at(canvas_forces_spots(forces), SIDE / 2 - 10, SIDE / 2, 4));
    canvas_forces_free(forces);
}

/* Between two samples it is the force of that very moment: 1000 N at 0.5 s, and half a sample later 999 exp(-0.01) + 1,
 * as (0.005/0.05)^2 is 0.01. */
static void test_between_samples(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(PUSHED);
    player_play(fixture);
    player_wait_until(fixture, 1);
    tinker_player_pause(fixture->player);
    tinker_player_seek(fixture->player, 0.505);
    const GArray *acting = tinker_forces_now(fixture->document, fixture->player);
    g_assert_cmpuint(acting->len, ==, 1);
    const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, 0);
    g_assert_cmpfloat_with_epsilon(force->fx, 1 + 999 * exp(-0.01), 1e-9);
}

/* A mass of 1 m lies on a floor whose top is 0.5 m below its centre, 20 canvas units: the normal force ends there, as
 * it does in a diagram, and its weight begins at the centre. */
static void test_normal_force_ends_at_contact(void)
{
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'run': {'duration': 1, 'interval': 0.01}, 'blocks': [{'type': 'gravity', 'name': 'G'},"
                           "{'type': 'support', 'name': 'Floor', 'position': [0, -0.6], 'width': 6, 'height': 0.2},"
                           "{'type': 'mass', 'name': 'M', 'width': 1, 'height': 1}]");
    CanvasForces *forces = canvas_forces_new();
    TinkerScene *scene = tinker_document_scene(fixture->document);
    g_bytes_unref(drawn_at(fixture, forces, 0));
    const GArray *spots = canvas_forces_spots(forces);
    guint shafts = 0;
    double across[2];
    for (guint i = 0; i < spots->len; i++) {
        const TinkerSpot *spot = &g_array_index(spots, TinkerSpot, i);
        if (!spot->is_line) continue;
        const gboolean weight = spot->what.block == tinker_scene_find_block(scene, "G");
        g_assert_cmpfloat_with_epsilon(spot->at[weight ? 1 : 3], SIDE / 2 + (weight ? 0 : 20), 1e-6);
        g_assert_true((spot->at[3] > spot->at[1]) == weight);
        across[shafts++ % 2] = spot->at[0];
    }
    g_assert_cmpuint(shafts, ==, 2);
    g_assert_cmpfloat(fabs(across[0] - across[1]), >, 4);
    canvas_forces_free(forces);
}

static void add_tests(void)
{
    g_test_add_func("/canvas-forces/normal-force-ends-at-contact", test_normal_force_ends_at_contact);
    g_test_add_func("/canvas-forces/arrow-at-a-place", test_arrow_at_a_place);
    g_test_add_func("/canvas-forces/label-beside-a-small-body", test_label_beside_a_small_body);
    g_test_add_func("/canvas-forces/peak", test_peak);
    g_test_add_func("/canvas-forces/between-samples", test_between_samples);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
