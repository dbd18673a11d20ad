/* GLib ends the program where it finds no memory, and says so in its own words; cJSON goes on, with a value left out.
 * Both end it here. */
#include <cjson/cJSON.h>
#include <string.h>

#include "plugin/call/crash.h"
#include "plugin/call/process-end.h"

/* What GLib's message of this end says before the size, and ours where we end for the same reason. */
#define REFUSED "failed to allocate "

static void on_message(const char *domain, GLogLevelFlags level, const char *message, gpointer unused)
{
    // Without memory, there may be none for the message either.
    const char *refused = message != NULL ? strstr(message, REFUSED) : "";
    if (refused == NULL || (level & G_LOG_LEVEL_ERROR) == 0) {
        g_log_default_handler(domain, level, message, unused);
        return;
    }
    char otherwise[160] = "out of memory";
    if (refused[0] != '\0') {
        g_strlcat(otherwise, " (", sizeof otherwise);
        g_strlcat(otherwise, refused, sizeof otherwise);
        g_strlcat(otherwise, ")", sizeof otherwise);
    }
    g_strlcat(otherwise, ": end other programs, or make the scene smaller", sizeof otherwise);
    tinker_crash_end_with(TINKER_STATUS_FILE, " ran out of memory", otherwise);
}

void tinker_crash_watch_memory(void)
{
    // A handler for one domain takes memory, which GLib would ask for while it keeps messages waiting.
    g_log_set_default_handler(on_message, NULL);
    cJSON_InitHooks(&(cJSON_Hooks){g_malloc, g_free});
}
