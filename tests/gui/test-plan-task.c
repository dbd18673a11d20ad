/* The plan that follows a document: after the last edit, of the scene as it is then, in the main loop's time. */
#include "gui-fixture.h"
#include "gui/document/background.h"
#include "gui/document/plan-task.h"
#include "gui/document/run-choice.h"

#define PATIENCE 20.0 /* s */

static TinkerDocument *open_scene(const char *name)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), name, NULL);
    TinkerDocument *document = tinker_document_new(scene_fixture_catalogue());
    tinker_document_open(document, path, NULL, &error);
    g_assert_no_error(error);
    return document;
}

static void set_run(TinkerDocument *document, const char *method, double step)
{
    g_autoptr(GError) error = NULL;
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    head.run.method = (char *)method;
    head.run.step = step;
    tinker_document_begin(document, "Method", NULL);
    tinker_history_set_head(tinker_document_history(document), &head, &error);
    g_assert_no_error(error);
    tinker_document_end(document);
}

static const TinkerPlanResult *wait_for_plan(TinkerPlanTask *task)
{
    for (double waited = 0; waited < PATIENCE && tinker_plan_task_is_due(task); waited += 0.01)
        gui_fixture_pass(10);
    g_assert_false(tinker_plan_task_is_due(task));
    return tinker_plan_task_result(task);
}

static const TinkerIslandPlan *only_island(const TinkerPlanResult *result)
{
    g_assert_nonnull(result->plan);
    g_assert_cmpuint(result->plan->islands->len, ==, 1);
    return g_ptr_array_index(result->plan->islands, 0);
}

/* k = 25 N/m and m = 1 kg swing at 5 rad/s, and rk4 is stable up to sqrt(8)/5 s = 0.566 s. */
static void test_warning_and_cure(void)
{
    g_autoptr(TinkerDocument) document = open_scene("spring-mass.tinker.json");
    g_autoptr(TinkerPlanTask) task = tinker_plan_task_new(document);
    set_run(document, "rk4", 0.57);
    const TinkerPlanResult *result = wait_for_plan(task);
    g_assert_cmpstr(only_island(result)->choice.method->id, ==, "rk4");
    g_assert_cmpfloat(only_island(result)->choice.step, ==, 0.57);
    g_assert_false(result->automatic);
    g_assert_cmpuint(result->plan->warnings->len, >, 0);
    g_assert_true(strstr(tinker_warnings_text(result->avoidable, 0), "0.566") != NULL);

    g_autofree char *before = tinker_scene_to_text(tinker_document_scene(document), TINKER_WRITE_SI);
    g_assert_true(tinker_run_choice_automatic(document, NULL));
    result = wait_for_plan(task);
    g_assert_true(result->automatic);
    g_assert_cmpuint(result->avoidable->len, ==, 0);
    g_assert_cmpuint(result->plan->warnings->len, ==, 0);
    tinker_document_undo(document);
    g_autofree char *after = tinker_scene_to_text(tinker_document_scene(document), TINKER_WRITE_SI);
    g_assert_cmpstr(after, ==, before);

    set_run(document, "rk4", 0.01);
    g_assert_cmpuint(wait_for_plan(task)->plan->warnings->len, ==, 0);
}

static void count(TinkerPlanTask *task, int *changes)
{
    ++*changes;
}

/* Many edits in a row are planned once, and while it works another edit takes its place. */
static void test_superseded(void)
{
    g_autoptr(TinkerDocument) document = open_scene("spring-mass.tinker.json");
    g_autoptr(TinkerPlanTask) task = tinker_plan_task_new(document);
    int changes = 0;
    g_signal_connect(task, "changed", G_CALLBACK(count), &changes);
    for (int i = 1; i <= 10; i++) {
        set_run(document, "verlet", 0.001 * i);
        gui_fixture_pass(20);
        if (i % 3 == 0) tinker_plan_task_demand(task); /* is under way when the next edit comes */
        g_assert_cmpint(changes, <=, 3);
    }
    g_assert_cmpfloat(only_island(wait_for_plan(task))->choice.step, ==, 0.01);
    changes = 0;
    gui_fixture_pass(500);
    g_assert_cmpint(changes, ==, 0);
}

static void test_refused(void)
{
    g_autoptr(TinkerDocument) document = open_scene("spring-mass.tinker.json");
    g_autoptr(TinkerPlanTask) task = tinker_plan_task_new(document);
    TinkerScene *scene = tinker_document_scene(document);
    tinker_document_begin(document, "Delete", NULL);
    tinker_history_remove_block(tinker_document_history(document), tinker_scene_find_block(scene, "Mass 0"));
    tinker_document_end(document);
    const TinkerPlanResult *result = wait_for_plan(task);
    g_assert_null(result->plan);
    g_assert_true(strstr(result->error->message, "Spring 0") != NULL);
    tinker_document_undo(document);
    g_assert_nonnull(wait_for_plan(task)->plan);
}

/* Of a large scene nothing is planned until somebody asks. */
static void test_large(void)
{
    g_autoptr(TinkerDocument) document = tinker_document_new(scene_fixture_catalogue());
    g_autoptr(TinkerPlanTask) task = tinker_plan_task_new(document);
    wait_for_plan(task);
    tinker_document_begin(document, "Many", NULL);
    for (int i = 0; i <= TINKER_PLAN_MOST_BLOCKS; i++)
        tinker_history_add_block(tinker_document_history(document), scene_fixture_class("mass"), NULL, NULL);
    tinker_document_end(document);
    gui_fixture_pass(600);
    g_assert_null(tinker_plan_task_result(task));
    g_assert_true(tinker_plan_task_is_due(task));
    tinker_plan_task_demand(task);
    g_assert_nonnull(wait_for_plan(task)->plan);
}

/* An owner may go at any time; its thread is waited for in the end. */
static void test_let_go(void)
{
    g_autoptr(TinkerDocument) document = open_scene("spring-mass-network.tinker.json");
    for (int i = 0; i < 20; i++) {
        g_autoptr(TinkerPlanTask) task = tinker_plan_task_new(document);
        tinker_plan_task_demand(task);
        g_usleep((gulong)(200 * i));
    }
    g_assert_true(tinker_background_wait(60));
    gui_fixture_pass(50);
}

/* A thread that does not end is not waited for for ever. */
static void test_never_ends(void)
{
    tinker_background_enter();
    g_assert_false(tinker_background_wait(0.01));
    tinker_background_leave();
    g_assert_true(tinker_background_wait(60));
}

static gboolean draw_on(gpointer data)
{
    ++*(guint *)data;
    return G_SOURCE_CONTINUE;
}

/* What draws frame after frame without a pause, as a window does on a slow machine, does not keep a result away. */
static void test_frames_do_not_keep_it_away(void)
{
    g_autoptr(TinkerDocument) document = open_scene("spring-mass.tinker.json");
    g_autoptr(TinkerPlanTask) task = tinker_plan_task_new(document);
    guint frames = 0;
    const guint source = g_idle_add_full(G_PRIORITY_HIGH_IDLE + 20, draw_on, &frames, NULL);
    const TinkerPlanResult *result = wait_for_plan(task);
    g_source_remove(source);
    g_assert_nonnull(result);
    g_assert_cmpuint(frames, >, 0);
}

static void add_tests(void)
{
    g_test_add_func("/plan-task/frames-do-not-keep-it-away", test_frames_do_not_keep_it_away);
    g_test_add_func("/plan-task/warning-and-cure", test_warning_and_cure);
    g_test_add_func("/plan-task/superseded", test_superseded);
    g_test_add_func("/plan-task/refused", test_refused);
    g_test_add_func("/plan-task/large", test_large);
    g_test_add_func("/plan-task/let-go", test_let_go);
    g_test_add_func("/plan-task/never-ends", test_never_ends);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
