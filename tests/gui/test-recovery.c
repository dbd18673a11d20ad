/* Nothing is lost: processes that are killed while a scene is not saved, and what is there when the next one starts. */
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utime.h>

#include "copies-fixture.h"
#include "gui/document/autosave.h"
#include "gui/document/recovery.h"
#include "gui/document/session.h"

#define BLAME "the library /plugins/bad.so crashed (SIGSEGV) in \"draw\""

static void test_crash(void)
{
    g_autoptr(GError) error = NULL;
    gint64 before = g_get_real_time() / G_USEC_PER_SEC;
    g_autofree char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    GPid pid = copies_start_child(path);
    copies_wait_for(1);
    g_autoptr(GPtrArray) alive = tinker_recovery_list();
    g_assert_cmpuint(alive->len, ==, 0);
    copies_kill_child(pid);

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
    g_assert_cmpuint(copies_count(), ==, 1);
    g_assert_true(tinker_document_save(document, path, &error));
    g_assert_cmpuint(copies_count(), ==, 0);
    g_autoptr(TinkerDocument) reopened = tinker_document_new(files_fixture_catalogue());
    g_assert_true(tinker_document_open(reopened, path, NULL, NULL));
    g_assert_cmpstr(files_fixture_first_name(reopened), ==, "Not saved");
}

/* A child with unsaved changes crashes. */
static void crash_one(const char *path)
{
    GPid pid = copies_start_child(path);
    copies_wait_for(1);
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
    GPid pid = copies_start_child(path);
    copies_wait_for(1);
    copies_kill_child(pid);
    g_autoptr(GPtrArray) killed = tinker_recovery_list();
    g_assert_null(((TinkerRecovery *)g_ptr_array_index(killed, 0))->blame);
    copies_discard_all();
}

static void test_discard(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = copies_crash(), *folder = tinker_recovery_discarded_folder(), *text = NULL;
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
    g_autofree char *first = copies_crash(), *second = copies_crash();
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
    g_assert_cmpuint(copies_count(), ==, 0);
}

/* A copy that is not a scene is told of, and stays. */
static void test_broken_copy(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = copies_crash();
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
    copies_discard_all();
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
    g_assert_cmpuint(copies_count(), ==, COPIES + 1);
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    g_assert_cmpuint(list->len, ==, COPIES);
    for (guint i = 0; i < list->len; i++) {
        const TinkerRecovery *recovery = list->pdata[i];
        g_autofree char *path = g_strconcat(recovery->stem, TINKER_AUTOSAVE_ENDING, NULL), *text = NULL;
        g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
        g_assert_cmpstr(text, ==, copy);
    }
    tinker_autosave_forget(autosave);
    copies_discard_all();
}

/* One that was killed while it wrote leaves a part of the copy, which is removed at the next start; and its lock. */
static void test_part_of_copy(void)
{
    g_autofree char *folder = tinker_session_folder(), *path = copies_crash();
    g_autofree char *part = g_build_filename(folder, ".tinker-part-A1B2C3", NULL);
    g_assert_true(g_file_set_contents(part, "{\"tinker\"", -1, NULL));
    tinker_recovery_purge();
    g_assert_false(g_file_test(part, G_FILE_TEST_EXISTS));
    g_assert_cmpuint(copies_count_in(folder, TINKER_SESSION_LOCK), ==, 1);
    copies_discard_all();
    tinker_recovery_purge();
    g_assert_cmpuint(copies_count_in(folder, ""), ==, 0);
}

static void add_tests(void)
{
    g_test_add_func("/gui/recovery/crash", test_crash);
    g_test_add_func("/gui/recovery/blame", test_blame);
    g_test_add_func("/gui/recovery/blame-alone", test_blame_alone);
    g_test_add_func("/gui/recovery/discard", test_discard);
    g_test_add_func("/gui/recovery/two-processes", test_two_processes);
    g_test_add_func("/gui/recovery/broken-copy", test_broken_copy);
    g_test_add_func("/gui/recovery/same-number", test_same_number);
    g_test_add_func("/gui/recovery/part-of-copy", test_part_of_copy);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, copies_edit_until_killed);
}
