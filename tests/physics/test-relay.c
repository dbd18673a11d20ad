/* Work handed on to another thread: all of it is done once and in its order, on the thread that is to do it, in
 * memory that is there. */
#include <string.h>

#include "allotments.h"
#include "numerics/sharing/sharing.h"
#include "physics/run/relay.h"

/* Fills a batch many times over. */
#define ITEMS 100000
#define MOST  40

typedef struct {
    gint64 number;
    gint32 count;
    double numbers[];
} Item;

typedef struct {
    GThread *finder;
    gint64 done, elsewhere, wrong;
    gint held; /* atomic: whoever works stands still */
} Doer;

static void do_item(void *data, const void *work)
{
    Doer *doer = data;
    const Item *item = work;
    while (g_atomic_int_get(&doer->held))
        g_usleep(100);
    doer->wrong += item->number != doer->done;
    for (gint32 i = 0; i < item->count; i++)
        doer->wrong += item->numbers[i] != (double)(item->number + i);
    doer->done++;
    doer->elsewhere += g_thread_self() != doer->finder;
}

static gsize bytes_of(gint32 count)
{
    return sizeof(Item) + (gsize)count * sizeof(double);
}

/* FALSE where there was no room. */
static gboolean add(TinkerRelay *relay, gint64 number, gint32 count, TinkerRelayPatience patience)
{
    Item *item = tinker_relay_add(relay, bytes_of(count), patience, NULL);
    if (item == NULL) return FALSE;
    *item = (Item){number, count};
    for (gint32 i = 0; i < count; i++)
        item->numbers[i] = (double)(number + i);
    return TRUE;
}

/* Answers how many items another thread did. */
static gint64 relay_items(gboolean beside, gint64 between_finishes)
{
    Doer doer = {.finder = g_thread_self()};
    TinkerRelay *relay = tinker_relay_new(bytes_of(MOST), beside, do_item, &doer);
    for (gint64 i = 0; i < ITEMS; i++) {
        g_assert_true(add(relay, i, (gint32)(i % MOST), NULL));
        if (i % between_finishes != between_finishes - 1) continue;
        g_assert_true(tinker_relay_finish(relay, NULL, NULL));
        g_assert_cmpint(doer.done, ==, i + 1);
    }
    g_assert_true(tinker_relay_finish(relay, NULL, NULL));
    g_assert_cmpint(doer.done, ==, ITEMS);
    g_assert_cmpint(doer.wrong, ==, 0);
    tinker_relay_free(relay);
    return doer.elsewhere;
}

static void test_order(void)
{
    tinker_share_set_threads(2);
    g_assert_cmpint(relay_items(TRUE, ITEMS), >, ITEMS / 2);
    relay_items(TRUE, 7001);
    relay_items(TRUE, 3);
}

static void test_alone(void)
{
    tinker_share_set_threads(2);
    g_assert_cmpint(relay_items(FALSE, ITEMS), ==, 0);
    tinker_share_set_threads(1);
    g_assert_cmpint(relay_items(TRUE, ITEMS), ==, 0);
}

/* What a short run finds is not worth a thread. */
static void test_few(void)
{
    tinker_share_set_threads(2);
    Doer doer = {.finder = g_thread_self()};
    TinkerRelay *relay = tinker_relay_new(bytes_of(MOST), TRUE, do_item, &doer);
    for (gint64 i = 0; i < 1000; i++)
        g_assert_true(add(relay, i, 0, NULL));
    g_assert_true(tinker_relay_finish(relay, NULL, NULL));
    g_assert_cmpint(doer.done, ==, 1000);
    g_assert_cmpint(doer.elsewhere, ==, 0);
    tinker_relay_free(relay);
}

/* Each fills a batch. */
static void test_large(void)
{
    enum { COUNT = 100000 };
    tinker_share_set_threads(2);
    Doer doer = {.finder = g_thread_self()};
    TinkerRelay *relay = tinker_relay_new(bytes_of(COUNT), TRUE, do_item, &doer);
    for (gint64 i = 0; i < 20; i++)
        g_assert_true(add(relay, i, i % 3 == 0 ? 1 : COUNT, NULL));
    g_assert_true(tinker_relay_finish(relay, NULL, NULL));
    g_assert_cmpint(doer.done, ==, 20);
    g_assert_cmpint(doer.wrong, ==, 0);
    g_assert_cmpint(doer.elsewhere, >, 0);
    tinker_relay_free(relay);
}

static gboolean has_none(void *data)
{
    return FALSE;
}

/* The doer stands still, and the finder does not wait for it for ever: what was added until then is done later, and
 * once. */
static void test_patience(void)
{
    tinker_share_set_threads(2);
    Doer doer = {.finder = g_thread_self()};
    TinkerRelay *relay = tinker_relay_new(bytes_of(MOST), TRUE, do_item, &doer);
    gint64 added = 0;
    while (added < ITEMS && doer.done == 0) /* the first batches are done here */
        g_assert_true(add(relay, added++, MOST, NULL));
    while (added < ITEMS / 2)
        g_assert_true(add(relay, added++, MOST, NULL));
    g_atomic_int_set(&doer.held, 1);
    while (added < ITEMS && add(relay, added, MOST, has_none))
        added++;
    g_assert_cmpint(added, <, ITEMS);
    g_assert_false(tinker_relay_finish(relay, has_none, NULL));
    g_assert_false(add(relay, added, MOST, has_none));
    g_atomic_int_set(&doer.held, 0);
    while (added < ITEMS)
        g_assert_true(add(relay, added++, MOST, NULL));
    g_assert_true(tinker_relay_finish(relay, has_none, NULL) || tinker_relay_finish(relay, NULL, NULL));
    g_assert_cmpint(doer.done, ==, ITEMS);
    g_assert_cmpint(doer.wrong, ==, 0);
    tinker_relay_free(relay);
}

/* Of large items a finder gets far ahead of a doer that stands still, and then no farther: its memory has a bound. */
static void test_far_ahead(void)
{
    enum { COUNT = 20000, FEW = 10, FAR = 200, TOO_FAR = 1000 };
    tinker_share_set_threads(2);
    Doer doer = {.finder = g_thread_self()};
    TinkerRelay *relay = tinker_relay_new(bytes_of(COUNT), TRUE, do_item, &doer);
    gint64 added = 0;
    while (added < FEW) /* the first batches are done here */
        g_assert_true(add(relay, added++, COUNT, NULL));
    g_atomic_int_set(&doer.held, 1);
    const gint64 before = added;
    while (added < TOO_FAR && add(relay, added, COUNT, has_none))
        added++;
    g_assert_cmpint(added - before, >, FAR);
    g_assert_cmpint(added, <, TOO_FAR);
    g_atomic_int_set(&doer.held, 0);
    g_assert_true(add(relay, added++, COUNT, NULL));
    g_assert_true(tinker_relay_finish(relay, NULL, NULL));
    g_assert_cmpint(doer.done, ==, added);
    g_assert_cmpint(doer.elsewhere, >, FAR);
    g_assert_cmpint(doer.wrong, ==, 0);
    tinker_relay_free(relay);
}

/* Nobody waits for what is undone. */
static void test_left_undone(void)
{
    tinker_share_set_threads(2);
    for (int round = 0; round < 20; round++) {
        Doer doer = {.finder = g_thread_self()};
        TinkerRelay *relay = tinker_relay_new(bytes_of(MOST), TRUE, do_item, &doer);
        for (gint64 i = 0; i < 1000 * (gint64)(round + 1); i++)
            g_assert_true(add(relay, i, MOST, NULL));
        tinker_relay_free(relay);
        g_assert_cmpint(doer.done, <=, 1000 * (gint64)(round + 1));
        g_assert_cmpint(doer.wrong, ==, 0);
    }
}

static void test_allotments(void)
{
    tinker_share_set_threads(2);
    Doer doer = {.finder = g_thread_self()};
    TinkerRelay *relay = tinker_relay_new(bytes_of(MOST), TRUE, do_item, &doer);
    gint64 i = 0;
    while (i < ITEMS / 2)
        g_assert_true(add(relay, i++, MOST, NULL));
    g_assert_true(tinker_relay_finish(relay, NULL, NULL));
    g_assert_cmpint(doer.elsewhere, >, 0);
    const int before = allotments;
    while (i < ITEMS)
        add(relay, i++, MOST, NULL);
    const int after = allotments;
    g_assert_true(tinker_relay_finish(relay, NULL, NULL));
    g_assert_cmpint(doer.done, ==, ITEMS);
    g_assert_cmpint(after, ==, before);
    tinker_relay_free(relay);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/physics/relay/order", test_order);
    g_test_add_func("/physics/relay/alone", test_alone);
    g_test_add_func("/physics/relay/far-ahead", test_far_ahead);
    g_test_add_func("/physics/relay/few", test_few);
    g_test_add_func("/physics/relay/large", test_large);
    g_test_add_func("/physics/relay/patience", test_patience);
    g_test_add_func("/physics/relay/left-undone", test_left_undone);
    g_test_add_func("/physics/relay/allotments", test_allotments);
    return g_test_run();
}
