/* Reading the options of `tinker graph`. */
#include "cli/verb/graph-options.h"

#include "cli/command/output.h"
#include "common/program/exit-status.h"

void tinker_graph_options_clear(TinkerGraphOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    g_free(options->output);
    g_free(options->decimals);
    g_free(options->against);
    g_free(options->log);
    g_free(options->from);
    g_free(options->to);
    g_free(options->json);
    g_free(options->spectrum);
    g_strfreev(options->with);
}

gboolean tinker_graph_read_form(const TinkerGraphOptions *options, TinkerGraphForm *form, GError **error)
{
    static const char *const endings[] = {".csv", ".png", ".svg", ".pdf", NULL};
    *form = (TinkerGraphForm){.decimals = -1, .width = 800, .height = 500};
    if (options->decimals != NULL &&
        !tinker_option_integer("decimals", options->decimals, 0, 17, &form->decimals, error))
        return FALSE;
    if (!tinker_picture_arguments_read(&options->picture, &form->width, &form->height, &form->theme, error))
        return FALSE;
    int place = tinker_is_standard_stream(options->output) ? 0 : tinker_picture_ending(options->output, endings, error);
    form->csv = place == 0;
    return place >= 0;
}

gboolean tinker_graph_read_window(const TinkerGraphOptions *options, TinkerWindow *window, GError **error)
{
    *window = g_strcmp0(options->spectrum, "none") == 0 ? TINKER_WINDOW_RECTANGULAR : TINKER_WINDOW_HANN;
    const char *wrong = NULL;
    if (options->spectrum == NULL) return TRUE;
    if (!g_str_equal(options->spectrum, "hann") && !g_str_equal(options->spectrum, "none"))
        wrong = "it must be hann or none";
    else if (options->against != NULL || options->with != NULL)
        wrong = "a spectrum is of curves over time, and of one run: leave out --against and --with";
    if (wrong == NULL) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--spectrum %s: %s", options->spectrum, wrong);
    return FALSE;
}

gboolean tinker_graph_read_log(TinkerChart *chart, const char *axes, GError **error)
{
    for (const char *axis = axes; axis != NULL && *axis != '\0'; axis++) {
        if (*axis != 'x' && *axis != 'y') {
            g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--log is \"%s\" (it must be x, y or xy)",
                        axes);
            return FALSE;
        }
        chart->logarithmic[*axis == 'y'] = TRUE;
    }
    return TRUE;
}

gboolean tinker_graph_read_interval(const TinkerGraphOptions *options, double *from, double *to, GError **error)
{
    static const TinkerDimension time = {.time = 1};
    if (options->from != NULL && !tinker_option_value("from", options->from, time, 0, FALSE, from, error)) return FALSE;
    if (options->to != NULL && !tinker_option_value("to", options->to, time, 0, TRUE, to, error)) return FALSE;
    if (*from < *to) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--from and --to leave nothing (from %g s to %g s)",
                *from, *to);
    return FALSE;
}
