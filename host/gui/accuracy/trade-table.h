/* The measurements of a trade as a table; it can be sorted by each column. Signals:
 *   "chosen"   (const TinkerTradeRow *row) a row was activated
 */
#ifndef TINKER_GUI_TRADE_TABLE_H
#define TINKER_GUI_TRADE_TABLE_H

#include <gtk/gtk.h>

#include "analysis/trade/trade.h"

#define TINKER_TYPE_TRADE_TABLE (tinker_trade_table_get_type())
G_DECLARE_FINAL_TYPE(TinkerTradeTable, tinker_trade_table, TINKER, TRADE_TABLE, GtkWidget)

/* The trade is borrowed until another is set; NULL: none. */
void tinker_trade_table_set_trade(TinkerTradeTable *table, const TinkerTrade *trade);

#endif
