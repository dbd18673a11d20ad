/* Measuring in the background: it ends, it can be ended, its result can be used, and it knows when it is out of date.
 */
#include <glib/gstdio.h>
#include <math.h>
#include <utime.h>

#include "common/graph/trade-chart.h"
#include "folders.h"
#include "gui-fixture.h"
#include "gui/accuracy/trade-task.h"
#include "gui/document/background.h"
#include "gui/document/run-choice.h"

#define PATIENCE 60.0 /* s */

static TinkerDocument *open_scene_with(TinkerCatalogue *catalogue)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), "spring-mass.tinker.json", NULL);
    TinkerDocument *document = tinker_document_new(catalogue);
    tinker_document_open(document, path, NULL, &error);
    g_assert_no_error(error);
    return document;
}

static TinkerDocument *open_scene(void)
{
    return open_scene_with(scene_fixture_catalogue());
}

/* Fails where it is not over after a time that no slow machine needs. */
static void wait_for_end(TinkerTradeTask *task)
{
    gint64 begun = g_get_monotonic_time();
    while (tinker_trade_task_is_running(task) && g_get_monotonic_time() - begun < (gint64)(1e6 * PATIENCE))
        gui_fixture_pass(5);
    g_assert_false(tinker_trade_task_is_running(task));
}

static char *text_of(TinkerDocument *document)
{
    return tinker_scene_to_text(tinker_document_scene(document), TINKER_WRITE_SI);
}

static TinkerTradeTask *measured(TinkerDocument *document)
{
    TinkerTradeTask *task = tinker_trade_task_new(document);
    tinker_trade_task_start(task, 1e-6, 0.5);
    g_assert_true(tinker_trade_task_is_running(task));
    wait_for_end(task);
    g_assert_null(tinker_trade_task_failure(task));
    g_assert_nonnull(tinker_trade_task_result(task));
    return task;
}

static void note_progress(TinkerTradeTask *task, double *last)
{
    double share = tinker_trade_task_progress(task);
    g_assert_cmpfloat(share, >=, *last);
    g_assert_cmpfloat(share, <=, 1);
    *last = share;
}

static void test_finishes(void)
{
    g_autoptr(TinkerDocument) document = open_scene();
    g_autoptr(TinkerTradeTask) task = tinker_trade_task_new(document);
    double share = 0;
    g_assert_null(tinker_trade_task_result(task));
    g_signal_connect(task, "progress", G_CALLBACK(note_progress), &share);
    tinker_trade_task_start(task, 1e-6, 1);
    wait_for_end(task);
    g_assert_cmpfloat(share, >, 0);
    const TinkerTrade *trade = tinker_trade_task_result(task);
    g_assert_nonnull(trade);
    g_assert_false(trade->interrupted);
    g_assert_cmpint(trade->advice.kind, ==, TINKER_TRADE_ADVICE_MET);
    g_assert_cmpfloat(trade->advice.row.error, <=, 1e-6);
    g_assert_true(strstr(tinker_trade_task_advice(task), trade->advice.row.setting.method) != NULL);
    g_assert_nonnull(tinker_trade_task_reference(task));
    g_assert_false(tinker_trade_task_is_stale(task));
}

/* At whatever point. One that has a reference by then has a result, too. */
static void test_cancels(void)
{
    g_autoptr(TinkerDocument) document = open_scene();
    const double moments[] = {0, 0.02, 0.3, 1.1};
    for (gsize i = 0; i < G_N_ELEMENTS(moments); i++) {
        g_autoptr(TinkerTradeTask) task = tinker_trade_task_new(document);
        tinker_trade_task_start(task, 1e-6, 100);
        gui_fixture_pass((guint)(1e3 * moments[i]));
        g_assert_true(tinker_trade_task_is_running(task));
        tinker_trade_task_cancel(task);
        wait_for_end(task); /* is less patient than measuring would take */
        g_assert_null(tinker_trade_task_failure(task));
        const TinkerTrade *trade = tinker_trade_task_result(task);
        if (trade != NULL) g_assert_true(trade->interrupted);
    }
}

/* Each row that has a result is used in one step for undo, and taken back by it. */
static void test_uses_rows(void)
{
    g_autoptr(TinkerDocument) document = open_scene();
    g_autoptr(TinkerTradeTask) task = measured(document);
    const TinkerTrade *trade = tinker_trade_task_result(task);
    g_autofree char *before = text_of(document);
    int used = 0;
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = g_ptr_array_index(trade->methods, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = &g_array_index(method->rows, TinkerTradeRow, i);
            if (isnan(row->error)) continue;
            g_autoptr(GError) error = NULL;
            tinker_run_choice_use(document, row, &error);
            g_assert_no_error(error);
            const TinkerRunSettings *run = &tinker_scene_head(tinker_document_scene(document))->run;
            g_assert_cmpstr(run->method, ==, row->setting.method);
            double value = row->setting.adaptive ? run->tolerance : run->step;
            if (row->setting.value > 0) g_assert_cmpfloat(value, ==, row->setting.value);
            g_assert_false(tinker_trade_task_is_stale(task)); /* the motion is the same */
            tinker_document_undo(document);
            g_autofree char *after = text_of(document);
            g_assert_cmpstr(after, ==, before);
            g_assert_null(tinker_history_can_undo(tinker_document_history(document)));
            used++;
        }
    }
    g_assert_cmpint(used, >, 0);
}

static void set_mass(TinkerDocument *document, double mass)
{
    TinkerBlockId block = tinker_scene_find_block(tinker_document_scene(document), "Mass 0");
    int32_t property = tinker_block_class_property(scene_fixture_class("mass"), "mass");
    tinker_document_begin(document, "Mass", NULL);
    g_assert_true(tinker_history_set(tinker_document_history(document), block, property, &mass, NULL));
    tinker_document_end(document);
}

static void count(TinkerTradeTask *task, int *changes)
{
    ++*changes;
}

static void test_goes_stale(void)
{
    g_autoptr(TinkerDocument) document = open_scene();
    g_autoptr(TinkerTradeTask) task = measured(document);
    int changes = 0;
    g_signal_connect(task, "changed", G_CALLBACK(count), &changes);
    TinkerBlockId mass = tinker_scene_find_block(tinker_document_scene(document), "Mass 0");
    tinker_document_begin(document, "Rename", NULL);
    tinker_history_rename_block(tinker_document_history(document), mass, "Bob", NULL);
    tinker_document_end(document);
    g_assert_false(tinker_trade_task_is_stale(task));
    tinker_document_undo(document);
    g_assert_cmpint(changes, ==, 0);
    set_mass(document, 2);
    g_assert_true(tinker_trade_task_is_stale(task));
    set_mass(document, 3);
    g_assert_cmpint(changes, ==, 1);
    tinker_document_undo(document);
    tinker_document_undo(document);
    g_assert_false(tinker_trade_task_is_stale(task));
    g_assert_cmpint(changes, ==, 2);
    set_mass(document, 4);
    tinker_document_start(document, "{\"tinker\": 1}", 13, NULL, NULL);
    g_assert_null(tinker_trade_task_result(task));
    g_assert_false(tinker_trade_task_is_stale(task));
}

static void test_fails(void)
{
    g_autoptr(TinkerDocument) document = open_scene();
    g_autoptr(TinkerTradeTask) task = tinker_trade_task_new(document);
    TinkerBlockId mass = tinker_scene_find_block(tinker_document_scene(document), "Mass 0");
    tinker_history_remove_block(tinker_document_history(document), mass);
    tinker_document_touch(document);
    tinker_trade_task_start(task, 1e-6, 1);
    wait_for_end(task);
    g_assert_null(tinker_trade_task_result(task));
    g_assert_true(strstr(tinker_trade_task_failure(task), "Spring 0") != NULL);
}

/* An owner may go at any time; its thread is waited for in the end. */
static void test_let_go(void)
{
    g_autoptr(TinkerDocument) document = open_scene();
    for (int i = 0; i < 10; i++) {
        g_autoptr(TinkerTradeTask) task = tinker_trade_task_new(document);
        tinker_trade_task_start(task, 1e-6, 100);
        gui_fixture_pass((guint)(10 * i));
        if (i % 2 == 0) tinker_trade_task_start(task, 1e-3, 100); /* another one takes its place */
    }
    gint64 begun = g_get_monotonic_time();
    g_assert_true(tinker_background_wait(60));
    g_assert_cmpint(g_get_monotonic_time() - begun, <, 500000);
    gui_fixture_pass(50);
}

/* Every point of the chart lies where its measurement is. */
static void test_chart(void)
{
    g_autoptr(TinkerDocument) document = open_scene();
    g_autoptr(TinkerTradeTask) task = measured(document);
    const TinkerTrade *trade = tinker_trade_task_result(task);
    g_autoptr(TinkerTradeChart) chart = tinker_trade_chart_new(trade);
    TinkerPlot plot = tinker_trade_chart_plot(chart, tinker_theme_find("light"));
    int rings = 0;
    for (int c = 0; c < plot.curve_count; c++) {
        const TinkerCurve *curve = &plot.curves[c];
        rings += curve->role == TINKER_CURVE_RING;
        for (gsize i = 0; i < curve->count; i++) {
            const TinkerTradeRow *row = tinker_trade_chart_row(chart, c, i);
            g_assert_true((row == NULL) == (curve->role == TINKER_CURVE_GUIDE));
            if (row == NULL) continue;
            g_assert_cmpfloat(curve->x[i], ==, row->wall_s);
            if (!row->at_limit) g_assert_cmpfloat(curve->y[i], ==, row->error);
            if (curve->role == TINKER_CURVE_DATA) g_assert_cmpstr(curve->label, ==, row->setting.method);
        }
        g_assert_null(tinker_trade_chart_row(chart, c, curve->count));
    }
    g_assert_cmpint(rings, ==, 1);
    g_assert_null(tinker_trade_chart_row(chart, plot.curve_count, 0));
}

/* A folder with the library of a method, "pull-method". (transfer full) */
static char *folder_of_method(const char *name)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *built = g_build_filename(g_getenv("G_TEST_BUILDDIR"), "plugin", "good.so", NULL), *bytes = NULL;
    gsize length;
    char *folder = g_dir_make_tmp("tinker-trade-XXXXXX", &error);
    g_autofree char *path = g_build_filename(folder, name, NULL);
    g_file_get_contents(built, &bytes, &length, &error);
    g_assert_no_error(error);
    g_file_set_contents_full(path, bytes, (gssize)length, G_FILE_SET_CONTENTS_CONSISTENT, 0644, &error);
    g_assert_no_error(error);
    return folder;
}

static gboolean is_listed(const TinkerTrade *trade, const char *id)
{
    for (guint i = 0; i < trade->methods->len; i++)
        if (g_str_equal(((TinkerTradeMethod *)g_ptr_array_index(trade->methods, i))->id, id)) return TRUE;
    return FALSE;
}

/* The library of a method is touched between the search and the measuring, which asks for the method by the id that the
 * search found. */
static void test_touched_library(void)
{
    g_autofree char *folder = folder_of_method("pull.so"), *library = g_build_filename(folder, "pull.so", NULL);
    g_autofree char *probe = g_file_read_link("/proc/self/exe", NULL);
    const char *folders[] = {g_getenv("TINKER_TEST_PLUGINS"), folder, NULL};
    const TinkerCatalogueOptions options = {
        .folders = folders, .cache_folder = folder, .probe_program = probe, .probe_seconds = PATIENCE};
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&options);
    TinkerDocument *document = open_scene_with(catalogue);
    struct utimbuf time = {1234567890, 1234567890};
    g_assert_cmpint(g_utime(library, &time), ==, 0);
    TinkerTradeTask *task = measured(document);
    g_assert_true(is_listed(tinker_trade_task_result(task), "pull-method"));
    g_object_unref(task);
    g_object_unref(document);
    g_assert_true(tinker_background_wait(PATIENCE));
    test_remove_all(folder);
}

static void add_tests(void)
{
    g_test_add_func("/trade-task/finishes", test_finishes);
    g_test_add_func("/trade-task/cancels", test_cancels);
    g_test_add_func("/trade-task/uses-rows", test_uses_rows);
    g_test_add_func("/trade-task/any-speed/goes-stale", test_goes_stale);
    g_test_add_func("/trade-task/any-speed/fails", test_fails);
    g_test_add_func("/trade-task/let-go", test_let_go);
    g_test_add_func("/trade-task/chart", test_chart);
    g_test_add_func("/trade-task/any-speed/touched-library", test_touched_library);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
