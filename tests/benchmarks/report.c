/* Table and JSON; see the header. */
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct _BenchmarkReport {
    char *json_path, *only;
    cJSON *steps, *figures, *whole;
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
    report->whole = cJSON_CreateObject();
    cJSON_AddItemToObject(report->whole, "steps", report->steps);
    cJSON_AddItemToObject(report->whole, "figures", report->figures);
    setvbuf(stdout, NULL, _IOLBF, 0);
    return report;
}

int benchmark_report_end(BenchmarkReport *report)
{
    g_autoptr(GError) error = NULL;
    if (report->json_path != NULL) {
        char *text = cJSON_Print(report->whole);
        if (!g_file_set_contents(report->json_path, text, -1, &error)) fprintf(stderr, "%s\n", error->message);
        cJSON_free(text);
    }
    cJSON_Delete(report->whole);
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

static void print_step_heading(void)
{
    printf("\n%-32s %-6s %24s %24s %12s %6s %5s\n", "SCENE", "METHOD", "NS/STEP MEDIAN / LEAST",
           "NS/ELEMENT MEDIAN/LEAST", "FLOOR, LEAST", "RATIO", "GOAL");
}

static cJSON *step_item(const BenchmarkStep *step)
{
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "scene", step->scene);
    cJSON_AddStringToObject(item, "method", step->method);
    add_number(item, "ns_per_step_median", 1e9 * step->step.median);
    add_number(item, "ns_per_step_least", 1e9 * step->step.minimum);
    add_number(item, "elements", step->elements);
    add_number(item, "floor_ns_per_step_median", 1e9 * step->floor.median);
    add_number(item, "floor_ns_per_step_least", 1e9 * step->floor.minimum);
    add_number(item, "ratio", step->step.minimum / step->floor.minimum);
    add_number(item, "goal_ns_per_element", step->goal);
    if (step->error_kind == NULL) return item;
    cJSON_AddStringToObject(item, "error_kind", step->error_kind);
    add_number(item, "error", step->error);
    add_number(item, "floor_error", step->floor_error);
    return item;
}

void benchmark_report_step(BenchmarkReport *report, const BenchmarkStep *step)
{
    double ns = 1e9 / step->elements, least = ns * step->step.minimum;
    g_autofree char *goal = goal_text(step->goal);
    if (cJSON_GetArraySize(report->steps) == 0) print_step_heading();
    printf("%-32s %-6s %12.1f /%10.1f %12.2f /%10.2f %12.2f %6.2f %5s %-6s", step->scene, step->method,
           1e9 * step->step.median, 1e9 * step->step.minimum, ns * step->step.median, least, ns * step->floor.minimum,
           step->step.minimum / step->floor.minimum, goal, verdict(least, step->goal));
    if (step->error_kind != NULL) printf("  %s %.2g", step->error_kind, step->error);
    if (step->error_kind != NULL && !isnan(step->floor_error)) printf(" (floor %.2g)", step->floor_error);
    printf("\n");
    cJSON_AddItemToArray(report->steps, step_item(step));
}

void benchmark_report_figure(BenchmarkReport *report, const char *scene, const char *what, double value,
                             const char *unit, double goal)
{
    if (cJSON_GetArraySize(report->figures) == 0)
        printf("\n%-32s %-52s %14s %-8s %8s\n", "SCENE", "FIGURE", "VALUE", "UNIT", "AT MOST");
    g_autofree char *goal_written = goal_text(goal);
    printf("%-32s %-52s %14.6g %-8s %8s %s\n", scene, what, value, unit, goal_written, verdict(value, goal));
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "scene", scene);
    cJSON_AddStringToObject(item, "figure", what);
    add_number(item, "value", value);
    cJSON_AddStringToObject(item, "unit", unit);
    add_number(item, "at_most", goal);
    cJSON_AddItemToArray(report->figures, item);
}

void benchmark_report_add(BenchmarkReport *report, const char *list, cJSON *item)
{
    cJSON *array = cJSON_GetObjectItem(report->whole, list);
    if (array == NULL) array = cJSON_AddArrayToObject(report->whole, list);
    cJSON_AddItemToArray(array, item);
}
