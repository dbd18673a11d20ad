/* What the chart's two files share. */
#ifndef TINKER_CLI_CHART_PRIVATE_H
#define TINKER_CLI_CHART_PRIVATE_H

#include "cli/report/chart.h"
#include "graph-axis.h"

/* The axis at a place of the record's rows. */
TinkerGraphAxis tinker_chart_axis(const TinkerChart *chart, guint place);

/* Numbers in a row of the record. */
guint tinker_chart_width(const TinkerChart *chart);

#endif
