/* The derivatives of the forces of lines: what products (products.c) and matrices (jacobian.c) are both made of.
 *
 * With d = x_b - x_a, w = v_b - v_a, L = |d|, n = d / L, m = n turned by +90 degrees, rate = n . w and the force
 * F = T(L, rate) n on a (on b its opposite),
 *
 *     dF/dw = dT/drate n n^T
 *     dF/dd = dT/dL n n^T + T / L m m^T + dT/drate (m . w) / L n m^T
 *
 * as dn/dd = m m^T / L and drate/dd = (m . w) m / L. The last term is not symmetric and vanishes where the line does
 * not swing.
 *
 * Where the ends are at one place nothing has a direction. A law with T(0) = 0 pulls like a spring without length
 * there, F = T(L) d / L -> dT/dL(0) d in every direction, so dF/dd = dT/dL(0) times the unit matrix. Where T(0) is not
 * 0 there is no derivative. Nor is there one by w: dT/drate n n^T depends on the direction in which the ends part. Both
 * then count as nothing, and are told apart from nothing by `pull_undefined` and `damping_undefined`.
 */
#ifndef TINKER_CORE_DERIVATIVES_H
#define TINKER_CORE_DERIVATIVES_H

#include <float.h>
#include <math.h>

#include "physics/model/model-data.h"

/* A line at the state in the points. */
typedef struct {
    double length;                              /* L; 0 where the ends are at one place */
    double x, y;                                /* n */
    double along, damping;                      /* dT/dL, dT/drate */
    double across;                              /* T / L */
    double swing;                               /* (m . w) / L, 1/s: how fast the line turns */
    gboolean pull_undefined, damping_undefined; /* they count as 0, as the ends are at one place */
} TinkerLineDerivatives;

/* A length that rounding of the places alone can make: of those that are worked with, and of those in the scene, which
 * are relative to no origin. */
static inline double tinker_line_rounding(const TinkerModel *model, const TinkerPoint *a, const TinkerPoint *b)
{
    double reach = fabs(a->x) + fabs(a->y) + fabs(b->x) + fabs(b->y);
    return DBL_EPSILON * (8 * reach + 2 * (fabs(model->origin[0]) + fabs(model->origin[1])));
}

/* L, n and swing; answers the rate. Where the ends are at one place all are 0. */
static inline double tinker_line_geometry(const TinkerModel *model, int32_t a, int32_t b, TinkerLineDerivatives *line)
{
    const TinkerPoint *pa = &model->point[a], *pb = &model->point[b];
    double dx = pb->x - pa->x, dy = pb->y - pa->y, wx = pb->vx - pa->vx, wy = pb->vy - pa->vy;
    double length = sqrt(dx * dx + dy * dy);
    if (length <= tinker_line_rounding(model, pa, pb)) length = 0;
    double inverse = length > 0 ? 1.0 / length : 0.0;
    double x = dx * inverse, y = dy * inverse;
    *line = (TinkerLineDerivatives){.length = length, .x = x, .y = y, .swing = (x * wy - y * wx) * inverse};
    return x * wx + y * wy;
}

/* What is left of a line whose ends are at one place, of T, dT/dL and dT/drate there. */
static inline void tinker_line_at_one_place(TinkerLineDerivatives *line, double tension, double by_length,
                                            double by_rate)
{
    *line =
        (TinkerLineDerivatives){.pull_undefined = tension != 0 || isinf(by_length), .damping_undefined = by_rate != 0};
    if (line->pull_undefined) return;
    line->x = 1;
    line->along = line->across = by_length;
}

/* Of a merged line. */
static inline TinkerLineDerivatives tinker_merged_line_derivatives(const TinkerModel *model, int32_t i)
{
    const TinkerMergedLines *lines = &model->lines;
    TinkerLineDerivatives line;
    double rate = tinker_line_geometry(model, lines->a[i], lines->b[i], &line);
    double loose = lines->tension[i] - lines->stiffness[i] * lines->length[i];
    if (line.length > 0) {
        line.along = lines->stiffness[i];
        line.damping = lines->damping[i];
        line.across = (loose + line.damping * rate) / line.length + line.along;
    } else {
        tinker_line_at_one_place(&line, loose, lines->stiffness[i], lines->damping[i]);
    }
    return line;
}

/* Of one line whose plugin is asked: by its own derivatives, or by differences. Where it fails it says why. */
TinkerStatus tinker_asked_line_derivatives(TinkerModel *model, const TinkerAskedBatch *asked, int32_t row,
                                           TinkerLineDerivatives *line);

/* dF/dd and dF/dw, row by row. */
static inline void tinker_line_stiffness(const TinkerLineDerivatives *line, double block[4])
{
    double turning = line->damping * line->swing, x = line->x, y = line->y;
    double difference = line->along - line->across;
    block[0] = difference * x * x + line->across - turning * x * y;
    block[1] = difference * x * y + turning * x * x;
    block[2] = difference * x * y - turning * y * y;
    block[3] = difference * y * y + line->across + turning * x * y;
}

static inline void tinker_line_damping(const TinkerLineDerivatives *line, double block[4])
{
    block[0] = line->damping * line->x * line->x;
    block[1] = block[2] = line->damping * line->x * line->y;
    block[3] = line->damping * line->y * line->y;
}

#endif
