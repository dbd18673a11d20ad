#include "units/compiled/typed-energy.h"

#include <math.h>

struct _TinkerTypedEnergy {
    TinkerFindEnergyFunc find;
    TinkerEnergySource source;
    gsize found;
    TinkerStoredEnergy stored;
};

void tinker_typed_set_energy(TinkerTypedLaw *law, TinkerFindEnergyFunc find, const TinkerEnergySource *source)
{
    TinkerTypedEnergy *energy = g_new0(TinkerTypedEnergy, 1);
    energy->find = find;
    energy->source = *source;
    for (gsize i = 0; i < G_N_ELEMENTS(source->laws); i++)
        if (source->laws[i] != NULL) energy->source.laws[i] = tinker_expression_ref(source->laws[i]);
    tinker_typed_energy_free(law->energy);
    law->energy = energy;
}

static const TinkerStoredEnergy *stored_by(const TinkerTypedLaw *law)
{
    TinkerTypedEnergy *energy = law->energy;
    if (energy == NULL) return NULL;
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
    for (gsize i = 0; i < G_N_ELEMENTS(energy->source.laws); i++)
        g_clear_pointer(&energy->source.laws[i], tinker_expression_unref);
    tinker_compiled_free(energy->stored.compiled);
    g_free(energy);
}
