/* Fragments: some blocks of a scene as text, for the clipboard.
 *
 * The text is a small scene, {"tinker": 1, "blocks": [...], "graphs": [...]}. A table of a waveform is not in it:
 * within one process the waveforms of the last fragments are kept, so that they can be pasted into any scene, and saved
 * as they were; elsewhere a table is looked for as in any scene without a file.
 */
#ifndef TINKER_CORE_FRAGMENT_H
#define TINKER_CORE_FRAGMENT_H

#include "scene/history/history.h"

/* These blocks and their graphs, in the drawing order. Ends on other blocks become detached at the place they are.
 * (transfer full) */
char *tinker_fragment_to_text(TinkerScene *scene, const TinkerBlockId *blocks, int32_t count);

/* Adds the blocks of a fragment, or of a whole scene, displaced by (dx, dy) m: positions, local origins and places of
 * graphs that are given, and detached ends. Where no step is open it is one of its own. A name that is taken gives way
 * to the type's title and the smallest free number; ends and graphs follow. The new ids are appended to `pasted` (of
 * TinkerBlockId, may be NULL), in the drawing order. FALSE for what is no fragment or holds no blocks: then nothing has
 * changed, and the error says what is wrong and where. */
gboolean tinker_fragment_paste(TinkerHistory *history, const char *text, double dx, double dy, GArray *pasted,
                               GError **error);

#endif
