/* Lists of points as texts: "0 0; 1 0; 0 1", in SI, or with units and a comma in each point: "1 ft, 0; 2 ft, 3 in". */
#ifndef TINKER_CORE_POINT_TEXT_H
#define TINKER_CORE_POINT_TEXT_H

#include <glib.h>
#include <tinker/types.h>

/* More points than this are no outline that anybody gives. */
#define TINKER_MOST_POINTS 1000

/* The points of a text, x and y by turns, in SI. An empty text has none. NULL with an error (TINKER_UNITS_ERROR_SYNTAX)
 * that says which point is wrong. Element: double. (transfer full) */
GArray *tinker_point_text_parse(const char *text, TinkerDimension dimension, GError **error);

/* The text of `count` points, plain numbers with the fewest digits that read back as they are. (transfer full) */
char *tinker_point_text_new(const double *points, int32_t count);

#endif
