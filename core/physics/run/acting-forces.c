/* The model's forces told apart. The model merges and adds up what it can, so each block's own law is asked here, for
 * the state that the sample is evaluated at; multipliers and forces of contacts come from that evaluation. */
#include "physics/run/acting-forces-private.h"

#include "physics/contact/contact-pins.h"
#include "physics/contact/contacts.h"
#include "physics/force/forces.h"
#include "physics/model/angles.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/run/simulation-private.h"

GArray *tinker_acting_forces_array(void)
{
    return g_array_new(FALSE, FALSE, sizeof(TinkerActingForce));
}

TinkerActingForces *tinker_acting_forces_new(TinkerModel *model)
{
    TinkerActingForces *forces = g_new0(TinkerActingForces, 1);
    forces->model = model;
    forces->acceleration = g_new0(double, (gsize)MAX(model->coordinates, 1));
    forces->touches = g_array_new(FALSE, FALSE, sizeof(TinkerActingTouch));
    return forces;
}

void tinker_acting_forces_free(TinkerActingForces *forces)
{
    if (forces == NULL) return;
    g_free(forces->acceleration);
    g_array_unref(forces->touches);
    g_free(forces);
}

const GArray *tinker_acting_forces_touches(const TinkerActingForces *forces)
{
    return forces->touches;
}

/* A force that acts at a point of the model, and a torque beside it: end `end` of the block, or -1. */
static void add(TinkerActingForces *forces, TinkerActingKind kind, TinkerBlockId by, int32_t end, int32_t point,
                double fx, double fy, double torque)
{
    const TinkerModel *model = forces->model;
    const TinkerPoint *at = &model->point[point];
    TinkerActingForce force = {.by = by,
                               .on = tinker_model_block_of(model, point),
                               .kind = kind,
                               .x = at->x + model->origin[0],
                               .y = at->y + model->origin[1],
                               .fx = fx,
                               .fy = fy,
                               .torque = tinker_acting_torque_on(model, point, torque),
                               .end = end,
                               .touch = -1};
    g_array_append_val(forces->out, force);
}

static TinkerStatus add_lines(TinkerActingForces *forces, const TinkerBlockBatch *batch, const int32_t *end_points)
{
    TinkerModel *model = forces->model;
    for (int32_t first = 0; first < batch->count; first += TINKER_CHUNK) {
        int32_t count = MIN(TINKER_CHUNK, batch->count - first);
        const int32_t *points = end_points + 2 * first;
        TinkerLineChunk chunk;
        TinkerBatch view = tinker_model_view(model, batch, first, count, model->column_views);
        TinkerStatus status = tinker_model_ask_lines(model, batch, points, &view, &chunk);
        if (status != TINKER_OK) return status;
        for (int32_t i = 0; i < count; i++) {
            double fx = chunk.tension[i] * chunk.x[i], fy = chunk.tension[i] * chunk.y[i];
            add(forces, TINKER_ACTING_LINE, batch->ids[first + i], 0, points[2 * i], fx, fy, 0);
            add(forces, TINKER_ACTING_LINE, batch->ids[first + i], 1, points[2 * i + 1], -fx, -fy, 0);
        }
    }
    return TINKER_OK;
}

static TinkerStatus add_elements(TinkerActingForces *forces, const TinkerBlockBatch *batch, const int32_t *end_points)
{
    for (int32_t row = 0; row < batch->count; row++) {
        const int32_t *points = end_points + batch->end_offsets[row];
        TinkerElementForces on;
        TinkerStatus status = tinker_model_ask_element(forces->model, batch, points, row, 1, &on);
        if (status != TINKER_OK) return status;
        for (int32_t e = 0; e < batch->end_offsets[row + 1] - batch->end_offsets[row]; e++) {
            add(forces, TINKER_ACTING_ELEMENT, batch->ids[row], e, points[e], on.force[2 * e], on.force[2 * e + 1],
                on.torque != NULL ? on.torque[e] : 0);
        }
    }
    return TINKER_OK;
}

static TinkerStatus add_fields(TinkerActingForces *forces, const TinkerBlockBatch *batch)
{
    for (int32_t row = 0; row < batch->count; row++) {
        const double *force;
        TinkerStatus status = tinker_model_ask_field(forces->model, batch, row, 1, &force);
        if (status != TINKER_OK) return status;
        for (int32_t i = 0; i < forces->model->bodies; i++)
            add(forces, TINKER_ACTING_FIELD, batch->ids[row], -1, i, force[2 * i], force[2 * i + 1], 0);
    }
    return TINKER_OK;
}

/* Of what is wound on a body: it pulls where it leaves that, along its line, which passes the centre by
 * (fy, -fx) torque / f^2; so there is no torque beside the force that was added last. */
static void pull_at_rim(TinkerActingForces *forces)
{
    TinkerActingForce *force = &g_array_index(forces->out, TinkerActingForce, forces->out->len - 1);
    const double square = force->fx * force->fx + force->fy * force->fy;
    if (!(square > 0)) return;
    force->x += force->torque * force->fy / square;
    force->y -= force->torque * force->fx / square;
    force->torque = 0;
}

/* Constraints pull each end by J^T lambda: the rows of one block on one end together. */
static void add_constraints(TinkerActingForces *forces, const TinkerConstraintBatch *part)
{
    const TinkerConstraints *all = &forces->model->constraints;
    const TinkerBlockBatch *batch = part->batch;
    int32_t rows = part->constraint->rows;
    const gboolean is_wound = tinker_block_class_is_wound(batch->block_class);
    const gboolean rubs = part->constraint->friction != NULL && forces->model->contacts != NULL;
    g_autofree double *torques = rubs ? g_new0(double, MAX(batch->end_count, 1)) : NULL;
    if (rubs) tinker_contacts_pin_torques(forces->model->contacts, part, torques);
    for (int32_t i = 0; i < batch->count; i++) {
        int32_t from = batch->end_offsets[i], ends = batch->end_offsets[i + 1] - from;
        for (int32_t e = 0; e < ends; e++) {
            double fx = 0, fy = 0, torque = rubs ? torques[from + e] : 0;
            for (int32_t r = 0; r < rows; r++) {
                const int32_t row = part->first_row + i * rows + r;
                const double *jacobian = all->jacobian + 2 * (all->row_starts[row] + e);
                fx += all->lambda[row] * jacobian[0];
                fy += all->lambda[row] * jacobian[1];
                if (part->angles != NULL)
                    torque += all->lambda[row] * part->angles->angular[rows * from + r * ends + e];
            }
            add(forces, TINKER_ACTING_CONSTRAINT, batch->ids[i], e, part->end_points[from + e], fx, fy, torque);
            if (e == 0 && is_wound) pull_at_rim(forces);
        }
    }
}

/* What keeps a bar straight pushes across it: at its ends and between, as the rod does that reaches across. */
static void add_straight_rows(TinkerActingForces *forces)
{
    const TinkerConstraints *all = &forces->model->constraints;
    for (int32_t row = all->first_straight; row < all->rows; row++)
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            add(forces, TINKER_ACTING_CONSTRAINT, all->blocks[row], -1, all->ends_at[e],
                all->lambda[row] * all->jacobian[2 * e], all->lambda[row] * all->jacobian[2 * e + 1], 0);
}

static TinkerStatus add_all(TinkerActingForces *forces)
{
    const TinkerModel *model = forces->model;
    TinkerStatus status = TINKER_OK;
    for (guint i = 0; status == TINKER_OK && i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        const int32_t *points = tinker_model_end_points(model, batch);
        if (physics == NULL) continue;
        if (physics->line_law != NULL) status = add_lines(forces, batch, points);
        if (status == TINKER_OK && physics->force_element != NULL) status = add_elements(forces, batch, points);
        if (status == TINKER_OK && physics->field != NULL) status = add_fields(forces, batch);
    }
    for (guint i = 0; status == TINKER_OK && i < model->constraints.batches->len; i++)
        add_constraints(forces, &g_array_index(model->constraints.batches, TinkerConstraintBatch, i));
    if (status == TINKER_OK) add_straight_rows(forces);
    if (status != TINKER_OK) return status;
    tinker_acting_add_contacts(forces);
    return TINKER_OK;
}

gboolean tinker_acting_forces_at(TinkerActingForces *forces, TinkerSimulation *simulation, GArray *out, GError **error)
{
    TinkerModel *model = forces->model;
    g_assert(simulation->all->model == model);
    g_array_set_size(out, 0);
    g_array_set_size(forces->touches, 0);
    forces->out = out;
    model->failure = "";
    TinkerStatus status = tinker_sampler_look_at(model, simulation->all->sample_time, simulation->all->sample_q,
                                                 simulation->all->sample_v, forces->acceleration);
    if (status == TINKER_OK) status = add_all(forces);
    if (status == TINKER_OK) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN, "the forces at t = %g s cannot be told apart%s%s",
                simulation->all->sample_time, model->failure[0] != '\0' ? ": " : "", model->failure);
    return FALSE;
}
