/* Loads and outputs in the coordinates of the modes, and one solve a frequency: by a division a mode where damping
 * couples none, else by a linear system. */
#include "analysis/modes/frequency-response.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/lapack.h"

#include "analysis/modes/group-response-private.h"

/* Groups beyond this are reduced once; smaller ones are solved as they are, whose rounding is less. */
#define MOST_SOLVED_DIRECTLY 24
/* Frequencies around modes, in all. */
#define MOST_AROUND 3000

struct _TinkerFrequencyResponse {
    const TinkerModalBasis *basis;
    GArray *groups; /* of int32_t: see tinker_mode_groups */
    int32_t *order;
    GPtrArray *reduced;         /* of each group: TinkerGroupResponse *; NULL: it is solved directly */
    double *load[2];            /* on the modes: by the input and by its rate */
    double *read[2];            /* of the modes: by place and by speed */
    double direct[3];           /* by the input, its rate, its second derivative */
    double complex *y, *matrix; /* of the largest group */
    int32_t *pivots;
};

/* Setting up ------------------------------------------------------------------------------------------------------- */

/* out (size) -= sum of weight b (b . d) over the terms, for d over all coordinates. */
static void take_terms(const TinkerLinearisation *linear, const GArray *terms, const double *d, double *out)
{
    for (guint i = 0; i < terms->len; i++) {
        const TinkerLinearTerm *term = &g_array_index(terms, TinkerLinearTerm, i);
        const TinkerLinearEntry *entries = (const TinkerLinearEntry *)(const void *)linear->entries->data + term->first;
        double along = 0;
        for (guint k = 0; k < term->count; k++)
            along += entries[k].value * d[entries[k].coordinate];
        for (guint k = 0; k < term->count && along != 0; k++)
            if (entries[k].coordinate < linear->size)
                out[entries[k].coordinate] -= term->weight * entries[k].value * along;
    }
}

static void take_dense(const TinkerLinearisation *linear, const double *matrix, const double *d, double *out)
{
    gsize n = (gsize)linear->size;
    for (gsize c = 0; matrix != NULL && c < n; c++)
        for (gsize r = 0; r < n; r++)
            out[r] -= matrix[r + n * c] * d[c];
}

/* The displacement of every coordinate that the input asks for by constraints alone, supports included. */
static gboolean follow_input(const TinkerLinearisation *linear, const TinkerLinearInput *input, double *d)
{
    g_autofree double *asked = g_new0(double, MAX(linear->rows->len, 1));
    for (guint row = 0; row < linear->rows->len; row++) {
        const TinkerLinearTerm *term = &g_array_index(linear->rows, TinkerLinearTerm, row);
        for (guint k = 0; k < term->count; k++) {
            const TinkerLinearEntry *entry = &g_array_index(linear->entries, TinkerLinearEntry, term->first + k);
            asked[row] -= entry->value * input->place[entry->coordinate];
        }
    }
    memcpy(d, input->place, sizeof(double) * (gsize)linear->coordinates);
    return tinker_linearisation_follow(linear, asked, d);
}

static double product(const double *x, const double *y, int32_t n)
{
    double sum = 0;
    for (int32_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

static void set_up(TinkerFrequencyResponse *response, const TinkerLinearisation *linear, const TinkerLinearInput *input,
                   const TinkerLinearOutput *output, const double *d)
{
    gsize size = (gsize)MAX(linear->size, 1);
    g_autofree double *force = g_memdup2(input->force, sizeof(double) * size), *drag = g_new0(double, size);
    take_terms(linear, linear->stiffness, d, force);
    take_terms(linear, linear->damping, d, drag);
    take_dense(linear, linear->other_stiffness, d, force);
    take_dense(linear, linear->other_damping, d, drag);
    tinker_modal_basis_reduce(response->basis, force, response->load[0]);
    tinker_modal_basis_reduce(response->basis, drag, response->load[1]);
    tinker_modal_basis_reduce(response->basis, output->by_place, response->read[0]);
    tinker_modal_basis_reduce(response->basis, output->by_speed, response->read[1]);
    response->direct[0] = output->by_input[0] + product(output->by_place, d, linear->size);
    response->direct[1] = output->by_input[1] + product(output->by_speed, d, linear->size);
    response->direct[2] = output->by_input[2];
}

static void reduce_groups(TinkerFrequencyResponse *response)
{
    const int32_t *members = response->order;
    for (guint i = 0; i < response->groups->len; i++) {
        TinkerModeGroup group = {response->basis, members, g_array_index(response->groups, int32_t, i)};
        gboolean large = group.count > MOST_SOLVED_DIRECTLY;
        members += group.count;
        g_ptr_array_add(response->reduced,
                        large ? tinker_group_response_new(&group, response->load, response->read) : NULL);
    }
}

TinkerFrequencyResponse *tinker_frequency_response_new(const TinkerLinearisation *linear, const TinkerModalBasis *basis,
                                                       const TinkerLinearInput *input, const TinkerLinearOutput *output,
                                                       GError **error)
{
    g_autoptr(TinkerFrequencyResponse) response = g_new0(TinkerFrequencyResponse, 1);
    gsize count = (gsize)MAX(basis->count, 1), largest = 1;
    response->basis = basis;
    response->order = g_new0(int32_t, count);
    response->groups = tinker_mode_groups(basis, response->order);
    for (guint i = 0; i < response->groups->len; i++)
        largest = MAX(largest, (gsize)g_array_index(response->groups, int32_t, i));
    response->reduced = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_group_response_free);
    for (int k = 0; k < 2; k++) {
        response->load[k] = g_new0(double, count);
        response->read[k] = g_new0(double, count);
    }
    response->y = g_new0(double complex, largest);
    response->matrix = g_new0(double complex, largest *largest);
    response->pivots = g_new0(int32_t, largest);
    g_autofree double *d = g_new0(double, MAX(linear->coordinates, 1));
    if (!follow_input(linear, input, d)) {
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
            "its frequency response cannot be worked out: its numbers leave the range that can be computed with");
        return NULL;
    }
    set_up(response, linear, input, output, d);
    reduce_groups(response);
    return g_steal_pointer(&response);
}

void tinker_frequency_response_free(TinkerFrequencyResponse *response)
{
    if (response == NULL) return;
    g_array_unref(response->groups);
    g_ptr_array_unref(response->reduced);
    gpointer arrays[] = {response->order,   response->load[0], response->load[1], response->read[0],
                         response->read[1], response->y,       response->matrix,  response->pivots};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(response);
}

/* One frequency ---------------------------------------------------------------------------------------------------- */

/* y of the group's members; FALSE where the system is singular. */
static gboolean solve_group(TinkerFrequencyResponse *response, const TinkerModeGroup *group, double omega)
{
    gsize p = (gsize)group->count, m = (gsize)response->basis->count;
    const double *damping = response->basis->damping, *following = response->basis->following;
    for (gsize k = 0; k < p; k++) {
        gsize column = (gsize)group->members[k];
        response->y[k] = response->load[0][column] + CMPLX(0, omega) * response->load[1][column];
        for (gsize i = 0; i < p; i++) {
            gsize place = (gsize)group->members[i] + m * column;
            response->matrix[i + p * k] =
                CMPLX(following != NULL ? following[place] : 0, damping != NULL ? omega * damping[place] : 0);
        }
        response->matrix[k + p * k] += response->basis->squares[column] - omega * omega;
    }
    if (p == 1) {
        response->y[0] /= response->matrix[0];
        return TRUE;
    }
    return tinker_solve_complex((int32_t)p, response->matrix, response->y, response->pivots);
}

double complex tinker_frequency_response_at(TinkerFrequencyResponse *response, double omega)
{
    double complex sum =
        response->direct[0] + CMPLX(0, omega) * response->direct[1] - omega * omega * response->direct[2];
    const int32_t *members = response->order;
    for (guint i = 0; i < response->groups->len; i++) {
        TinkerModeGroup group = {response->basis, members, g_array_index(response->groups, int32_t, i)};
        gboolean reads = FALSE, drives = FALSE;
        members += group.count;
        for (int32_t k = 0; k < group.count; k++) {
            int32_t mode = group.members[k];
            reads |= response->read[0][mode] != 0 || response->read[1][mode] != 0;
            drives |= response->load[0][mode] != 0 || response->load[1][mode] != 0;
        }
        if (!reads || !drives) continue;
        TinkerGroupResponse *reduced = g_ptr_array_index(response->reduced, i);
        if (reduced != NULL && omega > 0) {
            sum += tinker_group_response_at(reduced, omega);
            continue;
        }
        if (!solve_group(response, &group, omega)) return CMPLX(INFINITY, 0);
        for (int32_t k = 0; k < group.count; k++) {
            int32_t mode = group.members[k];
            sum += (response->read[0][mode] + CMPLX(0, omega) * response->read[1][mode]) * response->y[k];
        }
    }
    return isfinite(cabs(sum)) ? sum : CMPLX(INFINITY, 0);
}

char *tinker_frequency_response_unit(const char *output, const char *input)
{
    return g_strdup_printf(strpbrk(input, " /") != NULL ? "%s/(%s)" : "%s/%s", output, input);
}

/* Many frequencies
 * ----------------------------------------------------------------------------------------------------- */

static gboolean swings(const TinkerMode *mode)
{
    return mode->kind == TINKER_MODE_OSCILLATION ||
           (mode->kind == TINKER_MODE_DECAY && isfinite(mode->natural) && mode->natural > 0);
}

void tinker_frequency_response_range(const GPtrArray *modes, double *from, double *to)
{
    double least = INFINITY, greatest = 0;
    for (guint i = 0; i < modes->len; i++) {
        const TinkerMode *mode = g_ptr_array_index(modes, i);
        if (!swings(mode)) continue;
        least = fmin(least, mode->natural);
        greatest = fmax(greatest, mode->natural);
    }
    *from = greatest > 0 ? least / 5 : 0.1;
    *to = greatest > 0 ? greatest * 4 : 100;
}

static int compare_numbers(const void *left, const void *right)
{
    double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

/* Points on both sides of a mode, closer the nearer they are, down to a part of its width. */
static void add_around(GArray *grid, const TinkerMode *mode, int each, double from, double to)
{
    double centre = mode->frequency > 0 ? mode->frequency : mode->natural;
    double ratio = isfinite(mode->damping_ratio) ? fabs(mode->damping_ratio) : 1;
    double nearest = fmax(0.1 * ratio, 1e-4);
    if (mode->damping_ratio > 0 && centre >= from && centre <= to) g_array_append_val(grid, centre);
    for (int k = 0; k < each && nearest < 0.3; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double omega = centre * (1 + sign * nearest * pow(0.3 / nearest, k / fmax(each - 1, 1)));
            if (omega >= from && omega <= to) g_array_append_val(grid, omega);
        }
}

GArray *tinker_frequency_response_grid(const GPtrArray *modes, double from, double to, int count, gboolean logarithmic)
{
    GArray *grid = g_array_new(FALSE, FALSE, sizeof(double));
    for (int i = 0; i < count; i++) {
        double share = count > 1 ? i / (count - 1.0) : 0;
        double omega = logarithmic ? from * pow(to / from, share) : from + (to - from) * share;
        if (i == count - 1 && count > 1) omega = to;
        g_array_append_val(grid, omega);
    }
    int each = CLAMP(MOST_AROUND / (2 * (int)MAX(modes->len, 1)), 2, 14);
    for (guint i = 0; i < modes->len; i++)
        if (swings(g_ptr_array_index(modes, i))) add_around(grid, g_ptr_array_index(modes, i), each, from, to);
    g_array_sort(grid, compare_numbers);
    guint kept = 0;
    for (guint i = 0; i < grid->len; i++) {
        double omega = g_array_index(grid, double, i);
        if (kept > 0 && omega <= g_array_index(grid, double, kept - 1) * (1 + 1e-12)) continue;
        g_array_index(grid, double, kept++) = omega;
    }
    g_array_set_size(grid, kept);
    return grid;
}

/* Golden section between two frequencies that have a peak between them. */
static TinkerResponsePeak sharpen(TinkerFrequencyResponse *response, double low, double high)
{
    const double golden = 0.61803398874989485;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double at_a = cabs(tinker_frequency_response_at(response, a)),
           at_b = cabs(tinker_frequency_response_at(response, b));
    for (int i = 0; i < 100 && high - low > 1e-14 * high; i++) {
        if (at_a > at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - golden * (high - low);
            at_a = cabs(tinker_frequency_response_at(response, a));
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + golden * (high - low);
            at_b = cabs(tinker_frequency_response_at(response, b));
        }
    }
    double omega = at_a > at_b ? a : b;
    return (TinkerResponsePeak){omega, tinker_frequency_response_at(response, omega)};
}

GArray *tinker_frequency_response_peaks(TinkerFrequencyResponse *response, const GArray *grid)
{
    GArray *peaks = g_array_new(FALSE, FALSE, sizeof(TinkerResponsePeak));
    g_autofree double *size = g_new0(double, MAX(grid->len, 1));
    for (guint i = 0; i < grid->len; i++)
        size[i] = cabs(tinker_frequency_response_at(response, g_array_index(grid, double, i)));
    for (guint i = 1; i + 1 < grid->len; i++) {
        if (!(size[i] > size[i - 1] && size[i] >= size[i + 1])) continue;
        TinkerResponsePeak peak =
            sharpen(response, g_array_index(grid, double, i - 1), g_array_index(grid, double, i + 1));
        /* Only where nothing damps it does it go on growing like that: by a factor as great as the grid is fine. */
        if (isinf(size[i]) || !(cabs(peak.at) < 1e7 * size[i])) peak.at = CMPLX(INFINITY, 0);
        g_array_append_val(peaks, peak);
    }
    return peaks;
}
