/* The model's forces told apart. The model merges and adds up what it can, so each block's own law is asked here, for
 * the state that the sample is evaluated at; multipliers and forces of contacts come from that evaluation. */
#include "physics/run/acting-forces.h"

#include "physics/compile/compile.h"
#include "physics/contact/contact-pins.h"
#include "physics/contact/contacts.h"
#include "physics/force/forces.h"
#include "physics/model/angles.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation-private.h"
#include "physics/run/simulation.h"

/* Contacts that there is room for at first, beside one a body; each has normal force and friction, on both sides. */
#define EXPECTED_CONTACTS 16
#define FORCES_A_CONTACT  4
/* Takes no step: any method that goes with contacts. */
#define START_METHOD "dop853"

struct _TinkerActingForces {
    TinkerModel *model;
    double *acceleration;
    GArray *out;     /* borrowed, of the call in progress */
    GArray *touches; /* of TinkerActingTouch */
};

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

static TinkerBlockId block_of(const TinkerModel *model, int32_t point)
{
    return tinker_model_block_of(model, point);
}

/* What of a torque acts on the body of a point: nothing turns a mass, though a row that speaks of angles has an answer
 * for its end as well. On a support it is what holds that. */
static double torque_on(const TinkerModel *model, int32_t point, double torque)
{
    const int32_t body = tinker_model_body_of(model, point);
    return body < 0 || tinker_model_turn(model, body) != NULL ? torque : 0;
}

/* A force that acts at a point of the model, and a torque beside it: end `end` of the block, or -1. */
static void add(TinkerActingForces *forces, TinkerActingKind kind, TinkerBlockId by, int32_t end, int32_t point,
                double fx, double fy, double torque)
{
    const TinkerModel *model = forces->model;
    const TinkerPoint *at = &model->point[point];
    TinkerActingForce force = {.by = by,
                               .on = block_of(model, point),
                               .kind = kind,
                               .x = at->x + model->origin[0],
                               .y = at->y + model->origin[1],
                               .fx = fx,
                               .fy = fy,
                               .torque = torque_on(model, point, torque),
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

/* A contact of block `on` with block `by`, of which the other has the opposite. */
typedef struct {
    TinkerBlockId on, by;
    const double *normal;   /* from the other to what it is on */
    double press, friction; /* N, along the normal and t */
    double at[2][2];        /* where it acts on each; relative to the origin */
    double resists[2];      /* N m: a torque beside friction, on each */
    int32_t touch;
} Touching;

static void add_touching(TinkerActingForces *forces, const Touching *contact)
{
    const TinkerModel *model = forces->model;
    const TinkerBlockId block[2] = {contact->on, contact->by};
    const double *n = contact->normal;
    const double push[2][2] = {{contact->press * n[0], contact->press * n[1]},
                               {contact->friction * n[1], -contact->friction * n[0]}};
    for (int i = 0; i < 4; i++) {
        const int along = i / 2, other = i % 2;
        const TinkerActingForce force = {.by = block[1 - other],
                                         .on = block[other],
                                         .kind = along ? TINKER_ACTING_FRICTION : TINKER_ACTING_NORMAL,
                                         .x = contact->at[other][0] + model->origin[0],
                                         .y = contact->at[other][1] + model->origin[1],
                                         .fx = other ? -push[along][0] : push[along][0],
                                         .fy = other ? -push[along][1] : push[along][1],
                                         .torque = along ? contact->resists[other] : 0,
                                         .end = -1,
                                         .touch = contact->touch,
                                         .is_answer = other,
                                         .is_mean = model->contacts->impulses};
        g_array_append_val(forces->out, force);
    }
}

/* Of a mass that lies on a plate. */
static void add_touch(TinkerActingForces *forces, const TinkerContact *contact)
{
    const TinkerModel *model = forces->model;
    const TinkerPlate *plate = &model->contacts->plates[contact->plate];
    const TinkerPoint *centre = &model->point[contact->body];
    const double off = model->contacts->half_height[contact->body], *n = plate->normal;
    const double x = centre->x - off * n[0], y = centre->y - off * n[1];
    const Touching touching = {.on = model->body_blocks[contact->body],
                               .by = plate->block,
                               .normal = n,
                               .press = contact->normal,
                               .friction = contact->friction,
                               .at = {{x, y}, {x, y}},
                               .touch = -1};
    add_touching(forces, &touching);
}

/* For contacts to come. */
static void make_room(TinkerActingForces *forces)
{
    const TinkerModel *model = forces->model;
    guint now = forces->out->len;
    if (model->contacts == NULL) return;
    g_array_set_size(forces->out, now + FORCES_A_CONTACT * ((guint)model->bodies + EXPECTED_CONTACTS));
    g_array_set_size(forces->out, now);
    g_array_set_size(forces->touches, (guint)model->bodies + EXPECTED_CONTACTS);
    g_array_set_size(forces->touches, 0);
}

static void note_touch(TinkerActingForces *forces, const TinkerContact *contact, const double normal[2],
                       const TinkerBlockId block[2])
{
    const TinkerPlate *plate = &forces->model->contacts->plates[contact->plate];
    const TinkerSurface *surface = &plate->surface;
    const TinkerActingTouch touch = {.block = {block[0], block[1]},
                                     .angle = {plate->pair->angle[0], plate->pair->angle[1]},
                                     .gap = *plate->gap,
                                     .normal = {normal[0], normal[1]},
                                     .mode = contact->mode,
                                     .at_limit = contact->at_limit,
                                     .friction = {surface->static_friction, surface->dynamic_friction}};
    g_array_append_val(forces->touches, touch);
}

/* On what has the tip of a gap, and the opposite on the other; what resists rolling is a torque beside friction. */
static void add_gap(TinkerActingForces *forces, int32_t number)
{
    const TinkerModel *model = forces->model;
    const TinkerContact *contact = tinker_contacts_closed(model->contacts, (guint)number);
    const TinkerPlate *plate = &model->contacts->plates[contact->plate];
    const double moment = tinker_contacts_moment(model->contacts, number);
    const int32_t tip = plate->gap->tip_of;
    TinkerContactEntries entries;
    const TinkerBlockId block[2] = {tinker_model_block_of(model, plate->pair->point[0]),
                                    tinker_model_block_of(model, plate->pair->point[1])};
    tinker_contact_gap_entries(model->contacts, contact->plate, &entries);
    note_touch(forces, contact, entries.normal, block);
    const double *n = entries.normal, *at = entries.point;
    const Touching touching = {.on = block[tip],
                               .by = block[1 - tip],
                               .normal = n,
                               .press = contact->normal,
                               .friction = contact->friction,
                               .at = {{at[0], at[1]}, {at[0], at[1]}},
                               .resists = {torque_on(model, plate->pair->point[tip], moment),
                                           torque_on(model, plate->pair->point[1 - tip], -moment)},
                               .touch = (int32_t)forces->touches->len - 1};
    add_touching(forces, &touching);
}

/* As impulses have it. On each it acts at the arm that it had in the step, for the moment that it had there; on a
 * support where it acts on the body. */
static void add_pressing(TinkerActingForces *forces, const TinkerPressing *each)
{
    const TinkerModel *model = forces->model;
    const int32_t point[2] = {each->body, each->by};
    Touching touching = {.on = tinker_model_block_of(model, each->body),
                         .by = tinker_model_block_of(model, each->by),
                         .normal = each->normal,
                         .press = each->press,
                         .friction = each->friction,
                         .touch = -1};
    for (int k = 0; k < 2; k++) {
        const int of = tinker_model_body_of(model, point[k]) >= 0 ? k : 0;
        const TinkerPoint *centre = &model->point[point[of]];
        touching.at[k][0] = centre->x + each->from[of][0];
        touching.at[k][1] = centre->y + each->from[of][1];
    }
    add_touching(forces, &touching);
}

static void add_contacts(TinkerActingForces *forces)
{
    const TinkerContacts *contacts = forces->model->contacts;
    for (guint i = 0; contacts != NULL && i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (tinker_contacts_resists(contacts, contact)) continue; /* a moment beside the friction of what bears it */
        if (tinker_contacts_is_gap(contacts, contact))
            add_gap(forces, (int32_t)i);
        else
            add_touch(forces, contact);
    }
    for (guint i = 0; contacts != NULL && i < contacts->pressings->len; i++)
        add_pressing(forces, &g_array_index(contacts->pressings, TinkerPressing, i));
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
    make_room(forces);
    add_contacts(forces);
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

/* The set-up state ------------------------------------------------------------------------------------------------- */

static gboolean list_sample(TinkerSimulation *simulation, G_GNUC_UNUSED double time, G_GNUC_UNUSED const double *values,
                            void *out, GError **error)
{
    g_autoptr(TinkerActingForces) forces = tinker_acting_forces_new(simulation->all->model);
    return tinker_acting_forces_at(forces, simulation, out, error);
}

static gboolean list_by(TinkerScene *scene, const TinkerRunOptions *options, GArray *out, GError **error)
{
    g_array_set_size(out, 0);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, error);
    if (model == NULL) return FALSE;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, options, error);
    return simulation != NULL && tinker_simulation_run(simulation, NULL, list_sample, out, error);
}

/* A run of no duration finds out what touches. */
gboolean tinker_acting_forces_at_start(TinkerScene *scene, GArray *out, GError **error)
{
    const TinkerRunOptions options = {.interval = 1, .method = START_METHOD, .tolerance = 1e-9, .spectral_radius = 1};
    return list_by(scene, &options, out, error);
}

static gboolean is_late(void *until)
{
    return g_get_monotonic_time() > *(const gint64 *)until;
}

gboolean tinker_acting_forces_after(TinkerScene *scene, double time, double patience, GArray *out, GError **error)
{
    gint64 until = g_get_monotonic_time() + (gint64)(patience * G_USEC_PER_SEC);
    const TinkerRunOptions options = {.duration = time,
                                      .interval = time,
                                      .at = &time,
                                      .at_count = 1,
                                      .method = START_METHOD,
                                      .tolerance = 1e-9,
                                      .spectral_radius = 1,
                                      .cancelled = is_late,
                                      .data = &until};
    return list_by(scene, &options, out, error);
}
