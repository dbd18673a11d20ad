/* The impulses of all points, by sweeps: each point by turns to what its own law asks for beside the impulses of the
 * others (projected Gauss-Seidel), from the impulses of the last step on. A sweep moves news by one contact, so that a
 * stack of n takes some n^2 of them; each goes on along the direction of the last ones, as conjugate gradients do, and
 * far fewer are enough. What rests is solved by one; of stacks and chains all impulses are solved for at once after a
 * few. Source: M. Silcowitz-Hansen, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for
 * interactive contact force problems", The Visual Computer 26 (2010) 893-901. */
#include <math.h>
#include <string.h>

#include "physics/impulse/pile.h"
#include "physics/impulse/tolerances.h"

/* What is left over of the last step may be so many times as much: else rounding in one step asks for sweeps in the
 * next. */
#define STILL_SOLVED 10
/* After so many sweeps, and after so many, what is left over may be as many times as much: a blow through a pile is
 * known to first order in the step, and what rests goes on being solved in the next steps. */
#define SWEEPS_NEAR  30
#define NEARLY       1e5
#define SWEEPS_ROUGH 90
#define ROUGHLY      1e7
/* Sweeps of a step: as many as look at so many points, within limits. */
#define POINTS_A_STEP 100000
#define LEAST_SWEEPS  20
#define MOST_SWEEPS   200
/* Of these, how many part what overlaps; and how many solve either of two problems, where something strikes. */
#define PARTING    0.2
#define ONE_OF_TWO 0.5
/* Sweeps before the impulses are solved for at once; and how many times as many before that is tried again. */
#define SWEEPS_FIRST 3
#define MORE_SWEEPS  3

/* One touch: first its normals, then friction within what they allow; answers the largest change of a speed. */
static double sweep_touch(const TinkerPileTouch *touch, TinkerPilePoint *points, TinkerPileBody *a, TinkerPileBody *b)
{
    const double nx = touch->normal[0], ny = touch->normal[1];
    double most = 0;
    for (int32_t k = 0; k < touch->count; k++) {
        TinkerPilePoint *point = &points[k];
        const double u = tinker_pile_row(nx, ny, point->arm, a->v, b->v) - point->least;
        const double wanted = point->normal - point->give_normal * u, normal = wanted > 0 ? wanted : 0;
        const double by = normal - point->normal;
        point->normal = normal;
        tinker_pile_push(a, b, touch, point, by, 0);
        most = MAX(most, fabs(by) * point->take_normal);
    }
    for (int32_t k = 0; k < touch->count; k++) {
        TinkerPilePoint *point = &points[k];
        const double limit = point->friction * point->normal;
        const double u = tinker_pile_row(ny, -nx, point->slide, a->v, b->v);
        const double wanted = point->sliding - point->give_slide * u, sliding = CLAMP(wanted, -limit, limit);
        const double by = sliding - point->sliding;
        point->sliding = sliding;
        tinker_pile_push(a, b, touch, point, 0, by);
        most = MAX(most, fabs(by) * point->take_slide);
    }
    return most;
}

/* One sweep; answers the largest change of a speed (m/s). Nothing moves a top. */
static double sweep(TinkerPile *pile)
{
    double most = 0;
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        TinkerPileBody a = pile->bodies[touch->body[0]], b = pile->bodies[touch->body[1]];
        const double changed = sweep_touch(touch, pile->points + touch->first, &a, &b);
        most = MAX(most, changed);
        pile->bodies[touch->body[0]] = a;
        pile->bodies[touch->body[1]] = b;
    }
    return most;
}

/* Lets the impulses that are known act on the bodies. */
static void apply_all(TinkerPile *pile)
{
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        TinkerPileBody *a = &pile->bodies[touch->body[0]], *b = &pile->bodies[touch->body[1]];
        for (int32_t k = 0; k < touch->count; k++) {
            const TinkerPilePoint *point = &pile->points[touch->first + k];
            tinker_pile_push(a, b, touch, point, point->normal, point->sliding);
        }
    }
}

static void note_impulses(const TinkerPile *pile)
{
    for (int32_t i = 0; i < pile->point_count; i++) {
        const TinkerPilePoint *point = &pile->points[i];
        pile->along[4 * i + 2] = point->normal;
        pile->along[4 * i + 3] = point->sliding;
    }
}

static void take_noted(TinkerPile *pile)
{
    for (int32_t i = 0; i < pile->point_count; i++) {
        TinkerPilePoint *point = &pile->points[i];
        point->normal = pile->along[4 * i + 2];
        point->sliding = pile->along[4 * i + 3];
    }
}

/* How much a sweep changed (J, twice). */
static double change_of(const TinkerPile *pile)
{
    double sum = 0;
    for (int32_t i = 0; i < pile->point_count; i++) {
        const TinkerPilePoint *point = &pile->points[i];
        const double normal = point->normal - pile->along[4 * i + 2];
        const double sliding = point->sliding - pile->along[4 * i + 3];
        sum += normal * normal * point->take_normal + sliding * sliding * point->take_slide;
    }
    return sum;
}

/* Goes on along the last direction by `share` of it; the new one is that, and what the sweep changed. */
static void go_on(TinkerPile *pile, double share)
{
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        TinkerPileBody *a = &pile->bodies[touch->body[0]], *b = &pile->bodies[touch->body[1]];
        for (int32_t k = 0; k < touch->count; k++) {
            TinkerPilePoint *point = &pile->points[touch->first + k];
            double *along = pile->along + 4 * (gsize)(touch->first + k);
            const double normal = share * along[0], sliding = share * along[1];
            along[0] = normal + point->normal - along[2];
            along[1] = sliding + point->sliding - along[3];
            if (share == 0) continue;
            point->normal += normal;
            point->sliding += sliding;
            tinker_pile_push(a, b, touch, point, normal, sliding);
        }
    }
}

static void make_room(TinkerPile *pile)
{
    const gsize wanted = 4 * (gsize)pile->point_count;
    if (wanted <= pile->along_size) return;
    g_free(pile->along);
    pile->along_size = 2 * wanted;
    pile->along = g_new(double, pile->along_size);
}

static double leeway(gsize sweeps)
{
    if (sweeps == 1) return STILL_SOLVED;
    return sweeps <= SWEEPS_NEAR ? 1 : sweeps <= SWEEPS_ROUGH ? NEARLY : ROUGHLY;
}

/* From impulses that something else has found. */
static void begin_anew(TinkerPile *pile)
{
    memcpy(pile->bodies, pile->without, (gsize)pile->shapes * sizeof(TinkerPileBody));
    apply_all(pile);
    memset(pile->along, 0, 4 * (gsize)pile->point_count * sizeof(double));
}

/* FALSE: not within the sweeps that a step may take. What the first sweep solves need not be followed. */
static gboolean sweep_all(TinkerPile *pile, double enough, double share_of_sweeps)
{
    const gsize points = (gsize)MAX(pile->point_count, 1);
    const gsize all = CLAMP(POINTS_A_STEP / points, LEAST_SWEEPS, MOST_SWEEPS);
    const gsize most = (gsize)(share_of_sweeps * (double)all);
    gsize direct = SWEEPS_FIRST;
    double last = 0;
    make_room(pile);
    apply_all(pile);
    for (gsize count = 1;; count++) {
        if (count > 1) note_impulses(pile);
        if (pile->joints != NULL) tinker_pile_joints_solve(pile);
        const double changed = sweep(pile);
        if (changed <= leeway(count) * enough) return TRUE;
        if (count >= most) {
            pile->left = changed;
            const gboolean solved = tinker_pile_solve_wedged(pile, leeway(count) * enough);
            begin_anew(pile);
            return solved;
        }
        if (count == 1) {
            memset(pile->along, 0, 4 * points * sizeof(double));
            continue;
        }
        if (count == direct && tinker_pile_has_direct(pile)) {
            if (!tinker_pile_solve_directly(pile, enough)) take_noted(pile);
            begin_anew(pile);
            last = 0;
            direct *= MORE_SWEEPS;
            continue;
        }
        /* how much of the last direction is gone on along */
        const double now = change_of(pile), share = last > 0 && now < last ? now / last : 0;
        last = now;
        if (count + 1 < most) go_on(pile, share);
    }
}

/* What is held by constraints has met them before each sweep, and does so behind the last one. */
static gboolean solve(TinkerPile *pile, double enough, double share_of_sweeps)
{
    const gboolean solved = sweep_all(pile, enough, share_of_sweeps);
    if (pile->joints != NULL) tinker_pile_joints_solve(pile);
    return solved;
}

/* What contacts gave (J), for velocities without them and with them; what is beneath a top that moves gets that from
 * what moves it. *most: what was moved to and fro, as an elastic impact takes and gives back. */
static double energy_given(const TinkerPile *pile, double *most)
{
    double sum = 0;
    *most = 0;
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        for (int32_t k = 0; k < touch->count; k++) {
            const TinkerPilePoint *point = &pile->points[touch->first + k];
            const double before[] = {tinker_pile_speed(pile->without, touch, point),
                                     tinker_pile_slide(pile->without, touch, point)};
            const double behind[] = {tinker_pile_speed(pile->bodies, touch, point),
                                     tinker_pile_slide(pile->bodies, touch, point)};
            const double impulse[] = {point->normal, point->sliding};
            for (int axis = 0; axis < 2; axis++) {
                sum += 0.5 * impulse[axis] * (before[axis] + behind[axis]);
                *most += 0.5 * fabs(impulse[axis]) * (fabs(before[axis]) + fabs(behind[axis]));
            }
        }
    }
    return sum;
}

/* What strikes goes on by Newton's law, or by less than it asks for where friction would turn that into energy. */
static void solve_impacts(TinkerPile *pile)
{
    static const double shares[] = {1, 0.75, 0.5, 0.25, 0};
    const double unsolved = pile->unsolved;
    double fastest = pile->scale;
    for (gsize trial = 0; trial < G_N_ELEMENTS(shares); trial++) {
        double most;
        for (int32_t i = 0; i < pile->point_count; i++) {
            if (!pile->marks[i].strikes) continue;
            pile->points[i].least = shares[trial] * pile->marks[i].rebound;
            fastest = MAX(fastest, pile->marks[i].rebound);
        }
        memcpy(pile->bodies, pile->without, (gsize)pile->shapes * sizeof(TinkerPileBody));
        const gboolean solved = solve(pile, TINKER_PILE_SOLVED * fastest, ONE_OF_TWO);
        pile->unsolved = fmax(unsolved, solved ? 0 : pile->left);
        if (energy_given(pile, &most) <= (solved ? TINKER_PILE_NO_MORE : TINKER_PILE_NEARLY_NO_MORE) * most) break;
    }
}

void tinker_pile_solve(TinkerPile *pile)
{
    const gsize bytes = (gsize)pile->shapes * sizeof(TinkerPileBody);
    if (pile->joints != NULL && pile->strikes) tinker_pile_joints_strike(pile);
    memcpy(pile->without, pile->bodies, bytes);
    pile->largest = MAX(pile->largest, pile->scale);
    const gboolean solved = solve(pile, TINKER_PILE_SOLVED * pile->scale, pile->strikes ? ONE_OF_TWO : 1);
    pile->unsolved = solved ? 0 : pile->left;
    memcpy(pile->moves, pile->bodies, bytes);
    if (pile->strikes) solve_impacts(pile);
}

gboolean tinker_pile_part(TinkerPile *pile, double h)
{
    if (!pile->overlaps) return FALSE;
    double deepest = 0;
    for (int32_t i = 0; i < pile->shapes; i++)
        memset(pile->bodies[i].v, 0, sizeof(pile->bodies[0].v));
    if (pile->joints != NULL) tinker_pile_joints_hold(pile);
    memcpy(pile->without, pile->bodies, (gsize)pile->shapes * sizeof(TinkerPileBody));
    for (int32_t i = 0; i < pile->point_count; i++) {
        TinkerPilePoint *point = &pile->points[i];
        point->normal = point->sliding = point->friction = 0;
        point->least = -pile->marks[i].gap / h;
        deepest = MAX(deepest, point->least);
    }
    solve(pile, TINKER_PILE_SOLVED * deepest, PARTING);
    return TRUE;
}
