/* Tinker SDK: the entry of a plugin.
 *
 * A plugin is a shared object that exports exactly one symbol, tinker_plugin_v1, and links to nothing of the host.
 * The host opens it with immediate, local binding, never closes it, and checks in this order: symbol, magic, size of
 * the descriptor, sizes of the numbers, minor versions, services, unique ids; then it calls `init`.
 */
#ifndef TINKER_PLUGIN_H
#define TINKER_PLUGIN_H

#include "block.h"

#ifdef __cplusplus
extern "C" {
#endif

/* "TNKR", so that a library that is something else altogether is told apart. */
#define TINKER_MAGIC 0x544e4b52u

/* What the plugin may ask of the host. Lives as long as the process. */
typedef struct TinkerHost {
    uint32_t struct_size;
    int32_t abi_minor;
    /* The service of this id, or NULL where this host has none. Services are structs of functions that begin with
     * struct_size; the host's own are declared below. Callable in init and later, from any thread. */
    const void *(*service)(const struct TinkerHost *host, const char *id);
} TinkerHost;

/* Service "tinker.log/1": a line for the user or the developer. Never on the hot path. */
#define TINKER_LOG_SERVICE "tinker.log/1"
#define TINKER_LOG_INFO    0
#define TINKER_LOG_WARNING 1
typedef struct TinkerLogService {
    uint32_t struct_size;
    int32_t reserved;
    void (*log)(const TinkerHost *host, int32_t level, const char *text);
} TinkerLogService;

typedef struct TinkerPlugin {
    uint32_t magic;       /* TINKER_MAGIC */
    uint32_t struct_size; /* sizeof(TinkerPlugin) */
    int32_t abi_minor;    /* TINKER_ABI_MINOR of the headers it was compiled with */
    int32_t least_host_minor;
    int32_t size_of_double; /* sizeof(double) */
    int32_t size_of_index;  /* sizeof(int32_t) */
    const char *id;         /* reverse DNS, "org.tinker.spring" */
    const char *title;
    const char *version; /* of the plugin, semantic */
    const char *licence; /* SPDX */
    const char *home_page;
    TinkerSpan blocks;      /* of TinkerBlockType */
    TinkerSpan integrators; /* of TinkerIntegrator (integrator.h) */
    TinkerSpan services;    /* of const char *: ids of services it cannot do without */
    /* Called once after the checks; NULL where there is nothing to do. Anything but TINKER_OK refuses the plugin. */
    TinkerStatus (*init)(const TinkerHost *host);
} TinkerPlugin;

/* The entry: pure, may be called any number of times, answers a static descriptor. */
TINKER_EXPORT const TinkerPlugin *tinker_plugin_v1(void);
#define TINKER_ENTRY_SYMBOL "tinker_plugin_v1"

/* A span over a static array. */
#define TINKER_SPAN(array)                                                                                             \
    {                                                                                                                  \
        (array), (int32_t)(sizeof(array) / sizeof((array)[0])), (int32_t)sizeof((array)[0])                            \
    }
#define TINKER_NO_SPAN                                                                                                 \
    {                                                                                                                  \
        NULL, 0, 0                                                                                                     \
    }

/* The first members of a descriptor, which are the same for every plugin. */
#define TINKER_PLUGIN_HEAD                                                                                             \
    TINKER_MAGIC, (uint32_t)sizeof(TinkerPlugin), TINKER_ABI_MINOR, 0, (int32_t)sizeof(double), (int32_t)sizeof(int32_t)

#ifdef __cplusplus
}
#endif
#endif
