/* What the exact method costs and how far its result can be trusted, from the system's numbers alone. */
#include "numerics/exact/exact.h"

#include <float.h>
#include <math.h>

#include "numerics/exact/exact-private.h"

#define SWEEPS          7.0 /* of rotations until columns are orthogonal */
#define SERIES_TERMS    16.0
#define USUAL_DOUBLINGS 20.0
/* Intervals of a run. A prime number at the least and at the most: a run that lasts for a round number of periods is
 * seen in different phases. Coupled modes go on within an interval by halves of it, which are shared by all samples:
 * many intervals would cost more than they save. */
#define LEAST_INTERVALS        17.0
#define MOST_INTERVALS         65537.0
#define MOST_COUPLED_INTERVALS 257.0

/* drag / mass is the same everywhere in the part. */
static gboolean is_drag_even(const TinkerLinearSystem *system, const TinkerLinearParts *parts, int32_t part)
{
    if (!system->drag) return TRUE;
    int32_t first = parts->members[parts->starts[part]];
    for (int32_t k = parts->starts[part]; k < parts->starts[part + 1]; k++) {
        int32_t i = parts->members[k];
        double here = system->drag[i] * system->mass[first], there = system->drag[first] * system->mass[i];
        if (fabs(here - there) > 4.0 * DBL_EPSILON * fabs(here)) return FALSE;
    }
    return TRUE;
}

static gboolean is_part_proportional(const TinkerLinearSystem *system, const TinkerLinearParts *parts, int32_t part)
{
    if (parts->starts[part + 1] - parts->starts[part] == 1) return TRUE;
    const TinkerLinearEdge *stiffest = NULL;
    for (int32_t k = parts->edge_starts[part]; k < parts->edge_starts[part + 1]; k++) {
        const TinkerLinearEdge *edge = &system->edges[parts->edges[k]];
        if (!stiffest || edge->stiffness > stiffest->stiffness) stiffest = edge;
    }
    for (int32_t k = parts->edge_starts[part]; k < parts->edge_starts[part + 1]; k++) {
        const TinkerLinearEdge *edge = &system->edges[parts->edges[k]];
        double here = edge->damping * stiffest->stiffness, there = stiffest->damping * edge->stiffness;
        if (fabs(here - there) > 4.0 * DBL_EPSILON * fabs(here)) return FALSE;
        if (stiffest->stiffness == 0.0 && edge->damping != 0.0) return FALSE;
    }
    return is_drag_even(system, parts, part);
}

static gboolean is_part_suitable(const TinkerLinearSystem *system, const TinkerLinearParts *parts, int32_t part)
{
    int32_t n = parts->starts[part + 1] - parts->starts[part];
    if (n > TINKER_EXACT_MOST_COORDINATES) return FALSE;
    if (n > TINKER_EXACT_MOST_COUPLED && !is_part_proportional(system, parts, part)) return FALSE;
    for (int32_t k = parts->starts[part]; k < parts->starts[part + 1]; k++)
        if (!(system->mass[parts->members[k]] > 0.0)) return FALSE;
    for (int32_t k = parts->edge_starts[part]; k < parts->edge_starts[part + 1]; k++)
        if (!(system->edges[parts->edges[k]].stiffness >= 0.0)) return FALSE;
    return TRUE;
}

gboolean tinker_exact_suits(const TinkerLinearSystem *system)
{
    g_autoptr(TinkerLinearParts) parts = tinker_linear_parts_new(system);
    for (int32_t part = 0; part < parts->count; part++)
        if (!is_part_suitable(system, parts, part)) return FALSE;
    return TRUE;
}

gboolean tinker_exact_is_proportional(const TinkerLinearSystem *system)
{
    g_autoptr(TinkerLinearParts) parts = tinker_linear_parts_new(system);
    for (int32_t part = 0; part < parts->count; part++)
        if (!is_part_proportional(system, parts, part)) return FALSE;
    return TRUE;
}

/* Of one part: once, and each step. */
static void count_part(const TinkerLinearSystem *system, const TinkerLinearParts *parts, int32_t part, double *once,
                       double *each)
{
    double n = parts->starts[part + 1] - parts->starts[part];
    double edges = parts->edge_starts[part + 1] - parts->edge_starts[part];
    gboolean driven = system->force_count + system->motion_count > 0;
    double signals = driven ? fmin(system->signal_count, system->force_count + system->motion_count) : 0.0;
    *each += 4.0 * n * n + 20.0 * n;
    if (n > 1.0) *once += (2.0 + 5.0 * SWEEPS) * n * n * n;
    *once += 200.0 * n + 4.0 * edges * n;
    if (is_part_proportional(system, parts, part)) {
        double entries = driven ? 4.0 + 2.0 * signals : 0.0, d = 2.0 + entries;
        *each += (4.0 + 4.0 * signals) * entries * n;
        *once += driven ? n * (SERIES_TERMS + USUAL_DOUBLINGS) * 2.0 * d * d * d : 0.0;
        return;
    }
    double entries = 4.0 * signals, d = 2.0 * n + entries;
    *once += 8.0 * edges * n * n + SERIES_TERMS * 2.0 * d * n * (n + entries) + USUAL_DOUBLINGS * 2.0 * d * d * d;
    *each += 4.0 * n * d;
}

double tinker_exact_operations(const TinkerLinearSystem *system, gint64 steps, double *setup)
{
    g_autoptr(TinkerLinearParts) parts = tinker_linear_parts_new(system);
    double once = 0.0, each = 0.0;
    for (int32_t part = 0; part < parts->count; part++) {
        if (is_part_suitable(system, parts, part)) {
            count_part(system, parts, part, &once, &each);
        } else {
            once = each = INFINITY;
        }
    }
    if (setup) *setup = once;
    return steps > 0 ? each * (double)steps : 0.0;
}

/* Gershgorin's bound on M^-1 K, or on M^-1 C: twice the law between masses, once that to anchors. */
static double greatest_row(const TinkerLinearSystem *system, gboolean of_damping)
{
    g_autofree double *rows = g_new0(double, system->size);
    for (int32_t e = 0; e < system->edge_count; e++) {
        const TinkerLinearEdge *edge = &system->edges[e];
        double law = fabs(of_damping ? edge->damping : edge->stiffness);
        double share = edge->a >= 0 && edge->b >= 0 ? 2.0 * law : law;
        if (edge->a >= 0) rows[edge->a] += share;
        if (edge->b >= 0) rows[edge->b] += share;
    }
    double greatest = 0.0;
    for (int32_t i = 0; i < system->size; i++) {
        double drag = of_damping && system->drag ? fabs(system->drag[i]) : 0.0;
        greatest = fmax(greatest, (rows[i] + drag) / system->mass[i]);
    }
    return greatest;
}

double tinker_exact_fastest(const TinkerLinearSystem *system)
{
    return sqrt(greatest_row(system, FALSE));
}

double tinker_exact_interval(const TinkerLinearSystem *system, double drive, double duration)
{
    gboolean driven = system->force_count + system->motion_count > 0;
    gboolean coupled = !tinker_exact_is_proportional(system);
    double rate = 0.0, most = coupled ? MOST_COUPLED_INTERVALS : MOST_INTERVALS;
    if (driven || coupled) rate = fmax(tinker_exact_fastest(system) + greatest_row(system, TRUE), drive);
    double count = ceil(duration * rate / TINKER_LINEAR_SERIES_REACH);
    return duration / CLAMP(count, LEAST_INTERVALS, most);
}

double tinker_exact_claimed_error(const TinkerLinearSystem *system, double T)
{
    return DBL_EPSILON * (16.0 + tinker_exact_fastest(system) * fabs(T));
}
