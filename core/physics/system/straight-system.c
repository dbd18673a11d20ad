/* A model on a line, or of shafts, as the system that integrators see: one coordinate a body or a shaft, springs and
 * dampers between coordinates or between one and an anchor. */
#include <math.h>
#include <string.h>

#include "physics/line/linear-form-data.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/system.h"

static double pull(const TinkerStraightEdge *edge, double d, double speed)
{
    return edge->stiffness * d + (d < 0 ? -edge->offset : edge->offset) + edge->damping * speed;
}

static void move_anchors(const TinkerLinearForm *form)
{
    const double *direction = form->line.direction;
    for (int32_t i = 0; i < form->system.anchor_count; i++) {
        const TinkerPoint *at = &form->model->point[form->anchor_points[i]];
        form->anchor_place[i] = at->x * direction[0] + at->y * direction[1];
        form->anchor_speed[i] = at->vx * direction[0] + at->vy * direction[1];
    }
}

/* Sums that take turns, so that an addition need not wait for the one before. */
#define TURNS 4

/* The forces of the edges between coordinates; answers the power that their dampers take, where that is asked for. What
 * ends at the coordinate that the next edge starts from is added with that one's: along a chain no sum waits for
 * memory. */
static inline __attribute__((always_inline)) double add_inner_edges(const TinkerLinearForm *form,
                                                                    const double *restrict x, const double *restrict u,
                                                                    double *restrict force, const gboolean books)
{
    const double watched = form->model->watched_length;
    double taken[TURNS] = {0}, carried = 0;
    gboolean near = FALSE;
    int32_t at = form->inner_count > 0 ? form->inner[0].a : 0;
    for (int32_t i = 0; i < form->inner_count; i++) {
        const TinkerStraightEdge *edge = &form->inner[i];
        double d = x[edge->b] - x[edge->a], speed = u[edge->b] - u[edge->a], f = pull(edge, d, speed);
        near |= fabs(d) < watched;
        if (books) {
            double sum = taken[0] + edge->damping * speed * speed;
            for (int k = 0; k < TURNS - 1; k++)
                taken[k] = taken[k + 1];
            taken[TURNS - 1] = sum;
        }
        if (edge->a != at) {
            force[at] += carried;
            at = edge->a;
            carried = 0;
        }
        force[at] += carried + f;
        at = edge->b;
        carried = -f;
    }
    if (form->inner_count > 0) force[at] += carried;
    if (near) atomic_store_explicit(&form->model->came_near, TRUE, memory_order_relaxed);
    return (taken[0] + taken[1]) + (taken[2] + taken[3]);
}

/* The forces of the edges at anchors, as add_inner_edges(): those at one coordinate in a row are added before memory is
 * written. *given gets what the motion of the anchors gives. */
static inline __attribute__((always_inline)) double add_anchored_edges(const TinkerLinearForm *form,
                                                                       const double *restrict x,
                                                                       const double *restrict u, double *restrict force,
                                                                       const gboolean books, double *given)
{
    double taken = 0, sum = 0;
    int32_t at = -1;
    *given = 0;
    for (int32_t i = 0; i < form->anchored_count; i++) {
        const TinkerStraightEdge *edge = &form->anchored[i];
        if (edge->b != at) {
            if (at >= 0) force[at] = sum;
            at = edge->b;
            sum = force[at];
        }
        double anchor_speed = form->anchor_speed[edge->a], speed = u[edge->b] - anchor_speed;
        double d = x[edge->b] - form->anchor_place[edge->a], f = pull(edge, d, speed);
        if (fabs(d) < form->model->watched_length)
            atomic_store_explicit(&form->model->came_near, TRUE, memory_order_relaxed);
        sum -= f;
        if (!books) continue;
        taken += edge->damping * speed * speed;
        *given -= f * anchor_speed;
    }
    if (at >= 0) force[at] = sum;
    return taken;
}

/* Forces into `force`, which holds the loads; power into `power`, unless that is NULL. */
static void add_edges(const TinkerLinearForm *form, const double *x, const double *u, double *force, double *power)
{
    const TinkerLinearSystem *system = &form->system;
    double given, taken;
    if (power == NULL) {
        add_inner_edges(form, x, u, force, FALSE);
        add_anchored_edges(form, x, u, force, FALSE, &given);
        return;
    }
    taken = add_inner_edges(form, x, u, force, TRUE);
    taken += add_anchored_edges(form, x, u, force, TRUE, &given);
    if (system->damper_book >= 0) power[system->damper_book] -= taken;
    if (system->support_book >= 0) power[system->support_book] += given;
}

static void add_drives(const TinkerLinearForm *form, const double *u, double *force, double *power)
{
    for (guint i = 0; form->drives != NULL && i < form->drives->len; i++) {
        const TinkerDrive *drive = &g_array_index(form->drives, TinkerDrive, i);
        const TinkerInput *input = &g_array_index(form->inputs, TinkerInput, (guint)drive->input);
        double value[3];
        tinker_waveform_evaluate(input->evaluator, form->model->time, value);
        force[drive->target] += drive->factor * value[0];
        if (power != NULL && drive->book >= 0) power[drive->book] += drive->factor * value[0] * u[drive->target];
    }
}

static void add_drag(const TinkerLinearForm *form, const double *u, double *force, double *power)
{
    const TinkerLinearSystem *system = &form->system;
    for (int32_t i = 0; system->drag != NULL && i < system->size; i++) {
        force[i] -= system->drag[i] * u[i];
        if (power != NULL && system->drag_book >= 0) power[system->drag_book] -= system->drag[i] * u[i] * u[i];
    }
}

static void add_load_power(const TinkerLinearForm *form, const double *u, double *power)
{
    const TinkerLinearSystem *system = &form->system;
    for (int32_t i = 0; i < system->load_count; i++) {
        const TinkerConstantLoad *load = &system->loads[i];
        if (load->book >= 0) power[load->book] += load->force * u[load->target];
    }
}

/* Most have a book or two, and a loop becomes a call of the C library. */
static inline void clear(int32_t books, double *power)
{
    if (books > 0) power[0] = 0;
    if (books > 1) power[1] = 0;
    if (books > 2) memset(power + 2, 0, (gsize)(books - 2) * sizeof(double));
}

static TinkerStatus acceleration(void *context, double t, const double *x, const double *u, double *a, double *power)
{
    TinkerModelSystem *self = context;
    const TinkerLinearForm *form = self->form;
    const TinkerLinearSystem *system = &form->system;
    TinkerStatus status = tinker_model_set_time(self->model, t);
    if (status != TINKER_OK) return status;
    self->model->evaluations++;
    if (self->model->moving_supports > 0) move_anchors(form);
    for (int32_t i = 0; i < system->size; i++)
        a[i] = form->load[i];
    if (power != NULL) clear(self->system.books, power);
    add_edges(form, x, u, a, power);
    if (power != NULL) add_load_power(form, u, power);
    add_drives(form, u, a, power);
    add_drag(form, u, a, power);
    for (int32_t i = 0; i < system->size; i++)
        a[i] *= form->inverse_mass[i];
    return TINKER_OK;
}

static TinkerStatus damping_product(void *context, double t, const double *x, const double *u, const double *du,
                                    double *out)
{
    const TinkerModelSystem *self = context;
    const TinkerLinearSystem *system = &self->form->system;
    for (int32_t i = 0; i < system->size; i++)
        out[i] = system->drag != NULL ? -system->drag[i] * du[i] : 0;
    for (int32_t i = 0; i < system->edge_count; i++) {
        const TinkerLinearEdge *edge = &system->edges[i];
        double f = edge->damping * ((edge->b >= 0 ? du[edge->b] : 0) - (edge->a >= 0 ? du[edge->a] : 0));
        if (edge->a >= 0) out[edge->a] += f;
        if (edge->b >= 0) out[edge->b] -= f;
    }
    for (int32_t i = 0; i < system->size; i++)
        out[i] *= self->form->inverse_mass[i];
    return TINKER_OK;
}

static TinkerStatus jacobian(void *context, double t, const double *x, const double *u, double *stiffness,
                             double *damping)
{
    const TinkerModelSystem *self = context;
    const TinkerLinearForm *form = self->form;
    gsize bytes = (gsize)form->pattern.entries * sizeof(double);
    memcpy(stiffness, form->stiffness, bytes);
    memcpy(damping, form->damping, bytes);
    return TINKER_OK;
}

void tinker_straight_system_offer_jacobian(TinkerModelSystem *self)
{
    tinker_linear_form_differentiate(self->form);
    self->system.pattern = &self->form->pattern;
    self->system.jacobian = jacobian;
}

gboolean tinker_straight_system_is_near(const TinkerModelSystem *self, const double *x)
{
    const TinkerLinearForm *form = self->form;
    const double watched = self->model->watched_length;
    gboolean near = FALSE;
    if (self->model->moving_supports > 0) move_anchors(form);
    for (int32_t i = 0; i < form->inner_count; i++)
        near |= fabs(x[form->inner[i].b] - x[form->inner[i].a]) < watched;
    for (int32_t i = 0; i < form->anchored_count; i++)
        near |= fabs(x[form->anchored[i].b] - form->anchor_place[form->anchored[i].a]) < watched;
    return near;
}

static void widen_by_state(const TinkerLinearForm *form, const double *x, double range[2])
{
    for (int32_t i = 0; i < form->system.size; i++) {
        range[0] = MIN(range[0], x[i]);
        range[1] = MAX(range[1], x[i]);
    }
    for (int32_t i = 0; i < form->system.anchor_count; i++) {
        range[0] = MIN(range[0], form->anchor_place[i]);
        range[1] = MAX(range[1], form->anchor_place[i]);
    }
}

/* The box of the plane's system serves as the range along the line. */
static void scales(void *context, const double *x, const double *u, double *extent, double *speed)
{
    const TinkerModelSystem *self = context;
    double range[2] = {self->box[0], self->box[2]};
    widen_by_state(self->form, x, range);
    *extent = self->form->system.size > 0 ? fmax(range[1] - range[0], self->form->least_extent) : 0;
    *speed = self->speed;
    for (int32_t i = 0; i < self->form->system.size; i++)
        *speed = MAX(*speed, fabs(u[i]));
}

void tinker_straight_system_keep(TinkerModelSystem *self, const double *x, const double *u)
{
    double extent, range[2] = {self->box[0], self->box[2]};
    scales(self, x, u, &extent, &self->speed);
    widen_by_state(self->form, x, range);
    self->box[0] = range[0];
    self->box[2] = range[1];
}

void tinker_straight_system_widen_box(TinkerModelSystem *self)
{
    const TinkerLine *line = &self->form->line;
    double range[2] = {self->box[0], self->box[2]};
    if (!(range[0] <= range[1])) return; /* nothing was kept yet */
    for (int k = 0; k < 2; k++) {
        double ends[2] = {line->offset[k] + range[0] * line->direction[k],
                          line->offset[k] + range[1] * line->direction[k]};
        self->box[k] = MIN(ends[0], ends[1]);
        self->box[2 + k] = MAX(ends[0], ends[1]);
    }
}

void tinker_straight_system_narrow_box(TinkerModelSystem *self)
{
    const TinkerLine *line = &self->form->line;
    double middle = 0, half = 0;
    if (!(self->box[0] <= self->box[2])) return;
    for (int k = 0; k < 2; k++) {
        middle += 0.5 * (self->box[k] + self->box[2 + k]) * line->direction[k];
        half += 0.5 * (self->box[2 + k] - self->box[k]) * fabs(line->direction[k]);
    }
    self->box[0] = middle - half;
    self->box[2] = middle + half;
}

void tinker_straight_system_init(TinkerModelSystem *self)
{
    TinkerSystem *system = &self->system;
    system->size = self->form->system.size;
    system->mass = self->form->system.mass;
    system->acceleration = acceleration;
    system->applied = acceleration;
    system->damping_product = damping_product;
    system->scales = scales;
}
