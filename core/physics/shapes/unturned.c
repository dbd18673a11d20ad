/* Merging the edges of both by their directions, as Minkowski sums of convex polygons are made. Source: M. de Berg, O.
 * Cheong, M. van Kreveld, M. Overmars, "Computational Geometry", 3rd ed., Springer 2008, sec. 13.3. */
#include "physics/shapes/unturned.h"

#include <math.h>
#include <string.h>

#include "physics/shapes/tolerances.h"

#define MOST_OF_ONE 4

typedef struct {
    int32_t count;
    double corners[2 * MOST_OF_ONE];
} Turned;

/* Turned, the corner that is lowest (of two the left one) first. `sign` -1: through the centre. */
static void turn_outline(const TinkerOutline *outline, double angle, double sign, Turned *turned)
{
    const double c = sign * cos(angle), s = sign * sin(angle);
    double all[2 * MOST_OF_ONE];
    int32_t lowest = 0;
    g_assert(outline->kind == TINKER_OUTLINE_POLYGON && outline->count <= MOST_OF_ONE);
    turned->count = outline->count;
    for (int32_t i = 0; i < outline->count; i++) {
        const double *at = outline->corners + 2 * i;
        all[2 * i] = c * at[0] - s * at[1];
        all[2 * i + 1] = s * at[0] + c * at[1];
        const double *best = all + 2 * lowest;
        if (all[2 * i + 1] < best[1] || (all[2 * i + 1] == best[1] && all[2 * i] < best[0])) lowest = i;
    }
    for (int32_t i = 0; i < outline->count; i++)
        memcpy(turned->corners + 2 * i, all + 2 * ((lowest + i) % outline->count), 2 * sizeof(double));
}

/* The edge that begins at a corner; FALSE: there are no more. */
static gboolean edge_of(const Turned *turned, int32_t number, double edge[2])
{
    if (turned->count < 2 || number >= turned->count) return FALSE;
    const double *from = turned->corners + 2 * number, *to = turned->corners + 2 * ((number + 1) % turned->count);
    edge[0] = to[0] - from[0];
    edge[1] = to[1] - from[1];
    return TRUE;
}

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* Whether the first comes before the second counter-clockwise from +x; 0: they are parallel. */
static int compare_edges(const double a[2], const double b[2])
{
    const gboolean up_a = a[1] > 0 || (a[1] == 0 && a[0] > 0), up_b = b[1] > 0 || (b[1] == 0 && b[0] > 0);
    const double sine = cross(a, b) / (hypot(a[0], a[1]) * hypot(b[0], b[1]));
    const gboolean same_way = a[0] * b[0] + a[1] * b[1] > 0;
    if (same_way && fabs(sine) <= TINKER_PARALLEL) return 0;
    if (up_a != up_b) return up_a ? -1 : 1;
    return sine > 0 ? -1 : 1;
}

void tinker_unturned_init(TinkerUnturned *both, const TinkerOutline *first, double first_angle,
                          const TinkerOutline *second, double second_angle)
{
    static const double centre[2] = {0, 0};
    Turned a, b;
    turn_outline(first, first_angle, -1, &a);
    turn_outline(second, second_angle, 1, &b);
    double at[2] = {a.corners[0] + b.corners[0], a.corners[1] + b.corners[1]}, of_a[2], of_b[2], radius = 0;
    int32_t i = 0, k = 0, count = 0;
    for (;;) {
        const gboolean more_a = edge_of(&a, i, of_a), more_b = edge_of(&b, k, of_b);
        memcpy(both->corners + 2 * count++, at, sizeof(at));
        radius = fmax(radius, hypot(at[0], at[1]));
        if (!more_a && !more_b) break;
        const int order = !more_b ? -1 : !more_a ? 1 : compare_edges(of_a, of_b);
        for (int d = 0; d < 2; d++)
            at[d] += (order <= 0 ? of_a[d] : 0) + (order >= 0 ? of_b[d] : 0);
        i += order <= 0;
        k += order >= 0;
        const gboolean closed = i >= (a.count > 1 ? a.count : 0) && k >= (b.count > 1 ? b.count : 0);
        if (closed) break;
    }
    both->point = (TinkerOutline){TINKER_OUTLINE_POLYGON, 0, 1, centre};
    both->around = (TinkerOutline){TINKER_OUTLINE_POLYGON, radius, count, both->corners};
}

/* How far a shape reaches from its centre along a direction. */
static double reach_along(const TinkerOutline *outline, double angle, const double direction[2])
{
    const double c = cos(angle), s = sin(angle);
    double most = -INFINITY;
    for (int32_t i = 0; i < outline->count; i++) {
        const double *at = outline->corners + 2 * i;
        most = fmax(most, direction[0] * (c * at[0] - s * at[1]) + direction[1] * (s * at[0] + c * at[1]));
    }
    return most;
}

/* The point over the end of a line, or over another point, on the one line along `normal`. */
static void take_end(TinkerGapFunction *function, const double at[2], const double normal[2])
{
    *function =
        (TinkerGapFunction){.seat = {at[0], at[1]}, .normal = {normal[0], normal[1]}, .half_width = TINKER_ON_THE_LINE};
}

static int32_t add_ends(const TinkerUnturned *both, const double way[2], TinkerGapFunction *list)
{
    const double *from = both->corners, *to = both->corners + 2 * (both->around.count - 1);
    const double along[2] = {both->around.count > 1 ? to[0] - from[0] : -way[0],
                             both->around.count > 1 ? to[1] - from[1] : -way[1]};
    const double length = hypot(along[0], along[1]);
    if (both->around.count > 2 || !(length > 0)) return 0;
    const double normal[2] = {along[0] / length, along[1] / length}, back[2] = {-normal[0], -normal[1]};
    take_end(&list[0], from, back);
    if (both->around.count < 2) return 1;
    take_end(&list[1], to, normal);
    return 2;
}

int32_t tinker_unturned_functions(const TinkerUnturned *both, const TinkerOutline *first, double first_angle,
                                  const double way[2], TinkerGapFunction *list, int32_t room)
{
    const int32_t ends = both->around.count > 2 ? 0 : 2; /* at most */
    int32_t count = tinker_gap_functions(&both->point, &both->around, list, room - ends);
    count += add_ends(both, way, list + count);
    for (int32_t i = 0; i < count; i++) {
        const double back[2] = {-list[i].normal[0], -list[i].normal[1]};
        list[i].inset = reach_along(first, first_angle, back);
    }
    return count;
}
