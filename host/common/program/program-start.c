/* What every program of ours begins with. */
#include "common/program/program-start.h"

#include <malloc.h>
#include <signal.h>

#include "plugin/call/crash.h"

void tinker_program_start(const char *name)
{
    tinker_crash_watch(name);
    tinker_crash_watch_memory();
    // It may be inherited as ignored: then a child that has ended leaves nothing to be waited for.
    signal(SIGCHLD, SIG_DFL);
    // A write beyond the limit of a file's size then fails with EFBIG, and is told as that of a full disk is.
    signal(SIGXFSZ, SIG_IGN);
    // Small pieces of memory that are freed are joined at once, not in turns over all of them: a run of very many
    // islands takes a fifth less (100000 oscillators with their companion 4.2 s in place of 5.3 s).
    mallopt(M_MXFAST, 0);
}
