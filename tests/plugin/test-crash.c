/* The handler of crashes where something else goes wrong on the way: it says what it can, and never waits for itself.
 * What plugins bring about is in tests/cli/test-crashes.c. */
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include "plugin/call/call.h"
#include "plugin/call/crash-text-private.h"
#include "plugin/call/crash.h"

#define PATIENCE (60 * G_USEC_PER_SEC)

static const TinkerCrashRecord record = {.name = "the record", .file = STDOUT_FILENO, .text = "a row\n", .size = 6};

/* Runs the test of this name, which ends itself, in a process of its own. */
static void expect_end(const char *name, const char *message)
{
    g_test_trap_subprocess(name, PATIENCE, G_TEST_SUBPROCESS_DEFAULT);
    g_assert_false(g_test_trap_reached_timeout());
    g_test_trap_assert_failed();
    g_test_trap_assert_stderr(message);
}

/* Words that cannot be read end the message, and nothing else. */
static void exit_with_broken_words(void)
{
    TinkerPluginCall call = {.phase = "force", .path = GSIZE_TO_POINTER(8)};
    tinker_crash_watch("test");
    tinker_crash_keep(&record);
    tinker_call_enter(&call);
    exit(0);
}

static void test_broken_words(void)
{
    expect_end("/plugin/crash/broken-words/subprocess",
               "test: the library ; what was recorded up to then is in the record\n");
    g_test_trap_assert_stdout("*a row\n*");
}

/* A second signal comes while the first is answered: here of the pipe that nobody reads. */
static void end_into_closed_pipe(void)
{
    int ends[2];
    g_assert_cmpint(pipe(ends), ==, 0);
    close(ends[0]);
    const TinkerCrashRecord lost = {.name = "the pipe", .file = ends[1], .text = "a row\n", .size = 6};
    tinker_crash_watch("test");
    tinker_crash_keep(&lost);
    signal(SIGPIPE, tinker_crash_end);
    tinker_crash_end(SIGTERM);
}

static void test_second_signal(void)
{
    expect_end("/plugin/crash/second-signal/subprocess",
               "test: interrupted; what was recorded could not be written to the pipe\n");
}

/* A row is half made when the process is asked to end: it is finished first. */
static void end_in_a_change(void)
{
    static const char before[] = "half\n";
    tinker_crash_watch("test");
    tinker_crash_keep(&record);
    tinker_crash_change();
    tinker_crash_end(SIGTERM);
    g_assert_cmpint(write(STDOUT_FILENO, before, sizeof before - 1), ==, sizeof before - 1);
    tinker_crash_keep(&record);
}

static void test_change(void)
{
    expect_end("/plugin/crash/change/subprocess", "test: interrupted; what was recorded up to then is in the record\n");
    g_test_trap_assert_stdout("*half\na row\n*");
}

static void test_numbers(void)
{
    static const struct {
        double value;
        const char *text;
    } cases[] = {
        {0, "0"},
        {1.0625, "1.0625"},
        {-2, "-2"},
        {1e-6, "0.000001"},
        {0.9999999, "1"},
        {-1e-9, "0"},
        {123456789.25, "123456789.25"},
        {1e300, "more than 1e15"},
        {-HUGE_VAL, "-inf"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        TinkerCrashText text = {.length = 0};
        tinker_crash_text_add_number(&text, cases[i].value);
        g_assert_cmpstr(text.text, ==, cases[i].text);
    }
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    g_test_add_func("/plugin/crash/broken-words", test_broken_words);
    g_test_add_func("/plugin/crash/broken-words/subprocess", exit_with_broken_words);
    g_test_add_func("/plugin/crash/second-signal", test_second_signal);
    g_test_add_func("/plugin/crash/second-signal/subprocess", end_into_closed_pipe);
    g_test_add_func("/plugin/crash/change", test_change);
    g_test_add_func("/plugin/crash/change/subprocess", end_in_a_change);
    g_test_add_func("/plugin/crash/numbers", test_numbers);
    return g_test_run();
}
