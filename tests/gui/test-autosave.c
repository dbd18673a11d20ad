/* Nothing is lost: processes that are killed while a scene is not saved, and what is there when the next one starts. */
#include <errno.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utime.h>

#include "common/program/program-start.h"
#include "files-fixture.h"
#include "gui/document/autosave.h"
#include "gui/document/recovery.h"
#include "gui/document/session.h"
#include "plugin/call/call.h"
#include "plugin/call/crash.h"

#define PATIENCE (30 * G_USEC_PER_SEC)

/* The process that is killed --------------------------------------------------------------------------------------- */

/* Edits the scene in the file, and waits for its end, as if a plugin were at work. */
static void edit_until_killed(const char *path)
{
    TinkerPluginCall call = {.phase = "draw", .path = "/plugins/bad.so"};
    tinker_crash_watch("tinker-gui");
    tinker_recovery_note_crashes();
    tinker_call_enter(&call);
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_document_open(document, path, NULL, NULL));
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    files_fixture_rename(document, "Not saved");
    for (;;)
        g_main_context_iteration(NULL, TRUE);
}

static GPid start_child(const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *program = g_file_read_link("/proc/self/exe", NULL);
    char *words[] = {program, (char *)"child", (char *)path, NULL};
    g_auto(GStrv) environment = g_environ_setenv(g_get_environ(), "TINKER_AUTOSAVE_SECONDS", "0.02", TRUE);
    GPid pid;
    g_spawn_async(NULL, words, environment, G_SPAWN_DO_NOT_REAP_CHILD, NULL, NULL, &pid, &error);
    g_assert_no_error(error);
    return pid;
}

static guint count_in(const char *folder, const char *ending)
{
    guint count = 0;
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *name = dir != NULL ? g_dir_read_name(dir) : NULL; name != NULL; name = g_dir_read_name(dir))
        if (g_str_has_suffix(name, ending)) count++;
    return count;
}

static guint count_copies(void)
{
    g_autofree char *folder = tinker_session_folder();
    return count_in(folder, TINKER_AUTOSAVE_ENDING);
}

static void wait_for_copies(guint count)
{
    gint64 end = g_get_monotonic_time() + PATIENCE;
    while (count_copies() < count && g_get_monotonic_time() < end)
        g_usleep(2000);
    g_assert_cmpuint(count_copies(), ==, count);
}

static void kill_child(GPid pid)
{
    g_assert_cmpint(kill(pid, SIGKILL), ==, 0);
    g_assert_cmpint(waitpid(pid, NULL, 0), ==, pid);
}

/* A scene whose editor was killed before it was saved. (transfer full) */
static char *crash(void)
{
    char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    guint before = count_copies();
    GPid pid = start_child(path);
    wait_for_copies(before + 1);
    kill_child(pid);
    return path;
}

static void discard_all(void)
{
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    for (guint i = 0; i < list->len; i++)
        g_assert_true(tinker_recovery_discard(list->pdata[i], NULL));
    g_assert_cmpuint(count_copies(), ==, 0);
}

/* Tests ------------------------------------------------------------------------------------------------------------ */

static void test_crash(void)
{
    g_autoptr(GError) error = NULL;
    gint64 before = g_get_real_time() / G_USEC_PER_SEC;
    g_autofree char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    GPid pid = start_child(path);
    wait_for_copies(1);
    g_autoptr(GPtrArray) alive = tinker_recovery_list();
    g_assert_cmpuint(alive->len, ==, 0);
    kill_child(pid);

    g_autoptr(GPtrArray) list = tinker_recovery_list();
    g_assert_cmpuint(list->len, ==, 1);
    TinkerRecovery *recovery = g_ptr_array_index(list, 0);
    g_assert_cmpstr(recovery->name, ==, "A swing");
    g_assert_cmpstr(recovery->origin.path, ==, path);
    g_assert_cmpint(recovery->time, >=, before);
    g_assert_cmpint(recovery->time, <=, g_get_real_time() / G_USEC_PER_SEC);

    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    tinker_recovery_open(recovery, document, &error);
    g_assert_no_error(error);
    g_assert_cmpstr(files_fixture_first_name(document), ==, "Not saved");
    g_assert_cmpstr(tinker_document_path(document), ==, path);
    g_assert_true(tinker_document_is_modified(document));
    g_assert_false(tinker_document_changed_on_disk(document));

    g_assert_true(tinker_autosave_now(autosave));
    tinker_recovery_remove(recovery);
    g_assert_cmpuint(count_copies(), ==, 1);
    g_assert_true(tinker_document_save(document, path, &error));
    g_assert_cmpuint(count_copies(), ==, 0);
    g_autoptr(TinkerDocument) reopened = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_document_open(reopened, path, NULL, NULL));
    g_assert_cmpstr(files_fixture_first_name(reopened), ==, "Not saved");
}

#define BLAME "the library /plugins/bad.so crashed (SIGSEGV) in \"draw\""

/* A child with unsaved changes crashes. */
static void crash_one(const char *path)
{
    GPid pid = start_child(path);
    wait_for_copies(1);
    g_assert_cmpint(kill(pid, SIGSEGV), ==, 0);
    int status;
    g_assert_cmpint(waitpid(pid, &status, 0), ==, pid);
    g_assert_true(WIFSIGNALED(status));
    g_assert_cmpint(WTERMSIG(status), ==, SIGSEGV);
}

/* Where all was saved there is no copy, but the message is told, once. */
static void test_blame_alone(void)
{
    g_autofree char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    crash_one(path);
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    const char *stem = ((TinkerRecovery *)g_ptr_array_index(list, 0))->stem;
    g_autofree char *copy = g_strconcat(stem, TINKER_AUTOSAVE_ENDING, NULL);
    g_autofree char *info = g_strconcat(stem, TINKER_AUTOSAVE_INFO, NULL);
    g_assert_cmpint(g_unlink(copy), ==, 0);
    g_assert_cmpint(g_unlink(info), ==, 0);
    g_autofree char *blame = tinker_recovery_take_blame();
    g_assert_cmpstr(blame, ==, BLAME);
    g_assert_null(tinker_recovery_take_blame());
}

/* A crash leaves the copy as it was, and beside it who was at work. */
static void test_blame(void)
{
    g_autofree char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    crash_one(path);
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    g_assert_cmpuint(list->len, ==, 1);
    TinkerRecovery *recovery = g_ptr_array_index(list, 0);
    g_assert_cmpstr(recovery->blame, ==, BLAME);
    g_autoptr(TinkerDocument) document = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_recovery_open(recovery, document, NULL));
    g_assert_cmpstr(files_fixture_first_name(document), ==, "Not saved");
    tinker_recovery_remove(recovery);

    /* One that was killed from outside is nobody's fault. */
    GPid pid = start_child(path);
    wait_for_copies(1);
    kill_child(pid);
    g_autoptr(GPtrArray) killed = tinker_recovery_list();
    g_assert_null(((TinkerRecovery *)g_ptr_array_index(killed, 0))->blame);
    discard_all();
}

static void test_nothing_left_behind(void)
{
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    g_autofree char *folder = tinker_session_folder(), *saved = files_fixture_folder();
    g_autofree char *path = g_build_filename(saved, "a.tinker.json", NULL);
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpuint(count_copies(), ==, 0);

    files_fixture_rename(document, "One");
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpuint(count_copies(), ==, 1);
    tinker_document_undo(document);
    g_assert_cmpuint(count_copies(), ==, 0);
    tinker_document_redo(document);
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpuint(count_copies(), ==, 1);
    g_assert_true(tinker_document_save(document, path, NULL));
    g_assert_cmpuint(count_copies(), ==, 0);

    files_fixture_rename(document, "Two");
    g_assert_true(tinker_autosave_now(autosave));
    tinker_autosave_forget(autosave);
    g_assert_cmpuint(count_copies(), ==, 0);
    tinker_recovery_purge();
    g_assert_cmpuint(count_in(folder, ""), ==, 0);
}

static void test_timer(void)
{
    g_setenv("TINKER_AUTOSAVE_SECONDS", "0.02", TRUE);
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    files_fixture_rename(document, "One");
    gint64 end = g_get_monotonic_time() + PATIENCE;
    while (count_copies() == 0 && g_get_monotonic_time() < end)
        g_main_context_iteration(NULL, TRUE);
    g_assert_cmpuint(count_copies(), ==, 1);
    tinker_autosave_forget(autosave);
    g_unsetenv("TINKER_AUTOSAVE_SECONDS");
}

static void test_discard(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = crash(), *folder = tinker_recovery_discarded_folder(), *text = NULL;
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    TinkerRecovery *recovery = g_ptr_array_index(list, 0);
    tinker_recovery_discard(recovery, &error);
    g_assert_no_error(error);
    g_autoptr(GPtrArray) after = tinker_recovery_list();
    g_assert_cmpuint(after->len, ==, 0);

    tinker_recovery_purge();
    g_autofree char *kept = g_strconcat(recovery->stem, TINKER_AUTOSAVE_ENDING, NULL);
    g_assert_true(g_file_get_contents(kept, &text, NULL, NULL));
    g_assert_nonnull(strstr(text, "Not saved"));
    const time_t day = 24 * 3600, now = time(NULL);
    const struct utimbuf almost = {now - 7 * day + 60, now - 7 * day + 60},
                         over = {now - 7 * day - 60, now - 7 * day - 60};
    g_assert_cmpint(g_utime(kept, (struct utimbuf *)&almost), ==, 0);
    tinker_recovery_purge();
    g_assert_true(g_file_test(kept, G_FILE_TEST_EXISTS));
    g_assert_cmpint(g_utime(kept, (struct utimbuf *)&over), ==, 0);
    tinker_recovery_purge();
    g_assert_false(g_file_test(kept, G_FILE_TEST_EXISTS));
}

/* Both were killed, and both find both: each scene is had once. */
static void test_two_processes(void)
{
    g_autofree char *first = crash(), *second = crash();
    g_autoptr(GPtrArray) one = tinker_recovery_list(), other = tinker_recovery_list();
    g_assert_cmpuint(one->len, ==, 2);
    g_assert_cmpuint(other->len, ==, 2);
    for (guint i = 0; i < 2; i++) {
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerDocument) document = files_fixture_document(), late = files_fixture_document();
        g_assert_true(tinker_recovery_open(one->pdata[i], document, NULL));
        g_assert_cmpstr(files_fixture_first_name(document), ==, "Not saved");
        g_assert_false(tinker_recovery_open(other->pdata[i], late, &error));
        g_assert_error(error, G_FILE_ERROR, G_FILE_ERROR_NOENT);
        g_assert_cmpstr(files_fixture_first_name(late), ==, "Ceiling");
        g_assert_false(tinker_document_is_modified(late));
    }
    g_autoptr(GPtrArray) rest = tinker_recovery_list();
    g_assert_cmpuint(rest->len, ==, 0);
    for (guint i = 0; i < 2; i++)
        tinker_recovery_remove(one->pdata[i]);
    g_assert_cmpuint(count_copies(), ==, 0);
}

/* A copy that is not a scene is told of, and stays. */
static void test_broken_copy(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = crash();
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    TinkerRecovery *recovery = g_ptr_array_index(list, 0);
    g_autofree char *copy = g_strconcat(recovery->stem, TINKER_AUTOSAVE_ENDING, NULL);
    g_autofree char *info = g_strconcat(recovery->stem, TINKER_AUTOSAVE_INFO, NULL);
    g_assert_true(g_file_set_contents(copy, "{\"tinker\": 1, \"blocks\": [", -1, NULL));
    g_assert_true(g_file_set_contents(info, "\xff no companion", -1, NULL));
    g_autoptr(GPtrArray) again = tinker_recovery_list();
    g_assert_cmpuint(again->len, ==, 1);
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_assert_false(tinker_recovery_open(again->pdata[0], document, &error));
    g_assert_nonnull(error);
    g_assert_cmpstr(files_fixture_first_name(document), ==, "Ceiling");
    g_assert_true(g_file_test(copy, G_FILE_TEST_EXISTS));
    discard_all();
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
    g_assert_cmpuint(count_copies(), ==, 1);
    tinker_autosave_forget(autosave);
}

/* Copies of another run that had the same process number, as in another container: none is written over, and all are
 * found. */
static void test_same_number(void)
{
    enum { COPIES = 9 };
    static const char copy[] = "{\"tinker\": 1, \"title\": \"of another run\"}";
    g_autofree char *folder = tinker_session_folder();
    g_autoptr(TinkerDocument) document = files_fixture_document();
    g_autoptr(TinkerAutosave) autosave = tinker_autosave_new(document);
    g_assert_cmpint(g_mkdir_with_parents(folder, 0700), ==, 0);
    for (int i = 1; i <= COPIES; i++) {
        g_autofree char *path = g_strdup_printf("%s/%d-%d" TINKER_AUTOSAVE_ENDING, folder, (int)getpid(), i);
        g_assert_true(g_file_set_contents(path, copy, -1, NULL));
    }
    files_fixture_rename(document, "One");
    g_assert_true(tinker_autosave_now(autosave));
    g_assert_cmpuint(count_copies(), ==, COPIES + 1);
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    g_assert_cmpuint(list->len, ==, COPIES);
    for (guint i = 0; i < list->len; i++) {
        const TinkerRecovery *recovery = list->pdata[i];
        g_autofree char *path = g_strconcat(recovery->stem, TINKER_AUTOSAVE_ENDING, NULL), *text = NULL;
        g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
        g_assert_cmpstr(text, ==, copy);
    }
    tinker_autosave_forget(autosave);
    discard_all();
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
    g_assert_cmpuint(count_copies(), ==, 0);
    tinker_autosave_forget(autosave);
    g_assert_cmpuint(count_in(folder, ""), ==, 0);
}

/* One that was killed while it wrote leaves a part of the copy, which is removed at the next start; and its lock. */
static void test_part_of_copy(void)
{
    g_autofree char *folder = tinker_session_folder(), *path = crash();
    g_autofree char *part = g_build_filename(folder, ".tinker-part-A1B2C3", NULL);
    g_assert_true(g_file_set_contents(part, "{\"tinker\"", -1, NULL));
    tinker_recovery_purge();
    g_assert_false(g_file_test(part, G_FILE_TEST_EXISTS));
    g_assert_cmpuint(count_in(folder, TINKER_SESSION_LOCK), ==, 1);
    discard_all();
    tinker_recovery_purge();
    g_assert_cmpuint(count_in(folder, ""), ==, 0);
}

static void add_tests(void)
{
    g_test_add_func("/gui/autosave/crash", test_crash);
    g_test_add_func("/gui/autosave/blame", test_blame);
    g_test_add_func("/gui/autosave/blame-alone", test_blame_alone);
    g_test_add_func("/gui/autosave/nothing-left-behind", test_nothing_left_behind);
    g_test_add_func("/gui/autosave/timer", test_timer);
    g_test_add_func("/gui/autosave/discard", test_discard);
    g_test_add_func("/gui/autosave/two-processes", test_two_processes);
    g_test_add_func("/gui/autosave/broken-copy", test_broken_copy);
    g_test_add_func("/gui/autosave/unwritable", test_unwritable);
    g_test_add_func("/gui/autosave/same-number", test_same_number);
    g_test_add_func("/gui/autosave/size-limit", test_size_limit);
    g_test_add_func("/gui/autosave/part-of-copy", test_part_of_copy);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, edit_until_killed);
}
