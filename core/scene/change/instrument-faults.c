/* What is wrong with an instrument, in words. */
#include <math.h>

#include "scene/store/quantities.h"
#include "scene/value/reader.h"

static char *range_fault(const TinkerSceneInstrument *instrument, const TinkerNumber *number)
{
    const double ends[2] = {instrument->from, instrument->to};
    if (!(isfinite(ends[0]) && isfinite(ends[1]) && ends[0] < ends[1]))
        return g_strdup("to: it must be greater than from");
    if (!(isfinite(instrument->step) && instrument->step >= 0))
        return g_strdup("step: it must be 0 (any value) or greater");
    for (int i = 0; i < 2; i++) {
        g_autofree char *fault = scene_value_fault(number->type, (double[]){ends[i], ends[i]}, NULL);
        if (fault != NULL) return g_strdup_printf("%s: %s", i == 0 ? "from" : "to", fault);
    }
    return NULL;
}

static char *property_fault(const TinkerScene *scene, TinkerBlockId block, const TinkerSceneInstrument *instrument)
{
    TinkerNumber number;
    if (block == TINKER_NO_BLOCK) return g_strdup("block: a control is of a block, not of the scene");
    if (tinker_scene_block_class(scene, block) == NULL) return NULL; /* nobody knows */
    if (!tinker_scene_find_number(scene, block, instrument->of, &number))
        return g_strdup_printf(
            "property: a %s has no number \"%s\" (of a vector one component is named: \"velocity.x\")",
            tinker_scene_block_type(scene, block), instrument->of);
    if (number.type->flags & (TINKER_READ_ONLY | TINKER_DERIVED))
        return g_strdup_printf("property: %s is worked out, not set", instrument->of);
    if (number.type->kind == TINKER_KIND_SWITCH)
        return instrument->kind == TINKER_INSTRUMENT_SWITCH
                   ? NULL
                   : g_strdup_printf("kind: %s is on or off: its control is a \"switch\"", instrument->of);
    return range_fault(instrument, &number);
}

char *scene_instrument_fault(const TinkerScene *scene, const TinkerSceneInstrument *instrument)
{
    TinkerBlockId block;
    if (instrument->has_place && !(isfinite(instrument->place[0]) && isfinite(instrument->place[1])))
        return g_strdup("place must be finite");
    if (!tinker_scene_find_owner(scene, instrument->block, &block))
        return g_strdup_printf("block: there is no block \"%s\"", instrument->block);
    if (tinker_instrument_controls(instrument)) return property_fault(scene, block, instrument);
    g_autofree char *fault = scene_quantity_fault(scene, block, instrument->of);
    return fault != NULL ? g_strdup_printf("quantity: %s", fault) : NULL;
}
