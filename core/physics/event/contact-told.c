/* What a change of contacts tells: its events, by the names of what touches, and why a run cannot go on. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"

/* Whether an event of this kind was told of the pair already; notes that it is now. */
static gboolean was_told(TinkerContactChange *change, const char *kind, const TinkerTouchingPair *pair)
{
    for (guint i = 0; pair != NULL && i < change->told->len; i++) {
        const TinkerToldEvent *told = &g_array_index(change->told, TinkerToldEvent, i);
        if (told->pair == pair && g_str_equal(told->kind, kind)) return TRUE;
    }
    const TinkerToldEvent now = {kind, pair, NULL};
    if (pair != NULL) g_array_append_val(change->told, now);
    return FALSE;
}

/* "A, B" of a body and what it touches (transfer full). What leaves an end is what has the tip, whichever body was
 * placed first; off a support goes the body. */
static char *names_of(const TinkerContactChange *change, const char *kind, const TinkerTouch *of)
{
    const TinkerModel *model = change->model;
    const TinkerPlate *plate = &change->contacts->plates[of->contact.plate];
    const char *body = tinker_scene_block_name(model->scene, model->body_blocks[of->contact.body]),
               *other = tinker_scene_block_name(model->scene, plate->block);
    if (tinker_contacts_is_pin(change->contacts, &of->contact)) return g_strdup(other);
    const gboolean turned_round = g_str_equal(kind, "end") && plate->gap != NULL && plate->gap->tip_of == 1 &&
                                  plate->pair->point[1] < model->bodies;
    return turned_round ? g_strdup_printf("%s, %s", other, body) : g_strdup_printf("%s, %s", body, other);
}

void tinker_change_add_event(TinkerContactChange *change, const char *kind, const TinkerTouch *of)
{
    TinkerScene *scene = change->model->scene;
    if (of->row >= 0) {
        tinker_island_run_add_event(change->run->run, kind,
                                    tinker_scene_block_name(scene, change->model->constraints.blocks[of->row]));
        return;
    }
    if (was_told(change, kind, change->contacts->plates[of->contact.plate].pair)) return;
    g_autofree char *names = names_of(change, kind, of);
    tinker_island_run_add_event(change->run->run, kind, names);
    const GPtrArray *events = change->run->run->summary.events;
    TinkerEvent *event = g_ptr_array_index(events, events->len - 1);
    event->turns = tinker_contacts_resists(change->contacts, &of->contact);
    const TinkerTouchingPair *pair = change->contacts->plates[of->contact.plate].pair;
    if (pair == NULL) return;
    g_array_index(change->told, TinkerToldEvent, change->told->len - 1).event = event;
}

void tinker_change_note_staying(TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->contacts;
    for (guint i = 0; i < change->told->len; i++) {
        const TinkerToldEvent *told = &g_array_index(change->told, TinkerToldEvent, i);
        for (guint k = 0; told->event != NULL && k < contacts->closed->len; k++)
            told->event->stays |= contacts->plates[tinker_contacts_closed(contacts, k)->plate].pair == told->pair;
    }
}

gboolean tinker_change_refuse(TinkerContactChange *change, const char *why, GError **error)
{
    return tinker_island_run_fail_step(change->run->run, why, error);
}

/* Whether what is touched goes towards the body by a prescribed motion, or is about to. */
static gboolean closes_as_prescribed(const TinkerContactChange *change, const TinkerTouch *at)
{
    const TinkerContacts *contacts = change->contacts;
    double along[2];
    if (at->row >= 0 || !contacts->plates[at->contact.plate].moving) return FALSE;
    tinker_contacts_along(contacts, &at->contact, change->run->run->state.v, along);
    const double own = at->place.normal_speed - along[0];
    if (fabs(own) > TINKER_STILL * change->speed) return own < 0;
    g_autofree double *at_rest = g_new0(double, change->model->coordinates);
    tinker_contacts_relative_acceleration(contacts, &at->contact, at_rest, along);
    return along[0] < 0;
}

static gboolean rubs(const TinkerContactChange *change, int32_t body)
{
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->contact.body == body && tinker_touch_surface(change, i).static_friction > 0)
            return TRUE;
    return FALSE;
}

/* The first that something closes on by a prescribed motion, and that rubs; -1: there is none. */
static int32_t wedged_body(const TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (closes_as_prescribed(change, at) && rubs(change, at->contact.body)) return at->contact.body;
    }
    return -1;
}

gboolean tinker_change_refuse_laws(TinkerContactChange *change, TinkerContactResult result, const char *why,
                                   GError **error)
{
    const TinkerModel *model = change->model;
    const int32_t body = wedged_body(change);
    if (result != TINKER_CONTACT_NO_MEMORY && body < 0) return tinker_change_refuse(change, why, error);
    if (result != TINKER_CONTACT_NO_MEMORY) {
        g_autofree char *wedged = g_strdup_printf(
            _("%s is wedged: the motion of what closes on it is prescribed, and friction lets it go nowhere "
              "(make it smoother, or give the motion a way that leaves it room)"),
            tinker_scene_block_name(model->scene, model->body_blocks[body]));
        return tinker_change_refuse(change, wedged, error);
    }
    tinker_contacts_lack_memory(change->contacts, change->touches->len);
    return tinker_change_refuse(change, change->model->failure, error);
}
