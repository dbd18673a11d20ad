/* Applied forces: everything but the constraints. Forces are added up by point, in an order that never changes: merged
 * lines, lines that are asked for, driven forces, force elements, fields.
 *
 * The power of force elements and fields that store energy is booked whole; what they stored is taken off again where
 * the books are read (energy.c), so that no gradient is needed here. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/sharing/sharing.h"
#include "physics/force/forces.h"
#include "physics/force/line-parts.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "plugin/call/guarded.h"
#include "plugin/call/words.h"

/* Lines whose plugin is asked -------------------------------------------------------------------------------------- */

/* The tensions at rate 0. */
static TinkerStatus ask_still(TinkerModel *model, const TinkerBlockBatch *batch, TinkerBatch *view,
                              const TinkerLineChunk *chunk)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    const gsize size = sizeof(double) * (gsize)view->count;
    double *zero = model->chunk + 6 * model->chunk_rows;
    if (batch->law_count > 0 && !batch->has_law_of_velocity) {
        memcpy(chunk->still, chunk->tension, size);
        return TINKER_OK;
    }
    memset(zero, 0, size);
    return TINKER_CALL_BATCH(batch, "tension", view, law->tension(view, chunk->length, zero, chunk->still));
}

/* Of lines that store nothing dampers take all; but what changes a typed law in time gives what the law does at rest.
 */
static TinkerStatus book_what_is_not_stored(TinkerModel *model, const TinkerBlockBatch *batch, TinkerBatch *view,
                                            int32_t first, const TinkerLineChunk *chunk)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    double *stored = model->chunk + 6 * model->chunk_rows;
    const gboolean typed = batch->law_count > 0;
    const TinkerStatus status =
        typed ? TINKER_OK : TINKER_CALL_BATCH(batch, "energy", view, law->energy(view, chunk->length, stored));
    for (int32_t i = 0; i < view->count && status == TINKER_OK; i++) {
        if (typed ? tinker_block_batch_stores(batch, first + i) : !isnan(stored[i])) continue;
        if (tinker_block_batch_is_timed(batch, first + i) && isfinite(chunk->still[i]))
            model->book_power[TINKER_BOOK_MOTORS] -= chunk->still[i] * chunk->rate[i];
        else
            chunk->still[i] = 0;
    }
    return status;
}

/* What dampers take: the part of the tension that is not there at rate 0. */
static TinkerStatus take_line_power(TinkerModel *model, const TinkerAskedBatch *asked, TinkerBatch *view, int32_t first,
                                    const TinkerLineChunk *chunk)
{
    const TinkerBlockBatch *batch = asked->batch;
    if (asked->stores_energy) {
        TinkerStatus status = ask_still(model, batch, view, chunk);
        if (status == TINKER_OK && batch->block_class->physics->line_law->partly_stores != 0)
            status = book_what_is_not_stored(model, batch, view, first, chunk);
        if (status != TINKER_OK) return status;
    } else {
        memset(chunk->still, 0, sizeof(double) * (gsize)view->count);
    }
    const TinkerBook book = batch->waveforms > 0 ? TINKER_BOOK_MOTORS : TINKER_BOOK_DAMPERS;
    for (int32_t i = 0; i < view->count; i++)
        model->book_power[book] -= (chunk->tension[i] - chunk->still[i]) * chunk->rate[i];
    return TINKER_OK;
}

static TinkerStatus add_asked_lines(TinkerModel *model, const TinkerAskedBatch *asked, gboolean books)
{
    const TinkerBlockBatch *batch = asked->batch;
    for (int32_t first = 0; first < batch->count; first += TINKER_CHUNK) {
        int32_t count = MIN(TINKER_CHUNK, batch->count - first);
        const int32_t *points = asked->end_points + 2 * first;
        TinkerLineChunk chunk;
        TinkerBatch view = tinker_model_view(model, batch, first, count, model->column_views);
        TinkerStatus status = tinker_model_ask_lines(model, batch, points, &view, &chunk);
        if (status == TINKER_OK && books) {
            status = take_line_power(model, asked, &view, first, &chunk);
            if (status != TINKER_OK) return tinker_model_refuse_forces(model, batch, &view, status, "tension");
        }
        if (status != TINKER_OK) return status;
        for (int32_t i = 0; i < count; i++) {
            double fx = chunk.tension[i] * chunk.x[i], fy = chunk.tension[i] * chunk.y[i];
            double *on_a = model->force + 2 * points[2 * i], *on_b = model->force + 2 * points[2 * i + 1];
            on_a[0] += fx;
            on_a[1] += fy;
            on_b[0] -= fx;
            on_b[1] -= fy;
        }
    }
    return TINKER_OK;
}

/* Forces on single points ------------------------------------------------------------------------------------------ */

/* Books whose power nobody asks for go to this. */
#define NO_BOOK TINKER_BOOK_COUNT

static void push(TinkerModel *model, int32_t point, double fx, double fy, TinkerBook book)
{
    const TinkerPoint *at = &model->point[point];
    model->force[2 * point] += fx;
    model->force[2 * point + 1] += fy;
    if (book != NO_BOOK) model->book_power[book] += fx * at->vx + fy * at->vy;
}

static TinkerStatus add_driven_forces(TinkerModel *model, gboolean books)
{
    for (guint i = 0; i < model->driven->len; i++) {
        const TinkerDrivenForce *driven = &g_array_index(model->driven, TinkerDrivenForce, i);
        double fx = *driven->value * driven->direction[0], fy = *driven->value * driven->direction[1];
        if (!isfinite(fx + fy)) return tinker_model_not_finite(model, driven->batch, driven->row, "force");
        push(model, driven->point, fx, fy, books ? TINKER_BOOK_MOTORS : NO_BOOK);
    }
    if (!books || model->constant_force == NULL) return TINKER_OK;
    for (int32_t i = 0; i < model->bodies; i++)
        model->book_power[TINKER_BOOK_MOTORS] +=
            model->constant_force[2 * i] * model->point[i].vx + model->constant_force[2 * i + 1] * model->point[i].vy;
    return TINKER_OK;
}

/* What typed forces do by velocities, as drag does, was booked as given by motors, and is taken by dampers; `given` is
 * the power (W) of all that they do. */
static TinkerStatus book_drag(TinkerModel *model, const TinkerAskedBatch *asked, int32_t first, int32_t count,
                              double given)
{
    const int32_t *offsets = asked->batch->end_offsets, *points = asked->end_points + offsets[first];
    const double *still;
    const TinkerStatus status = tinker_model_ask_element_at_rest(model, asked->batch, points, first, count, &still);
    if (status != TINKER_OK) return status;
    for (int32_t e = 0; e < offsets[first + count] - offsets[first]; e++)
        given -= still[2 * e] * model->point[points[e]].vx + still[2 * e + 1] * model->point[points[e]].vy;
    model->book_power[TINKER_BOOK_MOTORS] -= given;
    model->book_power[TINKER_BOOK_DAMPERS] += given;
    return TINKER_OK;
}

static TinkerStatus add_asked_forces(TinkerModel *model, const TinkerAskedBatch *asked, gboolean books)
{
    const TinkerBlockBatch *batch = asked->batch;
    const gboolean dissipates = batch->block_class->physics->force_element->dissipates != 0;
    const TinkerBook book = !books ? NO_BOOK : dissipates ? TINKER_BOOK_DAMPERS : TINKER_BOOK_MOTORS;
    for (int32_t first = 0; first < batch->count; first += TINKER_CHUNK) {
        int32_t count = MIN(TINKER_CHUNK, batch->count - first);
        const int32_t *points = asked->end_points + batch->end_offsets[first];
        TinkerElementForces on;
        TinkerStatus status = tinker_model_ask_element(model, batch, points, first, count, &on);
        double given = 0;
        if (status != TINKER_OK) return status;
        for (int32_t e = 0; e < batch->end_offsets[first + count] - batch->end_offsets[first]; e++) {
            push(model, points[e], on.force[2 * e], on.force[2 * e + 1], book);
            given += on.force[2 * e] * model->point[points[e]].vx + on.force[2 * e + 1] * model->point[points[e]].vy;
            if (on.torque != NULL) push(model, on.turns[e], on.torque[e], 0, book);
        }
        if (book == TINKER_BOOK_MOTORS && batch->has_law_of_velocity)
            status = book_drag(model, asked, first, count, given);
        if (status != TINKER_OK) return status;
    }
    return TINKER_OK;
}

/* Fields ----------------------------------------------------------------------------------------------------------- */

static TinkerStatus add_asked_field(TinkerModel *model, const TinkerAskedBatch *asked, gboolean books)
{
    const double *force;
    TinkerStatus status = tinker_model_ask_field(model, asked->batch, 0, asked->batch->count, &force);
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < model->bodies; i++) {
        double fx = force[2 * i], fy = force[2 * i + 1];
        model->force[2 * i] += fx;
        model->force[2 * i + 1] += fy;
        if (books) model->book_power[TINKER_BOOK_FIELDS] += fx * model->point[i].vx + fy * model->point[i].vy;
    }
    return TINKER_OK;
}

static void add_linear_field_power(TinkerModel *model)
{
    for (int32_t i = 0; i < model->bodies; i++) {
        const TinkerPoint *at = &model->point[i];
        model->book_power[TINKER_BOOK_FIELDS] += (model->field_force[0] - model->field_drag * at->vx) * at->vx +
                                                 (model->field_force[1] - model->field_drag * at->vy) * at->vy;
    }
}

/* What moving supports give through the forces that act on them. */
static void add_support_power(TinkerModel *model)
{
    for (int32_t point = model->first_support; point < model->points; point++) {
        if (!tinker_model_attachment(model, point)->moving) continue;
        const TinkerPoint *at = &model->point[point];
        model->book_power[TINKER_BOOK_SUPPORT_MOTION] -=
            model->force[2 * point] * at->vx + model->force[2 * point + 1] * at->vy;
    }
}

static TinkerStatus add_asked(TinkerModel *model, GArray *batches,
                              TinkerStatus (*add)(TinkerModel *, const TinkerAskedBatch *, gboolean), gboolean books)
{
    for (guint i = 0; i < batches->len; i++) {
        TinkerStatus status = add(model, &g_array_index(batches, TinkerAskedBatch, i), books);
        if (status != TINKER_OK) return status;
    }
    return TINKER_OK;
}

typedef struct {
    const TinkerModel *model;
    double *a;
} Acceleration;

/* The arrays as parameters: see the loops of numerics/integrate/rk4.c. */
static inline void accelerate_bodies(int32_t first, int32_t end, const double *restrict force,
                                     const double *restrict inverse, const double *restrict constant,
                                     double *restrict a)
{
    for (int32_t i = first; i < end; i++) {
        a[2 * i] = constant[2 * i] + force[2 * i] * inverse[i];
        a[2 * i + 1] = constant[2 * i + 1] + force[2 * i + 1] * inverse[i];
    }
}

static void accelerate(void *data, int32_t first, int32_t end)
{
    const Acceleration *loop = data;
    const TinkerModel *model = loop->model;
    const double *inverse = model->inverse_mass;
    double *a = loop->a;
    accelerate_bodies(first, end, model->force, inverse, model->constant_acceleration, a);
    if (model->field_drag == 0) return;
    for (int32_t i = first; i < end; i++) {
        a[2 * i] -= model->field_drag * inverse[i] * model->point[i].vx;
        a[2 * i + 1] -= model->field_drag * inverse[i] * model->point[i].vy;
    }
}

/* Whether there is any force beside those that make the constant accelerations. */
static inline gboolean has_forces(const TinkerModel *model)
{
    return model->lines.count > 0 || model->more_than_lines;
}

/* What acts on attachments goes to the bodies. */
static void take_forces_in(TinkerModel *model)
{
    for (int32_t point = model->first_attachment; point < model->first_support; point++)
        memcpy(tinker_model_attachment(model, point)->force, model->force + 2 * point, 2 * sizeof(double));
    tinker_model_reduce_forces(model);
}

/* The accelerations of turns. */
static G_NO_INLINE void turn(TinkerModel *model, double *a)
{
    if (has_forces(model)) take_forces_in(model);
    for (int32_t k = 0; k < model->turning; k++) {
        const int32_t at = 2 * model->bodies + k;
        a[at] = model->constant_acceleration[at] + model->force[at] * model->inverse_mass[model->turns[k].body];
    }
}

/* The forces of merged lines alone; answers the power that dampers take. */
static inline double lines_forces(TinkerModel *model)
{
    double taken = 0;
    if (model->line_parts != NULL) return tinker_line_parts_forces(model);
    if (has_forces(model)) memset(model->force, 0, 2 * (gsize)model->points * sizeof(double));
    if (model->lines.count > 0) tinker_lines_add_forces(&model->lines, model->point, model->force, &taken);
    return taken;
}

/* Apart, so that models of lines alone do not carry its registers. */
static G_NO_INLINE TinkerStatus add_more_than_lines(TinkerModel *model, gboolean books)
{
    TinkerStatus status = add_asked(model, model->asked_lines, add_asked_lines, books);
    if (status == TINKER_OK) status = add_driven_forces(model, books);
    if (status == TINKER_OK) status = add_asked(model, model->asked_forces, add_asked_forces, books);
    if (status == TINKER_OK) status = add_asked(model, model->asked_fields, add_asked_field, books);
    if (status != TINKER_OK) return status;
    if (books && model->has_book[TINKER_BOOK_FIELDS]) add_linear_field_power(model);
    if (books && model->moving_supports > 0) add_support_power(model);
    return TINKER_OK;
}

TinkerStatus tinker_model_applied(TinkerModel *model, double *a, gboolean books)
{
    model->evaluations++;
    if (books && model->more_than_lines) memset(model->book_power, 0, sizeof(model->book_power));
    model->book_power[TINKER_BOOK_DAMPERS] = -lines_forces(model);
    TinkerStatus status = model->more_than_lines ? add_more_than_lines(model, books) : TINKER_OK;
    if (status == TINKER_OK && model->turning > 0) turn(model, a);
    if (status == TINKER_OK) tinker_share_range(model->bodies, accelerate, &(Acceleration){model, a});
    return status;
}

gboolean tinker_model_feels_velocities(const TinkerModel *model)
{
    return model->lines.any_damping || model->field_drag != 0 || model->asked_lines->len > 0 ||
           model->asked_forces->len > 0 || model->asked_fields->len > 0;
}
