/* A ring of batches between two threads: `filled` counts those that were handed over, `emptied` those that are done,
 * both under one lock; the batch that the finder writes to is number `filled`. */
#include "physics/run/relay.h"

#include "numerics/sharing/sharing.h"
#include "plugin/call/crash.h"

/* In the ring; and how many are left to do when a finder that waited for room goes on: there is something to do all the
 * while, and the two wake each other once for several batches. */
#define BATCHES      4
#define BATCHES_LEFT 1
/* Of a batch at least: some thousand steps of a small scene, which take about a millisecond. */
#define LEAST_BYTES 0x40000
/* Handed over before a thread is worth its start. */
#define BATCHES_ALONE 2
#define ALIGNMENT     16
/* us: between two questions for patience. */
#define QUESTION 20000

/* Before each item. */
typedef union {
    gsize bytes; /* with this head */
    char align[ALIGNMENT];
} Head;

typedef struct {
    char *bytes; /* NULL: never used yet */
    gsize used;
} Batch;

struct _TinkerRelay {
    TinkerRelayWork work;
    void *data;
    gsize size; /* bytes of a batch */
    Batch batches[BATCHES];
    gboolean beside;
    int alone;       /* batches that the finder did itself */
    gboolean waits;  /* the ring is full: the finder has no batch to write to */
    GThread *thread; /* NULL: the finder works itself */
    GMutex mutex;
    GCond handed_over, done; /* of those below; a call of the kernel, so only where somebody waits: */
    gboolean idle;           /* the doer, for a batch */
    gint64 awaited;          /* the finder, until no more are left to do than this; -1: it does not */
    gint64 filled, emptied;
    gboolean ends;
};

TinkerRelay *tinker_relay_new(gsize largest, gboolean beside, TinkerRelayWork work, void *data)
{
    TinkerRelay *relay = g_new0(TinkerRelay, 1);
    relay->work = work;
    relay->data = data;
    relay->beside = beside;
    relay->size = MAX(LEAST_BYTES, sizeof(Head) + largest + ALIGNMENT);
    relay->batches[0].bytes = g_malloc(relay->size);
    relay->awaited = -1;
    g_mutex_init(&relay->mutex);
    g_cond_init(&relay->handed_over);
    g_cond_init(&relay->done);
    return relay;
}

void tinker_relay_free(TinkerRelay *relay)
{
    if (relay == NULL) return;
    g_mutex_lock(&relay->mutex);
    relay->ends = TRUE;
    g_cond_signal(&relay->handed_over);
    g_mutex_unlock(&relay->mutex);
    if (relay->thread != NULL) g_thread_join(relay->thread);
    for (int i = 0; i < BATCHES; i++)
        g_free(relay->batches[i].bytes);
    g_cond_clear(&relay->done);
    g_cond_clear(&relay->handed_over);
    g_mutex_clear(&relay->mutex);
    g_free(relay);
}

static void do_batch(TinkerRelay *relay, Batch *batch)
{
    for (gsize at = 0; at < batch->used;) {
        const Head *head = (const Head *)(gconstpointer)(batch->bytes + at);
        relay->work(relay->data, head + 1);
        at += head->bytes;
    }
    batch->used = 0;
}

/* The other thread. */
static gpointer do_batches(gpointer data)
{
    TinkerRelay *relay = data;
    tinker_crash_watch_thread();
    g_mutex_lock(&relay->mutex);
    for (;;) {
        while (!relay->ends && relay->emptied == relay->filled) {
            relay->idle = TRUE;
            g_cond_wait(&relay->handed_over, &relay->mutex);
        }
        relay->idle = FALSE;
        if (relay->ends) break;
        Batch *batch = &relay->batches[relay->emptied % BATCHES];
        g_mutex_unlock(&relay->mutex);
        do_batch(relay, batch);
        g_mutex_lock(&relay->mutex);
        relay->emptied++;
        if (relay->filled - relay->emptied == relay->awaited) g_cond_signal(&relay->done);
    }
    g_mutex_unlock(&relay->mutex);
    return NULL;
}

/* Where memory or threads are short the finder goes on alone. */
static gboolean start_thread(TinkerRelay *relay)
{
    if (!relay->beside || tinker_share_threads() < 2) return FALSE;
    relay->beside = FALSE; /* is tried once */
    for (int i = 0; i < BATCHES; i++)
        if (relay->batches[i].bytes == NULL && (relay->batches[i].bytes = g_try_malloc(relay->size)) == NULL)
            return FALSE;
    relay->thread = g_thread_try_new("companion", do_batches, relay, NULL);
    return relay->thread != NULL;
}

/* Until no more than `left` batches wait for being done. To be called with the lock held. */
static gboolean wait_for_batches(TinkerRelay *relay, gint64 left, TinkerRelayPatience patience, void *data)
{
    gboolean goes_on = TRUE;
    relay->awaited = left;
    while (goes_on && relay->filled - relay->emptied > left) {
        if (g_cond_wait_until(&relay->done, &relay->mutex, g_get_monotonic_time() + QUESTION)) continue;
        g_mutex_unlock(&relay->mutex);
        goes_on = patience == NULL || patience(data);
        g_mutex_lock(&relay->mutex);
    }
    relay->awaited = -1;
    return goes_on;
}

/* The batch that is being written to. */
static Batch *current(TinkerRelay *relay)
{
    return &relay->batches[relay->filled % BATCHES];
}

/* To be called with the lock held. */
static void hand_over(TinkerRelay *relay)
{
    relay->filled++;
    relay->waits = relay->filled - relay->emptied == BATCHES;
    if (relay->idle) g_cond_signal(&relay->handed_over);
}

/* The batch is full. What the finder does itself leaves the ring where it is. */
static void pass_on(TinkerRelay *relay)
{
    if (relay->thread == NULL && (relay->alone++ < BATCHES_ALONE || !start_thread(relay))) {
        do_batch(relay, current(relay));
        return;
    }
    g_mutex_lock(&relay->mutex);
    hand_over(relay);
    g_mutex_unlock(&relay->mutex);
}

void *tinker_relay_add(TinkerRelay *relay, gsize bytes, TinkerRelayPatience patience, void *data)
{
    const gsize whole = (sizeof(Head) + bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    if (!relay->waits && current(relay)->used + whole > relay->size) pass_on(relay);
    if (relay->waits) {
        g_mutex_lock(&relay->mutex);
        relay->waits = !wait_for_batches(relay, BATCHES_LEFT, patience, data);
        g_mutex_unlock(&relay->mutex);
        if (relay->waits) return NULL;
    }
    Batch *batch = current(relay);
    Head *head = (Head *)(gpointer)(batch->bytes + batch->used);
    head->bytes = whole;
    batch->used += whole;
    return head + 1;
}

gboolean tinker_relay_finish(TinkerRelay *relay, TinkerRelayPatience patience, void *data)
{
    g_mutex_lock(&relay->mutex);
    const gboolean idle = relay->emptied == relay->filled;
    if (!idle && !relay->waits && current(relay)->used > 0) hand_over(relay);
    const gboolean done = wait_for_batches(relay, 0, patience, data);
    if (done) relay->waits = FALSE;
    g_mutex_unlock(&relay->mutex);
    if (idle) do_batch(relay, current(relay)); /* sooner done than handed over */
    return done;
}
