/* What the chart's two files share. */
#ifndef TINKER_CLI_CHART_PRIVATE_H
#define TINKER_CLI_CHART_PRIVATE_H

#include "chart.h"

/* What stands on one axis of one curve. */
typedef struct {
    const char *title; /* "Time", "Y Position" */
    const char *unit;  /* displayed, "ft" */
    double per_si;     /* displayed value = SI value * per_si */
    TinkerDimension dimension;
    TinkerBlockId block; /* TINKER_NO_BLOCK: time */
} TinkerChartAxis;

/* The axis at a place of the record's rows. */
TinkerChartAxis tinker_chart_axis(const TinkerChart *chart, guint place);

/* Numbers in a row of the record. */
guint tinker_chart_width(const TinkerChart *chart);

#endif
