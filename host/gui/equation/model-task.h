/* The equations of a document's scene at the time that the player shows, and the books up to it, worked out in a thread
 * a moment after the last edit or move, and again and again while it plays. No widget.
 *
 * Nothing is worked out before it is asked for. Signals:
 *   "changed"   there is another result
 */
#ifndef TINKER_GUI_MODEL_TASK_H
#define TINKER_GUI_MODEL_TASK_H

#include "equations/balance/books.h"
#include "equations/write/write.h"
#include "gui/document/player.h"

#define TINKER_TYPE_MODEL_TASK (tinker_model_task_get_type())
G_DECLARE_FINAL_TYPE(TinkerModelTask, tinker_model_task, TINKER, MODEL_TASK, GObject)

/* What is known of the scene as it was. */
typedef struct {
    TinkerScene *scene;      /* a copy of it */
    guint64 revision;        /* of the document's history */
    double time, start;      /* s: of the moment; and when the run of this scene starts, 0 but for changes on the way */
    TinkerModelState *state; /* NULL where the scene cannot run: */
    GError *error;           /* why */
    TinkerEquations *equations;
    TinkerMatrixForm *matrix; /* NULL where no plan could be made */
    TinkerAngleForm *angles;
    TinkerBlockId *bodies; /* that were selected, ended by TINKER_NO_BLOCK */
    TinkerBooks *books;    /* of them, from `start` to `time`; NULL where none is selected, or at the start */
    gboolean books_behind; /* they take long: those are there, if any, that were made before */
} TinkerModelResult;

/* Takes references. (transfer full) */
TinkerModelTask *tinker_model_task_new(TinkerDocument *document, TinkerPlayer *player);

/* The last result, or NULL. Borrowed until "changed". */
const TinkerModelResult *tinker_model_task_result(TinkerModelTask *task);

/* Whether somebody looks: else nothing is worked out. */
void tinker_model_task_want(TinkerModelTask *task, gboolean wanted);

/* Whether another result is to come. */
gboolean tinker_model_task_is_due(TinkerModelTask *task);

#endif
