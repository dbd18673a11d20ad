/* Runs that stop: where a condition holds, or because nobody looks on. */
#include "player-fixture.h"

#include <math.h>
#include <string.h>

static const TinkerRunEvent *last_event(PlayerFixture *fixture)
{
    const GPtrArray *events = tinker_player_events(fixture->player);
    g_assert_cmpuint(events->len, >, 0);
    return g_ptr_array_index(events, events->len - 1);
}

static void wait_for_end(PlayerFixture *fixture)
{
    TinkerRunStatus status = {0};
    while (!status.finished && tinker_player_status(fixture->player, &status))
        g_usleep(500);
}

/* y = 2 - cos 5t is 2.5 at 2π/15 s: there the record ends, and play-back pauses and says why. Edited on the way the run
 * goes on to where the condition holds again, t being counted from the first start. */
static void test_stop_when(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(
        "'run': {'duration': 4, 'interval': 0.01, 'until': '{M.y} > 5; {M.y} = 2.5 + 0*t'}, " OSCILLATOR_BLOCKS);
    player_play(fixture);
    wait_for_end(fixture);
    tinker_player_advance(fixture->player, 3);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
    player_assert_close(tinker_player_time(fixture->player), 2 * G_PI / 15, 1e-9);
    player_assert_close(player_height(fixture), 2.5, CLOSE);
    player_assert_close(last_event(fixture)->time, 2 * G_PI / 15, 1e-9);
    g_assert_cmpstr(last_event(fixture)->text, ==, "Stopped where {M.y} = 2.5 + 0*t");
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(fixture->document));
    head.run.until = (char *)"t = 1.5; event(impact, M)";
    tinker_document_begin(fixture->document, "Stop", NULL);
    g_assert_true(tinker_history_set_head(tinker_document_history(fixture->document), &head, NULL));
    tinker_document_end(fixture->document);
    g_assert_cmpint(fixture->rewound, ==, 1);
    player_play(fixture);
    wait_for_end(fixture);
    tinker_player_seek(fixture->player, 1);
    gui_fixture_set(fixture->base, "K", "stiffness", 20, 0);
    wait_for_end(fixture);
    player_assert_close(tinker_player_reached(fixture->player), 1.5, 1e-9);
    g_assert_true(tinker_history_rename_block(tinker_document_history(fixture->document),
                                              gui_fixture_block(fixture->base, "M"), "Bob", NULL));
    g_assert_cmpstr(tinker_scene_head(tinker_document_scene(fixture->document))->run.until, ==,
                    "t = 1.5; event(impact, Bob)");
}

/* What never holds stops nothing, and that is said; what is no condition any more keeps the run from beginning. */
static void test_stop_nowhere(void)
{
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'run': {'duration': 1, 'interval': 0.01, 'until': '{M.y} > 5'}, " OSCILLATOR_BLOCKS);
    player_play(fixture);
    wait_for_end(fixture);
    player_assert_close(tinker_player_reached(fixture->player), 1, 0);
    g_assert_cmpstr(last_event(fixture)->text, ==, "Nothing stopped it: {M.y} > 5 did not come true");
    tinker_document_begin(fixture->document, "Delete", NULL);
    tinker_history_remove_block(tinker_document_history(fixture->document), gui_fixture_block(fixture->base, "K"));
    tinker_history_remove_block(tinker_document_history(fixture->document), gui_fixture_block(fixture->base, "M"));
    tinker_document_end(fixture->document);
    player_play(fixture);
    wait_for_end(fixture);
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_player_wait(fixture->player, 1, &error));
    g_assert_nonnull(strstr(error->message, "The condition that stops the run: \"{M.y} > 5\": column 1: "));
}

/* Small steps over many periods: minutes of work. */
#define LONG_RUN "'run': {'duration': 20000, 'interval': 0.01, 'method': 'rk4', 'step': 1e-3}, " OSCILLATOR_BLOCKS

static double reset_at(PlayerFixture *fixture, double time)
{
    player_play(fixture);
    player_wait_until(fixture, time);
    tinker_player_reset(fixture->player);
    return tinker_player_reached(fixture->player);
}

/* Back at the start nothing is computed any more. What was recorded is there to be looked at, and played on from. */
static void test_reset_ends_the_run(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(LONG_RUN);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    reset_at(fixture, 1);
    wait_for_end(fixture);
    const double reached = tinker_player_reached(fixture->player);
    g_assert_cmpfloat(reached, >=, 1);
    g_assert_cmpfloat(reached, <, 20000);
    tinker_player_series(fixture->player, player_quantity(fixture, "y"), &(TinkerSeriesCursor){0}, times, values);
    g_assert_cmpuint(values->len, >, 100);
    player_assert_close(g_array_index(values, double, 100), 2 - cos(OMEGA), CLOSE);
    tinker_player_seek(fixture->player, 0.5);
    player_assert_close(player_height(fixture), 2 - cos(OMEGA * 0.5), CLOSE);
    player_play(fixture);
    player_wait_until(fixture, reached + 1);
    tinker_player_advance(fixture->player, 0.25);
    player_assert_close(tinker_player_time(fixture->player), 0.75, 1e-12);
    player_assert_close(player_height(fixture), 2 - cos(OMEGA * 0.75), CLOSE);
}

/* A run that is kept goes on to its end. */
static void test_reset_of_a_kept_run(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(LONG_RUN);
    TinkerRunStatus status;
    player_play(fixture);
    player_wait_until(fixture, 1);
    g_assert_true(tinker_player_keep(fixture->player));
    const double reached = reset_at(fixture, 1);
    player_wait_until(fixture, reached + 1);
    g_assert_true(tinker_player_status(fixture->player, &status));
    g_assert_false(status.finished);
}

static void add_tests(void)
{
    g_test_add_func("/player/reset-ends-the-run", test_reset_ends_the_run);
    g_test_add_func("/player/reset-of-a-kept-run", test_reset_of_a_kept_run);
    g_test_add_func("/player/stop-when", test_stop_when);
    g_test_add_func("/player/stop-nowhere", test_stop_nowhere);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
