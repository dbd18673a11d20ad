/* What typed laws do to energy. */
#include "units/compiled/typed-energy.h"

#include <math.h>
#include <string.h>

#include "law/build.h"
#include "law/derivative.h"
#include "law/integral.h"
#include "law/simplify.h"
#include "law/typed-law.h"
#include "numerics/roots/quadrature.h"

#define COUNTED_FROM  1.0    /* m: where a tension without an antiderivative stores 0 */
#define SUM_TOLERANCE 1e-11  /* of its absolute sum: below it cancellation in a law would be summed up */
#define TRIED_LEAST   0.0625 /* m: lengths at which it has to be a number, by factors of the root of 2 */
#define TRIED_MOST    16.0

static TinkerExpression *rest_of(const char *symbol, G_GNUC_UNUSED void *data)
{
    static const char *const velocities[] = {"rate", "vx", "vy", NULL};
    return g_strv_contains(velocities, symbol) ? tinker_expression_number(0) : NULL;
}

/* The law at rest; 0 where none is typed. (transfer full) */
static TinkerExpression *at_rest(const TinkerExpression *law)
{
    return law != NULL ? tinker_expression_folded(law, rest_of, NULL) : tinker_expression_number(0);
}

/* Takes the energy over, which may be NULL. */
static TinkerStoredEnergy stored_as(const TinkerEnergySource *source, TinkerExpression *energy)
{
    if (energy == NULL) return (TinkerStoredEnergy){NULL, NULL};
    const TinkerStoredEnergy stored = {tinker_compiled_new(energy, source->names, source->count), NULL};
    tinker_expression_unref(energy);
    return stored;
}

static TinkerStoredEnergy of_potential(G_GNUC_UNUSED const TinkerTypedLaw *law, const TinkerEnergySource *source)
{
    return stored_as(source, at_rest(source->laws[0]));
}

static double tension_at_rest(const TinkerTypedLaw *law, double length)
{
    return tinker_compiled_value(law->value, (const double[]){length, 0, 0});
}

static TinkerStatus put_tension(double length, double *value, void *data)
{
    *value = tension_at_rest(data, length);
    return TINKER_OK;
}

static double no_kink(G_GNUC_UNUSED double from, G_GNUC_UNUSED double to, G_GNUC_UNUSED void *data)
{
    return NAN;
}

/* The integral of the tension from COUNTED_FROM to the length; NAN where it is not a number in between. */
static double summed_tension(const TinkerTypedLaw *law, const double *arguments)
{
    const double length = arguments[0];
    double sum = 0, room[3];
    tinker_integrate(put_tension, no_kink, (void *)law, 1, fmin(length, COUNTED_FROM), fmax(length, COUNTED_FROM),
                     SUM_TOLERANCE, 0, &sum, room);
    return !isfinite(sum) ? NAN : length < COUNTED_FROM ? -sum : sum;
}

static gboolean is_a_number_all_along(const TinkerTypedLaw *law)
{
    for (double length = TRIED_LEAST; length <= TRIED_MOST; length *= G_SQRT2)
        if (!isfinite(tension_at_rest(law, length))) return FALSE;
    return TRUE;
}

static TinkerStoredEnergy of_tension(const TinkerTypedLaw *law, const TinkerEnergySource *source)
{
    g_autoptr(TinkerExpression) still = at_rest(source->laws[0]);
    if (tinker_expression_uses(still, "t")) return (TinkerStoredEnergy){NULL, NULL};
    const TinkerStoredEnergy stored = stored_as(source, tinker_expression_integral(still, "L"));
    if (stored.compiled != NULL || !is_a_number_all_along(law)) return stored;
    return (TinkerStoredEnergy){NULL, summed_tension};
}

/* V of force_x = -dV/dx and force_y = -dV/dy; NULL: none is found. (transfer full) */
static TinkerExpression *potential_of(const TinkerExpression *x, const TinkerExpression *y)
{
    g_autoptr(TinkerExpression) along_x = tinker_expression_integral(x, "x");
    if (along_x == NULL) return NULL;
    /* what force_y has beside that is to depend on y alone */
    g_autoptr(TinkerExpression) rest =
        tinker_expression_minus(tinker_expression_ref(y), tinker_expression_derivative_by(along_x, "y"));
    g_autoptr(TinkerExpression) left = tinker_expression_simplified(rest);
    g_autoptr(TinkerExpression) along_y =
        tinker_expression_uses(left, "x") ? NULL : tinker_expression_integral(left, "y");
    if (along_y == NULL) return NULL;
    return tinker_expression_negated(tinker_expression_plus(g_steal_pointer(&along_x), g_steal_pointer(&along_y)));
}

static TinkerStoredEnergy of_forces(G_GNUC_UNUSED const TinkerTypedLaw *law, const TinkerEnergySource *source)
{
    g_autoptr(TinkerExpression) x = at_rest(source->laws[0]), y = at_rest(source->laws[1]);
    const gboolean timed = tinker_expression_uses(x, "t") || tinker_expression_uses(y, "t");
    return stored_as(source, timed ? NULL : potential_of(x, y));
}

/* NULL where its text is empty, or where there is no such property. */
static TinkerTypedLaw *law_of(const TinkerBlockClass *block_class, TinkerTypedLaw *const *laws, const char *id)
{
    for (int32_t p = 0; p < block_class->property_count; p++) {
        const TinkerPropertyType *type = &block_class->properties[p];
        if ((type->flags & TINKER_TEXT_LAW) == 0) continue;
        if (strcmp(type->id, id) == 0) return *laws;
        laws++;
    }
    return NULL;
}

static TinkerExpression *is_of(const TinkerTypedLaw *law)
{
    return law != NULL ? tinker_typed_is(law) : NULL;
}

void tinker_typed_set_energies(const TinkerBlockClass *block_class, TinkerTypedLaw *const *laws)
{
    TinkerTypedLaw *potential = law_of(block_class, laws, "potential"), *tension = law_of(block_class, laws, "tension");
    TinkerTypedLaw *x = law_of(block_class, laws, "force_x"), *y = law_of(block_class, laws, "force_y");
    if (potential != NULL)
        tinker_typed_set_energy(potential, of_potential, (TinkerExpression *const[]){is_of(potential), NULL});
    if (tension != NULL)
        tinker_typed_set_energy(tension, of_tension, (TinkerExpression *const[]){is_of(tension), NULL});
    if (x != NULL || y != NULL)
        tinker_typed_set_energy(x != NULL ? x : y, of_forces, (TinkerExpression *const[]){is_of(x), is_of(y)});
}
