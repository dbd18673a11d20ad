/* The dictionary holds, by rows, the basic unknowns as functions of the n + 1 others: basic = constant - row . others.
 * Laws of contact have many constants that are 0 or alike, so that unknowns fall to 0 at once and the path goes in
 * circles, or into a ray by rounding: the constants are set apart before it, and the basis that it ends in is solved
 * with the true ones. */
#include "numerics/contact/complementarity.h"

#include <math.h>
#include <string.h>

#include <glib.h>

#include "numerics/contact/tolerances.h"
#include "numerics/solve/pivoted-solve.h"
#include "numerics/solve/power-of-two.h"

/* Of the largest constant, since those below TINKER_SMALLEST_CONSTANT are taken as 0 on the way. */
#define FLOOR (10 * TINKER_SMALLEST_CONSTANT)

/* Unknown 0 .. n-1 is w, n .. 2n-1 is z, 2n the covering one. */
typedef struct {
    int32_t n;
    int32_t stride; /* n + 2: the others, and the constant */
    double *rows;
    double *scale;  /* n: of the unknowns z (and 1 / of w) */
    int32_t *basic; /* n: in each row */
    int32_t *other; /* n + 1: at each column */
} Dictionary;

int64_t tinker_lcp_room(int32_t n)
{
    /* the dictionary, which the last system fits in too; scales, right-hand side, solution; two lists of half as wide
     * integers */
    return (int64_t)n * (n + 2) + 6 * (int64_t)n + 4;
}

static double *row_of(const Dictionary *self, int32_t row)
{
    return self->rows + (int64_t)row * self->stride;
}

/* Every unknown is scaled so that its row and column have entries near 1, by powers of two: nothing is rounded. The
 * constants are larger by one to two times `apart`, as chance would have it, the same each time. */
static void fill(Dictionary *self, const double *matrix, const double *q, double apart)
{
    int32_t n = self->n;
    double largest = 0;
    for (int32_t i = 0; i < n; i++) {
        double size = matrix[(int64_t)i * n + i];
        if (!(size > 0)) {
            size = 0;
            for (int32_t j = 0; j < n; j++)
                size = MAX(size, MAX(fabs(matrix[(int64_t)i * n + j]), fabs(matrix[(int64_t)j * n + i])));
        }
        self->scale[i] = size > 0 ? 1 / tinker_power_of_two(sqrt(size)) : 1;
        largest = MAX(largest, fabs(q[i]) * self->scale[i]);
    }
    double unit = largest > 0 ? 1 / tinker_power_of_two(largest) : 1;
    uint64_t chance = 1;
    for (int32_t i = 0; i < n; i++) {
        double *row = row_of(self, i);
        chance = chance * 6364136223846793005u + 1442695040888963407u;
        for (int32_t j = 0; j < n; j++)
            row[j] = -self->scale[i] * matrix[(int64_t)i * n + j] * self->scale[j];
        row[n] = -1;
        row[n + 1] = self->scale[i] * q[i] * unit + apart * (1 + (double)(chance >> 33) * 0x1p-31);
        self->basic[i] = i;
    }
    for (int32_t j = 0; j <= n; j++)
        self->other[j] = n + j;
}

static int32_t find(const int32_t *list, int32_t count, int32_t unknown)
{
    for (int32_t i = 0; i < count; i++)
        if (list[i] == unknown) return i;
    return -1;
}

/* The row whose unknown falls to 0 first where that of column `entering` grows; -1 where none does. */
static int32_t leaving_row(const Dictionary *self, int32_t entering)
{
    int32_t best = -1;
    double least = 0;
    for (int32_t i = 0; i < self->n; i++) {
        const double *row = row_of(self, i);
        if (!(row[entering] > TINKER_SMALLEST_PIVOT)) continue;
        double ratio = row[self->n + 1] / row[entering];
        double tie = TINKER_SMALLEST_CONSTANT / row[entering] + TINKER_SMALLEST_PIVOT * fabs(least);
        if (best < 0 || ratio < least - tie) {
            best = i;
            least = ratio;
        } else if (ratio <= least + tie) {
            /* the covering unknown ends the path; else the larger pivot is the safer one */
            const gboolean ends = self->basic[best] == 2 * self->n;
            if (self->basic[i] == 2 * self->n || (!ends && row[entering] > row_of(self, best)[entering])) best = i;
            least = MIN(least, ratio);
        }
    }
    return best;
}

static void pivot(Dictionary *self, int32_t leaving, int32_t entering)
{
    int32_t width = self->stride;
    double *row = row_of(self, leaving), share = 1 / row[entering];
    row[entering] = 1;
    for (int32_t j = 0; j < width; j++)
        row[j] *= share;
    for (int32_t i = 0; i < self->n; i++) {
        double *changed = row_of(self, i), factor = changed[entering];
        if (i == leaving || factor == 0) continue;
        changed[entering] = 0;
        for (int32_t j = 0; j < width; j++)
            changed[j] -= factor * row[j];
        if (fabs(changed[width - 1]) < TINKER_SMALLEST_CONSTANT) changed[width - 1] = 0;
    }
    int32_t left = self->basic[leaving];
    self->basic[leaving] = self->other[entering];
    self->other[entering] = left;
}

static TinkerLcpResult walk(Dictionary *self)
{
    int32_t n = self->n, entering = n, leaving = 0;
    /* the covering unknown comes in at the size that lifts every constant to at least 0 */
    for (int32_t i = 1; i < n; i++)
        if (row_of(self, i)[n + 1] <= row_of(self, leaving)[n + 1]) leaving = i;
    for (int32_t pivots = 0; pivots < 60 * (n + 2); pivots++) {
        int32_t left = self->basic[leaving];
        if (!isfinite(row_of(self, leaving)[n + 1])) return TINKER_LCP_GAVE_UP;
        pivot(self, leaving, entering);
        if (left == 2 * n) return TINKER_LCP_SOLVED;
        entering = find(self->other, n + 1, left < n ? left + n : left - n);
        leaving = leaving_row(self, entering);
        if (leaving < 0) {
            double covering = row_of(self, find(self->basic, n, 2 * n))[n + 1];
            return fabs(covering) <= TINKER_COVERS_NOTHING ? TINKER_LCP_SOLVED : TINKER_LCP_RAY;
        }
    }
    return TINKER_LCP_GAVE_UP;
}

/* z is cleared of rounding below 0; FALSE where it is no solution. `floor` is what (scaled) rows may miss in any case.
 */
static gboolean holds(const Dictionary *self, const double *matrix, const double *q, double floor, double *z)
{
    int32_t n = self->n;
    for (int32_t i = 0; i < n; i++)
        z[i] = z[i] > 0 ? z[i] : 0;
    for (int32_t i = 0; i < n; i++) {
        double w = q[i], size = fabs(q[i]);
        for (int32_t j = 0; j < n; j++) {
            double term = matrix[(int64_t)i * n + j] * z[j];
            w += term;
            size += fabs(term);
        }
        double slack = TINKER_LCP_MISS * size + floor / self->scale[i];
        if (!(z[i] > 0 ? fabs(w) <= slack : w >= -slack)) return FALSE;
    }
    return TRUE;
}

/* The basis once more, from the matrix itself; what the path gave stands where that is singular. */
static gboolean finish(Dictionary *self, const double *matrix, const double *q, double *z, double *right)
{
    int32_t n = self->n, count = 0, *chosen = self->basic, *order = self->other;
    double largest = 0;
    for (int32_t i = 0; i < n; i++)
        largest = MAX(largest, fabs(q[i]) * self->scale[i]);
    double unit = largest > 0 ? tinker_power_of_two(largest) : 1;
    memset(z, 0, (size_t)n * sizeof *z);
    for (int32_t i = 0; i < n; i++)
        if (self->basic[i] >= n && self->basic[i] < 2 * n)
            z[self->basic[i] - n] = row_of(self, i)[n + 1] * self->scale[self->basic[i] - n] * unit;
    for (int32_t i = 0, rows = n; i < rows; i++)
        if (self->basic[i] >= n && self->basic[i] < 2 * n) chosen[count++] = self->basic[i] - n;
    double *system = self->rows, *solved = right + n;
    memset(solved, 0, (size_t)n * sizeof *solved);
    for (int32_t i = 0; i < count; i++) {
        right[i] = -self->scale[chosen[i]] * q[chosen[i]];
        for (int32_t j = 0; j < count; j++)
            system[(int64_t)i * count + j] =
                self->scale[chosen[i]] * matrix[(int64_t)chosen[i] * n + chosen[j]] * self->scale[chosen[j]];
    }
    if (tinker_pivoted_solve(count, system, right, order, TINKER_SMALLEST_PIVOT) == count)
        for (int32_t i = 0; i < count; i++)
            solved[chosen[i]] = right[i] * self->scale[chosen[i]];
    for (int32_t pass = 0; pass < 2; pass++) {
        double floor = pass == 0 ? 0 : FLOOR * unit;
        if (holds(self, matrix, q, floor, solved))
            memcpy(z, solved, (size_t)n * sizeof *z);
        else if (!holds(self, matrix, q, floor, z))
            continue;
        return TRUE;
    }
    return FALSE;
}

TinkerLcpResult tinker_lcp_solve(int32_t n, const double *matrix, const double *q, double *z, double *room)
{
    static const double apart[] = {TINKER_SET_APART, TINKER_SET_LITTLE_APART};
    Dictionary self = {.n = n, .stride = n + 2, .rows = room};
    self.scale = room + (int64_t)n * self.stride;
    double *right = self.scale + n, *found = right + 2 * n;
    self.basic = (int32_t *)(void *)(found + n);
    self.other = self.basic + n;
    gboolean negative = FALSE;
    for (int32_t i = 0; i < n; i++) {
        z[i] = 0;
        negative |= !(q[i] >= 0);
    }
    if (!negative) return TINKER_LCP_SOLVED;
    TinkerLcpResult result = TINKER_LCP_RAY;
    gboolean ended = FALSE;
    for (gsize i = 0; i < G_N_ELEMENTS(apart); i++) {
        fill(&self, matrix, q, apart[i]);
        const TinkerLcpResult walked = walk(&self);
        const gboolean ends = walked == TINKER_LCP_SOLVED, holds = ends && finish(&self, matrix, q, found, right);
        if (holds || (ends && !ended)) memcpy(z, found, (size_t)n * sizeof *z);
        if (holds) return TINKER_LCP_SOLVED;
        if (walked != TINKER_LCP_RAY) result = TINKER_LCP_GAVE_UP;
        ended |= ends;
    }
    return result;
}
