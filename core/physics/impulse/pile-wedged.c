/* Contacts that wedge: friction of one holds the load that the friction of another comes from, and sweeps go to and fro
 * between them without an end. Bodies that contacts and constraints join are a group; the impulses of a small one are
 * then solved for by pivots, which the laws of events have, too (numerics/contact), with how each of its points answers
 * to each other as a matrix. */
#include <math.h>
#include <string.h>

#include "numerics/contact/contact-laws.h"
#include "numerics/solve/disjoint-sets.h"
#include "physics/impulse/pile.h"

/* Pivots of more points take longer than all else in a step: they grow with the third power. */
#define MOST_POINTS 64

/* Bodies that are joined, by the first of them. */
typedef struct {
    int32_t touch; /* the first in its list; -1: none */
    int32_t points;
    gboolean wedged; /* a point misses its laws */
} Group;

struct TinkerPileWedged {
    int32_t *parent; /* by shape */
    Group *groups;   /* by shape */
    double *room;
    gsize size;
    /* of the group that is solved for */
    int32_t count;
    const TinkerPileTouch *touches[MOST_POINTS];
    TinkerPilePoint *points[MOST_POINTS];
};

TinkerPileWedged *tinker_pile_wedged_new(const TinkerPile *pile)
{
    TinkerPileWedged *wedged = g_new0(TinkerPileWedged, 1);
    wedged->parent = g_new0(int32_t, (gsize)pile->shapes);
    wedged->groups = g_new0(Group, (gsize)pile->shapes);
    return wedged;
}

void tinker_pile_wedged_free(TinkerPileWedged *wedged)
{
    g_free(wedged->parent);
    g_free(wedged->groups);
    g_free(wedged->room);
    g_free(wedged);
}

/* By how much (m/s) a point's own law would change speeds. */
static double misses(const TinkerPile *pile, const TinkerPileTouch *touch, const TinkerPilePoint *point)
{
    const double u = tinker_pile_speed(pile->bodies, touch, point) - point->least;
    const double slide = tinker_pile_slide(pile->bodies, touch, point), limit = point->friction * point->normal;
    const double normal = fmax(point->normal - point->give_normal * u, 0);
    const double sliding = CLAMP(point->sliding - point->give_slide * slide, -limit, limit);
    return fmax(fabs(normal - point->normal) * point->take_normal, fabs(sliding - point->sliding) * point->take_slide);
}

static void find_groups(TinkerPile *pile, double enough)
{
    const TinkerContacts *contacts = pile->contacts;
    TinkerPileWedged *wedged = pile->wedged;
    tinker_sets_begin(wedged->parent, pile->shapes);
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i];
        if (contacts->held[body]) tinker_sets_join(wedged->parent, body, contacts->group[body]);
    }
    for (int32_t i = 0; i < pile->touch_count; i++)
        if (pile->touches[i].body[1] < pile->model->bodies)
            tinker_sets_join(wedged->parent, pile->touches[i].body[0], pile->touches[i].body[1]);
    for (int32_t i = 0; i < pile->shapes; i++)
        wedged->groups[i] = (Group){.touch = -1};
    for (int32_t i = 0; i < pile->touch_count; i++) {
        TinkerPileTouch *touch = &pile->touches[i];
        Group *group = &wedged->groups[tinker_sets_first(wedged->parent, touch->body[0])];
        touch->next = group->touch;
        group->touch = i;
        group->points += touch->count;
        for (int32_t k = 0; k < touch->count; k++)
            group->wedged |= misses(pile, touch, &pile->points[touch->first + k]) > enough;
    }
}

static void take_group(TinkerPile *pile, const Group *group)
{
    TinkerPileWedged *wedged = pile->wedged;
    wedged->count = 0;
    for (int32_t i = group->touch; i >= 0; i = pile->touches[i].next)
        for (int32_t k = 0; k < pile->touches[i].count; k++) {
            wedged->touches[wedged->count] = &pile->touches[i];
            wedged->points[wedged->count++] = &pile->points[pile->touches[i].first + k];
        }
}

/* What a unit impulse at one point, by turns along its normal and along it, does at all of them, with all that
 * constraints answer; of bodies that stand still. */
static void fill_matrix(TinkerPile *pile, double *delassus)
{
    const TinkerPileWedged *wedged = pile->wedged;
    const int32_t width = 2 * wedged->count;
    for (int32_t column = 0; column < width; column++) {
        const TinkerPileTouch *touch = wedged->touches[column / 2];
        TinkerPileBody *a = &pile->bodies[touch->body[0]], *b = &pile->bodies[touch->body[1]];
        tinker_pile_push(a, b, touch, wedged->points[column / 2], column % 2 == 0, column % 2);
        if (pile->joints != NULL) tinker_pile_joints_answer(pile);
        for (int32_t k = 0; k < wedged->count; k++) {
            double *entry = delassus + (gsize)(2 * k) * (gsize)width + column;
            entry[0] = tinker_pile_speed(pile->bodies, wedged->touches[k], wedged->points[k]);
            entry[width] = tinker_pile_slide(pile->bodies, wedged->touches[k], wedged->points[k]);
        }
        memset(a->v, 0, sizeof(a->v));
        memset(b->v, 0, sizeof(b->v));
        for (int32_t i = 0; pile->joints != NULL && i < pile->solved_count; i++)
            memset(pile->bodies[pile->solved[i]].v, 0, sizeof(a->v));
    }
}

/* FALSE: no impulses satisfy the laws. */
static gboolean solve_group(TinkerPile *pile)
{
    TinkerPileWedged *wedged = pile->wedged;
    const gsize m = (gsize)wedged->count, wanted = 4 * m * m + 6 * m + tinker_impact_pivot_room(wedged->count);
    if (wanted > wedged->size) {
        g_free(wedged->room);
        wedged->size = wanted;
        wedged->room = g_new(double, wanted);
    }
    double *delassus = wedged->room, *velocity = delassus + 4 * m * m, *least = velocity + 2 * m;
    double *friction = least + m, *impulses = friction + m, *room = impulses + 2 * m;
    for (gsize k = 0; k < m; k++) {
        const TinkerPilePoint *point = wedged->points[k];
        velocity[2 * k] = tinker_pile_speed(pile->without, wedged->touches[k], point);
        velocity[2 * k + 1] = tinker_pile_slide(pile->without, wedged->touches[k], point);
        least[k] = point->least;
        friction[k] = point->friction;
    }
    fill_matrix(pile, delassus);
    const TinkerImpact impact = {
        .count = wedged->count, .delassus = delassus, .velocity = velocity, .friction = friction, .least = least};
    gboolean solved = tinker_impact_pivot(&impact, room, impulses);
    if (!solved) {
        /* where friction wedges, no impulses make it rebound as restitution asks for: it comes to rest */
        for (gsize k = 0; k < m; k++)
            least[k] = fmin(least[k], 0);
        solved = tinker_impact_pivot(&impact, room, impulses);
    }
    if (!solved) return FALSE;
    for (gsize k = 0; k < m; k++) {
        wedged->points[k]->normal = impulses[2 * k];
        wedged->points[k]->sliding = impulses[2 * k + 1];
    }
    return TRUE;
}

gboolean tinker_pile_solve_wedged(TinkerPile *pile, double enough)
{
    gboolean all = TRUE;
    find_groups(pile, enough);
    for (int32_t i = 0; i < pile->shapes; i++)
        memset(pile->bodies[i].v, 0, sizeof(pile->bodies[i].v));
    for (int32_t i = 0; i < pile->shapes; i++) {
        const Group *group = &pile->wedged->groups[i];
        if (!group->wedged) continue;
        all &= group->points <= MOST_POINTS;
        if (group->points > MOST_POINTS) continue;
        take_group(pile, group);
        all &= solve_group(pile);
    }
    return all;
}
