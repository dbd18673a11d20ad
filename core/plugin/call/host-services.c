/* The services of the host: today the log. */
#include "plugin/call/host-services-private.h"

#include <string.h>

static void log_text(const TinkerHost *host, int32_t level, const char *text)
{
    if (text == NULL) return;
    const TinkerPluginHost *plugin_host = (const TinkerPluginHost *)host;
    g_autofree char *valid = g_utf8_make_valid(text, -1);
    // A message rather than a GLib warning: a plugin's complaint is news for the user, not a fault of this program.
    const GLogLevelFlags flags = level >= TINKER_LOG_WARNING ? G_LOG_LEVEL_MESSAGE : G_LOG_LEVEL_INFO;
    g_log("tinker-plugin", flags, "%s: %s", plugin_host->plugin_id, valid);
}

static const TinkerLogService log_service = {sizeof(TinkerLogService), 0, log_text};

static const void *find_service(const char *id)
{
    return id != NULL && strcmp(id, TINKER_LOG_SERVICE) == 0 ? &log_service : NULL;
}

static const void *service(const TinkerHost *host, const char *id)
{
    return find_service(id);
}

void tinker_plugin_host_init(TinkerPluginHost *plugin_host, const char *plugin_id)
{
    plugin_host->host = (TinkerHost){sizeof(TinkerHost), TINKER_ABI_MINOR, service};
    plugin_host->plugin_id = plugin_id;
}

gboolean tinker_host_offers(const char *service_id)
{
    return find_service(service_id) != NULL;
}

const char *tinker_host_service_names(void)
{
    return "\"" TINKER_LOG_SERVICE "\"";
}
