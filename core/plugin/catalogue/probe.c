/* The probe's parent side: start, read both outputs until the child is gone or the time is up, and judge the end. */
#include "plugin/catalogue/probe-private.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "plugin/call/process-end.h"
#include "plugin/trust/refuse.h"

/* A manifest has a few kB; a library that writes more than this is not describing itself. */
#define MOST_OUTPUT (1 << 20)

/* Exit statuses by which the program or the shell says that it did not come to look at the library. */
#define STATUS_USAGE     2
#define STATUS_NOT_RUN   126
#define STATUS_NOT_FOUND 127

typedef struct {
    GPid process;
    GString *text[2]; /* standard output, standard error */
    int pipes[2];     /* -1: closed */
    gint64 deadline;  /* by g_get_monotonic_time */
    int status;       /* as waitpid gives it */
} Probe;

typedef enum { PROBE_ENDED, PROBE_TIME_UP, PROBE_TOO_MUCH } ProbeEnd;

/* Runs in the child between fork and exec: system calls alone. */
static void prepare_child(gpointer data)
{
    const struct rlimit none = {0, 0};
    setpgid(0, 0); // what the library starts is ended with it
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setrlimit(RLIMIT_CORE, &none);
}

static gboolean start(Probe *probe, const char *program, const char *path, GError **error)
{
    const char *const arguments[] = {program, "plugins", "describe", "--output", "-", path, NULL};
    g_autoptr(GError) reason = NULL;
    if (g_spawn_async_with_pipes(NULL, (char **)arguments, NULL, G_SPAWN_DO_NOT_REAP_CHILD, prepare_child, NULL,
                                 &probe->process, NULL, &probe->pipes[0], &probe->pipes[1], &reason))
        return TRUE;
    return tinker_fail_file(error, "it could not be probed: %s", reason->message);
}

static int milliseconds_left(const Probe *probe)
{
    const gint64 left = (probe->deadline - g_get_monotonic_time() + 999) / 1000;
    return (int)CLAMP(left, 0, G_MAXINT);
}

static void read_pipe(Probe *probe, int number)
{
    char buffer[4096];
    const gssize got = read(probe->pipes[number], buffer, sizeof buffer);
    if (got > 0) {
        g_string_append_len(probe->text[number], buffer, got);
    } else if (got == 0 || errno != EINTR) {
        close(probe->pipes[number]);
        probe->pipes[number] = -1;
    }
}

static ProbeEnd read_outputs(Probe *probe)
{
    while (probe->pipes[0] >= 0 || probe->pipes[1] >= 0) {
        const int left = milliseconds_left(probe);
        if (left == 0) return PROBE_TIME_UP;
        struct pollfd polled[2] = {{probe->pipes[0], POLLIN, 0}, {probe->pipes[1], POLLIN, 0}};
        if (poll(polled, 2, left) <= 0) continue;
        for (int i = 0; i < 2; i++) {
            if (polled[i].revents != 0) read_pipe(probe, i);
        }
        if (probe->text[0]->len + probe->text[1]->len > MOST_OUTPUT) return PROBE_TOO_MUCH;
    }
    return PROBE_ENDED;
}

/* A child can close its outputs and live on. */
static ProbeEnd wait_for_end(Probe *probe)
{
    while (waitpid(probe->process, &probe->status, WNOHANG) == 0) {
        if (milliseconds_left(probe) == 0) return PROBE_TIME_UP;
        g_usleep(500);
    }
    return PROBE_ENDED;
}

static void end_child(Probe *probe)
{
    kill(-probe->process, SIGKILL); // its whole group
    kill(probe->process, SIGKILL);  // and itself, where it has not joined it yet
    while (waitpid(probe->process, &probe->status, 0) < 0 && errno == EINTR) {
    }
}

/* The last line of standard error that says something, without the names of program and library before it. */
static char *last_line(const char *text, const char *path)
{
    g_autofree char *valid = g_utf8_make_valid(text, -1);
    g_strchomp(valid);
    const char *line = strrchr(valid, '\n');
    line = line == NULL ? valid : line + 1;
    g_autofree char *prefix = g_strdup_printf("%s: ", path);
    const char *found = strstr(line, prefix);
    return g_strdup(found == NULL ? line : found + strlen(prefix));
}

static gboolean judge_exit(const Probe *probe, const char *program, const char *path, GError **error)
{
    const int status = WEXITSTATUS(probe->status);
    if (status == 0) return TRUE;
    g_autofree char *reason = last_line(probe->text[1]->str, path);
    if (status == TINKER_STATUS_FILE && reason[0] != '\0') return tinker_fail_file(error, "%s", reason);
    if (status == STATUS_USAGE || status == TINKER_STATUS_FILE || status == STATUS_NOT_RUN ||
        status == STATUS_NOT_FOUND)
        return tinker_fail_file(error, "it could not be probed: \"%s\" ended with status %d: %s", program, status,
                                reason);
    if (reason[0] != '\0') return tinker_refuse(error, "%s", reason);
    return tinker_refuse(error, "it ended the program that probed it, with status %d", status);
}

static gboolean judge(const Probe *probe, ProbeEnd end, double seconds, const char *program, const char *path,
                      GError **error)
{
    if (end == PROBE_TIME_UP)
        return tinker_refuse(error, "it hung: it was not ready within the time limit of %g s", seconds);
    if (end == PROBE_TOO_MUCH)
        return tinker_refuse(error, "it wrote more than %d bytes while it was probed", MOST_OUTPUT);
    if (WIFSIGNALED(probe->status)) {
        const char *name = sigabbrev_np(WTERMSIG(probe->status));
        return tinker_refuse(error, "it crashed while it was probed: SIG%s", name == NULL ? "?" : name);
    }
    return judge_exit(probe, program, path, error);
}

char *tinker_probe(const char *program, const char *path, double seconds, GError **error)
{
    Probe probe = {.deadline = g_get_monotonic_time() + (gint64)(MIN(seconds, 3600) * G_USEC_PER_SEC)};
    if (!start(&probe, program, path, error)) return NULL;
    g_autoptr(GString) output = g_string_new(NULL), messages = g_string_new(NULL);
    probe.text[0] = output;
    probe.text[1] = messages;

    ProbeEnd end = read_outputs(&probe);
    if (end == PROBE_ENDED) end = wait_for_end(&probe);
    if (end != PROBE_ENDED) end_child(&probe);
    for (int i = 0; i < 2; i++) {
        if (probe.pipes[i] >= 0) close(probe.pipes[i]);
    }
    if (!judge(&probe, end, seconds, program, path, error)) return NULL;
    return g_strdup(output->str);
}
