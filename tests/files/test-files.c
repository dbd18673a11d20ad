/* Files as a whole and by rows, and what killed processes leave of them. The truth is what stat(2) and the bytes say.
 */
#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "files/replace-file.h"
#include "files/unfinished.h"
#include "files/write-lines.h"

typedef struct {
    char *folder;
} Fixture;

static void set_up(Fixture *fixture, gconstpointer data)
{
    fixture->folder = g_dir_make_tmp("tinker-files-XXXXXX", NULL);
}

static void tear_down(Fixture *fixture, gconstpointer data)
{
    const char *words[] = {"rm", "-r", fixture->folder, NULL};
    g_assert_true(g_spawn_sync(NULL, (char **)words, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, NULL, NULL, NULL, NULL));
    g_free(fixture->folder);
}

static char *path_of(const Fixture *fixture, const char *name)
{
    return g_build_filename(fixture->folder, name, NULL);
}

static guint count_files(const Fixture *fixture)
{
    guint count = 0;
    g_autoptr(GDir) dir = g_dir_open(fixture->folder, 0, NULL);
    while (g_dir_read_name(dir) != NULL)
        count++;
    return count;
}

static void assert_holds(const char *path, const char *text)
{
    g_autofree char *now = NULL;
    g_assert_true(g_file_get_contents(path, &now, NULL, NULL));
    g_assert_cmpstr(now, ==, text);
}

/* Replacing -------------------------------------------------------------------------------------------------------- */

static void test_replace(Fixture *fixture, gconstpointer data)
{
    g_autofree char *path = path_of(fixture, "a.txt"), *link = path_of(fixture, "link");
    g_autoptr(GError) error = NULL;
    GStatBuf status;
    const mode_t mask = umask(022);
    g_assert_true(tinker_replace_file(path, "one", 3, 0666, &error));
    umask(mask);
    g_assert_cmpint(g_stat(path, &status), ==, 0);
    g_assert_cmpint(status.st_mode & 07777, ==, 0644);
    g_assert_cmpint(g_chmod(path, 0660), ==, 0);
    g_assert_cmpint(symlink("a.txt", link), ==, 0);
    g_assert_true(tinker_replace_file(link, "another", 7, 0666, &error));
    assert_holds(path, "another");
    g_assert_cmpint(g_stat(path, &status), ==, 0);
    g_assert_cmpint(status.st_mode & 07777, ==, 0660);
    g_assert_true(g_file_test(link, G_FILE_TEST_IS_SYMLINK));
    g_assert_true(tinker_replace_file("/dev/null", "nowhere", 7, 0666, &error));
    g_assert_false(g_file_test("/dev/null", G_FILE_TEST_IS_REGULAR));
    g_assert_no_error(error);
    g_assert_cmpuint(count_files(fixture), ==, 2);
    g_assert_false(tinker_replace_file(fixture->folder, "a folder", 8, 0666, &error));
    g_assert_error(error, G_FILE_ERROR, G_FILE_ERROR_ISDIR);
    assert_holds(path, "another");
}

static void limit_files(rlim_t bytes)
{
    struct rlimit limit;
    g_assert_cmpint(getrlimit(RLIMIT_FSIZE, &limit), ==, 0);
    limit.rlim_cur = MIN(bytes, limit.rlim_max);
    g_assert_cmpint(setrlimit(RLIMIT_FSIZE, &limit), ==, 0);
}

/* One that would grow beyond what the system allows. */
static void test_limit(Fixture *fixture, gconstpointer data)
{
    g_autofree char *path = path_of(fixture, "a.txt"), *text = g_strnfill(5000, 'x');
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_replace_file(path, "old", 3, 0666, NULL));
    signal(SIGXFSZ, SIG_IGN);
    limit_files(4096);
    const gboolean done = tinker_replace_file(path, text, 5000, 0666, &error);
    limit_files(RLIM_INFINITY);
    g_assert_false(done);
    g_assert_cmpstr(error->message, ==, g_strerror(EFBIG));
    assert_holds(path, "old");
    g_assert_cmpuint(count_files(fixture), ==, 1);
}

/* Killed processes ------------------------------------------------------------------------------------------------- */

/* A process that has begun a file and a folder with a file in it, and waits. */
static GPid begin_and_wait(const Fixture *fixture)
{
    int ready[2];
    char mark;
    g_assert_cmpint(pipe(ready), ==, 0);
    const pid_t child = fork();
    if (child == 0) {
        TinkerUnfinished file, folder;
        if (!tinker_unfinished_file(&file, fixture->folder, ".gif", 0666)) _exit(1);
        if (!tinker_unfinished_folder(&folder, fixture->folder)) _exit(1);
        g_autofree char *picture = g_build_filename(folder.path, "1", NULL);
        if (!g_file_set_contents(picture, "picture", -1, NULL) || write(ready[1], "", 1) != 1) _exit(1);
        for (;;)
            pause();
    }
    g_assert_cmpint(read(ready[0], &mark, 1), ==, 1);
    close(ready[0]);
    close(ready[1]);
    return child;
}

/* What looks alike, but is somebody else's. */
static const char *const foreign[] = {".tinker-part-",     ".tinker-part-ABC",   ".tinker-part-ABCDEFG",
                                      ".tinker-partition", "tinker-part-ABCDEF", "a.txt.A1B2C3"};

static void test_killed(Fixture *fixture, gconstpointer data)
{
    g_autofree char *path = path_of(fixture, "a.txt");
    for (gsize i = 0; i < G_N_ELEMENTS(foreign); i++) {
        g_autofree char *name = path_of(fixture, foreign[i]);
        g_assert_true(g_file_set_contents(name, "foreign", -1, NULL));
    }
    const GPid child = begin_and_wait(fixture);
    const guint begun = G_N_ELEMENTS(foreign) + 2;
    tinker_unfinished_clean(fixture->folder);
    g_assert_cmpuint(count_files(fixture), ==, begun);
    g_assert_cmpint(kill(child, SIGKILL), ==, 0);
    g_assert_cmpint(waitpid(child, NULL, 0), ==, child);
    g_assert_cmpuint(count_files(fixture), ==, begun);
    g_assert_true(tinker_replace_file(path, "new", 3, 0666, NULL));
    g_assert_cmpuint(count_files(fixture), ==, G_N_ELEMENTS(foreign) + 1);
}

static void test_given_up(Fixture *fixture, gconstpointer data)
{
    TinkerUnfinished file, folder;
    g_assert_true(tinker_unfinished_file(&file, fixture->folder, "", 0666));
    g_assert_true(tinker_unfinished_folder(&folder, fixture->folder));
    g_autofree char *picture = g_build_filename(folder.path, "1", NULL), *place = path_of(fixture, "place");
    g_assert_true(g_file_set_contents(picture, "picture", -1, NULL));
    tinker_unfinished_clear(&folder);
    g_assert_true(tinker_unfinished_finish(&file, place));
    tinker_unfinished_clear(&file);
    g_assert_cmpuint(count_files(fixture), ==, 1);
    g_assert_true(g_file_test(place, G_FILE_TEST_EXISTS));
}

/* Rows ------------------------------------------------------------------------------------------------------------- */

/* A file that takes 10 bytes, for every length of a row: what is in it ends with a whole row. */
static void test_rows(Fixture *fixture, gconstpointer data)
{
    g_autofree char *path = path_of(fixture, "rows");
    signal(SIGXFSZ, SIG_IGN);
    for (gsize width = 2; width <= 12; width++) {
        g_autofree char *row = g_strnfill(width, 'x');
        g_autoptr(GString) rows = g_string_new(NULL);
        row[width - 1] = '\n';
        while (rows->len <= 10)
            g_string_append(rows, row);
        const int file = g_open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
        limit_files(10);
        const gboolean done = tinker_write_lines(file, rows->str, rows->len);
        const int reason = errno;
        limit_files(RLIM_INFINITY);
        g_assert_false(done);
        g_assert_cmpint(reason, ==, EFBIG);
        close(file);
        g_string_truncate(rows, 10 / width * width);
        assert_holds(path, rows->str);
    }
}

static void add(const char *path, void (*test)(Fixture *fixture, gconstpointer data))
{
    g_test_add(path, Fixture, NULL, set_up, test, tear_down);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    add("/files/replace", test_replace);
    add("/files/limit", test_limit);
    add("/files/killed", test_killed);
    add("/files/given-up", test_given_up);
    add("/files/rows", test_rows);
    return g_test_run();
}
