/* Measures speed against accuracy on a document's scene, in a thread. No widget. Signals:
 *   "changed"     it began or ended, there is another result or none any more, or the result has become stale
 *   "progress"    further than before
 */
#ifndef TINKER_GUI_TRADE_TASK_H
#define TINKER_GUI_TRADE_TASK_H

#include "analysis/trade/trade.h"
#include "gui/document/document.h"

#define TINKER_TYPE_TRADE_TASK (tinker_trade_task_get_type())
G_DECLARE_FINAL_TYPE(TinkerTradeTask, tinker_trade_task, TINKER, TRADE_TASK, GObject)

/* Takes a reference of the document. (transfer full) */
TinkerTradeTask *tinker_trade_task_new(TinkerDocument *document);

/* Begins, on the scene as it is now; the advice will be for this error. `seconds` that it may take, about. One that is
 * under way ends without a result. */
void tinker_trade_task_start(TinkerTradeTask *task, double error, double seconds);
/* Ends it soon; what was measured up to then is the result. */
void tinker_trade_task_cancel(TinkerTradeTask *task);
gboolean tinker_trade_task_is_running(TinkerTradeTask *task);
/* Share of the work that is done, 0 to 1. */
double tinker_trade_task_progress(TinkerTradeTask *task);

/* The last result, or NULL. Borrowed until "changed". */
const TinkerTrade *tinker_trade_task_result(TinkerTradeTask *task);
/* What it is about in sentences: the advice, and what errors were measured against. NULL without a result. Borrowed. */
const char *tinker_trade_task_advice(TinkerTradeTask *task);
const char *tinker_trade_task_reference(TinkerTradeTask *task);
/* Why the last one has no result, or NULL. Borrowed. */
const char *tinker_trade_task_failure(TinkerTradeTask *task);
/* Whether the motion of the scene is another than the one that was measured; how it is run does not count. */
gboolean tinker_trade_task_is_stale(TinkerTradeTask *task);

#endif
