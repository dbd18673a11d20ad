/* tinker plugins check: the conformance kit's results as text, JSON or TAP. */
#include "cli/plugins/plugins-check.h"

#include <stdio.h>
#include <string.h>

#include <cjson/cJSON.h>

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "common/program/exit-status.h"
#include "common/program/plugin-folders.h"
#include "common/program/print.h"
#include "conformance/rule/conformance.h"

static const TinkerVerbHelp check_help = {
    .verb = "plugins check",
    .operands = "FILE.so",
    .summary =
        "Tries every rule of the contract on every block type and integrator of a plugin file, each in a process of\n"
        "its own: a plugin that crashes or hangs has failed that rule. A failure says how to repeat it alone. The "
        "exit\n"
        "status is 4 where a rule has failed.",
    .examples = "  tinker plugins check ./pulley.so\n"
                "  tinker plugins check ./pulley.so --rule energy --type pulley --seed 7\n"
                "  tinker plugins check --list",
    .most_operands = 1,
};

static const char *const formats[] = {"text", "json", "tap", NULL};
enum { FORMAT_TEXT, FORMAT_JSON, FORMAT_TAP };

static const char *const outcomes[] = {"passed", "failed", "skipped"};

typedef struct {
    int format, seed;
    const char *path;
    cJSON *results; /* of JSON, else NULL */
    int counts[3];
    char *subject; /* told last */
} Report;

/* (transfer full) */
static char *command_of(const Report *report, const TinkerConformanceResult *result)
{
    g_autofree char *path = g_shell_quote(report->path);
    g_autofree char *type = result->subject[0] != '\0' ? g_shell_quote(result->subject) : NULL;
    return g_strdup_printf("tinker plugins check %s --rule %s%s%s --seed %d", path, result->rule,
                           type != NULL ? " --type " : "", type != NULL ? type : "", report->seed);
}

static void write_text(Report *report, const TinkerConformanceResult *result)
{
    if (g_strcmp0(report->subject, result->subject) != 0) {
        if (report->subject != NULL) fputc('\n', stdout);
        tinker_print_line(stdout, "%s", result->subject[0] != '\0' ? result->subject : "library");
        g_free(report->subject);
        report->subject = g_strdup(result->subject);
    }
    if (result->text[0] != '\0')
        tinker_print_line(stdout, "  %-8s %-12s %s", outcomes[result->outcome], result->rule, result->text);
    else
        tinker_print_line(stdout, "  %-8s %s", outcomes[result->outcome], result->rule);
    if (result->outcome != TINKER_CONFORMANCE_FAILED) return;
    g_autofree char *command = command_of(report, result);
    tinker_print_line(stdout, "           repeat: %s", command);
}

static void write_tap(const Report *report, const TinkerConformanceResult *result)
{
    const int number = report->counts[0] + report->counts[1] + report->counts[2];
    g_autofree char *text = g_strdelimit(g_strdup(result->text), "\n#", ' ');
    const gboolean skipped = result->outcome == TINKER_CONFORMANCE_SKIPPED;
    tinker_print_line(stdout, "%sok %d - %s%s%s%s%s", result->outcome == TINKER_CONFORMANCE_FAILED ? "not " : "",
                      number, result->subject, result->subject[0] != '\0' ? " " : "", result->rule,
                      skipped ? " # SKIP " : "", skipped ? text : "");
    if (!skipped && text[0] != '\0') tinker_print_line(stdout, "# %s", text);
}

static void add_json(const Report *report, const TinkerConformanceResult *result)
{
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "rule", result->rule);
    cJSON_AddStringToObject(item, "subject", result->subject);
    cJSON_AddStringToObject(item, "outcome", outcomes[result->outcome]);
    cJSON_AddStringToObject(item, "text", result->text);
    if (result->outcome == TINKER_CONFORMANCE_FAILED) {
        g_autofree char *command = command_of(report, result);
        cJSON_AddStringToObject(item, "repeat", command);
    }
    cJSON_AddItemToArray(report->results, item);
}

static void take(const TinkerConformanceResult *result, gpointer data)
{
    Report *report = data;
    report->counts[result->outcome]++;
    if (report->format == FORMAT_JSON)
        add_json(report, result);
    else if (report->format == FORMAT_TAP)
        write_tap(report, result);
    else
        write_text(report, result);
}

static void finish(Report *report)
{
    const int *counts = report->counts;
    if (report->format == FORMAT_TAP) {
        tinker_print_line(stdout, "1..%d", counts[0] + counts[1] + counts[2]);
    } else if (report->format == FORMAT_TEXT) {
        fputc('\n', stdout);
        tinker_print_line(stdout, "%d passed, %d failed, %d do not apply; seed %d", counts[TINKER_CONFORMANCE_PASSED],
                          counts[TINKER_CONFORMANCE_FAILED], counts[TINKER_CONFORMANCE_SKIPPED], report->seed);
    } else {
        cJSON *root = cJSON_CreateObject();
        cJSON_AddStringToObject(root, "library", report->path);
        cJSON_AddNumberToObject(root, "seed", report->seed);
        for (int i = 0; i < 3; i++)
            cJSON_AddNumberToObject(root, outcomes[i], counts[i]);
        cJSON_AddItemToObject(root, "results", g_steal_pointer(&report->results));
        char *text = cJSON_Print(root);
        tinker_print_text(stdout, text);
        cJSON_free(text);
        cJSON_Delete(root);
    }
}

static void list_rules(void)
{
    for (const TinkerConformanceRule *rule = tinker_conformance_rules(); rule->name != NULL; rule++)
        tinker_print_line(stdout, "%-12s %s", rule->name, rule->sentence);
}

static gboolean check_rule(const char *name, GError **error)
{
    g_autoptr(GPtrArray) names = g_ptr_array_new();
    for (const TinkerConformanceRule *rule = tinker_conformance_rules(); rule->name != NULL; rule++)
        g_ptr_array_add(names, (gpointer)rule->name);
    g_ptr_array_add(names, NULL);
    int place;
    return name == NULL || tinker_option_choice("rule", name, (const char *const *)names->pdata, &place, error);
}

typedef struct {
    char *seed, *seconds, *rule, *type, *format;
    gboolean list;
} Options;

static void options_clear(Options *options)
{
    g_free(options->seed);
    g_free(options->seconds);
    g_free(options->rule);
    g_free(options->type);
    g_free(options->format);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Options, options_clear)

static gboolean read_options(const Options *options, Report *report, double *seconds, GError **error)
{
    const TinkerDimension time = TINKER_DIMENSION_TIME;
    if (options->seed != NULL && !tinker_option_integer("seed", options->seed, 0, G_MAXINT, &report->seed, error))
        return FALSE;
    if (options->seconds != NULL && !tinker_option_value("seconds", options->seconds, time, 0.0, TRUE, seconds, error))
        return FALSE;
    if (options->format != NULL && !tinker_option_choice("format", options->format, formats, &report->format, error))
        return FALSE;
    return check_rule(options->rule, error);
}

static gboolean is_no_folder(const char *path, GError **error)
{
    if (!g_file_test(path, G_FILE_TEST_IS_DIR)) return TRUE;
    g_autofree char *hint = tinker_plugin_folder_hint(path);
    g_set_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_FILE, "%s: this is a folder; %s", path, hint);
    return FALSE;
}

static int check_file(const TinkerCommandLine *line, const Options *options)
{
    g_autoptr(GError) error = NULL;
    if (!is_no_folder(line->operands[0], &error)) return tinker_report_error(NULL, error);
    double seconds = TINKER_CONFORMANCE_SECONDS;
    Report report = {.seed = TINKER_CONFORMANCE_SEED, .path = line->operands[0]};
    if (!read_options(options, &report, &seconds, &error)) return tinker_report_error(NULL, error);
    if (report.format == FORMAT_JSON) report.results = cJSON_CreateArray();
    g_autoptr(TinkerCatalogue) catalogue = tinker_open_catalogue(line->plugin_folders);
    const TinkerConformanceOptions how = {(guint32)report.seed, seconds, options->rule, options->type};
    if (report.format == FORMAT_TAP) tinker_print_line(stdout, "# seed %d", report.seed);
    const gboolean tried = tinker_conformance_check(catalogue, report.path, &how, take, &report, &error);
    if (tried || report.counts[TINKER_CONFORMANCE_PASSED] > 0) finish(&report);
    if (!tried && report.format == FORMAT_TAP) tinker_print_line(stdout, "Bail out! %s", error->message);
    cJSON_Delete(report.results);
    g_free(report.subject);
    if (!tried) return tinker_report_error(NULL, error);
    return report.counts[TINKER_CONFORMANCE_FAILED] > 0 ? TINKER_EXIT_PLUGIN : TINKER_EXIT_DONE;
}

int tinker_plugins_check(int argc, char **argv)
{
    g_auto(Options) options = {0};
    const GOptionEntry entries[] = {
        {"rule", 0, 0, G_OPTION_ARG_FILENAME, &options.rule, "Try this rule alone", "NAME"},
        {"type", 0, 0, G_OPTION_ARG_FILENAME, &options.type, "Try this block type or integrator alone", "TYPE"},
        {"seed", 0, 0, G_OPTION_ARG_FILENAME, &options.seed, "Draw other values: a whole number (1)", "N"},
        {"seconds", 0, 0, G_OPTION_ARG_FILENAME, &options.seconds, "Time limit of each try (10)", "S"},
        {"format", 0, 0, G_OPTION_ARG_FILENAME, &options.format, "text, json or tap (text)", "FORMAT"},
        {"list", 0, 0, G_OPTION_ARG_NONE, &options.list, "List the rules, one a line", NULL},
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &check_help, entries, argc, argv, &status)) return status;
    if (options.list) {
        list_rules();
        return TINKER_EXIT_DONE;
    }
    if (line.operand_count == 1) return check_file(&line, &options);
    tinker_report_note("plugins check: a plugin file is needed (see tinker plugins check --help)");
    return TINKER_EXIT_USAGE;
}
