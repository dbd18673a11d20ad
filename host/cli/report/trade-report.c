/* The tables and the CSV of a trade. */
#include "cli/report/trade-report.h"

#include <math.h>

#include "cli/report/text-table.h"
#include "common/program/csv-writer.h"
#include "common/program/print.h"
#include "common/words/trade-words.h"

static const TinkerTradeMethod *method_at(const TinkerTrade *trade, guint place)
{
    return g_ptr_array_index(trade->methods, place);
}

static const TinkerTradeRow *row_at(const TinkerTradeMethod *method, guint place)
{
    return &g_array_index(method->rows, TinkerTradeRow, place);
}

static void add_number(TinkerTextTable *table, const char *format, double value)
{
    char text[64] = "";
    if (!isnan(value)) g_ascii_formatd(text, sizeof text, format, value);
    tinker_text_table_add(table, text);
}

static void add_row(TinkerTextTable *table, const TinkerTradeRow *row, gboolean first)
{
    g_autofree char *setting = tinker_trade_value_text(&row->setting), *note = tinker_trade_note_text(row, FALSE);
    tinker_text_table_add(table, first ? row->setting.method : "");
    tinker_text_table_add(table, setting);
    add_number(table, "%.3g", row->wall_s);
    if (isnan(row->error))
        tinker_text_table_add(table, "");
    else
        tinker_text_table_add_format(table, "%" G_GINT64_FORMAT, row->evaluations);
    add_number(table, "%.2e", row->error);
    add_number(table, "%.1e", row->energy_error);
    add_number(table, "%.1e", row->constraint_error);
    tinker_text_table_add(table, note);
}

static void write_measurements(const TinkerTrade *trade, FILE *file)
{
    static const char *const headings[] = {"METHOD", "STEP OR TOLERANCE", "WALL [s]",         "EVALUATIONS",
                                           "ERROR",  "ENERGY ERROR",      "CONSTRAINT ERROR", ""};
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("lrrrrrrl", 0);
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = method_at(trade, m);
        for (guint i = 0; i < method->rows->len; i++)
            add_row(table, row_at(method, i), i == 0);
    }
    tinker_text_table_write(table, file);
}

static void write_failures(const TinkerTrade *trade, FILE *file)
{
    gboolean any = FALSE;
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = method_at(trade, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = row_at(method, i);
            if (row->note == NULL) continue;
            g_autofree char *setting = tinker_trade_value_text(&row->setting);
            if (!any) fputc('\n', file);
            tinker_print_line(file, "%s%s%s: %s", method->id, setting[0] != '\0' ? " at " : "", setting, row->note);
            any = TRUE;
        }
    }
}

static const char *order_remark(const TinkerTradeMethod *method)
{
    if (isnan(method->order)) return "too few errors tell of it";
    return method->asymptotic ? "" : "no asymptotic range was reached: the slope over all that was";
}

static void write_orders(const TinkerTrade *trade, FILE *file)
{
    static const char *const headings[] = {"METHOD", "NOMINAL ORDER", "OBSERVED ORDER", ""};
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("lrrl", 0);
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = method_at(trade, m);
        if (method->rows->len == 0) continue;
        tinker_text_table_add(table, method->id);
        if (method->integrator->order > 0)
            tinker_text_table_add_format(table, "%d", method->integrator->order);
        else
            tinker_text_table_add(table, "");
        add_number(table, "%.2f", method->order);
        tinker_text_table_add(table, order_remark(method));
    }
    fputc('\n', file);
    tinker_text_table_write(table, file);
}

void tinker_trade_write_tables(const TinkerTrade *trade, FILE *file)
{
    write_measurements(trade, file);
    write_failures(trade, file);
    write_orders(trade, file);
}

/* CSV -------------------------------------------------------------------------------------------------------------- */

static void write_value(TinkerCsvWriter *writer, gboolean known, double value)
{
    if (known && !isnan(value))
        tinker_csv_number(writer, value);
    else
        tinker_csv_text(writer, "");
}

void tinker_trade_write_csv(const TinkerTrade *trade, FILE *file)
{
    static const char *const headings[] = {"method", "step",         "tolerance",        "wall_s", "evaluations",
                                           "error",  "energy_error", "constraint_error", "note"};
    g_auto(TinkerCsvWriter) writer = tinker_csv_writer_record(file);
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_csv_text(&writer, headings[i]);
    tinker_csv_end_row(&writer);
    for (guint m = 0; m < trade->methods->len; m++) {
        const TinkerTradeMethod *method = method_at(trade, m);
        for (guint i = 0; i < method->rows->len; i++) {
            const TinkerTradeRow *row = row_at(method, i);
            g_autofree char *note = tinker_trade_note_text(row, TRUE);
            tinker_csv_text(&writer, method->id);
            gboolean neither = row->setting.value == 0;
            write_value(&writer, !row->setting.adaptive && !neither, row->setting.value);
            write_value(&writer, row->setting.adaptive && !neither, row->setting.value);
            write_value(&writer, TRUE, row->wall_s);
            write_value(&writer, !isnan(row->error), (double)row->evaluations);
            write_value(&writer, TRUE, row->error);
            write_value(&writer, TRUE, row->energy_error);
            write_value(&writer, TRUE, row->constraint_error);
            tinker_csv_text(&writer, note);
            tinker_csv_end_row(&writer);
        }
    }
}
