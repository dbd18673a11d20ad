/* Rest of bodies that all lie on plates: each has one coordinate, its place along the top.
 *
 * The forces along the tops are brought to 0 by Newton's method, with their derivatives by differences of the forces; what
 * nothing determines (two bodies with a spring between them alone) stays as near as it can to where it was. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "analysis/start-private.h"
#include "numerics/dense-solve.h"
#include "physics/linearise.h"

#define MOST_ROUNDS 60
/* Of the largest force: what counts as balanced. */
#define BALANCED 1e-12
/* Of the extent: the step of a difference. */
#define DIFFERENCE 1e-4
/* In the widths of a top: how far beyond it a place is still looked at. */
#define FARTHEST 4.0

typedef struct {
    TinkerModel *model;
    const StartTop *tops; /* of each body */
    const double *feet;   /* along the tops, at the start */
    const double *from;   /* places at the start */
    int32_t bodies;
    double *q;      /* places of the last evaluation */
    double *normal; /* N: forces off the tops of the last evaluation */
    double extent, scale;
} Tops;

/* The forces along the tops at the shifts s. */
static gboolean forces_at(Tops *tops, const double *s, double *force, GError **error)
{
    for (int32_t i = 0; i < tops->bodies; i++)
        for (int k = 0; k < 2; k++)
            tops->q[2 * i + k] = tops->from[2 * i + k] + s[i] * tops->tops[i].along[k];
    g_autoptr(TinkerLinearisation) linear = tinker_linearise(tops->model, tops->q, error);
    if (linear == NULL) return FALSE;
    tops->extent = linear->extent;
    tops->scale = linear->force_scale;
    for (int32_t i = 0; i < tops->bodies; i++) {
        const double *f = linear->force + 2 * i, *along = tops->tops[i].along, *normal = tops->tops[i].normal;
        force[i] = f[0] * along[0] + f[1] * along[1];
        tops->normal[i] = f[0] * normal[0] + f[1] * normal[1];
        tops->scale = fmax(tops->scale, hypot(f[0], f[1]));
    }
    return TRUE;
}

/* matrix = -df/ds, by rows, over its largest entry, which is answered; negative with an error. */
static double stiffness_at(Tops *tops, double *s, double *matrix, GError **error)
{
    const int32_t n = tops->bodies;
    const double h = DIFFERENCE * tops->extent;
    g_autofree double *ahead = g_new0(double, n), *behind = g_new0(double, n);
    double most = 0;
    for (int32_t j = 0; j < n; j++) {
        const double middle = s[j];
        s[j] = middle + h;
        if (!forces_at(tops, s, ahead, error)) return -1;
        s[j] = middle - h;
        if (!forces_at(tops, s, behind, error)) return -1;
        s[j] = middle;
        for (int32_t i = 0; i < n; i++) {
            matrix[i * n + j] = (behind[i] - ahead[i]) / (2 * h);
            most = fmax(most, fabs(matrix[i * n + j]));
        }
    }
    for (int32_t i = 0; i < n * n && most > 0; i++)
        matrix[i] /= most;
    return most;
}

static gboolean goes_too_far(const Tops *tops, const double *s)
{
    for (int32_t i = 0; i < tops->bodies; i++)
        if (!(fabs(tops->feet[i] + s[i]) <= FARTHEST * tops->tops[i].half_width)) return TRUE;
    return FALSE;
}

static double greatest(const double *x, int32_t n)
{
    double most = 0;
    for (int32_t i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* s ends where the forces balance; `found` where they do. */
static gboolean search(Tops *tops, double *s, gboolean *found, GError **error)
{
    const int32_t n = tops->bodies;
    g_autofree double *force = g_new0(double, n), *matrix = g_new0(double, (gsize)n *(gsize)n);
    TinkerDenseSolve *solve = tinker_dense_solve_new(n);
    gboolean good = TRUE;
    *found = FALSE;
    for (int round = 0; good && round < MOST_ROUNDS; round++) {
        good = forces_at(tops, s, force, error);
        *found = good && greatest(force, n) <= BALANCED * tops->scale;
        if (!good || *found) break;
        double stiffness = stiffness_at(tops, s, matrix, error);
        good = stiffness >= 0;
        if (!(stiffness > 0)) break;
        tinker_dense_solve_factor(solve, matrix);
        tinker_dense_solve(solve, force);
        for (int32_t i = 0; i < n; i++)
            s[i] += force[i] / stiffness;
        if (goes_too_far(tops, s)) break;
    }
    tinker_dense_solve_free(solve);
    return good;
}

gboolean start_settle_on_tops(TinkerModel *model, const StartTop *tops, const double *feet, double *q, const char **why,
                              GError **error)
{
    const int32_t n = tinker_model_sizes(model).bodies;
    g_autofree double *from = g_memdup2(q, 2 * (gsize)n * sizeof(double));
    g_autofree double *s = g_new0(double, n), *normal = g_new0(double, n);
    Tops all = {model, tops, feet, from, n, q, normal, 0, 0};
    gboolean found;
    if (!search(&all, s, &found, error)) return FALSE;
    *why = found ? NULL : _("no places along the tops that it lies on balance its forces");
    for (int32_t i = 0; i < n && found; i++) {
        if (fabs(feet[i] + s[i]) > tops[i].half_width) *why = _("it would lie beyond the end of a top");
        if (normal[i] > BALANCED * all.scale) *why = _("it would be pulled off a top");
    }
    return TRUE;
}
