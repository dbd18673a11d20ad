/* A path in the plane with as few points as show it, for where it is drawn often: while it grows, most of it is thinned
 * already. */
#ifndef TINKER_GUI_THIN_PATH_H
#define TINKER_GUI_THIN_PATH_H

#include <glib.h>

typedef struct {
    GArray *kept;  /* of guint: points */
    GArray *x, *y; /* of double: theirs */
    gsize thinned; /* so many points were thinned together; those behind them are kept */
} TinkerThinPath;

void tinker_thin_path_init(TinkerThinPath *path);
void tinker_thin_path_clear(TinkerThinPath *path);
/* Of points of which only the last are new; there is one at least. */
void tinker_thin_path_update(TinkerThinPath *path, const double *x, const double *y, gsize count);
/* Where all are new: before the next update. */
void tinker_thin_path_forget(TinkerThinPath *path);

#endif
