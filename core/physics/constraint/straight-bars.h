/* Bars: points that rods in one line hold in that line.
 *
 * Where one rod is as long as others end to end, as those of a bar of three masses are, no motion leads off the line:
 * the points between could only move across it if the ends came nearer. To first order nothing of this shows. The rows
 * of the rods are one too many along the line and say nothing across it, and no finite tension holds a load there; rods
 * that give way a little would carry it with tensions that grow without bound as they are made stiffer, and what they
 * move like in the end is a straight bar. So each point between the ends of such a bar gets a row of its own,
 *
 *     h = (p - a) x (c - a) / L = h at the start,
 *
 * with a and c the ends of the bar, L apart, and p the point: its distance from the line through them. With these rows
 * all motions that the rods allow are determined to first order. Source: Connelly, Whiteley, "Second-order rigidity and
 * prestress stability for tensegrity frameworks", SIAM J. Discrete Math. 9 (1996) 453-491: a self-stress of one sign
 * across the line blocks every motion off it. */
#ifndef TINKER_CORE_STRAIGHT_BARS_H
#define TINKER_CORE_STRAIGHT_BARS_H

#include "physics/model/model-data.h"

/* One row: `between` stays as far from the line from `first` to `last` as it is. */
typedef struct {
    int32_t first, between, last; /* points */
    double length;                /* m: from first to last */
    double offset;                /* m: what h is kept at, rounding of the places */
    TinkerBlockId rod;            /* the longest that reaches across the point */
} TinkerStraightRow;

/* The rows for the bars that the rods make, for the places in the model's points. Rods whose lengths are told with
 * fewer digits than the bar needs get, as the host has them, those that fit the others. *fitted: how many rods do
 * nothing that the others of their bar do not. Element: TinkerStraightRow. (transfer full) */
GArray *tinker_straight_rows_find(const TinkerModel *model, int32_t *fitted);

/* Drops those of the rows, of none of which the model has any yet, that its constraints hold anyway, for the state in
 * the points. FALSE where that cannot be told. */
gboolean tinker_straight_rows_drop_held(TinkerModel *model, GArray *rows);

/* dh/da, dh/dp, dh/dc of a row (see straight-rows.c); answers h without its offset. */
double tinker_straight_row_gradient(const TinkerModel *model, const TinkerStraightRow *row, double j[6]);

/* Works out the rows in the arrays of the constraints, for the state in the points. */
void tinker_straight_rows_evaluate(TinkerModel *model);

#endif
