/* Round numbers. A tick is an integer times 1, 2 or 5 times a power of ten, and is made as decimal text and read back,
 * so that it is the double nearest to the round number in every decade. */
#include <math.h>

#include "render/plot/plot-private.h"

#define GREATEST_INTEGER 4503599627370496.0 /* 2^52: beyond, neighbouring integers are not told apart */

typedef struct {
    int mantissa; /* 1, 2 or 5 */
    int exponent;
} RoundStep;

static double decimal(gint64 digits, int exponent)
{
    char text[48];
    g_snprintf(text, sizeof text, "%" G_GINT64_FORMAT "e%d", digits, exponent);
    return g_ascii_strtod(text, NULL);
}

static RoundStep next_step(RoundStep step)
{
    if (step.mantissa == 1) return (RoundStep){2, step.exponent};
    if (step.mantissa == 2) return (RoundStep){5, step.exponent};
    return (RoundStep){1, step.exponent + 1};
}

/* Numbers of the first and the last multiple of the step in the range; FALSE where they are too large to be counted. */
static gboolean multiples(RoundStep step, double low, double high, gint64 *first, gint64 *last)
{
    double size = decimal(step.mantissa, step.exponent);
    if (!(size > 0)) return FALSE;
    double from = ceil(low / size), to = floor(high / size);
    if (!(fabs(from) < GREATEST_INTEGER) || !(fabs(to) < GREATEST_INTEGER)) return FALSE;
    *first = (gint64)from;
    *last = (gint64)to;
    /* The quotient is rounded: a multiple that lies on a border belongs to the range, one beyond it does not. */
    while (decimal((*first - 1) * step.mantissa, step.exponent) >= low)
        (*first)--;
    while (decimal(*first * step.mantissa, step.exponent) < low)
        (*first)++;
    while (decimal((*last + 1) * step.mantissa, step.exponent) <= high)
        (*last)++;
    while (decimal(*last * step.mantissa, step.exponent) > high)
        (*last)--;
    return TRUE;
}

int tinker_plot_ticks(double low, double high, int most, double *ticks, int *decimals)
{
    *decimals = 0;
    if (!isfinite(low) || !isfinite(high) || low >= high || most < 1) return 0;
    /* Half the range is finite where the range itself is not. */
    double least = 2 * ((high / 2 - low / 2) / (most + 1));
    RoundStep step = {1, (int)floor(log10(fmax(least, 1e-307))) - 1};
    gint64 first, last;
    while (!multiples(step, low, high, &first, &last) || last - first + 1 > most)
        step = next_step(step);
    int count = 0;
    for (gint64 i = first; i <= last; i++)
        ticks[count++] = i == 0 ? 0 : decimal(i * step.mantissa, step.exponent);
    *decimals = MAX(-step.exponent, 0);
    return count;
}
