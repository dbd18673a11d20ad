/* Tells the thread sanitizer what GLib's locks and counted references order. GLib itself is not compiled with the
 * sanitizer, which therefore sees neither its locks, which are built on futexes, nor what the last holder of a
 * reference may do. Each function here stands before GLib's own and says what that promises: what was done before an
 * unlock, or before a reference was given up, is done for whoever locks, or gives up the last one, after it. To be
 * preloaded (LD_PRELOAD); the test setup "threads" does. */
#include <dlfcn.h>
#include <glib.h>
#include <string.h>

#define VISIBLE __attribute__((visibility("default")))

/* Of the sanitizer; missing in programs of others that a test starts. */
extern void __tsan_acquire(void *address) __attribute__((weak));
extern void __tsan_release(void *address) __attribute__((weak));

static void acquire(gconstpointer address)
{
    if (__tsan_acquire != NULL) __tsan_acquire((void *)address);
}

static void release(gconstpointer address)
{
    if (__tsan_release != NULL) __tsan_release((void *)address);
}

/* GLib's own function of this name, as `own`. */
#define OWN(name)                                                                                                      \
    static __typeof__(name) *own;                                                                                      \
    if (own == NULL) {                                                                                                 \
        void *symbol_ = dlsym(RTLD_NEXT, #name);                                                                       \
        memcpy(&own, &symbol_, sizeof own);                                                                            \
    }

/* The main context is there before any thread is: made by two of them at once it would seem to be a race within GLib.
 */
__attribute__((constructor)) static void make_main_context(void)
{
    g_main_context_default();
}

/* Locks
 * ------------------------------------------------------------------------------------------------------------------ */

VISIBLE void g_mutex_lock(GMutex *mutex)
{
    OWN(g_mutex_lock)
    own(mutex);
    acquire(mutex);
}

VISIBLE gboolean g_mutex_trylock(GMutex *mutex)
{
    OWN(g_mutex_trylock)
    const gboolean locked = own(mutex);
    if (locked) acquire(mutex);
    return locked;
}

VISIBLE void g_mutex_unlock(GMutex *mutex)
{
    OWN(g_mutex_unlock)
    release(mutex);
    own(mutex);
}

VISIBLE void g_cond_wait(GCond *cond, GMutex *mutex)
{
    OWN(g_cond_wait)
    release(mutex);
    own(cond, mutex);
    acquire(mutex);
}

VISIBLE gboolean g_cond_wait_until(GCond *cond, GMutex *mutex, gint64 end_time)
{
    OWN(g_cond_wait_until)
    release(mutex);
    const gboolean signalled = own(cond, mutex, end_time);
    acquire(mutex);
    return signalled;
}

/* Its other half is an atomic read that the compiler puts into the caller. */
#undef g_once_init_leave
VISIBLE void g_once_init_leave(volatile void *location, gsize result)
{
    OWN(g_once_init_leave)
    release((gconstpointer)location);
    own(location, result);
}

#undef g_once_init_enter
VISIBLE gboolean g_once_init_enter(volatile void *location)
{
    OWN(g_once_init_enter)
    const gboolean first = own(location);
    acquire((gconstpointer)location);
    return first;
}

/* Counted references
 * ----------------------------------------------------------------------------------------------------- */

VISIBLE gboolean g_atomic_ref_count_dec(gatomicrefcount *count)
{
    OWN(g_atomic_ref_count_dec)
    release(count);
    const gboolean last = own(count);
    if (last) acquire(count);
    return last;
}

/* What is freed here may be freed by the last holder within the call, so that it is ordered before: behind all who gave
 * theirs up already. */
#define UNREF(name, type)                                                                                              \
    VISIBLE void name(type *object)                                                                                    \
    {                                                                                                                  \
        OWN(name)                                                                                                      \
        if (object != NULL) {                                                                                          \
            release(object);                                                                                           \
            acquire(object);                                                                                           \
        }                                                                                                              \
        own(object);                                                                                                   \
    }
UNREF(g_array_unref, GArray)
UNREF(g_ptr_array_unref, GPtrArray)
UNREF(g_hash_table_unref, GHashTable)

VISIBLE void g_atomic_rc_box_release_full(gpointer box, GDestroyNotify clear)
{
    OWN(g_atomic_rc_box_release_full)
    release(box);
    acquire(box);
    own(box, clear);
}

/* Messages
 * --------------------------------------------------------------------------------------------------------------- */

typedef struct {
    GSourceFunc function;
    gpointer data;
    GDestroyNotify notify;
    gint sent; /* atomic: its sender has done with it */
} Message;

/* What its sender did up to the end of sending, GLib's own work included, is done for who takes it. */
static void take(const Message *message)
{
    while (!g_atomic_int_get(&message->sent))
        g_thread_yield();
    acquire(message);
}

static gboolean hand_over(gpointer data)
{
    Message *message = data;
    take(message);
    return message->function(message->data);
}

static void message_free(gpointer data)
{
    Message *message = data;
    take(message);
    if (message->notify != NULL) message->notify(message->data);
    g_free(message);
}

VISIBLE guint g_idle_add_full(gint priority, GSourceFunc function, gpointer data, GDestroyNotify notify)
{
    OWN(g_idle_add_full)
    Message *message = g_new(Message, 1);
    *message = (Message){function, data, notify, FALSE};
    const guint id = own(priority, hand_over, message, message_free);
    release(message);
    g_atomic_int_set(&message->sent, TRUE);
    return id;
}
