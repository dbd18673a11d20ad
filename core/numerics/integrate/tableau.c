/* What can be said of a tableau alone. */
#include <math.h>

#include "numerics/integrate/explicit-rk.h"

int tinker_tableau_ends_on_evaluation(const TinkerTableau *tableau)
{
    return tableau->error[tableau->stages] != 0.0;
}

double tinker_tableau_join_errors(double error, double second_error)
{
    if (error == 0.0) return 0.0;
    double share = second_error / error;
    return error / sqrt(1.0 + 0.01 * share * share);
}

void tinker_tableau_dense_weights(const TinkerTableau *tableau, double s, double *weights)
{
    int end = tableau->stages, count = end + 1 + tableau->extra_stages;
    const double *b = tableau->a[end];
    for (int i = 0; i < count; i++) {
        double at_start = i == 0 ? 1.0 : 0.0, at_end = i == end ? 1.0 : 0.0, sum = 0.0;
        for (int row = tableau->dense_rows - 1; row >= 0; row--)
            sum = (sum + tableau->d[row][i]) * (row % 2 ? s : 1.0 - s);
        sum = (sum + 2.0 * b[i] - at_start - at_end) * s;
        sum = (sum + at_start - b[i]) * (1.0 - s);
        weights[i] = (sum + b[i]) * s;
    }
}
