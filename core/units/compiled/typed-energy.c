#include "units/compiled/typed-energy.h"

#include <math.h>

struct _TinkerTypedEnergy {
    TinkerExpression *is; /* the law */
    TinkerFindEnergyFunc find;
    TinkerEnergySource source;
    gsize found;
    TinkerStoredEnergy stored;
};

void tinker_typed_keep(TinkerTypedLaw *law, const TinkerExpression *is, const char *const *names)
{
    law->energy = g_new0(TinkerTypedEnergy, 1);
    law->energy->is = tinker_expression_ref(is);
    law->energy->source.names = names;
    law->energy->source.count = law->count;
}

TinkerExpression *tinker_typed_is(const TinkerTypedLaw *law)
{
    return law->energy != NULL ? law->energy->is : NULL;
}

void tinker_typed_set_energy(TinkerTypedLaw *law, TinkerFindEnergyFunc find, TinkerExpression *const laws[2])
{
    TinkerTypedEnergy *energy = law->energy;
    g_return_if_fail(energy != NULL && energy->find == NULL);
    energy->find = find;
    for (int i = 0; i < 2; i++)
        if (laws[i] != NULL) energy->source.laws[i] = tinker_expression_ref(laws[i]);
}

static const TinkerStoredEnergy *stored_by(const TinkerTypedLaw *law)
{
    TinkerTypedEnergy *energy = law->energy;
    if (energy == NULL || energy->find == NULL) return NULL;
    if (g_once_init_enter(&energy->found)) {
        energy->stored = energy->find(law, &energy->source);
        g_once_init_leave(&energy->found, 1);
    }
    return &energy->stored;
}

gboolean tinker_typed_stores(const TinkerTypedLaw *law)
{
    const TinkerStoredEnergy *stored = stored_by(law);
    return stored != NULL && (stored->compiled != NULL || stored->summed != NULL);
}

double tinker_typed_stored(const TinkerTypedLaw *law, const double *arguments)
{
    const TinkerStoredEnergy *stored = stored_by(law);
    if (stored == NULL) return NAN;
    if (stored->compiled != NULL) return tinker_compiled_value(stored->compiled, arguments);
    return stored->summed != NULL ? stored->summed(law, arguments) : NAN;
}

void tinker_typed_energy_free(TinkerTypedEnergy *energy)
{
    if (energy == NULL) return;
    tinker_expression_unref(energy->is);
    for (gsize i = 0; i < G_N_ELEMENTS(energy->source.laws); i++)
        g_clear_pointer(&energy->source.laws[i], tinker_expression_unref);
    tinker_compiled_free(energy->stored.compiled);
    g_free(energy);
}
