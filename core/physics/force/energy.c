/* Energies of a state: what bodies have by moving, and what blocks say that they store. */
#include <math.h>

#include "physics/force/forces.h"
#include "physics/force/tolerances.h"
#include "physics/model/angles.h"
#include "physics/model/failures.h"

static double kinetic_energy(const TinkerModel *model)
{
    double sum = 0;
    for (int32_t i = 0; i < model->bodies; i++) {
        const TinkerPoint *at = &model->point[i];
        sum += model->mass[i] * (at->vx * at->vx + at->vy * at->vy);
    }
    for (int32_t k = 0; k < model->turning; k++) {
        const TinkerTurn *turn = &model->turns[k];
        sum += model->mass[turn->body] * turn->speed * turn->speed;
    }
    return 0.5 * sum;
}

static double merged_lines_energy(const TinkerModel *model)
{
    const TinkerMergedLines *lines = &model->lines;
    double sum = model->merged_energy;
    for (int32_t i = 0; i < lines->count; i++) {
        const TinkerPoint *a = &model->point[lines->a[i]], *b = &model->point[lines->b[i]];
        double dx = b->x - a->x, dy = b->y - a->y;
        double stretch = sqrt(dx * dx + dy * dy) - lines->length[i];
        sum += stretch * (lines->tension[i] + 0.5 * lines->stiffness[i] * stretch);
    }
    return sum;
}

static double uniform_field_energy(const TinkerModel *model)
{
    double gx = model->field_acceleration[0], gy = model->field_acceleration[1], sum = 0;
    for (int32_t i = 0; i < model->bodies; i++)
        sum -= model->mass[i] * (gx * model->point[i].x + gy * model->point[i].y);
    return sum;
}

/* Whether a state is so far from all that is meant that a law may well overflow: the run diverges. */
static gboolean is_beyond(const TinkerModel *model)
{
    double sum = 0;
    for (int32_t i = 0; i < model->points; i++) {
        const TinkerPoint *at = &model->point[i];
        sum += fabs(at->x) + fabs(at->y) + fabs(at->vx) + fabs(at->vy);
    }
    return !(sum < TINKER_STATE_BEYOND);
}

/* What the instance in this row of the batch stores. */
static TinkerStatus add_stored(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, double stored,
                               double *sum)
{
    *sum += stored;
    if (isfinite(stored) || is_beyond(model)) return TINKER_OK;
    tinker_model_not_finite(model, batch, row, "energy");
    return TINKER_FAILED;
}

static TinkerStatus asked_lines_energy(TinkerModel *model, const TinkerAskedBatch *asked, double *sum)
{
    const TinkerBlockBatch *batch = asked->batch;
    double *length = model->chunk, *stored = model->chunk + model->chunk_rows;
    for (int32_t first = 0; first < batch->count; first += TINKER_CHUNK) {
        int32_t count = MIN(TINKER_CHUNK, batch->count - first);
        for (int32_t i = 0; i < count; i++) {
            const TinkerPoint *a = &model->point[asked->end_points[2 * (first + i)]];
            const TinkerPoint *b = &model->point[asked->end_points[2 * (first + i) + 1]];
            length[i] = hypot(b->x - a->x, b->y - a->y);
        }
        TinkerBatch view = tinker_model_view(model, batch, first, count, model->column_views);
        const TinkerLineLaw *law = batch->block_class->physics->line_law;
        if (TINKER_CALL_BATCH(batch, "energy", &view, law->energy(&view, length, stored)) != TINKER_OK)
            return tinker_model_fail(model, batch, first + MAX(view.failed_instance, 0), "energy", view.failure);
        for (int32_t i = 0; i < count; i++) {
            if (law->partly_stores != 0 && isnan(stored[i])) continue;
            TinkerStatus status = add_stored(model, batch, first + i, stored[i], sum);
            if (status != TINKER_OK) return status;
        }
    }
    return TINKER_OK;
}

static TinkerStatus asked_forces_energy(TinkerModel *model, const TinkerAskedBatch *asked, double *sum)
{
    const TinkerBlockBatch *batch = asked->batch;
    for (int32_t first = 0; first < batch->count; first += TINKER_CHUNK) {
        int32_t count = MIN(TINKER_CHUNK, batch->count - first);
        int32_t from = batch->end_offsets[first], ends = batch->end_offsets[first + count] - from;
        TinkerPoint *gathered = (TinkerPoint *)(void *)model->chunk;
        double *stored = (double *)(void *)(gathered + ends);
        for (int32_t e = 0; e < ends; e++)
            gathered[e] = model->point[asked->end_points[from + e]];
        TinkerBatch view = tinker_model_view(model, batch, first, count, model->column_views);
        const TinkerForceElement *element = batch->block_class->physics->force_element;
        if (asked->angles != NULL) {
            tinker_angles_gather(asked->angles, model, from, ends);
            tinker_angles_show(asked->angles, &view, from, ends);
        }
        if (TINKER_CALL_BATCH(batch, "energy", &view, element->energy(&view, gathered, stored)) != TINKER_OK)
            return tinker_model_fail(model, batch, first + MAX(view.failed_instance, 0), "energy", view.failure);
        for (int32_t i = 0; i < count; i++) {
            TinkerStatus status = add_stored(model, batch, first + i, stored[i], sum);
            if (status != TINKER_OK) return status;
        }
    }
    return TINKER_OK;
}

static TinkerStatus asked_field_energy(TinkerModel *model, const TinkerAskedBatch *asked, double *sum)
{
    const TinkerBlockBatch *batch = asked->batch;
    TinkerBodies bodies = {sizeof(TinkerBodies), model->bodies, model->point, model->mass, 0, model->bodies};
    TinkerBatch view = tinker_model_view(model, batch, 0, batch->count, model->column_views);
    double potential = 0;
    const TinkerField *field = batch->block_class->physics->field;
    if (TINKER_CALL_BATCH(batch, "energy", &view, field->energy(&view, &bodies, &potential)) != TINKER_OK)
        return tinker_model_fail(model, batch, view.failed_instance, "energy", view.failure);
    return add_stored(model, batch, 0, potential, sum);
}

static TinkerStatus add_asked(TinkerModel *model, GArray *batches,
                              TinkerStatus (*energy)(TinkerModel *, const TinkerAskedBatch *, double *), double *sum)
{
    for (guint i = 0; i < batches->len; i++) {
        const TinkerAskedBatch *asked = &g_array_index(batches, TinkerAskedBatch, i);
        TinkerStatus status = asked->stores_energy ? energy(model, asked, sum) : TINKER_OK;
        if (status != TINKER_OK) return status;
    }
    return TINKER_OK;
}

TinkerStatus tinker_model_energy(TinkerModel *model, TinkerEnergy *energy)
{
    double lines = 0;
    *energy = (TinkerEnergy){.kinetic = kinetic_energy(model)};
    TinkerStatus status = add_asked(model, model->asked_lines, asked_lines_energy, &lines);
    if (status == TINKER_OK)
        status = add_asked(model, model->asked_forces, asked_forces_energy, &energy->stored_in_forces);
    if (status == TINKER_OK)
        status = add_asked(model, model->asked_fields, asked_field_energy, &energy->stored_in_fields);
    const double uniform = uniform_field_energy(model);
    energy->in_fields = uniform + energy->stored_in_fields;
    energy->potential =
        merged_lines_energy(model) + uniform + lines + energy->stored_in_forces + energy->stored_in_fields;
    return status;
}

/* As a product, so that a small change of much energy loses no digits. */
double tinker_model_kinetic_change(const TinkerModel *model, const double *before, const double *after)
{
    double sum = 0;
    for (int32_t i = 0; i < model->coordinates; i++)
        sum += 0.5 * model->coordinate_mass[i] * (after[i] - before[i]) * (after[i] + before[i]);
    return sum;
}
