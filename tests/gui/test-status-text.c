/* What the status line says: of a plan, of runs that go well or badly, and of runs that are slow. */
#include "gui/document/status-text.h"

#include <math.h>
#include <string.h>

static TinkerRunStatus good_run(void)
{
    return (TinkerRunStatus){
        .reached = 3.2,
        .rows = 321,
        .method = "rk4",
        .step = 0.01,
        .error_estimate = 2.1e-9,
        .energy_balance_error = 3e-12,
        .constraint_error = 4e-13,
        .predictable_until = INFINITY,
        .valid_until = INFINITY,
    };
}

static char *line_of(const TinkerRunStatus *run, double speed, double pace, gboolean warnings[TINKER_STATUS_COUNT])
{
    TinkerStatusItem items[TINKER_STATUS_COUNT];
    const TinkerStatusFacts facts = {.run = run, .duration = 10, .speed = speed, .pace = pace};
    tinker_status_fill(&facts, items);
    for (int i = 0; i < TINKER_STATUS_COUNT; i++) {
        g_assert_true((items[i].text == NULL) == (items[i].tooltip == NULL)); /* nothing goes unexplained */
        if (warnings != NULL) warnings[i] = items[i].warning;
    }
    char *line = tinker_status_line_text(items);
    tinker_status_clear(items);
    return line;
}

static void test_sizes(void)
{
    const struct {
        double value;
        int digits;
        const char *text;
    } cases[] = {{2.1e-9, 1, "2e-9"},    {9.6e-10, 1, "1e-9"}, {0, 1, "0"},        {0.034, 1, "0.03"},
                 {4.84e-3, 2, "4.8e-3"}, {1.34, 2, "1.3"},     {1234, 2, "1.2e3"}, {1e-300, 2, "1.0e-300"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = tinker_status_size_text(cases[i].value, cases[i].digits);
        g_assert_cmpstr(text, ==, cases[i].text);
    }
}

/* Nothing is recorded yet, and the line says why. */
static void test_looks_for_the_end(void)
{
    TinkerRunStatus run = {.error_estimate = NAN, .looks = TRUE, .looked = 3.2};
    g_autofree char *line = line_of(&run, 1, 1, NULL);
    g_assert_cmpstr(line, ==, "looking for where it stops: 3.2 s of 10 s");
    run.finished = TRUE;
    g_autofree char *after = line_of(&run, 1, 1, NULL);
    g_assert_null(strstr(after, "looking"));
}

static void test_good_run(void)
{
    gboolean warnings[TINKER_STATUS_COUNT];
    TinkerRunStatus run = good_run();
    g_autofree char *line = line_of(&run, 1, 1, warnings);
    g_assert_cmpstr(line, ==,
                    "rk4, step 0.01 s; error about 2e-9 of the motion; energy off by 3e-12; lengths held to 4e-13; "
                    "recorded to 3.2 s of 10 s");
    for (int i = 0; i < TINKER_STATUS_COUNT; i++)
        g_assert_false(warnings[i]);
    run.finished = TRUE;
    run.adaptive = TRUE;
    run.tolerance = 1e-9;
    run.constraint_error = 0; /* nothing holds anything */
    run.energy_balance_error = 0;
    run.error_estimate = NAN;
    g_autofree char *over = line_of(&run, 1, 1, NULL);
    g_assert_cmpstr(over, ==, "rk4, tolerance 1e-09; energy balanced");
}

static void test_estimate_due(void)
{
    TinkerRunStatus run = good_run();
    run.error_estimate = NAN;
    run.estimate_due = TRUE;
    g_autofree char *line = line_of(&run, 1, 1, NULL);
    g_assert_nonnull(strstr(line, "error being estimated"));
}

static void test_bad_run(void)
{
    gboolean warnings[TINKER_STATUS_COUNT];
    TinkerRunStatus run = good_run();
    run.error_estimate = 0.034;
    run.energy_balance_error = 0.2;
    run.constraint_error = 1e-3;
    g_autofree char *line = line_of(&run, 1, 1, warnings);
    g_assert_nonnull(strstr(line, "error about 3 % of the motion"));
    g_assert_true(warnings[TINKER_STATUS_ERROR]);
    g_assert_true(warnings[TINKER_STATUS_ENERGY]);
    g_assert_true(warnings[TINKER_STATUS_CONSTRAINTS]);
    g_assert_false(warnings[TINKER_STATUS_METHOD]);
    run.error_estimate = 2;
    g_autofree char *large = line_of(&run, 1, 1, NULL);
    g_assert_nonnull(strstr(large, "error as large as the motion"));
    run.predictable_until = 7.61;
    g_autofree char *chaotic = line_of(&run, 1, 1, warnings);
    g_assert_nonnull(strstr(chaotic, "predictable up to 7.61 s"));
    g_assert_true(warnings[TINKER_STATUS_ERROR]);
    const double lost[] = {INFINITY, NAN};
    for (gsize i = 0; i < G_N_ELEMENTS(lost); i++) {
        run.energy_balance_error = lost[i];
        g_autofree char *beyond = line_of(&run, 1, 1, warnings);
        g_assert_nonnull(strstr(beyond, "energy beyond all bounds"));
        g_assert_true(warnings[TINKER_STATUS_ENERGY]);
    }
}

static void test_slow_run(void)
{
    gboolean warnings[TINKER_STATUS_COUNT];
    TinkerRunStatus run = good_run();
    g_autofree char *slow = line_of(&run, 1, 0.4, warnings);
    g_assert_nonnull(strstr(slow, "slower than real time: 0.4×"));
    g_assert_true(warnings[TINKER_STATUS_PACE]);
    g_autofree char *fast = line_of(&run, 10, 0.4, NULL);
    g_assert_nonnull(strstr(fast, "slower than asked: 4×"));
    g_autofree char *in_time = line_of(&run, 10, 1, NULL);
    g_assert_null(strstr(in_time, "slower"));
}

/* Before a run there is the plan, or nothing. */
static void test_plan(void)
{
    const TinkerIntegrator rk4 = {.id = "rk4"}, exact = {.id = "exact"};
    g_autoptr(GPtrArray) islands = g_ptr_array_new();
    TinkerIslandPlan first = {
        .choice = {.method = &rk4, .step = 0.005}, .expected_error = 2e-7, .reason = (char *)"it suits"};
    TinkerIslandPlan second = first;
    TinkerPlan plan = {.islands = islands};
    TinkerPlanResult result = {.plan = &plan, .automatic = TRUE};
    first.blocks = second.blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    const TinkerStatusFacts facts = {.plan = &result, .duration = 10, .speed = 1, .pace = 1};
    TinkerStatusItem items[TINKER_STATUS_COUNT];
    for (int count = 0; count < 3; count++) {
        if (count == 1) g_ptr_array_add(islands, &first);
        if (count == 2) {
            second.choice.method = &exact;
            second.expected_error = 3e-5;
            g_ptr_array_add(islands, &second);
        }
        tinker_status_fill(&facts, items);
        g_autofree char *line = tinker_status_line_text(items);
        static const char *const expected[] = {
            "",
            "Automatic: rk4, step 0.005 s; error of about 2e-7 of the motion expected",
            "Automatic: 2 parts, each by a method of its own; error of about 3e-5 of the motion expected",
        };
        g_assert_cmpstr(line, ==, expected[count]);
        if (count > 0) g_assert_nonnull(strstr(items[TINKER_STATUS_METHOD].tooltip, "it suits"));
        tinker_status_clear(items);
    }
    g_array_unref(first.blocks);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/status-text/sizes", test_sizes);
    g_test_add_func("/status-text/looks-for-the-end-run", test_looks_for_the_end);
    g_test_add_func("/status-text/good-run", test_good_run);
    g_test_add_func("/status-text/estimate-due", test_estimate_due);
    g_test_add_func("/status-text/bad-run", test_bad_run);
    g_test_add_func("/status-text/slow-run", test_slow_run);
    g_test_add_func("/status-text/plan", test_plan);
    return g_test_run();
}
