/* Products of the forces' derivatives with a vector: what implicit halves of a step and the forecast of a stable step
 * need. Line laws and fields with derivatives give theirs exactly. Of the others, what depends on velocities is found
 * by differences along the vector: an implicit step would not converge without. What depends on places is left out,
 * which a forecast of a stable step can bear. */
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/force/derivatives.h"
#include "physics/force/forces.h"
#include "physics/force/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

/* block times the difference of d at the ends: a pull on a, the opposite on b. */
static void add_line(const TinkerModel *model, int32_t a, int32_t b, const double block[4], const double *d,
                     double *force)
{
    double at_a[2], at_b[2];
    tinker_model_at_point(model, a, d, at_a);
    tinker_model_at_point(model, b, d, at_b);
    double dx = at_b[0] - at_a[0], dy = at_b[1] - at_a[1];
    double fx = block[0] * dx + block[1] * dy, fy = block[2] * dx + block[3] * dy;
    force[2 * a] += fx;
    force[2 * a + 1] += fy;
    force[2 * b] -= fx;
    force[2 * b + 1] -= fy;
}

static void line_block(const TinkerLineDerivatives *line, gboolean damping, double block[4])
{
    if (damping)
        tinker_line_damping(line, block);
    else
        tinker_line_stiffness(line, block);
}

static void add_merged_stiffness(const TinkerModel *model, const double *d, double *force)
{
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < lines->count; i++) {
        TinkerLineDerivatives line = tinker_merged_line_derivatives(model, i);
        double block[4];
        tinker_line_stiffness(&line, block);
        add_line(model, lines->a[i], lines->b[i], block, d, force);
    }
}

/* Every step of a damped run comes here: of a line no more is worked out than its direction, which is 0 at one place.
 */
static void add_merged_damping(const TinkerModel *model, const double *d, double *force)
{
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < lines->count; i++) {
        TinkerLineDerivatives line;
        double block[4];
        if (lines->damping[i] == 0) continue;
        tinker_line_geometry(model, lines->a[i], lines->b[i], &line);
        line.damping = lines->damping[i];
        tinker_line_damping(&line, block);
        add_line(model, lines->a[i], lines->b[i], block, d, force);
    }
}

/* A line that cannot be worked out is left out. */
static void add_asked(TinkerModel *model, const TinkerAskedBatch *asked, gboolean damping, const double *d,
                      double *force)
{
    for (int32_t i = 0; i < asked->batch->count; i++) {
        TinkerLineDerivatives line;
        double block[4];
        if (tinker_asked_line_derivatives(model, asked, i, &line) != TINKER_OK) continue;
        line_block(&line, damping, block);
        add_line(model, asked->end_points[2 * i], asked->end_points[2 * i + 1], block, d, force);
    }
}

/* A field without derivatives has none here. */
static void add_field(TinkerModel *model, const TinkerAskedBatch *asked, gboolean damping, const double *d,
                      double *force)
{
    const TinkerBlockBatch *batch = asked->batch;
    const TinkerField *field = batch->block_class->physics->field;
    double *jacobian = model->chunk; /* has room for 8 a body */
    TinkerBodies bodies = {sizeof(TinkerBodies), model->bodies, model->point, model->mass, 0, model->bodies};
    TinkerBatch view = tinker_model_view(model, batch, 0, batch->count, model->column_views);
    if (field->derivatives == NULL ||
        TINKER_CALL_BATCH(batch, "derivatives", &view, field->derivatives(&view, &bodies, jacobian)) != TINKER_OK)
        return;
    for (int32_t i = 0; i < model->bodies; i++) {
        const double *j = jacobian + 8 * (gsize)i + (damping ? 4 : 0);
        force[2 * i] += j[0] * d[2 * i] + j[1] * d[2 * i + 1];
        force[2 * i + 1] += j[2] * d[2 * i] + j[3] * d[2 * i + 1];
    }
}

/* Differences of velocities ---------------------------------------------------------------------------------------- */

static void add_scaled(int32_t count, double scale, const double *values, double *sum)
{
    for (int32_t i = 0; i < count; i++)
        sum[i] += scale * values[i];
}

static gboolean has_derivatives(const TinkerAskedBatch *asked)
{
    return asked->batch->block_class->physics->field->derivatives != NULL;
}

/* Adds `scale` times the forces at the velocities in the points. */
static TinkerStatus add_forces_now(TinkerModel *model, double scale, double *sum)
{
    const double *force;
    for (guint i = 0; i < model->asked_forces->len; i++) {
        const TinkerAskedBatch *asked = &g_array_index(model->asked_forces, TinkerAskedBatch, i);
        const TinkerBlockBatch *batch = asked->batch;
        for (int32_t first = 0; first < batch->count; first += TINKER_CHUNK) {
            int32_t count = MIN(TINKER_CHUNK, batch->count - first), from = batch->end_offsets[first];
            const int32_t *points = asked->end_points + from;
            TinkerElementForces on;
            TinkerStatus status = tinker_model_ask_element(model, batch, points, first, count, &on);
            if (status != TINKER_OK) return status;
            for (int32_t e = 0; e < batch->end_offsets[first + count] - from; e++) {
                add_scaled(2, scale, on.force + 2 * e, sum + 2 * points[e]);
                if (on.torque != NULL) sum[2 * on.turns[e]] += scale * on.torque[e];
            }
        }
    }
    for (guint i = 0; i < model->asked_fields->len; i++) {
        const TinkerAskedBatch *asked = &g_array_index(model->asked_fields, TinkerAskedBatch, i);
        if (has_derivatives(asked)) continue;
        TinkerStatus status = tinker_model_ask_field(model, asked->batch, 0, asked->batch->count, &force);
        if (status != TINKER_OK) return status;
        add_scaled(2 * model->bodies, scale, force, sum);
    }
    return TINKER_OK;
}

static void set_velocities(TinkerModel *model, double scale, const double *d)
{
    double *v = model->velocity_kept + model->coordinates;
    for (int32_t i = 0; i < model->coordinates; i++)
        v[i] = model->velocity_kept[i] + scale * d[i];
    tinker_model_set_velocities(model, v);
}

static void keep_velocities(TinkerModel *model)
{
    for (int32_t i = 0; i < model->bodies; i++) {
        model->velocity_kept[2 * i] = model->point[i].vx;
        model->velocity_kept[2 * i + 1] = model->point[i].vy;
    }
    for (int32_t k = 0; k < model->turning; k++)
        model->velocity_kept[2 * model->bodies + k] = model->turns[k].speed;
}

static gboolean needs_differences(const TinkerModel *model)
{
    gboolean needs = model->asked_forces->len > 0;
    for (guint i = 0; i < model->asked_fields->len; i++)
        needs |= !has_derivatives(&g_array_index(model->asked_fields, TinkerAskedBatch, i));
    return needs;
}

/* The forces at two velocities, either side of the present one by `step` times d, the one less the other, times
 * `scale`. */
static TinkerStatus add_difference(TinkerModel *model, double step, const double *d, double scale, double *force)
{
    keep_velocities(model);
    set_velocities(model, step, d);
    TinkerStatus status = add_forces_now(model, scale, force);
    set_velocities(model, -step, d);
    if (status == TINKER_OK) status = add_forces_now(model, -scale, force);
    tinker_model_set_velocities(model, model->velocity_kept);
    return status;
}

/* Most such forces know nothing of velocities, and their differences would cost two evaluations a product for nothing.
 * Tried once, with `d`, scratch of 2 a body; uses model->force. */
static TinkerStatus try_velocities(TinkerModel *model, double *d)
{
    for (int32_t i = 0; i < model->coordinates; i++)
        d[i] = 1.0 + 0.5 * sin(12.9898 * (i + 1));
    memset(model->force, 0, 2 * (gsize)model->points * sizeof(double));
    TinkerStatus status = add_difference(model, 1, d, 1, model->force);
    gboolean feels = FALSE;
    for (int32_t i = 0; i < 2 * model->points; i++)
        feels |= model->force[i] != 0;
    if (status == TINKER_OK) model->feels_velocity = feels ? 1 : -1;
    return status;
}

/* The step has a floor, as in jacobian-asked.c: of a motion that has died away the difference would be rounding. */
static TinkerStatus add_differences(TinkerModel *model, const double *d, double *force)
{
    double greatest = tinker_largest(model->coordinates, d), speed = 1;
    if (!(greatest > 0) || !isfinite(greatest)) return TINKER_OK;
    for (int32_t i = 0; i < model->bodies; i++)
        speed = fmax(speed, fmax(fabs(model->point[i].vx), fabs(model->point[i].vy)));
    double step = TINKER_PRODUCT_STEP * speed / greatest;
    return add_difference(model, step, d, 0.5 / step, force);
}

/* All -------------------------------------------------------------------------------------------------------------- */

/* The torque of a force also changes as its arm r turns: by -r . F an angle. */
static void add_turned_arms(const TinkerModel *model, const double *d, double *out)
{
    for (int32_t point = model->first_attachment; point < model->first_support; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        const TinkerTurn *turn = &model->turns[model->turn_of[at->body]];
        const double along = at->arm[0] * at->force[0] + at->arm[1] * at->force[1];
        const int32_t i = 2 * model->bodies + model->turn_of[at->body];
        out[i] -= along / (turn->gyration * turn->gyration) * model->inverse_mass[at->body] * d[i];
    }
}

static TinkerStatus product(TinkerModel *model, gboolean damping, const double *d, double *out)
{
    gboolean differs = damping && model->feels_velocity >= 0 && needs_differences(model);
    if (differs && model->feels_velocity == 0) {
        TinkerStatus tried = try_velocities(model, out);
        if (tried != TINKER_OK) return tried;
        differs = model->feels_velocity > 0;
    }
    memset(model->force, 0, 2 * (gsize)model->points * sizeof(double));
    if (damping)
        add_merged_damping(model, d, model->force);
    else
        add_merged_stiffness(model, d, model->force);
    for (guint i = 0; i < model->asked_lines->len; i++)
        add_asked(model, &g_array_index(model->asked_lines, TinkerAskedBatch, i), damping, d, model->force);
    for (guint i = 0; i < model->asked_fields->len; i++)
        add_field(model, &g_array_index(model->asked_fields, TinkerAskedBatch, i), damping, d, model->force);
    TinkerStatus status = differs ? add_differences(model, d, model->force) : TINKER_OK;
    if (model->turning > 0) tinker_model_reduce_forces(model);
    for (int32_t i = 0; i < model->coordinates && status == TINKER_OK; i++) {
        out[i] = model->force[i] * model->inverse_mass[tinker_model_moved_by(model, i)];
        if (damping && i < 2 * model->bodies) out[i] -= model->field_drag * model->inverse_mass[i / 2] * d[i];
    }
    if (!damping && status == TINKER_OK) add_turned_arms(model, d, out);
    return status;
}

TinkerStatus tinker_model_damping_product(TinkerModel *model, const double *dv, double *out)
{
    return product(model, TRUE, dv, out);
}

TinkerStatus tinker_model_stiffness_product(TinkerModel *model, const double *dq, double *out)
{
    return product(model, FALSE, dq, out);
}
