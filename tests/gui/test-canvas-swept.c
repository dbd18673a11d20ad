/* The way of what moves, as what lies over the canvas keeps clear of it: against the closed form of an oscillation, and
 * how often the record is gone through for it. */
#include "player-fixture.h"

#include <math.h>

#include "gui/canvas/canvas-swept.h"

static const TinkerView view = {.scale = 50, .origin_x = 200, .origin_y = 250, .width = 400, .height = 300};

static const GArray *look(PlayerFixture *fixture, TinkerSwept *swept, const TinkerView *from)
{
    return tinker_swept_boxes(swept, fixture->document, fixture->player, from);
}

static void play_to_end(PlayerFixture *fixture)
{
    TinkerRunStatus status = {0};
    player_play(fixture);
    while (!status.finished && tinker_player_status(fixture->player, &status))
        g_usleep(500);
}

/* y = 2 - cos 5t is between 1 and 3: where the mass is drawn there, and nothing of what stands still. */
static void test_way_of_an_oscillation(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    TinkerSwept swept = {0};
    double least = INFINITY, greatest = -INFINITY;
    g_assert_cmpuint(look(fixture, &swept, &view)->len, ==, 0);
    play_to_end(fixture);
    const GArray *boxes = look(fixture, &swept, &view);
    for (guint i = 0; i < boxes->len; i++) {
        const double *box = (const double *)(gpointer)boxes->data + 4 * (gsize)i;
        const double middle = (box[1] + box[3]) / 2;
        if (box[3] >= 4) continue; /* of the spring, up to the support at 4 */
        least = fmin(least, middle);
        greatest = fmax(greatest, middle);
    }
    player_assert_close(least, 1, 0.02);
    player_assert_close(greatest, 3, 0.2); /* by less than a share of its size it is where it was */
    tinker_swept_clear(&swept);
}

/* Once as long as scene, record and scale are these: however the view is moved, and whatever time is shown. */
static void test_looked_up_once(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    TinkerSwept swept = {0};
    TinkerView moved = view;
    play_to_end(fixture);
    const guint count = look(fixture, &swept, &view)->len;
    g_assert_cmpuint(count, >, 0);
    for (int i = 0; i < 100; i++) {
        tinker_view_pan(&moved, 3, -2);
        tinker_player_seek(fixture->player, 0.04 * i);
        g_assert_cmpuint(look(fixture, &swept, &moved)->len, ==, count);
    }
    g_assert_cmpuint(swept.looked, ==, 1);
    tinker_view_zoom(&moved, 2, 0, 0);
    look(fixture, &swept, &moved);
    g_assert_cmpuint(swept.looked, ==, 2);
    gui_fixture_set(fixture->base, "M", "mass", 2, 0);
    look(fixture, &swept, &moved);
    g_assert_cmpuint(swept.looked, ==, 3);
    tinker_player_reset(fixture->player);
    play_to_end(fixture);
    look(fixture, &swept, &moved);
    g_assert_cmpuint(swept.looked, ==, 4);
    tinker_swept_clear(&swept);
}

static void add_tests(void)
{
    g_test_add_func("/canvas-swept/way-of-an-oscillation", test_way_of_an_oscillation);
    g_test_add_func("/canvas-swept/looked-up-once", test_looked_up_once);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
