/* The words of a crash, put together where neither memory nor locks are to be had. */
#ifndef TINKER_PLUGIN_CRASH_TEXT_PRIVATE_H
#define TINKER_PLUGIN_CRASH_TEXT_PRIVATE_H

#include "plugin/call.h"

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

#endif
