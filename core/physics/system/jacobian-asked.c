/* The derivatives of force elements and fields: by the field's own where it gives them, else by central differences. */
#include <math.h>

#include "physics/model/angles.h"
#include "physics/model/failures.h"
#include "physics/system/jacobian-private.h"
#include "physics/system/jacobian.h"
#include "physics/system/tolerances.h"

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
    self->distance = TINKER_JACOBIAN_STEP * (extent > 0 ? extent : 1);
    self->speed = TINKER_JACOBIAN_STEP * speed;
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

/* The ends of one force element, and how what they are on is turned. */
typedef struct {
    const TinkerAskedBatch *asked;
    int32_t row, count;
    TinkerPoint *ends;
    TinkerPose *poses; /* NULL where it knows no angles */
} Element;

/* Three numbers an end: the force on it, and the torque on what it is on. */
static TinkerStatus element_force(TinkerJacobian *self, const Element *of, double *out)
{
    TinkerModel *model = self->model;
    const TinkerAskedBatch *asked = of->asked;
    TinkerBatch view = tinker_model_view(model, asked->batch, of->row, 1, model->column_views);
    const TinkerForceElement *element = asked->batch->block_class->physics->force_element;
    if (of->poses != NULL) tinker_angles_show(asked->angles, &view, asked->batch->end_offsets[of->row], of->count);
    double *force = self->force;
    TinkerStatus status = TINKER_CALL_BATCH(asked->batch, "force", &view, element->force(&view, of->ends, force));
    for (int32_t e = 0; e < of->count; e++) {
        out[3 * e] = force[2 * e];
        out[3 * e + 1] = force[2 * e + 1];
        out[3 * e + 2] = of->poses != NULL ? view.angular[e] : 0;
    }
    if (status == TINKER_OK || status == TINKER_RETRY_SMALLER) return status;
    return tinker_model_fail(model, asked->batch, of->row, "force", view.failure);
}

/* What changes as one number of the element does: of its point `of` as that moves along k. */
static TinkerStatus add_difference(TinkerJacobian *self, const Element *element, int32_t of, int k, double *number,
                                   double step)
{
    const TinkerAskedBatch *asked = element->asked;
    const int32_t from = asked->batch->end_offsets[element->row], count = element->count;
    double *low = self->force + 2 * (gsize)count, *high = low + 3 * (gsize)count, kept = *number;
    *number = kept - step;
    TinkerStatus status = element_force(self, element, low);
    *number = kept + step;
    if (status == TINKER_OK) status = element_force(self, element, high);
    *number = kept;
    for (int32_t e = 0; e < count && status == TINKER_OK; e++) {
        double by[3];
        for (int i = 0; i < 3; i++)
            by[i] = (high[3 * e + i] - low[3 * e + i]) / (2 * step);
        if (!isfinite(by[0] + by[1] + by[2]))
            return tinker_model_not_finite(self->model, asked->batch, element->row, "force");
        const int32_t on = asked->end_points[from + e];
        const int32_t turn = element->poses != NULL ? asked->angles->turns[from + e] : self->model->first_support;
        if (on < self->model->first_support) add_column(self, on, of, k, by[0], by[1]);
        if (turn < self->model->first_support) add_column(self, turn, of, k, by[2], 0);
    }
    return status;
}

/* The forces on all ends of an element by the place and velocity of one of them. */
static TinkerStatus add_element_end(TinkerJacobian *self, const Element *element, int32_t end)
{
    TinkerStatus status = TINKER_OK;
    const int32_t of = element->asked->end_points[element->asked->batch->end_offsets[element->row] + end];
    for (int k = 0; k < 4 && status == TINKER_OK; k++) {
        double step, *number = coordinate_of(self, &element->ends[end], k, &step);
        status = add_difference(self, element, of, k, number, step);
    }
    return status;
}

/* By the angle of what one of its ends is on, and by the rate of that. */
static TinkerStatus add_element_turn(TinkerJacobian *self, const Element *element, int32_t end)
{
    const int32_t of = element->asked->angles->turns[element->asked->batch->end_offsets[element->row] + end];
    if (of >= self->model->first_support) return TINKER_OK;
    TinkerStatus status = add_difference(self, element, of, 0, &element->poses[end].angle, TINKER_JACOBIAN_ANGLE_STEP);
    if (status != TINKER_OK) return status;
    const double rate = fmax(1, fabs(element->poses[end].rate));
    return add_difference(self, element, of, 2, &element->poses[end].rate, TINKER_JACOBIAN_ANGLE_STEP * rate);
}

TinkerStatus tinker_jacobian_add_elements(TinkerJacobian *self, const TinkerAskedBatch *asked)
{
    const TinkerBlockBatch *batch = asked->batch;
    TinkerAngles *angles = asked->angles;
    if (angles != NULL) tinker_angles_gather(angles, self->model, 0, batch->end_count);
    for (int32_t row = 0; row < batch->count; row++) {
        int32_t from = batch->end_offsets[row], count = batch->end_offsets[row + 1] - from;
        const Element element = {asked, row, count, (TinkerPoint *)(void *)self->model->chunk,
                                 angles != NULL ? angles->poses + from : NULL};
        for (int32_t e = 0; e < count; e++)
            element.ends[e] = self->model->point[asked->end_points[from + e]];
        for (int32_t e = 0; e < count; e++) {
            TinkerStatus status = TINKER_OK;
            if (asked->end_points[from + e] < self->model->first_support) status = add_element_end(self, &element, e);
            if (status == TINKER_OK && angles != NULL) status = add_element_turn(self, &element, e);
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
    // columns of turns stand behind those of places, one by one
    if (self->model->turning > 0) return tinker_jacobian_find_entry(self, 2 * row, 2 * column);
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
