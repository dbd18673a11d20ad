/* Which plugin is being called, by this thread, at this moment: what a message about a crash needs (crash.h).
 *
 * Every call of a plugin goes through one of the macros below. They cost two stores of a pointer, and a few to the
 * stack for each call, which is one for a whole range of blocks. */
#ifndef TINKER_CORE_CALL_H
#define TINKER_CORE_CALL_H

#include "plugin/descriptor/block-class.h"

/* Everything is borrowed until the call is left, and in memory of the host. Members that a call does not have are NULL.
 */
typedef struct TinkerPluginCall {
    const char *phase;                   /* name of the function, "force" */
    const TinkerBlockClass *block_class; /* whose function it is */
    const TinkerIntegrator *method;      /* likewise */
    const char *path;                    /* of a library that is being opened */
    const TinkerBatch *batch;            /* the range of blocks asked about */
    const TinkerInstance *instance;      /* or the one block */
    /* The name of a block of the batch, NULL where it is not known; reads memory alone. */
    const char *(*name)(const void *source, int32_t row);
    const void *source;
    const struct TinkerPluginCall *outer; /* set by tinker_call_enter */
} TinkerPluginCall;

/* The innermost call of this thread; NULL: none. */
extern _Thread_local const TinkerPluginCall *volatile tinker_plugin_call;

/* The last calls of this thread that came back: what broke the host's memory shows when the host uses it next. */
typedef struct {
    const char *phase; /* of a block type or a library; NULL: none yet */
    const TinkerBlockClass *block_class;
    const char *path;
    const char *method_phase;
    const TinkerIntegrator *method; /* NULL where a block type was called since */
} TinkerPluginLast;

extern _Thread_local TinkerPluginLast tinker_plugin_last;

static inline void tinker_call_enter(TinkerPluginCall *call)
{
    call->outer = tinker_plugin_call;
    tinker_plugin_call = call;
}

/* Answers what the call answered. */
static inline int32_t tinker_call_leave(int32_t answer)
{
    const TinkerPluginCall *call = tinker_plugin_call;
    if (call->method != NULL) {
        tinker_plugin_last.method_phase = call->phase;
        tinker_plugin_last.method = call->method;
    } else {
        tinker_plugin_last = (TinkerPluginLast){call->phase, call->block_class, call->path, NULL, NULL};
    }
    tinker_plugin_call = call->outer;
    return answer;
}

/* An expression: the answer of `call`, a status or another int32_t, while the note (members of TinkerPluginCall)
 * stands. */
#define TINKER_CALL(call, ...) (tinker_call_enter(&(TinkerPluginCall){__VA_ARGS__}), tinker_call_leave(call))

/* A call of a plugin's function that answers nothing. */
#define TINKER_CALL_VOID(call, ...)                                                                                    \
    (tinker_call_enter(&(TinkerPluginCall){__VA_ARGS__}), (call), (void)tinker_call_leave(TINKER_OK))

/* A function of one block. */
#define TINKER_CALL_INSTANCE(owner, function, shown, call)                                                             \
    TINKER_CALL(call, .phase = (function), .block_class = (owner), .instance = (shown))

#endif
