/* Saving and putting back. Threads may make files meanwhile: the umask is set to something else for an instant alone,
 * once, to learn what it is. */
#include "plugin/call/process-state.h"

#include <fenv.h>
#include <glib.h>
#include <locale.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#if defined(__SSE__)
#include <immintrin.h>
#endif

/* Those that a program handles, or that a library may like to. */
static const int watched[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGABRT, SIGBUS,  SIGFPE,
                              SIGSEGV, SIGPIPE, SIGALRM, SIGTERM, SIGCHLD, SIGXFSZ, SIGUSR1};

struct _TinkerProcessState {
    char *locale;
    locale_t locale_of_thread;
    fenv_t floating_point;
    int rounding, traps;
    unsigned control; /* of the vector unit: its flags of what happened left out */
    struct sigaction handlers[G_N_ELEMENTS(watched)];
};

/* What is put back at the end of many calls of `prepare`; NULL: each puts back itself. */
static _Thread_local TinkerProcessState *entered;

/* The umask of the process cannot be read without being set: it is read once, when the first library is opened. */
static mode_t process_umask(void)
{
    static gsize known;
    static mode_t mask;
    if (g_once_init_enter(&known)) {
        mask = umask(077);
        umask(mask);
        g_once_init_leave(&known, 1);
    }
    return mask;
}

static unsigned vector_control(void)
{
#if defined(__SSE__)
    return _mm_getcsr() & ~(unsigned)_MM_EXCEPT_MASK;
#else
    return 0;
#endif
}

TinkerProcessState *tinker_process_state_save(void)
{
    TinkerProcessState *saved = g_new0(TinkerProcessState, 1);
    process_umask();
    saved->locale = g_strdup(setlocale(LC_ALL, NULL));
    saved->locale_of_thread = uselocale((locale_t)0);
    fegetenv(&saved->floating_point);
    saved->rounding = fegetround();
    saved->traps = fegetexcept();
    saved->control = vector_control();
    for (gsize i = 0; i < G_N_ELEMENTS(watched); i++)
        sigaction(watched[i], NULL, &saved->handlers[i]);
    return saved;
}

static gboolean restore_locale(const TinkerProcessState *saved)
{
    gboolean changed = FALSE;
    if (uselocale((locale_t)0) != saved->locale_of_thread) {
        uselocale(saved->locale_of_thread);
        changed = TRUE;
    }
    if (g_strcmp0(setlocale(LC_ALL, NULL), saved->locale) == 0) return changed;
    setlocale(LC_ALL, saved->locale);
    return TRUE;
}

static gboolean restore_floating_point(const TinkerProcessState *saved)
{
    const gboolean changed =
        fegetround() != saved->rounding || fegetexcept() != saved->traps || vector_control() != saved->control;
    fesetenv(&saved->floating_point);
    return changed;
}

static gboolean same_handler(const struct sigaction *one, const struct sigaction *other)
{
    return one->sa_flags == other->sa_flags && one->sa_handler == other->sa_handler;
}

/* The number of one of the signals whose handler was changed; 0: none was. */
static int restore_handlers(const TinkerProcessState *saved)
{
    int changed = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(watched); i++) {
        struct sigaction now;
        if (sigaction(watched[i], NULL, &now) != 0 || same_handler(&now, &saved->handlers[i])) continue;
        sigaction(watched[i], &saved->handlers[i], NULL);
        changed = watched[i];
    }
    return changed;
}

char *tinker_process_state_restore(TinkerProcessState *saved)
{
    g_autoptr(GPtrArray) changed = g_ptr_array_new_with_free_func(g_free);
    if (restore_locale(saved)) g_ptr_array_add(changed, g_strdup("the locale"));
    if (umask(process_umask()) != process_umask()) g_ptr_array_add(changed, g_strdup("the umask"));
    if (restore_floating_point(saved)) g_ptr_array_add(changed, g_strdup("the mode of floating-point numbers"));
    const int handler = restore_handlers(saved);
    if (handler != 0) g_ptr_array_add(changed, g_strdup_printf("the handler of SIG%s", sigabbrev_np(handler)));
    g_free(saved->locale);
    g_free(saved);
    if (changed->len == 0) return NULL;
    g_ptr_array_add(changed, NULL);
    return g_strjoinv(" and ", (char **)changed->pdata);
}

void tinker_process_state_enter(void)
{
    g_assert(entered == NULL);
    entered = tinker_process_state_save();
}

void tinker_process_state_leave(void)
{
    g_free(tinker_process_state_restore(g_steal_pointer(&entered)));
}

TinkerStatus tinker_prepare(const TinkerPhysics *physics, TinkerBatch *batch)
{
    if (entered == NULL) {
        TinkerProcessState *saved = tinker_process_state_save();
        const TinkerStatus status = physics->prepare(batch);
        g_free(tinker_process_state_restore(saved));
        return status;
    }
    const TinkerStatus status = physics->prepare(batch);
    fesetenv(&entered->floating_point);
    return status;
}
