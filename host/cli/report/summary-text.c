/* The summary of a run for people: an aligned table, without what is zero because nothing in the scene does it. */
#include <math.h>

#include "cli/report/summary.h"
#include "cli/report/text-table.h"
#include "common/program/print.h"
#include "common/words/event-words.h"
#include "common/words/plan-words.h"

static char *time_text(const TinkerSummary *run)
{
    g_autofree char *wall = tinker_duration_text(run->wall_s, 3);
    double factor = run->simulated_s / run->wall_s;
    if (!isfinite(factor)) return g_strdup_printf("%g s simulated in %s", run->simulated_s, wall);
    return g_strdup_printf("%g s simulated in %s, %.*f times real time", run->simulated_s, wall, factor < 10 ? 2 : 0,
                           factor);
}

static void add(TinkerTextTable *table, const char *label, const char *value)
{
    tinker_text_table_add(table, label);
    tinker_text_table_add(table, value);
}

static char *method_text(const char *method, gboolean adaptive, double step, double tolerance)
{
    if (g_str_equal(method, "exact") || g_str_equal(method, "auto")) return g_strdup(method);
    return adaptive ? g_strdup_printf("%s, tolerance %g", method, tolerance)
                    : g_strdup_printf("%s, step %g s", method, step);
}

/* Only where they differ: how many islands each way of stepping has. */
static void add_islands(TinkerTextTable *table, const TinkerSummary *run)
{
    if (!g_str_equal(run->method, "auto")) return;
    g_autoptr(GPtrArray) ways = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GString) text = g_string_new(NULL);
    for (guint i = 0; i < run->islands->len; i++) {
        const TinkerIslandSummary *island = g_ptr_array_index(run->islands, i);
        char *way = method_text(island->method, island->adaptive, island->step, island->tolerance);
        g_ptr_array_add(ways, way);
    }
    for (guint i = 0; i < ways->len; i++) {
        guint first, count = 0;
        const char *way = g_ptr_array_index(ways, i);
        if (g_ptr_array_find_with_equal_func(ways, way, g_str_equal, &first) && first < i) continue;
        for (guint k = i; k < ways->len; k++)
            if (g_str_equal(g_ptr_array_index(ways, k), way)) count++;
        g_string_append_printf(text, "%s%u by %s", text->len > 0 ? "; " : "", count, way);
    }
    add(table, "islands", text->str);
}

/* What rounding leaves of a value is none; `whole` is what it is a part of. */
static double without_noise(double value, double whole)
{
    return fabs(value) < TINKER_ROUNDING * whole ? 0 : value;
}

static char *error_text(const TinkerSummary *run)
{
    if (isfinite(run->predictable_until))
        return g_strdup_printf("not predictable beyond %.4g s", run->predictable_until);
    if (run->error_estimate < TINKER_ROUNDING) return g_strdup("right to rounding, estimated");
    return g_strdup_printf("about %.2g of the motion's size, estimated", run->error_estimate);
}

static void write_numbers(const TinkerSummary *run, FILE *file)
{
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("ll", 2);
    g_autofree char *method = method_text(run->method, run->adaptive, run->step, run->tolerance);
    g_autofree char *steps =
        run->rejected_steps > 0
            ? g_strdup_printf("%" G_GINT64_FORMAT " and %" G_GINT64_FORMAT " rejected", run->steps, run->rejected_steps)
            : g_strdup_printf("%" G_GINT64_FORMAT, run->steps);
    g_autofree char *evaluations = g_strdup_printf("%" G_GINT64_FORMAT, run->evaluations);
    g_autofree char *time = time_text(run);
    add(table, "method", method);
    add_islands(table, run);
    add(table, "steps", steps);
    add(table, "evaluations", evaluations);
    add(table, "time", time);
    if (run->constraint_position_error != 0 || run->constraint_velocity_error != 0) {
        g_autofree char *error =
            g_strdup_printf("%.2g of length, %.2g of speed", without_noise(run->constraint_position_error, 1),
                            without_noise(run->constraint_velocity_error, 1));
        add(table, "constraint error", error);
    }
    if (isfinite(run->error_estimate)) {
        g_autofree char *estimate = error_text(run);
        add(table, "error", estimate);
    }
    tinker_text_table_write(table, file);
}

/* What each run that was to hold the accuracy cost. */
static void write_tries(const TinkerSummary *run, FILE *file)
{
    if (run->tries->len == 0) return;
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("llrrr", 2);
    const char *const headings[] = {"accuracy", "method", "evaluations", "time", "error"};
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    for (guint i = 0; i < run->tries->len; i++) {
        const TinkerTry *each = &g_array_index(run->tries, TinkerTry, i);
        g_autofree char *method = method_text(each->method, each->adaptive, each->step, each->tolerance),
                        *time = tinker_duration_text(each->wall_s, 3);
        tinker_text_table_add_format(table, "try %u", i + 1);
        tinker_text_table_add(table, method);
        tinker_text_table_add_format(table, "%" G_GINT64_FORMAT, each->evaluations);
        tinker_text_table_add(table, time);
        tinker_text_table_add_format(table, "%.2g", each->error_estimate);
        tinker_text_table_end_row(table);
    }
    const TinkerTry *last = &g_array_index(run->tries, TinkerTry, run->tries->len - 1);
    fputc('\n', file);
    tinker_text_table_write(table, file);
    tinker_print_line(file, "  %g was asked for: %s", run->accuracy,
                      last->error_estimate <= run->accuracy ? "met" : "not met");
}

/* The greatest of all energies that are told: 1e-30 J beside 10 J is nothing. */
static double largest_energy(const TinkerSummary *run)
{
    double most = fmax(fmax(fabs(run->kinetic_start), fabs(run->kinetic_end)),
                       fmax(fabs(run->potential_start), fabs(run->potential_end)));
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        most = fmax(most, fabs(run->books[book]));
    return most;
}

static void write_energy(const TinkerSummary *run, FILE *file)
{
    static const char *const labels[TINKER_BOOK_COUNT] = {
        [TINKER_BOOK_DAMPERS] = "dampers",       [TINKER_BOOK_FRICTION] = "friction",
        [TINKER_BOOK_CONTACTS] = "contacts",     [TINKER_BOOK_MOTORS] = "motors",
        [TINKER_BOOK_FIELDS] = "fields",         [TINKER_BOOK_SUPPORT_MOTION] = "support motion",
        [TINKER_BOOK_PROJECTION] = "projection",
    };
    const double whole = largest_energy(run);
    gboolean exchanged = FALSE;
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        if (without_noise(run->books[book], whole) != 0) exchanged = TRUE;
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("lrrr", 2);
    tinker_text_table_add(table, "energy [J]");
    tinker_text_table_add(table, "start");
    tinker_text_table_add(table, "end");
    tinker_text_table_add(table, exchanged ? "given" : "");
    const struct {
        const char *label;
        double start, end;
    } stored[] = {
        {"kinetic", run->kinetic_start, run->kinetic_end},
        {"potential", run->potential_start, run->potential_end},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(stored); i++) {
        tinker_text_table_add(table, stored[i].label);
        tinker_text_table_add_format(table, "%.6g", without_noise(stored[i].start, whole));
        tinker_text_table_add_format(table, "%.6g", without_noise(stored[i].end, whole));
        tinker_text_table_end_row(table);
    }
    for (int book = 0; book < TINKER_BOOK_COUNT; book++) {
        if (without_noise(run->books[book], whole) == 0) continue;
        tinker_text_table_add(table, labels[book]);
        tinker_text_table_add(table, "");
        tinker_text_table_add(table, "");
        tinker_text_table_add_format(table, "%.6g", run->books[book]);
    }
    fputc('\n', file);
    tinker_text_table_write(table, file);
    tinker_print_line(file, "  balance error %.2g of the energy exchanged",
                      without_noise(run->energy_balance_error, 1));
}

static void write_events(const TinkerRunReport *report, FILE *file)
{
    const guint most = 10;
    const GPtrArray *events = report->run->events;
    guint count = events == NULL ? 0 : events->len;
    for (guint i = 0; i < MIN(count, most); i++) {
        const TinkerEvent *event = g_ptr_array_index(events, i);
        g_autofree char *text = tinker_event_text(report->scene, event);
        tinker_print_line(file, "  event at %.6g s: %s", event->time, text);
    }
    if (count > most) tinker_print_line(file, "  and %u more events (all of them: --json FILE)", count - most);
}

static void write_end(const TinkerRunReport *report, FILE *file)
{
    if (report->stopped_by != NULL)
        tinker_print_line(file, "  ended at %.10g s, where %s", report->run->simulated_s, report->stopped_by);
    else if (report->has_until)
        tinker_print_line(file, "  no condition that would end the run came true in %g s", report->run->simulated_s);
}

void tinker_summary_write_text(const TinkerRunReport *report, FILE *file)
{
    const char *title = tinker_scene_head(report->scene)->title;
    tinker_print_line(file, "%s", title[0] != '\0' ? title : report->scene_name);
    write_numbers(report->run, file);
    write_tries(report->run, file);
    write_energy(report->run, file);
    write_events(report, file);
    write_end(report, file);
    for (guint i = 0; i < report->warnings->len; i++)
        tinker_print_line(file, "  warning: %s", (const char *)g_ptr_array_index(report->warnings, i));
}
