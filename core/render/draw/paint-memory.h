/* What the pictures of one scene, or of one plot, hand on to the next: texts that are laid out, and on which side of
 * its body each name stands. A picture looks the same without it, and takes longer. */
#ifndef TINKER_CORE_PAINT_MEMORY_H
#define TINKER_CORE_PAINT_MEMORY_H

#include <glib.h>

typedef struct _TinkerPaintMemory TinkerPaintMemory;

/* For one scene as long as it is shown, however it changes; or for any number of plots. For one thread. (transfer full)
 */
TinkerPaintMemory *tinker_paint_memory_new(void);
void tinker_paint_memory_free(TinkerPaintMemory *memory);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerPaintMemory, tinker_paint_memory_free)

#endif
