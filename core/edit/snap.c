/* Snapping to a square grid through the world's origin. */
#include <math.h>

#include "edit/drag.h"

static double snapped(double grid, double value)
{
    /* Where the grid is finer than the digits of the value, the value is as good as on it. */
    double steps = round(value / grid);
    return fabs(steps) < 4503599627370496.0 ? steps * grid : value;
}

void tinker_snap(double grid, double *x, double *y)
{
    if (!(grid > 0) || !isfinite(grid)) return;
    *x = snapped(grid, *x);
    *y = snapped(grid, *y);
}
