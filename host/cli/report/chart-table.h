/* Charts of runs that were recorded before, as `tinker run --csv` writes them. */
#ifndef TINKER_CLI_CHART_TABLE_H
#define TINKER_CLI_CHART_TABLE_H

#include "cli/report/chart.h"

/* A chart of the same curves as `like`, with the values of a CSV file: its columns are found by their headings,
 * "Mass 0.x [m]", and are in SI. (transfer full) */
TinkerChart *tinker_chart_of_table(const TinkerChart *like, char **names, const char *against, const char *path,
                                   GError **error);

#endif
