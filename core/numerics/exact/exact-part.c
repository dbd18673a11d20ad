/* One part of a linear system: its modes, its edges seen from the modes, and what acts on it. */
#include <math.h>
#include <string.h>

#include "numerics/exact/exact-private.h"
#include "numerics/exact/linear-modes.h"

static int32_t local_of(const TinkerLinearParts *parts, int32_t end)
{
    return end >= 0 ? parts->local[end] : -1;
}

static const TinkerLinearEdge *edge_of(const TinkerExactPart *part, int32_t e)
{
    return &part->linear->edges[part->edges[e].edge];
}

/* What the modes are good for: masses above 0, no stiffness below it, nothing that is no number. */
static gboolean suits(const TinkerExactPart *part)
{
    for (int32_t i = 0; i < part->n; i++) {
        double mass = part->linear->mass[part->coordinates[i]];
        if (!(mass > 0.0) || !isfinite(mass)) return FALSE;
    }
    for (int32_t e = 0; e < part->edge_count; e++) {
        const TinkerLinearEdge *edge = edge_of(part, e);
        double sum = edge->stiffness + fabs(edge->damping) + fabs(edge->length) + fabs(edge->tension);
        if (!(edge->stiffness >= 0.0) || !isfinite(sum)) return FALSE;
    }
    return TRUE;
}

static void gather_springs(const TinkerExactPart *part, const TinkerLinearParts *parts, double *weights, double *ground)
{
    for (int32_t e = 0; e < part->edge_count; e++) {
        const TinkerLinearEdge *edge = edge_of(part, e);
        int32_t a = local_of(parts, edge->a), b = local_of(parts, edge->b);
        if (a < 0 || b < 0) {
            ground[MAX(a, b)] += edge->stiffness;
        } else if (a != b) {
            weights[(gsize)a * part->n + b] += edge->stiffness;
            weights[(gsize)b * part->n + a] += edge->stiffness;
        }
    }
}

static gboolean find_modes(TinkerExactPart *part, const TinkerLinearParts *parts)
{
    gsize n = (gsize)part->n;
    g_autofree double *weights = g_try_malloc0_n(n * n, sizeof(double));
    g_autofree double *ground = g_try_malloc0_n(2 * n, sizeof(double));
    g_autofree double *work = g_try_malloc0_n(tinker_linear_modes_work(part->n), sizeof(double));
    if (!weights || !ground || !work) return FALSE;
    double *mass = ground + n;
    for (gsize i = 0; i < n; i++)
        mass[i] = part->linear->mass[part->coordinates[i]];
    gather_springs(part, parts, weights, ground);
    if (!tinker_linear_modes(part->n, mass, weights, ground, part->omega, part->shape, work)) return FALSE;
    for (gsize i = 0; i < n; i++)
        for (gsize j = 0; j < n; j++)
            part->weigh[j * n + i] = part->shape[i * n + j] * mass[i];
    return TRUE;
}

static void find_elongations(TinkerExactPart *part, const TinkerLinearParts *parts)
{
    gsize n = (gsize)part->n;
    for (int32_t e = 0; e < part->edge_count; e++) {
        TinkerExactEdge *mine = &part->edges[e];
        const TinkerLinearEdge *edge = edge_of(part, e);
        int32_t a = local_of(parts, edge->a), b = local_of(parts, edge->b);
        double *row = part->elongation + (gsize)e * n;
        for (gsize j = 0; j < n; j++)
            row[j] = (b >= 0 ? part->shape[(gsize)b * n + j] : 0.0) - (a >= 0 ? part->shape[(gsize)a * n + j] : 0.0);
        mine->watched = a != b && (edge->stiffness * edge->length != 0.0 || edge->tension != 0.0);
        part->watched += mine->watched;
    }
}

static void find_loads(TinkerExactPart *part, const TinkerLinearParts *parts, int32_t number)
{
    const TinkerLinearSystem *linear = part->linear;
    gsize n = (gsize)part->n;
    for (int32_t k = 0; k < linear->load_count; k++) {
        const TinkerConstantLoad *load = &linear->loads[k];
        if (parts->part_of[load->target] != number) continue;
        int32_t local = parts->local[load->target];
        for (gsize j = 0; j < n; j++)
            part->load[j] += part->shape[(gsize)local * n + j] * load->force;
        if (load->book >= 0)
            part->booked_loads[part->booked_load_count++] = (TinkerConstantLoad){local, load->book, load->force};
    }
}

/* The part's number of a signal, a new one where it is met first. */
static int32_t signal_of(TinkerExactPart *part, int32_t id)
{
    for (int32_t s = 0; s < part->signal_count; s++)
        if (part->signals[s].id == id) return s;
    gsize n = (gsize)part->n;
    double *directions = tinker_exact_allot(part->memory, 3 * n, sizeof(double));
    if (!directions) return -1;
    part->signals[part->signal_count] = (TinkerExactSignal){
        .id = id, .by_value = directions, .by_rate = directions + n, .by_spring = directions + 2 * n};
    return part->signal_count++;
}

static TinkerExactPower *add_power(TinkerExactPart *part, int32_t signal, gboolean of_rate, const double *direction)
{
    TinkerExactPower *power = &part->powers[part->power_count++];
    *power = (TinkerExactPower){signal, of_rate, direction, {-1, -1}, {0.0, 0.0}};
    return power;
}

/* Forces on coordinates: into the modes, and each with a book of its own into a power. */
static gboolean find_forces(TinkerExactPart *part, const TinkerLinearParts *parts, int32_t number)
{
    gsize n = (gsize)part->n;
    for (int32_t k = 0; k < part->linear->force_count; k++) {
        const TinkerSignalUse *use = &part->linear->forces[k];
        if (parts->part_of[use->target] != number) continue;
        int32_t s = signal_of(part, use->signal);
        double *direction = tinker_exact_allot(part->memory, n, sizeof(double));
        if (s < 0 || !direction) return FALSE;
        for (gsize j = 0; j < n; j++) {
            direction[j] = part->shape[(gsize)parts->local[use->target] * n + j] * use->factor;
            part->signals[s].by_value[j] += direction[j];
        }
        if (use->book >= 0) {
            TinkerExactPower *power = add_power(part, s, FALSE, direction);
            power->books[0] = use->book;
            power->weights[0] = 1.0;
        }
    }
    return TRUE;
}

/* How the motions of one end move d: with +1 for b, -1 for a. */
static gboolean find_moves_of(TinkerExactPart *part, int32_t e, int32_t end, double sense)
{
    const TinkerLinearEdge *edge = edge_of(part, e);
    gsize n = (gsize)part->n;
    for (int32_t k = 0; end < 0 && k < part->linear->motion_count; k++) {
        const TinkerSignalUse *use = &part->linear->motions[k];
        if (use->target != -1 - end) continue;
        int32_t s = signal_of(part, use->signal);
        if (s < 0) return FALSE;
        TinkerExactSignal *signal = &part->signals[s];
        double factor = sense * use->factor;
        part->moves[part->move_count++] = (TinkerExactMove){e, s, factor};
        part->edges[e].moved = TRUE;
        for (gsize j = 0; j < n; j++) {
            double row = part->elongation[(gsize)e * n + j];
            signal->by_spring[j] -= edge->stiffness * factor * row;
            signal->by_rate[j] -= edge->damping * factor * row;
        }
    }
    return TRUE;
}

/* With T the pull of an edge and w what moving anchors add to its d, supports give T dw/dt; of this the part with the
 * modes' rates is integrated as powers, see exact-books.c. */
static gboolean find_moves(TinkerExactPart *part)
{
    for (int32_t e = 0; e < part->edge_count; e++) {
        const TinkerLinearEdge *edge = edge_of(part, e);
        if (!find_moves_of(part, e, edge->a, -1.0) || !find_moves_of(part, e, edge->b, 1.0)) return FALSE;
    }
    for (int32_t s = 0; s < part->signal_count; s++) {
        TinkerExactSignal *signal = &part->signals[s];
        TinkerExactPower *springs = add_power(part, s, FALSE, signal->by_spring);
        springs->books[0] = part->linear->support_book;
        springs->weights[0] = 1.0;
        TinkerExactPower *dampers = add_power(part, s, TRUE, signal->by_rate);
        dampers->books[0] = part->linear->support_book;
        dampers->weights[0] = -1.0;
        dampers->books[1] = part->linear->damper_book;
        dampers->weights[1] = 2.0;
        for (int32_t j = 0; j < part->n; j++)
            signal->by_value[j] += signal->by_spring[j];
    }
    return TRUE;
}

static gboolean allot_part(TinkerExactPart *part, const TinkerLinearParts *parts, int32_t number)
{
    GPtrArray *memory = part->memory;
    const TinkerLinearSystem *linear = part->linear;
    gsize n = (gsize)part->n, edges = (gsize)part->edge_count;
    gsize signals = (gsize)linear->signal_count;
    gsize moves = linear->motion_count > 0 ? 2 * edges * (gsize)linear->motion_count : 0;
    double *doubles = tinker_exact_allot(memory, 2 * n * n + (edges + 19) * n, sizeof(double));
    part->edges = tinker_exact_allot(memory, edges, sizeof *part->edges);
    part->moves = tinker_exact_allot(memory, moves, sizeof *part->moves);
    part->signals = tinker_exact_allot(memory, signals, sizeof *part->signals);
    part->powers = tinker_exact_allot(memory, (gsize)linear->force_count + 2 * signals, sizeof *part->powers);
    part->booked_loads = tinker_exact_allot(memory, (gsize)linear->load_count, sizeof *part->booked_loads);
    part->power_sums = tinker_exact_allot(memory, (gsize)linear->force_count + 2 * signals, sizeof(double));
    part->values = tinker_exact_allot(memory, signals, sizeof *part->values);
    part->ahead = tinker_exact_allot(memory, signals, sizeof *part->ahead);
    if (!doubles || !part->edges || !part->moves || !part->signals || !part->powers || !part->booked_loads ||
        !part->power_sums || !part->values || !part->ahead)
        return FALSE;
    double **each[] = {&part->shape,     &part->weigh, &part->elongation, &part->omega, &part->decay,  &part->load,
                       &part->reference, &part->push,  &part->place,      &part->speed, &part->before, &part->energy,
                       &part->bend,      &part->unit,  &part->z,          &part->from,  &part->scratch};
    gsize sizes[] = {n * n, n * n, edges * n, n, n, n, n, n, n, n, n, n, n, n, 2 * n, 2 * n, 4 * n};
    for (gsize i = 0; i < G_N_ELEMENTS(each); i++) {
        *each[i] = doubles;
        doubles += sizes[i];
    }
    for (gsize e = 0; e < edges; e++)
        part->edges[e].edge = parts->edges[parts->edge_starts[number] + (int32_t)e];
    return TRUE;
}

static gboolean build_part(TinkerExactPart *part, const TinkerLinearParts *parts, int32_t number)
{
    if (part->n > TINKER_EXACT_MOST_COORDINATES || !allot_part(part, parts, number) || !suits(part)) return FALSE;
    if (!find_modes(part, parts)) return FALSE;
    find_elongations(part, parts);
    find_loads(part, parts, number);
    return find_forces(part, parts, number) && find_moves(part) && tinker_exact_part_damp(part, parts);
}

TinkerExactPart *tinker_exact_part_new(const TinkerSystem *system, const TinkerLinearParts *parts, int32_t number)
{
    TinkerExactPart *part = g_new0(TinkerExactPart, 1);
    part->system = system;
    part->linear = system->linear;
    part->memory = g_ptr_array_new_with_free_func(g_free);
    part->booked = system->books > 0;
    part->n = parts->starts[number + 1] - parts->starts[number];
    part->coordinates = parts->members + parts->starts[number];
    part->edge_count = parts->edge_starts[number + 1] - parts->edge_starts[number];
    if (build_part(part, parts, number)) return part;
    tinker_exact_part_free(part);
    return NULL;
}

void tinker_exact_part_free(TinkerExactPart *part)
{
    if (!part) return;
    g_ptr_array_unref(part->memory);
    g_free(part->slot_memory);
    g_free(part->work);
    g_free(part);
}
