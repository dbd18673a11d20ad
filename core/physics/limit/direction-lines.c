/* Lines with a direction to lose, and the motion of their ends. */
#include <math.h>

#include "physics/island/island-run.h"
#include "physics/limit/direction-private.h"
#include "physics/limit/tolerances.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

/* Lines ------------------------------------------------------------------------------------------------------------ */

double tinker_direction_tension(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    const double length = 0, rate = 0;
    double tension = 0;
    TinkerBatch view = tinker_model_view(model, batch, row, 1, model->column_views);
    TinkerStatus status = TINKER_CALL_BATCH(batch, "tension", &view, law->tension(&view, &length, &rate, &tension));
    return status == TINKER_OK && isfinite(tension) ? tension : 0;
}

static double start_length(const TinkerModel *model, const TinkerDirectionLine *line)
{
    double a[2], b[2];
    tinker_model_start_place(model, line->a, a);
    tinker_model_start_place(model, line->b, b);
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* `force_free` (m): its length where it pulls at nothing; 0 where that is not known. */
static void add_line(TinkerDirectionWatch *self, TinkerDirectionLine line, double force_free, double *nearest)
{
    const TinkerModel *model = self->model;
    double inverse = 0;
    if (line.a < model->bodies) inverse += model->inverse_mass[line.a];
    if (line.b < model->bodies) inverse += model->inverse_mass[line.b];
    if (line.a == line.b || inverse == 0) return;
    line.mass = 1 / inverse;
    line.start = start_length(model, &line);
    if (!(force_free > 0)) force_free = line.start;
    if (force_free > 0) *nearest = fmin(*nearest, TINKER_LOST_NEAR * force_free);
    g_array_append_val(self->lines, line);
}

static void add_merged_lines(TinkerDirectionWatch *self, double *nearest)
{
    const TinkerMergedLines *lines = &self->model->lines;
    for (int32_t i = 0; i < lines->count; i++) {
        TinkerDirectionLine line = {.a = lines->a[i], .b = lines->b[i]};
        line.tension = lines->tension[i] - lines->stiffness[i] * lines->length[i];
        double force_free = lines->stiffness[i] > 0 ? fabs(line.tension) / lines->stiffness[i] : 0;
        if (line.tension != 0) add_line(self, line, force_free, nearest);
    }
}

static void add_asked_lines(TinkerDirectionWatch *self, double *nearest)
{
    for (guint i = 0; i < self->model->asked_lines->len; i++) {
        const TinkerAskedBatch *asked = &g_array_index(self->model->asked_lines, TinkerAskedBatch, i);
        for (int32_t row = 0; row < asked->batch->count; row++) {
            TinkerDirectionLine line = {
                .a = asked->end_points[2 * row], .b = asked->end_points[2 * row + 1], .asked = asked};
            line.row = row;
            line.tension = tinker_direction_tension(self->model, asked->batch, row);
            if (line.tension != 0 || asked->batch->waveforms > 0) add_line(self, line, 0, nearest);
        }
    }
}

double tinker_direction_list(TinkerDirectionWatch *self)
{
    double nearest = INFINITY;
    add_merged_lines(self, &nearest);
    add_asked_lines(self, &nearest);
    return isfinite(nearest) ? nearest : 0;
}

char *tinker_direction_names(const TinkerDirectionWatch *self, const TinkerDirectionLine *line)
{
    TinkerModel *model = self->model;
    g_autoptr(GString) names = g_string_new(NULL);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const int32_t *points = tinker_model_end_points(model, batch);
        if (batch->block_class->physics == NULL || batch->block_class->physics->line_law == NULL) continue;
        for (int32_t row = 0; row < batch->count; row++) {
            int32_t a = points[2 * row], b = points[2 * row + 1];
            if (MIN(a, b) != MIN(line->a, line->b) || MAX(a, b) != MAX(line->a, line->b)) continue;
            if (tinker_direction_tension(model, batch, row) == 0) continue;
            const char *name = tinker_scene_block_name(model->scene, batch->ids[row]);
            g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", name);
        }
    }
    return g_string_free(g_steal_pointer(&names), FALSE);
}

/* Ends ------------------------------------------------------------------------------------------------------------- */

/* The bodies at a time within the last step, at whose end they are placed; borrowed until the next call. */
static TinkerStatus state_at(TinkerDirectionWatch *self, double t, double **q, double **v)
{
    TinkerIslandRun *run = self->run;
    *q = run->q;
    *v = run->v;
    if (t == run->state.t) return TINKER_OK;
    TinkerStatus status = tinker_island_run_interpolate(run, t, self->x, self->u, NULL);
    *q = self->x;
    *v = self->u;
    if (!tinker_direction_is_straight(run)) return status;
    tinker_linear_form_expand(run->island->linear, self->x, self->u, self->q, self->v);
    *q = self->q;
    *v = self->v;
    return status;
}

/* For the supports where the model has them. */
static void motion_of(const TinkerModel *model, int32_t point, const double *q, const double *v, double motion[4])
{
    const TinkerPoint *at = &model->point[point];
    gboolean body = point < model->bodies;
    motion[0] = body ? q[2 * point] : at->x;
    motion[1] = body ? q[2 * point + 1] : at->y;
    motion[2] = body ? v[2 * point] : at->vx;
    motion[3] = body ? v[2 * point + 1] : at->vy;
}

TinkerStatus tinker_direction_measure(TinkerDirectionWatch *self, const TinkerDirectionLine *line, double t,
                                      TinkerDirectionEnds *ends)
{
    double *q, *v, a[4], b[4];
    TinkerStatus status = state_at(self, t, &q, &v);
    if (status == TINKER_OK) status = tinker_model_set_time(self->model, t);
    if (status != TINKER_OK) return status;
    motion_of(self->model, line->a, q, v, a);
    motion_of(self->model, line->b, q, v, b);
    *ends = (TinkerDirectionEnds){{b[0] - a[0], b[1] - a[1]}, {b[2] - a[2], b[3] - a[3]}, 0, 0, 0};
    ends->length = hypot(ends->d[0], ends->d[1]);
    ends->speed = hypot(ends->u[0], ends->u[1]);
    ends->closing = -(ends->d[0] * ends->u[0] + ends->d[1] * ends->u[1]);
    return TINKER_OK;
}

/* By what one of a line's ends is accelerated, for the system's accelerations worked out last. */
static void acceleration_of(const TinkerDirectionWatch *self, int32_t point, double a[2])
{
    const TinkerIslandRun *run = self->run;
    double direction[2] = {0};
    if (tinker_direction_is_straight(run)) tinker_linear_form_is_straight(run->island->linear, direction);
    for (int k = 0; k < 2; k++) {
        if (point >= self->model->bodies)
            a[k] = self->model->point_acceleration[2 * point + k];
        else
            a[k] = tinker_direction_is_straight(run) ? self->acceleration[point] * direction[k]
                                                     : self->acceleration[2 * point + k];
    }
}

TinkerStatus tinker_direction_acceleration(TinkerDirectionWatch *self, const TinkerDirectionLine *line, double t,
                                           const double *x, const double *u, double relative[2])
{
    TinkerSystem *system = &self->run->system.system;
    gint64 evaluations = self->model->evaluations;
    double a[2], b[2];
    TinkerStatus status = system->acceleration(system->context, t, x, u, self->acceleration, NULL);
    self->model->evaluations = evaluations; /* looking costs the method nothing */
    acceleration_of(self, line->a, a);
    acceleration_of(self, line->b, b);
    for (int k = 0; k < 2; k++)
        relative[k] = b[k] - a[k];
    return status;
}
