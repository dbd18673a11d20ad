/* What the curves of one graph are called: no more words than tell them apart. */
#ifndef TINKER_COMMON_GRAPH_NAMES_H
#define TINKER_COMMON_GRAPH_NAMES_H

#include <glib.h>

/* A curve, in the language of whoever reads it. Borrowed. */
typedef struct {
    const char *block; /* "Mass 0"; "": none, as of an expression */
    const char *title; /* "Y Position" */
} TinkerCurveName;

/* Of a graph of these curves, at least one: "Mass 0: Y Position", "Mass 0: Y Position, Y Velocity", "Y Position: Mass
 * 0, Mass 1", or all in full. (transfer full) */
char *tinker_curves_title(const TinkerCurveName *curves, guint count);

/* A curve beside these: "Mass 0: Y Position", or "Y Position" where all are of one block. (transfer full) */
char *tinker_curve_name(const TinkerCurveName *curve, const TinkerCurveName *curves, guint count);

/* A curve in their legend, where the axis tells of what: likewise, or "Mass 0" where all are of one quantity. (transfer
 * full) */
char *tinker_curve_legend(const TinkerCurveName *curve, const TinkerCurveName *curves, guint count);

#endif
