/* The energies of a step, as closed integrals of the motion: never from the energy balance, which is left to judge
 * them.
 *
 * An edge pulls with T = pull + k (xi + w) + c (xi' + w'), xi what the modes and w what moving anchors add to its d.
 *     dampers:   -int c (xi' + w')^2 = -int c xi'^2 - 2 int c xi' w' - int c w'^2
 *     supports:   int T w' = pull [w] + k [w^2 / 2] + k [xi w] - int k xi' w + int c xi' w' + int c w'^2
 * with [] the difference over the step. The integrals of xi'^2 are quadratic forms, those with w are moments of
 * the modes' rates with the signals, that of w'^2 follows from the signals alone.
 */
#include <string.h>

#include "numerics/exact/exact-private.h"

static void book(double *books, int32_t index, double energy)
{
    if (index >= 0) books[index] += energy;
}

static double quadratic(gsize d, const double *form, const double *x)
{
    double sum = 0.0;
    for (gsize i = 0; i < d; i++) {
        double row = 0.0;
        for (gsize j = 0; j < d; j++)
            row += form[i * d + j] * x[j];
        sum += x[i] * row;
    }
    return sum;
}

static double product(gsize count, const double *a, const double *b)
{
    double sum = 0.0;
    for (gsize i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* What a power is integrated against: its signal's values at the start of the step, or those of its rate. */
static const TinkerLinearInput *weights_of(const TinkerExactPart *part, const TinkerExactPower *power,
                                           TinkerExactValues weights)
{
    const TinkerLinearInput *input = &part->inputs[part->signals[power->signal].input];
    if (power->of_rate)
        tinker_exact_derivative(input, part->values[power->signal], weights);
    else
        memcpy(weights, part->values[power->signal], sizeof(TinkerExactValues));
    return input;
}

static void book_modes(TinkerExactPart *part, const TinkerExactSlot *slot, const double *from, double *books)
{
    gsize n = (gsize)part->n, entries = (gsize)part->entries, d = 2 + entries;
    double *vector = part->work, *moments = vector + d;
    for (gsize j = 0; j < n; j++) {
        vector[0] = from[j];
        vector[1] = from[n + j];
        for (gsize r = 0; r < entries; r++)
            vector[2 + r] = part->amplitude[r * n + j];
        double squares = quadratic(d, slot->forms + j * d * d, vector);
        book(books, part->linear->damper_book, -part->damping[0][j] * squares);
        book(books, part->linear->drag_book, -part->damping[1][j] * squares);
        if (part->power_count == 0) continue;
        for (gsize r = 0; r < entries; r++)
            moments[r] = product(d, slot->moments + (j * entries + r) * d, vector);
        for (int32_t k = 0; k < part->power_count; k++) {
            TinkerExactValues weights;
            const TinkerLinearInput *input = weights_of(part, &part->powers[k], weights);
            part->power_sums[k] +=
                part->powers[k].direction[j] * product((gsize)input->count, weights, moments + input->first);
        }
    }
}

/* The vector that the propagator was last applied to is still there: see tinker_exact_part_advance. */
static void book_coupled(TinkerExactPart *part, const TinkerExactSlot *slot, double *books)
{
    gsize d = 2 * (gsize)part->n + (gsize)part->entries, row = 0;
    const double *vector = part->amplitude + part->entries;
    book(books, part->linear->damper_book, -quadratic(d, slot->forms, vector));
    book(books, part->linear->drag_book, -quadratic(d, slot->forms + d * d, vector));
    for (int32_t k = 0; k < part->power_count; k++) {
        TinkerExactValues weights;
        const TinkerLinearInput *input = weights_of(part, &part->powers[k], weights);
        for (int32_t r = 0; r < input->count; r++, row++)
            part->power_sums[k] += weights[r] * product(d, slot->moments + row * d, vector);
    }
}

static double elongation(const TinkerExactPart *part, int32_t e, const double *z)
{
    const double *row = part->elongation + (gsize)e * (gsize)part->n;
    double sum = 0.0;
    for (int32_t j = 0; j < part->n; j++)
        sum += row[j] * (z[j] / tinker_linear_scale(part->omega[j]));
    return sum;
}

/* The integral of w'^2 from the moves `first` to `end`, all of one edge. */
static double square_of_rate(const TinkerExactPart *part, const TinkerExactSlot *slot, int32_t first, int32_t end)
{
    gsize b = (gsize)part->basis_entries;
    double *weights = part->work;
    memset(weights, 0, b * sizeof *weights);
    for (int32_t m = first; m < end; m++) {
        const TinkerExactMove *move = &part->moves[m];
        const TinkerLinearInput *input = &part->basis[part->basis_of[move->signal]];
        TinkerExactValues rates;
        tinker_exact_derivative(input, part->values[move->signal], rates);
        for (int32_t r = 0; r < input->count; r++)
            weights[input->first + r] += move->factor * rates[r];
    }
    return quadratic(b, slot->gram, weights);
}

static void book_moved_edges(TinkerExactPart *part, const TinkerExactSlot *slot, const double *from, const double *to,
                             double *books)
{
    for (int32_t first = 0, end; first < part->move_count; first = end) {
        int32_t e = part->moves[first].edge;
        double w0 = 0.0, w1 = 0.0;
        for (end = first; end < part->move_count && part->moves[end].edge == e; end++) {
            w0 += part->moves[end].factor * part->values[part->moves[end].signal][0];
            w1 += part->moves[end].factor * part->ahead[part->moves[end].signal][0];
        }
        const TinkerLinearEdge *edge = &part->linear->edges[part->edges[e].edge];
        double held = (part->edges[e].pull + 0.5 * edge->stiffness * (w0 + w1)) * (w1 - w0);
        double joint = edge->stiffness * (elongation(part, e, to) * w1 - elongation(part, e, from) * w0);
        double damped = edge->damping == 0.0 ? 0.0 : edge->damping * square_of_rate(part, slot, first, end);
        book(books, part->linear->support_book, held + joint + damped);
        book(books, part->linear->damper_book, -damped);
    }
}

static void book_loads(const TinkerExactPart *part, const double *from, const double *to, double *books)
{
    for (int32_t k = 0; k < part->booked_load_count; k++) {
        const TinkerConstantLoad *load = &part->booked_loads[k];
        const double *row = part->shape + (gsize)load->target * (gsize)part->n;
        double way = 0.0;
        for (int32_t j = 0; j < part->n; j++)
            way += row[j] * ((to[j] - from[j]) / tinker_linear_scale(part->omega[j]));
        book(books, load->book, load->force * way);
    }
}

void tinker_exact_part_book(TinkerExactPart *part, const TinkerExactSlot *slot, const double *from, const double *to,
                            double *books)
{
    memset(part->power_sums, 0, (gsize)part->power_count * sizeof *part->power_sums);
    if (part->coupled)
        book_coupled(part, slot, books);
    else
        book_modes(part, slot, from, books);
    for (int32_t k = 0; k < part->power_count; k++)
        for (int i = 0; i < 2; i++)
            book(books, part->powers[k].books[i], part->powers[k].weights[i] * part->power_sums[k]);
    book_moved_edges(part, slot, from, to, books);
    book_loads(part, from, to, books);
}
