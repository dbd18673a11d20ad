/* A plugin for the next major version of the contract. */
#include <tinker/types.h>

TINKER_EXPORT const void *tinker_plugin_v2(void);

const void *tinker_plugin_v2(void)
{
    return NULL;
}
