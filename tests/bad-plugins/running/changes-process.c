/* Changes all that a process has one of, in its `prepare`: what reads and writes numbers and files after it shows that.
 */
#include <fenv.h>
#include <locale.h>
#include <signal.h>
#include <sys/stat.h>

#include "exhibit.h"

static void misbehave(const TinkerBatch *batch, double *force) {}

static TinkerStatus prepare(TinkerBatch *batch)
{
    setlocale(LC_ALL, "de_DE.UTF-8");
    umask(0777);
    fesetround(FE_UPWARD);
    feenableexcept(FE_INEXACT);
    signal(SIGTERM, SIG_IGN);
    return TINKER_OK;
}

EXHIBIT_OF_PHYSICS("changes-process", .force_element = &exhibit_element, .prepare = prepare)
