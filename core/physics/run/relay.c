/* Batches go round between two threads: from the finder, who fills them, into a queue, from which the doer takes them,
 * and back. All lists are under one lock. */
#include "physics/run/relay.h"

#include <sys/resource.h>

#include "numerics/sharing/sharing.h"
#include "plugin/call/crash.h"

/* Of a small scene; and how many are free when a finder that waited for one goes on: there is something to do all the
 * while, and the two wake each other once for several batches. */
#define BATCHES      4
#define BATCHES_FREE 3
/* A doer may be so many items behind, each of them a step or a sample, where these are no more bytes. */
#define ITEMS_BEHIND 1024
#define MOST_BYTES   0x4000000
/* Of a batch at least: some thousand steps of a small scene, which take about a millisecond. */
#define LEAST_BYTES 0x40000
/* Handed over before a thread is worth its start. */
#define BATCHES_ALONE 2
#define ALIGNMENT     16
/* Where processors are short the finder goes first, and who draws what it found. */
#define NICENESS 10
/* us: between two questions for patience. */
#define QUESTION 20000

/* Before each item. */
typedef union {
    gsize bytes; /* with this head */
    char align[ALIGNMENT];
} Head;

typedef struct _Batch Batch;

struct _Batch {
    Batch *next; /* in its list */
    gsize used;
    _Alignas(ALIGNMENT) char bytes[];
};

struct _TinkerRelay {
    TinkerRelayWork work;
    void *data;
    gsize size;    /* bytes of a batch */
    gint64 most;   /* batches that there may be, */
    gint64 count;  /* and are */
    Batch *filled; /* the finder's; NULL where it has none to write to */
    gboolean beside;
    int alone;       /* batches that the finder did itself */
    GThread *thread; /* NULL: the finder works itself */
    GMutex mutex;
    GCond handed_over, done; /* of those below; a call of the kernel, so only where somebody waits: */
    gboolean idle;           /* the doer, for a batch */
    gint64 awaited;          /* the finder, until no more are left to do than this; -1: it does not */
    Batch *spare;            /* free ones, the last used first: that is in the caches */
    Batch *first, *last;     /* handed over, without the one that is being done */
    gint64 left;             /* to do, with that */
    gboolean ends;
};

/* Memory for one, or NULL. */
static Batch *take_up(TinkerRelay *relay, Batch *batch)
{
    if (batch == NULL) return NULL;
    batch->next = NULL;
    batch->used = 0;
    relay->count++;
    return batch;
}

static Batch *new_batch(TinkerRelay *relay)
{
    return take_up(relay, g_try_malloc(sizeof(Batch) + relay->size));
}

/* To be called with the lock held: one to write to, or NULL. */
static Batch *take_spare(TinkerRelay *relay)
{
    Batch *batch = relay->spare;
    if (batch == NULL) return relay->count < relay->most ? new_batch(relay) : NULL;
    relay->spare = batch->next;
    batch->next = NULL;
    return batch;
}

TinkerRelay *tinker_relay_new(gsize largest, gboolean beside, TinkerRelayWork work, void *data)
{
    TinkerRelay *relay = g_new0(TinkerRelay, 1);
    relay->work = work;
    relay->data = data;
    relay->beside = beside;
    relay->size = MAX(LEAST_BYTES, sizeof(Head) + largest + ALIGNMENT);
    relay->most = (gint64)MAX(BATCHES, MIN(ITEMS_BEHIND * (double)largest, MOST_BYTES) / (double)relay->size);
    relay->filled = take_up(relay, g_malloc(sizeof(Batch) + relay->size));
    relay->awaited = -1;
    g_mutex_init(&relay->mutex);
    g_cond_init(&relay->handed_over);
    g_cond_init(&relay->done);
    return relay;
}

static void free_list(Batch *batch)
{
    while (batch != NULL) {
        Batch *next = batch->next;
        g_free(batch);
        batch = next;
    }
}

void tinker_relay_free(TinkerRelay *relay)
{
    if (relay == NULL) return;
    g_mutex_lock(&relay->mutex);
    relay->ends = TRUE;
    g_cond_signal(&relay->handed_over);
    g_mutex_unlock(&relay->mutex);
    if (relay->thread != NULL) g_thread_join(relay->thread);
    g_free(relay->filled);
    free_list(relay->spare);
    free_list(relay->first);
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

/* To be called with the lock held, which is let go meanwhile. */
static void do_first(TinkerRelay *relay)
{
    Batch *batch = relay->first;
    relay->first = batch->next;
    g_mutex_unlock(&relay->mutex);
    do_batch(relay, batch);
    g_mutex_lock(&relay->mutex);
    batch->next = relay->spare;
    relay->spare = batch;
    relay->left--;
    if (relay->left == relay->awaited) g_cond_signal(&relay->done);
}

/* The other thread. */
static gpointer do_batches(gpointer data)
{
    TinkerRelay *relay = data;
    tinker_crash_watch_thread();
    (void)setpriority(PRIO_PROCESS, 0, NICENESS); /* of this thread, on Linux; elsewhere nothing is lost without */
    g_mutex_lock(&relay->mutex);
    for (;;) {
        while (!relay->ends && relay->first == NULL) {
            relay->idle = TRUE;
            g_cond_wait(&relay->handed_over, &relay->mutex);
        }
        relay->idle = FALSE;
        if (relay->ends) break;
        do_first(relay);
    }
    g_mutex_unlock(&relay->mutex);
    return NULL;
}

/* Where memory or threads are short the finder goes on alone. */
static gboolean start_thread(TinkerRelay *relay)
{
    if (!relay->beside || tinker_share_threads() < 2) return FALSE;
    relay->beside = FALSE; /* is tried once */
    while (relay->count < BATCHES) {
        Batch *batch = new_batch(relay);
        if (batch == NULL) return FALSE;
        batch->next = relay->spare;
        relay->spare = batch;
    }
    relay->thread = g_thread_try_new("companion", do_batches, relay, NULL);
    return relay->thread != NULL;
}

/* Until no more than `left` batches wait for being done. To be called with the lock held. */
static gboolean wait_for_batches(TinkerRelay *relay, gint64 left, TinkerRelayPatience patience, void *data)
{
    gboolean goes_on = TRUE;
    relay->awaited = left;
    while (goes_on && relay->left > left) {
        if (g_cond_wait_until(&relay->done, &relay->mutex, g_get_monotonic_time() + QUESTION)) continue;
        g_mutex_unlock(&relay->mutex);
        goes_on = patience == NULL || patience(data);
        g_mutex_lock(&relay->mutex);
    }
    relay->awaited = -1;
    return goes_on;
}

/* To be called with the lock held. */
static void hand_over(TinkerRelay *relay)
{
    if (relay->first == NULL)
        relay->first = relay->filled;
    else
        relay->last->next = relay->filled;
    relay->last = relay->filled;
    relay->left++;
    relay->filled = take_spare(relay);
    if (relay->idle) g_cond_signal(&relay->handed_over);
}

/* The batch is full. What the finder does itself it goes on writing to. */
static void pass_on(TinkerRelay *relay)
{
    if (relay->thread == NULL && (relay->alone++ < BATCHES_ALONE || !start_thread(relay))) {
        do_batch(relay, relay->filled);
        return;
    }
    g_mutex_lock(&relay->mutex);
    hand_over(relay);
    g_mutex_unlock(&relay->mutex);
}

void *tinker_relay_add(TinkerRelay *relay, gsize bytes, TinkerRelayPatience patience, void *data)
{
    const gsize whole = (sizeof(Head) + bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    if (relay->filled != NULL && relay->filled->used + whole > relay->size) pass_on(relay);
    if (relay->filled == NULL) {
        g_mutex_lock(&relay->mutex);
        if (wait_for_batches(relay, MAX(relay->count - BATCHES_FREE, 0), patience, data))
            relay->filled = take_spare(relay);
        g_mutex_unlock(&relay->mutex);
        if (relay->filled == NULL) return NULL;
    }
    Batch *batch = relay->filled;
    Head *head = (Head *)(gpointer)(batch->bytes + batch->used);
    head->bytes = whole;
    batch->used += whole;
    return head + 1;
}

gboolean tinker_relay_finish(TinkerRelay *relay, TinkerRelayPatience patience, void *data)
{
    g_mutex_lock(&relay->mutex);
    const gboolean idle = relay->left == 0;
    if (!idle && relay->filled != NULL && relay->filled->used > 0) hand_over(relay);
    const gboolean done = wait_for_batches(relay, 0, patience, data);
    if (done && relay->filled == NULL) relay->filled = take_spare(relay);
    g_mutex_unlock(&relay->mutex);
    if (idle) do_batch(relay, relay->filled); /* sooner done than handed over */
    return done;
}
