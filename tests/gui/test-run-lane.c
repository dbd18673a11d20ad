/* However fast runs are asked for, two at most are worked on at a time, and the newest is. */
#include <glib.h>

#include "gui/document/background.h"
#include "gui/document/run-lane.h"

#define MOST_AT_A_TIME 2
#define ADDED          300

typedef struct {
    GMutex mutex; /* of what follows */
    GCond changed;
    int working, most_working, worked, dropped;
    int newest;    /* the highest number of an item that was worked on */
    gboolean held; /* work does not end */
} Account;

static Account account;

static void work(void *item)
{
    g_mutex_lock(&account.mutex);
    account.working++;
    account.most_working = MAX(account.most_working, account.working);
    while (account.held)
        g_cond_wait(&account.changed, &account.mutex);
    account.working--;
    account.worked++;
    account.newest = MAX(account.newest, GPOINTER_TO_INT(item));
    g_cond_broadcast(&account.changed);
    g_mutex_unlock(&account.mutex);
}

static void drop(void *item)
{
    (void)item;
    g_mutex_lock(&account.mutex);
    account.dropped++;
    g_mutex_unlock(&account.mutex);
}

static void hold(gboolean held)
{
    g_mutex_lock(&account.mutex);
    account.held = held;
    g_cond_broadcast(&account.changed);
    g_mutex_unlock(&account.mutex);
}

static void forget(void)
{
    account.working = account.most_working = account.worked = account.dropped = account.newest = 0;
}

/* Of `ADDED` items the first two are held; all between them and the last make room for it. */
static void test_held(void)
{
    forget();
    hold(TRUE);
    TinkerRunLane *lane = tinker_run_lane_new(work, drop);
    for (int i = 1; i <= ADDED; i++)
        tinker_run_lane_add(lane, GINT_TO_POINTER(i));
    tinker_run_lane_unref(lane);
    hold(FALSE);
    g_assert_true(tinker_background_wait(60));
    g_assert_cmpint(account.most_working, <=, MOST_AT_A_TIME);
    g_assert_cmpint(account.worked, ==, MOST_AT_A_TIME + 1);
    g_assert_cmpint(account.dropped, ==, ADDED - account.worked);
    g_assert_cmpint(account.newest, ==, ADDED);
}

/* Items come while others end. */
static void test_ending(void)
{
    forget();
    TinkerRunLane *lane = tinker_run_lane_new(work, drop);
    for (int i = 1; i <= ADDED; i++) {
        tinker_run_lane_add(lane, GINT_TO_POINTER(i));
        if (i % 3 == 0) g_usleep(50);
    }
    tinker_run_lane_unref(lane);
    g_assert_true(tinker_background_wait(60));
    g_assert_cmpint(account.most_working, <=, MOST_AT_A_TIME);
    g_assert_cmpint(account.worked + account.dropped, ==, ADDED);
    g_assert_cmpint(account.newest, ==, ADDED);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_mutex_init(&account.mutex);
    g_cond_init(&account.changed);
    g_test_add_func("/run-lane/held", test_held);
    g_test_add_func("/run-lane/ending", test_ending);
    return g_test_run();
}
