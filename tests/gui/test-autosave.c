/* Copies while one edits: when there is one, when it goes, and what is told where none can be made. */
#include <errno.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/program/program-start.h"
#include "copies-fixture.h"
#include "gui/document/autosave.h"
#include "gui/document/recovery.h"
#include "gui/document/session.h"

static void test_nothing_left_behind(void)
{
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    g_autofree char *folder = tinker_session_folder(), *saved = files_fixture_folder();
    g_autofree char *path = g_build_filename(saved, "a.tinker.json", NULL);
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpuint(copies_count(), ==, 0);

    files_fixture_rename(document, "One");
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpuint(copies_count(), ==, 1);
    tinker_document_undo(document);
    g_assert_cmpuint(copies_count(), ==, 0);
    tinker_document_redo(document);
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpuint(copies_count(), ==, 1);
    g_assert_true(tinker_document_save(document, path, NULL));
    g_assert_cmpuint(copies_count(), ==, 0);

    files_fixture_rename(document, "Two");
    g_assert_true(tinker_autosave_now(autosave));
    tinker_autosave_forget(autosave);
    g_assert_cmpuint(copies_count(), ==, 0);
    tinker_recovery_purge();
    g_assert_cmpuint(copies_count_in(folder, ""), ==, 0);
}

static void test_timer(void)
{
    g_setenv("TINKER_AUTOSAVE_SECONDS", "0.02", TRUE);
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    files_fixture_rename(document, "One");
    gint64 end = g_get_monotonic_time() + COPIES_PATIENCE;
    while (copies_count() == 0 && g_get_monotonic_time() < end)
        g_main_context_iteration(NULL, TRUE);
    g_assert_cmpuint(copies_count(), ==, 1);
    tinker_autosave_forget(autosave);
    g_unsetenv("TINKER_AUTOSAVE_SECONDS");
}

static void count(TinkerAutosave *autosave, const char *message, int *times)
{
    ++*times;
}

static void count_plain(TinkerAutosave *autosave, int *times)
{
    ++*times;
}

/* A file is in the way of the folder. Told once, tried again, and told when it works again. */
static void test_unwritable(void)
{
    int failed = 0, working = 0;
    g_autofree char *folder = tinker_session_folder(), *away = g_strconcat(folder, "-away", NULL);
    g_assert_cmpint(g_rename(folder, away), ==, 0);
    g_assert_true(g_file_set_contents(folder, "", -1, NULL));
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    g_signal_connect(autosave, "failed", G_CALLBACK(count), &failed);
    g_signal_connect(autosave, "working", G_CALLBACK(count_plain), &working);
    files_fixture_rename(document, "One");
    g_assert_false(tinker_autosave_now(autosave));
    files_fixture_rename(document, "Two");
    g_assert_false(tinker_autosave_now(autosave));
    g_assert_cmpint(failed, ==, 1);
    g_assert_cmpint(working, ==, 0);
    g_assert_cmpstr(files_fixture_first_name(document), ==, "Two");
    g_assert_cmpint(g_unlink(folder), ==, 0);
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpint(failed, ==, 1);
    g_assert_cmpint(working, ==, 1);
    g_assert_cmpuint(copies_count(), ==, 1);
    tinker_autosave_forget(autosave);
}

/* The system limits the size of files: told as a full disk is, and nothing is left. */
static void test_size_limit(void)
{
    g_autofree char *folder = tinker_session_folder();
    int failed = 0;
    struct rlimit before, limit;
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    g_signal_connect(autosave, "failed", G_CALLBACK(count), &failed);
    tinker_recovery_purge();
    tinker_program_start("tinker-gui");
    files_fixture_rename(document, "One");
    g_assert_cmpint(getrlimit(RLIMIT_FSIZE, &before), ==, 0);
    limit = (struct rlimit){64, before.rlim_max};
    g_assert_cmpint(setrlimit(RLIMIT_FSIZE, &limit), ==, 0);
    const gboolean saved = tinker_autosave_now(autosave);
    g_assert_cmpint(setrlimit(RLIMIT_FSIZE, &before), ==, 0);
    g_assert_false(saved);
    g_assert_cmpint(failed, ==, 1);
    g_assert_cmpuint(copies_count(), ==, 0);
    tinker_autosave_forget(autosave);
    g_assert_cmpuint(copies_count_in(folder, ""), ==, 0);
}

static void add_tests(void)
{
    g_test_add_func("/gui/autosave/nothing-left-behind", test_nothing_left_behind);
    g_test_add_func("/gui/autosave/timer", test_timer);
    g_test_add_func("/gui/autosave/unwritable", test_unwritable);
    g_test_add_func("/gui/autosave/size-limit", test_size_limit);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, NULL);
}
