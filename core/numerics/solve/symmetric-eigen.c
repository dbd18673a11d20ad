/* Cyclic Jacobi: every entry off the diagonal is rotated away in turn, until all are rounding beside the two diagonal
 * entries of their own row and column. */
#include "numerics/solve/symmetric-eigen.h"

#include <float.h>
#include <math.h>

#define MOST_SWEEPS 60

typedef struct {
    double c, s;
} Rotation;

/* The rotation that makes a_pq 0, with the smaller of the two angles. */
static Rotation rotation_for(double app, double aqq, double apq)
{
    double tau = (aqq - app) / (2 * apq);
    double t = (tau >= 0 ? 1 : -1) / (fabs(tau) + hypot(1, tau));
    double c = 1 / hypot(1, t);
    return (Rotation){c, t * c};
}

static void rotate_columns(double *p, double *q, int count, Rotation r)
{
    for (int i = 0; i < count; i++) {
        double x = p[i], y = q[i];
        p[i] = r.c * x - r.s * y;
        q[i] = r.s * x + r.c * y;
    }
}

static void rotate_rows(double *a, int n, int p, int q, Rotation r)
{
    for (int i = 0; i < n; i++) {
        double *column = a + (gsize)n * i, x = column[p], y = column[q];
        column[p] = r.c * x - r.s * y;
        column[q] = r.s * x + r.c * y;
    }
}

/* The diagonal is moved by t * a_pq alone, so that a small entry keeps its digits. */
static void annul(int n, double *a, int rows, double *vectors, int p, int q)
{
    double app = a[p + (gsize)n * p], aqq = a[q + (gsize)n * q], apq = a[p + (gsize)n * q];
    Rotation r = rotation_for(app, aqq, apq);
    double t = r.s / r.c;
    rotate_columns(a + (gsize)n * p, a + (gsize)n * q, n, r);
    rotate_rows(a, n, p, q, r);
    a[p + (gsize)n * p] = app - t * apq;
    a[q + (gsize)n * q] = aqq + t * apq;
    a[p + (gsize)n * q] = a[q + (gsize)n * p] = 0;
    rotate_columns(vectors + (gsize)rows * p, vectors + (gsize)rows * q, rows, r);
}

gboolean tinker_symmetric_eigen(int n, double *a, int rows, double *vectors)
{
    for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
        gboolean rotated = FALSE;
        for (int p = 0; p < n - 1; p++)
            for (int q = p + 1; q < n; q++) {
                double bound = DBL_EPSILON * sqrt(fabs(a[p + (gsize)n * p])) * sqrt(fabs(a[q + (gsize)n * q]));
                double entry = fabs(a[p + (gsize)n * q]);
                if (!isfinite(entry)) return FALSE;
                if (entry <= bound || entry < DBL_MIN) continue;
                annul(n, a, rows, vectors, p, q);
                rotated = TRUE;
            }
        if (!rotated) return TRUE;
    }
    return FALSE;
}
