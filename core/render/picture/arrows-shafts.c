/* How long arrows are, and where they lie: cut to what is visible, and side by side where one would lie on another. */
#include "render/picture/arrows-diagram-private.h"

#include <float.h>
#include <math.h>

#define SHARE_OF_VIEW 0.1
#define KEEPS         3.0 /* the factor by which a scale may be off before it changes */

/* Canvas units. */
#define LEAST_LENGTH 3.0
#define BESIDE       8.0 /* between arrows that would lie on each other */

#define SLANT 0.12 /* sine of the angle between arrows that lie along each other */

static double strength_of(const TinkerForceArrow *arrow)
{
    double strength = hypot(arrow->fx, arrow->fy);
    return isfinite(strength) ? strength : 0;
}

/* The nearest of 1, 2, 5 times a power of ten, by ratio. */
static double round_number(double wanted)
{
    static const double mantissas[] = {1, 2, 5, 10};
    double decade = pow(10, floor(log10(wanted))), best = decade;
    for (gsize i = 1; i < G_N_ELEMENTS(mantissas); i++)
        if (fabs(log(mantissas[i] * decade / wanted)) < fabs(log(best / wanted))) best = mantissas[i] * decade;
    return best;
}

double tinker_arrows_scale(const TinkerForceArrow *arrows, gsize count, const TinkerView *view, double previous)
{
    double most = 0, wanted = SHARE_OF_VIEW * fmax(view->width, view->height) / view->scale;
    gboolean has_previous = previous > 0 && isfinite(previous);
    for (gsize i = 0; i < count; i++)
        most = fmax(most, strength_of(&arrows[i]));
    if (most > 0) wanted /= most;
    if (!(wanted > DBL_MIN) || !isfinite(wanted)) return has_previous ? previous : 1;
    if (has_previous && (most == 0 || fabs(log(previous / wanted)) <= log(KEEPS))) return previous;
    return round_number(wanted);
}

/* Whether two arrows lie on one line and over each other, whichever way they point. */
static gboolean lie_together(const ArrowShaft *a, const ArrowShaft *b, double beside)
{
    const double ax = a->x2 - a->x1, ay = a->y2 - a->y1, bx = b->x2 - b->x1, by = b->y2 - b->y1;
    const double length = hypot(ax, ay), ux = ax / length, uy = ay / length, x = b->x1 - a->x1, y = b->y1 - a->y1;
    if (fabs(ux * y - uy * x) > 0.9 * beside || fabs(ux * by - uy * bx) > SLANT * hypot(bx, by)) return FALSE;
    const double from = ux * x + uy * y, to = from + ux * bx + uy * by;
    return fmax(from, to) > 1e-6 * length && fmin(from, to) < length * (1 - 1e-6);
}

static gboolean is_alone(const ArrowDiagram *diagram, const ArrowShaft *shaft, double beside)
{
    for (guint i = 0; i < diagram->shafts->len && i < ARROWS_MOST_LABELS; i++)
        if (lie_together(&g_array_index(diagram->shafts, ArrowShaft, i), shaft, beside)) return FALSE;
    return TRUE;
}

/* To one side, to the other, farther to the first; where there is no room it stays. */
static void move_beside(const ArrowDiagram *diagram, ArrowShaft *shaft)
{
    static const int steps[] = {0, 1, -1, 2, -2, 3, -3, 4, -4};
    const double dx = shaft->x2 - shaft->x1, dy = shaft->y2 - shaft->y1, length = hypot(dx, dy);
    const double beside = BESIDE / diagram->view->scale;
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        const double off = steps[i] * beside / length;
        ArrowShaft moved = *shaft;
        moved.x1 += off * dy;
        moved.x2 += off * dy;
        moved.y1 -= off * dx;
        moved.y2 -= off * dx;
        if (!is_alone(diagram, &moved, beside)) continue;
        *shaft = moved;
        return;
    }
}

static int stronger_first(const void *left, const void *right)
{
    const TinkerForceArrow *l = *(const TinkerForceArrow *const *)left, *r = *(const TinkerForceArrow *const *)right;
    double by = strength_of(r) - strength_of(l);
    if (by != 0) return by > 0 ? 1 : -1;
    return l < r ? -1 : l > r;
}

/* Cut to what is visible and a little more, where a head does not show. */
static gboolean clip(const ArrowDiagram *diagram, ArrowShaft *shaft)
{
    const double line[4] = {shaft->x1, shaft->y1, shaft->x2, shaft->y2};
    double from, to, length = hypot(line[2] - line[0], line[3] - line[1]);
    TinkerStyle headless = diagram->brush.style;
    headless.symbol_size = 0;
    if (!tinker_style_finite(line, 4) || !(length * diagram->view->scale >= LEAST_LENGTH) || !isfinite(length) ||
        !tinker_style_clip(&headless, line, &from, &to) || !tinker_style_clip(&diagram->brush.style, line, &from, &to))
        return FALSE;
    double ux = (line[2] - line[0]) / length, uy = (line[3] - line[1]) / length;
    shaft->x1 = line[0] + from * ux;
    shaft->y1 = line[1] + from * uy;
    shaft->x2 = line[0] + to * ux;
    shaft->y2 = line[1] + to * uy;
    return TRUE;
}

void arrows_find_shafts(ArrowDiagram *diagram, const TinkerForceArrow *arrows, gsize count)
{
    g_autoptr(GPtrArray) sorted = g_ptr_array_sized_new((guint)count);
    for (gsize i = 0; i < count; i++)
        if (strength_of(&arrows[i]) > 0) g_ptr_array_add(sorted, (gpointer)&arrows[i]);
    g_ptr_array_sort(sorted, stronger_first);
    diagram->shafts = g_array_sized_new(FALSE, FALSE, sizeof(ArrowShaft), sorted->len);
    for (guint i = 0; i < sorted->len; i++) {
        const TinkerForceArrow *arrow = g_ptr_array_index(sorted, i);
        double scale = diagram->options->scale;
        const double x = scale * arrow->fx, y = scale * arrow->fy, back = arrow->look & TINKER_ARROW_PUSHES ? 1 : 0;
        const double start[] = {arrow->x - back * x, arrow->y - back * y};
        ArrowShaft shaft = {arrow, start[0], start[1], start[0] + x, start[1] + y, {0}};
        if (!clip(diagram, &shaft)) continue;
        move_beside(diagram, &shaft);
        g_array_append_val(diagram->shafts, shaft);
    }
}
