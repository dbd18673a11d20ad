/* The rows that keep bars straight; see straight-bars.h.
 *
 * With u = p - a, w = c - a and the points in the order a, p, c:
 *     h = (u_x w_y - u_y w_x) / L - offset,  dh/dp = (w_y, -w_x) / L,  dh/dc = (-u_y, u_x) / L,
 *     dh/da = -dh/dp - dh/dc,  drift = 2 (u' x w') / L. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/constraint/straight-bars.h"
#include "physics/model/model-data.h"

static const TinkerStraightRow *row_at(const TinkerConstraints *all, guint number)
{
    return &g_array_index(all->straight, TinkerStraightRow, number);
}

/* dh/da, dh/dp, dh/dc; answers h without its offset. */
double tinker_straight_row_gradient(const TinkerModel *model, const TinkerStraightRow *of, double j[6])
{
    const TinkerPoint *a = &model->point[of->first], *p = &model->point[of->between], *c = &model->point[of->last];
    double inverse = 1 / of->length, ux = p->x - a->x, uy = p->y - a->y, wx = c->x - a->x, wy = c->y - a->y;
    j[2] = wy * inverse;
    j[3] = -wx * inverse;
    j[4] = -uy * inverse;
    j[5] = ux * inverse;
    j[0] = -j[2] - j[4];
    j[1] = -j[3] - j[5];
    return (ux * wy - uy * wx) * inverse;
}

void tinker_straight_rows_evaluate(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    for (guint i = 0; i < all->straight->len; i++) {
        const TinkerStraightRow *of = row_at(all, i);
        const TinkerPoint *a = &model->point[of->first], *p = &model->point[of->between], *c = &model->point[of->last];
        int32_t row = all->first_straight + (int32_t)i;
        all->g[row] = tinker_straight_row_gradient(model, of, all->jacobian + 2 * all->row_starts[row]) - of->offset;
        all->drift[row] =
            2 * ((p->vx - a->vx) * (c->vy - a->vy) - (p->vy - a->vy) * (c->vx - a->vx)) * (1 / of->length);
        all->miss = fmax(all->miss, fabs(all->g[row]) * all->inverse_scales[row]);
    }
}
