/* tinker modes: natural frequencies, damping ratios, mode shapes and frequency responses of a scene. */
#include "cli/verb/verbs.h"

#include <math.h>
#include <string.h>

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "cli/report/mode-report.h"
#include "common/program/exit-status.h"

#define DEFAULT_COUNT  10
#define DEFAULT_POINTS 400

static const TinkerVerbHelp help = {
    .verb = "modes",
    .operands = "SCENE [\"BLOCK.QUANTITY\"]",
    .summary =
        "Works out how a scene moves of itself, a little, about its rest or its start: natural frequencies, damping\n"
        "ratios and mode shapes. -o draws one picture a mode, FILE-1.png, FILE-2.png, ... With --response it works\n"
        "out how a quantity answers a motor's force or a support's motion at all frequencies (the transmissibility,\n"
        "for a support); -o then draws amplitude and phase, or writes them as .csv.",
    .examples = "  tinker modes double-pendulum.tinker.json\n"
                "  tinker modes spring-mass-network.tinker.json --count 6 -o modes.png --json modes.json\n"
                "  tinker modes tuned-mass-damper.tinker.json --response \"Motor with absorber\" \\\n"
                "      \"Main mass with absorber.x\" -o response.svg",
    .least_operands = 1,
    .most_operands = 2,
};

typedef struct {
    TinkerPictureArguments picture;
    char *state, *count, *json, *output, *response, *from, *to, *points;
    gboolean linear;
} ModesOptions;

static void modes_options_clear(ModesOptions *options)
{
    tinker_picture_arguments_clear(&options->picture);
    char *texts[] = {options->state,    options->count, options->json, options->output,
                     options->response, options->from,  options->to,   options->points};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(ModesOptions, modes_options_clear)

/* What was asked for, read. */
typedef struct {
    gboolean about_rest;
    int count; /* 0: not given */
    int width, height;
    const TinkerTheme *theme;
    gboolean csv;
    TinkerModeResponseWish response;
} Wishes;

/* A plain number is in Hz. */
static gboolean read_frequency(const char *option, const char *text, double *omega, GError **error)
{
    static const TinkerDimension dimension = TINKER_DIMENSION_ANGULAR_FREQUENCY;
    if (text == NULL) return TRUE;
    char *end = NULL;
    g_ascii_strtod(text, &end);
    g_autofree char *with_unit = *text != '\0' && *end == '\0' ? g_strdup_printf("%s Hz", text) : g_strdup(text);
    return tinker_option_value(option, with_unit, dimension, 0, TRUE, omega, error);
}

static gboolean refuse(GError **error, const char *message)
{
    g_set_error_literal(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, message);
    return FALSE;
}

static gboolean read_output(const ModesOptions *options, Wishes *wishes, GError **error)
{
    static const char *const pictures[] = {".png", ".svg", ".pdf", NULL};
    static const char *const responses[] = {".csv", ".png", ".svg", ".pdf", NULL};
    if (options->output == NULL) return TRUE;
    wishes->csv = options->response != NULL && tinker_is_standard_stream(options->output);
    if (wishes->csv) return TRUE;
    int place = tinker_picture_ending(options->output, options->response != NULL ? responses : pictures, error);
    wishes->csv = options->response != NULL && place == 0;
    return place >= 0;
}

static gboolean read_response(const ModesOptions *options, const char *quantity, Wishes *wishes, GError **error)
{
    wishes->response = (TinkerModeResponseWish){
        .input = options->response, .output = quantity, .points = DEFAULT_POINTS, .linear = options->linear};
    if (options->response != NULL && quantity == NULL)
        return refuse(error, "--response: the quantity that answers is missing (as in --response \"Motor 0\" \"Mass "
                             "0.x\")");
    if (options->response == NULL && quantity != NULL)
        return refuse(error, "a quantity is given but no --response that it would answer to (as in --response "
                             "\"Motor 0\" \"Mass 0.x\")");
    if (options->response == NULL &&
        (options->from != NULL || options->to != NULL || options->points != NULL || options->linear))
        return refuse(error, "--from, --to, --points and --linear belong to a --response; none is asked for");
    if (options->points != NULL &&
        !tinker_option_integer("points", options->points, 2, 100000, &wishes->response.points, error))
        return FALSE;
    return read_frequency("from", options->from, &wishes->response.from, error) &&
           read_frequency("to", options->to, &wishes->response.to, error);
}

static gboolean read_wishes(const ModesOptions *options, const char *quantity, Wishes *wishes, GError **error)
{
    static const char *const states[] = {"rest", "start", NULL};
    int state = 0;
    *wishes = (Wishes){.width = 800, .height = 600};
    if (options->state != NULL && !tinker_option_choice("state", options->state, states, &state, error)) return FALSE;
    if (options->count != NULL && !tinker_option_integer("count", options->count, 1, 100000, &wishes->count, error))
        return FALSE;
    wishes->about_rest = state == 0;
    return tinker_picture_arguments_read(&options->picture, &wishes->width, &wishes->height, &wishes->theme, error) &&
           read_response(options, quantity, wishes, error) && read_output(options, wishes, error);
}

/* Of the catalogue, the reader and the model, and whether rest was found. (transfer full) */
static GPtrArray *collect_warnings(const TinkerOpenScene *open, const TinkerModeAnalysis *analysis,
                                   const Wishes *wishes)
{
    GPtrArray *warnings = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GPtrArray) of_model = tinker_warnings_texts(tinker_model_warnings(analysis->model));
    const GPtrArray *sources[] = {open->warnings, of_model};
    for (gsize i = 0; i < G_N_ELEMENTS(sources); i++)
        for (guint k = 0; k < sources[i]->len; k++)
            g_ptr_array_add(warnings, g_strdup(g_ptr_array_index(sources[i], k)));
    if (wishes->about_rest && !analysis->about_rest)
        g_ptr_array_add(warnings, g_strdup_printf("no rest state was found: %s; the modes are those of the start "
                                                  "places, held still (what --state start asks for)",
                                                  analysis->rest.why));
    if (!wishes->about_rest && analysis->linear->undefined_pulls > 0)
        g_ptr_array_add(warnings,
                        g_strdup("ends are at one place where a force pulls: it has no direction there, and the "
                                 "modes are those without it"));
    if (analysis->linear->rubbing_pins > 0)
        g_ptr_array_add(warnings,
                        g_strdup("pins have friction, which holds them still where they hardly turn: the modes "
                                 "are those without it"));
    if (analysis->linear->undefined_dampers > 0)
        g_ptr_array_add(warnings, g_strdup("the ends of what resists are at one place: the resistance has no direction "
                                           "there, and the modes are those without it"));
    return warnings;
}

static gboolean write_json(const TinkerModeReport *report, const char *path, GError **error)
{
    g_auto(TinkerOutput) output = {0};
    if (!tinker_output_open(&output, path, error)) return FALSE;
    tinker_mode_report_write_json(report, output.file);
    return tinker_output_close(&output, error);
}

static gboolean write_output(const TinkerModeReport *report, const Wishes *wishes, const char *path, GError **error)
{
    if (wishes->csv) return tinker_mode_response_write_csv(report->response, path, error);
    if (report->response != NULL)
        return tinker_mode_response_draw(report->response, wishes->theme, wishes->width, wishes->height, path, error);
    return tinker_mode_report_draw(report, wishes->theme, wishes->width, wishes->height, path, error);
}

/* Before anything is written: `pictures` is how many the modes have. */
static gboolean add_outputs(const ModesOptions *options, const TinkerOpenScene *open, guint pictures, GError **error)
{
    const gboolean drawn = options->output != NULL && options->response == NULL;
    const TinkerAskedOutput outputs[] = {
        {"--json", options->json}, {"--output", drawn ? NULL : options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    return tinker_outputs_add(files, outputs, error) &&
           (!drawn || tinker_mode_pictures_add(files, options->output, pictures, error));
}

static gboolean modes(const ModesOptions *options, const TinkerOpenScene *open, const char *quantity, GError **error)
{
    Wishes wishes;
    g_auto(TinkerModeResponse) response = {0};
    if (!read_wishes(options, quantity, &wishes, error)) return FALSE;
    g_autoptr(TinkerModeAnalysis) analysis = tinker_mode_analysis_new(open->scene, wishes.about_rest, error);
    if (analysis == NULL) return FALSE;
    if (wishes.response.input != NULL &&
        !tinker_mode_response_make(&response, analysis, open->scene, &wishes.response, error))
        return FALSE;
    g_autoptr(GPtrArray) warnings = collect_warnings(open, analysis, &wishes);
    TinkerModeReport report = {open->scene, analysis, analysis->modes->len,
                               wishes.response.input != NULL ? &response : NULL, warnings};
    if (wishes.count > 0) report.count = MIN(report.count, (guint)wishes.count);
    const guint shown = wishes.count > 0 ? report.count : MIN(report.count, DEFAULT_COUNT);
    if (!add_outputs(options, open, shown, error)) return FALSE;
    for (guint i = 0; i < warnings->len; i++)
        tinker_report_warning("%s", (const char *)g_ptr_array_index(warnings, i));
    if (options->json != NULL && !write_json(&report, options->json, error)) return FALSE;
    report.count = shown;
    if (options->output != NULL && !write_output(&report, &wishes, options->output, error)) return FALSE;
    gboolean taken = tinker_is_standard_stream(options->json) || tinker_is_standard_stream(options->output);
    tinker_mode_report_write_text(&report, taken ? stderr : stdout);
    return TRUE;
}

/* `--response INPUT OUTPUT SCENE` leaves the two operands in this order: the scene is the one that is a file. */
static void put_scene_first(const TinkerCommandLine *line)
{
    if (line->operand_count < 2 || g_file_test(line->operands[0], G_FILE_TEST_EXISTS) ||
        tinker_is_standard_stream(line->operands[0]))
        return;
    if (!g_file_test(line->operands[1], G_FILE_TEST_EXISTS) && !tinker_is_standard_stream(line->operands[1])) return;
    char *quantity = line->operands[0];
    line->operands[0] = line->operands[1];
    line->operands[1] = quantity;
}

int tinker_verb_modes(int argc, char **argv)
{
    g_auto(ModesOptions) options = {0};
    const GOptionEntry entries[] = {
        {"state", 0, 0, G_OPTION_ARG_FILENAME, &options.state,
         "About which state: rest, or start, the places as given, held still (rest)", "STATE"},
        {"count", 0, 0, G_OPTION_ARG_FILENAME, &options.count, "The lowest N modes only (10; all in JSON)", "N"},
        {"json", 0, 0, G_OPTION_ARG_FILENAME, &options.json, "Write everything as JSON to FILE", "FILE"},
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output,
         "Draw to FILE-1, FILE-2, ... (.png, .svg, .pdf), or the response to FILE (also .csv, or -)", "FILE"},
        {"response", 0, 0, G_OPTION_ARG_FILENAME, &options.response,
         "The frequency response of BLOCK.QUANTITY to this motor or support motion", "INPUT"},
        {"from", 0, 0, G_OPTION_ARG_FILENAME, &options.from, "The lowest frequency (a fifth of the lowest mode's)",
         "HZ"},
        {"to", 0, 0, G_OPTION_ARG_FILENAME, &options.to, "The highest frequency (four times the highest mode's)", "HZ"},
        {"points", 0, 0, G_OPTION_ARG_FILENAME, &options.points,
         "Frequencies to work out, besides more around each mode (400)", "N"},
        {"linear", 0, 0, G_OPTION_ARG_NONE, &options.linear, "Linear axes and even steps instead of logarithmic ones",
         NULL},
        TINKER_PICTURE_ENTRIES(options.picture, "800x600"),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_command_line_read(&line, &help, entries, argc, argv, &status)) return status;

    put_scene_first(&line);
    g_auto(TinkerOpenScene) open = {0};
    status = tinker_open_scene(&open, line.plugin_folders, line.operands[0]);
    if (status != TINKER_EXIT_DONE) return status;
    g_autoptr(GError) error = NULL;
    const char *quantity = line.operand_count > 1 ? line.operands[1] : NULL;
    return modes(&options, &open, quantity, &error) ? TINKER_EXIT_DONE : tinker_open_scene_report_error(&open, error);
}
