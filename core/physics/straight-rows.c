/* The rows that keep bars straight; see straight-bars.h.
 *
 * With u = p - a, w = c - a and the points in the order a, p, c:
 *     h = (u_x w_y - u_y w_x) / L - offset,  dh/dp = (w_y, -w_x) / L,  dh/dc = (-u_y, u_x) / L,
 *     dh/da = -dh/dp - dh/dc,  drift = 2 (u' x w') / L. */
#include <math.h>
#include <string.h>

#include "physics/linearise-private.h"
#include "physics/straight-bars.h"

/* Of the energy of a push: what is left where the constraints hold against it. */
#define HELD 1e-9
/* Times as hard as they are pushed: what holds no better does so by being a little off a straight line alone. */
#define HARDEST 1e3

static const TinkerStraightRow *row_at(const TinkerConstraints *all, guint number)
{
    return &g_array_index(all->straight, TinkerStraightRow, number);
}

/* dh/da, dh/dp, dh/dc; answers h without its offset. */
static double gradient(const TinkerModel *model, const TinkerStraightRow *of, double j[6])
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
        all->g[row] = gradient(model, of, all->jacobian + 2 * all->row_starts[row]) - of->offset;
        all->drift[row] =
            2 * ((p->vx - a->vx) * (c->vy - a->vy) - (p->vy - a->vy) * (c->vx - a->vx)) * (1 / of->length);
        all->miss = fmax(all->miss, fabs(all->g[row]) * all->inverse_scales[row]);
    }
}

/* Whether other constraints hold a push across the bar: by what it moves with them and without, sums of m v^2. */
static gboolean is_held(TinkerModel *model, const TinkerStraightRow *of, double *v)
{
    const int32_t points[3] = {of->first, of->between, of->last};
    double j[6], freely = 0, held = 0;
    gboolean moved;
    gradient(model, of, j);
    memset(v, 0, 2 * (gsize)model->bodies * sizeof(double));
    for (int k = 0; k < 6; k++) {
        if (points[k / 2] >= model->bodies) continue;
        v[2 * points[k / 2] + k % 2] = j[k] * model->inverse_mass[points[k / 2]];
        freely += j[k] * j[k] * model->inverse_mass[points[k / 2]];
    }
    tinker_constraints_correct_velocities(model, v, TRUE, &moved);
    for (int32_t i = 0; i < 2 * model->bodies; i++)
        held += v[i] * v[i] * model->coordinate_mass[i];
    return held <= HELD * freely && tinker_greatest(model->constraints.lambda, model->constraints.rows) <= HARDEST;
}

gboolean tinker_straight_rows_drop_held(TinkerModel *model, GArray *rows)
{
    TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->unilateral[row]) tinker_constraints_set_slack(model, row, TRUE);
    gboolean good = tinker_constraints_evaluate(model) == TINKER_OK;
    g_autofree double *v = g_new0(double, 2 * (gsize)MAX(model->bodies, 1));
    for (guint i = rows->len; good && i-- > 0;)
        if (is_held(model, &g_array_index(rows, TinkerStraightRow, i), v)) g_array_remove_index(rows, i);
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->unilateral[row]) tinker_constraints_set_slack(model, row, FALSE);
    return good;
}

/* Motions that the rods of a bar allow turn u and w alike, so that the second derivative of h, 2 u' x w' / L, is 0 along them: it
 * adds nothing to the stiffness. */
void tinker_linear_add_straight_rows(TinkerLinearisation *linear, const TinkerConstraints *all)
{
    for (int32_t row = all->first_straight; row < all->rows; row++)
        tinker_linear_add_row(linear, all, row);
}
