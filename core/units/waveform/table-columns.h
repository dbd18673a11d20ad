/* Columns of tables in files, as numbers. */
#ifndef TINKER_CORE_TABLE_COLUMNS_H
#define TINKER_CORE_TABLE_COLUMNS_H

#include <glib.h>

/* Adds the rows of a file, of the form that tinker_waveform_new_table_file reads, to `rows` (of double): time and
 * value in turn. Errors are the same. */
gboolean tinker_table_read_column(const char *path, int column, GArray *rows, GError **error);

#endif
