/* Properties and quantities of a class by their ids. */
#include "plugin/descriptor/class-build.h"

int32_t tinker_block_class_property(const TinkerBlockClass *block_class, const char *id)
{
    for (int32_t i = 0; i < block_class->property_count; i++) {
        if (g_strcmp0(block_class->properties[i].id, id) == 0) return i;
    }
    return -1;
}

int32_t tinker_block_class_quantity(const TinkerBlockClass *block_class, const char *id)
{
    for (int32_t i = 0; i < block_class->quantity_count; i++) {
        if (g_strcmp0(block_class->quantities[i].id, id) == 0) return i;
    }
    return -1;
}
