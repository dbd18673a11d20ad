/* Looking at the numbers that a drawing gives to the helpers of its style. */
#ifndef TINKER_CONFORMANCE_WATCHED_STYLE_H
#define TINKER_CONFORMANCE_WATCHED_STYLE_H

#include <glib.h>

#include <tinker/render.h>

/* From now on the helpers of this style, one at a time, look at their numbers. */
void kit_style_watch(TinkerStyle *style);

/* The first call with a number that is not finite, "box with (x, y, ...) = (1, 2, ...)"; NULL where there was none.
 * (transfer full) */
char *kit_style_seen(void);

#endif
