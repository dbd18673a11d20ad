/* FNV-1a over 64 bits from a random start, and the finisher of MurmurHash3, which spreads every bit. */
#include "scene/json/text-hash.h"

static guint64 seed(void)
{
    static gsize once = 0;
    static guint64 value;
    if (g_once_init_enter(&once)) {
        value = ((guint64)g_random_int() << 32) | g_random_int();
        g_once_init_leave(&once, 1);
    }
    return value;
}

guint tinker_text_hash(gconstpointer text)
{
    guint64 hash = seed();
    for (const unsigned char *byte = text; *byte != '\0'; byte++)
        hash = (hash ^ *byte) * G_GUINT64_CONSTANT(0x100000001b3);
    hash = (hash ^ (hash >> 33)) * G_GUINT64_CONSTANT(0xff51afd7ed558ccd);
    return (guint)(hash ^ (hash >> 33));
}
