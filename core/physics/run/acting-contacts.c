/* The forces of contacts told apart: each has its normal force and friction, on both sides. */
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/run/acting-forces-private.h"

/* Contacts that there is room for at first, beside one a body. */
#define EXPECTED_CONTACTS 16
#define FORCES_A_CONTACT  4

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
                               .resists = {tinker_acting_torque_on(model, plate->pair->point[tip], moment),
                                           tinker_acting_torque_on(model, plate->pair->point[1 - tip], -moment)},
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

void tinker_acting_add_contacts(TinkerActingForces *forces)
{
    const TinkerContacts *contacts = forces->model->contacts;
    if (contacts == NULL) return;
    make_room(forces);
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (tinker_contacts_resists(contacts, contact)) continue; /* a moment beside the friction of what bears it */
        if (tinker_contacts_is_gap(contacts, contact))
            add_gap(forces, (int32_t)i);
        else
            add_touch(forces, contact);
    }
    for (guint i = 0; i < contacts->pressings->len; i++)
        add_pressing(forces, &g_array_index(contacts->pressings, TinkerPressing, i));
}
