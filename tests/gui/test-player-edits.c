/* What becomes of a run that is shown when the scene is edited, against closed forms. */
#include "player-fixture.h"

#include <math.h>

static double stiffness_in(TinkerScene *scene)
{
    TinkerNumber number;
    const TinkerBlockId spring = tinker_scene_find_block(scene, "K");
    g_assert_true(tinker_scene_find_number(scene, spring, "stiffness", &number));
    return tinker_scene_get(scene, spring, number.column);
}

/* At the lowest place of its swing the stiffness is quartered: it goes on about the same rest, half as fast. */
static void test_change_on_the_way(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    double turn = 2 * G_PI / OMEGA;
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, turn);
    tinker_player_pause(fixture->player);
    double shown = tinker_player_time(fixture->player);
    gui_fixture_set(fixture->base, "K", "stiffness", 6.25, 0);
    g_assert_cmpint(fixture->rewound, ==, 0);
    double start = tinker_player_time(fixture->player); /* the sample before what was shown */
    g_assert_cmpfloat(shown - start, <, 0.01);
    double phase = OMEGA * start;
    player_wait_until(fixture, 4);
    for (double t = 1.3; t < 4; t += 0.3) {
        tinker_player_seek(fixture->player, t);
        double since = 0.5 * OMEGA * (t - start);
        /* y - 2 and its rate at the change, carried on with half the frequency. */
        double expected = -cos(phase) * cos(since) + 2 * sin(phase) * sin(since);
        player_assert_close(player_height(fixture), 2 + expected, 1e-5 + 1e-4 / 8 * OMEGA * OMEGA);
    }
    tinker_player_seek(fixture->player, 0.5); /* before the change all is as it was */
    player_assert_close(player_height(fixture), 2 - cos(OMEGA * 0.5), CLOSE);
    double begins;
    g_autoptr(TinkerScene) before = tinker_player_scene_shown(fixture->player, &begins);
    g_assert_cmpfloat(begins, ==, 0);
    g_assert_cmpfloat(stiffness_in(before), ==, 25);
    tinker_player_seek(fixture->player, 3);
    g_autoptr(TinkerScene) behind = tinker_player_scene_shown(fixture->player, &begins);
    g_assert_cmpfloat(begins, ==, start);
    g_assert_cmpfloat(stiffness_in(behind), ==, 6.25);
}

/* A slack cord of 3 m on a disc of 0.1 m that turns by 10 rad/s shortens by 1 m/s, also when the run goes on from a
 * change on the way, and between two samples. */
static void test_wound(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(
        "'run': {'duration': 1.5, 'interval': 0.01}, 'blocks': [{'type': 'support', 'name': 'S', 'solid': false},"
        "{'type': 'disc', 'position': [0, 0], 'name': 'D', 'radius': 0.1, 'angular_velocity': 10, 'solid': false},"
        "{'type': 'pin', 'ends': ['S', 'D']}, {'type': 'mass', 'name': 'M', 'position': [1, 0]},"
        "{'type': 'cord', 'name': 'C', 'ends': ['D', 'M'], 'length': 3}]");
    const TinkerBlockId cord = tinker_scene_find_block(tinker_document_scene(fixture->document), "C");
    player_play(fixture);
    player_wait_until(fixture, 1.5);
    tinker_player_seek(fixture->player, 0.5);
    tinker_player_pause(fixture->player);
    gui_fixture_set(fixture->base, "M", "mass", 2, 0);
    g_assert_cmpint(fixture->rewound, ==, 0);
    player_wait_until(fixture, 1.5);
    const double times[] = {0, 0.2, 1, 1.003};
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++) {
        tinker_player_seek(fixture->player, times[i]);
        player_assert_close(tinker_frame_length(tinker_player_frame(fixture->player), cord), 3 - times[i], 1e-7);
    }
}

/* A hand that takes hold while it runs, and moves on: the motion goes on from there, about its place. */
static void test_pulled_by_hand(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(
        "'run': {'duration': 4, 'interval': 0.01}, 'blocks': [{'type': 'mass', 'name': 'M', 'position': [0, 1]},"
        "{'type': 'hand', 'name': 'H', 'ends': ['M'], 'place': [0, 1], 'damping': 0, 'stiffness': 25}]");
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 0.5);
    gui_fixture_set(fixture->base, "H", "pulls", 1, 0);
    gui_fixture_set(fixture->base, "H", "place", 0, 3);
    g_assert_cmpint(fixture->rewound, ==, 0);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PLAYING);
    const double start = tinker_player_time(fixture->player);
    player_wait_until(fixture, 4);
    for (double t = 0.6; t < 4; t += 0.3) {
        tinker_player_seek(fixture->player, t);
        player_assert_close(player_height(fixture), 3 - 2 * cos(OMEGA * (t - start)), 1e-5 + 2e-4 / 8 * OMEGA * OMEGA);
    }
}

#define MARKED_OSCILLATOR                                                                                              \
    "'blocks': ["                                                                                                      \
    "{'type': 'support', 'name': 'S', 'position': [0, 4], 'orientation': '180 deg'},"                                  \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1]}, {'type': 'marker', 'name': 'P', 'ends': ['M']},"               \
    "{'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, 'rest_length': 2}]"

/* A marker's path up to now. */
static const double *path_of(PlayerFixture *fixture, int32_t *count)
{
    TinkerInstance instance;
    tinker_frame_instance(tinker_player_frame(fixture->player), gui_fixture_block(fixture->base, "P"), &instance);
    *count = instance.path_count;
    return instance.path;
}

/* The path is that of all samples up to the time shown, wherever one seeks to, and over a change on the way. */
static void test_path(void)
{
    g_autoptr(PlayerFixture) fixture =
        player_fixture_new("'run': {'duration': 4, 'interval': 0.01}, " MARKED_OSCILLATOR);
    static const double stops[] = {1.005, 3.2, 0.5, 2};
    int32_t count;
    path_of(fixture, &count);
    g_assert_cmpint(count, ==, 0);
    player_play(fixture);
    player_wait_until(fixture, 4);
    for (gsize i = 0; i < G_N_ELEMENTS(stops); i++) {
        tinker_player_seek(fixture->player, stops[i]);
        const double *path = path_of(fixture, &count);
        g_assert_cmpint(count, ==, (int)floor(100 * stops[i] + 1e-6) + 1);
        for (int32_t k = 0; k < count; k++)
            player_assert_close(path[2 * k + 1], 2 - cos(OMEGA * 0.01 * k), CLOSE);
    }
    tinker_player_pause(fixture->player);
    gui_fixture_set(fixture->base, "K", "stiffness", 0, 0); /* from here on straight on */
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 3);
    const double *path = path_of(fixture, &count);
    g_assert_cmpint(count, ==, 301);
    for (int32_t k = 0; k < count; k++) {
        const double t = 0.01 * k, after = fmax(t - 2, 0);
        player_assert_close(path[2 * k + 1], 2 - cos(OMEGA * (t - after)) + OMEGA * sin(OMEGA * 2) * after, CLOSE);
    }
    tinker_player_reset(fixture->player);
    path_of(fixture, &count);
    g_assert_cmpint(count, ==, 1);
}

/* After the end of a run nothing could go on with a change: it is made anew from the start, and shown where it was. */
static void test_change_at_the_end(void)
{
    double start;
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, tinker_player_duration(fixture->player));
    tinker_player_pause(fixture->player);
    gui_fixture_set(fixture->base, "K", "stiffness", 6.25, 0);
    player_wait_until(fixture, 4);
    tinker_player_advance(fixture->player, 0);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
    player_assert_close(player_height(fixture), 2 - cos(0.5 * OMEGA * 4), CLOSE);
    for (double t = 0; t < 4; t += 0.3) {
        tinker_player_seek(fixture->player, t);
        player_assert_close(player_height(fixture), 2 - cos(0.5 * OMEGA * t), CLOSE);
    }
    g_autoptr(TinkerScene) scene = tinker_player_scene_shown(fixture->player, &start);
    g_assert_cmpfloat(start, ==, 0);
}

/* A change on the way counts from there on, which is told; made anew, the run is that of the scene as it is. */
static void test_run_anew(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    player_play(fixture);
    player_wait_until(fixture, 4);
    g_assert_true(isnan(tinker_player_changed_at(fixture->player)));
    tinker_player_pause(fixture->player);
    tinker_player_seek(fixture->player, 2);
    gui_fixture_set(fixture->base, "K", "stiffness", 6.25, 0);
    player_assert_close(tinker_player_changed_at(fixture->player), 2, 1e-12);
    g_assert_true(tinker_player_run_anew(fixture->player));
    player_wait_until(fixture, 4);
    tinker_player_advance(fixture->player, 0);
    g_assert_true(isnan(tinker_player_changed_at(fixture->player)));
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_PAUSED);
    player_assert_close(tinker_player_time(fixture->player), 2, 0);
    player_assert_close(player_height(fixture), 2 - cos(0.5 * OMEGA * 2), CLOSE);
}

/* A start that was edited takes back to it. */
static void test_rewinds(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    player_play(fixture);
    player_wait_until(fixture, 1);
    tinker_player_seek(fixture->player, 1);
    gui_fixture_set(fixture->base, "M", "position", 0, 1.5);
    g_assert_cmpint(fixture->rewound, ==, 1);
    g_assert_cmpint(tinker_player_state(fixture->player), ==, TINKER_PLAYER_SETUP);
    player_assert_close(tinker_player_time(fixture->player), 0, 0);
    player_assert_close(player_height(fixture), 1.5, 0);
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 2);
    player_assert_close(player_height(fixture), 2 - 0.5 * cos(OMEGA * 2), CLOSE);
    tinker_document_undo(fixture->document);
    g_assert_cmpint(fixture->rewound, ==, 2);
    player_assert_close(player_height(fixture), 1, 0);
}

/* A name is no part of the motion. */
static void test_drawing_goes_on(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    player_play(fixture);
    player_wait_until(fixture, 4);
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
    player_assert_close(y, 2 - cos(OMEGA * 2), CLOSE);
}

/* The series of a run that was changed on the way has every sample once. */
static void test_series_over_a_change(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(OSCILLATOR);
    player_play(fixture);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 1.5);
    gui_fixture_set(fixture->base, "K", "stiffness", 20, 0);
    player_wait_until(fixture, 4);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    g_assert_true(
        tinker_player_series(fixture->player, player_quantity(fixture, "y"), &(TinkerSeriesCursor){0}, times, values));
    g_assert_cmpuint(times->len, ==, 401);
    for (guint i = 0; i < times->len; i++)
        player_assert_close(g_array_index(times, double, i), 0.01 * i, 1e-9);
}

/* A property is dragged: each edit begins another run. Those before it end, and the last one counts. */
static void test_dragged_property(void)
{
    g_autoptr(PlayerFixture) fixture = player_fixture_new(
        "'run': {'duration': 4, 'interval': 0.5, 'method': 'rk4', 'step': 2e-5}, " OSCILLATOR_BLOCKS);
    player_play(fixture);
    player_wait_until(fixture, 0.5);
    tinker_player_seek(fixture->player, 0.5);
    tinker_player_pause(fixture->player);
    for (int i = 0; i < 300; i++)
        gui_fixture_set(fixture->base, "K", "stiffness", 100 - i / 4.0, 0);
    gui_fixture_set(fixture->base, "K", "stiffness", 36, 0);
    player_wait_until(fixture, 4);
    tinker_player_seek(fixture->player, 4);
    g_assert_cmpint(fixture->rewound, ==, 0);
    double phase = OMEGA * 0.5, faster = 6 /* rad/s */, since = faster * 3.5;
    player_assert_close(player_height(fixture), 2 - cos(phase) * cos(since) + OMEGA / faster * sin(phase) * sin(since),
                        CLOSE);
}

static void add_tests(void)
{
    g_test_add_func("/player/change-on-the-way", test_change_on_the_way);
    g_test_add_func("/player/change-at-the-end", test_change_at_the_end);
    g_test_add_func("/player/run-anew", test_run_anew);
    g_test_add_func("/player/wound", test_wound);
    g_test_add_func("/player/pulled-by-hand", test_pulled_by_hand);
    g_test_add_func("/player/path", test_path);
    g_test_add_func("/player/rewinds", test_rewinds);
    g_test_add_func("/player/drawing-goes-on", test_drawing_goes_on);
    g_test_add_func("/player/series-over-a-change", test_series_over_a_change);
    g_test_add_func("/player/dragged-property", test_dragged_property);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
