/* Words for the measurements of a trade. */
#ifndef TINKER_HOST_TRADE_WORDS_H
#define TINKER_HOST_TRADE_WORDS_H

#include "analysis/trade/trade.h"

/* "0.01 s" of a step, "1e-09" of a tolerance, nothing where the method takes neither. (transfer full) */
char *tinker_trade_value_text(const TinkerTradeSetting *setting);

/* What is to be said of a row: that it is advised, that its error is at the reference's limit, that it has no result;
 * `in_full` with the reason. May be empty. (transfer full) */
char *tinker_trade_note_text(const TinkerTradeRow *row, gboolean in_full);

#endif
