/* The hand on a control against closed forms: a mass of 1 kg on a spring, let go 1 m below its rest at y = 2, is at
 * 2 - cos(omega t), with omega the root of the stiffness. */
#include "gui-fixture.h"

#include <math.h>
#include <string.h>

#include "gui/instrument/hand.h"
#include "scene/store/quantities.h"

#define OSCILLATOR                                                                                                     \
    "'run': {'duration': 4, 'interval': 0.01}, 'blocks': ["                                                            \
    "{'type': 'support', 'name': 'S', 'position': [0, 4], 'orientation': '180 deg'},"                                  \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1]},"                                                               \
    "{'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, 'rest_length': 2}]"
#define CLOSE 1e-6 /* m: of tolerance 1e-9 */

typedef struct {
    GuiFixture *base;
    TinkerHand *hand;
    int rewound;
} Fixture;

static void on_rewound(Fixture *fixture)
{
    fixture->rewound++;
}

static Fixture *fixture_new(void)
{
    Fixture *fixture = g_new0(Fixture, 1);
    fixture->base = gui_fixture_new("");
    gui_fixture_start_scene(fixture->base, OSCILLATOR);
    fixture->hand = tinker_hand_new(fixture->base->document, fixture->base->player);
    g_signal_connect_swapped(fixture->base->player, "rewound", G_CALLBACK(on_rewound), fixture);
    return fixture;
}

static void fixture_free(Fixture *fixture)
{
    tinker_hand_free(fixture->hand);
    gui_fixture_free(fixture->base);
    g_free(fixture);
}
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Fixture, fixture_free)

static double stiffness(Fixture *fixture)
{
    TinkerScene *scene = tinker_document_scene(fixture->base->document);
    const TinkerBlockId spring = gui_fixture_block(fixture->base, "K");
    TinkerNumber number;
    g_assert_true(tinker_scene_find_number(scene, spring, "stiffness", &number));
    return tinker_scene_get(scene, spring, number.column);
}

static void turn(Fixture *fixture, double to)
{
    tinker_hand_set(fixture->hand, gui_fixture_block(fixture->base, "K"), "stiffness", to);
}

static gboolean is_whole(void *data)
{
    Fixture *fixture = data;
    TinkerRunStatus status;
    double wanted;
    const TinkerBlockId spring = gui_fixture_block(fixture->base, "K");
    return !tinker_hand_wanted(fixture->hand, spring, "stiffness", &wanted) &&
           tinker_player_status(fixture->base->player, &status) && status.finished;
}

static double height(Fixture *fixture)
{
    double x, y, orientation;
    tinker_player_refresh(fixture->base->player);
    tinker_frame_centre(tinker_player_frame(fixture->base->player), gui_fixture_block(fixture->base, "M"), &x, &y,
                        &orientation);
    return y;
}

/* At the start, where nothing has been run, the whole curve is there; what was wanted last is what is shown. */
static void test_from_the_start(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    for (double k = 30; k <= 100; k += 10)
        turn(fixture, k);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_assert_cmpfloat(stiffness(fixture), ==, 100);
    g_assert_cmpfloat(tinker_player_time(fixture->base->player), ==, 0);
    g_assert_cmpfloat(tinker_player_reached(fixture->base->player), ==, 4);
    tinker_player_seek(fixture->base->player, 4);
    g_assert_cmpfloat_with_epsilon(height(fixture), 2 - cos(40), CLOSE);
    g_assert_cmpfloat(tinker_hand_rate(fixture->hand), >, 0);
}

/* In the middle of a record the time stays, and what is shown is that of a run from the start. */
static void test_time_stays(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    turn(fixture, 36);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    tinker_player_seek(fixture->base->player, 2);
    g_assert_cmpfloat_with_epsilon(height(fixture), 2 - cos(12), CLOSE);
    turn(fixture, 49);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_assert_cmpfloat(tinker_player_time(fixture->base->player), ==, 2);
    g_assert_cmpfloat_with_epsilon(height(fixture), 2 - cos(14), CLOSE);
    g_assert_cmpint(fixture->rewound, ==, 0);
}

/* A scene that plays goes on playing where it was, and what it shows is a run from the start, too. */
static void test_while_it_plays(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    TinkerPlayer *player = fixture->base->player;
    TinkerBlockId culprit;
    g_assert_true(tinker_player_play(player, &culprit, NULL));
    g_assert_true(tinker_player_wait(player, 4, NULL));
    tinker_player_advance(player, 2);
    turn(fixture, 49);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_assert_cmpint(tinker_player_state(player), ==, TINKER_PLAYER_PLAYING);
    g_assert_cmpfloat(tinker_player_time(player), ==, 2);
    g_assert_true(isnan(tinker_player_changed_at(player)));
    tinker_player_advance(player, 0.5);
    g_assert_cmpfloat(tinker_player_time(player), ==, 2.5);
    g_assert_cmpfloat_with_epsilon(height(fixture), 2 - cos(7 * 2.5), CLOSE);
}

/* What a hand does without letting go is one step. */
static void test_one_step(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    for (int i = 0; i < 3; i++) {
        turn(fixture, 40 + i);
        g_assert_true(gui_fixture_wait(is_whole, fixture));
    }
    tinker_hand_let_go(fixture->hand);
    turn(fixture, 60);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    tinker_document_undo(fixture->base->document);
    g_assert_cmpfloat(stiffness(fixture), ==, 42);
    tinker_document_undo(fixture->base->document);
    g_assert_cmpfloat(stiffness(fixture), ==, 25);
}

static gboolean is_estimated(void *data)
{
    TinkerRunStatus status;
    return tinker_player_status(((Fixture *)data)->base->player, &status) && status.finished && !status.estimate_due;
}

/* Runs of a hand that turns have no estimate of their error; once it rests there is one, of the same samples. */
static void test_estimate_at_rest(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    TinkerRunStatus status;
    turn(fixture, 36);
    g_assert_true(tinker_player_status(fixture->base->player, &status));
    g_assert_true(status.estimate_due);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    tinker_player_seek(fixture->base->player, 3);
    const double before = height(fixture);
    const guint generation = tinker_player_generation(fixture->base->player);
    g_assert_true(tinker_player_status(fixture->base->player, &status));
    g_assert_true(isnan(status.error_estimate));
    g_assert_true(gui_fixture_wait(is_estimated, fixture));
    g_assert_true(tinker_player_status(fixture->base->player, &status));
    g_assert_cmpfloat(status.error_estimate, >, 0);
    g_assert_cmpfloat(status.error_estimate, <, 1e-6);
    g_assert_cmpfloat(height(fixture), ==, before);
    g_assert_cmpuint(tinker_player_generation(fixture->base->player), ==, generation);
    g_assert_cmpfloat(tinker_player_time(fixture->base->player), ==, 3);
}

/* The energies of the scene, which are added up sample by sample, are there once the hand rests, or once something has
 * asked for them. */
static void test_energies_at_rest(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    const TinkerQuantity kinetic = {TINKER_NO_BLOCK, TINKER_SCENE_KINETIC};
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double)),
                      values = g_array_new(FALSE, FALSE, sizeof(double));
    TinkerSeriesCursor first = {0}, second = {0};
    turn(fixture, 36);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_assert_false(tinker_player_series(fixture->base->player, kinetic, &first, times, values));
    g_assert_true(gui_fixture_wait(is_estimated, fixture));
    g_assert_true(tinker_player_series(fixture->base->player, kinetic, &first, times, values));
    turn(fixture, 49);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_array_set_size(times, 0);
    g_array_set_size(values, 0);
    g_assert_true(tinker_player_series(fixture->base->player, kinetic, &second, times, values));
    for (guint i = 0; i < values->len; i++) {
        const double speed = 7 * sin(7 * g_array_index(times, double, i));
        g_assert_cmpfloat_with_epsilon(g_array_index(values, double, i), 0.5 * speed * speed, 100 * CLOSE);
    }
    g_assert_cmpuint(values->len, >, 100);
}

/* Of a long run a hand sees some samples, which are exact; once it rests, all of them. */
static void test_samples_at_rest(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    TinkerRunStatus status;
    g_autofree char *members = g_strdup(OSCILLATOR);
    memcpy(strstr(members, "0.01"), "1e-3", 4);
    gui_fixture_start_scene(fixture->base, members);
    turn(fixture, 36);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_assert_true(tinker_player_status(fixture->base->player, &status));
    g_assert_cmpuint(status.rows, ==, 1001);
    tinker_player_seek(fixture->base->player, 3.5);
    g_assert_cmpfloat_with_epsilon(height(fixture), 2 - cos(21), CLOSE);
    g_assert_true(gui_fixture_wait(is_estimated, fixture));
    g_assert_true(tinker_player_status(fixture->base->player, &status));
    g_assert_cmpuint(status.rows, ==, 4001);
    tinker_player_seek(fixture->base->player, 3.501);
    g_assert_cmpfloat_with_epsilon(height(fixture), 2 - cos(6 * 3.501), CLOSE);
}

static void on_moved(gboolean *told)
{
    *told = TRUE;
}

/* While a run that was made anew comes to where time stands, what is seen is what was there, and not its start. */
static void test_nothing_jumps(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    TinkerPlayer *player = fixture->base->player;
    gui_fixture_start_scene(fixture->base, "'run': {'duration': 4, 'interval': 0.01, 'method': 'rk4', 'step': 2e-6}, "
                                           "'blocks': [{'type': 'support', 'name': 'S', 'position': [0, 4], "
                                           "'orientation': '180 deg'}, {'type': 'mass', 'name': 'M', 'position': [0, "
                                           "1]}, {'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, "
                                           "'rest_length': 2}]");
    TinkerBlockId culprit;
    TinkerRunStatus status = {0};
    gboolean told = FALSE;
    g_assert_true(tinker_player_play(player, &culprit, NULL));
    g_assert_true(tinker_player_wait(player, 4, NULL));
    tinker_player_seek(player, 3.9);
    const double before = height(fixture);
    const gulong handler = g_signal_connect_swapped(player, "moved", G_CALLBACK(on_moved), &told);
    turn(fixture, 36);
    tinker_player_status(player, &status);
    g_assert_false(status.finished); /* else there is nothing to see */
    g_assert_false(told);
    g_assert_cmpfloat(height(fixture), ==, before);
    g_signal_handler_disconnect(player, handler);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_assert_cmpfloat_with_epsilon(height(fixture), 2 - cos(6 * 3.9), CLOSE);
}

static gboolean has_some(void *data)
{
    TinkerRunStatus status;
    return tinker_player_status(((Fixture *)data)->base->player, &status) && status.rows > 10;
}

/* Of a run that takes long the curve is there as far as it has come. */
static void test_as_far_as_it_is(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    gui_fixture_start_scene(fixture->base,
                            "'run': {'duration': 4000, 'interval': 0.01, 'method': 'rk4', 'step': 1e-4}, "
                            "'blocks': [{'type': 'support', 'name': 'S', 'position': [0, 4], "
                            "'orientation': '180 deg'}, {'type': 'mass', 'name': 'M', 'position': [0, "
                            "1]}, {'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, "
                            "'rest_length': 2}]");
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double)),
                      values = g_array_new(FALSE, FALSE, sizeof(double));
    const TinkerBlockId mass = gui_fixture_block(fixture->base, "M");
    const TinkerQuantity y = {mass,
                              tinker_scene_find_quantity(tinker_document_scene(fixture->base->document), mass, "y")};
    TinkerSeriesCursor cursor = {0};
    TinkerRunStatus status;
    turn(fixture, 36);
    g_assert_true(gui_fixture_wait(has_some, fixture));
    g_assert_true(tinker_player_status(fixture->base->player, &status));
    g_assert_false(status.finished);
    g_assert_true(tinker_player_series(fixture->base->player, y, &cursor, times, values));
    g_assert_cmpuint(values->len, >, 10);
    for (guint i = 0; i < values->len; i++)
        g_assert_cmpfloat_with_epsilon(g_array_index(values, double, i), 2 - cos(6 * g_array_index(times, double, i)),
                                       CLOSE);
}

/* What cannot be is said, and changes nothing. */
static void test_refused(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    turn(fixture, -1);
    gui_fixture_pass(20);
    g_assert_nonnull(tinker_hand_problem(fixture->hand));
    g_assert_cmpfloat(stiffness(fixture), ==, 25);
    turn(fixture, 26);
    g_assert_true(gui_fixture_wait(is_whole, fixture));
    g_assert_cmpstr(tinker_hand_problem(fixture->hand), ==, NULL);
}

/* What is told has the titles that people see. */
static void test_titles_in_problem(void)
{
    g_autoptr(Fixture) fixture = fixture_new();
    turn(fixture, -1);
    gui_fixture_pass(20);
    const char *problem = tinker_hand_problem(fixture->hand);
    g_test_message("%s", problem);
    g_assert_nonnull(strstr(problem, "“K”"));
    g_assert_null(strstr(problem, "stiffness"));
}

static void add_tests(void)
{
    g_test_add_func("/gui/hand/from-the-start", test_from_the_start);
    g_test_add_func("/gui/hand/time-stays", test_time_stays);
    g_test_add_func("/gui/hand/while-it-plays", test_while_it_plays);
    g_test_add_func("/gui/hand/one-step", test_one_step);
    g_test_add_func("/gui/hand/estimate-at-rest", test_estimate_at_rest);
    g_test_add_func("/gui/hand/energies-at-rest", test_energies_at_rest);
    g_test_add_func("/gui/hand/samples-at-rest", test_samples_at_rest);
    g_test_add_func("/gui/hand/nothing-jumps", test_nothing_jumps);
    g_test_add_func("/gui/hand/as-far-as-it-is", test_as_far_as_it_is);
    g_test_add_func("/gui/hand/refused", test_refused);
    g_test_add_func("/gui/hand/titles-in-problem", test_titles_in_problem);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
