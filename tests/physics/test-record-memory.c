/* A record whose memory cannot be had: every request for it fails in turn. */
#include "physics/record/record.h"

#define ROWS 100000 /* of 16 bytes: some chunks */

static int requests, failing; /* from 1; 0: none */

gpointer __real_g_try_malloc_n(gsize count, gsize size);
__attribute__((visibility("default"))) gpointer __wrap_g_try_malloc_n(gsize count, gsize size);
gpointer __wrap_g_try_malloc_n(gsize count, gsize size)
{
    return ++requests == failing ? NULL : __real_g_try_malloc_n(count, size);
}

/* Appends rows until one fails; answers how many there are. */
static int append(TinkerRecord *record, GError **error)
{
    for (int i = 0; i < ROWS; i++) {
        const double row[] = {i, -i};
        if (!tinker_record_append(record, row, error)) return i;
    }
    return ROWS;
}

static void assert_rows(TinkerRecord *record, int rows)
{
    g_autoptr(GError) error = NULL;
    g_autofree double *values = g_new0(double, 2 * (gsize)rows + 1);
    g_assert_cmpuint(tinker_record_rows(record), ==, (gsize)rows);
    g_assert_true(tinker_record_read(record, 0, (gsize)rows, values, &error));
    g_assert_no_error(error);
    for (int i = 0; i < 2 * rows; i++)
        g_assert_cmpfloat(values[i], ==, i % 2 == 0 ? i / 2 : -(i / 2));
}

/* What was recorded before is kept, the message says what to do, and with memory at hand the record goes on. */
static void test_each_request(void)
{
    for (failing = 1;; failing++) {
        requests = 0;
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerRecord) record = tinker_record_new(2, 0);
        const int rows = append(record, &error);
        if (requests < failing) break;
        g_assert_error(error, G_FILE_ERROR, G_FILE_ERROR_NOMEM);
        g_assert_nonnull(g_strrstr(error->message, "no memory for a record"));
        g_assert_cmpint(rows, <, ROWS);
        assert_rows(record, rows);
        const double next[] = {rows, -rows};
        g_assert_true(tinker_record_append(record, next, NULL));
        assert_rows(record, rows + 1);
    }
    g_assert_cmpint(failing, >, 2);
    failing = 0;
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/physics/record-memory/each-request", test_each_request);
    return g_test_run();
}
