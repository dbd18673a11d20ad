/* The results of a trade: as tables for people, and as CSV. */
#ifndef TINKER_CLI_TRADE_REPORT_H
#define TINKER_CLI_TRADE_REPORT_H

#include <stdio.h>

#include "analysis/trade/trade.h"

/* The measurements by method, why some of them failed, and the observed orders. */
void tinker_trade_write_tables(const TinkerTrade *trade, FILE *file);

/* One row a measurement. Write errors stay with the stream. */
void tinker_trade_write_csv(const TinkerTrade *trade, FILE *file);

#endif
