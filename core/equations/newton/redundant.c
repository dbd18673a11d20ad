/* Which constraint rows depend on each other at the state: those that a combination of rows which does nothing to any
 * body needs.
 *
 * A body to which the rows that are left do independent things needs none of them in such a combination, so they are
 * set aside, and so on: nothing is left of trees and open chains. Of the rest the singular values decide. Each slope is
 * over the root of the mass or inertia that it moves, as in J M^-1 J^T. */
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"

#define DEPENDENT  1e-9 /* of the largest singular value; */
#define TAKES_PART 1e-6 /* entry of a unit vector of the null space */
#define MOST_ROWS  600  /* of the rest, for which singular values are worked out */

void tinker_writer_note_slope(TinkerEquationWriter *writer, TinkerBlockId block, const double slope[3])
{
    const TinkerBodyEquation *body = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(block));
    const GPtrArray *rows = writer->equations->constraints;
    const TinkerConstraintEquation *row = g_ptr_array_index(rows, rows->len - 1);
    if (body == NULL || !row->active) return;
    const double mass = tinker_equations_value(writer->equations, body->mass);
    const double inertia = body->inertia != NULL ? tinker_equations_value(writer->equations, body->inertia) : INFINITY;
    const TinkerRowSlope entry = {
        rows->len - 1, block, {slope[0] / sqrt(mass), slope[1] / sqrt(mass), slope[2] / sqrt(inertia)}};
    if (slope[0] != 0 || slope[1] != 0 || entry.slope[2] != 0) g_array_append_val(writer->slopes, entry);
}

/* The null space of the columns of a matrix (by columns, so many rows high), as the rows of `vt` from the answered one
 * on; `columns` where it is empty. (transfer full) */
static guint null_space(double *matrix, guint height, guint columns, double **vt)
{
    const lapack_int m = (lapack_int)height, n = (lapack_int)columns;
    const guint least = MIN(height, columns);
    g_autofree double *values = g_new0(double, least + 1), *room = g_new0(double, least + 1);
    double none = 0;
    *vt = g_new0(double, columns *columns);
    if (LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'N', 'A', m, n, matrix, m, values, &none, 1, *vt, n, room) != 0)
        return columns;
    guint rank = 0;
    while (rank < least && values[rank] > DEPENDENT * values[0])
        rank++;
    return rank;
}

typedef struct {
    GArray *slopes;  /* of TinkerRowSlope: the rows that are left */
    GHashTable *set; /* numbers of rows that have been set aside */
} Rest;

/* The rows on a body, each once, and what they do to it: three numbers a row. */
static void rows_on(const Rest *rest, const GArray *of_body, GArray *rows, GArray *matrix)
{
    g_array_set_size(rows, 0);
    g_array_set_size(matrix, 0);
    for (guint i = 0; i < of_body->len; i++) {
        const TinkerRowSlope *entry = &g_array_index(rest->slopes, TinkerRowSlope, g_array_index(of_body, guint, i));
        if (g_hash_table_contains(rest->set, GUINT_TO_POINTER(entry->row))) continue;
        if (rows->len > 0 && g_array_index(rows, guint, rows->len - 1) == entry->row) {
            for (int k = 0; k < 3; k++)
                g_array_index(matrix, double, 3 * (rows->len - 1) + (guint)k) += entry->slope[k];
            continue;
        }
        g_array_append_val(rows, entry->row);
        g_array_append_vals(matrix, entry->slope, 3);
    }
}

/* Sets aside what is independent on some body, until nothing changes. */
static void set_aside(Rest *rest, GHashTable *by_body)
{
    g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(guint)),
                      matrix = g_array_new(FALSE, FALSE, sizeof(double));
    for (gboolean changed = TRUE; changed;) {
        GHashTableIter iter;
        gpointer of_body;
        changed = FALSE;
        g_hash_table_iter_init(&iter, by_body);
        while (g_hash_table_iter_next(&iter, NULL, &of_body)) {
            rows_on(rest, of_body, rows, matrix);
            if (rows->len == 0 || rows->len > 3) continue;
            g_autofree double *vt = NULL;
            if (null_space((double *)(void *)matrix->data, 3, rows->len, &vt) < rows->len) continue;
            for (guint i = 0; i < rows->len; i++)
                g_hash_table_add(rest->set, GUINT_TO_POINTER(g_array_index(rows, guint, i)));
            changed = TRUE;
        }
    }
}

/* Marks rows of the rest by the null space of all of it. */
static void mark(TinkerEquationWriter *writer, const Rest *rest, GHashTable *by_body)
{
    g_autoptr(GHashTable) columns = g_hash_table_new(NULL, NULL);
    g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(guint));
    for (guint i = 0; i < rest->slopes->len; i++) {
        const guint row = g_array_index(rest->slopes, TinkerRowSlope, i).row;
        if (g_hash_table_contains(rest->set, GUINT_TO_POINTER(row)) ||
            g_hash_table_contains(columns, GUINT_TO_POINTER(row)))
            continue;
        g_hash_table_insert(columns, GUINT_TO_POINTER(row), GUINT_TO_POINTER(rows->len));
        g_array_append_val(rows, row);
    }
    if (rows->len == 0 || rows->len > MOST_ROWS) return;
    const guint height = 3 * g_hash_table_size(by_body);
    g_autofree double *matrix = g_new0(double, (gsize)height * rows->len), *vt = NULL;
    g_autoptr(GHashTable) numbers = g_hash_table_new(NULL, NULL);
    for (guint i = 0; i < rest->slopes->len; i++) {
        const TinkerRowSlope *entry = &g_array_index(rest->slopes, TinkerRowSlope, i);
        gpointer column, number;
        if (!g_hash_table_lookup_extended(columns, GUINT_TO_POINTER(entry->row), NULL, &column)) continue;
        if (!g_hash_table_lookup_extended(numbers, GINT_TO_POINTER(entry->body), NULL, &number)) {
            number = GUINT_TO_POINTER(g_hash_table_size(numbers));
            g_hash_table_insert(numbers, GINT_TO_POINTER(entry->body), number);
        }
        for (guint k = 0; k < 3; k++)
            matrix[(gsize)GPOINTER_TO_UINT(column) * height + 3 * GPOINTER_TO_UINT(number) + k] += entry->slope[k];
    }
    const guint rank = null_space(matrix, height, rows->len, &vt);
    for (guint i = 0; i < rows->len; i++) {
        double part = 0;
        for (guint k = rank; k < rows->len; k++)
            part = fmax(part, fabs(vt[(gsize)i * rows->len + k]));
        TinkerConstraintEquation *row =
            g_ptr_array_index(writer->equations->constraints, g_array_index(rows, guint, i));
        row->redundant = part > TAKES_PART;
    }
}

void tinker_writer_mark_redundant(TinkerEquationWriter *writer)
{
    g_autoptr(GHashTable) by_body = g_hash_table_new_full(NULL, NULL, NULL, (GDestroyNotify)g_array_unref);
    g_autoptr(GHashTable) set = g_hash_table_new(NULL, NULL);
    Rest rest = {writer->slopes, set};
    for (guint i = 0; i < writer->slopes->len; i++) {
        const TinkerBlockId body = g_array_index(writer->slopes, TinkerRowSlope, i).body;
        GArray *of_body = g_hash_table_lookup(by_body, GINT_TO_POINTER(body));
        if (of_body == NULL) {
            of_body = g_array_new(FALSE, FALSE, sizeof(guint));
            g_hash_table_insert(by_body, GINT_TO_POINTER(body), of_body);
        }
        g_array_append_val(of_body, i);
    }
    set_aside(&rest, by_body);
    mark(writer, &rest, by_body);
}
