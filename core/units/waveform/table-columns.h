/* Columns of tables in files, as numbers. */
#ifndef TINKER_CORE_TABLE_COLUMNS_H
#define TINKER_CORE_TABLE_COLUMNS_H

#include <glib.h>

/* Adds the rows of a file, of the form that tinker_waveform_new_table_file reads, to `rows` (of double): time and
 * value in turn. Either may be in any column, from 0. Errors are the same. */
gboolean tinker_table_read_column(const char *path, int time_column, int column, GArray *rows, GError **error);

/* The names of the columns by the heading of the file, one for each column; empty where it has none. (transfer full)
 * NULL where the file cannot be read or holds nothing. */
GPtrArray *tinker_table_column_names(const char *path, GError **error);

#endif
