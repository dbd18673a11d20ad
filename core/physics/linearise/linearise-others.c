/* What is neither line nor constraint, made linear. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/linearise/linearise-private.h"
#include "physics/linearise/tolerances.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"
#include "physics/system/jacobian.h"

/* Takes terms off a dense matrix, and adds up in `taken` how much that was of each entry. */
static void take_terms(const TinkerLinearisation *linear, const GArray *terms, double *matrix, double *taken)
{
    gsize n = (gsize)linear->size;
    const TinkerLinearEntry *entries = (const TinkerLinearEntry *)(const void *)linear->entries->data;
    for (guint i = 0; i < terms->len; i++) {
        const TinkerLinearTerm *term = &g_array_index(terms, TinkerLinearTerm, i);
        const TinkerLinearEntry *first = entries + term->first, *end = first + term->count;
        for (const TinkerLinearEntry *r = first; r < end; r++)
            for (const TinkerLinearEntry *c = first; c < end; c++) {
                if (r->coordinate >= linear->size || c->coordinate >= linear->size) continue;
                gsize place = (gsize)r->coordinate + n * (gsize)c->coordinate;
                double part = term->weight * r->value * c->value;
                matrix[place] -= part;
                taken[place] += fabs(part);
            }
    }
}

/* What is left of a dense matrix within rounding of what was taken off it is nothing. */
static void clear_rounding(gsize n, const double *taken, double *matrix)
{
    g_autofree double *most = g_new0(double, MAX(n, 1));
    for (gsize c = 0; c < n; c++)
        for (gsize r = 0; r < n; r++)
            most[r] = fmax(most[r], taken[r + n * c]);
    for (gsize c = 0; c < n; c++)
        for (gsize r = 0; r < n; r++)
            if (fabs(matrix[r + n * c]) <= 64 * DBL_EPSILON * fmax(most[r], most[c])) matrix[r + n * c] = 0;
}

/* Leaves what is no line and no turned arm, whose parts are terms of their own, or rounding. */
static void take_lines(const TinkerLinearisation *linear, double *stiffness, double *damping)
{
    const gsize n = (gsize)linear->size;
    g_autofree double *taken = g_new0(double, n *n), *damped = g_new0(double, n *n);
    take_terms(linear, linear->stiffness, stiffness, taken);
    take_terms(linear, linear->rounding, stiffness, taken);
    clear_rounding(n, taken, stiffness);
    take_terms(linear, linear->damping, damping, damped);
    clear_rounding(n, damped, damping);
}

static gboolean is_zero(const double *x, gsize n)
{
    for (gsize i = 0; i < n; i++)
        if (x[i] != 0) return FALSE;
    return TRUE;
}

static double *spread(const TinkerPattern *pattern, const double *values)
{
    gsize n = (gsize)pattern->size;
    double *matrix = g_new0(double, MAX(n * n, 1));
    for (gsize row = 0; row < n; row++)
        for (int32_t e = pattern->row_starts[row]; e < pattern->row_starts[row + 1]; e++)
            matrix[row + n * (gsize)pattern->columns[e]] = values[e];
    return matrix;
}

/* The forces of a field on all bodies. */
static TinkerStatus field_forces(TinkerModel *model, const TinkerAskedBatch *asked, double *force)
{
    const TinkerBlockBatch *batch = asked->batch;
    TinkerBodies bodies = {sizeof(TinkerBodies), model->bodies, model->point, model->mass, 0, model->bodies};
    TinkerBatch view = tinker_model_view(model, batch, 0, batch->count, model->column_views);
    const TinkerField *field = batch->block_class->physics->field;
    TinkerStatus status = TINKER_CALL_BATCH(batch, "force", &view, field->force(&view, &bodies, force));
    if (status == TINKER_OK || status == TINKER_RETRY_SMALLER) return status;
    return tinker_model_fail(model, batch, view.failed_instance, "force", view.failure);
}

/* What a field that couples bodies does to the others where one body is moved: the jacobian has what it does to that
 * one. */
static TinkerStatus add_coupling(TinkerLinearisation *linear, TinkerModel *model, const TinkerAskedBatch *asked,
                                 int32_t body)
{
    static const double weights[] = {1, -8, 0, 8, -1}; /* / 12 h */
    gsize n = (gsize)linear->size;
    double step = TINKER_COUPLING_STEP * linear->extent;
    TinkerPoint *at = &model->point[body], kept = *at;
    double *coordinates[4] = {&at->x, &at->y, &at->vx, &at->vy};
    g_autofree double *force = g_new0(double, n);
    TinkerStatus status = TINKER_OK;
    for (int c = 0; c < 4; c++) {
        double *matrix = c < 2 ? linear->other_stiffness : linear->other_damping;
        double *column = matrix + n * (gsize)(2 * body + c % 2);
        for (int k = -2; k <= 2 && status == TINKER_OK; k++) {
            if (k == 0) continue;
            *coordinates[c] += k * step;
            status = field_forces(model, asked, force);
            *at = kept;
            for (gsize i = 0; i < n && status == TINKER_OK; i++)
                if (i / 2 != (gsize)body) column[i] -= weights[k + 2] * force[i] / (12 * step);
        }
    }
    return status;
}

static TinkerStatus add_couplings(TinkerLinearisation *linear, TinkerModel *model)
{
    TinkerStatus status = TINKER_OK;
    for (guint i = 0; i < model->asked_fields->len; i++) {
        const TinkerAskedBatch *asked = &g_array_index(model->asked_fields, TinkerAskedBatch, i);
        if (!asked->batch->block_class->physics->field->couples_bodies) continue;
        for (int32_t body = 0; body < model->bodies && status == TINKER_OK; body++)
            status = add_coupling(linear, model, asked, body);
    }
    return status;
}

TinkerStatus tinker_linear_add_others(TinkerLinearisation *linear, TinkerModel *model, const double *q,
                                      const double *still)
{
    if (model->asked_forces->len == 0 && model->asked_fields->len == 0) return TINKER_OK;
    TinkerJacobian *jacobian = tinker_jacobian_new(model);
    const TinkerPattern *pattern = tinker_jacobian_pattern(jacobian);
    g_autofree double *stiffness = g_new0(double, MAX(pattern->entries, 1));
    g_autofree double *damping = g_new0(double, MAX(pattern->entries, 1));
    TinkerStatus status = tinker_jacobian_evaluate(jacobian, model->time, q, still, stiffness, damping);
    if (status == TINKER_OK) {
        gsize places = (gsize)linear->size * (gsize)linear->size;
        linear->other_stiffness = spread(pattern, stiffness);
        linear->other_damping = spread(pattern, damping);
        take_lines(linear, linear->other_stiffness, linear->other_damping);
        status = add_couplings(linear, model);
        if (is_zero(linear->other_stiffness, places)) g_clear_pointer(&linear->other_stiffness, g_free);
        if (is_zero(linear->other_damping, places)) g_clear_pointer(&linear->other_damping, g_free);
    }
    tinker_jacobian_free(jacobian);
    return status;
}
