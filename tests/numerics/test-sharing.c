/* Loops shared among threads: every part is done once, whoever does it. */
#include <glib.h>
#include <stdatomic.h>

#include "numerics/sharing/sharing.h"

#define MOST_PARTS 211

typedef struct {
    _Atomic int32_t times[MOST_PARTS]; /* that each part was done */
} Tally;

static void count(void *data, int32_t part)
{
    Tally *tally = data;
    volatile double x = 1;
    for (int i = 0; i < 100 * (part % 7); i++)
        x = x * 0.5 + 1;
    atomic_fetch_add(&tally->times[part], 1);
}

static void share_and_check(int32_t parts)
{
    Tally tally = {{0}};
    tinker_share(parts, count, &tally);
    for (int32_t part = 0; part < MOST_PARTS; part++)
        g_assert_cmpint(atomic_load(&tally.times[part]), ==, part < parts ? 1 : 0);
}

static void test_every_part_once(void)
{
    for (int threads = 1; threads <= 8; threads++) {
        tinker_share_set_threads(threads);
        g_assert_cmpint(tinker_share_threads(), ==, threads);
        for (int32_t parts = 0; parts <= MOST_PARTS; parts += 1 + parts / 5)
            for (int repeat = 0; repeat < 20; repeat++)
                share_and_check(parts);
    }
}

/* Helpers have gone to sleep in between. */
static void test_after_a_pause(void)
{
    tinker_share_set_threads(4);
    for (int repeat = 0; repeat < 5; repeat++) {
        g_usleep(3000);
        share_and_check(MOST_PARTS);
    }
}

static gpointer share_often(gpointer data)
{
    for (int repeat = 0; repeat < 300; repeat++)
        share_and_check(1 + repeat % MOST_PARTS);
    return NULL;
}

static void test_several_callers(void)
{
    GThread *threads[3];
    tinker_share_set_threads(3);
    for (gsize i = 0; i < G_N_ELEMENTS(threads); i++)
        threads[i] = g_thread_new("caller", share_often, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(threads); i++)
        g_thread_join(threads[i]);
}

static void share_inside(void *data, int32_t part)
{
    share_and_check(10 + part);
}

static void test_inside_a_part(void)
{
    tinker_share_set_threads(4);
    tinker_share(5, share_inside, NULL);
}

typedef struct {
    unsigned char *times;
} Marks;

static void mark(void *data, int32_t first, int32_t end)
{
    const Marks *marks = data;
    for (int32_t i = first; i < end; i++)
        marks->times[i]++;
}

static void test_ranges(void)
{
    const int32_t counts[] = {0, 1, TINKER_SHARE_LEAST - 1, TINKER_SHARE_LEAST, TINKER_SHARE_LEAST + 1, 100003};
    tinker_share_set_threads(4);
    for (gsize k = 0; k < G_N_ELEMENTS(counts); k++) {
        g_autofree unsigned char *times = g_new0(unsigned char, counts[k] + 1);
        tinker_share_range(counts[k], mark, &(Marks){times});
        for (int32_t i = 0; i < counts[k]; i++)
            g_assert_cmpint(times[i], ==, 1);
        g_assert_cmpint(times[counts[k]], ==, 0);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/sharing/every-part-once", test_every_part_once);
    g_test_add_func("/numerics/sharing/after-a-pause", test_after_a_pause);
    g_test_add_func("/numerics/sharing/several-callers", test_several_callers);
    g_test_add_func("/numerics/sharing/inside-a-part", test_inside_a_part);
    g_test_add_func("/numerics/sharing/ranges", test_ranges);
    return g_test_run();
}
