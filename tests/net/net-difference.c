/* Comparing stored records value by value; see the header. */
#include "net-difference.h"

#include <math.h>
#include <string.h>

typedef struct {
    char *bytes;
    GStrv names; /* of the columns, with their units */
    guint columns;
    gsize rows;
    const char *values;
} Stored;

static void stored_clear(Stored *stored)
{
    g_free(stored->bytes);
    g_strfreev(stored->names);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Stored, stored_clear)

static gboolean load(const char *store, const char *hash, Stored *stored, GError **error)
{
    g_autofree char *path = g_build_filename(store, hash, NULL);
    gsize length;
    if (!g_file_get_contents(path, &stored->bytes, &length, error)) return FALSE;
    const char *end = memchr(stored->bytes, '\n', length);
    if (end == NULL) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_INVAL, "%s is no record", path);
        return FALSE;
    }
    g_autofree char *heading = g_strndup(stored->bytes, (gsize)(end - stored->bytes));
    stored->names = g_strsplit(heading, "\t", -1);
    stored->columns = g_strv_length(stored->names);
    stored->values = end + 1;
    stored->rows = (length - (gsize)(stored->values - stored->bytes)) / (stored->columns * sizeof(double));
    return TRUE;
}

static double value(const Stored *stored, gsize row, guint column)
{
    guint64 bits;
    double result;
    memcpy(&bits, stored->values + (row * stored->columns + column) * sizeof bits, sizeof bits);
    bits = GUINT64_FROM_LE(bits);
    memcpy(&result, &bits, sizeof result);
    return result;
}

static double largest_magnitude(const Stored *stored, guint column)
{
    double largest = 0;
    for (gsize row = 0; row < stored->rows; row++) {
        const double magnitude = fabs(value(stored, row, column));
        if (magnitude > largest && isfinite(magnitude)) largest = magnitude;
    }
    return largest;
}

static const char *unit_of(const char *name)
{
    return strrchr(name, '[');
}

/* The largest magnitude of all columns of one unit, for each column. (transfer full) */
static double *spread_over_units(const Stored *stored, const double *magnitudes)
{
    double *spread = g_new0(double, stored->columns);
    g_autoptr(GHashTable) units = g_hash_table_new(g_str_hash, g_str_equal);
    g_autofree double *largest = g_new0(double, stored->columns);
    for (guint i = 0; i < stored->columns; i++) {
        char *unit = (char *)unit_of(stored->names[i]);
        if (!g_hash_table_contains(units, unit)) g_hash_table_insert(units, unit, &largest[i]);
        double *of_unit = g_hash_table_lookup(units, unit);
        *of_unit = fmax(*of_unit, magnitudes[i]);
    }
    for (guint i = 0; i < stored->columns; i++)
        spread[i] = *(double *)g_hash_table_lookup(units, unit_of(stored->names[i]));
    return spread;
}

static void take_larger(NetLargest *largest, double share, const char *name, double at)
{
    if (!(share > largest->share) && !isnan(largest->share)) return;
    largest->share = share;
    largest->at = at;
    g_strlcpy(largest->column, name, sizeof largest->column);
}

/* What one value is and the other is not, a number, is infinitely far from it. */
static double apart(double one, double other)
{
    if (one == other || (isnan(one) && isnan(other))) return 0;
    const double difference = fabs(one - other);
    return isnan(difference) ? INFINITY : difference;
}

gboolean net_difference(const char *store, const char *old_hash, const char *new_hash, NetDifference *difference,
                        GError **error)
{
    g_auto(Stored) old = {0}, new = {0};
    *difference = (NetDifference){.of_column.share = NAN, .of_unit.share = NAN};
    if (!load(store, old_hash, &old, error) || !load(store, new_hash, &new, error)) return FALSE;
    difference->comparable = g_strv_equal((const char *const *)old.names, (const char *const *)new.names);
    if (!difference->comparable) return TRUE;
    g_autofree double *magnitudes = g_new0(double, old.columns);
    for (guint i = 0; i < old.columns; i++)
        magnitudes[i] = fmax(largest_magnitude(&old, i), largest_magnitude(&new, i));
    g_autofree double *of_unit = spread_over_units(&old, magnitudes);
    for (gsize row = 0; row < MIN(old.rows, new.rows); row++) {
        for (guint i = 0; i < old.columns; i++) {
            const double distance = apart(value(&old, row, i), value(&new, row, i)), at = value(&old, row, 0);
            if (distance == 0) continue;
            take_larger(&difference->of_column, distance / magnitudes[i], old.names[i], at);
            take_larger(&difference->of_unit, distance / of_unit[i], old.names[i], at);
        }
    }
    return TRUE;
}
