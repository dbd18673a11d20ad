/* Choosing how a document's scene is run, as one step for undo each. No widget. */
#ifndef TINKER_GUI_RUN_CHOICE_H
#define TINKER_GUI_RUN_CHOICE_H

#include "analysis/trade/trade.h"
#include "gui/document/document.h"

/* Uses the method and step or tolerance of a measurement, and contact by events or as impulses. */
gboolean tinker_run_choice_use(TinkerDocument *document, const TinkerTradeRow *row, GError **error);

/* Leaves the choice of the method to the plan. */
gboolean tinker_run_choice_automatic(TinkerDocument *document, GError **error);

/* Records at this interval (s). */
gboolean tinker_run_choice_record(TinkerDocument *document, double interval, GError **error);

/* What has been chosen: "rk4 with a step of 0.005 s". (transfer full) */
char *tinker_run_choice_text(const TinkerTradeSetting *setting);

#endif
