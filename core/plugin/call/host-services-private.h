/* What the host offers to a plugin. */
#ifndef TINKER_PLUGIN_HOST_SERVICES_PRIVATE_H
#define TINKER_PLUGIN_HOST_SERVICES_PRIVATE_H

#include "plugin/descriptor/block-class.h"

/* The host as one plugin sees it. `host` comes first: a service finds the plugin's name behind the pointer it is given.
 */
typedef struct {
    TinkerHost host;
    const char *plugin_id; /* borrowed from the library */
} TinkerPluginHost;

/* Fills in the host for the plugin of this id. It must stay where it is as long as the plugin is open. */
void tinker_plugin_host_init(TinkerPluginHost *plugin_host, const char *plugin_id);

/* Whether this host has the service. */
gboolean tinker_host_offers(const char *service_id);

/* The ids of all services, for messages: "\"tinker.log/1\"". */
const char *tinker_host_service_names(void);

#endif
