/* The derivatives of force elements and fields: by the field's own where it gives them, else by central differences. */
#include <math.h>

#include "physics/model/model-data.h"
#include "physics/system/jacobian-private.h"
#include "physics/system/jacobian.h"

/* Of the extent, or of a speed. */
#define DIFFERENCE 1e-6

/* How far they reach: a part of the system's extent, and of its largest speed, but at least 1e-6 m/s. */
void tinker_jacobian_choose_differences(TinkerJacobian *self)
{
    const TinkerModel *model = self->model;
    double extent = 0, speed = 1;
    for (int32_t i = 0; i < model->points; i++) {
        const TinkerPoint *at = &model->point[i];
        if (!model->point_used[i]) continue;
        extent = fmax(extent, fmax(fabs(at->x), fabs(at->y)));
        speed = fmax(speed, fmax(fabs(at->vx), fabs(at->vy)));
    }
    self->distance = DIFFERENCE * (extent > 0 ? extent : 1);
    self->speed = DIFFERENCE * speed;
}

/* One of the four numbers of a point, and the step that its difference takes. */
static double *coordinate_of(const TinkerJacobian *self, TinkerPoint *point, int k, double *step)
{
    double *coordinates[4] = {&point->x, &point->y, &point->vx, &point->vy};
    *step = k < 2 ? self->distance : self->speed;
    return coordinates[k];
}

/* The force on the point `on` by coordinate k of the point `of`: one column of a block. */
static void add_column(const TinkerJacobian *self, int32_t on, int32_t of, int k, double fx, double fy)
{
    double *values = k < 2 ? self->stiffness : self->damping;
    if (self->model->turning > 0) {
        const double block[4] = {k % 2 == 0 ? fx : 0, k % 2 == 1 ? fx : 0, k % 2 == 0 ? fy : 0, k % 2 == 1 ? fy : 0};
        tinker_jacobian_spread(self, values, on, of, -1, block);
        return;
    }
    const int32_t row = on, slot = on == of ? self->diagonal[on] : tinker_jacobian_find(self, on, of);
    int32_t below = slot + self->row_starts[2 * row + 1] - self->row_starts[2 * row];
    values[slot + k % 2] -= fx;
    values[below + k % 2] -= fy;
}

static TinkerStatus element_force(TinkerJacobian *self, const TinkerAskedBatch *asked, int32_t row,
                                  const TinkerPoint *ends, double *force)
{
    TinkerModel *model = self->model;
    TinkerBatch view = tinker_model_view(model, asked->batch, row, 1, model->column_views);
    const TinkerForceElement *element = asked->batch->block_class->physics->force_element;
    TinkerStatus status = TINKER_CALL_BATCH(asked->batch, "force", &view, element->force(&view, ends, force));
    if (status == TINKER_OK || status == TINKER_RETRY_SMALLER) return status;
    return tinker_model_fail(model, asked->batch, row, "force", view.failure);
}

/* The forces on all ends of an element by the place and velocity of one of them. */
static TinkerStatus add_element_end(TinkerJacobian *self, const TinkerAskedBatch *asked, int32_t row, TinkerPoint *ends,
                                    int32_t end)
{
    const int32_t *offsets = asked->batch->end_offsets, *points = asked->end_points + offsets[row];
    int32_t count = offsets[row + 1] - offsets[row], of = points[end];
    double *low = self->force, *high = self->force + 2 * (gsize)count;
    for (int k = 0; k < 4; k++) {
        double step, *coordinate = coordinate_of(self, &ends[end], k, &step), kept = *coordinate;
        *coordinate = kept - step;
        TinkerStatus status = element_force(self, asked, row, ends, low);
        *coordinate = kept + step;
        if (status == TINKER_OK) status = element_force(self, asked, row, ends, high);
        *coordinate = kept;
        if (status != TINKER_OK) return status;
        for (int32_t e = 0; e < count; e++) {
            if (points[e] >= self->model->first_support) continue;
            double fx = (high[2 * e] - low[2 * e]) / (2 * step);
            double fy = (high[2 * e + 1] - low[2 * e + 1]) / (2 * step);
            if (!isfinite(fx + fy)) return tinker_model_not_finite(self->model, asked->batch, row, "force");
            add_column(self, points[e], of, k, fx, fy);
        }
    }
    return TINKER_OK;
}

TinkerStatus tinker_jacobian_add_elements(TinkerJacobian *self, const TinkerAskedBatch *asked)
{
    const TinkerBlockBatch *batch = asked->batch;
    TinkerPoint *ends = (TinkerPoint *)(void *)self->model->chunk;
    for (int32_t row = 0; row < batch->count; row++) {
        int32_t from = batch->end_offsets[row], count = batch->end_offsets[row + 1] - from;
        for (int32_t e = 0; e < count; e++)
            ends[e] = self->model->point[asked->end_points[from + e]];
        for (int32_t e = 0; e < count; e++) {
            if (asked->end_points[from + e] >= self->model->first_support) continue;
            TinkerStatus status = add_element_end(self, asked, row, ends, e);
            if (status != TINKER_OK) return status;
        }
    }
    return TINKER_OK;
}

static TinkerStatus field_status(TinkerModel *model, const TinkerAskedBatch *asked, const TinkerBatch *view,
                                 TinkerStatus status)
{
    if (status == TINKER_OK || status == TINKER_RETRY_SMALLER) return status;
    return tinker_model_fail(model, asked->batch, view->failed_instance, "force", view->failure);
}

/* The force of a field on one body by the body's own place and velocity, by differences. */
static TinkerStatus add_body_of_field(TinkerJacobian *self, const TinkerAskedBatch *asked, int32_t body)
{
    TinkerModel *model = self->model;
    const TinkerField *field = asked->batch->block_class->physics->field;
    TinkerBodies bodies = {sizeof(TinkerBodies), model->bodies, model->point, model->mass, body, 1};
    TinkerBatch view = tinker_model_view(model, asked->batch, 0, asked->batch->count, model->column_views);
    double *low = self->force, *high = self->force + 2;
    for (int k = 0; k < 4; k++) {
        double step, *coordinate = coordinate_of(self, &model->point[body], k, &step), kept = *coordinate;
        *coordinate = kept - step;
        TinkerStatus status = TINKER_CALL_BATCH(asked->batch, "force", &view, field->force(&view, &bodies, low));
        *coordinate = kept + step;
        if (status == TINKER_OK)
            status = TINKER_CALL_BATCH(asked->batch, "force", &view, field->force(&view, &bodies, high));
        *coordinate = kept;
        if (status != TINKER_OK) return field_status(model, asked, &view, status);
        double fx = (high[0] - low[0]) / (2 * step), fy = (high[1] - low[1]) / (2 * step);
        if (!isfinite(fx + fy)) return tinker_model_not_finite(model, asked->batch, 0, "force");
        add_column(self, body, body, k, fx, fy);
    }
    return TINKER_OK;
}

TinkerStatus tinker_jacobian_add_field(TinkerJacobian *self, const TinkerAskedBatch *asked)
{
    TinkerModel *model = self->model;
    const TinkerField *field = asked->batch->block_class->physics->field;
    TinkerStatus status = TINKER_OK;
    if (field->derivatives == NULL) {
        for (int32_t i = 0; i < model->bodies && status == TINKER_OK; i++)
            status = add_body_of_field(self, asked, i);
        return status;
    }
    double *jacobian = model->chunk; /* has room for 8 a body */
    TinkerBodies bodies = {sizeof(TinkerBodies), model->bodies, model->point, model->mass, 0, model->bodies};
    TinkerBatch view = tinker_model_view(model, asked->batch, 0, asked->batch->count, model->column_views);
    status = TINKER_CALL_BATCH(asked->batch, "derivatives", &view, field->derivatives(&view, &bodies, jacobian));
    status = field_status(model, asked, &view, status);
    for (int32_t i = 0; i < model->bodies && status == TINKER_OK; i++) {
        tinker_jacobian_add(self, self->stiffness, i, self->diagonal[i], -1, jacobian + 8 * (gsize)i);
        tinker_jacobian_add(self, self->damping, i, self->diagonal[i], -1, jacobian + 8 * (gsize)i + 4);
    }
    return status;
}

int32_t tinker_jacobian_find(const TinkerJacobian *self, int32_t row, int32_t column)
{
    int32_t low = self->row_starts[2 * row], high = self->row_starts[2 * row + 1];
    while (high - low > 2) {
        int32_t middle = low + (high - low) / 4 * 2;
        if (self->columns[middle] > 2 * column)
            high = middle;
        else
            low = middle;
    }
    return low;
}
