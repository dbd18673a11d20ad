/* One job at a time. Its parts are handed out by one atomic word that holds the number of the job and how many parts
 * were taken: by the caller from the front, by helpers from the back, so that the same arrays stay in the caches of the
 * same processors from loop to loop. A helper that comes late, with the fields of an older or a newer job in its hands,
 * fails to take a part of it.
 *
 * Helpers spin for a moment after a job, since the next loop of the same step follows at once, then sleep. The caller
 * must wait for a part that a helper has begun. Where it would have been done sooner alone, since the helper lost its
 * processor, the helpers are left out for a multiple of what was lost; likewise for a while where a helper finds itself
 * on the caller's processor, which it would only take time from. So however busy the machine, little is lost. */
#include "numerics/sharing/sharing.h"

#include <glib.h>
#include <sched.h>
#include <stdatomic.h>

#define MOST_THREADS 8
/* Looks for the next job before a helper sleeps: some 50 microseconds. */
#define HELPER_SPINS 4000
/* Looks for the end of the last part between two looks at the clock. */
#define CALLER_SPINS 500
/* µs: a longer wait is no part being finished but a helper that is not running; only then has the caller's processor
 * something better to do. */
#define LONG_WAIT 300
/* µs: a loss that nobody minds. */
#define SHORT_WAIT 5
/* µs: so long helpers are left out that found no processor of their own. */
#define CROWDED_REST 3000
/* Helpers are left out for so many times what was lost. */
#define REST_FACTOR 20
#define RANGE_PART  8192

static struct {
    _Atomic uint64_t place; /* job number << 32 | parts taken from the back << 16 | from the front */
    _Atomic int32_t parts, finished, sleepers;
    atomic_int processor; /* of the caller */
    atomic_bool crowded;  /* a helper found itself there */
    _Atomic(TinkerShareWork) work;
    _Atomic(void *) data;
    atomic_flag taken; /* by a caller */
    atomic_int threads, helpers;
    gint64 rests_until; /* µs, monotonic */
    GMutex mutex;
    GCond wake;
} shared = {.taken = ATOMIC_FLAG_INIT};

static inline void relax(void)
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

#define FRONT     1u
#define BACK      0x10000u
#define MOST_PART 0xffff

static inline int32_t front(uint64_t place)
{
    return (int32_t)(place & 0xffff);
}

static inline int32_t back(uint64_t place)
{
    return (int32_t)(place >> 16 & 0xffff);
}

/* Does parts until none is left; answers how many. `step` says which end they are taken from. */
static int32_t take_parts(uint64_t step)
{
    int32_t done = 0;
    uint64_t place = atomic_load(&shared.place);
    for (;;) {
        int32_t parts = atomic_load_explicit(&shared.parts, memory_order_relaxed);
        if (front(place) + back(place) >= parts) return done;
        TinkerShareWork work = atomic_load_explicit(&shared.work, memory_order_relaxed);
        void *data = atomic_load_explicit(&shared.data, memory_order_relaxed);
        if (!atomic_compare_exchange_weak(&shared.place, &place, place + step)) continue;
        work(data, step == FRONT ? front(place) : parts - 1 - back(place));
        done++;
        place = atomic_load(&shared.place);
    }
}

static int this_processor(void)
{
#if defined(__linux__)
    return sched_getcpu();
#else
    return -1;
#endif
}

/* Whether there is a part to take, of a job other than `skipped`. */
static gboolean is_open(uint64_t skipped)
{
    uint64_t place = atomic_load(&shared.place);
    return place >> 32 != skipped && front(place) + back(place) < atomic_load(&shared.parts);
}

static gboolean is_crowded(void)
{
    int processor = this_processor();
    return processor >= 0 && processor == atomic_load(&shared.processor);
}

static void wait_for_job(uint64_t skipped)
{
    for (int i = 0; i < HELPER_SPINS; i++) {
        if (is_open(skipped)) return;
        relax();
        if (i % 64 == 63 && is_crowded()) break;
    }
    g_mutex_lock(&shared.mutex);
    atomic_fetch_add(&shared.sleepers, 1);
    while (!is_open(skipped))
        g_cond_wait(&shared.wake, &shared.mutex);
    atomic_fetch_sub(&shared.sleepers, 1);
    g_mutex_unlock(&shared.mutex);
}

static gpointer help(gpointer data)
{
    uint64_t skipped = 0;
    for (;;) {
        wait_for_job(skipped);
        if (is_crowded()) {
            atomic_store(&shared.crowded, TRUE);
            skipped = atomic_load(&shared.place) >> 32;
        } else {
            atomic_fetch_add(&shared.finished, take_parts(BACK));
        }
    }
    return NULL;
}

static void open_job(int32_t parts, TinkerShareWork work, void *data)
{
    uint64_t next = (atomic_load(&shared.place) >> 32) + 1;
    atomic_store(&shared.place, next << 32 | MOST_PART); /* nobody takes a part while the fields change */
    atomic_store(&shared.finished, 0);
    atomic_store(&shared.processor, this_processor());
    atomic_store(&shared.work, work);
    atomic_store(&shared.data, data);
    atomic_store(&shared.parts, parts);
    atomic_store(&shared.place, next << 32);
    if (atomic_load(&shared.sleepers) == 0) return;
    g_mutex_lock(&shared.mutex);
    g_cond_broadcast(&shared.wake);
    g_mutex_unlock(&shared.mutex);
}

static gboolean finishes_soon(int32_t parts)
{
    for (int i = 0; i < CALLER_SPINS; i++) {
        if (atomic_load(&shared.finished) == parts) return TRUE;
        relax();
    }
    return FALSE;
}

/* Until the helpers have finished their parts, where the caller has done `own` of all since `began`. */
static void wait_for_helpers(int32_t own, int32_t parts, gint64 began)
{
    if (finishes_soon(parts - own)) return;
    gint64 from = g_get_monotonic_time(), now = from;
    while (!finishes_soon(parts - own)) {
        now = g_get_monotonic_time();
        if (now - from > LONG_WAIT) sched_yield();
    }
    gint64 saved = own > 0 ? (from - began) * (parts - own) / own : 0, lost = now - from - saved;
    if (lost > SHORT_WAIT) shared.rests_until = now + REST_FACTOR * lost;
}

static void start_helpers(int wanted)
{
    while (atomic_load(&shared.helpers) < wanted) {
        GThread *thread = g_thread_try_new("share", help, NULL, NULL);
        if (thread == NULL) return;
        g_thread_unref(thread);
        atomic_fetch_add(&shared.helpers, 1);
    }
}

int tinker_share_threads(void)
{
    int threads = atomic_load(&shared.threads);
    return threads > 0 ? threads : CLAMP((int)g_get_num_processors(), 1, MOST_THREADS);
}

void tinker_share_set_threads(int threads)
{
    atomic_store(&shared.threads, CLAMP(threads, 1, MOST_THREADS));
}

static void do_alone(int32_t parts, TinkerShareWork work, void *data)
{
    for (int32_t part = 0; part < parts; part++)
        work(data, part);
}

void tinker_share(int32_t parts, TinkerShareWork work, void *data)
{
    int threads = tinker_share_threads();
    if (parts < 2 || threads < 2 || atomic_flag_test_and_set(&shared.taken)) {
        do_alone(parts, work, data);
        return;
    }
    gint64 began = g_get_monotonic_time();
    if (began < shared.rests_until) {
        do_alone(parts, work, data);
    } else {
        start_helpers(threads - 1);
        open_job(parts, work, data);
        wait_for_helpers(take_parts(FRONT), parts, began);
        if (atomic_exchange(&shared.crowded, FALSE)) shared.rests_until = MAX(shared.rests_until, began + CROWDED_REST);
    }
    atomic_flag_clear(&shared.taken);
}

typedef struct {
    int32_t count, part;
    TinkerShareRange work;
    void *data;
} Range;

static void do_range(void *data, int32_t part)
{
    const Range *range = data;
    int32_t first = part * range->part;
    range->work(range->data, first, MIN(first + range->part, range->count));
}

void tinker_share_long_range(int32_t count, TinkerShareRange work, void *data)
{
    Range range = {count, MAX(RANGE_PART, count / 1024), work, data};
    tinker_share((count + range.part - 1) / range.part, do_range, &range);
}
