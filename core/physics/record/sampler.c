/* Every class that has a wanted column is asked once a sample for each wanted quantity, over all its blocks. */
#include "physics/record/sampler.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contact-pins.h"
#include "physics/contact/contacts.h"
#include "physics/force/forces.h"
#include "physics/impulse/impulse.h"
#include "physics/model/angles.h"
#include "physics/model/failures.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/record/columns.h"
#include "physics/record/implied.h"

/* One quantity of one class: which rows go to which columns. */
typedef struct {
    TinkerBlockBatch *batch;
    int32_t quantity;
    GArray *rows;    /* of int32_t */
    GArray *columns; /* of int32_t */
} Wanted;

struct _TinkerSampler {
    TinkerModel *model;
    GPtrArray *wanted;      /* of Wanted, those of one batch side by side */
    TinkerImplied *implied; /* NULL where no such column is wanted */
    const GArray *columns;
    double *acceleration;
    TinkerPoint *ends; /* of the largest batch, in the world */
    double *end_accelerations, *forces, *values;
    TinkerPoint *bodies;         /* in the world */
    TinkerPose *poses;           /* of the ends; NULL where nothing turns */
    double *contacts, *by_point; /* four numbers each, of the largest batch and of all points; NULL without contact */
};

static void wanted_free(gpointer data)
{
    Wanted *wanted = data;
    g_array_unref(wanted->rows);
    g_array_unref(wanted->columns);
    g_free(wanted);
}

static TinkerBlockBatch *batch_of(const TinkerModel *model, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(model->scene, block);
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->block_class == block_class) return batch;
    }
    return NULL;
}

static Wanted *find_wanted(TinkerSampler *sampler, TinkerBlockBatch *batch, int32_t quantity)
{
    for (guint i = 0; i < sampler->wanted->len; i++) {
        Wanted *wanted = g_ptr_array_index(sampler->wanted, i);
        if (wanted->batch == batch && wanted->quantity == quantity) return wanted;
    }
    Wanted *wanted = g_new0(Wanted, 1);
    *wanted = (Wanted){batch, quantity, g_array_new(FALSE, FALSE, sizeof(int32_t)),
                       g_array_new(FALSE, FALSE, sizeof(int32_t))};
    g_ptr_array_add(sampler->wanted, wanted);
    return wanted;
}

static int compare_wanted(const void *left, const void *right)
{
    const Wanted *l = *(Wanted *const *)left, *r = *(Wanted *const *)right;
    if (l->batch != r->batch) return l->batch->ids[0] < r->batch->ids[0] ? -1 : 1;
    return l->quantity - r->quantity;
}

/* Row of each block within its batch, by block id. */
static int32_t *rows_by_block(const TinkerModel *model)
{
    int32_t *rows = g_new0(int32_t, MAX(tinker_scene_id_limit(model->scene), 1));
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++)
            rows[batch->ids[row]] = row;
    }
    return rows;
}

TinkerSampler *tinker_sampler_new(TinkerModel *model, const GArray *columns)
{
    TinkerSampler *sampler = g_new0(TinkerSampler, 1);
    sampler->model = model;
    sampler->columns = columns;
    sampler->wanted = g_ptr_array_new_with_free_func(wanted_free);
    g_autofree int32_t *rows = rows_by_block(model);
    for (guint c = 0; columns != NULL && c < columns->len; c++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, c);
        if (column->block == TINKER_NO_BLOCK || column->quantity >= TINKER_IMPLIED_LENGTH) continue;
        TinkerBlockBatch *batch = batch_of(model, column->block);
        if (batch == NULL || batch->block_class->graph == NULL) continue;
        Wanted *wanted = find_wanted(sampler, batch, column->quantity);
        int32_t number = (int32_t)c;
        g_array_append_val(wanted->rows, rows[column->block]);
        g_array_append_val(wanted->columns, number);
    }
    sampler->implied = tinker_implied_new(model, columns);
    g_ptr_array_sort(sampler->wanted, compare_wanted);
    gsize most = 1;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        most = MAX(most, (gsize)MAX(batch->count, batch->end_count));
    }
    sampler->acceleration = g_new0(double, (gsize)MAX(model->coordinates, 1));
    sampler->ends = g_new0(TinkerPoint, most);
    sampler->end_accelerations = g_new0(double, 2 * most);
    sampler->forces = g_new0(double, 2 * most);
    sampler->values = g_new0(double, most);
    sampler->bodies = g_new0(TinkerPoint, MAX(model->bodies, 1));
    if (model->turning > 0) sampler->poses = g_new0(TinkerPose, most);
    if (model->contacts != NULL) {
        sampler->contacts = g_new0(double, 4 * most);
        sampler->by_point = g_new0(double, 4 * (gsize)MAX(model->points, 1));
    }
    return sampler;
}

void tinker_sampler_free(TinkerSampler *sampler)
{
    if (sampler == NULL) return;
    g_ptr_array_unref(sampler->wanted);
    tinker_implied_free(sampler->implied);
    g_free(sampler->poses);
    gpointer arrays[] = {sampler->acceleration, sampler->ends,   sampler->end_accelerations, sampler->forces,
                         sampler->values,       sampler->bodies, sampler->contacts,          sampler->by_point};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(sampler);
}

static TinkerPoint in_world(const TinkerModel *model, int32_t point)
{
    TinkerPoint at = model->point[point];
    at.x += model->origin[0];
    at.y += model->origin[1];
    return at;
}

/* How what a point is on is turned. */
static TinkerPose pose_of(const TinkerSampler *sampler, int32_t point, const double *q)
{
    const TinkerModel *model = sampler->model;
    const int32_t body = tinker_model_body_of(model, point), at = body < 0 ? -1 : tinker_model_turn_of(model, body);
    if (at < 0) return (TinkerPose){0, 0, 0};
    const TinkerTurn *turn = &model->turns[at - 2 * model->bodies];
    return (TinkerPose){tinker_model_angle(model, body, q), turn->rate, sampler->acceleration[at] / turn->gyration};
}

/* The batch's ends, relative to the model's origin, so that lengths far away from the world's lose no digits; of a
 * class that is itself a body, its own centres, in the world. */
static void gather(TinkerSampler *sampler, const TinkerBlockBatch *batch, const double *q)
{
    const TinkerModel *model = sampler->model;
    const int32_t *points = tinker_model_end_points(model, batch);
    int32_t count = points != NULL ? batch->end_count : batch->count;
    for (int32_t e = 0; e < count; e++) {
        int32_t point = points != NULL ? points[e] : tinker_model_centre(model, batch->ids[e]);
        if (point < 0) continue;
        sampler->ends[e] = points != NULL ? model->point[point] : in_world(model, point);
        sampler->end_accelerations[2 * e] = model->point_acceleration[2 * point];
        sampler->end_accelerations[2 * e + 1] = model->point_acceleration[2 * point + 1];
        if (sampler->poses != NULL) sampler->poses[e] = pose_of(sampler, point, q);
    }
}

static const TinkerConstraintBatch *constraints_of(const TinkerModel *model, const TinkerBlockBatch *batch)
{
    const TinkerConstraints *all = &model->constraints;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (part->batch == batch) return part;
    }
    return NULL;
}

/* Of a class that is a body or a plate. */
static void gather_contacts(TinkerSampler *sampler, const TinkerBlockBatch *batch)
{
    for (int32_t row = 0; row < batch->count; row++) {
        int32_t point = tinker_model_centre(sampler->model, batch->ids[row]);
        if (point >= 0) memcpy(sampler->contacts + 4 * row, sampler->by_point + 4 * point, 4 * sizeof(double));
    }
}

static TinkerGraphInput input_of(TinkerSampler *sampler, TinkerBlockBatch *batch, TinkerBatch *view, const double *q)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    const TinkerConstraintBatch *rows = constraints_of(sampler->model, batch);
    gather(sampler, batch, q);
    TinkerGraphInput input = {
        .struct_size = sizeof(TinkerGraphInput),
        .ends = sampler->ends,
        .accelerations = sampler->end_accelerations,
        .multipliers = rows != NULL ? sampler->model->constraints.lambda + rows->first_row : NULL,
        .poses = sampler->poses,
    };
    if (sampler->contacts != NULL && physics != NULL && physics->body != NULL) {
        gather_contacts(sampler, batch);
        input.contacts = sampler->contacts;
    }
    TinkerAngles *angles = tinker_model_angles(sampler->model, batch);
    if (angles != NULL) {
        tinker_angles_gather(angles, sampler->model, 0, batch->end_count);
        tinker_angles_show(angles, view, 0, batch->end_count);
        input.poses = angles->poses;
        input.torques = physics->force_element != NULL ? view->angular : NULL;
    }
    if (rows != NULL && rows->constraint->friction != NULL && sampler->model->contacts != NULL) {
        tinker_contacts_pin_torques(sampler->model->contacts, rows, sampler->forces);
        input.torques = sampler->forces;
    }
    if (physics != NULL && physics->force_element != NULL &&
        TINKER_CALL_BATCH(batch, "force", view, physics->force_element->force(view, sampler->ends, sampler->forces)) ==
            TINKER_OK)
        input.forces = sampler->forces;
    if (physics != NULL && physics->field != NULL) {
        input.bodies = sampler->bodies;
        input.masses = sampler->model->mass;
        input.body_count = sampler->model->bodies;
    }
    return input;
}

TinkerStatus tinker_sampler_look_at(TinkerModel *model, double t, const double *q, const double *v, double *a)
{
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, q, v);
    gint64 evaluations = model->evaluations;
    status = tinker_model_applied(model, a, FALSE);
    model->evaluations = evaluations; /* looking costs the method nothing */
    if (status == TINKER_OK && model->constraints.rows > 0) status = tinker_constraints_evaluate(model);
    if (model->contacts != NULL && model->contacts->impulses) tinker_impulse_add_accelerations(model->contacts, a);
    if (status == TINKER_OK && tinker_contacts_act(model->contacts))
        tinker_contacts_accelerate(model->contacts, a);
    else if (status == TINKER_OK && model->constraints.rows > 0)
        tinker_constraints_accelerate(model, a);
    return status;
}

static TinkerStatus accelerations_at(TinkerSampler *sampler, double t, const double *q, const double *v)
{
    TinkerModel *model = sampler->model;
    TinkerStatus status = tinker_sampler_look_at(model, t, q, v, sampler->acceleration);
    if (status != TINKER_OK) return status;
    if (sampler->by_point != NULL) tinker_contacts_sum_forces(model->contacts, sampler->by_point);
    memcpy(model->point_acceleration, sampler->acceleration, (gsize)model->coordinates * sizeof(double));
    if (model->turning > 0) tinker_model_accelerate_attachments(model);
    for (int32_t i = 0; i < model->bodies; i++)
        sampler->bodies[i] = in_world(model, i);
    return status;
}

/* What is less than any normal number is what cancelling left: 0, and many programs that read tables take it for
 * nothing else. */
static void drop_remainders(const TinkerSampler *sampler, double *values)
{
    for (guint i = 0; i < sampler->columns->len; i++)
        if (values[i] != 0 && fabs(values[i]) < DBL_MIN) values[i] = 0;
}

TinkerStatus tinker_sampler_values(TinkerSampler *sampler, double t, const double *q, const double *v, double *values)
{
    TinkerModel *model = sampler->model;
    if (sampler->wanted->len == 0 && sampler->implied == NULL) return TINKER_OK;
    TinkerStatus status = accelerations_at(sampler, t, q, v);
    if (status == TINKER_OK && sampler->implied != NULL) status = tinker_implied_values(sampler->implied, q, v, values);
    TinkerBlockBatch *last = NULL;
    TinkerBatch view = {0};
    TinkerGraphInput input = {0};
    for (guint i = 0; status == TINKER_OK && i < sampler->wanted->len; i++) {
        const Wanted *wanted = g_ptr_array_index(sampler->wanted, i);
        if (wanted->batch != last) {
            last = wanted->batch;
            const TinkerPhysics *physics = last->block_class->physics;
            if (last->waveforms > 0 && (physics == NULL || physics->motion != NULL))
                tinker_block_batch_set_time(last, t); /* the model has set all others */
            view = tinker_block_batch_view(last, t);
            if (last->end_count > 0) memcpy(view.origin, model->origin, sizeof(model->origin));
            input = input_of(sampler, last, &view, q);
        }
        const TinkerGraph *graph = last->block_class->graph;
        if (TINKER_CALL_BATCH(last, "values", &view, graph->values(&view, &input, wanted->quantity, sampler->values)) !=
            TINKER_OK)
            return tinker_model_fail(model, last, view.failed_instance,
                                     last->block_class->quantities[wanted->quantity].id, view.failure);
        for (guint k = 0; k < wanted->rows->len; k++) {
            int32_t row = g_array_index(wanted->rows, int32_t, k);
            if (!isfinite(sampler->values[row]))
                return tinker_model_not_finite(model, last, row, last->block_class->quantities[wanted->quantity].id);
            values[g_array_index(wanted->columns, int32_t, k)] = sampler->values[row];
        }
    }
    if (status == TINKER_OK) drop_remainders(sampler, values);
    return status;
}
