/* What the files about changes of contact share. */
#ifndef TINKER_CORE_CONTACT_CHANGE_PRIVATE_H
#define TINKER_CORE_CONTACT_CHANGE_PRIVATE_H

#include "physics/contact/contact-reach.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/model/model-data.h"

/* A contact that is closed, or closes now: of a body with a plate; or a constraint row that holds in one direction
 * only, and is taut or becomes so. A row is a contact without friction that opens as its g falls. */
typedef struct {
    TinkerContact contact; /* of a row: its first body; no plate */
    int32_t row;           /* -1: a plate */
    TinkerContactPlace place;
    TinkerContactMode was; /* before the event; OPEN where it was not closed */
    int8_t limit;          /* the way it slipped by `was`, at the limit of sticking, while others held; 0: it did not */
    gboolean held; /* a row that neither anything acting nor anything prescribed can move: its speed is rounding */
    gboolean struck;
    gboolean slows;   /* it slides, and what acted up to an event of a speed slowed it down */
    gboolean begins;  /* it had no speed along, by which it was known to slide: its mode is what the laws made of it */
    gboolean at_end;  /* of the top: it ends unless something stops the body there */
    gboolean leaves;  /* it has just opened, and is asked for impulses alone: a blow may throw it back */
    gboolean dropped; /* on its way out of the list */
} TinkerTouch;

typedef struct {
    const char *kind;
    const TinkerTouchingPair *pair;
    TinkerEvent *event; /* the summary's */
} TinkerToldEvent;

typedef struct {
    TinkerContactRun *run; /* NULL: of a model that is held still (still-contacts.h), which knows no events */
    TinkerModel *model;
    TinkerContacts *contacts;
    double *acceleration; /* 2 a body, for work */
    TinkerTrigger trigger;
    int32_t group;
    GArray *touches;  /* of TinkerTouch: of this group of bodies */
    GArray *told;     /* of TinkerToldEvent: two corners of one pair that do the same are one event */
    gboolean apart;   /* only what leans on the trigger's body shares its load anew (contact-shares.c) */
    gboolean forced;  /* what was found to reach the limit of sticking slips, whatever the laws could share otherwise */
    gboolean jams;    /* forces have grown beyond all bounds up to here: an impulse is to end that */
    gboolean rattles; /* what is met has struck by turns with others without end, within no time (contact-turns.c) */
    gboolean turns;   /* the force of the trigger's contact has changed by turns likewise, and it is of this group */
    double tolerance; /* m: within it a gap is closed */
    double speed, slow;   /* m/s: the largest; the share of it that is still */
    GArray *alternatives; /* of TinkerAlternative: of the impact, where the laws differ; else NULL. Owned */
    double least_flight;  /* m/s: what rises to no more than places are known by rounding is that slow */
    double least_rise;    /* m/s: what rises to no more than the tolerance, or than the method resolves, is that slow */
} TinkerContactChange;

static inline TinkerTouch *tinker_touch(const TinkerContactChange *change, guint number)
{
    return &g_array_index(change->touches, TinkerTouch, number);
}

/* NULL for a row. */
static inline const TinkerPlate *tinker_touch_plate(const TinkerContactChange *change, guint number)
{
    const TinkerTouch *at = tinker_touch(change, number);
    return at->row < 0 ? &change->contacts->plates[at->contact.plate] : NULL;
}

/* Of a row one without friction and rebound. */
static inline TinkerSurface tinker_touch_surface(const TinkerContactChange *change, guint number)
{
    const TinkerTouch *at = tinker_touch(change, number);
    if (at->row >= 0) return (TinkerSurface){0, 0, 0, 0};
    return tinker_contact_surface(change->contacts, at->contact.body, at->contact.plate);
}

/* What it leans on, which comes before it on the list: of what resists turning another touch, else itself. */
static inline guint tinker_touch_bearer(const TinkerContactChange *change, guint number)
{
    const TinkerPlate *plate = tinker_touch_plate(change, number);
    guint bearer = number;
    if (plate == NULL || !(plate->arm > 0) || plate->bearer < 0) return number;
    while (tinker_touch(change, bearer)->row >= 0 || tinker_touch(change, bearer)->contact.plate != plate->bearer)
        bearer--;
    return bearer;
}

/* Whether it resists turning, and touches nothing. */
static inline gboolean tinker_touch_resists(const TinkerContactChange *change, guint number)
{
    const TinkerPlate *plate = tinker_touch_plate(change, number);
    return plate != NULL && plate->arm > 0;
}

/* Whether it is the friction of a pin. */
static inline gboolean tinker_touch_is_pin(const TinkerContactChange *change, guint number)
{
    return tinker_touch_resists(change, number) && tinker_touch_plate(change, number)->bearer < 0;
}

static inline gboolean tinker_touch_leans(const TinkerContactChange *change, guint number)
{
    return tinker_touch_bearer(change, number) != number;
}

/* Contacts as the laws see them (numerics/contact/contact-laws.h): m of them. */
typedef struct {
    gsize count;
    double *delassus;                  /* 2m x 2m; NULL where they are many: */
    TinkerContactReach reach;          /* then solves do, ... */
    const TinkerContactMotion *motion; /* ... else NULL */
    double *pairs, *answers;           /* 2m, 2m */
    double *first, *second;            /* m */
    int32_t *bearer;                   /* m; NULL: none leans on another */
    /* of pins with friction, at their numbers: the magnitudes of their forces, as found last (m); the force without any
     * contact, of accelerations (2m); what a unit of each entry adds to it (2m x 2m). NULL: there are none */
    double *pin_size, *pin_free, *pin_answers;
    int8_t *sliding;
    TinkerContactMode *modes;
} TinkerContactLaws;
void tinker_contact_laws_clear(TinkerContactLaws *laws);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerContactLaws, tinker_contact_laws_clear)

/* With how they answer to one another. Where there is no memory for it, that is the model's failure. */
TinkerStatus tinker_contact_laws_init(TinkerContactLaws *laws, const TinkerContactChange *change);

/* Keeps the forces that pins with friction have by the accelerations worked out last, without any contact. */
void tinker_change_note_pins(const TinkerContactChange *change, TinkerContactLaws *laws);
/* Works out how large they are with these forces of all contacts; answers the largest relative change of one. */
double tinker_change_size_pins(const TinkerContactChange *change, TinkerContactLaws *laws, const double *forces);

/* Brings the model to the state of the run, constraint rows included. */
TinkerStatus tinker_change_set_state(const TinkerContactChange *change);

/* Takes everything of the group that touches, within `tolerance` (m). */
void tinker_change_take(TinkerContactChange *change, double tolerance);
/* Notes which of them are held; the model is at the state of the run, and nothing of the group is closed. */
void tinker_change_note_held(TinkerContactChange *change);
/* Takes what is `dropped` off the list. */
void tinker_change_drop(TinkerContactChange *change);
/* Looks where they are now. */
void tinker_change_measure(TinkerContactChange *change);
gboolean tinker_change_is_trigger(const TinkerContactChange *change, const TinkerTouch *of);
/* What speeds of a touch are rounding beside (m/s): the largest that there is, or, where rounding is all that moves,
 * what bodies gain as they fall by their own size. For what parts or strikes alone: slip and ends of tops are held
 * against the largest speed, since a motion so slow is one as well where nothing opens or closes by it. */
double tinker_change_speed_scale(const TinkerContactChange *change, const TinkerTouch *at);
/* Whether the two come nearer to each other, for the state that the model was brought to. */
gboolean tinker_change_approaches(const TinkerContactChange *change, const TinkerContactPair *pair);
/* v += what impulses (pn, pt by turns) at all contacts do. */
void tinker_change_push(const TinkerContactChange *change, const double *impulses, double *v);
/* Accelerations with constraints but without contacts, relative to what is touched; *scale is the greatest that acts.
 */
gboolean tinker_change_accelerations(TinkerContactChange *change, double *pairs, double *scale);
void tinker_change_add_event(TinkerContactChange *change, const char *kind, const TinkerTouch *of);
/* Of what was told of pairs of shapes: whether the two touch elsewhere from here on, now that all is settled. */
void tinker_change_note_staying(TinkerContactChange *change);
/* Stops the run. Answers FALSE. */
gboolean tinker_change_refuse(TinkerContactChange *change, const char *why, GError **error);
/* Stops the run where the laws were not solved: `why`, unless it was for want of memory. */
gboolean tinker_change_refuse_laws(TinkerContactChange *change, TinkerContactResult result, const char *why,
                                   GError **error);

/* Impacts, where anything approaches. */
gboolean tinker_change_strike(TinkerContactChange *change, GError **error);
/* Numbers (one for each touch) that contacts of one pair have in common. Answers how many pairs there are. */
int32_t tinker_change_number_pairs(const TinkerContactChange *change, int32_t *pair);
/* Notes what other laws of impact make of one that was solved (`impulses`), where that differs: once for a run it is a
 * warning. */
void tinker_change_note_alternatives(TinkerContactChange *change, const TinkerImpact *impact, const int32_t *pair,
                                     const double *impulses);
/* Drops what parts, and decides of all that is left, by the laws of accelerations, whether it opens, slips or sticks;
 * an impulse ends sliding that jams. FALSE: refused. */
gboolean tinker_change_decide(TinkerContactChange *change, GError **error);
/* Whether a corner slides, behind a blow, by too little to be seen. Blocks that rock down to rest strike with their
 * corners by turns and slide a little in between, infinitely often in finite time; discs that rock between two walls
 * do, with blows so slow at last that what lies between them is rounding of places. What stops so may throw another
 * back on what it has just parted from, to be struck again: then it slides on. */
gboolean tinker_change_hardly_slides(const TinkerContactChange *change, const TinkerTouch *at);

/* Whether so many changes came before this one at the same instant that they do not end by themselves. */
static inline gboolean tinker_change_repeats(const TinkerContactChange *change)
{
    return change->run != NULL && tinker_contact_run_repeats(change->run);
}

/* What guides the body together with a touch; NULL for nothing. */
TinkerTouch *tinker_change_other_side(const TinkerContactChange *change, const TinkerTouch *at);
/* One side of each guide stays closed, whatever the laws say of each by itself; what slides goes on as it did. */
void tinker_change_choose_sides(TinkerContactChange *change);
/* Whether it passes from one side of a guide to the other, which is no event. */
gboolean tinker_change_changes_side(const TinkerContactChange *change, const TinkerTouch *at);

/* Where the motion depends on how the closed contacts of the group share their load: once for a run it is a warning. */
void tinker_change_note_share(TinkerContactChange *change);
/* Whether nothing determines how the closed contacts of the group share their load. */
gboolean tinker_change_shares_load(const TinkerContactChange *change);
/* Shares the load evenly where that keeps the laws, or evenly among bodies and among the corners of one by what presses
 * on each; else as the laws gave it, which may stand at a limit, among corners likewise. Answers whether it is the even
 * share: what has reached its limit by another one need not slip then. */
gboolean tinker_change_share_load(TinkerContactChange *change);
/* Lets impulses act, and books what they take. */
gboolean tinker_change_push_all(TinkerContactChange *change, const double *impulses);

#endif
