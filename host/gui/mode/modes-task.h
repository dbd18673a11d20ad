/* The modes of a document's scene about its rest, worked out beside the main thread while somebody wants them. No
 * widget. Signal: "changed", there is another result. */
#ifndef TINKER_GUI_MODES_TASK_H
#define TINKER_GUI_MODES_TASK_H

#include "common/graph/drive-response.h"
#include "gui/document/document.h"

#define TINKER_TYPE_MODES_TASK (tinker_modes_task_get_type())
G_DECLARE_FINAL_TYPE(TinkerModesTask, tinker_modes_task, TINKER, MODES_TASK, GObject)

typedef struct {
    TinkerScene *scene;           /* a copy, which the analysis is of */
    TinkerModeAnalysis *analysis; /* NULL: it failed */
    GPtrArray *responses;         /* of TinkerDriveResponse *: to what drives it; NULL: it failed */
    GError *error;                /* why, or NULL */
} TinkerModesResult;

/* (transfer full) */
TinkerModesTask *tinker_modes_task_new(TinkerDocument *document);

/* Works them out some time after each edit, as long as somebody wants them: who did so with TRUE, ends it with FALSE.
 */
void tinker_modes_task_want(TinkerModesTask *task, gboolean wanted);

/* NULL where there is none yet. Borrowed until "changed" or the next edit. */
const TinkerModesResult *tinker_modes_task_result(TinkerModesTask *task);

#endif
