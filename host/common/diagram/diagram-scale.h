/* One scale for the arrows of a diagram, at which as many of them as can be are drawn true to it. */
#ifndef TINKER_HOST_DIAGRAM_SCALE_H
#define TINKER_HOST_DIAGRAM_SCALE_H

#include <glib.h>

#define TINKER_DIAGRAM_RATIO 20.0 /* of the longest to the shortest arrow that are drawn to scale */

/* The greatest of the sizes that is drawn to scale: those from it down to a TINKER_DIAGRAM_RATIO-th are; greater ones
 * are broken, lesser ones drawn longer than they are. Zeros do not count; 0 where there are none else. */
double tinker_diagram_greatest_to_scale(const double *sizes, gsize count);

#endif
