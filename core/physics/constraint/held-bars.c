/* Which rows that keep bars straight are there already by what else holds the bar. */
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/straight-bars.h"
#include "physics/constraint/tolerances.h"

/* Whether other constraints hold a push across the bar: by what it moves with them and without, sums of m v^2. */
static gboolean is_held(TinkerModel *model, const TinkerStraightRow *of, double *v)
{
    const int32_t points[3] = {of->first, of->between, of->last};
    double j[6], freely = 0, held = 0;
    gboolean moved;
    tinker_straight_row_gradient(model, of, j);
    memset(v, 0, (gsize)model->coordinates * sizeof(double));
    for (int k = 0; k < 6; k++) {
        if (points[k / 2] >= model->bodies) continue;
        v[2 * points[k / 2] + k % 2] = j[k] * model->inverse_mass[points[k / 2]];
        freely += j[k] * j[k] * model->inverse_mass[points[k / 2]];
    }
    tinker_constraints_correct_velocities(model, v, TRUE, &moved);
    for (int32_t i = 0; i < model->coordinates; i++)
        held += v[i] * v[i] * model->coordinate_mass[i];
    return held <= TINKER_HELD * freely &&
           tinker_largest(model->constraints.rows, model->constraints.lambda) <= TINKER_HARDEST;
}

gboolean tinker_straight_rows_drop_held(TinkerModel *model, GArray *rows)
{
    tinker_constraints_set_all_slack(model, TRUE);
    gboolean good = tinker_constraints_evaluate(model) == TINKER_OK;
    g_autofree double *v = g_new0(double, (gsize)MAX(model->coordinates, 1));
    for (guint i = rows->len; good && i-- > 0;)
        if (is_held(model, &g_array_index(rows, TinkerStraightRow, i), v)) g_array_remove_index(rows, i);
    tinker_constraints_set_all_slack(model, FALSE);
    return good;
}
