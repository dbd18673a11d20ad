/* Typed laws of a batch: compiled with the numbers of each block. */
#include "scene/frame/batch-laws.h"

#include "law/timed-parts.h"
#include "law/typed-law.h"
#include "scene/frame/batch-waveforms.h"
#include "units/compiled/typed-energy.h"

gboolean tinker_block_batch_is_timed(const TinkerBlockBatch *batch, int32_t row)
{
    for (int32_t k = 0; k < batch->law_count; k++) {
        const TinkerTypedLaw *law = batch->laws[(gsize)row * (gsize)batch->law_count + (gsize)k];
        if (law != NULL && law->depends_on_time) return TRUE;
    }
    return FALSE;
}

gboolean tinker_block_batch_stores(const TinkerBlockBatch *batch, int32_t row)
{
    TinkerTypedLaw *const *laws = batch->laws + (gsize)row * (gsize)batch->law_count;
    for (int32_t k = 0; k < batch->law_count; k++)
        if (laws[k] != NULL && tinker_typed_stores(laws[k])) return TRUE;
    return FALSE;
}

/* The laws of one block; the first that cannot be read is told by the batch. */
static void compile_row(TinkerBlockBatch *batch, int32_t row)
{
    TinkerSceneTexts texts = {batch->scene, batch->ids[row]};
    TinkerTypedLaw **const laws = batch->laws + (gsize)row * (gsize)batch->law_count, **law = laws;
    for (int32_t p = 0; p < batch->block_class->property_count; p++) {
        if ((batch->block_class->properties[p].flags & TINKER_TEXT_LAW) == 0) continue;
        g_autoptr(GError) error = NULL;
        if (tinker_scene_text_of(p, &texts)[0] != '\0')
            *law = tinker_typed_new(batch->block_class, p, tinker_scene_text_of, &texts, &error);
        if (error != NULL && batch->law_fault == NULL)
            batch->law_fault =
                g_strdup_printf("%s: %s", tinker_scene_block_name(batch->scene, texts.block), error->message);
        g_autofree char *note = tinker_typed_note(batch->block_class, p, tinker_scene_text_of, &texts);
        if (note != NULL)
            g_ptr_array_add(batch->law_notes,
                            g_strdup_printf("%s: %s", tinker_scene_block_name(batch->scene, texts.block), note));
        law++;
    }
    tinker_typed_set_energies(batch->block_class, laws);
    batch->has_timed_law = batch->has_timed_law || tinker_block_batch_is_timed(batch, row);
    for (int32_t k = 0; k < batch->law_count; k++)
        batch->has_law_of_velocity = batch->has_law_of_velocity || (laws[k] != NULL && laws[k]->depends_on_velocity);
}

/* What t alone switches in one law; NULL: nothing. (transfer full) */
static TinkerWaveform *switches_of(const TinkerTypedLaw *law)
{
    if (law == NULL || !law->depends_on_time) return NULL;
    g_autoptr(TinkerExpression) timed = tinker_expression_timed_parts(tinker_typed_is(law));
    return timed != NULL ? tinker_waveform_new_switching(timed) : NULL;
}

/* Their breaks are found with those of waveforms. */
static void follow_switches(TinkerBlockBatch *batch)
{
    for (int32_t i = 0; i < batch->count * batch->law_count; i++) {
        g_autoptr(TinkerWaveform) switches = switches_of(batch->laws[i]);
        if (switches != NULL) tinker_block_batch_add_switches(batch, i / batch->law_count, switches);
    }
}

void tinker_block_batch_compile_laws(TinkerBlockBatch *batch)
{
    for (int32_t p = 0; p < batch->block_class->property_count; p++)
        batch->law_count += (batch->block_class->properties[p].flags & TINKER_TEXT_LAW) != 0;
    if (batch->law_count == 0) return;
    batch->law_notes = g_ptr_array_new_with_free_func(g_free);
    batch->laws = g_new0(TinkerTypedLaw *, (gsize)batch->count * (gsize)batch->law_count);
    for (int32_t row = 0; row < batch->count; row++)
        compile_row(batch, row);
    for (int32_t law = 0; law < batch->law_count; law++)
        tinker_typed_join(batch->laws + law, batch->law_count, batch->count);
    if (batch->has_timed_law) follow_switches(batch);
}
