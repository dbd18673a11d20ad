/* Shared by its owner and its threads, and freed by whichever lets go last. */
#include "gui/document/run-lane.h"

#include "gui/document/background.h"

#define MOST_THREADS 2

struct _TinkerRunLane {
    gatomicrefcount references;
    void (*work)(void *item);
    void (*drop)(void *item);

    GMutex mutex; /* of what follows */
    int threads;
    void *waiting; /* NULL unless all threads are taken */
};

TinkerRunLane *tinker_run_lane_new(void (*work)(void *item), void (*drop)(void *item))
{
    TinkerRunLane *lane = g_new0(TinkerRunLane, 1);
    g_atomic_ref_count_init(&lane->references);
    g_mutex_init(&lane->mutex);
    lane->work = work;
    lane->drop = drop;
    return lane;
}

void tinker_run_lane_unref(TinkerRunLane *lane)
{
    if (!g_atomic_ref_count_dec(&lane->references)) return;
    g_mutex_clear(&lane->mutex);
    g_free(lane);
}

/* What is to be done next; NULL: nothing, and the thread that asks ends. */
static void *next_item(TinkerRunLane *lane)
{
    g_mutex_lock(&lane->mutex);
    void *item = g_steal_pointer(&lane->waiting);
    if (item == NULL) lane->threads--;
    g_mutex_unlock(&lane->mutex);
    return item;
}

typedef struct {
    TinkerRunLane *lane;
    void *item;
} Start;

static gpointer run(gpointer data)
{
    const Start start = *(Start *)data;
    g_free(data);
    for (void *item = start.item; item != NULL; item = next_item(start.lane))
        start.lane->work(item);
    tinker_run_lane_unref(start.lane);
    tinker_background_leave();
    return NULL;
}

void tinker_run_lane_add(TinkerRunLane *lane, void *item)
{
    g_mutex_lock(&lane->mutex);
    const gboolean starts = lane->threads < MOST_THREADS;
    void *dropped = lane->waiting; // NULL where one starts
    lane->threads += starts;
    lane->waiting = starts ? NULL : item;
    g_mutex_unlock(&lane->mutex);
    if (dropped != NULL) lane->drop(dropped);
    if (!starts) return;
    Start *start = g_new(Start, 1);
    *start = (Start){lane, item};
    g_atomic_ref_count_inc(&lane->references);
    tinker_background_enter();
    g_thread_unref(g_thread_new("run", run, start));
}
