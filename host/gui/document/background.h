/* Work in threads, on behalf of owners in the main thread. Threads that were let go are waited for before what they
 * use, the plugins, goes away. */
#ifndef TINKER_GUI_BACKGROUND_H
#define TINKER_GUI_BACKGROUND_H

#include <glib.h>

typedef struct _TinkerBackground TinkerBackground;

/* `work` is called in a thread, then `done` in the main loop, unless the owner has let go by then. `data` is freed
 * last, in either. */
typedef struct {
    const char *name;
    void (*work)(TinkerBackground *background, void *data);
    void (*done)(void *data);
    GDestroyNotify free;
} TinkerBackgroundWork;

/* Starts; to be let go exactly once, also after `done`. `data` is the work's from now on. (transfer full) */
TinkerBackground *tinker_background_start(const TinkerBackgroundWork *work, void *data);

/* Asks the work to end soon; `done` is still called. */
void tinker_background_cancel(TinkerBackground *background);
/* Asks the work to end, and neither waits nor wants to hear of it again. */
void tinker_background_let_go(TinkerBackground *background);

/* For the work: whether it has been asked to end. Any thread. */
gboolean tinker_background_is_cancelled(TinkerBackground *background);

/* A thread of somebody else's begins (before it is started) and ends; both from any thread. */
void tinker_background_enter(void);
void tinker_background_leave(void);

/* Waits for all threads; their owners have let go. FALSE where one is not done after `seconds`: a plugin that never
 * comes back. */
gboolean tinker_background_wait(double seconds);

#endif
