/* The words of a crash, put together where neither memory nor locks are to be had. */
#ifndef TINKER_PLUGIN_CRASH_TEXT_PRIVATE_H
#define TINKER_PLUGIN_CRASH_TEXT_PRIVATE_H

#include "plugin/call/call.h"

/* A text of limited length; what does not fit is cut off. */
typedef struct {
    char text[2048];
    gsize length;
} TinkerCrashText;

void tinker_crash_text_add(TinkerCrashText *text, const char *more);

/* To six decimals, without zeros at the end; from 1e15 on it says no more than that. */
void tinker_crash_text_add_number(TinkerCrashText *text, double value);

/* Who was at work: "the plugin ID WHAT in "FUNCTION" of block type TYPE (blocks A … B) at t = 1 s". */
void tinker_crash_text_add_call(TinkerCrashText *text, const TinkerPluginCall *call, const char *what);

/* That the memory of the host was written to before it crashed: by the plugin of that class, or where it is NULL by the
 * one that was called last. */
void tinker_crash_text_add_broken(TinkerCrashText *text, const TinkerBlockClass *owner, const char *what);

/* Whether the call is one of a plugin, and not of a method of the host itself. */
gboolean tinker_crash_is_of_plugin(const TinkerPluginCall *call);

/* Who crashed outside of all calls of plugins: the library of a plugin that the address of the code lies in (a thread
 * of its own, or what it left to the end of the program), else "tinker itself WHAT" in the host's call (NULL: none),
 * and which plugin's call had come back last. */
void tinker_crash_text_add_outside(TinkerCrashText *text, const TinkerPluginCall *call, guintptr code,
                                   const char *what);

#endif
