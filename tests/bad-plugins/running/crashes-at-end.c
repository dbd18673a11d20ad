/* Leaves a function to the end of the program that crashes. */
#include "exhibit.h"

static int *volatile nowhere;

__attribute__((no_sanitize("undefined"))) static void at_end(void)
{
    *nowhere = 1;
}

static void misbehave(const TinkerBatch *batch, double *force)
{
    static int left;
    if (!left) atexit(at_end);
    left = 1;
}

RUNNING_EXHIBIT("crashes-at-end")
