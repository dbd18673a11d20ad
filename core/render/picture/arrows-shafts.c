/* How long arrows are, and where they lie: cut to what is visible, and side by side where one would lie on another. */
#include "render/picture/arrows-diagram-private.h"

#include <float.h>
#include <math.h>

#define SHARE_OF_VIEW 0.1
#define KEEPS         3.0 /* the factor by which a scale may be off before it changes */

/* Canvas units. */
#define LEAST_LENGTH 3.0
#define BESIDE       7.0 /* between arrows that would lie on each other */
#define TOGETHER     2.0 /* starts so near to each other are one */

#define SAME_WAY 0.995 /* cosine */

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

/* How many of the arrows so far it would lie on. */
static int count_beneath(const ArrowDiagram *diagram, const ArrowShaft *shaft)
{
    double unit = 1 / diagram->view->scale, dx = shaft->x2 - shaft->x1, dy = shaft->y2 - shaft->y1;
    int count = 0;
    for (guint i = 0; i < diagram->shafts->len && i < ARROWS_MOST_LABELS; i++) {
        const ArrowShaft *other = &g_array_index(diagram->shafts, ArrowShaft, i);
        double ox = other->x2 - other->x1, oy = other->y2 - other->y1;
        if (hypot(other->arrow->x - shaft->arrow->x, other->arrow->y - shaft->arrow->y) > TOGETHER * unit) continue;
        if (dx * ox + dy * oy >= SAME_WAY * hypot(dx, dy) * hypot(ox, oy)) count++;
    }
    return count;
}

/* To one side, to the other, farther to the first. */
static void move_beside(const ArrowDiagram *diagram, ArrowShaft *shaft)
{
    int beneath = count_beneath(diagram, shaft);
    double dx = shaft->x2 - shaft->x1, dy = shaft->y2 - shaft->y1, length = hypot(dx, dy);
    double off = (beneath + 1) / 2 * (beneath % 2 ? BESIDE : -BESIDE) / (diagram->view->scale * length);
    shaft->x1 += off * dy;
    shaft->x2 += off * dy;
    shaft->y1 -= off * dx;
    shaft->y2 -= off * dx;
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
        ArrowShaft shaft = {arrow, arrow->x, arrow->y, arrow->x + scale * arrow->fx, arrow->y + scale * arrow->fy, {0}};
        if (!clip(diagram, &shaft)) continue;
        move_beside(diagram, &shaft);
        g_array_append_val(diagram->shafts, shaft);
    }
}
