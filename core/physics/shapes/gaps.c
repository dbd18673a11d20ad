/* Gap functions of pairs of convex shapes, and their derivatives. With k x (x, y) = (-y, x), arms a of the tip and c of
 * the seat from the places of their frames, D = P - C, and rates w of the frames:
 *
 *     edge:   gap'' = n . (P'' - C'') + 2 w_seat (k x n) . D' + (angle_seat'' (k x n) - w_seat^2 n) . D
 *             u = t . D' + r w_tip + gap w_seat           = (along + r (angle_tip - angle_seat))'
 *     round:  gap'' = n . (P'' - C'') + (t . D')^2 / |D|
 *             u = t . D' + r w_tip + s w_seat
 *
 * since the material of the tip at the contact is at P - r n, and k x n = -t. tests/physics/test-shapes-derivatives.c
 * has differences for all of it. */
#include "physics/shapes/gaps.h"

#include <math.h>

#include "physics/shapes/tolerances.h"

static double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* k x a */
static void across(const double a[2], double out[2])
{
    const double x = a[0];
    out[0] = -a[1];
    out[1] = x;
}

/* As its frame is turned. */
static void turn(const TinkerBodyPose *by, const double a[2], double out[2])
{
    const double x = a[0], y = a[1];
    out[0] = by->cosine * x - by->sine * y;
    out[1] = by->sine * x + by->cosine * y;
}

/* What the functions of a pair consist of -------------------------------------------------------------------------- */

typedef struct {
    TinkerGapFunction *list;
    int32_t count, room;
} List;

static void add(List *list, const TinkerGapFunction *function)
{
    if (list->count < list->room) list->list[list->count++] = *function;
}

static void set(double out[2], const double from[2])
{
    out[0] = from[0];
    out[1] = from[1];
}

/* The outward normal of the edge that begins at a corner. */
static void edge_normal(const TinkerOutline *outline, int32_t number, double normal[2])
{
    const double *a = outline->corners + 2 * number, *b = outline->corners + 2 * ((number + 1) % outline->count);
    const double length = hypot(b[0] - a[0], b[1] - a[1]), along[2] = {b[0] - a[0], b[1] - a[1]};
    normal[0] = along[1] / length;
    normal[1] = -along[0] / length;
    if (outline->kind != TINKER_OUTLINE_TOP) return;
    normal[0] = -normal[0];
    normal[1] = -normal[1];
}

static int32_t edges_of(const TinkerOutline *outline)
{
    if (outline->kind == TINKER_OUTLINE_DISC || outline->count < 2) return 0;
    return outline->kind == TINKER_OUTLINE_TOP ? 1 : outline->count;
}

/* Whether a corner turns inwards. */
static gboolean is_inner(const TinkerOutline *outline, int32_t number)
{
    double before[2], after[2];
    if (outline->triangles == NULL) return FALSE;
    edge_normal(outline, (number + outline->count - 1) % outline->count, before);
    edge_normal(outline, number, after);
    return before[0] * after[1] - before[1] * after[0] < 0;
}

static void seat_edge(TinkerGapFunction *function, const TinkerOutline *outline, int32_t number)
{
    const double *a = outline->corners + 2 * number, *b = outline->corners + 2 * ((number + 1) % outline->count);
    function->round = FALSE;
    edge_normal(outline, number, function->normal);
    function->seat[0] = 0.5 * (a[0] + b[0]);
    function->seat[1] = 0.5 * (a[1] + b[1]);
    function->half_width = 0.5 * hypot(b[0] - a[0], b[1] - a[1]);
    for (int k = 0; k < 2; k++) {
        const double part = 0.5 * TINKER_INTO_CORNER, *end = k == 0 ? a : b, *other = k == 0 ? b : a;
        if (!is_inner(outline, (number + k) % outline->count)) continue;
        function->seat[0] += part * (end[0] - other[0]);
        function->seat[1] += part * (end[1] - other[1]);
        function->half_width *= 1 + TINKER_INTO_CORNER;
    }
}

static void take_sides(TinkerGapFunction *function, const TinkerOutline *outline, int32_t number)
{
    const double *at = outline->corners + 2 * number;
    for (int k = 0; k < 2; k++) {
        const int32_t next = (number + (k == 0 ? 1 : outline->count - 1)) % outline->count;
        const double x = outline->corners[2 * next] - at[0], y = outline->corners[2 * next + 1] - at[1];
        function->sides[k][0] = x / hypot(x, y);
        function->sides[k][1] = y / hypot(x, y);
    }
}

/* Corners and centres of `tips` over edges of `seats`. */
static void add_edges(List *list, const TinkerOutline *tips, const TinkerOutline *seats, int32_t tip_of)
{
    const gboolean disc = tips->kind == TINKER_OUTLINE_DISC;
    if (tips->kind == TINKER_OUTLINE_TOP && seats->kind == TINKER_OUTLINE_TOP) return;
    for (int32_t i = 0; i < (disc ? 1 : tips->count); i++) {
        TinkerGapFunction function = {.tip_of = tip_of, .rolls = disc, .tip_radius = disc ? tips->radius : 0};
        if (!disc && is_inner(tips, i)) continue;
        if (!disc) set(function.tip, tips->corners + 2 * i);
        if (!disc && tips->count > 1) take_sides(&function, tips, i);
        if (tips->kind == TINKER_OUTLINE_TOP) edge_normal(tips, 0, function.above);
        for (int32_t k = 0; k < edges_of(seats); k++) {
            seat_edge(&function, seats, k);
            function.reverse = !disc && edges_of(seats) == 2 ? 1 - 2 * k : 0;
            add(list, &function);
        }
    }
}

/* The directions in which a corner is the nearest: between the normals of its edges; of an end of a top between its
 * normal and the way on along it. */
static double corner_directions(const TinkerOutline *outline, int32_t number, double middle[2])
{
    double before[2], after[2];
    if (outline->kind == TINKER_OUTLINE_TOP) {
        edge_normal(outline, 0, before);
        after[0] = number == 0 ? -before[1] : before[1];
        after[1] = number == 0 ? before[0] : -before[0];
    } else {
        edge_normal(outline, (number + outline->count - 1) % outline->count, before);
        edge_normal(outline, number, after);
    }
    const double cosine = fmax(-1, fmin(1, dot(before, after)));
    middle[0] = before[0] + after[0];
    middle[1] = before[1] + after[1];
    double length = hypot(middle[0], middle[1]);
    if (length < 1e-9) { /* the end of a line: half a turn, away from the line */
        across(before, middle);
        length = 1;
    }
    middle[0] /= length;
    middle[1] /= length;
    return 0.5 * acos(cosine);
}

/* A disc, by its centre, over the corners of the other shape, or over another disc. */
static void add_rounds(List *list, const TinkerOutline *disc, const TinkerOutline *other, int32_t tip_of)
{
    TinkerGapFunction function = {.tip_of = tip_of,
                                  .round = TRUE,
                                  .rolls = TRUE,
                                  .tip_radius = disc->radius,
                                  .normal = {1, 0},
                                  .half_width = INFINITY};
    if (other->kind == TINKER_OUTLINE_DISC || other->count == 1) {
        function.seat_radius = other->kind == TINKER_OUTLINE_DISC ? other->radius : 0;
        add(list, &function);
        return;
    }
    for (int32_t i = 0; i < other->count; i++) {
        if (is_inner(other, i)) continue;
        set(function.seat, other->corners + 2 * i);
        function.half_width = disc->radius * corner_directions(other, i, function.normal);
        add(list, &function);
    }
}

int32_t tinker_gap_functions_most(const TinkerOutline *first, const TinkerOutline *second)
{
    const int32_t a = MAX(first->count, 1), b = MAX(second->count, 1);
    return 2 * a * b + a + b;
}

int32_t tinker_gap_functions(const TinkerOutline *first, const TinkerOutline *second, TinkerGapFunction *list,
                             int32_t room)
{
    List all = {list, 0, room};
    const gboolean disc = first->kind == TINKER_OUTLINE_DISC, other_disc = second->kind == TINKER_OUTLINE_DISC;
    add_edges(&all, first, second, 0);
    add_edges(&all, second, first, 1);
    if (disc) add_rounds(&all, first, second, 0);
    if (!disc && other_disc) add_rounds(&all, second, first, 1);
    return all.count;
}

/* Measuring -------------------------------------------------------------------------------------------------------- */

/* A point that is fixed to a frame: its arm and the arm turned by a right angle, its velocity, and what turning alone
 * makes of its acceleration. */
typedef struct {
    double place[2], arm[2], turned[2], velocity[2], bend[2];
} Point;

/* Where a point is that is fixed to a frame. */
static void place_at(const TinkerBodyPose *pose, const double local[2], double arm[2], double place[2])
{
    turn(pose, local, arm);
    place[0] = pose->x + arm[0];
    place[1] = pose->y + arm[1];
}

static Point point_at(const TinkerBodyPose *pose, const double local[2])
{
    Point point = {0};
    place_at(pose, local, point.arm, point.place);
    across(point.arm, point.turned);
    for (int k = 0; k < 2; k++) {
        point.velocity[k] = (k == 0 ? pose->vx : pose->vy) + pose->rate * point.turned[k];
        point.bend[k] = -pose->rate * pose->rate * point.arm[k];
    }
    return point;
}

/* By the normal of the edge, and the way from the seat to the tip. */
static double gap_over_edge(const TinkerGapFunction *function, const double normal[2], const double way[2])
{
    return dot(normal, way) - function->tip_radius;
}

static double gap_of_round(const TinkerGapFunction *function, double far)
{
    return far - (function->tip_radius + function->seat_radius);
}

static void fill_row(double row[6], const double direction[2], double by_tip, double by_seat)
{
    row[0] = direction[0];
    row[1] = direction[1];
    row[2] = by_tip;
    row[3] = -direction[0];
    row[4] = -direction[1];
    row[5] = -by_seat;
}

static double rate_of(const double row[6], const TinkerBodyPose *tip, const TinkerBodyPose *seat)
{
    return row[0] * tip->vx + row[1] * tip->vy + row[2] * tip->rate + row[3] * seat->vx + row[4] * seat->vy +
           row[5] * seat->rate;
}

/* p: the tip. */
static void measure_edge(const TinkerGapFunction *function, const TinkerBodyPose *tip, const TinkerBodyPose *seat,
                         const Point *p, TinkerGap *gap)
{
    const Point c = point_at(seat, function->seat);
    const double d[2] = {p->place[0] - c.place[0], p->place[1] - c.place[1]}, r = function->tip_radius;
    const double moves[2] = {p->velocity[0] - c.velocity[0], p->velocity[1] - c.velocity[1]};
    const double bend[2] = {p->bend[0] - c.bend[0], p->bend[1] - c.bend[1]}, w = seat->rate;
    turn(seat, function->normal, gap->normal);
    const double *n = gap->normal;
    const double t[2] = {n[1], -n[0]};
    gap->gap = gap_over_edge(function, n, d);
    gap->along = dot(t, d);
    gap->rolled = gap->along + r * (tip->angle - seat->angle);
    gap->period = 0;
    fill_row(gap->row[0], n, dot(n, p->turned), dot(n, c.turned) + dot(t, d));
    fill_row(gap->row[1], t, dot(t, p->turned) + r, dot(t, c.turned) - gap->gap);
    gap->normal_speed = rate_of(gap->row[0], tip, seat);
    gap->tangential_speed = rate_of(gap->row[1], tip, seat);
    gap->along_speed = gap->tangential_speed - r * (tip->rate - w);
    gap->drift[0] = dot(n, bend) - 2 * w * dot(t, moves) - w * w * dot(n, d);
    gap->drift[1] = dot(t, bend) + w * dot(n, moves) + w * gap->normal_speed;
}

static void measure_round(const TinkerGapFunction *function, const TinkerBodyPose *tip, const TinkerBodyPose *seat,
                          const Point *p, TinkerGap *gap)
{
    const Point c = point_at(seat, function->seat);
    const double d[2] = {p->place[0] - c.place[0], p->place[1] - c.place[1]}, far = hypot(d[0], d[1]);
    const double moves[2] = {p->velocity[0] - c.velocity[0], p->velocity[1] - c.velocity[1]};
    const double bend[2] = {p->bend[0] - c.bend[0], p->bend[1] - c.bend[1]};
    const double r = function->tip_radius, s = function->seat_radius, reach = r + s;
    gap->normal[0] = far > 0 ? d[0] / far : 0;
    gap->normal[1] = far > 0 ? d[1] / far : 1;
    const double *n = gap->normal;
    const double t[2] = {n[1], -n[0]}, direction = atan2(n[1], n[0]);
    double middle[2];
    turn(seat, function->normal, middle);
    gap->gap = gap_of_round(function, far);
    gap->along = -reach * atan2(middle[0] * n[1] - middle[1] * n[0], dot(middle, n));
    gap->rolled = r * tip->angle + s * seat->angle - reach * direction;
    gap->period = 2 * G_PI * reach;
    fill_row(gap->row[0], n, dot(n, p->turned), dot(n, c.turned));
    fill_row(gap->row[1], t, dot(t, p->turned) + r, dot(t, c.turned) - s);
    gap->normal_speed = rate_of(gap->row[0], tip, seat);
    gap->tangential_speed = rate_of(gap->row[1], tip, seat);
    const double slides = dot(t, moves);
    gap->along_speed = reach * (slides / far + seat->rate);
    gap->drift[0] = dot(n, bend) + slides * slides / far;
    gap->drift[1] = dot(t, bend) - slides * dot(n, moves) / far;
}

void tinker_gap_measure(const TinkerGapFunction *function, const TinkerBodyPose *first, const TinkerBodyPose *second,
                        TinkerGap *gap)
{
    const TinkerBodyPose *tip = function->tip_of == 0 ? first : second, *seat = function->tip_of == 0 ? second : first;
    const Point p = point_at(tip, function->tip);
    if (function->round)
        measure_round(function, tip, seat, &p, gap);
    else
        measure_edge(function, tip, seat, &p, gap);
    for (int k = 0; k < 2; k++)
        gap->point[k] = p.place[k] - (function->tip_radius + function->inset) * gap->normal[k];
}

double tinker_gap_alone(const TinkerGapFunction *function, const TinkerBodyPose *first, const TinkerBodyPose *second)
{
    const TinkerBodyPose *tip = function->tip_of == 0 ? first : second, *seat = function->tip_of == 0 ? second : first;
    double arm[2], p[2], c[2], normal[2];
    place_at(tip, function->tip, arm, p);
    place_at(seat, function->seat, arm, c);
    const double way[2] = {p[0] - c[0], p[1] - c[1]};
    if (function->round) return gap_of_round(function, hypot(way[0], way[1]));
    turn(seat, function->normal, normal);
    return gap_over_edge(function, normal, way);
}

gboolean tinker_gap_is_over(const TinkerGapFunction *function, const TinkerBodyPose *first,
                            const TinkerBodyPose *second, const TinkerGap *gap, double tolerance)
{
    const TinkerBodyPose *tip = function->tip_of == 0 ? first : second;
    (void)second;
    double above[2];
    const double beyond = fabs(gap->along) - function->half_width;
    const gboolean moves_off =
        gap->along * gap->along_speed > 0 && fabs(gap->along_speed) > TINKER_STRAIGHT_DOWN * fabs(gap->normal_speed);
    if (beyond > tolerance || (beyond > -tolerance && moves_off)) return FALSE;
    for (int k = 0; k < 2; k++) {
        double side[2];
        turn(tip, function->sides[k], side);
        if (dot(side, gap->normal) < -TINKER_NOT_INTO) return FALSE;
    }
    if (function->above[0] == 0 && function->above[1] == 0) return TRUE;
    turn(tip, function->above, above);
    return dot(gap->normal, above) < -TINKER_NOT_INTO;
}
