/* The words of a crash. Everything here is async-signal-safe: it reads memory and writes to the text. */
#include "plugin/call/crash-text-private.h"

#include <dlfcn.h>
#include <math.h>
#include <string.h>

#include "plugin/call/library.h"

/* Of the library that an address lies in, without a lock: since this version of the GNU C library. */
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 35)
#define KNOWS_LIBRARIES 1
#include <link.h>
#else
#define KNOWS_LIBRARIES 0
#endif

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

static const TinkerPlugin *plugin_of(const TinkerPluginCall *call)
{
    if (call->method != NULL) return tinker_library_plugin_of_method(call->method);
    return call->block_class != NULL ? call->block_class->plugin : NULL;
}

gboolean tinker_crash_is_of_plugin(const TinkerPluginCall *call)
{
    return call->path != NULL || plugin_of(call) != NULL;
}

static void add_owner(TinkerCrashText *text, const TinkerPluginCall *call)
{
    const TinkerPlugin *plugin = plugin_of(call);
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

static void add_subject(TinkerCrashText *text, const TinkerPluginCall *call)
{
    if (call->method != NULL) {
        tinker_crash_text_add(text, " of the method ");
        tinker_crash_text_add(text, call->method->id);
    }
    if (call->block_class != NULL) {
        tinker_crash_text_add(text, " of block type ");
        tinker_crash_text_add(text, call->block_class->type->id);
    }
}

void tinker_crash_text_add_call(TinkerCrashText *text, const TinkerPluginCall *call, const char *what)
{
    add_owner(text, call);
    tinker_crash_text_add(text, what);
    tinker_crash_text_add(text, " in \"");
    tinker_crash_text_add(text, call->phase);
    tinker_crash_text_add(text, "\"");
    add_subject(text, call);
    add_blocks(text, call);
    add_time(text, call);
}

/* Whose call came back last, in the members of a call. Methods of the host itself are no plugin's. */
static gboolean last_call(TinkerPluginCall *last)
{
    const TinkerPluginLast *kept = &tinker_plugin_last;
    const gboolean methods = kept->method != NULL && tinker_library_plugin_of_method(kept->method) != NULL;
    *last = (TinkerPluginCall){.phase = methods ? kept->method_phase : kept->phase};
    if (methods)
        last->method = kept->method;
    else
        last->block_class = kept->block_class, last->path = kept->path;
    return last->phase != NULL;
}

void tinker_crash_text_add_broken(TinkerCrashText *text, const TinkerBlockClass *owner, const char *what)
{
    TinkerPluginCall call = {.block_class = owner};
    if (owner != NULL || last_call(&call)) {
        add_owner(text, &call);
        tinker_crash_text_add(text,
                              owner != NULL ? " wrote beyond the scratch" : " wrote beyond its results, it seems,");
    } else {
        tinker_crash_text_add(text, "a plugin wrote beyond its results");
    }
    if (call.block_class != NULL) {
        tinker_crash_text_add(text, " of its block type ");
        tinker_crash_text_add(text, call.block_class->type->id);
    }
    tinker_crash_text_add(text, ", and the program");
    tinker_crash_text_add(text, what);
}

/* The path of the plugin's library that the address lies in; NULL where it lies in none. */
static const char *library_at(guintptr code)
{
#if KNOWS_LIBRARIES
    struct dl_find_object found;
    if (code == 0 || _dl_find_object((void *)code, &found) != 0) return NULL; // NOLINT: an address, to be looked up
    const char *path = found.dlfo_link_map->l_name;
    return path != NULL && tinker_library_passed(path) != NULL ? path : NULL;
#else
    return NULL;
#endif
}

void tinker_crash_text_add_outside(TinkerCrashText *text, const TinkerPluginCall *call, guintptr code, const char *what)
{
    const char *path = library_at(code);
    TinkerPluginCall last;
    if (path != NULL) {
        add_owner(text, &(TinkerPluginCall){.path = path});
        tinker_crash_text_add(text, what);
        tinker_crash_text_add(text, " outside of any call, in a thread of its own or at the end of the program");
        return;
    }
    if (call != NULL) {
        tinker_crash_text_add_call(text, call, what);
    } else {
        tinker_crash_text_add(text, "tinker itself");
        tinker_crash_text_add(text, what);
    }
    if (!last_call(&last)) return;
    tinker_crash_text_add(text, ", after ");
    add_owner(text, &last);
    tinker_crash_text_add(text, " had come back from \"");
    tinker_crash_text_add(text, last.phase);
    tinker_crash_text_add(text, "\"");
    add_subject(text, &last);
}
