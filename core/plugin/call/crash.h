/* When a plugin crashes in the middle of its work, the process cannot go on: its memory may be in any state. But it can
 * say who was at work, and keep what was recorded.
 *
 * tinker_crash_watch() sets a handler for SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT. It writes one line to standard
 * error (plugin, signal, function, blocks, time), writes out the record that is being kept, and raises the signal
 * again, so that the process ends as it would have. SIGTERM, unless it is ignored, is told in the same way. It takes
 * the places of GLib's default log handler and of cJSON's allocation as well, for the whole process. Likewise where a
 * plugin calls exit(): the process then ends with status 1, whatever the plugin asked for; and where GLib or cJSON find
 * no memory, so that nothing is left out quietly. Nothing can be done about _exit() and SIGKILL.
 *
 * What runs in the handler calls async-signal-safe functions alone (signal-safety(7)), allocates nothing and locks
 * nothing. */
#ifndef TINKER_CORE_CRASH_H
#define TINKER_CORE_CRASH_H

#include <glib.h>

/* For the whole process, once, at the start of a program; `program` is the name before the message (copied). Also
 * watches this thread. */
void tinker_crash_watch(const char *program);

/* For the whole process, once, after tinker_crash_watch(): where GLib or cJSON find no memory, the process ends with
 * one line, the record written out, and status 5. What is large is asked for with g_try_malloc() and the like instead,
 * and its lack is an error. */
void tinker_crash_watch_memory(void);

/* Gives the calling thread a stack of its own for the handler, so that a stack overflow can be told: for the first
 * lines of every other thread that calls plugins. */
void tinker_crash_watch_thread(void);

/* A record that is being written: text that is already made, but not yet in the file. */
typedef struct {
    const char *name; /* of the file, for the message */
    int file;         /* descriptor */
    const char *text;
    gsize size; /* bytes of `text` that are whole lines */
} TinkerCrashRecord;

/* For a handler of a signal that asks the process to end (SIGINT, SIGTERM) and that cannot wait for what is under way,
 * such as a plugin that never comes back: says who is at work on this thread, writes out the record, and ends by that
 * signal. While the record is being changed it returns at once, and all that happens when the change is done. */
void tinker_crash_end(int signal_number);

/* Has the handler leave the record alone until the next tinker_crash_keep: before its text or the file is changed. */
void tinker_crash_change(void);

/* Has the handler write out this record; NULL: none. One at a time; it is borrowed until the next call. */
void tinker_crash_keep(const TinkerCrashRecord *record);

/* Has the handler write its message to this file as well (created with mode 0600), for the next start to read.
 * NULL: no file. The path is copied. */
void tinker_crash_set_note(const char *path);

#endif
