/* Where shapes touch within a step, and what that asks of their velocities. */
#include <math.h>

#include "physics/impulse/pile.h"
#include "physics/impulse/tolerances.h"

/* Of the radius: points so far apart are looked at whatever their speed, for what else pushes them together. */
#define SLACK 0.01

static double radius_of(const TinkerPile *pile, int32_t shape)
{
    return shape < pile->model->bodies ? pile->shape[shape].radius : 0;
}

/* How far (m) any point of a shape may go in the step. */
static double travel_of(const TinkerPile *pile, int32_t shape, double h)
{
    const double *v = pile->bodies[shape].v;
    const double turns = fabs(v[2]) * pile->by_gyration[shape] * pile->shape[shape].radius;
    return h * (sqrt(v[0] * v[0] + v[1] * v[1]) + turns);
}

/* A mass that keeps its angle lies on a top as other masses do: its centre half its height above it. */
static void stand_off(const TinkerPile *pile, const TinkerPileNear *near, double reach, TinkerManifold *manifold)
{
    const TinkerPlacedShape *body = &pile->shape[near->first], *top = &pile->shape[near->second];
    const double *n = top->normals, *base = top->corners, way[2] = {base[2] - base[0], base[3] - base[1]};
    const double off[2] = {body->place[0] - base[0], body->place[1] - base[1]};
    const double along = n[1] * off[0] - n[0] * off[1], length = n[1] * way[0] - n[0] * way[1];
    const double stands = pile->contacts->half_height[near->first], gap = n[0] * off[0] + n[1] * off[1] - stands;
    *manifold = (TinkerManifold){.normal = {n[0], n[1]}, .separation = gap, .beside = along < 0 || along > length};
    if (manifold->beside || gap > reach) return;
    manifold->count = 1;
    manifold->points[0] =
        (TinkerManifoldPoint){gap, {body->place[0] - stands * n[0], body->place[1] - stands * n[1]}, 0};
}

static gboolean is_thin(const TinkerPlacedShape *shape)
{
    return shape->kind == TINKER_OUTLINE_POLYGON && shape->count <= 2;
}

/* Bodies that overlap since the start. */
static gboolean still_passes(const TinkerPile *pile, const TinkerPileNear *near, const TinkerManifold *manifold)
{
    return near->passes && near->second < pile->model->bodies && -manifold->separation > TINKER_TOUCHING;
}

/* A point on a line, or a line on another, is on neither side of it but for rounding: it stays on the side where it
 * was, until it is past an end. What passes has no side yet: it may come free on any. */
static void keep_side(const TinkerPile *pile, TinkerPileNear *near, TinkerManifold *manifold)
{
    if (!is_thin(&pile->shape[near->first]) || !is_thin(&pile->shape[near->second])) return;
    double *n = manifold->normal, *was = near->side;
    if (still_passes(pile, near, manifold)) {
        was[0] = was[1] = 0;
        return;
    }
    const gboolean over = manifold->count > 0, turned = n[0] * was[0] + n[1] * was[1] < 0;
    if (over && turned) manifold->separation = -manifold->separation;
    for (int k = 0; over && turned && k < 2; k++)
        n[k] = -n[k];
    for (int32_t k = 0; over && turned && k < manifold->count; k++)
        manifold->points[k].gap = -manifold->points[k].gap;
    for (int k = 0; k < 2; k++)
        was[k] = over ? n[k] : 0;
}

/* Whether a pair goes through one another now. A body meets a top when it comes from above: not past an end, from
 * below, or from within. */
static gboolean goes_through(const TinkerPile *pile, TinkerPileNear *near, const TinkerManifold *manifold, double h)
{
    const double depth = -manifold->separation;
    if (near->second < pile->model->bodies) {
        near->passes = still_passes(pile, near, manifold);
        return near->passes;
    }
    const double *v = pile->bodies[near->first].v, *w = pile->bodies[near->second].v, *n = manifold->normal;
    const double falls = h * ((w[0] - v[0]) * n[0] + (w[1] - v[1]) * n[1]);
    const double even =
        pile->started ? fmax(TINKER_PILE_EVEN * radius_of(pile, near->first), 2 * falls) : TINKER_TOUCHING;
    if (manifold->beside)
        near->above = FALSE;
    else if (depth <= even)
        near->above = TRUE;
    return !near->above;
}

static void fill_rows(const TinkerPile *pile, const TinkerPileTouch *touch, const double at[2], TinkerPilePoint *point)
{
    double normal = 0, slide = 0;
    for (int k = 0; k < 2; k++) {
        const int32_t shape = touch->body[k];
        const double *place = pile->shape[shape].place, *n = touch->normal, by_gyration = pile->by_gyration[shape];
        const double x = at[0] - place[0], y = at[1] - place[1], w = pile->bodies[shape].inverse_mass;
        point->arm[k] = by_gyration * (x * n[1] - y * n[0]);
        point->slide[k] = -by_gyration * (x * n[0] + y * n[1]);
        normal += w * (1 + point->arm[k] * point->arm[k]);
        slide += w * (1 + point->slide[k] * point->slide[k]);
    }
    point->take_normal = normal;
    point->take_slide = slide;
    point->give_normal = 1 / normal;
    point->give_slide = 1 / slide;
}

/* The normal acceleration (m/s^2) of both, however they go along with each other. */
static double pull_of_both(const TinkerPile *pile, const TinkerPileTouch *touch)
{
    double sum = 0;
    for (int k = 0; k < 2; k++) {
        const double *pull = pile->pull + 3 * touch->body[k];
        sum += fabs(touch->normal[0] * pull[0] + touch->normal[1] * pull[1]);
    }
    return sum;
}

/* Whether it strikes, and how it rebounds. What presses already, what forces make of it in a step, and rounding are no
 * blows. */
static void look_for_blow(TinkerPile *pile, const TinkerPileTouch *touch, const TinkerPilePoint *point,
                          TinkerPileMark *mark, double after, double h)
{
    const gsize first = 3 * (gsize)touch->body[0], second = 3 * (gsize)touch->body[1];
    const double *n = touch->normal;
    const double before = tinker_pile_row(n[0], n[1], point->arm, pile->before + first, pile->before + second);
    const double pull = tinker_pile_row(n[0], n[1], point->arm, pile->pull + first, pile->pull + second);
    const double share = mark->gap > 0 ? mark->gap / (-h * after) : 0, arrives = -(before + share * h * pull);
    mark->strikes =
        arrives > fmax(h * fabs(pull), fmax(TINKER_PILE_NO_BLOW * h * pull_of_both(pile, touch), pile->slow));
    if (!mark->strikes) return;
    pile->strikes = TRUE;
    mark->rebound = g_array_index(pile->near, TinkerPileNear, touch->near).surface.restitution * arrives;
}

/* What it asks of the normal velocity: see pile.h. */
static void ask(TinkerPile *pile, const TinkerPileTouch *touch, TinkerPilePoint *point, TinkerPileMark *mark,
                const TinkerPileKept *kept, double h)
{
    const double after = tinker_pile_speed(pile->bodies, touch, point);
    point->least = mark->gap > TINKER_PILE_CLOSED * radius_of(pile, touch->body[0]) ? -mark->gap / h : 0;
    pile->overlaps |= mark->gap < -TINKER_TOUCHING;
    const double misses = point->least - after;
    if (misses > pile->scale) pile->scale = misses;
    const gboolean presses = kept != NULL && kept->normal > 0;
    if (!presses && mark->gap + h * after < 0) look_for_blow(pile, touch, point, mark, after, h);
}

static const TinkerPileKept *kept_of(const TinkerPileNear *near, const TinkerManifold *manifold, int32_t number)
{
    for (int32_t k = 0; k < near->count; k++)
        if (near->kept[k].corner == manifold->points[number].corner) return &near->kept[k];
    return near->count == manifold->count ? &near->kept[number] : NULL;
}

static void add_touch(TinkerPile *pile, guint number, const TinkerManifold *manifold, double h)
{
    const TinkerPileNear *near = &g_array_index(pile->near, TinkerPileNear, number);
    TinkerPileTouch *touch = &pile->touches[pile->touch_count++];
    *touch = (TinkerPileTouch){.body = {near->first, near->second},
                               .normal = {manifold->normal[0], manifold->normal[1]},
                               .first = pile->point_count,
                               .count = manifold->count,
                               .near = (int32_t)number};
    for (int32_t k = 0; k < manifold->count; k++) {
        const TinkerManifoldPoint *at = &manifold->points[k];
        const TinkerPileKept *kept = kept_of(near, manifold, k);
        const gboolean stuck = kept != NULL && kept->stuck;
        TinkerPileMark *mark = &pile->marks[pile->point_count];
        TinkerPilePoint *point = &pile->points[pile->point_count++];
        *mark = (TinkerPileMark){.gap = at->gap, .at = {at->at[0], at->at[1]}, .corner = at->corner};
        point->friction = stuck ? near->surface.static_friction : near->surface.dynamic_friction;
        point->normal = kept != NULL ? h * kept->normal : 0;
        point->sliding = kept != NULL ? h * kept->sliding : 0;
        fill_rows(pile, touch, mark->at, point);
        ask(pile, touch, point, mark, kept, h);
    }
}

/* At the start what does not move along sticks. */
static void start_stuck(TinkerPile *pile, TinkerPileNear *near, const TinkerManifold *manifold)
{
    const TinkerPileTouch touch = {.body = {near->first, near->second},
                                   .normal = {manifold->normal[0], manifold->normal[1]}};
    near->count = manifold->count;
    for (int32_t k = 0; k < manifold->count; k++) {
        TinkerPilePoint point = {0};
        fill_rows(pile, &touch, manifold->points[k].at, &point);
        const double slides = tinker_pile_row(touch.normal[1], -touch.normal[0], point.slide,
                                              pile->before + 3 * near->first, pile->before + 3 * near->second);
        near->kept[k] = (TinkerPileKept){.corner = manifold->points[k].corner, .stuck = fabs(slides) <= pile->slow};
    }
}

void tinker_pile_make_room(TinkerPile *pile)
{
    if (pile->near->len <= pile->near_room) return;
    pile->near_room = 2 * pile->near->len;
    pile->touches = g_renew(TinkerPileTouch, pile->touches, pile->near_room);
    pile->points = g_renew(TinkerPilePoint, pile->points, 2 * pile->near_room);
    pile->marks = g_renew(TinkerPileMark, pile->marks, 2 * pile->near_room);
}

void tinker_pile_find_touches(TinkerPile *pile, double h)
{
    pile->touch_count = pile->point_count = 0;
    pile->strikes = pile->overlaps = FALSE;
    pile->scale = 0;
    for (guint i = 0; i < pile->near->len; i++) {
        TinkerPileNear *near = &g_array_index(pile->near, TinkerPileNear, i);
        const double travel = travel_of(pile, near->first, h) + travel_of(pile, near->second, h);
        const double reach = travel + SLACK * radius_of(pile, near->first);
        TinkerManifold manifold;
        if (near->second >= pile->model->bodies && pile->by_gyration[near->first] == 0)
            stand_off(pile, near, reach, &manifold);
        else
            tinker_manifold_find(&pile->shape[near->first], &pile->shape[near->second], reach, &manifold);
        keep_side(pile, near, &manifold);
        if (goes_through(pile, near, &manifold, h) || manifold.count == 0) {
            near->count = 0;
            continue;
        }
        if (!pile->started) start_stuck(pile, near, &manifold);
        add_touch(pile, i, &manifold, h);
    }
}
