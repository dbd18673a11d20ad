/* Contacts of a model that is held still; see the header. */
#include "physics/event/still-contacts.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/still-contacts-private.h"
#include "physics/event/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

static gboolean may_touch(const TinkerContacts *contacts)
{
    gboolean any = contacts->model->constraints.unilateral != NULL;
    for (int32_t body = 0; body < contacts->model->bodies && contacts->plate_count > 0; body++)
        any |= !isnan(contacts->half_height[body]);
    return any;
}

/* What slides along a top at the start, as the supports move. */
static void note_start(TinkerStillContacts *self)
{
    const TinkerModel *model = self->model;
    double fastest = 0;
    if (tinker_model_set_time(self->model, 0.0) != TINKER_OK) return;
    tinker_model_set_state(self->model, model->q_start, model->v_start);
    for (int32_t i = 0; i < model->points; i++)
        fastest = fmax(fastest, hypot(model->point[i].vx, model->point[i].vy));
    for (int32_t body = 0; body < model->bodies; body++)
        for (int32_t plate = 0; plate < self->contacts->plate_count; plate++) {
            TinkerContactPlace place = tinker_contact_place(self->contacts, body, plate);
            TinkerContactPair pair = {body, plate, -1};
            if (!(fabs(place.gap) <= TINKER_TOUCHING)) continue;
            gboolean slides = fabs(place.tangential_speed) > TINKER_START_SLOW * fastest;
            g_array_append_val(slides ? self->sliding : self->resting, pair);
        }
    self->sliding_at_start = self->sliding->len;
}

TinkerStillContacts *tinker_still_contacts_new(TinkerModel *model)
{
    if (model->contacts == NULL || !may_touch(model->contacts)) return NULL;
    TinkerStillContacts *self = g_new0(TinkerStillContacts, 1);
    gsize bodies = (gsize)MAX(model->bodies, 1),
          gaps = bodies * (gsize)model->contacts->plate_count + (gsize)model->constraints.rows;
    self->model = model;
    self->contacts = model->contacts;
    self->still = g_new0(double, (gsize)MAX(model->coordinates, 1));
    self->acceleration = g_new0(double, (gsize)MAX(model->coordinates, 1));
    self->touches = g_array_new(FALSE, TRUE, sizeof(TinkerTouch));
    self->resting = g_array_new(FALSE, TRUE, sizeof(TinkerContactPair));
    self->sliding = g_array_new(FALSE, TRUE, sizeof(TinkerContactPair));
    for (int k = 0; k < 2; k++)
        self->gaps[k] = g_new0(double, MAX(gaps, 1));
    note_start(self);
    return self;
}

void tinker_still_contacts_free(TinkerStillContacts *self)
{
    if (self == NULL) return;
    g_array_unref(self->touches);
    g_array_unref(self->resting);
    g_array_unref(self->sliding);
    gpointer arrays[] = {self->still, self->acceleration, self->gaps[0], self->gaps[1]};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

void tinker_still_contacts_leave_out_friction(TinkerStillContacts *self)
{
    self->smooth = TRUE;
}

void tinker_still_contacts_begin_anew(TinkerStillContacts *self, gboolean lands_smoothly)
{
    g_array_set_size(self->sliding, self->sliding_at_start);
    self->lands_smoothly = lands_smoothly;
}

void tinker_still_contacts_have_landed(TinkerStillContacts *self)
{
    self->lands_smoothly = FALSE;
}

/* Deciding --------------------------------------------------------------------------------------------------------- */

TinkerStatus tinker_still_set_places(TinkerStillContacts *self, const double *q)
{
    tinker_model_set_state(self->model, q, self->still);
    return self->model->constraints.rows > 0 ? tinker_constraints_evaluate(self->model) : TINKER_OK;
}

gboolean tinker_still_holds_one_way(const TinkerStillContacts *self, int32_t row)
{
    const TinkerConstraints *all = &self->model->constraints;
    return all->unilateral != NULL && all->unilateral[row] && tinker_contacts_row_body(self->contacts, row) >= 0;
}

static void open_all(TinkerStillContacts *self)
{
    tinker_contacts_open_all(self->contacts);
    for (int32_t row = 0; row < self->model->constraints.rows; row++)
        if (tinker_still_holds_one_way(self, row)) tinker_constraints_set_slack(self->model, row, TRUE);
}

static void take_touching(TinkerStillContacts *self)
{
    const TinkerConstraints *all = &self->model->constraints;
    g_array_set_size(self->touches, 0);
    for (int32_t body = 0; body < self->model->bodies; body++)
        for (int32_t plate = 0; plate < self->contacts->plate_count; plate++) {
            TinkerTouch touch = {.contact = {.body = body, .plate = plate}, .row = -1};
            touch.place = tinker_contact_place(self->contacts, body, plate);
            if (!(fabs(touch.place.gap) <= TINKER_TOUCHING) ||
                !tinker_contact_is_over(self->contacts, plate, &touch.place, TINKER_TOUCHING))
                continue;
            g_array_append_val(self->touches, touch);
        }
    for (int32_t row = 0; row < all->rows; row++) {
        if (!tinker_still_holds_one_way(self, row) || !(fabs(all->own_g[row]) <= TINKER_TOUCHING * all->scales[row]))
            continue;
        TinkerTouch touch = {.contact = {.body = tinker_contacts_row_body(self->contacts, row)}, .row = row};
        g_array_append_val(self->touches, touch);
    }
}

static gboolean is_among(const GArray *pairs, const TinkerTouch *touch)
{
    for (guint i = 0; i < pairs->len; i++) {
        const TinkerContactPair *pair = &g_array_index(pairs, TinkerContactPair, i);
        if (pair->body == touch->contact.body && pair->plate == touch->contact.plate) return TRUE;
    }
    return FALSE;
}

static TinkerSurface surface_of(const TinkerStillContacts *self, const TinkerTouch *touch)
{
    return tinker_contact_surface(self->contacts, touch->contact.body, touch->contact.plate);
}

static gboolean may_stick(const TinkerStillContacts *self, const TinkerTouch *touch)
{
    if (self->smooth || touch->row >= 0 || !(surface_of(self, touch).static_friction > 0)) return FALSE;
    return !is_among(self->sliding, touch) && (!self->lands_smoothly || is_among(self->resting, touch));
}

static void note_sliding(TinkerStillContacts *self, const TinkerTouch *touch)
{
    TinkerContactPair pair = {touch->contact.body, touch->contact.plate, -1};
    g_array_append_val(self->sliding, pair);
}

/* What begins to slide does so without friction, so that the others are asked again. `noise` is an acceleration. */
static gboolean ask_laws(TinkerStillContacts *self, const TinkerContactChange *change, TinkerContactLaws *laws,
                         double noise)
{
    gboolean again = TRUE;
    while (again) {
        again = FALSE;
        for (guint i = 0; i < laws->count; i++) {
            const TinkerTouch *touch = tinker_touch(change, i);
            gboolean sticks = may_stick(self, touch);
            laws->sliding[i] = sticks ? 0 : 1;
            laws->first[i] = laws->second[i] = sticks ? surface_of(self, touch).static_friction : 0;
        }
        TinkerClosedContacts closed = {(int32_t)laws->count, laws->delassus, laws->pairs, laws->sliding,
                                       laws->first,          laws->second,   noise,       laws->motion};
        const TinkerContactResult result = tinker_contact_modes(&closed, laws->modes, laws->answers);
        const gboolean solved = result == TINKER_CONTACT_SOLVED;
        if (result == TINKER_CONTACT_NO_MEMORY) {
            tinker_contacts_lack_memory(self->contacts, laws->count);
            return FALSE;
        }
        for (guint i = 0; i < laws->count; i++) {
            const TinkerTouch *touch = tinker_touch(change, i);
            gboolean holds = laws->modes[i] == TINKER_CONTACT_STICK || laws->modes[i] == TINKER_CONTACT_OPEN;
            if (!may_stick(self, touch) || (solved && holds)) continue;
            note_sliding(self, touch);
            again = TRUE;
        }
        if (!solved && !again) return FALSE;
    }
    return TRUE;
}

/* Whether another top that it touches guides the body, whichever it presses on. */
static gboolean is_guided(const TinkerStillContacts *self, const TinkerTouch *touch)
{
    for (guint i = 0; touch->row < 0 && i < self->touches->len; i++) {
        const TinkerTouch *other = &g_array_index(self->touches, TinkerTouch, i);
        if (other->row < 0 && other->contact.body == touch->contact.body &&
            tinker_contacts_are_guide(self->contacts, touch->contact.body, touch->contact.plate, other->contact.plate))
            return TRUE;
    }
    return FALSE;
}

void tinker_still_close(TinkerStillContacts *self, TinkerTouch *touch)
{
    if (touch->row >= 0) {
        tinker_constraints_set_slack(self->model, touch->row, FALSE);
        return;
    }
    touch->contact.anchor = touch->place.along;
    g_array_append_val(self->contacts->closed, touch->contact);
}

static TinkerStatus close_what_acts(TinkerStillContacts *self, const TinkerContactLaws *laws, double noise)
{
    for (guint i = 0; i < self->touches->len; i++) {
        TinkerTouch *touch = &g_array_index(self->touches, TinkerTouch, i);
        gboolean acts = laws->answers[2 * i] > noise * self->model->mass[touch->contact.body];
        touch->contact.normal = touch->contact.base_normal = laws->answers[2 * i];
        touch->contact.base_friction = laws->answers[2 * i + 1];
        touch->contact.mode = !acts && !is_guided(self, touch) ? TINKER_CONTACT_OPEN
                              : may_stick(self, touch)         ? TINKER_CONTACT_STICK
                                                               : TINKER_CONTACT_SMOOTH;
        if (touch->contact.mode != TINKER_CONTACT_OPEN) tinker_still_close(self, touch);
    }
    return tinker_contacts_list_rows(self->contacts);
}

static gboolean refuse(const TinkerStillContacts *self, const char *why, GError **error)
{
    const char *failure = self->model->failure;
    g_set_error_literal(error, TINKER_MODEL_ERROR,
                        self->model->lacks_memory ? TINKER_MODEL_ERROR_MEMORY : TINKER_MODEL_ERROR_RUN,
                        failure[0] != '\0' ? failure : why);
    return FALSE;
}

gboolean tinker_still_contacts_decide(TinkerStillContacts *self, const double *q, GError **error)
{
    self->model->failure = "";
    double scale;
    open_all(self);
    self->pushed = FALSE;
    if (tinker_still_set_places(self, q) != TINKER_OK)
        return refuse(self, _("the forces cannot be made linear there"), error);
    take_touching(self);
    if (self->touches->len == 0) return TRUE;
    TinkerContactChange change = {
        .model = self->model, .contacts = self->contacts, .acceleration = self->acceleration, .touches = self->touches};
    g_auto(TinkerContactLaws) laws = {0};
    if (tinker_contact_laws_init(&laws, &change) != TINKER_OK ||
        !tinker_change_accelerations(&change, laws.pairs, &scale))
        return refuse(self, _("the forces cannot be made linear there"), error);
    if (!ask_laws(self, &change, &laws, TINKER_FORCE_NOISE * scale))
        return refuse(self, _("no motion satisfies the laws of friction for all bodies that touch there"), error);
    if (close_what_acts(self, &laws, TINKER_FORCE_NOISE * scale) == TINKER_OK) return TRUE;
    return refuse(self, NULL, error);
}

/* Telling ---------------------------------------------------------------------------------------------------------- */

static TinkerStillContact told(const TinkerStillContacts *self, const TinkerTouch *touch)
{
    const TinkerModel *model = self->model;
    gboolean acts = touch->contact.mode != TINKER_CONTACT_OPEN;
    if (touch->row >= 0)
        return (TinkerStillContact){acts ? TINKER_STILL_TAUT : TINKER_STILL_SLACK,
                                    model->constraints.blocks[touch->row], TINKER_NO_BLOCK,
                                    acts ? touch->contact.normal : 0, FALSE};
    const TinkerPlate *plate = &self->contacts->plates[touch->contact.plate];
    gboolean sticks = touch->contact.mode == TINKER_CONTACT_STICK;
    return (TinkerStillContact){!acts    ? TINKER_STILL_TOUCHES
                                : sticks ? TINKER_STILL_STICKS
                                         : TINKER_STILL_SLIDES,
                                model->body_blocks[touch->contact.body], plate->block, acts ? touch->contact.normal : 0,
                                acts && !sticks && surface_of(self, touch).dynamic_friction > 0};
}

GArray *tinker_still_contacts_list(const TinkerStillContacts *self)
{
    GArray *list = g_array_new(FALSE, TRUE, sizeof(TinkerStillContact));
    const TinkerConstraints *all = &self->model->constraints;
    for (guint i = 0; i < self->touches->len; i++) {
        TinkerStillContact contact = told(self, &g_array_index(self->touches, TinkerTouch, i));
        if (contact.kind != TINKER_STILL_SLACK) g_array_append_val(list, contact);
    }
    for (int32_t row = 0; row < all->rows; row++) {
        TinkerStillContact slack = {TINKER_STILL_SLACK, all->blocks[row], TINKER_NO_BLOCK, 0, FALSE};
        if (tinker_still_holds_one_way(self, row) && all->slack[row]) g_array_append_val(list, slack);
    }
    return list;
}

const char *tinker_still_contact_kind_name(TinkerStillContactKind kind)
{
    static const char *const names[] = {"slides", "sticks", "touches", "taut", "slack"};
    return names[kind];
}
