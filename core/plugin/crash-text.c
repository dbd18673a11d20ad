/* The words of a crash. Everything here is async-signal-safe: it reads memory and writes to the text. */
#include "plugin/crash-text-private.h"

#include <math.h>
#include <string.h>

#include "plugin/library-private.h"

void tinker_crash_text_add(TinkerCrashText *text, const char *more)
{
    for (; *more != '\0' && text->length < sizeof text->text - 1; more++)
        text->text[text->length++] = *more;
    text->text[text->length] = '\0';
}

static void add_digits(TinkerCrashText *text, guint64 value, int least)
{
    char digits[24];
    int at = sizeof digits - 1;
    digits[at] = '\0';
    for (int count = 0; value > 0 || count < least; count++) {
        digits[--at] = (char)('0' + value % 10);
        value /= 10;
    }
    tinker_crash_text_add(text, digits + at);
}

void tinker_crash_text_add_number(TinkerCrashText *text, double value)
{
    if (!isfinite(value)) {
        tinker_crash_text_add(text, isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
        return;
    }
    if (value <= -0.5e-6) tinker_crash_text_add(text, "-"); // what is rounded to 0 has no sign
    value = fabs(value);
    if (value >= 1e15) {
        tinker_crash_text_add(text, "more than 1e15");
        return;
    }
    double whole = floor(value);
    guint64 millionths = (guint64)((value - whole) * 1e6 + 0.5);
    if (millionths == 1000000) {
        whole += 1;
        millionths = 0;
    }
    add_digits(text, (guint64)whole, 1);
    if (millionths == 0) return;
    int digits = 6;
    for (; millionths % 10 == 0; digits--)
        millionths /= 10;
    tinker_crash_text_add(text, ".");
    add_digits(text, millionths, digits);
}

static void add_blocks(TinkerCrashText *text, const TinkerPluginCall *call)
{
    if (call->instance != NULL) {
        tinker_crash_text_add(text, " (block ");
        tinker_crash_text_add(text, call->instance->name != NULL ? call->instance->name : "?");
        tinker_crash_text_add(text, ")");
        return;
    }
    if (call->batch == NULL || call->name == NULL || call->batch->count < 1) return;
    int32_t first = call->batch->first, last = first + call->batch->count - 1;
    const char *from = call->name(call->source, first), *to = call->name(call->source, last);
    if (from == NULL || to == NULL) return;
    tinker_crash_text_add(text, first == last ? " (block " : " (blocks ");
    tinker_crash_text_add(text, from);
    if (first != last) {
        tinker_crash_text_add(text, " … ");
        tinker_crash_text_add(text, to);
    }
    tinker_crash_text_add(text, ")");
}

static void add_time(TinkerCrashText *text, const TinkerPluginCall *call)
{
    if (call->batch == NULL && call->instance == NULL) return;
    tinker_crash_text_add(text, " at t = ");
    tinker_crash_text_add_number(text, call->batch != NULL ? call->batch->time : call->instance->time);
    tinker_crash_text_add(text, " s");
}

static void add_owner(TinkerCrashText *text, const TinkerPluginCall *call)
{
    const TinkerPlugin *plugin = call->method != NULL ? tinker_library_plugin_of_method(call->method)
                                                      : (call->block_class != NULL ? call->block_class->plugin : NULL);
    if (plugin != NULL) {
        tinker_crash_text_add(text, "the plugin ");
        tinker_crash_text_add(text, plugin->id);
    } else if (call->path != NULL) {
        tinker_crash_text_add(text, "the library ");
        tinker_crash_text_add(text, call->path);
    } else {
        tinker_crash_text_add(text, "tinker itself");
    }
}

void tinker_crash_text_add_call(TinkerCrashText *text, const TinkerPluginCall *call, const char *what)
{
    add_owner(text, call);
    tinker_crash_text_add(text, what);
    tinker_crash_text_add(text, " in \"");
    tinker_crash_text_add(text, call->phase);
    tinker_crash_text_add(text, "\"");
    if (call->method != NULL) {
        tinker_crash_text_add(text, " of the method ");
        tinker_crash_text_add(text, call->method->id);
    }
    if (call->block_class != NULL) {
        tinker_crash_text_add(text, " of block type ");
        tinker_crash_text_add(text, call->block_class->type->id);
    }
    add_blocks(text, call);
    add_time(text, call);
}
