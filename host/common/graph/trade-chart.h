/* The work-precision chart of a trade: error over wall time, both logarithmic, one curve a method, the advised point
 * ringed. */
#ifndef TINKER_HOST_TRADE_CHART_H
#define TINKER_HOST_TRADE_CHART_H

#include "analysis/trade/trade.h"
#include "render/plot/plot.h"

typedef struct _TinkerTradeChart TinkerTradeChart;

/* The trade is borrowed and outlives the chart. (transfer full) */
TinkerTradeChart *tinker_trade_chart_new(const TinkerTrade *trade);
void tinker_trade_chart_free(TinkerTradeChart *chart);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerTradeChart, tinker_trade_chart_free)

/* Without a title; its curves are the chart's. */
TinkerPlot tinker_trade_chart_plot(const TinkerTradeChart *chart, const TinkerTheme *theme);

/* The measurement that a point of the plot stands for; NULL: none, it is a limit. Borrowed from the trade. */
const TinkerTradeRow *tinker_trade_chart_row(const TinkerTradeChart *chart, int curve, gsize point);

#endif
