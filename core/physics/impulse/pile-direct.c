/* The impulses of all points by one factor. What each point does is guessed: apart, sticking, or sliding with the
 * friction that it has. The velocities then solve, with stiffnesses K that are large beside the masses,
 *
 *     (M + J^T K J) dv = -J^T K r,   r = J v - least,   dp = -K (r + J dv)
 *
 * by bodies, three coordinates each, so that points that hold the same twice over do no harm; a few passes take what K
 * leaves over. Rows of constraints are among them (pile-tied.c). Where the impulses found contradict the guess it is
 * made anew (an active set method). Source: J. Nocedal, S. J. Wright, "Numerical Optimization", 2nd ed., Springer 2006,
 * sec. 16.5 and 17.3. */
#include <math.h>
#include <string.h>

#include "numerics/solve/sparse-ldl.h"
#include "physics/impulse/pile.h"

/* K over the mass that a point moves. */
#define STIFF        1e6
#define PASSES       4
#define MOST_GUESSES 8

typedef enum { APART, STICKS, SLIDES } Guess;

/* A row over the coordinates of the first and, with the other sign, of the second. */
typedef struct {
    double a[3], b[3], least, stiff;
    double *impulse;
} Row;

static void row_of(const TinkerPileTouch *touch, TinkerPilePoint *point, gboolean slides, Row *row)
{
    const double *n = touch->normal, *arm = slides ? point->slide : point->arm;
    row->a[0] = row->b[0] = slides ? n[1] : n[0];
    row->a[1] = row->b[1] = slides ? -n[0] : n[1];
    row->a[2] = arm[0];
    row->b[2] = arm[1];
    row->least = slides ? 0 : point->least;
    row->stiff = STIFF * (slides ? point->give_slide : point->give_normal);
    row->impulse = slides ? &point->sliding : &point->normal;
}

/* The rows of a touch, two a point; FALSE: as is guessed it holds nothing. */
static gboolean take_row(const TinkerPile *pile, const TinkerPileTouch *touch, int32_t which, Row *row)
{
    const int32_t number = touch->first + which / 2;
    const Guess guess = pile->direct->guess[number];
    if (guess == APART || (which % 2 == 1 && guess == SLIDES)) return FALSE;
    row_of(touch, &pile->points[number], which % 2, row);
    return TRUE;
}

static void add_block(double *values, const int32_t *slots, const double block[9])
{
    for (int r = 0, k = 0; r < 3; r++)
        for (int c = 0; c <= r; c++, k++)
            values[slots[k]] += block[3 * r + c];
}

static void add_touch(const TinkerPile *pile, const TinkerPileTouch *touch, double *values)
{
    const TinkerPileDirect *direct = pile->direct;
    const int32_t first = direct->number[touch->body[0]], second = direct->number[touch->body[1]];
    double own[9] = {0}, other[9] = {0}, both[9] = {0};
    for (int32_t k = 0; k < 2 * touch->count; k++) {
        Row row;
        if (!take_row(pile, touch, k, &row)) continue;
        for (int i = 0; i < 9; i++) {
            own[i] += row.stiff * row.a[i / 3] * row.a[i % 3];
            other[i] += row.stiff * row.b[i / 3] * row.b[i % 3];
            both[i] -= row.stiff * row.a[i / 3] * row.b[i % 3];
        }
    }
    add_block(values, direct->diagonal + 6 * (gsize)first, own);
    if (second < 0) return;
    add_block(values, direct->diagonal + 6 * (gsize)second, other);
    for (int i = 0; i < 9; i++)
        values[direct->between[9 * (gsize)touch->near + (gsize)i]] += both[i];
}

static gboolean factor(TinkerPile *pile)
{
    TinkerPileDirect *direct = pile->direct;
    double *values = tinker_sparse_ldl_values(direct->ldl);
    tinker_sparse_ldl_clear(direct->ldl);
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const double mass = 1 / pile->bodies[pile->solved[i]].inverse_mass;
        values[direct->diagonal[6 * i]] = values[direct->diagonal[6 * i + 2]] = values[direct->diagonal[6 * i + 5]] =
            mass;
    }
    for (int32_t i = 0; i < pile->touch_count; i++)
        add_touch(pile, &pile->touches[i], values);
    if (direct->tied != NULL) tinker_pile_tied_add_values(pile, values);
    return tinker_sparse_ldl_factor(direct->ldl, 0, 0);
}

static double speed_along(const Row *row, const double *v, const double *w)
{
    return row->a[0] * (v[0] - w[0]) + row->a[1] * (v[1] - w[1]) + row->a[2] * v[2] - row->b[2] * w[2];
}

/* Adds to an impulse, and lets that act. */
static void push_along(TinkerPile *pile, const TinkerPileTouch *touch, const Row *row, double push)
{
    TinkerPileBody *first = &pile->bodies[touch->body[0]], *second = &pile->bodies[touch->body[1]];
    *row->impulse += push;
    for (int i = 0; i < 3; i++) {
        first->v[i] += first->inverse_mass * push * row->a[i];
        second->v[i] -= second->inverse_mass * push * row->b[i];
    }
}

static void add_right(const TinkerPile *pile)
{
    TinkerPileDirect *direct = pile->direct;
    memset(direct->right, 0, 3 * (gsize)pile->solved_count * sizeof(double));
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        const int32_t first = direct->number[touch->body[0]], second = direct->number[touch->body[1]];
        const double *v = pile->bodies[touch->body[0]].v, *w = pile->bodies[touch->body[1]].v;
        for (int32_t k = 0; k < 2 * touch->count; k++) {
            Row row;
            if (!take_row(pile, touch, k, &row)) continue;
            const double push = -row.stiff * (speed_along(&row, v, w) - row.least);
            for (int c = 0; c < 3; c++) {
                direct->right[3 * first + c] += push * row.a[c];
                if (second >= 0) direct->right[3 * second + c] -= push * row.b[c];
            }
        }
    }
    if (direct->tied != NULL) tinker_pile_tied_add_right(pile, direct->right);
}

/* Takes the impulses that the solution asks for; the bodies follow by them, so that both agree. */
static void take_solution(TinkerPile *pile)
{
    static const double still[3] = {0, 0, 0};
    TinkerPileDirect *direct = pile->direct;
    memcpy(direct->bodies, pile->bodies, (gsize)pile->shapes * sizeof(TinkerPileBody));
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        const int32_t first = direct->number[touch->body[0]], second = direct->number[touch->body[1]];
        const double *v = direct->bodies[touch->body[0]].v, *w = direct->bodies[touch->body[1]].v;
        const double *dv = direct->right + 3 * first, *dw = second >= 0 ? direct->right + 3 * second : still;
        for (int32_t k = 0; k < 2 * touch->count; k++) {
            Row row;
            if (!take_row(pile, touch, k, &row)) continue;
            const double misses = speed_along(&row, v, w) + speed_along(&row, dv, dw) - row.least;
            push_along(pile, touch, &row, -row.stiff * misses);
        }
    }
    if (direct->tied != NULL) tinker_pile_tied_take_solution(pile, direct->right);
}

/* Sets an impulse, and what it does. */
static void set_impulse(TinkerPile *pile, const TinkerPileTouch *touch, TinkerPilePoint *point, gboolean slides,
                        double value)
{
    Row row;
    row_of(touch, point, slides, &row);
    push_along(pile, touch, &row, value - *row.impulse);
    *row.impulse = value;
}

static Guess guess_of(const TinkerPilePoint *point)
{
    if (!(point->normal > 0)) return APART;
    return fabs(point->sliding) < point->friction * point->normal ? STICKS : SLIDES;
}

/* What contradicts its guess is guessed anew, and friction that slides goes with what presses. TRUE: nothing did. */
static gboolean guess_anew(TinkerPile *pile, double enough)
{
    TinkerPileDirect *direct = pile->direct;
    gboolean holds = TRUE;
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        for (int32_t k = 0; k < touch->count; k++) {
            const gsize number = (gsize)(touch->first + k);
            TinkerPilePoint *point = &pile->points[number];
            const Guess was = direct->guess[number];
            Guess now = guess_of(point);
            if (was == APART)
                now = tinker_pile_speed(pile->bodies, touch, point) < point->least - enough ? STICKS : APART;
            if (was == SLIDES && now == STICKS) now = SLIDES;
            holds &= now == was;
            direct->guess[number] = (guint8)now;
            if (now == APART) set_impulse(pile, touch, point, FALSE, 0);
            if (now == APART) set_impulse(pile, touch, point, TRUE, 0);
            const double limit = point->friction * point->normal;
            if (now == SLIDES) set_impulse(pile, touch, point, TRUE, point->sliding > 0 ? limit : -limit);
        }
    }
    return holds;
}

static void make_room(TinkerPileDirect *direct, gsize points)
{
    if (points <= direct->points) return;
    direct->points = 2 * points;
    direct->guess = g_renew(guint8, direct->guess, direct->points);
}

gboolean tinker_pile_solve_directly(TinkerPile *pile, double enough)
{
    TinkerPileDirect *direct = pile->direct;
    make_room(direct, (gsize)pile->point_count);
    for (int32_t i = 0; i < pile->point_count; i++)
        direct->guess[i] = (guint8)guess_of(&pile->points[i]);
    for (int guess = 0; guess < MOST_GUESSES; guess++) {
        if (!factor(pile)) return FALSE;
        for (int pass = 0; pass < PASSES; pass++) {
            add_right(pile);
            tinker_sparse_ldl_solve(direct->ldl, direct->right);
            take_solution(pile);
        }
        if (guess_anew(pile, enough)) return TRUE;
    }
    return FALSE;
}
