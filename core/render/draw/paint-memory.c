/* Nothing here depends on what a block is or where it stands: an edited scene makes a memory longer at most. */
#include "render/draw/paint-memory-content.h"

#include <string.h>

struct _TinkerPaintMemory {
    TinkerTextMemory *texts;
    GByteArray *places; /* by block id */
};

TinkerPaintMemory *tinker_paint_memory_new(void)
{
    TinkerPaintMemory *memory = g_new0(TinkerPaintMemory, 1);
    memory->texts = tinker_text_memory_new();
    memory->places = g_byte_array_new();
    return memory;
}

void tinker_paint_memory_free(TinkerPaintMemory *memory)
{
    if (!memory) return;
    tinker_text_memory_free(memory->texts);
    g_byte_array_unref(memory->places);
    g_free(memory);
}

TinkerTextMemory *tinker_paint_memory_texts(TinkerPaintMemory *memory)
{
    return memory ? memory->texts : NULL;
}

signed char *tinker_paint_memory_places(TinkerPaintMemory *memory, int32_t limit)
{
    if (!memory) return NULL;
    guint before = memory->places->len, after = MAX(before, (guint)MAX(limit, 1));
    g_byte_array_set_size(memory->places, after);
    memset(memory->places->data + before, 0, after - before);
    return (signed char *)memory->places->data;
}
