#include "common/diagram/diagram-scale.h"

/* How many sizes are drawn to scale where `greatest` is the longest. */
static int count_to_scale(const double *sizes, gsize count, double greatest)
{
    int number = 0;
    for (gsize i = 0; i < count; i++)
        number += sizes[i] <= greatest && sizes[i] * TINKER_DIAGRAM_RATIO >= greatest;
    return number;
}

double tinker_diagram_greatest_to_scale(const double *sizes, gsize count)
{
    double best = 0;
    int most = 0;
    for (gsize i = 0; i < count; i++) {
        const int number = sizes[i] > 0 ? count_to_scale(sizes, count, sizes[i]) : 0;
        if (number > most || (number == most && number > 0 && sizes[i] > best)) {
            most = number;
            best = sizes[i];
        }
    }
    return best;
}
