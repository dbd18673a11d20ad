/* The plan for people: what is there, island by island how it is stepped and why, then what is modelled and what is
 * not. */
#include <math.h>

#include "cli/report/plan-report.h"
#include "cli/report/text-table.h"
#include "common/program/print.h"
#include "common/words/plan-words.h"

#define MOST_ISLANDS 8 /* the JSON has them all */

static const char *plural(int32_t count)
{
    return count == 1 ? "" : "s";
}

static void add(TinkerTextTable *table, const char *label, const char *value)
{
    tinker_text_table_add(table, label);
    tinker_text_table_add(table, value);
}

static char *kind_text(const TinkerIslandPlan *island)
{
    g_autoptr(GString) text = g_string_new(NULL);
    g_string_append_printf(text, "%d %s, %d degree%s of freedom, %s", island->bodies,
                           island->bodies == 1 ? "body" : "bodies", island->degrees_of_freedom,
                           plural(island->degrees_of_freedom), island->linear ? "linear" : "nonlinear");
    if (island->straight) g_string_append(text, ", stepped along one line");
    if (island->shafts) g_string_append(text, ", stepped by the angles of its shafts");
    if (island->constraint_rows > 0)
        g_string_append_printf(text, ", %d constraint%s", island->constraint_rows, plural(island->constraint_rows));
    if (island->redundant_rows > 0) g_string_append_printf(text, " (%d redundant)", island->redundant_rows);
    return g_string_free(g_steal_pointer(&text), FALSE);
}

static char *speed_text(const TinkerIslandPlan *island)
{
    g_autoptr(GString) text = g_string_new(NULL);
    if (island->omega_max > 0)
        g_string_append_printf(text, "%.4g rad/s (period %.3g s)", island->omega_max, 2 * G_PI / island->omega_max);
    else
        g_string_append(text, island->linear ? "nothing swings" : "nothing swings about the start");
    if (island->damping_max > 0) g_string_append_printf(text, "; fastest decay %.4g/s", island->damping_max);
    if (island->growth_max > 0) g_string_append_printf(text, "; fastest growth %.4g/s", island->growth_max);
    return g_string_free(g_steal_pointer(&text), FALSE);
}

/* "verlet 0.2 s, rk4 0.283 s"; "-" where a limit is not known. */
static char *limits_text(const TinkerIslandPlan *island)
{
    g_autoptr(GString) text = g_string_new(NULL);
    g_autoptr(GPtrArray) methods = tinker_plan_limited_methods(island);
    for (guint i = 0; i < methods->len; i++) {
        const TinkerIntegrator *method = g_ptr_array_index(methods, i);
        double step = tinker_plan_stable_step(island, method);
        g_string_append_printf(text, "%s%s ", text->len > 0 ? ", " : "", method->id);
        if (step > 0 && isfinite(step))
            g_string_append_printf(text, "%.3g s", step);
        else
            g_string_append(text, isnan(step) ? "-" : step > 0 ? "any" : "none");
    }
    if (!island->linear) g_string_append(text, " (near the start)");
    return g_string_free(g_steal_pointer(&text), FALSE);
}

static void write_island(const TinkerPlanReport *report, guint number, FILE *file)
{
    const TinkerIslandPlan *island = g_ptr_array_index(report->plan->islands, number);
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("ll", 2);
    g_autofree char *blocks = tinker_island_blocks_text(report->scene, island), *kind = kind_text(island),
                    *speed = speed_text(island);
    g_autofree char *limits = limits_text(island), *time = tinker_duration_text(island->expected_s, 2);
    g_autofree char *method = tinker_island_method_text(island);
    g_autofree char *error = island->expected_error < TINKER_ROUNDING
                                 ? g_strdup("right to rounding")
                                 : g_strdup_printf("error about %.1g of the motion's extent", island->expected_error);
    g_autofree char *expected = g_strdup_printf("about %s with %.2g evaluations, %s", time, island->evaluations, error);
    add(table, "what", kind);
    add(table, "method", method);
    add(table, "why", island->reason);
    if (island->bodies > 0) {
        add(table, "fastest", speed);
        add(table, "stable up to", limits);
        add(table, "expected", expected);
    }
    fputc('\n', file);
    tinker_print_line(file, "Island %u: %s", number + 1, blocks);
    tinker_text_table_write(table, file);
}

static void write_list(const char *title, const GPtrArray *sentences, FILE *file)
{
    if (sentences->len == 0) return;
    fputc('\n', file);
    tinker_print_line(file, "%s", title);
    for (guint i = 0; i < sentences->len; i++)
        tinker_print_line(file, "  %s", (const char *)g_ptr_array_index(sentences, i));
}

void tinker_plan_write_text(const TinkerPlanReport *report, FILE *file)
{
    const char *title = tinker_scene_head(report->scene)->title;
    guint islands = report->plan->islands->len;
    tinker_print_line(file, "%s", title[0] != '\0' ? title : report->scene_name);
    for (guint i = 0; i < MIN(islands, MOST_ISLANDS); i++)
        write_island(report, i, file);
    if (islands > MOST_ISLANDS)
        fprintf(file, "\nand %u more islands (all of them: --json FILE)\n", islands - MOST_ISLANDS);
    write_list("Modelled", report->plan->modelled, file);
    write_list("Left out", report->plan->left_out, file);
    if (report->warnings->len > 0) fputc('\n', file);
    for (guint i = 0; i < report->warnings->len; i++)
        tinker_print_line(file, "warning: %s", (const char *)g_ptr_array_index(report->warnings, i));
}
