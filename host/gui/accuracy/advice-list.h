/* What is wrong or doubtful with the start, kept up to date while a document is edited. No widget.
 *
 * A copy of the scene is looked over by a thread, shortly after the last edit and only at the start of a run. The
 * signal "changed" tells of other findings. */
#ifndef TINKER_GUI_ADVICE_LIST_H
#define TINKER_GUI_ADVICE_LIST_H

#include "analysis/start/advice.h"
#include "gui/document/player.h"

#define TINKER_TYPE_ADVICE_LIST (tinker_advice_list_get_type())
G_DECLARE_FINAL_TYPE(TinkerAdviceList, tinker_advice_list, TINKER, ADVICE_LIST, GObject)

/* Takes references. (transfer full) */
TinkerAdviceList *tinker_advice_list_new(TinkerDocument *document, TinkerPlayer *player);

/* Of TinkerAdvice *, worst first; empty while a run is shown. Blocks may be gone since. Borrowed, valid until
 * "changed". */
const GPtrArray *tinker_advice_list_findings(TinkerAdviceList *list);

/* Does what the button of a finding says, as one step for undo. Errors: TINKER_SCENE_ERROR, where the finding is there
 * no longer; then nothing has changed. */
gboolean tinker_advice_list_repair(TinkerAdviceList *list, guint finding, GError **error);

#endif
