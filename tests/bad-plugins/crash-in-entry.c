/* Writes through a null pointer, and no sanitizer is to stop it: the crash is what the host must survive. */
#include "exhibit.h"

static TinkerPlugin *volatile nowhere;

__attribute__((no_sanitize("undefined"))) const TinkerPlugin *tinker_plugin_v1(void)
{
    *(volatile uint32_t *)&nowhere->magic = exhibit_blocks[0].struct_size;
    return nowhere;
}
