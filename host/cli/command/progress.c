/* The progress line, and Ctrl-C. */
#include "cli/command/progress.h"

#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include "plugin/call/crash.h"

#define FIRST_SHOWN_AFTER (G_USEC_PER_SEC)
#define SHOWN_EVERY       (G_USEC_PER_SEC / 5)

static volatile sig_atomic_t interrupted;

/* The first Ctrl-C lets the run end well. Who asks again, or asks with SIGTERM, does not wait for a plugin that may
 * never come back. */
static void on_signal(int number)
{
    if (interrupted || number != SIGINT) tinker_crash_end(number);
    interrupted = 1;
}

void tinker_progress_catch_interrupt(void)
{
    interrupted = 0;
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

gboolean tinker_progress_interrupted(void *data)
{
    return interrupted != 0;
}

TinkerProgress tinker_progress_start(const char *what)
{
    return (TinkerProgress){.what = what, .started = g_get_monotonic_time(), .terminal = isatty(STDERR_FILENO) == 1};
}

static void write_line(const TinkerProgress *progress, double fraction, gint64 elapsed)
{
    double remaining = fraction > 0 ? (double)elapsed / G_USEC_PER_SEC * (1 - fraction) / fraction : 0;
    fprintf(stderr, "\r%s: %3.0f %%, about %.0f s left   ", progress->what, 100 * fraction, remaining);
    fflush(stderr);
}

void tinker_progress_update(TinkerProgress *progress, double done, double whole)
{
    if (!progress->terminal || !(whole > 0)) return;
    gint64 now = g_get_monotonic_time();
    if (now - progress->started < FIRST_SHOWN_AFTER || now - progress->shown < SHOWN_EVERY) return;
    progress->shown = now;
    write_line(progress, CLAMP(done / whole, 0, 1), now - progress->started);
}

void tinker_progress_end(TinkerProgress *progress)
{
    if (progress->shown == 0) return;
    fprintf(stderr, "\r%*s\r", 50, "");
    fflush(stderr);
    progress->shown = 0;
}

void tinker_progress_of_run(double t, double duration, void *data)
{
    tinker_progress_update((TinkerProgress *)data, t, duration);
}
