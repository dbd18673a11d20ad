/* Thinning a path in the plane: the points that are enough to draw it. No widget. */
#ifndef TINKER_GUI_PATH_THIN_H
#define TINKER_GUI_PATH_THIN_H

#include <glib.h>

/* Appends the numbers (guint) of those points to `kept` from which the others are no farther than twice the tolerances,
 * along x and y: the first, the last, all at bends, and all about a NaN. Takes time in proportion to `count`. */
void tinker_path_thin(const double *x, const double *y, gsize count, const double tolerance[2], GArray *kept);

#endif
