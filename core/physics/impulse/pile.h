/* Bodies that turn, and masses that collide, with contact as impulses: all that touches in a step is solved together.
 *
 *     near (pile-near.c)    pairs that may meet within the next steps, found by a grid
 *     touch (pile-touch.c)  where they touch in this one, and what that asks for
 *     solve (pile-solve.c)  the impulses, by sweeps along the contacts that start from those of the last step,
 *           (pile-direct.c) or of stacks and chains by one factor
 *           (pile-wedged.c) or of what wedges by pivots
 *     joints (pile-joints.c) what constraints on these bodies ask for, in each sweep
 *           (pile-tied.c)   and in the factor
 *     step (pile-step.c)    velocities, positions, books
 *
 * Rows are by the three coordinates of each of two bodies, x, y and turn (a length, as models have it), so that one
 * mass moves all three:
 *
 *     u_n = n . (v_a - v_b) + arm_a turn_a' - arm_b turn_b',   least <= u_n'  |  0 <= p_n   (one of the two holds)
 *     u_t = t . (v_a - v_b) + slide_a turn_a' - slide_b turn_b',   |p_t| <= mu p_n,  u_t' = 0 or p_t against u_t'
 *
 * least = -gap / h: nothing overlaps at the end of the step, to first order. What approaches faster than forces make it
 * in one step strikes. Then the rows are solved twice: once as they are, which is how the bodies move up to where they
 * touch; and once by Newton's law, least = -e u_n, which is how they go on from there. So impacts are solved as a
 * whole, wherever in the step they fall, and no rebound adds energy. */
#ifndef TINKER_CORE_PILE_H
#define TINKER_CORE_PILE_H

#include "numerics/solve/sparse-ldl.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/shapes/manifold.h"

/* The velocity of a shape, and the inverse of its mass; of a top 0. */
typedef struct {
    double v[3], inverse_mass;
} TinkerPileBody;

/* What sweeps work on. */
typedef struct {
    double arm[2], slide[2];        /* of the first and the second */
    double least;                   /* m/s */
    double give_normal, give_slide; /* kg: the impulse that changes the speed by 1 m/s */
    double take_normal, take_slide; /* 1/kg: their reciprocals */
    double friction;                /* largest |p_t| / p_n */
    double normal, sliding;         /* N s: the impulses */
} TinkerPilePoint;

/* What else is known of a point. */
typedef struct {
    double gap, at[2]; /* m */
    double rebound;    /* m/s: of what strikes */
    gboolean strikes;
    int32_t corner;
} TinkerPileMark;

/* Two shapes that touch. */
typedef struct {
    int32_t body[2];
    double normal[2];
    int32_t first, count; /* of its points, behind one another */
    int32_t near;
    int32_t next; /* of the same group of bodies (pile-wedged.c) */
} TinkerPileTouch;

/* What is known of a point from the last step. */
typedef struct {
    int32_t corner;
    double normal, sliding; /* N */
    gboolean stuck;
} TinkerPileKept;

/* A pair that may meet soon. */
typedef struct {
    int32_t first, second; /* shapes: bodies, then tops; first < second */
    TinkerSurface surface;
    gboolean passes; /* bodies that overlap since the start */
    gboolean above;  /* of a top: the first came from above */
    double side[2];  /* of a line and what has no inside either: the normal that they had last; (0, 0): none */
    int32_t count;
    TinkerPileKept kept[2];
} TinkerPileNear;

typedef struct {
    int64_t row, column;
    int32_t shape;
} TinkerPileCell;

/* What constraints that hold bodies of the pile ask of velocities (pile-joints.c). */
typedef struct {
    gboolean *has;           /* by row of the model: it holds bodies of the pile */
    double *before, *wanted; /* by row, m/s: J v at the start of the step; J v' */
    double *asked;           /* by row: room */
    double *v;               /* by point: room; of supports 0 */
    gboolean *struck;        /* by group of bodies: something strikes one of them */
    double power;            /* W: what supports that move and prescribed rows gave at the start of the step */
} TinkerPileJoints;

/* A row of constraints over the unknowns of a factor (pile-tied.c). */
typedef struct {
    int32_t row, count;
    gsize first, first_slot; /* of its entries; of its slots in the factor, of the lower triangle of their products */
    double stiff;            /* kg: K */
} TinkerPileTiedRow;

typedef struct {
    GArray *rows;                   /* of TinkerPileTiedRow */
    TinkerCoordinateEntry *entries; /* of these, by unknown */
    int32_t *slots;
    gsize slot_count;
    TinkerCoordinateEntry *room; /* for one row */
} TinkerPileTied;

/* What all impulses are solved for at once with (pile-pattern.c, pile-direct.c). */
typedef struct {
    TinkerSparseLdl *ldl; /* NULL: there is none for the pairs that are near now */
    gboolean tried;
    int32_t *number;   /* by shape: among the bodies that are solved for; -1: a top */
    int32_t *diagonal; /* 6 a body: slots of its lower triangle, row by row */
    int32_t *between;  /* 9 a near pair: slots of first by second, row by row; -1: a top's */
    gsize between_size;
    double *right;
    guint8 *guess; /* by point */
    TinkerPileBody *bodies;
    gsize points;
    TinkerPileTied *tied; /* NULL: no constraints */
} TinkerPileDirect;

/* What contacts that wedge are solved for with (pile-wedged.c). */
typedef struct TinkerPileWedged TinkerPileWedged;

typedef struct {
    const TinkerContacts *contacts;
    TinkerModel *model;
    int32_t shapes;                   /* bodies of the model, then tops */
    int32_t *members;                 /* shapes that meet others: bodies, then tops */
    int32_t body_count, member_count; /* of them */
    int32_t *solved, solved_count;    /* bodies that are solved for: these, and what constraints tie to them */
    gboolean *has;                    /* by body: it is one of those */
    TinkerPileJoints *joints;         /* NULL: no constraint holds one */
    GHashTable *joined;               /* pairs of blocks that joints keep from meeting */
    TinkerPlacedShape *shape;         /* by shape */
    double *corners, *local;          /* what these lie in, and the same in their own axes; ... */
    gsize *first_corner;              /* ... corners of each, and their normals, from here on */
    TinkerPileBody *bodies;           /* by shape: velocities at the end of the step */
    TinkerPileBody *without, *moves;  /* likewise: without the impulses of contacts; on the way to it */
    double *by_gyration;              /* by shape: 1/m; 0: it does not turn */
    double *before, *pull;            /* 3 by shape: velocities and accelerations at the start of the step */
    double slow;                      /* m/s: what slides more slowly at the start sticks */

    GArray *near, *near_was; /* of TinkerPileNear, by both: now, and before they were listed anew */
    double *listed, *margin; /* 2 by shape: where it was then; m: how far it may go before they are again */
    double *sorted;
    GArray *cells; /* of TinkerPileCell */
    gboolean started;

    TinkerPileTouch *touches; /* of this step; there is room for what is near, as for ... */
    TinkerPilePoint *points;
    TinkerPileMark *marks; /* ... by point */
    int32_t touch_count, point_count;
    guint near_room;
    double scale;   /* m/s: what a point misses its least speed by without contact, at the most */
    double largest; /* m/s: the largest scale so far */
    gboolean strikes, overlaps;
    double left;     /* m/s: what the last sweep of the last solve changed speeds by, where that was too much */
    double unsolved; /* m/s: of the step in this way; 0: its impulses were solved for */
    double *along;   /* 4 by point: the direction that sweeps go on along, and the impulses before one */
    gsize along_size;
    TinkerPileDirect *direct;
    TinkerPileWedged *wedged;
} TinkerPile;

/* NULL where no body has a shape that meets others. (transfer full) */
TinkerPile *tinker_pile_new(const TinkerContacts *contacts);
void tinker_pile_free(TinkerPile *pile);

/* Whether a body is of it. */
static inline gboolean tinker_pile_has(const TinkerPile *pile, int32_t body)
{
    return pile != NULL && pile->has[body];
}

/* A step from the start of it to its end, of the bodies of the pile alone. */
typedef struct TinkerImpulses TinkerImpulses;
void tinker_pile_step(TinkerImpulses *self, TinkerState *state);

/* Of what constraints hold bodies of the pile by; NULL: none do. (transfer full) */
TinkerPileJoints *tinker_pile_joints_new(const TinkerPile *pile);
void tinker_pile_joints_free(TinkerPileJoints *joints);
/* Finds what they ask for in a step h, and brings the bodies' velocities there: for rows evaluated at its start. */
void tinker_pile_joints_begin(TinkerPile *pile, double h);
/* Brings the bodies' velocities to what is wanted. */
void tinker_pile_joints_solve(TinkerPile *pile);
/* Brings them to rest across every row. */
void tinker_pile_joints_answer(TinkerPile *pile);
/* From here on what strikes, with all that is tied to it, keeps J v, and the bodies' velocities are brought there; or
 * no row lets anything move across it. */
void tinker_pile_joints_strike(TinkerPile *pile);
void tinker_pile_joints_hold(TinkerPile *pile);
/* Whether what supports and prescribed rows do gives energy through constraints. */
static inline gboolean tinker_pile_joints_are_moved(const TinkerPile *pile)
{
    return pile->model->constraints.prescribed || pile->model->moving_supports > 0;
}
/* J: what contacts and constraints together gave in the step. */
double tinker_pile_joints_give(const TinkerImpulses *self);

/* Rows of constraints in the factor: their pattern, which is written into as many places as there are slots and answers
 * how many of them it took; where they are in the factor; and what they add to a matrix and a right side. */
TinkerPileTied *tinker_pile_tied_new(const TinkerPile *pile);
void tinker_pile_tied_free(TinkerPileTied *tied);
gsize tinker_pile_tied_pattern(const TinkerPile *pile, int *rows, int *columns);
void tinker_pile_tied_find_slots(const TinkerPile *pile);
void tinker_pile_tied_add_values(const TinkerPile *pile, double *values);
void tinker_pile_tied_add_right(const TinkerPile *pile, double *right);
/* Pushes the bodies by what the rows miss with a solution, a change of all velocities. */
void tinker_pile_tied_take_solution(TinkerPile *pile, const double *change);

/* Brings the list of pairs up to date for a step h. */
void tinker_pile_list_near(TinkerPile *pile, double h);

/* Makes room for the points of all that is near. */
void tinker_pile_make_room(TinkerPile *pile);
/* The points that touch within a step h. */
void tinker_pile_find_touches(TinkerPile *pile, double h);

/* Changes the bodies' velocities by the impulses of all points, and finds how they move. */
void tinker_pile_solve(TinkerPile *pile);

/* Whether what is near now is worth a factor. */
gboolean tinker_pile_has_direct(TinkerPile *pile);
/* The impulses of all points at once, from a guess by those that there are (pile-direct.c); the bodies follow. What a
 * point does is wrong by `enough` (m/s) before it is guessed anew. FALSE: no guess held. */
gboolean tinker_pile_solve_directly(TinkerPile *pile, double enough);
/* For a list of pairs that is another from now on. */
void tinker_pile_direct_forget(TinkerPileDirect *direct);
TinkerPileDirect *tinker_pile_direct_new(const TinkerPile *pile);
void tinker_pile_direct_free(TinkerPileDirect *direct);

/* The impulses of groups of bodies in which a point misses its laws by more than `enough` (m/s), by pivots; the bodies
 * do not follow, and stand still. FALSE: there is a group that is too large, or has no impulses that keep the laws. */
gboolean tinker_pile_solve_wedged(TinkerPile *pile, double enough);
TinkerPileWedged *tinker_pile_wedged_new(const TinkerPile *pile);
void tinker_pile_wedged_free(TinkerPileWedged *wedged);

/* Replaces the bodies' velocities by those that part what overlaps within a step h, and nothing else. FALSE: nothing
 * overlaps. */
gboolean tinker_pile_part(TinkerPile *pile, double h);

/* A row with the direction (x, y) and these arms, times what two shapes have by their coordinates. */
static inline double tinker_pile_row(double x, double y, const double arm[2], const double *a, const double *b)
{
    return x * (a[0] - b[0]) + y * (a[1] - b[1]) + arm[0] * a[2] - arm[1] * b[2];
}

/* Lets impulses of a point act on the first and the second of its bodies. */
static inline void tinker_pile_push(TinkerPileBody *a, TinkerPileBody *b, const TinkerPileTouch *touch,
                                    const TinkerPilePoint *point, double normal, double sliding)
{
    const double x = normal * touch->normal[0] + sliding * touch->normal[1];
    const double y = normal * touch->normal[1] - sliding * touch->normal[0];
    a->v[0] += a->inverse_mass * x;
    a->v[1] += a->inverse_mass * y;
    a->v[2] += a->inverse_mass * (normal * point->arm[0] + sliding * point->slide[0]);
    b->v[0] -= b->inverse_mass * x;
    b->v[1] -= b->inverse_mass * y;
    b->v[2] -= b->inverse_mass * (normal * point->arm[1] + sliding * point->slide[1]);
}

/* u_n of a point, for these velocities. */
static inline double tinker_pile_speed(const TinkerPileBody *bodies, const TinkerPileTouch *touch,
                                       const TinkerPilePoint *point)
{
    return tinker_pile_row(touch->normal[0], touch->normal[1], point->arm, bodies[touch->body[0]].v,
                           bodies[touch->body[1]].v);
}

/* u_t likewise. */
static inline double tinker_pile_slide(const TinkerPileBody *bodies, const TinkerPileTouch *touch,
                                       const TinkerPilePoint *point)
{
    return tinker_pile_row(touch->normal[1], -touch->normal[0], point->slide, bodies[touch->body[0]].v,
                           bodies[touch->body[1]].v);
}

#endif
