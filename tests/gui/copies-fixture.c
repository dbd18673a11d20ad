#include "copies-fixture.h"

#include <signal.h>
#include <sys/wait.h>

#include "gui/document/autosave.h"
#include "gui/document/recovery.h"
#include "gui/document/session.h"
#include "plugin/call/call.h"
#include "plugin/call/crash.h"

void copies_edit_until_killed(const char *path)
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

GPid copies_start_child(const char *path)
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

guint copies_count_in(const char *folder, const char *ending)
{
    guint count = 0;
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    for (const char *name = dir != NULL ? g_dir_read_name(dir) : NULL; name != NULL; name = g_dir_read_name(dir))
        if (g_str_has_suffix(name, ending)) count++;
    return count;
}

guint copies_count(void)
{
    g_autofree char *folder = tinker_session_folder();
    return copies_count_in(folder, TINKER_AUTOSAVE_ENDING);
}

void copies_wait_for(guint count)
{
    gint64 end = g_get_monotonic_time() + COPIES_PATIENCE;
    while (copies_count() < count && g_get_monotonic_time() < end)
        g_usleep(2000);
    g_assert_cmpuint(copies_count(), ==, count);
}

void copies_kill_child(GPid pid)
{
    g_assert_cmpint(kill(pid, SIGKILL), ==, 0);
    g_assert_cmpint(waitpid(pid, NULL, 0), ==, pid);
}

char *copies_crash(void)
{
    char *path = files_fixture_file("swing.tinker.json", files_fixture_scene);
    guint before = copies_count();
    GPid pid = copies_start_child(path);
    copies_wait_for(before + 1);
    copies_kill_child(pid);
    return path;
}

void copies_discard_all(void)
{
    g_autoptr(GPtrArray) list = tinker_recovery_list();
    for (guint i = 0; i < list->len; i++)
        g_assert_true(tinker_recovery_discard(list->pdata[i], NULL));
    g_assert_cmpuint(copies_count(), ==, 0);
}
