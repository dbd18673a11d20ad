/* What `tinker graph` is asked for, and the curves that come of it. */
#ifndef TINKER_CLI_GRAPH_OPTIONS_H
#define TINKER_CLI_GRAPH_OPTIONS_H

#include "cli/command/options.h"
#include "cli/command/picture.h"
#include "cli/report/chart.h"

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    char *output, *decimals, *against, *log;
    gboolean statistics;
    char **with;
    char **plugin_folders; /* of the command line; borrowed */
    char *from, *to, *json, *spectrum;
} TinkerGraphOptions;

void tinker_graph_options_clear(TinkerGraphOptions *options);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerGraphOptions, tinker_graph_options_clear)

/* How the graph is written. */
typedef struct {
    gboolean csv;
    int decimals;
    int width, height;
    const TinkerTheme *theme;
} TinkerGraphForm;

gboolean tinker_graph_read_form(const TinkerGraphOptions *options, TinkerGraphForm *form, GError **error);

/* Of spectra; refuses what does not go with them. */
gboolean tinker_graph_read_window(const TinkerGraphOptions *options, TinkerWindow *window, GError **error);

/* Which axes are logarithmic: "x", "y" or "xy". */
gboolean tinker_graph_read_log(TinkerChart *chart, const char *axes, GError **error);

/* The interval (s) of statistics and spectra: all of what `from` and `to` hold where nothing is said. */
gboolean tinker_graph_read_interval(const TinkerGraphOptions *options, double *from, double *to, GError **error);

/* The curves that are named, or those of the scene's graphs; warns of what has other axes. */
gboolean tinker_graph_add_curves(TinkerChart *chart, const TinkerGraphOptions *options, const char *path, char **names,
                                 GError **error);

/* What records a chart's curves while a scene runs; what is drawn or measured has its jumps where they are. */
TinkerSampleTaker tinker_graph_taker(TinkerChart *chart, gboolean at_events);

/* The runs of --with, in the chart of this one; `csv`: samples alone. `scenes`, of tinker_graph_scenes_new, keeps
 * theirs. */
gboolean tinker_graph_add_others(TinkerChart *chart, const TinkerGraphOptions *options, gboolean csv,
                                 const TinkerOpenScene *open, char **names, GPtrArray *scenes, GError **error);
GPtrArray *tinker_graph_scenes_new(void);

#endif
