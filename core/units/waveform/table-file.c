/* Tables in files: numbers in lines, separated by commas, semicolons, tabs or blanks. The first line that is not a
 * comment may be a header. A file is read line by line. */
#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "units/waveform/table-columns.h"
#include "units/waveform/table-private.h"

#define LONGEST_LINE 65536 /* bytes */
#define MOST_NAMES   200   /* of columns, for people to choose from */

typedef struct {
    const char *path;
    FILE *file;
    char line[LONGEST_LINE];
    glong line_number;
    int time_column, column;
    double scale;
    gsize rows, room;
    double *times, *values; /* of `rows`, with room for more */
} TableReader;

/* One field of a line; empty where the line has not so many. */
typedef struct {
    const char *start;
    gsize length;
} Field;

G_GNUC_PRINTF(4, 5)
static gboolean fail(const TableReader *reader, const char *place, GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE, "%s:%ld:%ld: %s", reader->path,
                reader->line_number, (glong)(place - reader->line) + 1, message);
    return FALSE;
}

static void skip_blanks(const char **at)
{
    while (**at == ' ' || **at == '\t')
        (*at)++;
}

static Field find_field(const char *line, int index)
{
    static const char separators[] = ",;\t";
    const gboolean blanks_separate = strpbrk(line, separators) == NULL;
    const char *ends = blanks_separate ? " " : separators;
    const char *at = line;
    for (;;) {
        while (*at == ' ')
            at++;
        Field field = {at, strcspn(at, ends)};
        at += field.length;
        if (index-- == 0 || *at == '\0') {
            if (index >= 0) return (Field){at, 0};
            while (field.length > 0 && field.start[field.length - 1] == ' ')
                field.length--;
            return field;
        }
        at++;
    }
}

static gboolean field_number(Field field, double *number)
{
    char digits[64];
    if (field.length == 0 || field.length >= sizeof digits) return FALSE;
    memcpy(digits, field.start, field.length);
    digits[field.length] = '\0';
    /* no hexadecimal digits; "nan" and "inf" are read, and refused as numbers */
    if (strpbrk(digits, "xX") != NULL) return FALSE;
    char *end;
    *number = g_ascii_strtod(digits, &end);
    return *end == '\0';
}

/* A number of the row, its time or its value, that is finite, as it must be. */
static gboolean read_field(const TableReader *reader, int index, gboolean is_time, double *number, GError **error)
{
    const Field field = find_field(reader->line, index);
    const int length = (int)MIN(field.length, 32);
    if (field.length == 0)
        return fail(reader, field.start, error,
                    is_time ? _("the time is missing (column %d)") : _("the value is missing (column %d)"), index);
    if (!field_number(field, number))
        return fail(reader, field.start, error,
                    is_time ? _("the time must be a number, not \"%.*s\"")
                            : _("the value must be a number, not \"%.*s\""),
                    length, field.start);
    if (isfinite(*number)) return TRUE;
    return fail(reader, field.start, error, "%s",
                is_time ? _("the time must be finite") : _("the value must be finite"));
}

static gboolean enlarge(double **column, gsize room)
{
    double *larger = g_try_renew(double, *column, room);
    if (larger == NULL) return FALSE;
    *column = larger;
    return TRUE;
}

/* Room for one more row. How many there are is up to the file, so no memory for them is an error like another. */
static gboolean make_room(TableReader *reader, GError **error)
{
    if (reader->rows < reader->room) return TRUE;
    const gsize room = MAX(2 * reader->room, 64);
    if (enlarge(&reader->times, room) && enlarge(&reader->values, room)) {
        reader->room = room;
        return TRUE;
    }
    g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE,
                _("%s: there is no memory for more than %lu rows"), reader->path, (gulong)reader->rows);
    return FALSE;
}

static gboolean read_row(TableReader *reader, GError **error)
{
    double time, value;
    const char *start = find_field(reader->line, reader->time_column).start;
    if (!read_field(reader, reader->time_column, TRUE, &time, error)) return FALSE;
    if (!read_field(reader, reader->column, FALSE, &value, error)) return FALSE;
    if (reader->rows == TINKER_TABLE_MOST_ROWS)
        return fail(reader, start, error, _("a table has at most %d rows"), TINKER_TABLE_MOST_ROWS);
    if (reader->rows > 0) {
        const double last = reader->times[reader->rows - 1];
        if (time <= last)
            return fail(reader, start, error, _("the time %g must be greater than %g in the row before"), time, last);
    }
    value *= reader->scale;
    if (!isfinite(value))
        return fail(reader, find_field(reader->line, reader->column).start, error, "%s",
                    _("the scaled value is too large"));
    if (!make_room(reader, error)) return FALSE;
    reader->times[reader->rows] = time;
    reader->values[reader->rows++] = value;
    return TRUE;
}

/* A line of names instead of numbers: the time is no number, and nor is it one that went wrong. */
static gboolean is_header(const char *line, int time_column)
{
    double number;
    const Field field = find_field(line, time_column);
    const gunichar first = g_utf8_get_char_validated(field.start, (gssize)field.length);
    return !field_number(field, &number) && (first == '"' || first == '(' || g_unichar_isalpha(first));
}

/* Reads the next line that holds something. FALSE at the end of the file, or where the error says what is wrong. */
static gboolean next_line(TableReader *reader, GError **error)
{
    while (fgets(reader->line, sizeof reader->line, reader->file) != NULL) {
        reader->line_number++;
        const gsize length = strlen(reader->line);
        if (length + 1 == sizeof reader->line && reader->line[length - 1] != '\n')
            return fail(reader, reader->line, error, _("the line is longer than %d bytes"), LONGEST_LINE - 2);
        if (reader->line_number == 1 && g_str_has_prefix(reader->line, "\xEF\xBB\xBF"))
            memset(reader->line, ' ', 3); /* a byte order mark */
        g_strchomp(reader->line);
        const char *start = reader->line;
        skip_blanks(&start);
        if (*start != '\0' && *start != '#') return TRUE;
    }
    if (ferror(reader->file))
        g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE, _("%s: cannot be read: %s"), reader->path,
                    g_strerror(errno));
    return FALSE;
}

static gboolean read_lines(TableReader *reader, GError **error)
{
    g_autoptr(GError) fault = NULL;
    gboolean header_possible = TRUE;
    while (next_line(reader, &fault)) {
        const gboolean header = header_possible && is_header(reader->line, reader->time_column);
        header_possible = FALSE;
        if (!header && !read_row(reader, error)) return FALSE;
    }
    if (fault == NULL) return TRUE;
    g_propagate_error(error, g_steal_pointer(&fault));
    return FALSE;
}

/* Opens a regular file; anything else, such as a pipe, might never end. */
static FILE *open_regular(const char *path, GError **error)
{
    struct stat status;
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "r") : NULL;
    if (file == NULL || fstat(descriptor, &status) != 0) {
        g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE, _("%s: cannot be opened: %s"), path,
                    g_strerror(errno));
        if (file != NULL) fclose(file);
        return NULL;
    }
    if (S_ISREG(status.st_mode) && status.st_size <= TINKER_TABLE_MOST_BYTES) return file;
    if (!S_ISREG(status.st_mode))
        g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE, _("%s: must be a file"), path);
    else
        g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_FILE,
                    _("%s: has %ld bytes, a table has at most %d"), path, (glong)status.st_size,
                    TINKER_TABLE_MOST_BYTES);
    fclose(file);
    return NULL;
}

/* All rows, scaled; a header is passed over. */
static gboolean read_file(TableReader *reader, GError **error)
{
    reader->file = open_regular(reader->path, error);
    if (reader->file == NULL) return FALSE;
    const gboolean good = read_lines(reader, error);
    fclose(reader->file);
    if (good && reader->rows == 0) return fail(reader, reader->line, error, "%s", _("the file has no rows of numbers"));
    return good;
}

TinkerTable *tinker_table_read(const char *path, int column, double scale, TinkerTableKind kind, GError **error)
{
    if (column < 1 || !isfinite(scale)) {
        g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_TABLE,
                    _("%s: column must be at least 1 (the time is in column 0), and scale finite"), path);
        return NULL;
    }
    g_autofree TableReader *reader = g_new0(TableReader, 1);
    reader->path = path;
    reader->column = column;
    reader->scale = scale;
    if (!read_file(reader, error)) {
        g_free(reader->times);
        g_free(reader->values);
        return NULL;
    }
    TinkerTable *table = tinker_table_new(reader->times, reader->values, reader->rows, kind, error);
    if (table == NULL) {
        g_prefix_error(error, "%s: ", path);
        return NULL;
    }
    table->column = column;
    table->scale = scale;
    return table;
}

gboolean tinker_table_read_column(const char *path, int time_column, int column, GArray *rows, GError **error)
{
    g_autofree TableReader *reader = g_new0(TableReader, 1);
    reader->path = path;
    reader->time_column = time_column;
    reader->column = column;
    reader->scale = 1;
    const gboolean good = read_file(reader, error);
    for (gsize i = 0; good && i < reader->rows; i++) {
        g_array_append_val(rows, reader->times[i]);
        g_array_append_val(rows, reader->values[i]);
    }
    g_free(reader->times);
    g_free(reader->values);
    return good;
}

/* The fields of a line as texts without their quotation marks; empty ones where one of them is a number. */
static GPtrArray *names_of(const char *line)
{
    GPtrArray *names = g_ptr_array_new_with_free_func(g_free);
    gboolean header = TRUE;
    double number;
    for (int i = 0; i < MOST_NAMES; i++)
        header = header && !field_number(find_field(line, i), &number);
    for (int i = 0; i < MOST_NAMES; i++) {
        const Field field = find_field(line, i);
        if (field.length == 0 && *field.start == '\0') break;
        g_autofree char *text = g_strndup(field.start, header ? field.length : 0);
        if (text[0] == '"' && field.length > 1 && text[field.length - 1] == '"') {
            text[field.length - 1] = '\0';
            memmove(text, text + 1, field.length - 1);
        }
        g_ptr_array_add(names, g_utf8_make_valid(text, -1));
    }
    return names;
}

GPtrArray *tinker_table_column_names(const char *path, GError **error)
{
    g_autofree TableReader *reader = g_new0(TableReader, 1);
    g_autoptr(GError) fault = NULL;
    reader->path = path;
    reader->file = open_regular(path, error);
    if (reader->file == NULL) return NULL;
    const gboolean found = next_line(reader, &fault);
    fclose(reader->file);
    if (found) return names_of(reader->line);
    if (fault != NULL)
        g_propagate_error(error, g_steal_pointer(&fault));
    else
        fail(reader, reader->line, error, "%s", _("the file has no rows of numbers"));
    return NULL;
}
