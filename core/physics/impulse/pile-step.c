/* The pile in the steps of impulses: where its shapes are, what their velocities become, and what that leaves behind in
 * the state, the books and the forces that samples show. */
#include "physics/impulse/pile.h"

#include <math.h>
#include <string.h>

#include "physics/impulse/impulse-private.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

static void place_body(TinkerPile *pile, int32_t body, const double *q)
{
    const TinkerTurn *turn = tinker_model_turn(pile->model, body);
    const double angle = pile->contacts->angle[body];
    const double c = turn != NULL ? turn->cosine : cos(angle), s = turn != NULL ? turn->sine : sin(angle);
    tinker_place_shape(&pile->shape[body], q[2 * body], q[2 * body + 1], c, s, pile->local + pile->first_corner[body]);
}

/* A top where it is at the start of the step, and the speed at which it goes to where it is at the end. */
static void place_top(TinkerPile *pile, int32_t number, const TinkerImpulsePlate *plate, double h)
{
    const int32_t shape = pile->model->bodies + number;
    const double *n = plate->normal, *w = &plate->half_width;
    TinkerPlacedShape *top = &pile->shape[shape];
    double *corners = top->corners;
    for (int k = 0; k < 2; k++) {
        const double along = plate->middle[0] + (k == 0 ? -*w : *w);
        corners[2 * k] = plate->top[0] * n[0] + along * n[1];
        corners[2 * k + 1] = plate->top[0] * n[1] - along * n[0];
        corners[4 + k] = n[k];
    }
    const double rises = (plate->top[1] - plate->top[0]) / h, slides = (plate->middle[1] - plate->middle[0]) / h;
    double *v = pile->bodies[shape].v;
    v[0] = rises * n[0] + slides * n[1];
    v[1] = rises * n[1] - slides * n[0];
    for (int k = 0; k < 2; k++) {
        top->place[k] = 0.5 * (corners[k] + corners[2 + k]);
        pile->before[3 * shape + k] = v[k];
    }
}

static void take_state(TinkerImpulses *self, const TinkerState *state)
{
    TinkerPile *pile = self->pile;
    for (int32_t i = 0; i < pile->body_count; i++)
        place_body(pile, pile->members[i], state->q);
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i], turn = tinker_model_turn_of(self->model, body);
        for (int k = 0; k < 3; k++) {
            const int32_t coordinate = k < 2 ? 2 * body + k : turn;
            const double v = coordinate >= 0 ? state->v[coordinate] : 0, a = coordinate >= 0 ? self->a[coordinate] : 0;
            pile->before[3 * body + k] = v;
            pile->pull[3 * body + k] = a;
            pile->bodies[body].v[k] = v + self->h * a;
        }
    }
    for (int32_t i = 0; i < self->contacts->plate_count; i++)
        if (!pile->started || self->plates[i].moving) place_top(pile, i, &self->plates[i], self->h);
}

/* Lets the bodies move through the step with these velocities; answers what stood still in that time against forces,
 * in J. */
static double displace(const TinkerImpulses *self, const TinkerPileBody *moves, TinkerState *state)
{
    const TinkerPile *pile = self->pile;
    double work = 0;
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i], turn = tinker_model_turn_of(self->model, body);
        for (int k = 0; k < (turn < 0 ? 2 : 3); k++) {
            const int32_t coordinate = k < 2 ? 2 * body + k : turn;
            const double way = self->h * moves[body].v[k];
            state->q[coordinate] += way;
            work += self->model->mass[body] * self->a[coordinate] * way;
        }
    }
    return work;
}

static void take_velocities(const TinkerImpulses *self, TinkerState *state)
{
    const TinkerPile *pile = self->pile;
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i], turn = tinker_model_turn_of(self->model, body);
        memcpy(state->v + 2 * body, pile->bodies[body].v, 2 * sizeof(double));
        if (turn >= 0) state->v[turn] = pile->bodies[body].v[2];
    }
}

/* Twice the mean of a speed at a point, from the start of the step to its end. */
static inline double passes_by(const TinkerPile *pile, const TinkerPileTouch *touch, const double arm[2], double x,
                               double y)
{
    const int32_t first = touch->body[0], second = touch->body[1];
    return tinker_pile_row(x, y, arm, pile->before + 3 * first, pile->before + 3 * second) +
           tinker_pile_row(x, y, arm, pile->bodies[first].v, pile->bodies[second].v);
}

/* Books the impulses of a point; what an impact takes along a side is the impact's. */
static void book(TinkerImpulses *self, const TinkerPileTouch *touch, const TinkerPilePoint *point, gboolean blow)
{
    const TinkerPile *pile = self->pile;
    const double *n = touch->normal;
    self->work[TINKER_BOOK_CONTACTS] += 0.5 * point->normal * passes_by(pile, touch, point->arm, n[0], n[1]);
    self->work[blow ? TINKER_BOOK_CONTACTS : TINKER_BOOK_FRICTION] +=
        0.5 * point->sliding * passes_by(pile, touch, point->slide, n[1], -n[0]);
    const int32_t top = touch->body[1] - self->model->bodies;
    if (top < 0 || !self->plates[top].moving) return;
    const double *w = pile->bodies[touch->body[1]].v;
    self->work[TINKER_BOOK_SUPPORT_MOTION] +=
        point->normal * (n[0] * w[0] + n[1] * w[1]) + point->sliding * (n[1] * w[0] - n[0] * w[1]);
}

static void show(const TinkerImpulses *self, const TinkerPileTouch *touch, const TinkerPilePoint *point,
                 const double at[2], guint number)
{
    const int32_t by = touch->body[1], bodies = self->model->bodies;
    const double *first = self->pile->shape[touch->body[0]].place, *second = self->pile->shape[by].place;
    TinkerPressing *pressing = &g_array_index(self->contacts->pressings, TinkerPressing, number);
    *pressing = (TinkerPressing){
        .body = touch->body[0],
        .by = by < bodies ? by : self->contacts->plates[by - bodies].point,
        .normal = {touch->normal[0], touch->normal[1]},
        .press = point->normal / self->h,
        .friction = point->sliding / self->h,
        .from = {{at[0] - first[0], at[1] - first[1]}, {at[0] - second[0], at[1] - second[1]}},
        .arm = {point->arm[0], point->arm[1]},
        .slide = {point->slide[0], point->slide[1]},
    };
}

/* What the next step starts from. */
static void keep(TinkerImpulses *self, const TinkerPileTouch *touch, guint *pressing)
{
    TinkerPile *pile = self->pile;
    TinkerPileNear *near = &g_array_index(pile->near, TinkerPileNear, touch->near);
    near->count = touch->count;
    for (int32_t k = 0; k < touch->count; k++) {
        const TinkerPilePoint *point = &pile->points[touch->first + k];
        const TinkerPileMark *mark = &pile->marks[touch->first + k];
        const gboolean stuck = point->normal > 0 && fabs(point->sliding) < point->friction * point->normal;
        const double presses = mark->strikes ? 0 : 1 / self->h;
        near->kept[k] = (TinkerPileKept){mark->corner, presses * point->normal, presses * point->sliding, stuck};
        if (!(point->normal > 0)) continue;
        book(self, touch, point, mark->strikes);
        show(self, touch, point, mark->at, (*pressing)++);
        if (mark->strikes) self->last_impact = self->to.t;
    }
}

static double sum_of_work(const TinkerImpulses *self)
{
    double sum = 0;
    for (int k = 0; k < TINKER_BOOK_COUNT; k++)
        sum += self->work[k];
    return sum;
}

/* What joints gave beside contacts, and beside what is booked by its power: supports that move do that, or else the
 * step, which knows rows to first order and is projected back onto them afterwards. */
static void book_joints(TinkerImpulses *self, double by_contacts)
{
    const double given = tinker_pile_joints_give(self) - by_contacts;
    if (tinker_pile_joints_are_moved(self->pile))
        self->work[TINKER_BOOK_SUPPORT_MOTION] += given - self->h * self->pile->joints->power;
    else
        self->parted += given;
}

void tinker_pile_step(TinkerImpulses *self, TinkerState *state)
{
    TinkerPile *pile = self->pile;
    pile->slow = TINKER_START_SLOW * self->context->speed;
    take_state(self, state);
    if (pile->joints != NULL) tinker_pile_joints_begin(pile, self->h);
    tinker_pile_list_near(pile, self->h);
    tinker_pile_find_touches(pile, self->h);
    tinker_pile_solve(pile);
    displace(self, pile->moves, state);
    take_velocities(self, state);
    guint pressing = 0;
    const double booked = sum_of_work(self);
    g_array_set_size(self->contacts->pressings, (guint)pile->point_count);
    for (int32_t i = 0; i < pile->touch_count; i++)
        keep(self, &pile->touches[i], &pressing);
    g_array_set_size(self->contacts->pressings, pressing);
    if (pile->joints != NULL) book_joints(self, sum_of_work(self) - booked);
    /* displacements that part what overlaps have no part in the next step */
    if (tinker_pile_part(pile, self->h)) self->parted -= displace(self, pile->bodies, state);
    pile->started = TRUE;
}

void tinker_impulse_tell_overlaps(const TinkerContacts *contacts, GPtrArray *warnings)
{
    TinkerPile *pile = contacts->bodies_listed ? NULL : tinker_pile_new(contacts);
    guint told = 0;
    if (pile == NULL) return;
    pile->member_count = pile->body_count; /* without tops, of which the contacts told */
    tinker_model_set_state(pile->model, pile->model->q_start, pile->model->v_start);
    for (int32_t i = 0; i < pile->body_count; i++)
        place_body(pile, pile->members[i], pile->model->q_start);
    tinker_pile_list_near(pile, 0);
    for (guint i = 0; i < pile->near->len; i++) {
        const TinkerPileNear *near = &g_array_index(pile->near, TinkerPileNear, i);
        const int32_t point[2] = {near->first, near->second};
        TinkerManifold manifold;
        tinker_manifold_find(&pile->shape[near->first], &pile->shape[near->second], 0, &manifold);
        tinker_contacts_tell_overlap(contacts, point, -manifold.separation, &told, warnings);
    }
    tinker_contacts_tell_more_overlaps(told, warnings);
    tinker_pile_free(pile);
}
