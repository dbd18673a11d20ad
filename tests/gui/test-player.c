/* The player against closed forms: a mass of 1 kg on a spring of 25 N/m swings about its equilibrium with 5 rad/s. */
#include "gui-fixture.h"

#include <math.h>
#include <string.h>

#define OMEGA 5.0  /* rad/s */
#define CLOSE 1e-7 /* m: of tolerance 1e-9 */

/* Without gravity, let go 1 m below its rest at y = 2; a support 2 m above. */
#define OSCILLATOR "'run': {'duration': 4, 'interval': 0.01}, " OSCILLATOR_BLOCKS
#define OSCILLATOR_BLOCKS                                                                                              \
    "'blocks': ["                                                                                                      \
    "{'type': 'support', 'name': 'S', 'position': [0, 4], 'orientation': '180 deg'},"                                  \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1]},"                                                               \
    "{'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, 'rest_length': 2}]"

#define MARKED_OSCILLATOR                                                                                              \
    "'blocks': ["                                                                                                      \
    "{'type': 'support', 'name': 'S', 'position': [0, 4], 'orientation': '180 deg'},"                                  \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1]}, {'type': 'marker', 'name': 'P', 'ends': ['M']},"               \
    "{'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, 'rest_length': 2}]"

typedef struct {
    GuiFixture *base;
    TinkerDocument *document;
    TinkerPlayer *player;
    int rewound, failed;
} Fixture;

static void on_rewound(Fixture *fixture)
{
    fixture->rewound++;
}

static void on_failed(TinkerPlayer *player, const char *message, Fixture *fixture)
{
    fixture->failed++;
}

static Fixture *fixture_new(const char *members)
{
    Fixture *fixture = g_new0(Fixture, 1);
    fixture->base = gui_fixture_new("");
    fixture->document = fixture->base->document;
    fixture->player = fixture->base->player;
    gui_fixture_start_scene(fixture->base, members);
    g_signal_connect_swapped(fixture->player, "rewound", G_CALLBACK(on_rewound), fixture);
    g_signal_connect(fixture->player, "failed", G_CALLBACK(on_failed), fixture);
    return fixture;
}

static void fixture_free(Fixture *fixture)
{
    gui_fixture_free(fixture->base);
    g_free(fixture);
}
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Fixture, fixture_free)

static void play(Fixture *fixture)
{
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    tinker_player_play(fixture->player, &culprit, &error);
    g_assert_no_error(error);
}

static void wait_until(Fixture *fixture, double time)
{
    g_autoptr(GError) error = NULL;
    tinker_player_wait(fixture->player, time, &error);
    g_assert_no_error(error);
}

static double height(Fixture *fixture)
{
    double x, y, orientation;
    tinker_frame_centre(tinker_player_frame(fixture->player), gui_fixture_block(fixture->base, "M"), &x, &y,
                        &orientation);
    return y;
}

static TinkerQuantity quantity(Fixture *fixture, const char *id)
{
    TinkerBlockId block = gui_fixture_block(fixture->base, "M");
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_document_scene(fixture->document), block);
    return (TinkerQuantity){block, tinker_block_class_quantity(block_class, id)};
}

static void assert_close(double value, double expected, double tolerance)
{
    if (fabs(value - expected) > tolerance) g_test_message("%.12g is not %.12g", value, expected);
    g_assert_cmpfloat(fabs(value - expected), <=, tolerance);
}

/* Heights and velocities of the mass at every sample of a whole run. (transfer full) */
static GArray *whole_record(Fixture *fixture)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    GArray *values = g_array_new(FALSE, FALSE, sizeof(double));
    play(fixture);
    wait_until(fixture, 4);
    tinker_player_series(fixture->player, quantity(fixture, "y"), &(TinkerSeriesCursor){0}, times, values);
    tinker_player_series(fixture->player, quantity(fixture, "vy"), &(TinkerSeriesCursor){0}, times, values);
    return values;
}

/* Where the offset is measured from has no part in the motion: the same bits, and a run that is shown goes on. */
static void test_local_origin(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR), other = fixture_new(OSCILLATOR);
    gui_fixture_set(other->base, "M", "local_origin", 0.3, 2.5);
    g_autoptr(GArray) first = whole_record(fixture), second = whole_record(other);
    g_assert_cmpmem(first->data, first->len * sizeof(double), second->data, second->len * sizeof(double));
    g_assert_cmpuint(first->len, ==, 802);
    tinker_player_seek(fixture->player, 2);
    gui_fixture_set(fixture->base, "M", "local_origin", -1, 0);
    assert_close(tinker_player_time(fixture->player), 2, 0);
    g_assert_cmpint(fixture->rewound, ==, 0);
}

/* A pendulum of 1 m let go one degree from its top: the first try misses, and gives way to one that does not, all at
 * once. */
static void test_accuracy(void)
{
    g_autoptr(Fixture) fixture = fixture_new(
        "'run': {'duration': 4, 'interval': 0.01, 'method': 'rk4', 'accuracy': 1e-7}, 'blocks': [{'type': 'gravity'},"
        "{'type': 'support', 'name': 'S', 'solid': false}, {'type': 'rod', 'ends': ['S', 'M']},"
        "{'type': 'mass', 'name': 'M', 'position': [0.017452406437283512, 0.99984769515639127]}]");
    const char *const names[] = {"y", "vx", "vy"};
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    play(fixture);
    guint generation = tinker_player_generation(fixture->player);
    wait_until(fixture, 4);
    TinkerRunStatus status;
    g_assert_true(tinker_player_status(fixture->player, &status));
    g_assert_true(status.finished);
    g_assert_cmpuint(status.replaced, ==, 1);
    g_assert_cmpfloat(status.error_estimate, <=, 1e-7);
    g_assert_cmpuint(tinker_player_generation(fixture->player), >=, generation);
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++)
        tinker_player_series(fixture->player, quantity(fixture, names[i]), &(TinkerSeriesCursor){0}, times, values);
    g_assert_cmpuint(values->len, ==, 3 * 401);
    const double *y = (const double *)(gpointer)values->data, *vx = y + 401, *vy = vx + 401;
    for (gsize i = 0; i < 401; i++) /* what gravity gave is what it moves with: shares of 4 g */
        assert_close((vx[i] * vx[i] + vy[i] * vy[i]) / 2, 9.81 * (y[0] - y[i]), 2e-7 * 4 * 9.81);
}

/* However the seconds come in, the motion is the same: every frame lies on the closed form. */
static void test_frame_rates(void)
{
    static const double ticks[] = {0.004, 1.0 / 60, 0.1, 0.37};
    for (gsize i = 0; i < G_N_ELEMENTS(ticks); i++) {
        g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
        play(fixture);
        wait_until(fixture, 4);
        double time = 0;
        while (tinker_player_state(fixture->player) == TINKER_PLAYER_PLAYING) {
            tinker_player_advance(fixture->player, ticks[i]);
            time = fmin(time + ticks[i], 4);
            assert_close(tinker_player_time(fixture->player), time, 1e-12);
            /* Straight between samples: off by h^2 / 8 times the acceleration at most. */
            assert_close(height(fixture), 2 - cos(OMEGA * time), CLOSE + 1e-4 / 8 * OMEGA * OMEGA);
        }
        g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
        assert_close(tinker_player_time(fixture->player), 4, 0);
    }
}

static void test_speed(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    tinker_player_set_speed(fixture->player, 0.25);
    play(fixture);
    wait_until(fixture, 4);
    tinker_player_advance(fixture->player, 2);
    assert_close(tinker_player_time(fixture->player), 0.5, 1e-12);
}

static void test_step_and_seek(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    TinkerBlockId culprit;
    for (int i = 1; i <= 3; i++) {
        g_assert_true(tinker_player_step(fixture->player, TRUE, &culprit, NULL));
        wait_until(fixture, 0.01 * i);
        tinker_player_advance(fixture->player, 1);
        g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
        assert_close(tinker_player_time(fixture->player), 0.01 * i, 1e-12);
        assert_close(height(fixture), 2 - cos(OMEGA * 0.01 * i), CLOSE);
    }
    g_assert_true(tinker_player_step(fixture->player, FALSE, &culprit, NULL));
    assert_close(tinker_player_time(fixture->player), 0.02, 1e-12);
    wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 3.5);
    assert_close(height(fixture), 2 - cos(OMEGA * 3.5), CLOSE);
    tinker_player_seek(fixture->player, 99);
    assert_close(tinker_player_time(fixture->player), 4, 0);
    tinker_player_reset(fixture->player);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_SETUP);
    assert_close(height(fixture), 1, 0);
}

/* The first sample need not be there yet when the next is asked for. */
static void test_steps_in_a_row(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    TinkerBlockId culprit;
    for (int i = 0; i < 50; i++)
        g_assert_true(tinker_player_step(fixture->player, TRUE, &culprit, NULL));
    wait_until(fixture, 0.5);
    tinker_player_advance(fixture->player, 0);
    assert_close(tinker_player_time(fixture->player), 0.5, 1e-12);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
}

/* At the lowest place of its swing the stiffness is quartered: it goes on about the same rest, half as fast. */
static void test_change_on_the_way(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    double turn = 2 * G_PI / OMEGA;
    play(fixture);
    wait_until(fixture, 4);
    tinker_player_seek(fixture->player, turn);
    tinker_player_pause(fixture->player);
    double shown = tinker_player_time(fixture->player);
    gui_fixture_set(fixture->base, "K", "stiffness", 6.25, 0);
    g_assert_cmpint(fixture->rewound, ==, 0);
    double start = tinker_player_time(fixture->player); /* the sample before what was shown */
    g_assert_cmpfloat(shown - start, <, 0.01);
    double phase = OMEGA * start;
    wait_until(fixture, 4);
    for (double t = 1.3; t < 4; t += 0.3) {
        tinker_player_seek(fixture->player, t);
        double since = 0.5 * OMEGA * (t - start);
        /* y - 2 and its rate at the change, carried on with half the frequency. */
        double expected = -cos(phase) * cos(since) + 2 * sin(phase) * sin(since);
        assert_close(height(fixture), 2 + expected, 1e-5 + 1e-4 / 8 * OMEGA * OMEGA);
    }
    tinker_player_seek(fixture->player, 0.5); /* before the change all is as it was */
    assert_close(height(fixture), 2 - cos(OMEGA * 0.5), CLOSE);
}

/* A marker's path up to now. */
static const double *path_of(Fixture *fixture, int32_t *count)
{
    TinkerInstance instance;
    tinker_frame_instance(tinker_player_frame(fixture->player), gui_fixture_block(fixture->base, "P"), &instance);
    *count = instance.path_count;
    return instance.path;
}

/* The path is that of all samples up to the time shown, wherever one seeks to, and over a change on the way. */
static void test_path(void)
{
    g_autoptr(Fixture) fixture = fixture_new("'run': {'duration': 4, 'interval': 0.01}, " MARKED_OSCILLATOR);
    static const double stops[] = {1.005, 3.2, 0.5, 2};
    int32_t count;
    path_of(fixture, &count);
    g_assert_cmpint(count, ==, 0);
    play(fixture);
    wait_until(fixture, 4);
    for (gsize i = 0; i < G_N_ELEMENTS(stops); i++) {
        tinker_player_seek(fixture->player, stops[i]);
        const double *path = path_of(fixture, &count);
        g_assert_cmpint(count, ==, (int)floor(100 * stops[i] + 1e-6) + 1);
        for (int32_t k = 0; k < count; k++)
            assert_close(path[2 * k + 1], 2 - cos(OMEGA * 0.01 * k), CLOSE);
    }
    tinker_player_pause(fixture->player);
    gui_fixture_set(fixture->base, "K", "stiffness", 0, 0); /* from here on straight on */
    wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 3);
    const double *path = path_of(fixture, &count);
    g_assert_cmpint(count, ==, 301);
    for (int32_t k = 0; k < count; k++) {
        const double t = 0.01 * k, after = fmax(t - 2, 0);
        assert_close(path[2 * k + 1], 2 - cos(OMEGA * (t - after)) + OMEGA * sin(OMEGA * 2) * after, CLOSE);
    }
    tinker_player_reset(fixture->player);
    path_of(fixture, &count);
    g_assert_cmpint(count, ==, 0);
}

/* A start that was edited takes back to it. */
static void test_rewinds(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    play(fixture);
    wait_until(fixture, 1);
    tinker_player_seek(fixture->player, 1);
    gui_fixture_set(fixture->base, "M", "position", 0, 1.5);
    g_assert_cmpint(fixture->rewound, ==, 1);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_SETUP);
    assert_close(tinker_player_time(fixture->player), 0, 0);
    assert_close(height(fixture), 1.5, 0);
    play(fixture);
    wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 2);
    assert_close(height(fixture), 2 - 0.5 * cos(OMEGA * 2), CLOSE);
    tinker_document_undo(fixture->document);
    g_assert_cmpint(fixture->rewound, ==, 2);
    assert_close(height(fixture), 1, 0);
}

/* A name is no part of the motion. */
static void test_drawing_goes_on(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    play(fixture);
    wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 2);
    guint generation = tinker_player_generation(fixture->player);
    tinker_document_begin(fixture->document, "Rename", NULL);
    g_assert_true(tinker_history_rename_block(tinker_document_history(fixture->document),
                                              gui_fixture_block(fixture->base, "S"), "Ceiling", NULL));
    tinker_document_end(fixture->document);
    g_assert_true(tinker_history_rename_block(tinker_document_history(fixture->document),
                                              gui_fixture_block(fixture->base, "M"), "Bob", NULL));
    tinker_document_touch(fixture->document);
    g_assert_cmpuint(tinker_player_generation(fixture->player), ==, generation);
    double y;
    TinkerBlockId bob = gui_fixture_block(fixture->base, "Bob");
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_document_scene(fixture->document), bob);
    g_assert_true(tinker_player_value(fixture->player, bob, tinker_block_class_quantity(block_class, "y"), &y));
    assert_close(y, 2 - cos(OMEGA * 2), CLOSE);
}

static void test_series(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    TinkerSeriesCursor cursor = {0};
    play(fixture);
    while (times->len < 401)
        g_assert_true(tinker_player_series(fixture->player, quantity(fixture, "vy"), &cursor, times, values));
    g_assert_cmpuint(times->len, ==, 401);
    g_assert_cmpuint(values->len, ==, 401);
    for (guint i = 0; i < times->len; i++) {
        assert_close(g_array_index(times, double, i), 0.01 * i, 1e-12);
        assert_close(g_array_index(values, double, i), OMEGA * sin(OMEGA * 0.01 * i), OMEGA * CLOSE);
    }
    g_assert_false(
        tinker_player_series(fixture->player, (TinkerQuantity){99, 0}, &(TinkerSeriesCursor){0}, times, values));
}

/* The series of a run that was changed on the way has every sample once. */
static void test_series_over_a_change(void)
{
    g_autoptr(Fixture) fixture = fixture_new(OSCILLATOR);
    play(fixture);
    wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 1.5);
    gui_fixture_set(fixture->base, "K", "stiffness", 20, 0);
    wait_until(fixture, 4);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    g_assert_true(
        tinker_player_series(fixture->player, quantity(fixture, "y"), &(TinkerSeriesCursor){0}, times, values));
    g_assert_cmpuint(times->len, ==, 401);
    for (guint i = 0; i < times->len; i++)
        assert_close(g_array_index(times, double, i), 0.01 * i, 1e-9);
}

/* A long record is read in portions, so that no frame waits for all of it. */
static void test_long_series(void)
{
    const guint rows = 100001;
    g_autoptr(Fixture) fixture = fixture_new("'run': {'duration': 10, 'interval': 1e-4}, " OSCILLATOR_BLOCKS);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    TinkerSeriesCursor cursor = {0};
    play(fixture);
    wait_until(fixture, 10);
    g_assert_true(tinker_player_series(fixture->player, quantity(fixture, "y"), &cursor, times, values));
    g_assert_true(cursor.behind);
    g_assert_cmpuint(times->len, <, rows);
    while (cursor.behind)
        g_assert_true(tinker_player_series(fixture->player, quantity(fixture, "y"), &cursor, times, values));
    g_assert_cmpuint(times->len, ==, rows);
    g_assert_cmpuint(values->len, ==, rows);
    for (guint i = 0; i < rows; i += 101) {
        assert_close(g_array_index(times, double, i), 1e-4 * i, 1e-12);
        assert_close(g_array_index(values, double, i), 2 - cos(OMEGA * 1e-4 * i), CLOSE);
    }
}

/* A property is dragged: each edit begins another run. Those before it end, and the last one counts. */
static void test_dragged_property(void)
{
    g_autoptr(Fixture) fixture =
        fixture_new("'run': {'duration': 4, 'interval': 0.5, 'method': 'rk4', 'step': 2e-5}, " OSCILLATOR_BLOCKS);
    play(fixture);
    wait_until(fixture, 0.5);
    tinker_player_seek(fixture->player, 0.5);
    tinker_player_pause(fixture->player);
    for (int i = 0; i < 300; i++)
        gui_fixture_set(fixture->base, "K", "stiffness", 100 - i / 4.0, 0);
    gui_fixture_set(fixture->base, "K", "stiffness", 36, 0);
    wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 4);
    g_assert_cmpint(fixture->rewound, ==, 0);
    double phase = OMEGA * 0.5, faster = 6 /* rad/s */, since = faster * 3.5;
    assert_close(height(fixture), 2 - cos(phase) * cos(since) + OMEGA / faster * sin(phase) * sin(since), CLOSE);
}

static void test_refusal(void)
{
    g_autoptr(Fixture) fixture = fixture_new("'blocks': [{'type': 'mass', 'name': 'M'}, "
                                             "{'type': 'spring', 'name': 'K', 'ends': ['M', [1, 1]]}]");
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_player_play(fixture->player, &culprit, &error));
    g_assert_cmpint(culprit, ==, gui_fixture_block(fixture->base, "K"));
    g_assert_nonnull(strstr(error->message, "K"));
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_SETUP);
}

/* A run that fails, with a force that is no number behind t = 2, keeps what it has and says so once. */
static void test_failure(void)
{
    g_autoptr(Fixture) fixture = fixture_new("'blocks': [{'type': 'mass', 'name': 'M'}, {'type': 'motor', 'name': 'F', "
                                             "'ends': ['M'], 'waveform': {'expression': 'sqrt(2 - t)'}}]");
    play(fixture);
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
    assert_close(tinker_player_time(fixture->player), 0.5 * end, 0);
    g_assert_cmpint(fixture->failed, ==, 1);
}

static void add_tests(void)
{
    g_test_add_func("/player/accuracy", test_accuracy);
    g_test_add_func("/player/frame-rates", test_frame_rates);
    g_test_add_func("/player/local-origin", test_local_origin);
    g_test_add_func("/player/speed", test_speed);
    g_test_add_func("/player/step-and-seek", test_step_and_seek);
    g_test_add_func("/player/steps-in-a-row", test_steps_in_a_row);
    g_test_add_func("/player/change-on-the-way", test_change_on_the_way);
    g_test_add_func("/player/path", test_path);
    g_test_add_func("/player/rewinds", test_rewinds);
    g_test_add_func("/player/drawing-goes-on", test_drawing_goes_on);
    g_test_add_func("/player/series", test_series);
    g_test_add_func("/player/series-over-a-change", test_series_over_a_change);
    g_test_add_func("/player/long-series", test_long_series);
    g_test_add_func("/player/dragged-property", test_dragged_property);
    g_test_add_func("/player/refusal", test_refusal);
    g_test_add_func("/player/failure", test_failure);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
