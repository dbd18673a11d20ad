/* Setting the waveform that a row stands for, where need be of a block that is attached for it. */
#include <glib/gi18n.h>

#include "gui/property/property-rows.h"

/* Which waveform, and of which scene. */
typedef struct {
    TinkerScene *scene;
    TinkerWaveform *waveform; /* NULL: each block's own as an expression */
} Wanted;

static double value_of(TinkerScene *scene, TinkerBlockId block, const char *id, double otherwise)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    int32_t property = id != NULL ? tinker_block_class_property(block_class, id) : -1;
    return property < 0 ? otherwise : tinker_scene_get(scene, block, block_class->first_columns[property]);
}

/* The function that the waveform is now, as an expression to start from. (transfer full) */
static TinkerWaveform *as_expression(TinkerScene *scene, TinkerBlockId block, int32_t property)
{
    const TinkerPropertyType *type = &tinker_scene_block_class(scene, block)->properties[property];
    TinkerWaveformKind kind = tinker_waveform_kind(tinker_scene_get_waveform(scene, block, property));
    if (kind != TINKER_WAVEFORM_SINE && kind != TINKER_WAVEFORM_COSINE)
        return tinker_waveform_new_expression("0", NULL);
    char amplitude[32], frequency[32], phase[32];
    double shift = value_of(scene, block, type->phase, 0);
    tinker_number_to_text(value_of(scene, block, type->amplitude, 1), amplitude, sizeof amplitude);
    tinker_number_to_text(value_of(scene, block, type->frequency, 1), frequency, sizeof frequency);
    tinker_number_to_text(shift, phase, sizeof phase);
    g_autofree char *text =
        g_strdup_printf("%s*%s(%s*t%s%s%s)", amplitude, kind == TINKER_WAVEFORM_SINE ? "sin" : "cos", frequency,
                        shift != 0 ? " + (" : "", shift != 0 ? phase : "", shift != 0 ? ")" : "");
    TinkerWaveform *waveform = tinker_waveform_new_expression(text, NULL);
    return waveform != NULL ? waveform : tinker_waveform_new_expression("0", NULL);
}

static gboolean edit_waveform(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                              gconstpointer data, GError **error)
{
    const Wanted *wanted = data;
    g_autoptr(TinkerWaveform) waveform = wanted->waveform != NULL ? tinker_waveform_ref(wanted->waveform)
                                                                  : as_expression(wanted->scene, block, row->property);
    tinker_history_set_waveform(history, block, row->property, waveform);
    return TRUE;
}

/* Adds a block of the row's class, attached to this one by the end that asks for its panel. */
static gboolean attach_block(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                             gconstpointer data, GError **error)
{
    const TinkerBlockClass *block_class = row->data;
    GError *cause = NULL;
    TinkerBlockId added = tinker_history_add_block(history, block_class, NULL, &cause);
    TinkerSceneEnd end = {block, 0, 0};
    if (added != TINKER_NO_BLOCK &&
        tinker_history_set_end(history, added, block_class->properties[row->property].panel, end, &cause))
        return edit_waveform(history, row, added, data, error);
    property_fail(error, cause, NULL, NULL);
    return FALSE;
}

gboolean property_set_waveform(TinkerDocument *document, const TinkerPropertyRow *row, TinkerWaveform *waveform,
                               GError **error)
{
    Wanted wanted = {tinker_document_scene(document), waveform};
    return property_edit_all(document, row, row->data != NULL ? attach_block : edit_waveform, &wanted, error);
}
