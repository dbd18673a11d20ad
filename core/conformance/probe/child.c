/* Children are forked, not started anew: a fork of a small program takes less than a millisecond, and what the parent
 * knows (the catalogue, the options) need not be handed over. Nothing of the library is in the parent, so each child
 * opens it. */
#include "conformance/probe/child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define POLL_US 300
/* A child that does nothing is waited for so many times the time that it may work. */
#define WAITS_AS_LONG 6.0

static gboolean fail(GError **error, const char *what)
{
    g_set_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_FILE, "%s: %s", what, g_strerror(errno));
    return FALSE;
}

KitSheet *kit_sheet_new(GError **error)
{
    KitSheet *sheet = mmap(NULL, sizeof *sheet, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (sheet != MAP_FAILED) return sheet;
    fail(error, "no memory can be had that is shared with a child");
    return NULL;
}

void kit_sheet_free(KitSheet *sheet)
{
    if (sheet != NULL) munmap(sheet, sizeof *sheet);
}

static void silence(int errors)
{
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(errors >= 0 ? errors : nowhere, STDERR_FILENO);
}

/* A host's own last words would blame the host: here it is known whose functions are called. */
static void forget_handlers(void)
{
    static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    for (gsize i = 0; i < G_N_ELEMENTS(crashes); i++)
        signal(crashes[i], SIG_DFL);
    g_log_set_default_handler(g_log_default_handler, NULL);
}

static void be_child(KitSheet *sheet, int errors, pid_t parent, void (*work)(gpointer data), gpointer data)
{
    const struct rlimit none = {0, 0};
    setpgid(0, 0); // what the library starts is ended with it
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    setrlimit(RLIMIT_CORE, &none);
    silence(errors);
    forget_handlers();
    work(data);
    sheet->came_back = 1;
    _exit(0);
}

static void end_child(pid_t child, int *status)
{
    kill(-child, SIGKILL); // its whole group
    kill(child, SIGKILL);  // and itself, where it has not joined it yet
    while (waitpid(child, status, 0) < 0 && errno == EINTR) {
    }
}

static gboolean has_ended(pid_t child)
{
    siginfo_t info = {0};
    return waitid(P_PID, (id_t)child, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
}

static double processor_time(pid_t child)
{
    clockid_t clock;
    struct timespec used;
    if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &used) != 0) return 0;
    return (double)used.tv_sec + 1e-9 * (double)used.tv_nsec;
}

/* FALSE where the time was up: that which the child worked itself, so that a machine that does other things, too, makes
 * nothing hang; or many times as long for one that waits. In the end its group is ended, with what it left behind,
 * while the child is not reaped yet: so long nobody else can have its number. */
static gboolean wait_for(pid_t child, double seconds, int *status)
{
    const double most = CLAMP(seconds, 0, 3600);
    const gint64 deadline = g_get_monotonic_time() + (gint64)(WAITS_AS_LONG * most * G_USEC_PER_SEC);
    gboolean ended = has_ended(child);
    while (!ended && processor_time(child) <= most && g_get_monotonic_time() <= deadline) {
        g_usleep(POLL_US);
        ended = has_ended(child);
    }
    end_child(child, status);
    return ended;
}

/* The last line that says something, in brackets: an assertion, or a sanitizer's finding. */
static void last_words(int errors, char words[256])
{
    char text[4096];
    words[0] = '\0';
    if (errors < 0) return;
    const off_t size = lseek(errors, 0, SEEK_END);
    const off_t from = MAX(size - (off_t)sizeof text + 1, 0);
    const ssize_t got = pread(errors, text, sizeof text - 1, from);
    if (got <= 0) return;
    text[got] = '\0';
    g_autofree char *valid = g_utf8_make_valid(text, got);
    g_strchomp(valid);
    const char *line = strrchr(valid, '\n');
    line = line == NULL ? valid : line + 1;
    if (*line != '\0') g_snprintf(words, 256, " (%.200s)", line);
}

static void judge(KitSheet *sheet, gboolean in_time, int status, double seconds, int errors)
{
    char words[256], where[KIT_PHASE_SIZE + 8] = "";
    if (sheet->decided) return;
    if (sheet->phase[0] != '\0') g_snprintf(where, sizeof where, " in %s", sheet->phase);
    sheet->outcome = TINKER_CONFORMANCE_FAILED;
    sheet->decided = 1;
    if (!in_time) {
        g_snprintf(sheet->text, sizeof sheet->text, "hung: not done within %g s%s", seconds, where);
    } else if (WIFSIGNALED(status)) {
        const char *name = sigabbrev_np(WTERMSIG(status));
        last_words(errors, words);
        g_snprintf(sheet->text, sizeof sheet->text, "crashed: SIG%s%s%s", name == NULL ? "?" : name, where, words);
    } else if (sheet->came_back) {
        sheet->outcome = TINKER_CONFORMANCE_PASSED;
    } else {
        last_words(errors, words);
        g_snprintf(sheet->text, sizeof sheet->text, "ended the process%s, with status %d%s", where, WEXITSTATUS(status),
                   words);
    }
}

gboolean kit_child_run(KitSheet *sheet, double seconds, void (*work)(gpointer data), gpointer data, GError **error)
{
    memset(sheet, 0, sizeof *sheet);
    fflush(NULL); // what is buffered is written once
    const int errors = memfd_create("errors", MFD_CLOEXEC);
    const pid_t parent = getpid(), child = fork();
    if (child == 0) be_child(sheet, errors, parent, work, data);
    if (child > 0) {
        setpgid(child, child);
        int status = 0;
        const gboolean in_time = wait_for(child, seconds, &status);
        judge(sheet, in_time, status, seconds, errors);
    } else {
        fail(error, "no process can be had for a check");
    }
    if (errors >= 0) close(errors);
    return child > 0;
}
