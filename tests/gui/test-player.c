/* The player against closed forms: playing at any rate, stepping, seeking, series of samples, and what is refused or
 * fails. */
#include "player-fixture.h"

#include <math.h>
#include <string.h>

/* Heights and velocities of the mass at every sample of a whole run. (transfer full) */
static GArray *whole_record(PlayerFixture *fixture)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    GArray *values = g_array_new(FALSE, FALSE, sizeof(double));
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_series(fixture->player, player_quantity(fixture, "y"), &(TinkerSeriesCursor){0}, times, values);
    tinker_player_series(fixture->player, player_quantity(fixture, "vy"), &(TinkerSeriesCursor){0}, times, values);
    return values;
}

/* Where the offset is measured from has no part in the motion: the same bits, and a run that is shown goes on. */
static void test_local_origin(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR), other = player_fixture_new(OSCILLATOR);
    gui_fixture_set(other->base, "M", "local_origin", 0.3, 2.5);
    g_autoptr(GArray) first = whole_record(fixture), second = whole_record(other);
    g_assert_cmpmem(first->data, first->len * sizeof(double), second->data, second->len * sizeof(double));
    g_assert_cmpuint(first->len, ==, 802);
    tinker_player_seek(fixture->player, 2);
    gui_fixture_set(fixture->base, "M", "local_origin", -1, 0);
    player_assert_close(tinker_player_time(fixture->player), 2, 0);
    g_assert_cmpint(fixture->rewound, ==, 0);
}

/* A pendulum of 1 m let go one degree from its top: the first try misses, and gives way to one that does not, all at
 * once. */
static void test_accuracy(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(
        "'run': {'duration': 4, 'interval': 0.01, 'method': 'rk4', 'accuracy': 1e-7}, 'blocks': [{'type': 'gravity'},"
        "{'type': 'support', 'name': 'S', 'solid': false}, {'type': 'rod', 'ends': ['S', 'M']},"
        "{'type': 'mass', 'name': 'M', 'position': [0.017452406437283512, 0.99984769515639127]}]");
    const char *const names[] = {"y", "vx", "vy"};
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    player_play(fixture);
    guint generation = tinker_player_generation(fixture->player);
    player_wait_until(fixture, 4);
    TinkerRunStatus status;
    g_assert_true(tinker_player_status(fixture->player, &status));
    g_assert_true(status.finished);
    g_assert_cmpuint(status.replaced, ==, 1);
    g_assert_cmpfloat(status.error_estimate, <=, 1e-7);
    g_assert_cmpuint(tinker_player_generation(fixture->player), >=, generation);
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++)
        tinker_player_series(fixture->player, player_quantity(fixture, names[i]), &(TinkerSeriesCursor){0}, times,
                             values);
    g_assert_cmpuint(values->len, ==, 3 * 401);
    const double *y = (const double *)(gpointer)values->data, *vx = y + 401, *vy = vx + 401;
    for (gsize i = 0; i < 401; i++) /* what gravity gave is what it moves with: shares of 4 g */
        player_assert_close((vx[i] * vx[i] + vy[i] * vy[i]) / 2, 9.81 * (y[0] - y[i]), 2e-7 * 4 * 9.81);
}

/* However the seconds come in, the motion is the same: every frame lies on the closed form. */
static void test_frame_rates(void)
{
    static const double ticks[] = {0.004, 1.0 / 60, 0.1, 0.37};
    for (gsize i = 0; i < G_N_ELEMENTS(ticks); i++) {
        g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
        player_play(fixture);
        player_wait_until(fixture, 4);
        double time = 0;
        while (tinker_player_state(fixture->player) == TINKER_PLAYER_PLAYING) {
            tinker_player_advance(fixture->player, ticks[i]);
            time = fmin(time + ticks[i], 4);
            player_assert_close(tinker_player_time(fixture->player), time, 1e-12);
            /* Straight between samples: off by h^2 / 8 times the acceleration at most. */
            player_assert_close(player_height(fixture), 2 - cos(OMEGA * time), CLOSE + 1e-4 / 8 * OMEGA * OMEGA);
        }
        g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
        player_assert_close(tinker_player_time(fixture->player), 4, 0);
    }
}

static void test_speed(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    tinker_player_set_speed(fixture->player, 0.25);
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_advance(fixture->player, 2);
    player_assert_close(tinker_player_time(fixture->player), 0.5, 1e-12);
}

static void test_step_and_seek(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    TinkerBlockId culprit;
    for (int i = 1; i <= 3; i++) {
        g_assert_true(tinker_player_step(fixture->player, TRUE, &culprit, NULL));
        player_wait_until(fixture, 0.01 * i);
        tinker_player_advance(fixture->player, 1);
        g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
        player_assert_close(tinker_player_time(fixture->player), 0.01 * i, 1e-12);
        player_assert_close(player_height(fixture), 2 - cos(OMEGA * 0.01 * i), CLOSE);
    }
    g_assert_true(tinker_player_step(fixture->player, FALSE, &culprit, NULL));
    player_assert_close(tinker_player_time(fixture->player), 0.02, 1e-12);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 3.5);
    player_assert_close(player_height(fixture), 2 - cos(OMEGA * 3.5), CLOSE);
    tinker_player_seek(fixture->player, 99);
    player_assert_close(tinker_player_time(fixture->player), 4, 0);
    tinker_player_reset(fixture->player);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_SETUP);
    player_assert_close(player_height(fixture), 1, 0);
}

/* Along the line of a slot a mass swings with amplitude v/omega = 0.5 m about the slot's end. */
#define SLOT_BLOCKS                                                                                                    \
    "{'type': 'support', 'name': 'A', 'position': [4, 0]}, {'type': 'support', 'name': 'S', 'position': [0, 0]},"      \
    "{'type': 'mass', 'name': 'M', 'position': [0, 0], 'velocity': [2.5, 0]},"                                         \
    "{'type': 'spring', 'name': 'K', 'ends': ['A', 'M'], 'stiffness': 25, 'rest_length': 4},"                          \
    "{'type': 'slot', 'name': 'G', 'ends': ['S', 'M']}]"

static TinkerInstance slot_shown(PlayerFixture *fixture)
{
    const TinkerBlockId slot = tinker_scene_find_block(tinker_document_scene(fixture->document), "G");
    TinkerInstance instance;
    g_assert_true(tinker_frame_instance(tinker_player_frame(fixture->player), slot, &instance));
    return instance;
}

/* So long in the main loop, in which nothing is played or sought. */
static void look_on(double seconds)
{
    for (const gint64 until = g_get_monotonic_time() + (gint64)(1e6 * seconds); g_get_monotonic_time() < until;
         g_usleep(1000))
        while (g_main_context_iteration(NULL, FALSE)) {
        }
}

/* The amplitude is the span at every time that is shown, as soon as the run is recorded, and none of it before. */
static void test_spans(void)
{
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'run': {'duration': 4, 'interval': 0.01}, 'blocks': [" SLOT_BLOCKS);
    g_assert_cmpfloat(slot_shown(fixture).span, ==, 0);
    player_play(fixture);
    player_wait_until(fixture, 4);
    for (int i = 0; i < 3; i++) {
        tinker_player_seek(fixture->player, i);
        const TinkerInstance instance = slot_shown(fixture);
        player_assert_close(instance.span, 0.5, 0.5 * (1 - cos(OMEGA * 0.005)) + CLOSE);
        player_assert_close(fabs(instance.end[1].x - instance.end[0].x), fabs(0.5 * sin(OMEGA * i)), CLOSE);
    }
}

/* The ghost of a run that is kept has its amplitude as the span from its first picture on. */
static void test_spans_of_a_kept_run(void)
{
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'run': {'duration': 4, 'interval': 0.01}, 'blocks': [" SLOT_BLOCKS);
    player_play(fixture);
    player_wait_until(fixture, 4);
    g_assert_true(tinker_player_keep(fixture->player));
    TinkerKeptRun *kept = tinker_kept_runs_at(tinker_player_kept(fixture->player), 0);
    for (int i = 0; i < 4; i++) {
        TinkerFrame *frame = tinker_kept_run_frame(kept, i);
        TinkerInstance instance;
        g_assert_true(tinker_frame_instance(frame, tinker_scene_find_block(kept->scene, "G"), &instance));
        player_assert_close(instance.span, 0.5, 0.5 * (1 - cos(OMEGA * 0.005)) + CLOSE);
        player_assert_close(fabs(instance.end[1].x - instance.end[0].x), fabs(0.5 * sin(OMEGA * i)), CLOSE);
    }
}

/* With a spring of hundred times the stiffness from t = 0.1 s on, where x = sin(0.5)/2, it never comes as far as it
 * would have: of the run that was recorded up to its end nothing beyond that time stays. It is told while time stands
 * still. */
static void test_spans_of_another_future(void)
{
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'run': {'duration': 4, 'interval': 0.001}, 'blocks': [" SLOT_BLOCKS);
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_pause(fixture->player);
    tinker_player_seek(fixture->player, 0.1);
    look_on(0.5);
    player_assert_close(slot_shown(fixture).span, 0.5, 1e-5);
    gui_fixture_set(fixture->base, "K", "stiffness", 2500, 0);
    player_wait_until(fixture, 4);
    look_on(0.5);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
    const double omega = 10 * OMEGA, x = 0.5 * sin(0.5), v = 2.5 * cos(0.5), amplitude = hypot(x, v / omega);
    player_assert_close(slot_shown(fixture).span, amplitude, amplitude * (1 - cos(omega * 0.0005)) + CLOSE);
}

/* The first sample need not be there yet when the next is asked for. */
static void test_steps_in_a_row(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    TinkerBlockId culprit;
    for (int i = 0; i < 50; i++)
        g_assert_true(tinker_player_step(fixture->player, TRUE, &culprit, NULL));
    player_wait_until(fixture, 0.5);
    tinker_player_advance(fixture->player, 0);
    player_assert_close(tinker_player_time(fixture->player), 0.5, 1e-12);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
}

static void test_series(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    TinkerSeriesCursor cursor = {0};
    player_play(fixture);
    while (times->len < 401)
        g_assert_true(tinker_player_series(fixture->player, player_quantity(fixture, "vy"), &cursor, times, values));
    g_assert_cmpuint(times->len, ==, 401);
    g_assert_cmpuint(values->len, ==, 401);
    for (guint i = 0; i < times->len; i++) {
        player_assert_close(g_array_index(times, double, i), 0.01 * i, 1e-12);
        player_assert_close(g_array_index(values, double, i), OMEGA * sin(OMEGA * 0.01 * i), OMEGA * CLOSE);
    }
    g_assert_false(
        tinker_player_series(fixture->player, (TinkerQuantity){99, 0}, &(TinkerSeriesCursor){0}, times, values));
}

/* A long record is read in portions, so that no frame waits for all of it. */
static void test_long_series(void)
{
    const guint rows = 100001;
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'run': {'duration': 10, 'interval': 1e-4}, " OSCILLATOR_BLOCKS);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    TinkerSeriesCursor cursor = {0};
    player_play(fixture);
    player_wait_until(fixture, 10);
    g_assert_true(tinker_player_series(fixture->player, player_quantity(fixture, "y"), &cursor, times, values));
    g_assert_true(cursor.behind);
    g_assert_cmpuint(times->len, <, rows);
    while (cursor.behind)
        g_assert_true(tinker_player_series(fixture->player, player_quantity(fixture, "y"), &cursor, times, values));
    g_assert_cmpuint(times->len, ==, rows);
    g_assert_cmpuint(values->len, ==, rows);
    for (guint i = 0; i < rows; i += 101) {
        player_assert_close(g_array_index(times, double, i), 1e-4 * i, 1e-12);
        player_assert_close(g_array_index(values, double, i), 2 - cos(OMEGA * 1e-4 * i), CLOSE);
    }
}

static void test_refusal(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new("'blocks': [{'type': 'mass', 'name': 'M'}, "
                                                          "{'type': 'spring', 'name': 'K', 'ends': ['M', [1, 1]]}]");
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_player_play(fixture->player, &culprit, &error));
    g_assert_cmpint(culprit, ==, gui_fixture_block(fixture->base, "K"));
    g_assert_nonnull(strstr(error->message, "K"));
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_SETUP);
}

/* How many samples of the height of M there are. */
static guint samples_of(PlayerFixture *fixture)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    (void)tinker_player_series(fixture->player, player_quantity(fixture, "y"), &(TinkerSeriesCursor){0}, times, values);
    return times->len;
}

/* Going back is not forgetting: what was recorded can be looked at until an edit or another run, which is that of the
 * scene as it is from its start on. */
static void test_reset_keeps_what_was(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_pause(fixture->player);
    tinker_player_seek(fixture->player, 2);
    gui_fixture_set(fixture->base, "K", "stiffness", 0, 0); /* from here on straight on */
    player_wait_until(fixture, 4);
    tinker_player_reset(fixture->player);
    double start, stiffness;
    g_autoptr(TinkerScene) shown =
        tinker_player_scene_shown(fixture->player, &start); /* not what was before the edit */
    stiffness = tinker_scene_get(shown, gui_fixture_block(fixture->base, "K"), 0);
    g_assert_cmpfloat(stiffness, ==, 0);
    g_assert_true(isnan(tinker_player_changed_at(fixture->player)));
    g_assert_cmpuint(samples_of(fixture), ==, 401);
    g_assert_true(tinker_player_keep(fixture->player));
    tinker_player_seek(fixture->player, 1);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
    player_assert_close(player_height(fixture), 2 - cos(OMEGA), CLOSE);
    tinker_player_reset(fixture->player);
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 1);
    player_assert_close(player_height(fixture), 1, CLOSE); /* at rest: nothing pulls from the start on */
    tinker_player_reset(fixture->player);
    gui_fixture_set(fixture->base, "M", "position", 0, 1.5);
    g_assert_cmpuint(samples_of(fixture), ==, 0);
    tinker_player_give_up(fixture->player);
    g_assert_false(tinker_player_keep(fixture->player));
}

/* A run that fails, with a force that is no number behind t = 2, keeps what it has and says so once. */
static void test_failure(void)
{
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'blocks': [{'type': 'mass', 'name': 'M'}, {'type': 'motor', 'name': 'F', "
                           "'ends': ['M'], 'waveform': {'expression': 'sqrt(2 - t)'}}]");
    player_play(fixture);
    for (int i = 0; i < 10000 && tinker_player_state(fixture->player) == TINKER_PLAYER_PLAYING; i++) {
        tinker_player_advance(fixture->player, 1);
        g_usleep(1000);
    }
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
    g_assert_cmpint(fixture->failed, ==, 1);
    double end = tinker_player_time(fixture->player);
    g_assert_cmpfloat(end, >, 1.9);
    g_assert_cmpfloat(end, <=, 2);
    tinker_player_seek(fixture->player, 0.5 * end);
    player_assert_close(tinker_player_time(fixture->player), 0.5 * end, 0);
    g_assert_cmpint(fixture->failed, ==, 1);
    tinker_player_reset(fixture->player); /* and once more when it is run again */
    player_play(fixture);
    for (int i = 0; i < 10000 && tinker_player_state(fixture->player) == TINKER_PLAYER_PLAYING; i++) {
        tinker_player_advance(fixture->player, 1);
        g_usleep(1000);
    }
    g_assert_cmpint(fixture->failed, ==, 2);
}

static void add_tests(void)
{
    g_test_add_func("/player/accuracy", test_accuracy);
    g_test_add_func("/player/frame-rates", test_frame_rates);
    g_test_add_func("/player/local-origin", test_local_origin);
    g_test_add_func("/player/speed", test_speed);
    g_test_add_func("/player/step-and-seek", test_step_and_seek);
    g_test_add_func("/player/spans", test_spans);
    g_test_add_func("/player/spans-of-a-kept-run", test_spans_of_a_kept_run);
    g_test_add_func("/player/spans-of-another-future", test_spans_of_another_future);
    g_test_add_func("/player/steps-in-a-row", test_steps_in_a_row);
    g_test_add_func("/player/series", test_series);
    g_test_add_func("/player/long-series", test_long_series);
    g_test_add_func("/player/refusal", test_refusal);
    g_test_add_func("/player/reset-keeps-what-was", test_reset_keeps_what_was);
    g_test_add_func("/player/failure", test_failure);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
