/* A run that nobody wants any more ends soon: between two steps, however long they are, and before the first. */
#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"

typedef struct {
    int after; /* questions that are answered with no */
    int asked;
} Patience;

static gboolean had_enough(void *data)
{
    Patience *patience = data;
    return ++patience->asked > patience->after;
}

/* Masses in a row that hang on one another: one island. */
static TinkerScene *chain(int masses)
{
    g_autoptr(GString) blocks = g_string_new("{'type': 'support', 'name': 'M0', 'position': [0, 0]}");
    for (int i = 1; i <= masses; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'mass', 'name': 'M%d', 'position': [0, %d]}"
                               ", {'type': 'spring', 'ends': ['M%d', 'M%d'], 'stiffness': 100}",
                               i, -i, i - 1, i);
    g_string_append(blocks, ", {'type': 'gravity'}");
    g_strdelimit(blocks->str, "'", '"');
    return scene_fixture_read_blocks(blocks->str);
}

/* Steps until a run of 2000 was stopped, where the answer is yes from the question after `after` on. */
static gint64 steps_until_stopped(int masses, Patience *patience)
{
    g_autoptr(TinkerScene) scene = chain(masses);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.method = "verlet";
    options.step = 1e-3;
    options.duration = options.interval = 2;
    options.estimate = FALSE;
    options.cancelled = had_enough;
    options.data = patience;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    g_assert_no_error(error);
    g_assert_false(tinker_simulation_run(simulation, NULL, NULL, NULL, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED);
    return tinker_simulation_summary(simulation)->steps;
}

/* The first question is that of the set-up. */
static void test_between_steps(void)
{
    Patience at_once = {.after = 1};
    g_assert_cmpint(steps_until_stopped(300, &at_once), ==, 1);
    Patience later = {.after = 6};
    g_assert_cmpint(steps_until_stopped(300, &later), ==, 6);
}

/* Short steps are not burdened with a question each. */
static void test_few_questions(void)
{
    Patience patience = {.after = 3};
    g_assert_cmpint(steps_until_stopped(1, &patience), >, 100);
}

static void test_before_the_first_step(void)
{
    g_autoptr(TinkerScene) scene = chain(3);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    Patience none = {.after = 0};
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.cancelled = had_enough;
    options.data = &none;
    g_assert_null(tinker_simulation_new(model, &options, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED);
    g_assert_cmpint(none.asked, ==, 1);
}

static void add_tests(void)
{
    g_test_add_func("/physics/cancel/between-steps", test_between_steps);
    g_test_add_func("/physics/cancel/few-questions", test_few_questions);
    g_test_add_func("/physics/cancel/before-the-first-step", test_before_the_first_step);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
