/* Linearisation: lines by their exact derivatives; closed contacts, whose tops are straight; constraints and everything
 * else in files of their own. */
#include "physics/linearise/linearise.h"
#include "numerics/solve/largest.h"

#include <float.h>
#include <glib/gi18n-lib.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/force/derivatives.h"
#include "physics/force/forces.h"
#include "physics/linearise/linearise-private.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

/* Holding ---------------------------------------------------------------------------------------------------------- */

TinkerStatus tinker_model_hold(TinkerModel *model)
{
    TinkerStatus status = tinker_model_set_time(model, 0.0);
    for (guint i = 0; i < model->waveform_batches->len; i++)
        tinker_block_batch_set_steady(g_ptr_array_index(model->waveform_batches, i));
    for (int32_t i = model->bodies; i < model->points; i++) {
        model->point[i].vx = model->point[i].vy = 0;
        model->point_acceleration[2 * i] = model->point_acceleration[2 * i + 1] = 0;
    }
    return status;
}

double tinker_model_held_length(TinkerModel *model, const double *q, TinkerBlockId block)
{
    g_autofree double *still = g_new0(double, MAX(model->coordinates, 1));
    const double length = tinker_constraints_wound_length(model, 0, q, still, block);
    (void)tinker_model_hold(model); /* which setting the time has taken back */
    return length;
}

void tinker_model_start_places(const TinkerModel *model, double *q)
{
    memcpy(q, model->q_start, (gsize)model->coordinates * sizeof(double));
}

void tinker_model_start_velocities(const TinkerModel *model, double *v)
{
    memcpy(v, model->v_start, (gsize)model->coordinates * sizeof(double));
}

TinkerBlockId tinker_model_body_block(const TinkerModel *model, int32_t body)
{
    return model->body_blocks[body];
}

int32_t tinker_model_body_turn(const TinkerModel *model, int32_t body, double *radius)
{
    const int32_t turn = tinker_model_turn_of(model, body);
    *radius = turn < 0 ? 0 : model->turns[turn - 2 * model->bodies].gyration;
    return turn;
}

void tinker_model_origin(const TinkerModel *model, double origin[2])
{
    memcpy(origin, model->origin, sizeof(model->origin));
}

gboolean tinker_model_meet_constraints(TinkerModel *model, double *q)
{
    gboolean moved;
    double work;
    g_autofree double *still = g_new0(double, (gsize)MAX(model->coordinates, 1));
    if (tinker_contacts_act(model->contacts))
        return tinker_contacts_project_positions(model->contacts, model->time, q, still, &moved, &work) == TINKER_OK;
    if (model->constraints.rows == 0) return TRUE;
    return tinker_constraints_project_positions(model, model->time, q, still, &moved) == TINKER_OK;
}

/* Terms ------------------------------------------------------------------------------------------------------------ */

/* weight times the square of (x, y) . (x_b - x_a). */
static void add_line_term(TinkerLinearisation *linear, const TinkerModel *model, GArray *terms, double weight,
                          int32_t a, int32_t b, double x, double y)
{
    if (weight == 0) return;
    tinker_linear_begin_term(linear, terms, weight);
    tinker_linear_add_point(linear, model, terms, a, -x, -y);
    tinker_linear_add_point(linear, model, terms, b, x, y);
}

/* A tension that rounding of the places alone would make counts as none: else it would hold what nothing holds. */
static void add_line(TinkerLinearisation *linear, const TinkerModel *model, int32_t a, int32_t b,
                     TinkerLineDerivatives line)
{
    if (a == b || (a >= model->first_support && b >= model->first_support)) return;
    const TinkerPoint *pa = &model->point[a], *pb = &model->point[b];
    double reach = fmax(fmax(fabs(pa->x), fabs(pa->y)), fmax(fabs(pb->x), fabs(pb->y))) + line.length;
    double noise = 8 * DBL_EPSILON * fabs(line.along) * reach;
    const gboolean is_rounding = line.length > 0 && fabs(line.across) * line.length <= noise;
    linear->undefined_pulls += line.pull_undefined;
    linear->undefined_dampers += line.damping_undefined;
    add_line_term(linear, model, linear->stiffness, line.along, a, b, line.x, line.y);
    add_line_term(linear, model, is_rounding ? linear->rounding : linear->stiffness, line.across, a, b, -line.y,
                  line.x);
    add_line_term(linear, model, linear->damping, line.damping, a, b, line.x, line.y);
    if (!is_rounding) linear->force_scale = fmax(linear->force_scale, fabs(line.across) * line.length);
    linear->force_noise = fmax(linear->force_noise, noise);
}

static TinkerStatus add_lines(TinkerLinearisation *linear, TinkerModel *model)
{
    for (int32_t i = 0; i < model->lines.count; i++)
        add_line(linear, model, model->lines.a[i], model->lines.b[i], tinker_merged_line_derivatives(model, i));
    for (guint k = 0; k < model->asked_lines->len; k++) {
        const TinkerAskedBatch *asked = &g_array_index(model->asked_lines, TinkerAskedBatch, k);
        for (int32_t i = 0; i < asked->batch->count; i++) {
            TinkerLineDerivatives line;
            TinkerStatus status = tinker_asked_line_derivatives(model, asked, i, &line);
            if (status != TINKER_OK) return status;
            add_line(linear, model, asked->end_points[2 * i], asked->end_points[2 * i + 1], line);
        }
    }
    for (int32_t i = 0; i < 2 * model->bodies && model->field_drag != 0; i++) {
        tinker_linear_begin_term(linear, linear->damping, model->field_drag);
        tinker_linear_add_entry(linear, linear->damping, i, 1);
    }
    return TINKER_OK;
}

/* The body's place relative to the plate, along a direction that is held. */
static void add_contact_row(TinkerLinearisation *linear, int32_t body, int32_t plate, double x, double y)
{
    tinker_linear_begin_term(linear, linear->rows, 1);
    tinker_linear_add_entry(linear, linear->rows, 2 * body, x);
    tinker_linear_add_entry(linear, linear->rows, 2 * body + 1, y);
    tinker_linear_add_entry(linear, linear->rows, 2 * plate, -x);
    tinker_linear_add_entry(linear, linear->rows, 2 * plate + 1, -y);
}

static void add_gap_rows(TinkerLinearisation *linear, const TinkerContacts *contacts, const TinkerContact *contact)
{
    const int rows = contact->mode == TINKER_CONTACT_STICK ? 2 : 1; /* along the normal; along the tangent */
    TinkerContactEntries entries;
    tinker_contact_gap_entries(contacts, contact->plate, &entries);
    for (int which = tinker_contacts_resists(contacts, contact) ? 1 : 0; which < rows; which++) {
        tinker_linear_begin_term(linear, linear->rows, 1);
        for (int32_t k = 0; k < entries.count; k++)
            tinker_linear_add_entry(linear, linear->rows, entries.coordinate[k], entries.row[which][k]);
    }
}

static void add_contacts(TinkerLinearisation *linear, const TinkerModel *model)
{
    if (!tinker_contacts_act(model->contacts)) return;
    for (guint i = 0; i < model->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(model->contacts, i);
        const TinkerPlate *plate = &model->contacts->plates[contact->plate];
        const double *n = plate->normal;
        if (plate->gap != NULL) {
            add_gap_rows(linear, model->contacts, contact);
            continue;
        }
        add_contact_row(linear, contact->body, plate->point, n[0], n[1]);
        if (contact->mode == TINKER_CONTACT_STICK) add_contact_row(linear, contact->body, plate->point, n[1], -n[0]);
    }
}

/* All -------------------------------------------------------------------------------------------------------------- */

static void measure_extent(TinkerLinearisation *linear, const TinkerModel *model)
{
    double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int32_t i = 0; i < model->points; i++) {
        const TinkerPoint *at = &model->point[i];
        if (!model->point_used[i]) continue;
        box[0] = fmin(box[0], at->x);
        box[1] = fmin(box[1], at->y);
        box[2] = fmax(box[2], at->x);
        box[3] = fmax(box[3], at->y);
    }
    linear->extent = hypot(fmax(box[2] - box[0], 0), fmax(box[3] - box[1], 0));
    linear->extent = fmax(linear->extent, tinker_constraints_reach(model));
    if (!(linear->extent > 0)) linear->extent = 1;
}

/* Forces at rest there, with those of the constraints; leaves lambda and the rows. */
static TinkerStatus add_forces(TinkerLinearisation *linear, TinkerModel *model)
{
    TinkerStatus status = tinker_model_applied(model, linear->force, FALSE);
    for (int32_t i = 0; status == TINKER_OK && i < linear->size; i++) {
        linear->force_scale = fmax(linear->force_scale, fabs(linear->force[i] * linear->mass[i]));
        linear->force_scale = fmax(linear->force_scale, fabs(model->constant_acceleration[i] * linear->mass[i]));
    }
    if (status == TINKER_OK && model->constraints.rows > 0) status = tinker_constraints_evaluate(model);
    if (status != TINKER_OK) return status;
    if (tinker_contacts_act(model->contacts))
        tinker_contacts_accelerate(model->contacts, linear->force);
    else if (model->constraints.rows > 0)
        tinker_constraints_accelerate(model, linear->force);
    if (model->constraints.rows > 0)
        linear->force_scale =
            fmax(linear->force_scale, tinker_largest(model->constraints.rows, model->constraints.lambda));
    for (int32_t i = 0; i < linear->size; i++)
        linear->force[i] *= linear->mass[i];
    linear->force_noise = fmax(linear->force_noise, 8 * DBL_EPSILON * linear->force_scale);
    return status;
}

/* Before force elements and fields, whose jacobian has them, too; and after a look at how large all forces are, by
 * which one is told from rounding. */
static TinkerStatus add_turned_forces(TinkerLinearisation *linear, TinkerModel *model)
{
    TinkerStatus status = add_forces(linear, model);
    if (status == TINKER_OK) status = tinker_model_applied(model, linear->force, FALSE);
    if (status == TINKER_OK) tinker_linear_add_turned_forces(linear, model);
    return status;
}

static TinkerLinearisation *allot(const TinkerModel *model)
{
    TinkerLinearisation *linear = g_new0(TinkerLinearisation, 1);
    linear->size = model->coordinates;
    linear->coordinates = 2 * model->points;
    linear->mass = g_memdup2(model->coordinate_mass, sizeof(double) * (gsize)MAX(linear->size, 1));
    linear->force = g_new0(double, MAX(linear->size, 1));
    linear->entries = g_array_new(FALSE, FALSE, sizeof(TinkerLinearEntry));
    GArray **terms[] = {&linear->stiffness, &linear->rounding, &linear->damping, &linear->rows};
    for (gsize i = 0; i < G_N_ELEMENTS(terms); i++)
        *terms[i] = g_array_new(FALSE, FALSE, sizeof(TinkerLinearTerm));
    return linear;
}

TinkerLinearisation *tinker_linearise(TinkerModel *model, const double *q, GError **error)
{
    g_autoptr(TinkerLinearisation) linear = allot(model);
    g_autofree double *still = g_new0(double, MAX(linear->size, 1));
    tinker_model_set_state(model, q, still);
    measure_extent(linear, model);
    TinkerStatus status = add_lines(linear, model);
    if (status == TINKER_OK && model->turning > 0) status = add_turned_forces(linear, model);
    if (status == TINKER_OK) status = tinker_linear_add_others(linear, model, q, still);
    if (status == TINKER_OK) status = add_forces(linear, model);
    for (guint i = 0; status == TINKER_OK && i < model->constraints.batches->len; i++)
        status = tinker_linear_add_constraints(linear, model,
                                               &g_array_index(model->constraints.batches, TinkerConstraintBatch, i));
    if (status == TINKER_OK) tinker_linear_add_straight_rows(linear, &model->constraints);
    if (status == TINKER_OK && model->turning > 0) tinker_linear_add_turned_rows(linear, model);
    if (status == TINKER_OK) add_contacts(linear, model);
    linear->rubbing_pins = model->contacts != NULL ? model->contacts->pin_count : 0;
    if (status == TINKER_OK) return g_steal_pointer(&linear);
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
                        model->failure[0] != '\0' ? model->failure : _("the forces cannot be made linear there"));
    return NULL;
}

void tinker_linearisation_free(TinkerLinearisation *linear)
{
    if (linear == NULL) return;
    g_array_unref(linear->entries);
    g_array_unref(linear->stiffness);
    g_array_unref(linear->rounding);
    g_array_unref(linear->damping);
    g_array_unref(linear->rows);
    gpointer arrays[] = {linear->mass, linear->other_stiffness, linear->other_damping, linear->force};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(linear);
}
