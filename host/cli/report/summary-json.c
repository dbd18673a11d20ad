/* The summary of a run as JSON. */
#include <math.h>

#include <cjson/cJSON.h>

#include "cli/report/scene-json.h"
#include "cli/report/summary.h"
#include "common/program/print.h"
#include "common/words/event-words.h"

static void add_number(cJSON *object, const char *key, double value)
{
    if (isfinite(value))
        cJSON_AddNumberToObject(object, key, value);
    else
        cJSON_AddNullToObject(object, key);
}

static void add_start_and_end(cJSON *object, const char *key, double start, double end)
{
    cJSON *pair = cJSON_AddObjectToObject(object, key);
    add_number(pair, "start", start);
    add_number(pair, "end", end);
}

static void add_energy(cJSON *root, const TinkerSummary *run)
{
    static const char *const keys[TINKER_BOOK_COUNT] = {
        [TINKER_BOOK_DAMPERS] = "dampers",       [TINKER_BOOK_FRICTION] = "friction",
        [TINKER_BOOK_CONTACTS] = "contacts",     [TINKER_BOOK_MOTORS] = "motors",
        [TINKER_BOOK_FIELDS] = "fields",         [TINKER_BOOK_SUPPORT_MOTION] = "support_motion",
        [TINKER_BOOK_PROJECTION] = "projection",
    };
    cJSON *energy = cJSON_AddObjectToObject(root, "energy");
    add_start_and_end(energy, "kinetic", run->kinetic_start, run->kinetic_end);
    add_start_and_end(energy, "potential", run->potential_start, run->potential_end);
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        add_number(energy, keys[book], run->books[book]);
}

/* The velocities behind it, law by law. */
static void add_alternatives(cJSON *entry, const TinkerRunReport *report, const GArray *alternatives)
{
    cJSON *laws = alternatives != NULL ? cJSON_AddObjectToObject(entry, "alternatives") : NULL;
    for (guint i = 0; laws != NULL && i < alternatives->len; i++) {
        const TinkerAlternative *each = &g_array_index(alternatives, TinkerAlternative, i);
        cJSON *law = cJSON_GetObjectItemCaseSensitive(laws, each->law);
        if (law == NULL) law = cJSON_AddObjectToObject(laws, each->law);
        cJSON *body = cJSON_AddObjectToObject(law, tinker_scene_block_name(report->scene, each->block));
        add_number(body, "vx", each->vx);
        add_number(body, "vy", each->vy);
        if (!isnan(each->rate)) add_number(body, "angular velocity", each->rate);
    }
}

static void add_events(cJSON *root, const TinkerRunReport *report)
{
    const TinkerSummary *run = report->run;
    cJSON *events = cJSON_AddArrayToObject(root, "events");
    for (guint i = 0; run->events != NULL && i < run->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(run->events, i);
        cJSON *entry = cJSON_CreateObject();
        add_number(entry, "time", event->time);
        cJSON_AddStringToObject(entry, "kind", event->kind);
        g_auto(GStrv) names = g_strsplit(event->blocks == NULL ? "" : event->blocks, ", ", -1);
        cJSON_AddItemToObject(entry, "blocks",
                              cJSON_CreateStringArray((const char *const *)names, (int)g_strv_length(names)));
        g_autofree char *text = tinker_event_text(report->scene, event);
        cJSON_AddStringToObject(entry, "text", text);
        add_alternatives(entry, report, event->alternatives);
        cJSON_AddItemToArray(events, entry);
    }
}

/* Whichever counts for the method; null for the other, and for both where islands differ or steps are exact. */
static void add_step_or_tolerance(cJSON *object, const char *method, gboolean adaptive, double step, double tolerance)
{
    gboolean neither = g_str_equal(method, "auto") || g_str_equal(method, "exact");
    add_number(object, "step", adaptive || neither ? NAN : step);
    add_number(object, "tolerance", adaptive && !neither ? tolerance : NAN);
}

static void add_islands(cJSON *root, const TinkerRunReport *report)
{
    cJSON *islands = cJSON_AddArrayToObject(root, "islands");
    for (guint i = 0; i < report->run->islands->len; i++) {
        const TinkerIslandSummary *run = g_ptr_array_index(report->run->islands, i);
        cJSON *island = cJSON_CreateObject();
        tinker_json_add_names(island, report->scene, run->bodies);
        cJSON_AddStringToObject(island, "method", run->method);
        add_step_or_tolerance(island, run->method, run->adaptive, run->step, run->tolerance);
        cJSON_AddItemToArray(islands, island);
    }
}

/* The accuracy that was asked for, and every run that was to hold it, the last one too. */
static void add_tries(cJSON *root, const TinkerSummary *run)
{
    add_number(root, "accuracy", run->accuracy > 0 ? run->accuracy : NAN);
    cJSON *tries = cJSON_AddArrayToObject(root, "tries");
    for (guint i = 0; i < run->tries->len; i++) {
        const TinkerTry *each = &g_array_index(run->tries, TinkerTry, i);
        cJSON *entry = cJSON_CreateObject();
        cJSON_AddStringToObject(entry, "method", each->method);
        add_step_or_tolerance(entry, each->method, each->adaptive, each->step, each->tolerance);
        add_number(entry, "evaluations", (double)each->evaluations);
        add_number(entry, "wall_s", each->wall_s);
        add_number(entry, "error_estimate", each->error_estimate);
        cJSON_AddItemToArray(tries, entry);
    }
}

static void add_texts(cJSON *root, const char *key, const GPtrArray *texts)
{
    cJSON *array = cJSON_AddArrayToObject(root, key);
    for (guint i = 0; i < texts->len; i++)
        cJSON_AddItemToArray(array, cJSON_CreateString(g_ptr_array_index(texts, i)));
}

void tinker_summary_write_json(const TinkerRunReport *report, FILE *file)
{
    const TinkerSummary *run = report->run;
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "method", run->method);
    add_step_or_tolerance(root, run->method, run->adaptive, run->step, run->tolerance);
    add_number(root, "steps", (double)run->steps);
    add_number(root, "rejected_steps", (double)run->rejected_steps);
    add_number(root, "evaluations", (double)run->evaluations);
    add_number(root, "simulated_s", run->simulated_s);
    add_number(root, "wall_s", run->wall_s);
    add_number(root, "real_time_factor", run->simulated_s / run->wall_s);
    add_number(root, "constraint_position_error", run->constraint_position_error);
    add_number(root, "constraint_velocity_error", run->constraint_velocity_error);
    add_energy(root, run);
    add_number(root, "energy_balance_error", run->energy_balance_error);
    add_number(root, "error_estimate", run->error_estimate);
    add_tries(root, run);
    add_number(root, "valid_until", run->determined_until);
    if (report->has_until && report->stopped_by != NULL)
        cJSON_AddStringToObject(root, "stopped_by", report->stopped_by);
    else if (report->has_until)
        cJSON_AddNullToObject(root, "stopped_by");
    add_events(root, report);
    add_islands(root, report);
    add_texts(root, "libraries", report->libraries);
    add_texts(root, "warnings", report->warnings);

    char *text = cJSON_Print(root);
    tinker_print_text(file, text);
    cJSON_free(text);
    cJSON_Delete(root);
}
