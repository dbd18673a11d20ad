/* What the chart's files share. */
#ifndef TINKER_CLI_CHART_PRIVATE_H
#define TINKER_CLI_CHART_PRIVATE_H

#include "cli/report/chart.h"
#include "common/graph/graph-axis.h"

/* The axis at a place of the record's rows. */
TinkerGraphAxis tinker_chart_axis(const TinkerChart *chart, guint place);

/* Numbers in a row of the record. */
guint tinker_chart_width(const TinkerChart *chart);

/* How far a curve may be off in a row of the record of a chart with bands, SI: the band of its column, or of what its
 * formula is made of; NAN where nobody knows. */
double tinker_chart_band(const TinkerChart *chart, const TinkerChartCurve *curve, const double *row);

/* Appends all samples of a curve, or the rows of its table: times (s) and values in displayed units, double. */
gboolean tinker_chart_read_curve(const TinkerChart *chart, const TinkerChartCurve *curve, GArray *times, GArray *values,
                                 GError **error);

/* The spectrum of one curve; it is the chart's, which outlives it. */
typedef struct {
    const TinkerChartCurve *curve;
    GArray *frequencies, *amplitudes; /* of double: Hz, and displayed units */
} TinkerChartSpectrum;

/* Those of all curves, of TinkerChartSpectrum *; NULL where one has too few samples. (transfer full) */
GPtrArray *tinker_chart_spectra(const TinkerChart *chart, const TinkerSpectrumOptions *options, GError **error);

#endif
