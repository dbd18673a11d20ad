/* Rows in chunks of equal size. A chunk is filled in memory; once the memory is full, the oldest is written into an
 * unnamed temporary file, at its own place, and its memory taken for the next. The mutex is held to copy rows of one
 * chunk, or to say that a chunk has left the memory: never while the disk is at work. */
#include "physics/record/record.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <string.h>
#include <unistd.h>

#define DEFAULT_MEMORY ((gsize)64 << 20)
#define CHUNK_BYTES    ((gsize)256 << 10) /* about */
#define LEAST_CHUNKS   4                  /* that a small memory is divided into */

struct _TinkerRecord {
    gsize row_bytes, chunk_rows;
    gsize most_chunks; /* in memory */
    gsize oldest;      /* chunk in memory */
    int file;          /* -1 until it is needed; set before a chunk leaves the memory */

    GMutex mutex;      /* of what follows; the thread that appends reads it without */
    GPtrArray *chunks; /* of char *, chunk_rows rows each; NULL: in the file alone */
    gsize rows;
};

TinkerRecord *tinker_record_new(gsize width, gsize memory_limit)
{
    TinkerRecord *record = g_new0(TinkerRecord, 1);
    const gsize limit = memory_limit > 0 ? memory_limit : DEFAULT_MEMORY;
    record->row_bytes = MAX(width, 1) * sizeof(double);
    record->chunk_rows = MAX(MIN(CHUNK_BYTES, limit / LEAST_CHUNKS) / record->row_bytes, 1);
    record->most_chunks = MAX(limit / (record->chunk_rows * record->row_bytes), 1);
    record->file = -1;
    record->chunks = g_ptr_array_new_with_free_func(g_free);
    g_mutex_init(&record->mutex);
    return record;
}

void tinker_record_free(TinkerRecord *record)
{
    if (record == NULL) return;
    if (record->file >= 0) close(record->file);
    g_ptr_array_unref(record->chunks);
    g_mutex_clear(&record->mutex);
    g_free(record);
}

/* The file
 * ------------------------------------------------------------------------------------------------------------- */

typedef enum { WRITTEN, READ } FileWork;

static gboolean file_error(FileWork failed, GError **error)
{
    const int code = errno;
    g_set_error(error, G_FILE_ERROR, g_file_error_from_errno(code),
                failed == WRITTEN
                    ? _("the record outgrew its memory, and its temporary file could not be written: %s (free some "
                        "room in %s)")
                    : _("the record outgrew its memory, and its temporary file could not be read: %s (free some "
                        "room in %s)"),
                g_strerror(code), g_get_tmp_dir());
    return FALSE;
}

static gboolean open_file(TinkerRecord *record, GError **error)
{
    if (record->file >= 0) return TRUE;
    g_autofree char *name = NULL;
    record->file = g_file_open_tmp("tinker-record-XXXXXX", &name, error);
    if (record->file < 0) return FALSE;
    unlink(name);
    return TRUE;
}

static gboolean write_all(int file, const char *bytes, gsize count, off_t place)
{
    while (count > 0) {
        const ssize_t written = pwrite(file, bytes, count, place);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return FALSE;
        bytes += written;
        count -= (gsize)written;
        place += written;
    }
    return TRUE;
}

static gboolean read_all(int file, char *bytes, gsize count, off_t place)
{
    while (count > 0) {
        const ssize_t got = pread(file, bytes, count, place);
        if (got < 0 && errno == EINTR) continue;
        if (got == 0) errno = EIO; // somebody has made it shorter
        if (got <= 0) return FALSE;
        bytes += got;
        count -= (gsize)got;
        place += got;
    }
    return TRUE;
}

static gboolean read_file(const TinkerRecord *record, gsize first, gsize count, char *rows, GError **error)
{
    return read_all(record->file, rows, count * record->row_bytes, (off_t)(first * record->row_bytes)) ||
           file_error(READ, error);
}

/* Growing
 * -------------------------------------------------------------------------------------------------------------- */

static gsize chunk_bytes(const TinkerRecord *record)
{
    return record->chunk_rows * record->row_bytes;
}

/* How much is recorded is the user's choice, so that a lack of memory is an error like another. */
static char *new_memory(const TinkerRecord *record, GError **error)
{
    char *memory = g_try_malloc_n(record->chunk_rows, record->row_bytes);
    if (memory == NULL)
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_NOMEM,
                    _("there is no memory for a record of %zu rows of %zu bytes (record fewer quantities)"),
                    record->rows + record->chunk_rows, record->row_bytes);
    return memory;
}

/* Writes the oldest chunk in memory into the file, and answers the memory that it had. (transfer full) */
static char *spill(TinkerRecord *record, GError **error)
{
    char *memory = record->chunks->pdata[record->oldest];
    if (!open_file(record, error)) return NULL;
    if (!write_all(record->file, memory, chunk_bytes(record), (off_t)(record->oldest * chunk_bytes(record)))) {
        file_error(WRITTEN, error);
        return NULL;
    }
    g_mutex_lock(&record->mutex);
    record->chunks->pdata[record->oldest++] = NULL;
    g_mutex_unlock(&record->mutex);
    return memory;
}

static char *memory_for_chunk(TinkerRecord *record, GError **error)
{
    const gboolean full = record->chunks->len - record->oldest >= record->most_chunks;
    return full ? spill(record, error) : new_memory(record, error);
}

/* The chunk that the next row belongs into, which is in memory then. A record that was cut within a chunk of the file
 * takes that chunk back. */
static char *chunk_to_fill(TinkerRecord *record, GError **error)
{
    const gsize number = record->rows / record->chunk_rows, started = record->rows % record->chunk_rows;
    if (number < record->chunks->len && record->chunks->pdata[number] != NULL) return record->chunks->pdata[number];
    g_autofree char *memory = memory_for_chunk(record, error);
    if (memory == NULL || (started > 0 && !read_file(record, record->rows - started, started, memory, error)))
        return NULL;
    g_mutex_lock(&record->mutex);
    g_ptr_array_set_size(record->chunks, (int)number);
    g_ptr_array_add(record->chunks, memory);
    g_mutex_unlock(&record->mutex);
    record->oldest = MIN(record->oldest, number);
    return g_steal_pointer(&memory);
}

gboolean tinker_record_append(TinkerRecord *record, const double *row, GError **error)
{
    char *chunk = chunk_to_fill(record, error);
    if (chunk == NULL) return FALSE;
    memcpy(chunk + record->rows % record->chunk_rows * record->row_bytes, row, record->row_bytes);
    g_mutex_lock(&record->mutex);
    record->rows++; // only now does anybody read it
    g_mutex_unlock(&record->mutex);
    return TRUE;
}

gsize tinker_record_rows(TinkerRecord *record)
{
    g_mutex_lock(&record->mutex);
    const gsize rows = record->rows;
    g_mutex_unlock(&record->mutex);
    return rows;
}

/* Chunks that hold no row any more go from the memory; in the file they lie where the next of their number will. */
void tinker_record_cut(TinkerRecord *record, gsize rows)
{
    if (rows >= record->rows) return;
    const gsize chunks = (rows + record->chunk_rows - 1) / record->chunk_rows;
    g_mutex_lock(&record->mutex);
    record->rows = rows;
    g_ptr_array_set_size(record->chunks, (int)chunks);
    g_mutex_unlock(&record->mutex);
    record->oldest = MIN(record->oldest, chunks);
}

/* Reading
 * -------------------------------------------------------------------------------------------------------------- */

/* Copies rows that lie in one chunk; FALSE where that is in the file alone. */
static gboolean copy_from_memory(TinkerRecord *record, gsize first, gsize count, char *rows)
{
    const gsize number = first / record->chunk_rows;
    g_mutex_lock(&record->mutex);
    const char *chunk = number < record->chunks->len ? record->chunks->pdata[number] : NULL;
    if (chunk != NULL) memcpy(rows, chunk + first % record->chunk_rows * record->row_bytes, count * record->row_bytes);
    g_mutex_unlock(&record->mutex);
    return chunk != NULL;
}

gboolean tinker_record_read(TinkerRecord *record, gsize first, gsize count, double *rows, GError **error)
{
    char *out = (char *)rows;
    while (count > 0) {
        const gsize some = MIN(count, record->chunk_rows - first % record->chunk_rows);
        if (!copy_from_memory(record, first, some, out) && !read_file(record, first, some, out, error)) return FALSE;
        out += some * record->row_bytes;
        first += some;
        count -= some;
    }
    return TRUE;
}
