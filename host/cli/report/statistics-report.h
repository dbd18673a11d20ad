/* Statistics of the curves of a chart, as a table for people and as JSON. */
#ifndef TINKER_CLI_STATISTICS_REPORT_H
#define TINKER_CLI_STATISTICS_REPORT_H

#include <stdio.h>

#include "cli/report/chart.h"
#include "measure/statistics.h"

/* Works out the statistics of every curve over time, from `from` to `to` (s), in the units that the scene displays.
 * Both files may be NULL. */
gboolean tinker_statistics_report(const TinkerChart *chart, double from, double to, FILE *text, FILE *json,
                                  GError **error);

#endif
