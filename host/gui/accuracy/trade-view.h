/* The chart of a trade in a widget: hovering reads a point, a click chooses it. Signals:
 *   "chosen"   (const TinkerTradeRow *row)
 */
#ifndef TINKER_GUI_TRADE_VIEW_H
#define TINKER_GUI_TRADE_VIEW_H

#include <gtk/gtk.h>

#include "analysis/trade/trade.h"

#define TINKER_TYPE_TRADE_VIEW (tinker_trade_view_get_type())
G_DECLARE_FINAL_TYPE(TinkerTradeView, tinker_trade_view, TINKER, TRADE_VIEW, GtkDrawingArea)

/* The trade is borrowed until another is set; NULL: none. */
void tinker_trade_view_set_trade(TinkerTradeView *view, const TinkerTrade *trade);

#endif
