/* What a process has one of for all its parts, and a plugin may change without a word: the locale, the umask, the mode
 * of floating-point numbers (rounding, traps, numbers near 0), the handlers of signals. */
#ifndef TINKER_CORE_PROCESS_STATE_H
#define TINKER_CORE_PROCESS_STATE_H

#include <tinker/sdk.h>

typedef struct _TinkerProcessState TinkerProcessState;

/* The state of this moment; locale, umask and handlers are the process's, the mode is this thread's. (transfer full) */
TinkerProcessState *tinker_process_state_save(void);

/* Puts everything back as it was saved, and frees what was saved. Answers what had been changed, as "the locale and the
 * umask" in English, for the conformance kit; NULL where nothing was. (transfer full) */
char *tinker_process_state_restore(TinkerProcessState *saved);

/* Until it leaves again, this thread calls `prepare` many times: between the two only the mode of floating-point
 * numbers is put back after each, which takes no call of the system, and all else at the end. No state may be saved or
 * put back in between. */
void tinker_process_state_enter(void);
void tinker_process_state_leave(void);

/* Calls `prepare` of the physics, and puts back what it changed of the state of the process. The caller's note of the
 * call stands (call.h). */
TinkerStatus tinker_prepare(const TinkerPhysics *physics, TinkerBatch *batch);

#endif
