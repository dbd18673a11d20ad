/* A record: rows of doubles, kept in memory up to a limit and in a temporary file beyond it. One thread makes it longer
 * and shorter; any other may read at the same time, and is never kept waiting for the disk. */
#ifndef TINKER_CORE_RECORD_H
#define TINKER_CORE_RECORD_H

#include <glib.h>

typedef struct _TinkerRecord TinkerRecord;

/* Rows of `width` doubles. At most `memory_limit` bytes are kept in memory (0: 64 MiB), but for one row at least.
 * (transfer full) */
TinkerRecord *tinker_record_new(gsize width, gsize memory_limit);
void tinker_record_free(TinkerRecord *record);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerRecord, tinker_record_free)

/* FALSE where there is no memory, or the temporary file cannot be used; the rows before this one can still be read. */
gboolean tinker_record_append(TinkerRecord *record, const double *row, GError **error);

/* Any thread. */
gsize tinker_record_rows(TinkerRecord *record);

/* Reads `count` rows from `first` on, which have been appended. Any thread. */
gboolean tinker_record_read(TinkerRecord *record, gsize first, gsize count, double *rows, GError **error);

/* Forgets all rows from this one on. */
void tinker_record_cut(TinkerRecord *record, gsize rows);

#endif
