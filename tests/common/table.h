/* A record as `tinker run --csv` writes it: time in the first column, quantities of blocks in the others. */
#ifndef TEST_TABLE_H
#define TEST_TABLE_H

#include <glib.h>

typedef struct {
    gsize rows, columns;
    char **names;   /* without their units: "time", "Mass 0.x", ... */
    double *values; /* row by row */
} TestTable;

/* Reads CSV text; fails the test where that is not a table of finite numbers under a header. (transfer full) */
TestTable *test_table_new(const char *text);
void test_table_free(TestTable *table);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TestTable, test_table_free)

/* A value. Fails the test where there is no such column. */
double test_table_value(const TestTable *table, gsize row, const char *column);
gboolean test_table_has(const TestTable *table, const char *column);

/* The row of a time, to 1e-12; fails the test where there is none. */
gsize test_table_row(const TestTable *table, double time);

#endif
