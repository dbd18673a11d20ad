/* Samples and summary as bytes; see the header. */
#include "net-take.h"

#include <math.h>
#include <string.h>

static void add_heading(GByteArray *bytes, const GArray *columns, const char *second)
{
    g_autoptr(GString) heading = g_string_new("time [s]");
    g_string_append(heading, second);
    for (guint i = 0; i < columns->len; i++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, i);
        g_string_append_printf(heading, "\t%s [%s]", column->name, column->unit);
    }
    g_string_append_c(heading, '\n');
    g_byte_array_append(bytes, (const guint8 *)heading->str, (guint)heading->len);
}

NetTake *net_take_new(const GArray *columns)
{
    NetTake *take = g_new0(NetTake, 1);
    take->record = g_byte_array_new();
    take->estimate = g_byte_array_new();
    add_heading(take->record, columns, "");
    add_heading(take->estimate, columns, "\terror estimate [1]");
    take->record_heading = take->record->len;
    take->estimate_heading = take->estimate->len;
    take->columns = columns->len;
    return take;
}

void net_take_free(NetTake *take)
{
    if (take == NULL) return;
    g_byte_array_unref(take->record);
    g_byte_array_unref(take->estimate);
    g_free(take);
}

/* Nothing says which of the many NaNs an operation answers, and compilers differ in it: they are all one here. */
static void add_double(GByteArray *bytes, double value)
{
    guint64 bits;
    if (isnan(value)) value = fabs((double)NAN);
    memcpy(&bits, &value, sizeof bits);
    bits = GUINT64_TO_LE(bits);
    g_byte_array_append(bytes, (const guint8 *)&bits, sizeof bits);
}

static gboolean keep(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    NetTake *take = data;
    const double *bands = tinker_simulation_bands(simulation);
    add_double(take->record, time);
    add_double(take->estimate, time);
    add_double(take->estimate, tinker_simulation_error(simulation));
    for (guint i = 0; i < take->columns; i++) {
        add_double(take->record, values[i]);
        add_double(take->estimate, bands != NULL ? bands[i] : (double)NAN);
    }
    take->samples++;
    return TRUE;
}

static void begin_again(void *data)
{
    NetTake *take = data;
    g_byte_array_set_size(take->record, take->record_heading);
    g_byte_array_set_size(take->estimate, take->estimate_heading);
    take->samples = 0;
}

TinkerSampleTaker net_take_samples(NetTake *take)
{
    return (TinkerSampleTaker){.sample = keep, .begin_again = begin_again, .data = take};
}

char *net_summary_text(const TinkerSummary *summary)
{
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "simulated %.17g\nvalid until %.17g\ndetermined until %.17g\n", summary->simulated_s,
                           summary->valid_until, summary->determined_until);
    g_string_append_printf(text, "kinetic %.17g to %.17g\npotential %.17g to %.17g\nstart impulse %.17g\n",
                           summary->kinetic_start, summary->kinetic_end, summary->potential_start,
                           summary->potential_end, summary->start_impulse);
    for (int i = 0; i < TINKER_BOOK_COUNT; i++)
        g_string_append_printf(text, "book %d %.17g\n", i, summary->books[i]);
    g_string_append_printf(text, "balance error %.17g\nconstraint errors %.17g %.17g\n", summary->energy_balance_error,
                           summary->constraint_position_error, summary->constraint_velocity_error);
    g_string_append_printf(text, "rejected steps %" G_GINT64_FORMAT "\ncontact changes %" G_GINT64_FORMAT "\n",
                           summary->rejected_steps, summary->contact_changes);
    for (guint i = 0; i < summary->tries->len; i++) {
        const TinkerTry *one = &g_array_index(summary->tries, TinkerTry, i);
        g_string_append_printf(text, "try %s step %.17g tolerance %.17g\n", one->method, one->step, one->tolerance);
    }
    for (guint i = 0; i < summary->islands->len; i++) {
        const TinkerIslandSummary *island = g_ptr_array_index(summary->islands, i);
        g_string_append_printf(text, "island of %u by %s step %.17g tolerance %.17g\n", island->bodies->len,
                               island->method, island->step, island->tolerance);
    }
    for (guint i = 0; i < summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(summary->events, i);
        g_string_append_printf(text, "event %.17g %s %s\n", event->time, event->kind, event->blocks);
    }
    for (guint i = 0; i < summary->warnings->len; i++)
        g_string_append_printf(text, "warning %s\n", tinker_warnings_text(summary->warnings, i));
    return g_string_free(text, FALSE);
}
