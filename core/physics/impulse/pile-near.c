/* Which shapes may meet soon. Each has a circle around it, as far as its farthest corner, and a margin that it may move
 * by before the pairs are listed anew; what turns stays within its circle. Shapes of about one size lie in a grid of
 * squares as wide as the largest of them, so that those of neighbouring squares alone can meet; what is much larger, or
 * faster, is looked at beside all others, and so are tops. Source: C. Ericson, "Real-Time Collision Detection", Morgan
 * Kaufmann 2005, sec. 7.1. */
#include <math.h>
#include <stdlib.h>

#include "physics/impulse/pile.h"

/* The margin beside what a shape moves by in some steps: a share of its radius, and how many steps. */
#define MARGIN_OF_RADIUS 0.1
#define MARGIN_OF_TRAVEL 3
/* Shapes that reach farther than the middle one by this factor are looked at beside all. */
#define MUCH_LARGER 4

static int by_reach(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return a < b ? -1 : a > b;
}

static int by_cell(const void *left, const void *right)
{
    const TinkerPileCell *a = left, *b = right;
    if (a->row != b->row) return a->row < b->row ? -1 : 1;
    if (a->column != b->column) return a->column < b->column ? -1 : 1;
    return a->shape < b->shape ? -1 : a->shape > b->shape;
}

static int by_pair(const void *left, const void *right)
{
    const TinkerPileNear *a = left, *b = right;
    if (a->first != b->first) return a->first < b->first ? -1 : 1;
    return a->second < b->second ? -1 : a->second > b->second;
}

static TinkerBlockId block_of(const TinkerPile *pile, int32_t shape)
{
    const int32_t bodies = pile->model->bodies;
    return shape < bodies ? pile->model->body_blocks[shape] : pile->contacts->plates[shape - bodies].block;
}

static void add_pair(TinkerPile *pile, int32_t a, int32_t b)
{
    const TinkerPileNear near = {.first = MIN(a, b), .second = MAX(a, b)};
    if (pile->joints != NULL && tinker_contacts_are_joined(pile->joined, block_of(pile, a), block_of(pile, b))) return;
    g_array_append_val(pile->near, near);
}

static double reach_of(const TinkerPile *pile, int32_t shape)
{
    return pile->shape[shape].radius + pile->margin[shape];
}

static gboolean circles_meet(const TinkerPile *pile, int32_t a, int32_t b)
{
    const double *p = pile->shape[a].place, *r = pile->shape[b].place, reach = reach_of(pile, a) + reach_of(pile, b);
    const double x = p[0] - r[0], y = p[1] - r[1];
    return x * x + y * y <= reach * reach;
}

/* Whether a circle comes near the line of a top. */
static gboolean meets_top(const TinkerPile *pile, int32_t body, int32_t top)
{
    const double *a = pile->shape[top].corners, way[2] = {a[2] - a[0], a[3] - a[1]}, *p = pile->shape[body].place;
    const double off[2] = {p[0] - a[0], p[1] - a[1]}, square = way[0] * way[0] + way[1] * way[1];
    const double share = CLAMP((off[0] * way[0] + off[1] * way[1]) / square, 0, 1);
    const double x = off[0] - share * way[0], y = off[1] - share * way[1];
    const double reach = reach_of(pile, body) + pile->margin[top];
    return x * x + y * y <= reach * reach;
}

/* The largest reach of those that lie in the grid. */
static double grid_reach(TinkerPile *pile)
{
    double most = 0;
    for (int32_t i = 0; i < pile->body_count; i++)
        pile->sorted[i] = reach_of(pile, pile->members[i]);
    qsort(pile->sorted, (size_t)pile->body_count, sizeof(double), by_reach);
    const double limit = MUCH_LARGER * pile->sorted[pile->body_count / 2];
    for (int32_t i = 0; i < pile->body_count; i++)
        if (pile->sorted[i] <= limit) most = pile->sorted[i];
    return most;
}

static void fill_grid(TinkerPile *pile, double reach)
{
    g_array_set_size(pile->cells, 0);
    for (int32_t i = 0; i < pile->body_count; i++) {
        const int32_t shape = pile->members[i];
        if (reach_of(pile, shape) > reach) continue;
        const double *at = pile->shape[shape].place, width = 2 * reach;
        const TinkerPileCell cell = {(int64_t)floor(at[1] / width), (int64_t)floor(at[0] / width), shape};
        g_array_append_val(pile->cells, cell);
    }
    qsort(pile->cells->data, pile->cells->len, sizeof(TinkerPileCell), by_cell);
}

/* Each with those behind it in its own square and the next one, and with those of three squares of the next row. */
static void pair_grid(TinkerPile *pile)
{
    const TinkerPileCell *cells = (const TinkerPileCell *)(const void *)pile->cells->data;
    const guint count = pile->cells->len;
    for (guint i = 0, next = 0; i < count; i++) {
        const TinkerPileCell *cell = &cells[i];
        for (guint k = i + 1; k < count && cells[k].row == cell->row && cells[k].column <= cell->column + 1; k++)
            if (circles_meet(pile, cell->shape, cells[k].shape)) add_pair(pile, cell->shape, cells[k].shape);
        const TinkerPileCell above = {cell->row + 1, cell->column - 1, -1};
        while (next < count && by_cell(&cells[next], &above) < 0)
            next++;
        for (guint k = next; k < count && cells[k].row == above.row && cells[k].column <= cell->column + 1; k++)
            if (circles_meet(pile, cell->shape, cells[k].shape)) add_pair(pile, cell->shape, cells[k].shape);
    }
}

static void pair_others(TinkerPile *pile, double reach)
{
    for (int32_t i = 0; i < pile->body_count; i++) {
        const int32_t large = pile->members[i];
        if (!(reach_of(pile, large) > reach)) continue;
        for (int32_t k = 0; k < pile->body_count; k++) {
            const int32_t other = pile->members[k];
            if (other == large || (other < large && reach_of(pile, other) > reach)) continue;
            if (circles_meet(pile, large, other)) add_pair(pile, large, other);
        }
    }
    for (int32_t i = 0; i < pile->body_count; i++)
        for (int32_t k = pile->body_count; k < pile->member_count; k++)
            if (meets_top(pile, pile->members[i], pile->members[k])) add_pair(pile, pile->members[i], pile->members[k]);
}

/* What is known of pairs that were listed before goes on; of others the surface is found. */
static void carry_over(TinkerPile *pile)
{
    const GArray *was = pile->near_was;
    const TinkerContacts *contacts = pile->contacts;
    for (guint i = 0, k = 0; i < pile->near->len; i++) {
        TinkerPileNear *near = &g_array_index(pile->near, TinkerPileNear, i);
        while (k < was->len && by_pair(&g_array_index(was, TinkerPileNear, k), near) < 0)
            k++;
        if (k < was->len && by_pair(&g_array_index(was, TinkerPileNear, k), near) == 0) {
            *near = g_array_index(was, TinkerPileNear, k);
            continue;
        }
        const TinkerSurface *other = near->second < pile->model->bodies
                                         ? &contacts->surfaces[near->second]
                                         : &contacts->plates[near->second - pile->model->bodies].surface;
        near->surface = tinker_surface_between(other, &contacts->surfaces[near->first]);
        near->passes = !pile->started;
    }
}

static gboolean is_listed(const TinkerPile *pile, double h)
{
    if (!pile->started) return FALSE;
    for (int32_t i = 0; i < pile->member_count; i++) {
        const int32_t shape = pile->members[i];
        const double *at = pile->shape[shape].place, *was = pile->listed + 2 * shape, *v = pile->bodies[shape].v;
        const double left = pile->margin[shape] - h * sqrt(v[0] * v[0] + v[1] * v[1]);
        const double x = at[0] - was[0], y = at[1] - was[1];
        if (left < 0 || x * x + y * y > left * left) return FALSE;
    }
    return TRUE;
}

void tinker_pile_list_near(TinkerPile *pile, double h)
{
    if (is_listed(pile, h)) return;
    tinker_pile_direct_forget(pile->direct);
    GArray *was = pile->near;
    pile->near = pile->near_was;
    pile->near_was = was;
    g_array_set_size(pile->near, 0);
    for (int32_t i = 0; i < pile->member_count; i++) {
        const int32_t shape = pile->members[i];
        const double *v = pile->bodies[shape].v, radius = i < pile->body_count ? pile->shape[shape].radius : 0;
        pile->margin[shape] = MARGIN_OF_RADIUS * radius + MARGIN_OF_TRAVEL * h * hypot(v[0], v[1]);
        for (int k = 0; k < 2; k++)
            pile->listed[2 * shape + k] = pile->shape[shape].place[k];
    }
    const double reach = grid_reach(pile);
    fill_grid(pile, reach);
    pair_grid(pile);
    pair_others(pile, reach);
    qsort(pile->near->data, pile->near->len, sizeof(TinkerPileNear), by_pair);
    carry_over(pile);
    tinker_pile_make_room(pile);
}
