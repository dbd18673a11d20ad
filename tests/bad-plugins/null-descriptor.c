/* An entry that answers nothing. */
#include <tinker/sdk.h>

const TinkerPlugin *tinker_plugin_v1(void)
{
    return NULL;
}
