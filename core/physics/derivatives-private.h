/* The derivatives of the forces of lines: what products (products.c) and matrices (jacobian.c) are both made of.
 *
 * With d = x_b - x_a, w = v_b - v_a, L = |d|, n = d / L, m = n turned by +90 degrees, rate = n . w and the force
 * F = T(L, rate) n on a (on b its opposite),
 *
 *     dF/dw = dT/drate n n^T
 *     dF/dd = dT/dL n n^T + T / L m m^T + dT/drate (m . w) / L n m^T
 *
 * as dn/dd = m m^T / L and drate/dd = (m . w) m / L. The last term is not symmetric and vanishes where the line does not
 * swing. Where L is 0 nothing has a direction, but a linear spring without rest length pulls with stiffness * d all the
 * same.
 */
#ifndef TINKER_CORE_DERIVATIVES_PRIVATE_H
#define TINKER_CORE_DERIVATIVES_PRIVATE_H

#include <math.h>

#include "physics/model-private.h"

/* A line at the state in the points. */
typedef struct {
    double x, y;           /* n */
    double along, damping; /* dT/dL, dT/drate */
    double across;         /* T / L */
    double swing;          /* (m . w) / L, 1/s: how fast the line turns */
} TinkerLineDerivatives;

/* n and swing; answers L. Where L is 0 n is 0. */
static inline double tinker_line_geometry(const TinkerModel *model, int32_t a, int32_t b, TinkerLineDerivatives *line,
                                          double *rate)
{
    const TinkerPoint *pa = &model->point[a], *pb = &model->point[b];
    double dx = pb->x - pa->x, dy = pb->y - pa->y, wx = pb->vx - pa->vx, wy = pb->vy - pa->vy;
    double length = sqrt(dx * dx + dy * dy), inverse = length > 0 ? 1.0 / length : 0.0;
    double x = dx * inverse, y = dy * inverse;
    *line = (TinkerLineDerivatives){.x = x, .y = y, .swing = (x * wy - y * wx) * inverse};
    *rate = x * wx + y * wy;
    return length;
}

/* Of a merged line. */
static inline TinkerLineDerivatives tinker_merged_line_derivatives(const TinkerModel *model, int32_t i)
{
    const TinkerMergedLines *lines = &model->lines;
    TinkerLineDerivatives line;
    double rate, length = tinker_line_geometry(model, lines->a[i], lines->b[i], &line, &rate);
    double loose = lines->tension[i] - lines->stiffness[i] * lines->length[i];
    if (length > 0) {
        line.along = lines->stiffness[i];
        line.damping = lines->damping[i];
        line.across = (loose + line.damping * rate) / length + line.along;
    } else if (loose == 0) {
        line.x = 1;
        line.along = line.across = lines->stiffness[i];
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
