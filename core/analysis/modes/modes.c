/* Modes that damping does not couple have roots in closed form; those that it does are solved group by group. */
#include "analysis/modes/modes.h"

#include <float.h>
#include <math.h>

#include "analysis/modes/mode-roots-private.h"

/* Damping this small beside the strongest is rounding of it. */
#define LEAST_DAMPING 1e-13

/* Components this far out of step make a shape that is no standing one. */
#define OUT_OF_STEP 1e-6

static void mode_free(gpointer data)
{
    TinkerMode *mode = data;
    g_free(mode->real);
    g_free(mode->imaginary);
    g_free(mode);
}

/* Turns the shape so that its largest component is 1. */
static void normalise(TinkerMode *mode, int32_t size)
{
    double most = 0;
    double complex largest = 1;
    for (int32_t i = 0; i < size; i++) {
        double complex at = CMPLX(mode->real[i], mode->imaginary[i]);
        if (cabs(at) <= most * (1 + 1e-9)) continue; /* the first of equals, whatever rounding says */
        most = cabs(at);
        largest = at;
    }
    for (int32_t i = 0; i < size; i++) {
        double complex at = CMPLX(mode->real[i], mode->imaginary[i]) / largest;
        mode->real[i] = creal(at);
        mode->imaginary[i] = cimag(at);
    }
}

/* A mode whose shape is `shape` over the group's members. */
static TinkerMode *mode_new(const TinkerModeGroup *group, const double complex *shape)
{
    gsize size = (gsize)group->basis->size;
    TinkerMode *mode = g_new0(TinkerMode, 1);
    mode->real = g_new0(double, MAX(size, 1));
    mode->imaginary = g_new0(double, MAX(size, 1));
    for (int32_t k = 0; k < group->count; k++) {
        const double *column = group->basis->shapes + size * (gsize)group->members[k];
        for (gsize i = 0; i < size; i++) {
            mode->real[i] += creal(shape[k]) * column[i];
            mode->imaginary[i] += cimag(shape[k]) * column[i];
        }
    }
    normalise(mode, group->basis->size);
    mode->natural = mode->damping_ratio = NAN;
    return mode;
}

static void add_rigid(const TinkerModeGroup *group, int32_t place, GPtrArray *modes)
{
    const TinkerModeGroup one = {group->basis, group->members + place, 1};
    TinkerMode *mode = mode_new(&one, (double complex[]){1});
    mode->kind = TINKER_MODE_RIGID;
    mode->natural = 0;
    g_ptr_array_add(modes, mode);
}

static TinkerMode *add_root(const TinkerModeGroup *group, double complex s, const double complex *shape,
                            GPtrArray *modes)
{
    TinkerMode *mode = mode_new(group, shape);
    mode->decay = -creal(s);
    if (mode->decay == 0) mode->decay = 0; /* no minus before it */
    mode->frequency = fabs(cimag(s));
    if (mode->frequency > 0) {
        mode->kind = TINKER_MODE_OSCILLATION;
        mode->natural = cabs(s);
        mode->damping_ratio = mode->decay / mode->natural;
    } else {
        mode->kind = mode->decay > 0 ? TINKER_MODE_DECAY : TINKER_MODE_GROWTH;
    }
    g_ptr_array_add(modes, mode);
    return mode;
}

/* Of a rigid motion: what dampers between parts that move alike leave of their damping. */
static gboolean is_rounding(const TinkerModalBasis *basis, double damping)
{
    double strongest = 0;
    for (gsize i = 0; damping != 0 && i < (gsize)basis->count; i++)
        strongest = fmax(strongest, fabs(basis->damping[i + (gsize)basis->count * i]));
    return fabs(damping) <= LEAST_DAMPING * strongest;
}

/* s^2 + c s + square = 0; the smaller root by the product of both, so that it keeps its digits. */
static void add_single(const TinkerModeGroup *group, GPtrArray *modes)
{
    static const double complex shape[] = {1};
    const TinkerModalBasis *basis = group->basis;
    gsize i = (gsize)group->members[0];
    double square = basis->squares[i], c = basis->damping != NULL ? basis->damping[i + (gsize)basis->count * i] : 0;
    double half = 0.5 * c, under = half * half - square;
    if (fabs(under) <= 8 * DBL_EPSILON * fmax(half * half, fabs(square))) under = 0;
    if (square == 0) add_rigid(group, 0, modes);
    if (square == 0 && !is_rounding(basis, c)) add_root(group, -c, shape, modes);
    if (square == 0) return;
    if (under < 0) {
        TinkerMode *mode = add_root(group, CMPLX(-half, sqrt(-under)), shape, modes);
        mode->natural = sqrt(square);
        mode->damping_ratio = half / mode->natural;
        return;
    }
    double far = -(half + copysign(sqrt(under), half));
    TinkerMode *pair[] = {add_root(group, square / far, shape, modes), add_root(group, far, shape, modes)};
    for (int k = 0; k < 2 && square > 0; k++) {
        pair[k]->natural = sqrt(square);
        pair[k]->damping_ratio = half / pair[k]->natural;
    }
}

static gboolean add_group(const TinkerModeGroup *group, GPtrArray *modes)
{
    if (group->count == 1 && group->basis->following == NULL) {
        add_single(group, modes);
        return TRUE;
    }
    g_autoptr(GPtrArray) roots = tinker_mode_roots(group);
    if (roots == NULL) return FALSE;
    for (int32_t i = 0; i < group->count; i++)
        if (group->basis->squares[group->members[i]] == 0) add_rigid(group, i, modes);
    for (guint i = 0; i < roots->len; i++) {
        const TinkerModeRoot *root = g_ptr_array_index(roots, i);
        add_root(group, root->s, root->shape, modes);
    }
    return TRUE;
}

static double rate_of(const TinkerMode *mode)
{
    return hypot(mode->decay, mode->frequency);
}

static int compare_modes(const void *left, const void *right)
{
    const TinkerMode *l = *(TinkerMode *const *)left, *r = *(TinkerMode *const *)right;
    double a = rate_of(l), b = rate_of(r);
    if (a != b) return a < b ? -1 : 1;
    return (l->kind > r->kind) - (l->kind < r->kind);
}

/* Two real roots of one oscillator count where the larger one stands, as in the matrix form. */
static void number_modes(const GPtrArray *modes)
{
    guint count = 0;
    for (guint i = 0; i < modes->len; i++) {
        TinkerMode *mode = g_ptr_array_index(modes, i);
        if (mode->kind == TINKER_MODE_OSCILLATION || mode->kind == TINKER_MODE_GROWTH) mode->number = ++count;
        for (guint k = 0; k < i && mode->kind == TINKER_MODE_DECAY && mode->number == 0; k++) {
            TinkerMode *other = g_ptr_array_index(modes, k);
            const gboolean pair = other->kind == TINKER_MODE_DECAY && other->number == 0 &&
                                  other->natural == mode->natural && other->damping_ratio == mode->damping_ratio;
            if (pair) mode->number = other->number = ++count;
        }
    }
}

GPtrArray *tinker_modes_of(const TinkerModalBasis *basis, GError **error)
{
    g_autoptr(GPtrArray) modes = g_ptr_array_new_with_free_func(mode_free);
    g_autofree int32_t *order = g_new0(int32_t, MAX(basis->count, 1));
    g_autoptr(GArray) groups = tinker_mode_groups(basis, order);
    const int32_t *members = order;
    for (guint i = 0; i < groups->len; i++) {
        TinkerModeGroup group = {basis, members, g_array_index(groups, int32_t, i)};
        members += group.count;
        if (add_group(&group, modes)) continue;
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
                    "its modes cannot be worked out: the eigenvalues of its damped motion do not converge");
        return NULL;
    }
    g_ptr_array_sort(modes, compare_modes);
    number_modes(modes);
    return g_steal_pointer(&modes);
}

gboolean tinker_mode_is_standing(const TinkerMode *mode, int32_t size)
{
    for (int32_t i = 0; i < size; i++)
        if (fabs(mode->imaginary[i]) > OUT_OF_STEP) return FALSE;
    return TRUE;
}

double tinker_modes_growth(const GPtrArray *modes)
{
    double growth = 0;
    for (guint i = 0; i < modes->len; i++)
        growth = fmax(growth, -((const TinkerMode *)g_ptr_array_index(modes, i))->decay);
    return growth;
}

const char *tinker_mode_kind_name(TinkerModeKind kind)
{
    static const char *const names[] = {"rigid", "oscillation", "decay", "growth"};
    return names[kind];
}
