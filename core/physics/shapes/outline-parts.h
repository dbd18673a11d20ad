/* An outline of corners as shapes take it: in order, without corners that are none, and cut into triangles. */
#ifndef TINKER_CORE_OUTLINE_PARTS_H
#define TINKER_CORE_OUTLINE_PARTS_H

#include <glib.h>
#include <stdint.h>

/* Writes the corners (2 each) of a simple polygon, given round its outline either way, counter-clockwise and relative
 * to `origin`, without those that lie on the line through their neighbours. Answers how many these are. */
int32_t tinker_outline_normalise(const double *points, int32_t count, const double origin[2], double *corners);

/* Whether none of its corners, counter-clockwise, turns inwards. */
gboolean tinker_outline_is_convex(const double *corners, int32_t count);

/* Cuts a simple polygon, counter-clockwise, into count - 2 triangles, counter-clockwise, of its own corners: 6 doubles
 * each. The same outline gives the same triangles. Source: G. H. Meisters, "Polygons have ears", Amer. Math. Monthly 82
 * (1975) 648-651. */
void tinker_outline_cut(const double *corners, int32_t count, double *triangles);

#endif
