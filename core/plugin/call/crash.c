/* The handler of crashes. Its parts run in this order: who was at work, what is kept, the message, the signal again.
 * A second fault on the way (the memory may be broken) cuts off the part it happens in, not those that follow. */
#include "plugin/call/crash.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <ucontext.h>
#include <unistd.h>

#include "files/write-lines.h"
#include "plugin/call/crash-text-private.h"
#include "plugin/call/guarded.h"
#include "plugin/call/process-end.h"

#define STACK_BYTES 65536
/* A fault this near to the stack pointer, in bytes, is the stack running into its guard page. */
#define NEAR_STACK 65536

static _Thread_local char handler_stack[STACK_BYTES];

static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
static const char *const signal_names[] = {"SIGSEGV", "SIGBUS", "SIGFPE", "SIGILL", "SIGABRT"};
static struct sigaction before[G_N_ELEMENTS(signals)];

static char program_name[64], note_path[4096];
static const TinkerCrashRecord *volatile kept;
static gint changing;     /* atomic: whether the record is being changed */
static gint asked_to_end; /* atomic: the signal; 0: none */

/* Of the one end that is told; a second thread that crashes meanwhile waits for it. */
static gint under_way; /* atomic */
static TinkerCrashText message;

/* How far this thread is. Set before each part, so that a fault in it goes on with the next. */
enum { NOTHING, BEGUN, COMPOSED, SAVED, TOLD };
static _Thread_local volatile sig_atomic_t stage;

/* What is left to be done ------------------------------------------------------------------------------------------ */

/* Writes out the lines that are whole, once, and says where they are. */
static void save_record(void)
{
    const TinkerCrashRecord *record = kept;
    kept = NULL;
    if (record == NULL) return;
    const gboolean saved = tinker_write_lines(record->file, record->text, record->size);
    tinker_crash_text_add(&message, saved ? "; what was recorded up to then is in "
                                          : "; what was recorded could not be written to ");
    tinker_crash_text_add(&message, record->name);
}

static void tell(void)
{
    tinker_crash_text_add(&message, "\n");
    (void)tinker_write_lines(STDERR_FILENO, message.text, message.length);
    if (note_path[0] == '\0') return;
    const int file = open(note_path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file < 0) return;
    (void)tinker_write_lines(file, message.text, message.length);
    close(file);
}

static void begin_message(void)
{
    message.length = 0;
    tinker_crash_text_add(&message, program_name);
    tinker_crash_text_add(&message, ": ");
}

/* Signals ---------------------------------------------------------------------------------------------------------- */

static gsize number_of(int signal_number)
{
    gsize number = 0;
    while (number + 1 < G_N_ELEMENTS(signals) && signals[number] != signal_number)
        number++;
    return number;
}

/* Where the thread was; 0 where that is not known. */
static guintptr program_counter(const void *context)
{
    const ucontext_t *at = context;
#if defined(__x86_64__)
    return (guintptr)at->uc_mcontext.gregs[REG_RIP];
#elif defined(__aarch64__)
    return (guintptr)at->uc_mcontext.pc;
#else
    return 0;
#endif
}

/* Whether a fault lies where the stack of the thread ended. */
static gboolean is_stack_overflow(int signal_number, const siginfo_t *info, const void *context)
{
    if (signal_number != SIGSEGV && signal_number != SIGBUS) return FALSE;
    const ucontext_t *at = context;
#if defined(__x86_64__)
    const guintptr stack = (guintptr)at->uc_mcontext.gregs[REG_RSP];
#elif defined(__aarch64__)
    const guintptr stack = (guintptr)at->uc_mcontext.sp;
#else
    const guintptr stack = 0;
#endif
    const guintptr fault = (guintptr)info->si_addr;
    return stack != 0 && fault + NEAR_STACK > stack && fault < stack + NEAR_STACK && info->si_code > 0;
}

/* `code` is the last error of the C library. GLib aborts where one of its locks finds no memory, and calls itself
 * without end where the message about it finds none; the error may be an old one. */
static void compose(int signal_number, const siginfo_t *info, const void *context, int code)
{
    const gboolean overflowed = is_stack_overflow(signal_number, info, context);
    char what[96] = " crashed (";
    strcat(what, signal_names[number_of(signal_number)]);
    if (overflowed) strcat(what, ", its stack overflowed");
    if (code == ENOMEM && (signal_number == SIGABRT || overflowed)) strcat(what, ", maybe for want of memory");
    strcat(what, ")");
    begin_message();
    const TinkerPluginCall *call = tinker_plugin_call;
    const TinkerBlockClass *owner = NULL;
    if (call != NULL && tinker_crash_is_of_plugin(call))
        tinker_crash_text_add_call(&message, call, what);
    else if (tinker_guarded_find_broken(&owner))
        tinker_crash_text_add_broken(&message, owner, what);
    else
        tinker_crash_text_add_outside(&message, call, program_counter(context), what);
}

G_NORETURN static void wait_for_end(void)
{
    for (;;)
        pause();
}

/* Makes this thread the one that tells. */
static void begin(void)
{
    stage = BEGUN;
    if (!g_atomic_int_compare_and_exchange(&under_way, 0, 1)) wait_for_end();
}

static void on_signal(int signal_number, siginfo_t *info, void *context)
{
    const int code = errno;
    if (stage == NOTHING) begin();
    // A fault in one part comes here again, and goes on with the next.
    while (stage < TOLD) {
        switch (++stage) {
        case COMPOSED:
            compose(signal_number, info, context, code);
            break;
        case SAVED:
            save_record();
            break;
        case TOLD:
            tell();
            break;
        }
    }
    // What comes now goes to the handlers before ours, in the end to the system's, which ends the process.
    for (gsize i = 0; i < G_N_ELEMENTS(signals); i++)
        sigaction(signals[i], &before[i], NULL);
    // A fault happens again on return; what was sent has to be sent again.
    if (info->si_code <= 0) raise(signal_number);
}

/* Tells of an end that is no crash: `what` the plugin at work did, or `otherwise`. */
static void tell_end(const char *what, const char *otherwise)
{
    begin();
    stage = COMPOSED;
    begin_message();
    if (tinker_plugin_call != NULL)
        tinker_crash_text_add_call(&message, tinker_plugin_call, what);
    else
        tinker_crash_text_add(&message, otherwise);
    stage = SAVED;
    save_record();
    stage = TOLD;
    tell();
}

static void end_by(int signal_number)
{
    tell_end(" was interrupted", "interrupted");
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

void tinker_crash_end(int signal_number)
{
    // One signal may come while another is answered, on the same thread: the first goes on when this has returned.
    if (stage != NOTHING) return;
    g_atomic_int_set(&asked_to_end, signal_number);
    if (!g_atomic_int_get(&changing)) end_by(signal_number);
}

void tinker_crash_end_with(int status, const char *what, const char *otherwise)
{
    // Whatever is told already is not told again.
    if (stage == NOTHING) tell_end(what, otherwise);
    _exit(status);
}

/* The end of the process ------------------------------------------------------------------------------------------- */

/* A plugin that ends the process would end it with its own status, as if the run were done. */
static void on_exit_called(void)
{
    if (tinker_plugin_call == NULL || stage != NOTHING) return;
    tinker_crash_end_with(1, " called exit()", "");
}

/* Public ----------------------------------------------------------------------------------------------------------- */

void tinker_crash_watch_thread(void)
{
    stack_t present = {0};
    // Somebody else's (a sanitizer's) is as good, and it is theirs to free.
    if (sigaltstack(NULL, &present) == 0 && (present.ss_flags & SS_DISABLE) == 0) return;
    const stack_t own = {.ss_sp = handler_stack, .ss_size = sizeof handler_stack};
    sigaltstack(&own, NULL);
}

/* Whoever ends a program that hangs wants to know what it hung in. */
static void watch_termination(void)
{
    struct sigaction action = {.sa_handler = tinker_crash_end, .sa_flags = SA_ONSTACK}, present;
    sigemptyset(&action.sa_mask);
    if (sigaction(SIGTERM, NULL, &present) == 0 && present.sa_handler == SIG_DFL) sigaction(SIGTERM, &action, NULL);
}

void tinker_crash_watch(const char *program)
{
    g_strlcpy(program_name, program, sizeof program_name);
    tinker_crash_watch_thread();
    struct sigaction action = {.sa_sigaction = on_signal, .sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER};
    sigemptyset(&action.sa_mask);
    for (gsize i = 0; i < G_N_ELEMENTS(signals); i++)
        sigaction(signals[i], &action, &before[i]);
    watch_termination();
    atexit(on_exit_called);
}

void tinker_crash_change(void)
{
    g_atomic_int_set(&changing, 1);
    kept = NULL;
}

void tinker_crash_keep(const TinkerCrashRecord *record)
{
    kept = record;
    g_atomic_int_set(&changing, 0);
    const int signal_number = g_atomic_int_get(&asked_to_end);
    if (signal_number != 0) end_by(signal_number);
}

void tinker_crash_set_note(const char *path)
{
    g_strlcpy(note_path, path != NULL ? path : "", sizeof note_path);
}
