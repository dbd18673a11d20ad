/* Never comes back; says on standard output when that begins. */
#include <unistd.h>

#include "exhibit.h"

static volatile int forever = 1;

static void misbehave(const TinkerBatch *batch, double *force)
{
    if (write(STDOUT_FILENO, "hangs\n", 6) != 6) abort();
    while (forever)
        force[0] += 1;
}

RUNNING_EXHIBIT("hangs")
