/* What is in a memory, for painter and plots. */
#ifndef TINKER_RENDER_PAINT_MEMORY_CONTENT_H
#define TINKER_RENDER_PAINT_MEMORY_CONTENT_H

#include "render/draw/paint-memory.h"
#include "render/draw/text.h"

/* The laid out texts; NULL without a memory. Borrowed. */
TinkerTextMemory *tinker_paint_memory_texts(TinkerPaintMemory *memory);

/* For each block id below `limit`, where its name was put: 0 nowhere yet, else the caller's number. NULL without a
 * memory. Borrowed, until the next call. */
signed char *tinker_paint_memory_places(TinkerPaintMemory *memory, int32_t limit);

#endif
