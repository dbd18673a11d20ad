/* A piece of work is shared by its thread, its owner and the message that it is done, and freed by whichever lets go
 * last. */
#include "gui/document/background.h"

#include "plugin/call/crash.h"

struct _TinkerBackground {
    gatomicrefcount references;
    const TinkerBackgroundWork *work;
    void *data;
    gint cancelled; /* atomic */
    gint let_go;    /* atomic; set in the main thread */
};

/* Threads that are under way. */
static GMutex mutex;
static GCond all_left;
static int entered;

void tinker_background_enter(void)
{
    g_mutex_lock(&mutex);
    entered++;
    g_mutex_unlock(&mutex);
}

void tinker_background_leave(void)
{
    g_mutex_lock(&mutex);
    if (--entered == 0) g_cond_broadcast(&all_left);
    g_mutex_unlock(&mutex);
}

gboolean tinker_background_wait(double seconds)
{
    const gint64 end = g_get_monotonic_time() + (gint64)(seconds * G_USEC_PER_SEC);
    g_mutex_lock(&mutex);
    while (entered > 0 && g_cond_wait_until(&all_left, &mutex, end)) {
    }
    const gboolean done = entered == 0;
    g_mutex_unlock(&mutex);
    return done;
}

static void unref(void *data)
{
    TinkerBackground *background = data;
    if (!g_atomic_ref_count_dec(&background->references)) return;
    background->work->free(background->data);
    g_free(background);
}

static gboolean tell(void *data)
{
    TinkerBackground *background = data;
    if (!g_atomic_int_get(&background->let_go)) background->work->done(background->data);
    return G_SOURCE_REMOVE;
}

/* Before frames are drawn, else a window whose frames take longer than they have would never come to it. */
#define TELL_PRIORITY G_PRIORITY_HIGH_IDLE

static gpointer run(gpointer data)
{
    TinkerBackground *background = data;
    tinker_crash_watch_thread();
    background->work->work(background, background->data);
    /* The message has the thread's reference, unless nobody would hear it: the data must be gone before the thread is.
     */
    if (g_atomic_int_get(&background->let_go))
        unref(background);
    else
        g_idle_add_full(TELL_PRIORITY, tell, background, unref);
    tinker_background_leave();
    return NULL;
}

TinkerBackground *tinker_background_start(const TinkerBackgroundWork *work, void *data)
{
    TinkerBackground *background = g_new0(TinkerBackground, 1);
    g_atomic_ref_count_init(&background->references);
    background->work = work;
    background->data = data;
    g_atomic_ref_count_inc(&background->references);
    tinker_background_enter();
    g_thread_unref(g_thread_new(work->name, run, background));
    return background;
}

void tinker_background_cancel(TinkerBackground *background)
{
    g_atomic_int_set(&background->cancelled, TRUE);
}

void tinker_background_let_go(TinkerBackground *background)
{
    if (background == NULL) return;
    g_atomic_int_set(&background->cancelled, TRUE);
    g_atomic_int_set(&background->let_go, TRUE);
    unref(background);
}

gboolean tinker_background_is_cancelled(TinkerBackground *background)
{
    return g_atomic_int_get(&background->cancelled);
}
