/* Needs a function that nobody has. */
#include "exhibit.h"

const TinkerPlugin *exhibit_missing_function(void);

const TinkerPlugin *tinker_plugin_v1(void)
{
    return exhibit_blocks[0].id == NULL ? NULL : exhibit_missing_function();
}
