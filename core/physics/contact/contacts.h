/* Contact of bodies with the solid tops of plates, with Coulomb friction.
 *
 * A body is a point that stands off what it touches by half its height; a plate is a segment with one solid side:
 *
 *     gap   = n . (x - c) - top,   n the plate's normal, c its centre, top = (height of plate + height of body) / 2
 *     along = t . (x - c),         t = (n_y, -n_x), the plate's own +x; over the plate where |along| <= width / 2
 *
 * A contact is closed while the body rests on the top or slides along it. Which contacts are closed and whether they
 * stick changes at events alone (contact-change-private.h); between them closed contacts are equations, solved here
 * together with the constraint rows:
 *
 *     n . (a - a_c) = 0;   sticking: t . (a - a_c) = 0;   slipping: friction -mu N sign(u_t) along t.
 *
 * Bodies that turn have a shape. Each gap function of a pair of shapes (shapes/gaps.h) stands for a plate of its own
 * here, behind the tops: then n, t and where they act follow from the state, and the same holds of rows over up to six
 * coordinates. Whatever is closed, opens, sticks or slips does so function by function. So it is for masses, too, on a
 * top that a motion turns: the seat of their gap function is the top, lifted by half their height.
 *
 * What resists rolling has a plate of its own, too, behind the gap functions. It has no normal: it turns against the
 * plate that bears it, is closed while that is, and its `friction` is a force at the arm `arm`, so that it is measured
 * in newtons and metres as all others are:
 *
 *     u = arm (rate of the tip's frame - rate of the seat's),   |friction| <= (rho / arm) N.
 *
 * So has the friction of a pin, which is always closed; in place of N it has the magnitude of the pin's force
 * (contact-pins.c).
 *
 * Bodies that no constraint holds and that touch one plate are solved one by one in closed form; the others together: a
 * few equations by the Delassus matrix of their contacts, W = C P M^-1 D, with P the projection onto the motions that
 * the constraints allow; many by elimination (contact-elimination.h), without W. */
#ifndef TINKER_CORE_CONTACTS_H
#define TINKER_CORE_CONTACTS_H

#include <math.h>

#include "numerics/contact/contact-laws.h"
#include "numerics/contact/impact-law.h"
#include "numerics/solve/dense-solve.h"
#include "physics/contact/contact-elimination.h"
#include "physics/contact/surfaces.h"
#include "physics/contact/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/shapes/gaps.h"
#include "physics/shapes/unturned.h"
#include "scene/frame/overlaps.h"

/* Two shapes that may touch: a body's and a support's or another body's. */
typedef struct {
    int32_t point[2]; /* of their centres: of bodies, or of a support */
    const TinkerOutline *outline[2];
    double angle[2];           /* rad: of what does not turn by itself, */
    double cosine[2], sine[2]; /* and of that angle */
    const TinkerPlace *turned; /* how a motion turns the support that is the second; NULL: none does */
    double lift;               /* m: what the first, a mass, is over what it lies on */
    int32_t top;               /* the plate of the support that is the second; -1: a body */
    gboolean moving;           /* that */
    int32_t unturned; /* of two bodies that do not turn: the number of what they have in place of outlines; else -1 */
    double way[2];    /* m: of these, from the second to the first, as placed */
    int32_t first, count; /* its gap functions, among the plates; written there */
    gboolean filled;      /* once it is near (tinker_contacts_fill_pair) */
    gboolean rolls;       /* something resists rolling */
    gboolean passes;      /* they overlap, and do so until they have parted */
} TinkerTouchingPair;

typedef struct {
    TinkerBlockId block;           /* of a gap function: of the second of the pair */
    int32_t point;                 /* of its centre */
    double orientation, normal[2]; /* rad; out of the solid side */
    double half_height, half_width;
    TinkerSurface surface; /* of a gap function that between the two; of a top its own */
    gboolean moving;
    const TinkerPlace *turned;    /* how a motion turns it, so that masses meet it by gap functions; NULL: none does */
    const TinkerGapFunction *gap; /* NULL: a top, as masses meet it; else that of ... */
    const TinkerTouchingPair *pair;
    int32_t resistance; /* of a gap function: the plate that stands for what resists its rolling; 0: nothing does */
    double arm;         /* m: of what resists turning; 0: a plate that touches, ... */
    int32_t bearer;     /* ... else the plate whose normal force bounds it; -1: it is of a pin */
    /* of what resists turning: that of the first of these (points of a body's or a support's centre) relative to the
     * second, and how motions turn the two */
    int32_t frame[2];
    const TinkerPlace *frame_turned[2];
    int32_t joint_row; /* of a pin: the first of the two constraint rows that hold it */
} TinkerPlate;

typedef struct {
    int32_t body, plate;
    TinkerContactMode mode;  /* not OPEN */
    double anchor;           /* `rolled` of one that sticks (TinkerContactPlace) */
    gboolean starts;         /* slips, and has no speed yet that tells which way */
    gboolean at_limit;       /* slips by its static coefficient: it has reached that, but others hold what it rubs on */
    double normal, friction; /* N, on the body along n and t (on what has the tip of a gap): as worked out last */
    /* Where contacts hold a body more than once nothing determines how they share its load: the share stays as near to
     * this one (N) as the load allows, which the laws of contact gave. */
    double base_normal, base_friction;
    int32_t bearer; /* of what resists rolling: the number of the closed contact that it leans on; else -1. Found when
                       rows are listed */
} TinkerContact;

/* How a gap function's gap and its speed along the seat depend on the motion of its bodies. */
typedef struct {
    int32_t count, coordinate[6];
    double row[2][6];      /* normal, tangential: by these coordinates */
    double of_supports[2]; /* m/s: speeds that supports give to the two, beside the rows' */
    double drift[2];       /* m/s^2: accelerations beside the rows', those of supports included */
    double normal[2];
    double point[2]; /* where it touches, relative to the origin */
} TinkerContactEntries;

/* What a body presses with, as impulses have it (impulse/pile.h): where, and the mean of the last step. */
typedef struct {
    int32_t body, by;        /* points: of the body that it acts on, and of the body or support that it comes from */
    double normal[2];        /* out of the other */
    double press, friction;  /* N, along the normal and t */
    double from[2][2];       /* m: to where they touch from the centre of each, where the step began */
    double arm[2], slide[2]; /* of both bodies: the arms of these there, over the radius of gyration */
} TinkerPressing;

/* One equation of the closed contacts that are solved together: `row` is what it keeps at 0, `force` the direction of
 * the force that does so. Of a gap function they are found anew for every state, by the coordinates of its entries. */
typedef struct {
    int32_t contact;
    gboolean tangential;
    double row[2], force[2];
    double weight;   /* root of the body's mass: W is scaled by it to about 1 */
    int32_t entries; /* of a gap function: its number among contacts->entries; else -1 */
    double share;    /* of slipping friction, along with a normal force */
    /* what resists its rolling, and turns: closed contact (-1: nothing), number of its entries, share */
    int32_t resisting, resisting_entries;
    double resisting_share;
    double pin_slope; /* of a pin that turns: its friction over the magnitude of its force; else 0 */
} TinkerContactRow;

/* Rows of bodies that are tied together or touch, behind one another: no other row changes what they ask for. */
typedef struct {
    int32_t first, count;
    gboolean held;              /* W changes with the constraints or the state; else it is factored once */
    gsize matrix;               /* where that of W begins among those of all blocks */
    TinkerDenseSolve *solve[2]; /* W with the directions of the rows' forces; with those of the rows themselves */
    gboolean factored[2];
    TinkerContactElimination *elimination; /* in place of W where there are many rows; borrowed */
    gboolean uneven; /* bodies of very different masses touch: W has lost some of what it says of the heavy ones */
    gboolean full;   /* its forces are determined */
} TinkerContactBlock;

/* What friction of pins is solved with; allotted with the rows where there are pins. */
typedef struct {
    double *free;           /* 2 a row: the force of a pin without any contact */
    double *answers;        /* 2 a row of each row of its block: what a unit of that one's force adds to it */
    double *found, *before; /* a row */
    const double *block_free, *block_answers; /* of the block that is solved: its part of these */
} TinkerContactPins;

struct _TinkerContacts {
    TinkerModel *model;
    TinkerImpactLaw impact_law;         /* of the scene's run */
    int32_t plate_count, moving_plates; /* tops; behind them stand the gap functions, */
    int32_t gap_count;
    int32_t resistance_count; /* behind these what resists the rolling of some of them, */
    int32_t pin_count;        /* and the friction of pins */
    TinkerContactPins pins;
    gboolean bodies_listed;    /* bodies that meet each other have gap functions: they are not too many */
    int32_t *first_gap;        /* bodies + 1: the plate that the gap functions of each body begin with */
    TinkerOutline *outlines;   /* of bodies that turn and are solid, and of those that collide, then of tops */
    TinkerUnturned *unturned;  /* what pairs of two that do not turn have in place of these */
    TinkerTouchingPair *pairs; /* that have gap functions */
    int32_t pair_count;
    double *reach; /* of each body: its farthest point from its centre; 0: it has none */
    double *angle; /* of each body that does not turn: rad, as it is placed */
    TinkerGapFunction *functions;
    double *corners;    /* what outlines lie in */
    double thickness;   /* m: the largest half heights of a plate and a body */
    double plate_speed; /* m/s: of moving plates, the largest so far */
    TinkerPlate *plates;
    TinkerSurface *surfaces; /* of each body */
    gboolean own_surfaces;   /* some body has one of its own */
    double *half_height;     /* of each body; NAN: it touches nothing */
    gboolean *held;          /* by body: a constraint acts on it */
    int32_t *tied;           /* by body: the first of those that constraints tie together; */
    int32_t *group;          /* of those that may touch besides: contacts of one group are decided together; */
    int32_t *touching;       /* of those that touch besides, when rows were listed last */

    GArray *closed;    /* of TinkerContact, by body, then by plate */
    gboolean impulses; /* act on them, step by step (impulse.h): they are no equations, and have none */
    GArray *pressings; /* of TinkerPressing: with `impulses`, of bodies with outlines */
    GArray *simple;    /* of int32_t: numbers of closed contacts that are solved one by one */
    GArray *rows;      /* of TinkerContactRow: the others' equations */
    GArray *entries;   /* of TinkerContactEntries: of closed gap functions, for the state they were listed at last */
    gboolean any_slip_friction;
    /* By the first body: of what is tied; of what may meet. Made when they are asked for; of one that ties all that may
     * meet the other's does. */
    TinkerContactElimination **eliminations[2];

    /* working state; what depends on the rows is allotted when they change */
    GArray *blocks;                          /* of TinkerContactBlock */
    GPtrArray *eliminated;                   /* of TinkerContactElimination: those of blocks that have one; borrowed */
    double *delassus;                        /* of each block that is solved by it, rows x rows */
    double *demand, *base, *found, *asked;   /* of all rows */
    TinkerContactEquation *equations[2];     /* of all rows, as the blocks have them: for forces; for moves */
    double *column, *accelerations, *before; /* 2 per body */
    double *acts;                            /* by coordinate: the magnitudes of what accelerates it, added up */
    gboolean pushed;                         /* held bodies, which constraints have not answered to yet */
    gint64 evaluations;                      /* of closed contacts, ever: 0 where nothing touched */
};

/* The contacts that a model may have; NULL where no plate is solid or no body has a shape, and no constraint holds in
 * one direction only. (transfer full) */
TinkerContacts *tinker_contacts_new(TinkerModel *model);
void tinker_contacts_free(TinkerContacts *contacts);

/* How many bodies have outlines, and may meet each other. */
int32_t tinker_contacts_outlines(const TinkerContacts *contacts);
/* Whether there are tops, or bodies with outlines that meet each other; of NULL there are none. */
gboolean tinker_contacts_can_meet(const TinkerContacts *contacts);

/* The pairs of blocks that a joint, a gear or a rack holds together, which do not meet (transfer full); and whether two
 * are one of these. */
GHashTable *tinker_contacts_joined_blocks(const TinkerModel *model);
gboolean tinker_contacts_are_joined(GHashTable *joined, gint64 a, gint64 b);

/* Writes the gap functions of a pair, and their plates, where that was not done yet: before anything asks for them.
 * Nothing is allotted. The second finds the pair of a plate, if it is that of a gap function. */
void tinker_contacts_fill_pair(TinkerContacts *contacts, TinkerTouchingPair *pair);
void tinker_contacts_fill_plate(TinkerContacts *contacts, int32_t number);

/* The plate of a closed contact of a part's, whose body has this number here: the tops are the same and in the same
 * order, gap functions those of its own pairs, and what resists turning stands behind all of them. Fills it in. */
int32_t tinker_contacts_plate_of_part(TinkerContacts *contacts, const TinkerContacts *part,
                                      const TinkerContact *contact, int32_t body);

/* Where a body is as seen from a plate, for the state in the model's points. */
typedef struct {
    double gap, along;                     /* m */
    double normal_speed, tangential_speed; /* m/s, relative to the plate */
    double along_speed;                    /* m/s: how `along` grows, of one that rolls more than its slipping */
    double rolled, period; /* m: what stays of one that sticks, but for multiples of the period (0: none) */
} TinkerContactPlace;

/* Of a gap function. */
TinkerContactPlace tinker_contact_gap_place(const TinkerContacts *contacts, int32_t number);
/* Its gap (m) alone, to the same bits, which is told much sooner. */
double tinker_contact_gap_alone(const TinkerContacts *contacts, int32_t number);
void tinker_contact_gap_entries(const TinkerContacts *contacts, int32_t number, TinkerContactEntries *entries);
/* One of its rows (0: normal, 1: tangential) times a vector by coordinate. */
double tinker_contact_times(const TinkerContactEntries *entries, int which, const double *by_coordinate);
/* Whether the tip is over the seat (TinkerContactPlace.along), and the pair does not pass. */
gboolean tinker_contact_gap_is_over(const TinkerContacts *contacts, int32_t number, double tolerance);
/* What is to be told where so many bodies could meet that they do not, by events; NULL: nothing. (transfer full) */
char *tinker_contacts_unmet(const TinkerModel *model);
/* Adds warnings (TinkerWarning *) of pairs that overlap, for the state in the model's points: they pass at first. */
void tinker_contacts_tell_overlaps(TinkerContacts *contacts, GPtrArray *warnings);
/* The same of one pair, which counts as told where it overlaps; and how many of these were too many to tell of. */
void tinker_contacts_tell_overlap(const TinkerContacts *contacts, const int32_t point[2], double overlap, guint *told,
                                  GPtrArray *warnings);
void tinker_contacts_tell_more_overlaps(guint told, GPtrArray *warnings);
/* How far (m) two shapes overlap, as tinker_outlines_overlap has it. */
double tinker_contact_pair_overlap(TinkerContacts *contacts, TinkerTouchingPair *pair);

/* How it is turned (rad) at the time of the model. */
static inline double tinker_plate_angle(const TinkerPlate *plate)
{
    return plate->orientation + (plate->turned != NULL ? plate->turned->angle : 0);
}

static inline gboolean tinker_contacts_is_gap(const TinkerContacts *contacts, const TinkerContact *contact)
{
    return contact->plate >= contacts->plate_count;
}

/* Whether it is what resists turning, and touches nothing by itself. */
static inline gboolean tinker_contacts_resists(const TinkerContacts *contacts, const TinkerContact *contact)
{
    return contacts->plates[contact->plate].arm > 0;
}

/* The plate that the friction of pins begins with. */
static inline int32_t tinker_contacts_first_pin(const TinkerContacts *contacts)
{
    return contacts->plate_count + contacts->gap_count + contacts->resistance_count;
}

/* Of all plates, whatever they stand for. */
static inline int32_t tinker_contacts_plates(const TinkerContacts *contacts)
{
    return tinker_contacts_first_pin(contacts) + contacts->pin_count;
}

/* Whether that is a pin's friction. */
static inline gboolean tinker_contacts_is_pin(const TinkerContacts *contacts, const TinkerContact *contact)
{
    return tinker_contacts_resists(contacts, contact) && contacts->plates[contact->plate].bearer < 0;
}

/* Whether these plates are of corners of one edge on another, which rub along one line; so is a corner with itself. For
 * a state of the model. */
gboolean tinker_contacts_on_one_line(const TinkerContacts *contacts, int32_t number, int32_t other);

/* Whether two corners of one edge stick on another: along it they hold the body by one line together. So does each of
 * them with itself. */
static inline gboolean tinker_contacts_stick_together(const TinkerContacts *contacts, const TinkerContact *a,
                                                      const TinkerContact *b)
{
    if (a->mode != TINKER_CONTACT_STICK || b->mode != TINKER_CONTACT_STICK) return FALSE;
    return tinker_contacts_on_one_line(contacts, a->plate, b->plate);
}

/* What a contact that sticks has left its place by (m). */
static inline double tinker_contact_creep(const TinkerContactPlace *place, double anchor)
{
    const double off = place->rolled - anchor;
    return place->period > 0 ? remainder(off, place->period) : off;
}

/* Whether a body has an outline, so that it meets others: one that turns, or a mass that collides. */
static inline gboolean tinker_contacts_has_outline(const TinkerContacts *contacts, int32_t body)
{
    return contacts->reach[body] > 0 || contacts->outlines[body].corners != NULL;
}

/* Whether a body may touch anything. */
static inline gboolean tinker_contacts_may_touch(const TinkerContacts *contacts, int32_t body)
{
    return !isnan(contacts->half_height[body]) || tinker_contacts_has_outline(contacts, body);
}

static inline TinkerContactPlace tinker_contact_place(const TinkerContacts *contacts, int32_t body, int32_t number)
{
    const TinkerPlate *plate = &contacts->plates[number];
    if (plate->gap != NULL) return tinker_contact_gap_place(contacts, number);
    const TinkerPoint *at = &contacts->model->point[body], *centre = &contacts->model->point[plate->point];
    const double dx = at->x - centre->x, dy = at->y - centre->y, ux = at->vx - centre->vx, uy = at->vy - centre->vy;
    const double nx = plate->normal[0], ny = plate->normal[1];
    const double along = ny * dx - nx * dy, slides = ny * ux - nx * uy;
    return (TinkerContactPlace){nx * dx + ny * dy - (plate->half_height + contacts->half_height[body]),
                                along,
                                nx * ux + ny * uy,
                                slides,
                                slides,
                                along,
                                0};
}

/* Whether any body touches a plate, and does not part from it, for the state in the points; or a pin has friction. */
gboolean tinker_contacts_touch(TinkerContacts *contacts);

/* Whether no gap changes while bodies turn about their centres: all that turn and may touch something are discs. */
gboolean tinker_contacts_are_round(const TinkerContacts *contacts);

/* Whether two tops guide a body: they face each other, and are as far apart as it is high, to within TINKER_TOUCHING,
 * for the places and motions of the supports in the points. */
gboolean tinker_contacts_are_guide(const TinkerContacts *contacts, int32_t body, int32_t a, int32_t b);
/* Whether a plate and one that a body lies on guide it: a way from one to the other there is none. */
gboolean tinker_contacts_is_guided(const TinkerContacts *contacts, int32_t body, int32_t plate);

/* The greatest distance (m) of a body from the centre of a plate that it rests on, for the state in the points: what
 * places are measured from. 0 where no contact is closed. */
double tinker_contacts_extent(const TinkerContacts *contacts);

/* The surface between the two of a pair. */
TinkerSurface tinker_contact_pair_surface(const TinkerContacts *contacts, const TinkerTouchingPair *pair);

/* The surface between a body and a plate. */
static inline TinkerSurface tinker_contact_surface(const TinkerContacts *contacts, int32_t body, int32_t plate)
{
    const TinkerSurface *own = &contacts->plates[plate].surface;
    if (G_LIKELY(!contacts->own_surfaces) || plate >= contacts->plate_count) return *own;
    return tinker_surface_between(own, &contacts->surfaces[body]);
}

/* Friction along t over the normal force, of a contact that slips. */
static inline double tinker_contact_slip_share(const TinkerContacts *contacts, const TinkerContact *contact)
{
    const TinkerSurface surface = tinker_contact_surface(contacts, contact->body, contact->plate);
    const double share = contact->at_limit ? surface.static_friction : surface.dynamic_friction;
    if (contact->mode == TINKER_CONTACT_SLIP_FORWARD) return -share;
    return contact->mode == TINKER_CONTACT_SLIP_BACKWARD ? share : 0.0;
}

/* Whether the foot of a body is over the plate. At the very end, within `tolerance` (m), one that moves on off it is
 * not. */
static inline gboolean tinker_contact_is_over(const TinkerContacts *contacts, int32_t number,
                                              const TinkerContactPlace *place, double tolerance)
{
    const TinkerPlate *plate = &contacts->plates[number];
    if (plate->gap != NULL) return tinker_contact_gap_is_over(contacts, number, tolerance);
    double beyond = fabs(place->along) - plate->half_width;
    return beyond <= -tolerance || (beyond <= tolerance && place->along * place->tangential_speed <= 0);
}

static inline TinkerContact *tinker_contacts_closed(const TinkerContacts *contacts, guint number)
{
    return &g_array_index(contacts->closed, TinkerContact, number);
}

/* Whether there are equations of contact to be solved at all. */
static inline gboolean tinker_contacts_act(const TinkerContacts *contacts)
{
    return G_UNLIKELY(contacts != NULL && contacts->closed->len > 0 && !contacts->impulses);
}

/* Sorts the closed contacts and lists their equations: after any change of them. Where there is no memory for the
 * equations, none is closed any more, and that is recorded as below. */
TinkerStatus tinker_contacts_list_rows(TinkerContacts *contacts);
/* Opens all, so that there are no equations. */
void tinker_contacts_open_all(TinkerContacts *contacts);
/* Whether the forces of a block were determined when they were solved for last; FALSE before. */
static inline gboolean tinker_contact_block_is_full(const TinkerContactBlock *block)
{
    return block->elimination != NULL ? block->full : tinker_dense_solve_is_full(block->solve[FALSE]);
}
/* Takes over the shares of the load (base_normal, base_friction) of contacts whose equations are listed. */
void tinker_contacts_take_shares(TinkerContacts *contacts);
/* Records that there is no memory for the equations of so many contacts at once, as the model's failure. Answers
 * TINKER_FAILED. */
TinkerStatus tinker_contacts_lack_memory(const TinkerContacts *contacts, gsize count);

/* Between events, for the state in the points. ------------------------------------------------------------------- */

/* a = M^-1 f becomes the acceleration with constraints, whose rows were evaluated, and closed contacts, whose forces
 * are noted. */
void tinker_contacts_accelerate(TinkerContacts *contacts, double *a);
/* Adds what friction takes and what moving plates give to model->book_power, for the forces worked out last. */
void tinker_contacts_add_power(TinkerContacts *contacts);
/* Adds M^-1 times the friction of slipping contacts, as worked out last, to a. */
void tinker_contacts_add_friction(const TinkerContacts *contacts, double *a);

/* These bring a state onto closed contacts and constraints, as tinker_constraints_project_positions and its neighbours
 * do for constraints alone. Of positions the energy (J) that it gave is left in *work; of velocities it is answered. */
TinkerStatus tinker_contacts_project_positions(TinkerContacts *contacts, double t, double *q, const double *v,
                                               gboolean *moved, double *work);
double tinker_contacts_correct_velocities(TinkerContacts *contacts, double *v, gboolean homogeneous, gboolean *moved);
TinkerStatus tinker_contacts_rattle(TinkerContacts *contacts, double t_from, const double *q_from, double t, double h,
                                    double *q, double *v);

/* At events. ----------------------------------------------------------------------------------------------------- */

/* The Delassus matrix (2m x 2m, see numerics/contact/contact-laws.h) of m contacts, whatever their modes, for the
 * constraint rows evaluated last. */
void tinker_contacts_delassus(TinkerContacts *contacts, const TinkerContact *touching, int32_t count, double *delassus);
/* v += what an impulse on a body does to all of them, constraints included. */
void tinker_contacts_push(TinkerContacts *contacts, int32_t body, double px, double py, double *v);
/* Impulses on several bodies, which the constraints answer to at once, in the end. */
void tinker_contacts_begin_pushes(TinkerContacts *contacts);
void tinker_contacts_add_push(TinkerContacts *contacts, int32_t body, double px, double py, double *v);
void tinker_contacts_end_pushes(TinkerContacts *contacts, double *v);

/* v += what impulses along the normal and the tangent of a contact do to all bodies, for the state in the points. */
void tinker_contacts_push_along(TinkerContacts *contacts, const TinkerContact *contact, double normal,
                                double tangential, double *v);
/* What changes of velocities of all bodies are along a contact; and accelerations, relative to what is touched. */
void tinker_contacts_along(const TinkerContacts *contacts, const TinkerContact *contact, const double *by_coordinate,
                           double along[2]);
void tinker_contacts_relative_acceleration(const TinkerContacts *contacts, const TinkerContact *contact,
                                           const double *a, double along[2]);

/* Joins the bodies of a constraint row, among sets of bodies (numerics/solve/disjoint-sets.h). */
void tinker_contacts_tie(const TinkerModel *model, int32_t row, int32_t *sets);
/* The first body of a constraint row; -1 for none. */
int32_t tinker_contacts_row_body(const TinkerContacts *contacts, int32_t row);
/* v += what the multiplier `lambda` of a row that holds in one direction only, slack or not, does to all bodies. */
void tinker_contacts_pull(TinkerContacts *contacts, int32_t row, double lambda, double *v);
/* Whether other constraints leave such a row nothing to move along: a rope to a body that is welded to where the rope
 * goes. All rows that hold in one direction only are to be slack. */
gboolean tinker_contacts_row_is_held(TinkerContacts *contacts, int32_t row);

/* The moment (N m) that resists the rolling of a closed contact, on the body that has the tip of its gap. */
double tinker_contacts_moment(const TinkerContacts *contacts, int32_t number);

/* What contacts do to the points of bodies and plates, for the sampler: normal force, friction, fx, fy of each point.
 */
void tinker_contacts_sum_forces(const TinkerContacts *contacts, double *by_point);

#endif
