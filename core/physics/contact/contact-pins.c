/* Friction of pins: a torque that resists the turning of what a joint holds together, up to an arm times the magnitude
 * of the joint's force. It stands for a plate of its own, as rolling resistance does (contacts.h), and is always
 * closed; but what bounds it is a force of constraints,
 *
 *     F = F0 + sum over rows j of B_j f_j,
 *
 * F0 without any contact, B_j what a unit of the force of row j adds. While the pin turns, its friction f at the arm
 * `arm` keeps f = slope |F|. By Newton's method on f: with the direction e = F / |F| of the last pass, |F| becomes e .
 * F and the equation is linear in all forces, one more row of their system. The error of e is of first order, that of
 * e . F of second. */
#include "physics/contact/contact-pins.h"

#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/tolerances.h"
#include "physics/model/points.h"

#define MOST_PASSES 50

/* What pins have in place of a gap. */
static const TinkerGapFunction no_gap = {.round = TRUE};

/* Compiling -------------------------------------------------------------------------------------------------------- */

/* The centre of what a point is fixed to, and how a motion turns that. */
static int32_t frame_of(const TinkerModel *model, int32_t point, const TinkerPlace **turned)
{
    const int32_t body = tinker_model_body_of(model, point);
    *turned = NULL;
    if (body >= 0) return body;
    const TinkerBlockId block = tinker_model_block_of(model, point);
    if (tinker_motions_moves(model->motions, block) && tinker_motions_place(model->motions, block)->turns)
        *turned = tinker_motions_place(model->motions, block);
    return tinker_model_centre(model, block);
}

static void add_pin(TinkerContacts *contacts, const TinkerConstraintBatch *part, int32_t i, double radius)
{
    TinkerModel *model = contacts->model;
    const int32_t *ends = part->end_points + part->batch->end_offsets[i];
    const int32_t last = tinker_contacts_plates(contacts);
    contacts->pin_count++;
    TinkerPlate *plate = &contacts->plates[last];
    *plate = (TinkerPlate){.block = part->batch->ids[i], .bearer = -1, .gap = &no_gap, .half_width = INFINITY};
    for (int side = 0; side < 2; side++)
        plate->frame[side] = frame_of(model, ends[1 - side], &plate->frame_turned[side]);
    plate->point = plate->frame[1];
    plate->moving = plate->frame_turned[0] != NULL || plate->frame_turned[1] != NULL;
    plate->joint_row = part->first_row + 2 * i;
    const int32_t body = tinker_contact_pin_body(contacts, last);
    plate->arm = tinker_model_turn(model, body)->gyration;
    plate->surface.static_friction = plate->surface.dynamic_friction = radius / plate->arm;
}

/* Of the blocks that declare friction, how large it is: by instance, 0 where there is none. NULL: none declares any.
 * (transfer full) */
static double *radii_of(const TinkerConstraintBatch *part)
{
    const TinkerConstraint *constraint = part->constraint;
    if (constraint->friction == NULL || part->batch->count == 0) return NULL;
    g_autofree double *radii = g_new0(double, part->batch->count);
    TinkerBatch view = part->view;
    if (TINKER_CALL_BATCH(part->batch, "friction", &view, constraint->friction(&view, radii)) != TINKER_OK) return NULL;
    return g_steal_pointer(&radii);
}

int32_t tinker_model_rubbing_pins(const TinkerModel *model)
{
    int32_t count = 0;
    for (guint p = 0; p < model->constraints.batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(model->constraints.batches, TinkerConstraintBatch, p);
        g_autofree double *radii = radii_of(part);
        for (int32_t i = 0; radii != NULL && i < part->batch->count; i++)
            count += radii[i] > 0;
    }
    return count;
}

void tinker_contacts_list_pins(TinkerContacts *contacts, int32_t count)
{
    const TinkerModel *model = contacts->model;
    const int32_t before = tinker_contacts_first_pin(contacts);
    if (count == 0) return;
    contacts->plates = g_renew(TinkerPlate, contacts->plates, before + count);
    for (guint p = 0; p < model->constraints.batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(model->constraints.batches, TinkerConstraintBatch, p);
        g_autofree double *radii = radii_of(part);
        for (int32_t i = 0; radii != NULL && i < part->batch->count; i++)
            if (radii[i] > 0) add_pin(contacts, part, i, radii[i]);
    }
}

/* Whether friction may act between what two points are fixed to: that needs an angle on both sides. */
static gboolean may_rub(const TinkerModel *model, const int32_t ends[2])
{
    int32_t turning = 0;
    for (int k = 0; k < 2; k++) {
        const int32_t body = tinker_model_body_of(model, ends[k]);
        if (body >= 0 && tinker_model_turn(model, body) == NULL) return FALSE;
        turning += body >= 0;
    }
    return turning > 0;
}

gboolean tinker_model_check_pins(const TinkerModel *model, GError **error)
{
    for (guint p = 0; p < model->constraints.batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(model->constraints.batches, TinkerConstraintBatch, p);
        g_autofree double *radii = radii_of(part);
        for (int32_t i = 0; radii != NULL && i < part->batch->count; i++) {
            if (!(radii[i] > 0) || may_rub(model, part->end_points + part->batch->end_offsets[i])) continue;
            g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                        _("%s has friction, and does not join two things that have an angle: a mass turns with nothing "
                          "(take a body that turns, as a disc, in its place; or leave the friction out)"),
                        tinker_scene_block_name(model->scene, part->batch->ids[i]));
            return FALSE;
        }
    }
    return TRUE;
}

void tinker_contacts_pin_torques(const TinkerContacts *contacts, const TinkerConstraintBatch *part, double *torques)
{
    memset(torques, 0, (gsize)part->batch->end_count * sizeof(double));
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        const int32_t row = plate->joint_row - part->first_row;
        if (!tinker_contacts_is_pin(contacts, contact) || row < 0 || row >= part->row_count) continue;
        torques[row] = -contact->friction * plate->arm;
        torques[row + 1] = contact->friction * plate->arm;
    }
}

int32_t tinker_contact_pin_body(const TinkerContacts *contacts, int32_t number)
{
    const TinkerPlate *plate = &contacts->plates[number];
    return plate->frame[0] < contacts->model->bodies ? plate->frame[0] : plate->frame[1];
}

void tinker_contacts_close_pins(TinkerContacts *contacts)
{
    const int32_t first = tinker_contacts_first_pin(contacts);
    for (int32_t k = first; k < first + contacts->pin_count; k++) {
        const TinkerContact contact = {
            .body = tinker_contact_pin_body(contacts, k), .plate = k, .mode = TINKER_CONTACT_SMOOTH};
        g_array_append_val(contacts->closed, contact);
    }
}

gboolean tinker_contact_pin_is_determined(TinkerModel *model, const TinkerPlate *plate)
{
    TinkerConstraints *all = &model->constraints;
    g_autofree double *asked = g_new0(double, MAX(all->rows, 1));
    for (int k = 0; all->redundant > 0 && k < 2; k++) {
        memset(asked, 0, (gsize)all->rows * sizeof(double));
        asked[plate->joint_row + k] = 1;
        if (tinker_constraints_solve(model, asked) > TINKER_SHARED_PIN) return FALSE;
    }
    return TRUE;
}

/* Forces ----------------------------------------------------------------------------------------------------------- */

double tinker_contact_pin_force(const TinkerContacts *contacts, const TinkerPlate *plate)
{
    const double *force = contacts->model->constraints.lambda + plate->joint_row;
    return hypot(force[0], force[1]);
}

void tinker_contacts_note_pin_forces(TinkerContacts *contacts)
{
    for (guint i = 0; contacts->pin_count > 0 && i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        if (tinker_contacts_is_pin(contacts, contact)) contact->normal = tinker_contact_pin_force(contacts, plate);
    }
}

static const TinkerPlate *plate_of(const TinkerContacts *contacts, const TinkerContactRow *row)
{
    return &contacts->plates[tinker_contacts_closed(contacts, (guint)row->contact)->plate];
}

void tinker_contact_pins_keep(TinkerContacts *contacts, const TinkerContactBlock *block, double *into, gsize stride)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    for (int32_t k = 0; contacts->pin_count > 0 && k < block->count; k++) {
        if (rows[k].pin_slope == 0) continue;
        const double *force = contacts->model->constraints.lambda + plate_of(contacts, &rows[k])->joint_row;
        into[2 * (gsize)k * stride] = force[0];
        into[(2 * (gsize)k + 1) * stride] = force[1];
    }
}

/* F of the pin of row k with these forces (scaled), and its direction. */
static double force_on(const TinkerContactPins *pins, const TinkerContactRow *rows, int32_t count, int32_t k,
                       const double *found, double direction[2])
{
    double force[2];
    for (int c = 0; c < 2; c++) {
        const double *answers = pins->block_answers + (gsize)(2 * k + c) * (gsize)count;
        force[c] = pins->block_free[2 * k + c];
        for (int32_t j = 0; j < count; j++)
            force[c] += answers[j] * rows[j].weight * found[j];
    }
    const double size = hypot(force[0], force[1]);
    direction[0] = size > 0 ? force[0] / size : 0;
    direction[1] = size > 0 ? force[1] / size : 0;
    return size;
}

/* The row of the system that keeps f = slope e . F, and what it asks for. */
static double fill_row(const TinkerContactPins *pins, const TinkerContactRow *rows, int32_t count, int32_t k,
                       const double direction[2], double *row)
{
    const double share = rows[k].pin_slope / rows[k].weight;
    const double *answers = pins->block_answers + (gsize)(2 * k) * (gsize)count;
    for (int32_t j = 0; j < count; j++)
        row[j] = (j == k) -
                 share * rows[j].weight * (direction[0] * answers[j] + direction[1] * answers[(gsize)count + (gsize)j]);
    return share * (direction[0] * pins->block_free[2 * k] + direction[1] * pins->block_free[2 * k + 1]);
}

void tinker_contact_pins_solve(TinkerContacts *contacts, TinkerContactBlock *block, double *demand)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    TinkerContactPins *pins = &contacts->pins;
    const int32_t count = block->count;
    double *matrix = contacts->delassus + block->matrix, *found = pins->found, direction[2];
    pins->block_free = pins->free + 2 * (gsize)block->first;
    pins->block_answers = pins->answers + 2 * block->matrix;
    memset(found, 0, (gsize)count * sizeof(double));
    double last = INFINITY;
    for (int pass = 0; pass < MOST_PASSES; pass++) {
        double off = 0, most = 0;
        memcpy(pins->before, found, (gsize)count * sizeof(double));
        memcpy(found, demand, (gsize)count * sizeof(double));
        for (int32_t k = 0; k < count; k++) {
            if (rows[k].pin_slope == 0) continue;
            force_on(pins, rows, count, k, pins->before, direction);
            found[k] = fill_row(pins, rows, count, k, direction, matrix + (gsize)k * (gsize)count);
        }
        tinker_dense_solve_factor(block->solve[FALSE], matrix);
        tinker_dense_solve_near(block->solve[FALSE], contacts->base + block->first, found);
        for (int32_t j = 0; j < count; j++) {
            off = fmax(off, fabs(found[j] - pins->before[j]));
            most = fmax(most, fabs(found[j]));
        }
        /* no nearer than rounding: where it no longer shrinks */
        if (!(off > 4 * DBL_EPSILON * most) || (off <= 1e-12 * most && off >= last)) break;
        last = off;
    }
    memcpy(demand, found, (gsize)count * sizeof(double));
}
