/* The results of a trade: as tables for people, as CSV, and as a work-precision chart. */
#ifndef TINKER_CLI_TRADE_REPORT_H
#define TINKER_CLI_TRADE_REPORT_H

#include <stdio.h>

#include "analysis/trade.h"
#include "render/theme.h"

/* The measurements by method, why some of them failed, and the observed orders. */
void tinker_trade_write_tables(const TinkerTrade *trade, FILE *file);

/* One row a measurement. Write errors stay with the stream. */
void tinker_trade_write_csv(const TinkerTrade *trade, FILE *file);

/* Error over wall time, both logarithmic, one curve a method, the advised point ringed; .png, .svg or .pdf by the
 * ending. */
gboolean tinker_trade_draw_chart(const TinkerTrade *trade, const char *title, const TinkerTheme *theme, int width,
                                 int height, const char *path, GError **error);

#endif
