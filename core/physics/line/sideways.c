/* Whether motion along a line is stable across it.
 *
 * Across the line a connector acts as a spring of stiffness T / L, with T its tension and L its length at rest: pressed
 * ones push bodies off the line. Rest is found along the line under the steady loads; a part that hangs on nothing is
 * taken in the frame that falls with it. The smallest eigenvalue of M^-1/2 K M^-1/2, with K the stiffness across, comes
 * from power iteration on its distance to Gershgorin's upper bound. */
#include <math.h>
#include <string.h>

#include "physics/line/linear-form-data.h"
#include "physics/line/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

#define ITERATIONS 400

/* The lines of a model as a graph along one direction. */
typedef struct {
    const TinkerModel *model;
    const TinkerLine *line;
    double *displacement; /* of each body: from its start to rest */
    double *sum, *other;  /* of each body: for work */
    int32_t *part_of;     /* of each body: its part, by its first body */
    gboolean *held;       /* of each part: whether it hangs on a support */
} Rest;

static double along(const Rest *rest, int32_t point)
{
    const double *direction = rest->line->direction;
    double place[2];
    tinker_model_start_place(rest->model, point, place);
    return place[0] * direction[0] + place[1] * direction[1];
}

static double distance(const Rest *rest, int32_t i)
{
    return along(rest, rest->model->lines.b[i]) - along(rest, rest->model->lines.a[i]);
}

/* Tension of line i where its ends are d apart (signed). */
static double tension(const Rest *rest, int32_t i, double d)
{
    const TinkerMergedLines *lines = &rest->model->lines;
    return lines->tension[i] + lines->stiffness[i] * (fabs(d) - lines->length[i]);
}

static int32_t part_of(int32_t *parent, int32_t body)
{
    while (parent[body] != body)
        body = parent[body] = parent[parent[body]];
    return body;
}

static void find_parts(Rest *rest)
{
    const TinkerModel *model = rest->model;
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < model->bodies; i++)
        rest->part_of[i] = i;
    for (int pass = 0; pass < 2; pass++) { /* first which bodies belong together, then which parts hang on something */
        for (int32_t i = 0; i < lines->count; i++) {
            int32_t a = lines->a[i], b = lines->b[i];
            if (!(lines->stiffness[i] > 0) || MIN(a, b) >= model->bodies) continue;
            gboolean inner = MAX(a, b) < model->bodies;
            if (pass == 0 && inner) {
                int32_t first = part_of(rest->part_of, a), second = part_of(rest->part_of, b);
                rest->part_of[MAX(first, second)] = MIN(first, second);
            }
            if (pass == 1 && !inner) rest->held[part_of(rest->part_of, MIN(a, b))] = TRUE;
        }
    }
    for (int32_t i = 0; i < model->bodies; i++)
        rest->part_of[i] = part_of(rest->part_of, i);
}

/* Forces along the line at the start, less what makes a part without a support fall. */
static void find_loads(const Rest *rest, double *load)
{
    const TinkerModel *model = rest->model;
    const double *direction = rest->line->direction, *constant = model->constant_acceleration;
    double *sum = rest->sum, *mass = rest->other;
    memset(sum, 0, 2 * (gsize)model->bodies * sizeof(double));
    for (int32_t i = 0; i < model->bodies; i++)
        load[i] = model->mass[i] * (constant[2 * i] * direction[0] + constant[2 * i + 1] * direction[1]);
    for (guint i = 0; i < model->driven->len; i++) {
        const TinkerDrivenForce *driven = &g_array_index(model->driven, TinkerDrivenForce, i);
        double along_line = driven->direction[0] * direction[0] + driven->direction[1] * direction[1];
        if (driven->point < model->bodies) load[driven->point] += tinker_driven_steady(driven) * along_line;
    }
    for (int32_t i = 0; i < model->lines.count; i++) {
        double d = distance(rest, i), pull = copysign(tension(rest, i, d), d * tension(rest, i, d));
        if (model->lines.a[i] < model->bodies) load[model->lines.a[i]] += pull;
        if (model->lines.b[i] < model->bodies) load[model->lines.b[i]] -= pull;
    }
    for (int32_t i = 0; i < model->bodies; i++) {
        sum[rest->part_of[i]] += load[i];
        mass[rest->part_of[i]] += model->mass[i];
    }
    for (int32_t i = 0; i < model->bodies; i++)
        if (!rest->held[rest->part_of[i]]) load[i] -= model->mass[i] * sum[rest->part_of[i]] / mass[rest->part_of[i]];
}

/* Solves K u = loads where no line joins two bodies, so that K is diagonal. */
static gboolean find_rest_apart(Rest *rest, double stiffest)
{
    const TinkerModel *model = rest->model;
    const TinkerMergedLines *lines = &model->lines;
    double *stiffness = rest->sum;
    find_loads(rest, rest->displacement);
    memset(stiffness, 0, (gsize)model->bodies * sizeof(double));
    for (int32_t i = 0; i < lines->count; i++)
        if (MIN(lines->a[i], lines->b[i]) < model->bodies)
            stiffness[MIN(lines->a[i], lines->b[i])] += lines->stiffness[i];
    for (int32_t i = 0; i < model->bodies; i++) {
        if (!rest->held[i]) stiffness[i] += stiffest > 0 ? stiffest : 1.0;
        if (!(stiffness[i] > 0)) return FALSE;
        rest->displacement[i] *= 1.0 / stiffness[i];
    }
    return TRUE;
}

/* Solves K u = loads; a part that hangs on nothing is held at its first body. */
static gboolean find_rest(Rest *rest)
{
    const TinkerModel *model = rest->model;
    const TinkerMergedLines *lines = &model->lines;
    double stiffest = 0;
    gsize count = 0;
    for (int32_t i = 0; i < lines->count; i++) {
        stiffest = MAX(stiffest, lines->stiffness[i]);
        if (MAX(lines->a[i], lines->b[i]) < model->bodies) count++;
    }
    if (count == 0) return find_rest_apart(rest, stiffest);
    g_autofree int *rows = g_new(int, count), *columns = g_new(int, count);
    count = 0;
    for (int32_t i = 0; i < lines->count; i++) {
        if (MAX(lines->a[i], lines->b[i]) >= model->bodies) continue;
        rows[count] = lines->a[i];
        columns[count++] = lines->b[i];
    }
    TinkerSparseLdl *ldl = tinker_sparse_ldl_new(model->bodies, rows, columns, count);
    if (ldl == NULL) return FALSE;
    double *values = tinker_sparse_ldl_values(ldl);
    tinker_sparse_ldl_clear(ldl);
    for (int32_t i = 0; i < lines->count; i++) {
        int32_t a = lines->a[i], b = lines->b[i];
        if (a < model->bodies) values[tinker_sparse_ldl_slot(ldl, a, a)] += lines->stiffness[i];
        if (b < model->bodies) values[tinker_sparse_ldl_slot(ldl, b, b)] += lines->stiffness[i];
        if (MAX(a, b) < model->bodies) values[tinker_sparse_ldl_slot(ldl, a, b)] -= lines->stiffness[i];
    }
    for (int32_t i = 0; i < model->bodies; i++)
        if (rest->part_of[i] == i && !rest->held[i])
            values[tinker_sparse_ldl_slot(ldl, i, i)] += stiffest > 0 ? stiffest : 1.0;
    find_loads(rest, rest->displacement);
    gboolean solved = tinker_sparse_ldl_factor(ldl, 0, 0);
    if (solved) tinker_sparse_ldl_solve(ldl, rest->displacement);
    tinker_sparse_ldl_free(ldl);
    return solved;
}

/* Stiffness across of line i where its ends are d apart: T / L, and at one place that of a spring without length. */
static double stiffness_across(const Rest *rest, int32_t i, double d)
{
    if (d != 0) return tension(rest, i, d) / fabs(d);
    return tension(rest, i, 0) == 0 ? rest->model->lines.stiffness[i] : 0;
}

/* Stiffness across of each line at rest; the largest, by size, of a body's sum over its mass is answered. */
static double find_across(const Rest *rest, double *across)
{
    const TinkerModel *model = rest->model;
    const TinkerMergedLines *lines = &model->lines;
    double *sum = rest->sum, most = 0;
    memset(sum, 0, (gsize)model->bodies * sizeof(double));
    for (int32_t i = 0; i < lines->count; i++) {
        int32_t a = lines->a[i], b = lines->b[i];
        double d = distance(rest, i);
        if (a < model->bodies) d -= rest->displacement[a];
        if (b < model->bodies) d += rest->displacement[b];
        across[i] = stiffness_across(rest, i, d);
        if (a < model->bodies) sum[a] += fabs(across[i]);
        if (b < model->bodies) sum[b] += fabs(across[i]);
    }
    for (int32_t i = 0; i < model->bodies; i++)
        most = MAX(most, 2 * sum[i] * model->inverse_mass[i]);
    return most;
}

/* y = (bound - M^-1/2 K M^-1/2) x */
static void multiply(const TinkerModel *model, const double *across, double bound, const double *x, double *y)
{
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < model->bodies; i++)
        y[i] = bound * x[i];
    for (int32_t i = 0; i < lines->count; i++) {
        int32_t a = lines->a[i], b = lines->b[i];
        double root_a = a < model->bodies ? sqrt(model->inverse_mass[a]) : 0;
        double root_b = b < model->bodies ? sqrt(model->inverse_mass[b]) : 0;
        double pull = across[i] * ((b < model->bodies ? root_b * x[b] : 0) - (a < model->bodies ? root_a * x[a] : 0));
        if (a < model->bodies) y[a] += root_a * pull;
        if (b < model->bodies) y[b] -= root_b * pull;
    }
}

static double smallest_eigenvalue(const TinkerModel *model, const double *across, double bound)
{
    g_autofree double *x = g_new(double, model->bodies), *y = g_new(double, model->bodies);
    double quotient = 0;
    for (int32_t i = 0; i < model->bodies; i++)
        x[i] = 1.0 + 0.5 * sin(12.9898 * (i + 1));
    for (int iteration = 0; iteration < ITERATIONS; iteration++) {
        double size = 0, product = 0;
        for (int32_t i = 0; i < model->bodies; i++)
            size += x[i] * x[i];
        size = sqrt(size);
        if (!(size > 0)) return 0;
        for (int32_t i = 0; i < model->bodies; i++)
            x[i] /= size;
        multiply(model, across, bound, x, y);
        for (int32_t i = 0; i < model->bodies; i++)
            product += x[i] * y[i];
        quotient = bound - product;
        for (int32_t i = 0; i < model->bodies; i++)
            x[i] = y[i];
    }
    return quotient;
}

double tinker_model_growth_across(TinkerModel *model, const TinkerLine *line)
{
    const gsize n = (gsize)model->bodies, lines = (gsize)model->lines.count;
    g_autofree double *room = g_malloc0((3 * n + lines) * sizeof(double) + n * (sizeof(int32_t) + sizeof(gboolean)));
    double *across = room + 3 * n;
    int32_t *parts = (int32_t *)(gpointer)(across + lines);
    Rest rest = {model, line, room, room + n, room + 2 * n, parts, parts + n};
    find_parts(&rest);
    if (!find_rest(&rest)) return 0;
    double bound = find_across(&rest, across), stiffest = 0, least = 0;
    for (int32_t i = 0; i < model->lines.count; i++) {
        double mobility = 0;
        if (model->lines.a[i] < model->bodies) mobility += model->inverse_mass[model->lines.a[i]];
        if (model->lines.b[i] < model->bodies) mobility += model->inverse_mass[model->lines.b[i]];
        stiffest = MAX(stiffest, model->lines.stiffness[i] * mobility);
        least = MIN(least, across[i] * mobility);
    }
    if (least >= -TINKER_NEGLIGIBLE_STIFFNESS * stiffest) return 0;
    double eigenvalue = smallest_eigenvalue(model, across, bound);
    return eigenvalue < -TINKER_NEGLIGIBLE_STIFFNESS * stiffest ? sqrt(-eigenvalue) : 0;
}
