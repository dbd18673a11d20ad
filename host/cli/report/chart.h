/* A chart: curves of quantities, recorded while a scene runs, then drawn or written as CSV in the units that the scene
 * displays. */
#ifndef TINKER_CLI_CHART_H
#define TINKER_CLI_CHART_H

#include "common/graph/graph-axis.h"
#include "measure/formula.h"
#include "measure/spectrum.h"
#include "physics/record/record.h"
#include "physics/run/simulation.h"
#include "render/draw/theme.h"

/* One curve; x and y are places in a row of the record, whose place 0 is the time and i + 1 the column i. In the place
 * of y there may be a formula or a table. */
typedef struct {
    guint x, y;
    TinkerFormula *formula; /* NULL: y */
    GArray *table;          /* of double, time and value in turn; NULL: of the run */
    char *name;             /* in a legend: "Mass 0.y" */
    char *title;            /* that the axis has, where the scene gives one; NULL */
    TinkerGraphAxis axis;   /* of its values */
    gboolean right;         /* on the second axis */
} TinkerChartCurve;

typedef struct {
    TinkerScene *scene;   /* borrowed */
    GArray *columns;      /* of TinkerColumn: what is recorded */
    GArray *curves;       /* of TinkerChartCurve */
    TinkerRecord *record; /* rows of the time, the columns, and their bands where there are any */
    gboolean has_bands;
    char *title;
    char *run;                    /* what sets this run apart from others in a chart; NULL */
    GPtrArray *others;            /* of TinkerChart: the same curves of other runs; owned */
    const TinkerSceneGraph *axes; /* scales and ranges; borrowed from the scene; NULL */
    gboolean logarithmic[2];      /* asked for besides: x, y */
    gboolean is_spectrum;         /* the scene's graphs are of frequencies */
} TinkerChart;

/* Of which part of the time (s), and how it is weighted. */
typedef struct {
    TinkerWindow window;
    double from, to;
} TinkerSpectrumOptions;

/* A chart without curves, titled like the scene. (transfer full) */
TinkerChart *tinker_chart_new(TinkerScene *scene);
void tinker_chart_free(TinkerChart *chart);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerChart, tinker_chart_free)

/* Adds the curve of "Mass 0.y", or of an expression, which has a name in braces: over time where `against` is NULL or
 * "time" or "frequency", else against a quantity of the same block
 * ("vx") or of any ("Mass 1.x"). Errors: TINKER_SCENE_ERROR_NAME, TINKER_WAVEFORM_ERROR. */
gboolean tinker_chart_add(TinkerChart *chart, const char *name, const char *against, GError **error);

/* The second unit, where curves have two, goes to the axis at the right. */
void tinker_chart_part_axes(TinkerChart *chart);

/* The value of a curve in a row of the record, in SI; of one that is no table. */
double tinker_chart_value(const TinkerChartCurve *curve, const double *row);

/* Adds the graphs that the scene holds: the first, and all others of the same axes. `path` is the scene's file, beside
 * which tables are looked for; the rest is added to `left_out`, of
 * const TinkerSceneGraph *. */
gboolean tinker_chart_add_graphs_of_scene(TinkerChart *chart, const char *path, GPtrArray *left_out, GError **error);

/* Takes a sample of all columns, as a TinkerSampleFunc hands it out. `bands` says how far each may be off (NAN: nobody
 * knows); NULL at all samples or at none. */
gboolean tinker_chart_sample(TinkerChart *chart, double time, const double *values, const double *bands,
                             GError **error);

/* Takes all columns just before and just behind an event that comes after a sample, as a TinkerEventsFunc hands them
 * out: two rows at one time, as far off as that sample may be. Spectra and CSV are of samples alone. */
gboolean tinker_chart_at_event(TinkerChart *chart, double time, const double *before, const double *behind,
                               GError **error);

/* Forgets the samples later than `time`: what a failed run is not to be believed in. */
void tinker_chart_cut(TinkerChart *chart, double time);

/* Draws the chart to .png, .svg or .pdf by the ending. */
gboolean tinker_chart_draw(TinkerChart *chart, const TinkerTheme *theme, int width, int height, const char *path,
                           GError **error);

/* Draws amplitudes over frequency in the place of values over time, and writes them as CSV: "Frequency", in Hz, then a
 * column a curve. */
gboolean tinker_chart_draw_spectrum(TinkerChart *chart, const TinkerSpectrumOptions *options, const TinkerTheme *theme,
                                    int width, int height, const char *path, GError **error);
gboolean tinker_chart_write_spectrum_csv(TinkerChart *chart, const TinkerSpectrumOptions *options, int decimals,
                                         const char *path, GError **error);

/* Writes CSV: "Time", then a column a curve, called like the quantity where there is one curve, else with the block's
 * name before it; x and y of each curve where they are not over time. `decimals` as in csv-writer.h. */
gboolean tinker_chart_write_csv(TinkerChart *chart, int decimals, const char *path, GError **error);

#endif
