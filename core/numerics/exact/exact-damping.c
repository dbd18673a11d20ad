/* The dampers of a part in its modes: whether they leave the modes apart (proportional damping) to rounding. */
#include <float.h>
#include <math.h>

#include "numerics/exact/exact-private.h"

static double drag_of(const TinkerExactPart *part, int32_t i)
{
    return part->linear->drag ? part->linear->drag[part->coordinates[i]] : 0.0;
}

static const TinkerLinearEdge *edge_of(const TinkerExactPart *part, int32_t e)
{
    return &part->linear->edges[part->edges[e].edge];
}

/* c = beta k for every edge, drag = alpha m for every coordinate, to rounding (Rayleigh). */
static gboolean is_rayleigh(const TinkerExactPart *part, double *alpha, double *beta)
{
    *alpha = *beta = 0.0;
    double stiffest = 0.0, heaviest = 0.0;
    for (int32_t e = 0; e < part->edge_count; e++) {
        const TinkerLinearEdge *edge = edge_of(part, e);
        if (edge->stiffness > stiffest) *beta = edge->damping / (stiffest = edge->stiffness);
    }
    for (int32_t i = 0; i < part->n; i++) {
        double mass = part->linear->mass[part->coordinates[i]];
        if (mass > heaviest) *alpha = drag_of(part, i) / (heaviest = mass);
    }
    for (int32_t e = 0; e < part->edge_count; e++) {
        const TinkerLinearEdge *edge = edge_of(part, e);
        if (fabs(edge->damping - *beta * edge->stiffness) > 4.0 * DBL_EPSILON * fabs(edge->damping)) return FALSE;
    }
    for (int32_t i = 0; i < part->n; i++) {
        double drag = drag_of(part, i), mass = part->linear->mass[part->coordinates[i]];
        if (fabs(drag - *alpha * mass) > 4.0 * DBL_EPSILON * fabs(drag)) return FALSE;
    }
    return TRUE;
}

/* Adds weight row row^T to c, and to `doubt` how far rounding of the row's entries may move that. */
static void add_outer(int32_t n, double weight, const double *row, const double *row_doubt, double *c, double *doubt)
{
    for (int32_t i = 0; i < n; i++) {
        for (int32_t j = 0; j < n; j++) {
            c[(gsize)i * n + j] += weight * row[i] * row[j];
            doubt[(gsize)i * n + j] += fabs(weight) * (fabs(row[i]) * row_doubt[j] + row_doubt[i] * fabs(row[j]) +
                                                       row_doubt[i] * row_doubt[j]);
        }
    }
}

/* The shapes are known to about n roundings; an elongation, their difference, to as many of what was subtracted. */
static void find_row_doubt(const TinkerExactPart *part, const TinkerLinearParts *parts, int32_t a, int32_t b,
                           double *doubt)
{
    gsize n = (gsize)part->n;
    for (gsize j = 0; j < n; j++) {
        double sum = 0.0;
        if (a >= 0) sum += fabs(part->shape[(gsize)parts->local[a] * n + j]);
        if (b >= 0) sum += fabs(part->shape[(gsize)parts->local[b] * n + j]);
        doubt[j] = 4.0 * sqrt((double)n) * DBL_EPSILON * sum;
    }
}

static gboolean is_diagonal(int32_t n, const double *c, const double *doubt)
{
    double rounding = 16.0 * n * DBL_EPSILON;
    for (int32_t i = 0; i < n; i++) {
        for (int32_t j = 0; j < i; j++) {
            double size = sqrt(fabs(c[(gsize)i * n + i])) * sqrt(fabs(c[(gsize)j * n + j]));
            if (fabs(c[(gsize)i * n + j]) > rounding * size + doubt[(gsize)i * n + j]) return FALSE;
        }
    }
    return TRUE;
}

/* Both matrices, n x n; FALSE where memory is out. */
static gboolean find_matrices(TinkerExactPart *part, const TinkerLinearParts *parts, gboolean *coupled)
{
    int32_t n = part->n;
    gsize square = (gsize)n * (gsize)n;
    g_autofree double *doubt = g_try_malloc0_n(2 * square + (gsize)n, sizeof(double));
    double *matrices = tinker_exact_allot(part->memory, 2 * square, sizeof(double));
    if (!doubt || !matrices) return FALSE;
    double *row_doubt = doubt + 2 * square;
    for (int k = 0; k < 2; k++)
        part->damping[k] = matrices + k * square;
    for (int32_t e = 0; e < part->edge_count; e++) {
        const TinkerLinearEdge *edge = edge_of(part, e);
        if (edge->damping == 0.0) continue;
        find_row_doubt(part, parts, edge->a, edge->b, row_doubt);
        add_outer(n, edge->damping, part->elongation + (gsize)e * n, row_doubt, part->damping[0], doubt);
    }
    for (int32_t i = 0; i < n; i++) {
        if (drag_of(part, i) == 0.0) continue;
        find_row_doubt(part, parts, part->coordinates[i], -1, row_doubt);
        add_outer(n, drag_of(part, i), part->shape + (gsize)i * n, row_doubt, part->damping[1], doubt + square);
    }
    *coupled = !is_diagonal(n, part->damping[0], doubt) || !is_diagonal(n, part->damping[1], doubt + square);
    return TRUE;
}

gboolean tinker_exact_part_damp(TinkerExactPart *part, const TinkerLinearParts *parts)
{
    gsize n = (gsize)part->n;
    double alpha, beta;
    if (is_rayleigh(part, &alpha, &beta)) {
        double *decays = tinker_exact_allot(part->memory, 2 * n, sizeof(double));
        if (!decays) return FALSE;
        for (int k = 0; k < 2; k++)
            part->damping[k] = decays + k * n;
        for (gsize j = 0; j < n; j++) {
            part->damping[0][j] = beta * part->omega[j] * part->omega[j];
            part->damping[1][j] = alpha;
        }
    } else {
        if (!find_matrices(part, parts, &part->coupled)) return FALSE;
        if (part->coupled) {
            double *sum = tinker_exact_allot(part->memory, n * n, sizeof(double));
            if (!sum || part->n > TINKER_EXACT_MOST_COUPLED) return FALSE;
            for (gsize i = 0; i < n * n; i++)
                sum[i] = part->damping[0][i] + part->damping[1][i];
            part->decay = sum;
            return TRUE;
        }
        for (int k = 0; k < 2; k++)
            for (gsize j = 1; j < n; j++)
                part->damping[k][j] = part->damping[k][j * n + j];
    }
    for (gsize j = 0; j < n; j++)
        part->decay[j] = part->damping[0][j] + part->damping[1][j];
    return TRUE;
}
