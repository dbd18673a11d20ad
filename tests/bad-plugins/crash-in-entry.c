/* Writes through a null pointer. */
#include "exhibit.h"

static TinkerPlugin *volatile nowhere;

const TinkerPlugin *tinker_plugin_v1(void)
{
    *(volatile uint32_t *)&nowhere->magic = exhibit_blocks[0].struct_size;
    return nowhere;
}
