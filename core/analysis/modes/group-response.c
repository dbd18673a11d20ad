/* With the state matrix A = Q H Q^T (see mode-roots.c), whose last states are the modes' velocities u,
 *
 *   (i omega - H) x = Q^T (0, load0 + i omega load1),  u = last states of Q x,  y = u / (i omega),
 *
 * and H, upper Hessenberg, is eliminated row by row. Source: Laub, "Efficient multivariable frequency response
 * computations", IEEE Trans. Automatic Control 26 (1981). */
#include "analysis/modes/group-response-private.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/lapack.h"

struct _TinkerGroupResponse {
    gsize order;
    double *hessenberg;         /* row by row */
    double *load[2], *read[2];  /* times Q^T */
    double complex *rows, *rhs; /* room for a solve */
};

/* Q^T (0, values of the group's members). */
static double *rotate(const double *q, gsize n, const TinkerModeGroup *group, const double *values)
{
    double *out = g_new0(double, n);
    gsize first = n - (gsize)group->count;
    for (gsize c = 0; c < n; c++)
        for (int32_t k = 0; k < group->count; k++)
            out[c] += q[first + (gsize)k + n * c] * values[group->members[k]];
    return out;
}

TinkerGroupResponse *tinker_group_response_new(const TinkerModeGroup *group, double *const load[2],
                                               double *const read[2])
{
    int32_t order = 0;
    g_autofree double *a = tinker_mode_state_matrix(group, &order);
    gsize n = (gsize)(guint)order;
    g_autofree double *q = g_new0(double, n *n);
    for (gsize i = 0; i < n * n; i++)
        if (!isfinite(a[i])) return NULL;
    if (!tinker_hessenberg(order, a, q)) return NULL;
    TinkerGroupResponse *response = g_new0(TinkerGroupResponse, 1);
    response->order = n;
    response->hessenberg = g_new0(double, n *n);
    for (gsize r = 0; r < n; r++)
        for (gsize c = r > 0 ? r - 1 : 0; c < n; c++)
            response->hessenberg[c + n * r] = a[r + n * c];
    for (int k = 0; k < 2; k++) {
        response->load[k] = rotate(q, n, group, load[k]);
        response->read[k] = rotate(q, n, group, read[k]);
    }
    response->rows = g_new0(double complex, n *n);
    response->rhs = g_new0(double complex, n);
    return response;
}

void tinker_group_response_free(TinkerGroupResponse *response)
{
    if (response == NULL) return;
    gpointer arrays[] = {response->hessenberg, response->load[0], response->load[1], response->read[0],
                         response->read[1],    response->rows,    response->rhs};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(response);
}

/* Eliminates the entry below the diagonal of column k, with the larger of the two rows as pivot. */
static void eliminate(TinkerGroupResponse *response, gsize k)
{
    gsize n = response->order;
    double complex *upper = response->rows + n * k, *lower = upper + n;
    if (cabs(lower[k]) > cabs(upper[k])) {
        for (gsize c = k; c < n; c++) {
            double complex kept = upper[c];
            upper[c] = lower[c];
            lower[c] = kept;
        }
        double complex kept = response->rhs[k];
        response->rhs[k] = response->rhs[k + 1];
        response->rhs[k + 1] = kept;
    }
    if (lower[k] == 0) return;
    double complex factor = lower[k] / upper[k];
    for (gsize c = k; c < n; c++)
        lower[c] -= factor * upper[c];
    response->rhs[k + 1] -= factor * response->rhs[k];
}

double complex tinker_group_response_at(TinkerGroupResponse *response, double omega)
{
    gsize n = response->order;
    double complex sum = 0, rate = CMPLX(0, omega);
    for (gsize r = 0; r < n; r++) {
        for (gsize c = r > 0 ? r - 1 : 0; c < n; c++)
            response->rows[c + n * r] = -response->hessenberg[c + n * r];
        response->rows[r + n * r] += rate;
        response->rhs[r] = response->load[0][r] + rate * response->load[1][r];
    }
    for (gsize k = 0; k + 1 < n; k++)
        eliminate(response, k);
    for (gsize r = n; r-- > 0;) {
        for (gsize c = r + 1; c < n; c++)
            response->rhs[r] -= response->rows[c + n * r] * response->rhs[c];
        response->rhs[r] /= response->rows[r + n * r];
        sum += (response->read[0][r] / rate + response->read[1][r]) * response->rhs[r];
    }
    return sum;
}
