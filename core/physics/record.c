/* Rows in memory, and in an unnamed temporary file once the memory is full: the file holds the rows from the first one
 * on, the memory those behind them. */
#include "physics/record.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define DEFAULT_MEMORY ((gsize)64 << 20)

struct _TinkerRecord {
    gsize row_bytes;
    gsize capacity; /* rows in memory */
    gsize allotted; /* rows that `memory` has room for */
    char *memory;
    gsize in_memory, in_file;
    FILE *file;
};

TinkerRecord *tinker_record_new(gsize width, gsize memory_limit)
{
    TinkerRecord *record = g_new0(TinkerRecord, 1);
    record->row_bytes = MAX(width, 1) * sizeof(double);
    record->capacity = MAX((memory_limit > 0 ? memory_limit : DEFAULT_MEMORY) / record->row_bytes, 1);
    return record;
}

void tinker_record_free(TinkerRecord *record)
{
    if (record == NULL) return;
    if (record->file != NULL) fclose(record->file);
    g_free(record->memory);
    g_free(record);
}

typedef enum { OPENED, WRITTEN, READ } FileWork;

static gboolean file_error(FileWork failed, GError **error)
{
    const int code = errno;
    g_set_error(error, G_FILE_ERROR, g_file_error_from_errno(code),
                failed == OPENED
                    ? _("the record outgrew its memory, and its temporary file could not be opened: %s (free some "
                        "room in %s)")
                : failed == WRITTEN
                    ? _("the record outgrew its memory, and its temporary file could not be written: %s (free some "
                        "room in %s)")
                    : _("the record outgrew its memory, and its temporary file could not be read: %s (free some "
                        "room in %s)"),
                g_strerror(code), g_get_tmp_dir());
    return FALSE;
}

static gboolean spill(TinkerRecord *record, GError **error)
{
    if (record->file == NULL) {
        char *name = NULL;
        int descriptor = g_file_open_tmp("tinker-record-XXXXXX", &name, error);
        if (descriptor < 0) return FALSE;
        unlink(name);
        g_free(name);
        record->file = fdopen(descriptor, "w+b");
        if (record->file == NULL) {
            close(descriptor);
            return file_error(OPENED, error);
        }
    }
    if (fseeko(record->file, (off_t)(record->in_file * record->row_bytes), SEEK_SET) != 0 ||
        fwrite(record->memory, record->row_bytes, record->in_memory, record->file) != record->in_memory)
        return file_error(WRITTEN, error);
    record->in_file += record->in_memory;
    record->in_memory = 0;
    return TRUE;
}

/* Room for more rows. How much is the user's choice, by what is recorded and how often, so none is an error like another. */
static gboolean grow(TinkerRecord *record, GError **error)
{
    const gsize allotted = MIN(MAX(2 * record->allotted, 64), record->capacity);
    char *memory = g_try_realloc_n(record->memory, allotted, record->row_bytes);
    if (memory == NULL) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_NOMEM,
                    _("there is no memory for a record of %zu rows of %zu bytes (record fewer quantities)"), allotted,
                    record->row_bytes);
        return FALSE;
    }
    record->memory = memory;
    record->allotted = allotted;
    return TRUE;
}

gboolean tinker_record_append(TinkerRecord *record, const double *row, GError **error)
{
    if (record->in_memory == record->capacity && !spill(record, error)) return FALSE;
    if (record->in_memory == record->allotted && !grow(record, error)) return FALSE;
    memcpy(record->memory + record->in_memory * record->row_bytes, row, record->row_bytes);
    record->in_memory++;
    return TRUE;
}

gsize tinker_record_rows(const TinkerRecord *record)
{
    return record->in_file + record->in_memory;
}

gboolean tinker_record_read(TinkerRecord *record, gsize first, gsize count, double *rows, GError **error)
{
    char *out = (char *)rows;
    gsize from_file = first < record->in_file ? MIN(count, record->in_file - first) : 0;
    if (from_file > 0) {
        if (fseeko(record->file, (off_t)(first * record->row_bytes), SEEK_SET) != 0 ||
            fread(out, record->row_bytes, from_file, record->file) != from_file)
            return file_error(READ, error);
    }
    if (count > from_file)
        memcpy(out + from_file * record->row_bytes,
               record->memory + (first + from_file - record->in_file) * record->row_bytes,
               (count - from_file) * record->row_bytes);
    return TRUE;
}

void tinker_record_cut(TinkerRecord *record, gsize rows)
{
    if (rows >= tinker_record_rows(record)) return;
    if (rows < record->in_file) {
        record->in_file = rows;
        record->in_memory = 0;
    } else {
        record->in_memory = rows - record->in_file;
    }
}
