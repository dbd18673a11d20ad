/* Frequencies of what drives the scene, and whether that is near a resonance. */
#include "common/graph/drive-response.h"
#include "gui/property/property-list.h"

/* Whether the row sets the frequency of a waveform of its one block. */
static gboolean is_frequency(TinkerScene *scene, const TinkerPropertyRow *row)
{
    if (row->kind != TINKER_ROW_NUMBER || row->blocks->len != 1) return FALSE;
    const TinkerBlockId block = g_array_index(row->blocks, TinkerBlockId, 0);
    const TinkerBlockClass *block_class =
        tinker_scene_has_block(scene, block) ? tinker_scene_block_class(scene, block) : NULL;
    if (block_class == NULL || row->property < 0 || row->property >= block_class->property_count) return FALSE;
    const char *id = block_class->properties[row->property].id;
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *type = &block_class->properties[i];
        if (type->kind == TINKER_KIND_WAVEFORM && g_strcmp0(type->frequency, id) == 0) return TRUE;
    }
    return FALSE;
}

gboolean tinker_property_list_hint_resonances(GPtrArray *rows, TinkerScene *scene, const GPtrArray *responses)
{
    gboolean any = FALSE;
    for (guint i = 0; i < rows->len; i++) {
        TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        if (!is_frequency(scene, row)) continue;
        const char *name = tinker_scene_block_name(scene, g_array_index(row->blocks, TinkerBlockId, 0));
        any = TRUE;
        for (guint k = 0; responses != NULL && k < responses->len; k++) {
            const TinkerDriveResponse *response = g_ptr_array_index(responses, k);
            if (g_strcmp0(response->drive, name) != 0) continue;
            g_free(row->hint);
            row->hint = tinker_drive_response_hint(response);
        }
    }
    return any;
}
