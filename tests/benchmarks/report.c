/* Table and JSON; see the header. */
#include "report.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct _BenchmarkReport {
    char *json_path, *only;
    cJSON *steps, *figures;
    gboolean step_heading, figure_heading;
};

BenchmarkReport *benchmark_report_new(int argc, char **argv)
{
    BenchmarkReport *report = g_new0(BenchmarkReport, 1);
    const GOptionEntry entries[] = {
        {"json", 0, 0, G_OPTION_ARG_FILENAME, &report->json_path, "Write the figures to FILE as JSON", "FILE"},
        {"only", 0, 0, G_OPTION_ARG_STRING, &report->only, "Run only scenes whose name contains TEXT", "TEXT"},
        {NULL},
    };
    GOptionContext *context = g_option_context_new(NULL);
    g_autoptr(GError) error = NULL;
    g_option_context_add_main_entries(context, entries, NULL);
    gboolean fine = g_option_context_parse(context, &argc, &argv, &error);
    g_option_context_free(context);
    if (!fine || argc > 1) {
        fprintf(stderr, "%s: %s\n", g_get_prgname(), fine ? "no operands are taken" : error->message);
        exit(2);
    }
    report->steps = cJSON_CreateArray();
    report->figures = cJSON_CreateArray();
    setvbuf(stdout, NULL, _IOLBF, 0);
    return report;
}

int benchmark_report_end(BenchmarkReport *report)
{
    g_autoptr(GError) error = NULL;
    cJSON *whole = cJSON_CreateObject();
    cJSON_AddItemToObject(whole, "steps", report->steps);
    cJSON_AddItemToObject(whole, "figures", report->figures);
    if (report->json_path != NULL) {
        char *text = cJSON_Print(whole);
        if (!g_file_set_contents(report->json_path, text, -1, &error)) fprintf(stderr, "%s\n", error->message);
        cJSON_free(text);
    }
    cJSON_Delete(whole);
    g_free(report->json_path);
    g_free(report->only);
    g_free(report);
    return error == NULL ? 0 : 5;
}

gboolean benchmark_report_wants(const BenchmarkReport *report, const char *scene)
{
    return report->only == NULL || strstr(scene, report->only) != NULL;
}

/* JSON has no NaN: what is not known is null. */
static void add_number(cJSON *object, const char *key, double value)
{
    cJSON_AddItemToObject(object, key, isfinite(value) ? cJSON_CreateNumber(value) : cJSON_CreateNull());
}

static const char *verdict(double value, double goal)
{
    if (isnan(goal)) return "";
    return value <= goal ? "met" : "missed";
}

static char *goal_text(double goal)
{
    return isnan(goal) ? g_strdup("-") : g_strdup_printf("%.4g", goal);
}

void benchmark_report_step(BenchmarkReport *report, const BenchmarkStep *step)
{
    double median = 1e9 * step->step.median, minimum = 1e9 * step->step.minimum;
    double least = minimum / step->elements, floor_least = 1e9 * step->floor.minimum / step->elements;
    if (!report->step_heading)
        printf("\n%-34s %-12s %24s %20s %12s %8s %7s\n", "SCENE", "METHOD", "NS/STEP median / min",
               "PER ELEMENT med/min", "FLOOR (min)", "RATIO", "GOAL");
    report->step_heading = TRUE;
    g_autofree char *goal = goal_text(step->goal);
    printf("%-34s %-12s %12.1f /%10.1f %10.2f /%8.2f %12.2f %8.2f %7s %s\n", step->scene, step->method, median, minimum,
           median / step->elements, least, floor_least, least / floor_least, goal, verdict(least, step->goal));
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "scene", step->scene);
    cJSON_AddStringToObject(item, "method", step->method);
    add_number(item, "ns_per_step_median", median);
    add_number(item, "ns_per_step_minimum", minimum);
    add_number(item, "elements", step->elements);
    add_number(item, "floor_ns_per_step_median", 1e9 * step->floor.median);
    add_number(item, "floor_ns_per_step_minimum", 1e9 * step->floor.minimum);
    add_number(item, "ratio", least / floor_least);
    add_number(item, "goal_ns_per_element", step->goal);
    cJSON_AddItemToArray(report->steps, item);
}

void benchmark_report_figure(BenchmarkReport *report, const char *scene, const char *what, double value,
                             const char *unit, double goal)
{
    if (!report->figure_heading)
        printf("\n%-34s %-44s %14s %-8s %10s\n", "SCENE", "FIGURE", "VALUE", "UNIT", "AT MOST");
    report->figure_heading = TRUE;
    g_autofree char *goal_written = goal_text(goal);
    printf("%-34s %-44s %14.6g %-8s %10s %s\n", scene, what, value, unit, goal_written, verdict(value, goal));
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "scene", scene);
    cJSON_AddStringToObject(item, "figure", what);
    add_number(item, "value", value);
    cJSON_AddStringToObject(item, "unit", unit);
    add_number(item, "at_most", goal);
    cJSON_AddItemToArray(report->figures, item);
}
