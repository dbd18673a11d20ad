/* Times in rising order. */
#ifndef TINKER_UNITS_TIMES_H
#define TINKER_UNITS_TIMES_H

#include <glib.h>

/* How many of them are not later than t (s); what is repeated counts as often as it stands there. */
static inline gsize tinker_times_until(const double *times, gsize count, double t)
{
    gsize low = 0, high = count;
    while (low < high) {
        const gsize middle = low + (high - low) / 2;
        if (times[middle] <= t)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

#endif
