/* From the command line to a run. */
#include "cli/command/run-arguments.h"

#include "cli/command/options.h"
#include "common/program/exit-status.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

/* What the summary calls the method of contact as impulses. */
#define IMPULSE "impulse"

static const TinkerDimension time_dimension = TINKER_DIMENSION_TIME;
static const TinkerDimension no_dimension = TINKER_DIMENSION_NONE;

void tinker_run_arguments_clear(TinkerRunArguments *arguments)
{
    g_clear_pointer(&arguments->duration, g_free);
    g_clear_pointer(&arguments->interval, g_free);
    g_clear_pointer(&arguments->method, g_free);
    g_clear_pointer(&arguments->contacts, g_free);
    g_clear_pointer(&arguments->step, g_free);
    g_clear_pointer(&arguments->tolerance, g_free);
    g_clear_pointer(&arguments->accuracy, g_free);
}

static gboolean apply_contacts(const char *text, TinkerRunOptions *options, GError **error)
{
    options->impulses = g_str_equal(text, "impulse");
    if (options->impulses || g_str_equal(text, "events")) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--contacts is \"%s\" (it must be events or impulse)",
                text);
    return FALSE;
}

/* An accuracy stands in the place of step and tolerance, and is held by the estimate: of what excludes each other on
 * the command line both cannot be meant; what it says goes before what the scene says. */
static gboolean apply_accuracy(const TinkerRunArguments *arguments, TinkerRunOptions *options, GError **error)
{
    const char *other = arguments->step != NULL        ? "--step"
                        : arguments->tolerance != NULL ? "--tolerance"
                        : arguments->no_estimate       ? "--no-estimate"
                                                       : NULL;
    if (arguments->accuracy == NULL) {
        if (other != NULL) options->accuracy = 0;
        return TRUE;
    }
    if (other != NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                    "--accuracy and %s exclude each other (%s; leave one of them out)", other,
                    arguments->no_estimate && g_str_equal(other, "--no-estimate")
                        ? "it is the error estimate that is held to the accuracy"
                        : "an accuracy chooses step and tolerance itself");
        return FALSE;
    }
    if (!tinker_option_value("accuracy", arguments->accuracy, no_dimension, 0, TRUE, &options->accuracy, error))
        return FALSE;
    if (options->accuracy < 1) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                "--accuracy \"%s\": must be less than 1 (it is a share of the motion's size, as in 1e-6)",
                arguments->accuracy);
    return FALSE;
}

gboolean tinker_run_arguments_apply(const TinkerRunArguments *arguments, TinkerScene *scene, TinkerRunOptions *options,
                                    GError **error)
{
    *options = tinker_run_options_of(scene);
    const struct {
        const char *option;
        const char *text;
        TinkerDimension dimension;
        double *value;
    } numbers[] = {
        {"duration", arguments->duration, time_dimension, &options->duration},
        {"interval", arguments->interval, time_dimension, &options->interval},
        {"step", arguments->step, time_dimension, &options->step},
        {"tolerance", arguments->tolerance, no_dimension, &options->tolerance},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(numbers); i++)
        if (numbers[i].text != NULL && !tinker_option_value(numbers[i].option, numbers[i].text, numbers[i].dimension, 0,
                                                            TRUE, numbers[i].value, error))
            return FALSE;
    if (arguments->method != NULL) options->method = arguments->method;
    if (arguments->contacts != NULL && !apply_contacts(arguments->contacts, options, error)) return FALSE;
    if (arguments->no_estimate) options->estimate = FALSE;
    return apply_accuracy(arguments, options, error);
}

static int by_value(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

GArray *tinker_run_arguments_times(const char *text, GError **error)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_auto(GStrv) parts = g_strsplit(text, ",", -1);
    for (char **part = parts; *part != NULL; part++) {
        double time = 0;
        if (*g_strstrip(*part) == '\0') {
            g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                        "entry %d of --at is empty (as in --at 0,0.5,2)", (int)(part - parts) + 1);
            return NULL;
        }
        if (!tinker_option_value("at", *part, time_dimension, 0, FALSE, &time, error)) return NULL;
        g_array_append_val(times, time);
    }
    if (times->len == 0) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--at: no time is given (as in --at 0,0.5,2)");
        return NULL;
    }
    qsort(times->data, times->len, sizeof(double), by_value);
    guint kept = 1;
    for (guint i = 1; i < times->len; i++) {
        double time = g_array_index(times, double, i);
        if (time > g_array_index(times, double, kept - 1)) g_array_index(times, double, kept++) = time;
    }
    g_array_set_size(times, kept);
    return g_steal_pointer(&times);
}

void tinker_run_arguments_blame(const TinkerRunArguments *arguments, GError **error)
{
    const char *const given[] = {arguments->duration, arguments->interval,  arguments->method,
                                 arguments->step,     arguments->tolerance, arguments->accuracy};
    if (!g_error_matches(*error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD)) return;
    for (gsize i = 0; i < G_N_ELEMENTS(given); i++)
        if (given[i] != NULL) {
            tinker_blame_option(NULL, error);
            return;
        }
}

gboolean tinker_scene_run_prepare(TinkerSceneRun *run, TinkerScene *scene, const TinkerRunArguments *arguments,
                                  TinkerRunOptions *options, GError **error)
{
    run->progress = tinker_progress_start("running");
    run->automatic = g_str_equal(options->method, "auto");
    options->cancelled = tinker_progress_interrupted;
    options->progress = tinker_progress_of_run;
    options->data = &run->progress;

    g_autoptr(GError) reason = NULL;
    run->model = tinker_model_new(scene, &reason);
    if (run->model != NULL) run->simulation = tinker_simulation_new(run->model, options, &reason);
    if (run->simulation != NULL) {
        run->automatic &= !g_str_equal(tinker_simulation_summary(run->simulation)->method, IMPULSE);
        return TRUE;
    }
    tinker_run_arguments_blame(arguments, &reason);
    g_propagate_error(error, g_steal_pointer(&reason));
    return FALSE;
}

gboolean tinker_scene_run_go(TinkerSceneRun *run, const GArray *columns, const TinkerSampleTaker *taker, GError **error)
{
    tinker_progress_catch_interrupt();
    gboolean done = tinker_accurate_run(&run->simulation, columns, taker, error);
    tinker_progress_end(&run->progress);
    return done;
}

void tinker_scene_run_clear(TinkerSceneRun *run)
{
    g_clear_pointer(&run->until, tinker_until_free);
    g_clear_pointer(&run->simulation, tinker_simulation_free);
    g_clear_pointer(&run->model, tinker_model_free);
}

static void add_once(GPtrArray *texts, const GPtrArray *more)
{
    for (guint i = 0; i < more->len; i++)
        if (!g_ptr_array_find_with_equal_func(texts, g_ptr_array_index(more, i), g_str_equal, NULL))
            g_ptr_array_add(texts, g_strdup(g_ptr_array_index(more, i)));
}

/* The step or the tolerance of the command line where the method does not take it. */
static void add_idle_options(GPtrArray *warnings, const TinkerSceneRun *run, const TinkerSummary *summary,
                             const TinkerRunArguments *arguments)
{
    gboolean neither = g_str_equal(summary->method, "exact");
    if (arguments->method != NULL && g_str_equal(summary->method, IMPULSE))
        g_ptr_array_add(warnings,
                        g_strdup("--method has no effect: contact is asked for as impulses (--contacts events)"));
    if (g_strcmp0(arguments->contacts, IMPULSE) == 0 && !g_str_equal(summary->method, IMPULSE))
        g_ptr_array_add(warnings, g_strdup("--contacts has no effect: there is nothing that could touch"));
    if (arguments->step != NULL && run->automatic)
        g_ptr_array_add(warnings, g_strdup("--step has no effect: auto chooses steps by --tolerance (name a method "
                                           "that takes one: --method rk4)"));
    else if (arguments->step != NULL && neither)
        g_ptr_array_add(warnings, g_strdup("--step has no effect: exact goes from sample to sample"));
    else if (arguments->step != NULL && summary->adaptive)
        g_ptr_array_add(warnings,
                        g_strdup_printf("--step has no effect: %s chooses its steps by --tolerance", summary->method));
    if (arguments->tolerance == NULL || run->automatic || summary->adaptive) return;
    g_ptr_array_add(warnings, neither ? g_strdup("--tolerance has no effect: exact is as good as rounding allows")
                                      : g_strdup_printf("--tolerance has no effect: %s takes --step", summary->method));
}

GPtrArray *tinker_scene_run_warnings(const TinkerSceneRun *run, const TinkerOpenScene *open,
                                     const TinkerRunArguments *arguments)
{
    GPtrArray *warnings = g_ptr_array_new_with_free_func(g_free);
    const TinkerSummary *summary = tinker_simulation_summary(run->simulation);
    add_once(warnings, open->warnings);
    const GPtrArray *more[] = {tinker_model_warnings(run->model), summary->warnings};
    for (gsize i = 0; i < G_N_ELEMENTS(more); i++) {
        g_autoptr(GPtrArray) texts = tinker_warnings_texts(more[i]);
        add_once(warnings, texts);
    }
    add_idle_options(warnings, run, summary, arguments);
    return warnings;
}

void tinker_scene_run_report_warnings(const TinkerSceneRun *run, const TinkerOpenScene *open,
                                      const TinkerRunArguments *arguments)
{
    g_autoptr(GPtrArray) warnings = tinker_scene_run_warnings(run, open, arguments);
    for (guint i = 0; i < warnings->len; i++)
        tinker_report_warning("%s", (const char *)g_ptr_array_index(warnings, i));
}
