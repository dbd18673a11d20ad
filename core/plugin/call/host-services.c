/* The services of the host: the log, and formulas. */
#include "plugin/call/host-services-private.h"

#include <math.h>
#include <string.h>

#include "units/compiled/compiled.h"
#include "units/compiled/typed-energy.h"

#include <tinker/typed-law.h>

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

static double formula_value(const TinkerTypedLaw *formula, const double *arguments)
{
    return tinker_compiled_value(formula->value, arguments);
}

static double formula_slope(const TinkerTypedLaw *formula, int32_t by, const double *arguments)
{
    return tinker_compiled_value(formula->slopes[by], arguments);
}

static double formula_curvature(const TinkerTypedLaw *formula, int32_t by, int32_t and_by, const double *arguments)
{
    return tinker_compiled_value(formula->curvatures[by * formula->count + and_by], arguments);
}

static void formula_values(const TinkerTypedQuestion *question, double *results)
{
    tinker_typed_ask(question, -1, -1, results);
}

static void formula_slopes(const TinkerTypedQuestion *question, int32_t by, double *results)
{
    tinker_typed_ask(question, by, -1, results);
}

static double formula_energy(const TinkerTypedLaw *formula, const double *arguments)
{
    return tinker_typed_stored(formula, arguments);
}

static const TinkerTypedLawService formula_service = {sizeof(TinkerTypedLawService),
                                                      0,
                                                      formula_value,
                                                      formula_slope,
                                                      formula_curvature,
                                                      formula_values,
                                                      formula_slopes,
                                                      tinker_typed_ask,
                                                      formula_energy};

static const struct {
    const char *id;
    const void *service;
} services[] = {{TINKER_LOG_SERVICE, &log_service}, {TINKER_TYPED_SERVICE, &formula_service}};

static const void *find_service(const char *id)
{
    for (gsize i = 0; id != NULL && i < G_N_ELEMENTS(services); i++)
        if (strcmp(id, services[i].id) == 0) return services[i].service;
    return NULL;
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
    return "\"" TINKER_LOG_SERVICE "\", \"" TINKER_TYPED_SERVICE "\"";
}
