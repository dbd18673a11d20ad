/* Wrappers that count; the linker puts them before the real functions. */
#include "allotments.h"

#include <glib.h>

_Atomic int allotments;

/* Visible: the linker counts what libraries refer to as well. */
#define WRAP(result, name, parameters, arguments)                                                                      \
    result __real_##name parameters;                                                                                   \
    __attribute__((visibility("default"))) result __wrap_##name parameters;                                            \
    result __wrap_##name parameters                                                                                    \
    {                                                                                                                  \
        allotments++;                                                                                                  \
        return __real_##name arguments;                                                                                \
    }

WRAP(void *, malloc, (size_t size), (size))
WRAP(void *, calloc, (size_t count, size_t size), (count, size))
WRAP(void *, realloc, (void *memory, size_t size), (memory, size))
WRAP(void *, g_malloc, (gsize size), (size))
WRAP(void *, g_malloc0, (gsize size), (size))
WRAP(void *, g_try_malloc0, (gsize size), (size))
WRAP(void *, g_realloc, (gpointer memory, gsize size), (memory, size))
WRAP(void *, g_malloc_n, (gsize count, gsize size), (count, size))
WRAP(void *, g_malloc0_n, (gsize count, gsize size), (count, size))
WRAP(void *, g_realloc_n, (gpointer memory, gsize count, gsize size), (memory, count, size))
WRAP(void *, g_memdup2, (gconstpointer memory, gsize size), (memory, size))
