/* Ends the program that asks. */
#include <unistd.h>

#include "exhibit.h"

const TinkerPlugin *tinker_plugin_v1(void)
{
    _exit(exhibit_blocks[0].schema_version + 6);
}
