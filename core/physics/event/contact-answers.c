/* How what touches answers to pushes, and to what acts: the numbers that the laws of contact are solved with. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"

/* The largest m whose 2m x 2m entries an int32_t counts. */
#define MOST_TOUCHES 23170

/* v += what an impulse (pn, pt) at a contact does. */
static void push(const TinkerContactChange *change, guint number, double pn, double pt, double *v)
{
    const TinkerTouch *at = tinker_touch(change, number);
    if (at->row >= 0) {
        tinker_contacts_pull(change->contacts, at->row, -pn, v);
        return;
    }
    tinker_contacts_begin_pushes(change->contacts);
    tinker_contacts_push_along(change->contacts, &at->contact, pn, pt, v);
    tinker_contacts_end_pushes(change->contacts, v);
}

void tinker_change_push(const TinkerContactChange *change, const double *impulses, double *v)
{
    TinkerContacts *contacts = change->contacts;
    tinker_contacts_begin_pushes(contacts);
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        const double pn = impulses[2 * i], pt = impulses[2 * i + 1];
        if (at->row >= 0 || (pn == 0 && pt == 0)) continue;
        tinker_contacts_push_along(contacts, &at->contact, pn, pt, v);
    }
    tinker_contacts_end_pushes(contacts, v);
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->row >= 0 && impulses[2 * i] != 0) push(change, i, impulses[2 * i], 0, v);
}

/* What a change of velocities (or accelerations) of all bodies is along a contact: normal and tangential. */
static void along_contact(const TinkerContactChange *change, guint number, const double *by_body, double *normal,
                          double *tangential)
{
    const TinkerTouch *at = tinker_touch(change, number);
    *tangential = 0;
    if (at->row >= 0) {
        *normal = at->held ? 0 : -tinker_constraints_own_row_times(change->model, at->row, by_body);
        return;
    }
    double along[2];
    tinker_contacts_along(change->contacts, &at->contact, by_body, along);
    *normal = along[0];
    *tangential = along[1];
}

void tinker_contact_laws_clear(TinkerContactLaws *laws)
{
    gpointer arrays[] = {laws->delassus, laws->pairs,  laws->answers,  laws->first,    laws->second,     laws->modes,
                         laws->sliding,  laws->bearer, laws->pin_size, laws->pin_free, laws->pin_answers};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    tinker_contact_reach_clear(&laws->reach);
}

/* `resists`: some may lean on others. */
static gboolean allot_laws(TinkerContactLaws *laws, gboolean resists)
{
    const gsize m = laws->count;
    laws->pairs = g_try_new0(double, 2 * m);
    laws->answers = g_try_new0(double, 2 * m);
    laws->first = g_try_new0(double, m);
    laws->second = g_try_new0(double, m);
    laws->sliding = g_try_new0(int8_t, m);
    laws->modes = g_try_new0(TinkerContactMode, m);
    if (resists) laws->bearer = g_try_new0(int32_t, m);
    if (resists && laws->bearer == NULL) return FALSE;
    return laws->pairs != NULL && laws->answers != NULL && laws->first != NULL && laws->second != NULL &&
           laws->sliding != NULL && laws->modes != NULL;
}

/* FALSE: no memory. */
static gboolean allot_pins(TinkerContactLaws *laws, const TinkerContactChange *change)
{
    const gsize m = laws->count;
    if (change->contacts->pin_count == 0) return TRUE;
    laws->pin_size = g_try_new0(double, m);
    laws->pin_free = g_try_new0(double, 2 * m);
    laws->pin_answers = m <= MOST_TOUCHES ? g_try_new0(double, 4 * m * m) : NULL;
    return laws->pin_size != NULL && laws->pin_free != NULL && laws->pin_answers != NULL;
}

/* The multipliers solved last, of all pins with friction: two numbers a touch, `stride` apart. */
static void keep_pins(const TinkerContactChange *change, double *into, gsize stride)
{
    for (guint i = 0; i < change->touches->len; i++) {
        if (!tinker_touch_is_pin(change, i)) continue;
        const double *force = change->model->constraints.lambda + tinker_touch_plate(change, i)->joint_row;
        into[2 * i * stride] = force[0];
        into[(2 * i + 1) * stride] = force[1];
    }
}

void tinker_change_note_pins(const TinkerContactChange *change, TinkerContactLaws *laws)
{
    if (laws->pin_free != NULL) keep_pins(change, laws->pin_free, 1);
}

double tinker_change_size_pins(const TinkerContactChange *change, TinkerContactLaws *laws, const double *forces)
{
    const gsize width = 2 * laws->count;
    double off = 0;
    for (guint i = 0; laws->pin_size != NULL && i < laws->count; i++) {
        if (!tinker_touch_is_pin(change, i)) continue;
        double force[2] = {laws->pin_free[2 * i], laws->pin_free[2 * i + 1]};
        for (gsize c = 0; c < 2; c++)
            for (gsize k = 0; k < width; k++)
                force[c] += laws->pin_answers[(2 * i + c) * width + k] * forces[k];
        const double size = hypot(force[0], force[1]);
        off = fmax(off, fabs(size - laws->pin_size[i]) / fmax(size, laws->pin_size[i]));
        laws->pin_size[i] = size;
    }
    return off;
}

/* Many contacts of plates alone. FALSE: no memory. */
static gboolean reach_contacts(TinkerContactLaws *laws, const TinkerContactChange *change)
{
    const gsize m = laws->count;
    if (m <= TINKER_FEW_CONTACTS || !change->contacts->held[tinker_touch(change, 0)->contact.body]) return TRUE;
    g_autofree TinkerContact *touching = g_try_new(TinkerContact, m);
    if (touching == NULL) return FALSE;
    for (guint i = 0; i < m; i++) {
        if (tinker_touch(change, i)->row >= 0 || tinker_touch_plate(change, i)->gap != NULL) return TRUE;
        touching[i] = tinker_touch(change, i)->contact;
    }
    if (!tinker_contact_reach_take(&laws->reach, change->contacts, touching, (int32_t)m)) return FALSE;
    if (laws->reach.motion.context != NULL) laws->motion = &laws->reach.motion;
    return TRUE;
}

TinkerStatus tinker_contact_laws_init(TinkerContactLaws *laws, const TinkerContactChange *change)
{
    const gsize m = change->touches->len;
    double *answer = change->contacts->column;
    *laws = (TinkerContactLaws){.count = m};
    if (!allot_laws(laws, change->contacts->resistance_count + change->contacts->pin_count > 0) ||
        !reach_contacts(laws, change))
        return tinker_contacts_lack_memory(change->contacts, m);
    for (guint i = 0; laws->bearer != NULL && i < m; i++)
        laws->bearer[i] = tinker_touch_is_pin(change, i) ? -1 : (int32_t)tinker_touch_bearer(change, i);
    if (!allot_pins(laws, change)) return tinker_contacts_lack_memory(change->contacts, m);
    if (laws->motion != NULL) return TINKER_OK;
    laws->delassus = m <= MOST_TOUCHES ? g_try_new0(double, 4 * m * m) : NULL;
    if (laws->delassus == NULL) return tinker_contacts_lack_memory(change->contacts, m);
    for (guint column = 0; column < 2 * m; column++) {
        const TinkerTouch *at = tinker_touch(change, column / 2);
        if (at->held || (column % 2 == 1 && at->row >= 0)) continue;
        memset(answer, 0, (gsize)change->model->coordinates * sizeof(double));
        push(change, column / 2, column % 2 == 0, column % 2 == 1, answer);
        for (guint i = 0; i < m; i++)
            along_contact(change, i, answer, &laws->delassus[2 * i * 2 * m + column],
                          &laws->delassus[(2 * i + 1) * 2 * m + column]);
        if (laws->pin_answers != NULL) keep_pins(change, laws->pin_answers + column, 2 * m);
    }
    return TINKER_OK;
}

gboolean tinker_change_accelerations(TinkerContactChange *change, double *pairs, double *scale)
{
    TinkerModel *model = change->model;
    double *a = change->acceleration;
    if (tinker_model_applied(model, a, FALSE) != TINKER_OK) return FALSE;
    if (model->constraints.rows > 0) tinker_constraints_accelerate(model, a);
    *scale = 0;
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        const TinkerPlate *plate = tinker_touch_plate(change, i);
        int32_t body = at->contact.body;
        along_contact(change, i, a, &pairs[2 * i], &pairs[2 * i + 1]);
        if (plate != NULL && plate->gap != NULL) {
            tinker_contacts_relative_acceleration(change->contacts, &at->contact, a, &pairs[2 * i]);
        } else if (plate != NULL) {
            const double *base = model->point_acceleration + 2 * plate->point, *n = plate->normal;
            pairs[2 * i] -= n[0] * base[0] + n[1] * base[1];
            pairs[2 * i + 1] -= n[1] * base[0] - n[0] * base[1];
        } else if (!at->held) {
            pairs[2 * i] -= tinker_constraints_own_drift(model, at->row);
        }
        *scale = fmax(*scale, hypot(pairs[2 * i], pairs[2 * i + 1]) +
                                  (fabs(model->force[2 * body]) + fabs(model->force[2 * body + 1])) *
                                      model->inverse_mass[body]);
    }
    return TRUE;
}
