/* The laws by projected Gauss-Seidel: every contact by turns to what its own law asks for beside the impulses of the
 * others. Converges slowly where contacts lean on one another, and in any case. Source: Jourdan, Alart, Jean, "A
 * Gauss-Seidel like algorithm to solve frictional contact problems", Computer Methods in Applied Mechanics and
 * Engineering 155 (1998) 31-47. */
#include <math.h>
#include <string.h>

#include "numerics/contact/contact-private.h"
#include "numerics/contact/tolerances.h"

#define MOST_SWEEPS 500

static double velocity(const TinkerContactProblem *problem, const double *p, int32_t i)
{
    const int32_t width = 2 * problem->count;
    const double *row = problem->delassus + (gsize)i * (gsize)width;
    double sum = problem->offset[i];
    for (int32_t j = 0; j < width; j++)
        sum += row[j] * p[j];
    return sum;
}

/* Brings one entry of p to where v is 0 in that direction, or as near as its bounds let it; answers by how much v
 * changed. */
static double relax(const TinkerContactProblem *problem, int32_t i, double own, double least, double most, double *p)
{
    const double before = p[i];
    if (!(own > 0)) return 0;
    p[i] = CLAMP(before - velocity(problem, p, i) / own, least, most);
    return own * fabs(p[i] - before);
}

double tinker_contact_sweep(const TinkerContactProblem *problem, double *p)
{
    const gsize width = 2 * (gsize)problem->count;
    double most = 0;
    for (int32_t k = 0; k < problem->count; k++) {
        const int32_t n = 2 * k, t = n + 1;
        const double *row = problem->delassus + (gsize)n * width;
        if (tinker_contact_grips(problem, k)) {
            most = fmax(most, relax(problem, n, row[n], 0, INFINITY, p));
            const double bound = problem->friction[k] * tinker_contact_normal(problem, p, k);
            most = fmax(most, relax(problem, t, row[width + (gsize)t], -bound, bound, p));
        } else {
            const double slope = tinker_contact_slope(problem, k, TINKER_STATE_FREE);
            most = fmax(most, relax(problem, n, row[n] + slope * row[t], 0, INFINITY, p));
            p[t] = slope * tinker_contact_normal(problem, p, k);
        }
    }
    return most;
}

int tinker_impact_sweep(const TinkerImpact *impact, double *offset, double *impulses)
{
    const TinkerContactProblem problem = {impact->count, impact->delassus, offset, impact->friction, NULL,
                                          NULL,          impact->bearer};
    double scale = 0;
    gboolean finite = TRUE;
    memset(impulses, 0, 2 * (gsize)impact->count * sizeof(double));
    for (int32_t i = 0; i < 2 * impact->count; i++) {
        offset[i] = impact->velocity[i] - (i % 2 == 0 ? impact->least[i / 2] : 0);
        scale = fmax(scale, fabs(offset[i]));
        finite = finite && isfinite(offset[i]);
    }
    for (int sweeps = 0; sweeps < MOST_SWEEPS; sweeps++)
        if (tinker_contact_sweep(&problem, impulses) <= TINKER_SWEEPS_CONVERGED * scale) break;
    return finite;
}
