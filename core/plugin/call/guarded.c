/* A header, the memory, a band; all in one list.
 *
 *     | link, owner, bytes | what the plugin may write | band |
 */
#include "plugin/call/guarded.h"

#include <stddef.h>
#include <string.h>

#define BAND_BYTES        64
#define BAND_VALUE        0xa5
#define EIGHT_BAND_VALUES G_GUINT64_CONSTANT(0xa5a5a5a5a5a5a5a5)
/* Entries that the handler of crashes looks at: a list that was overwritten may have no end. */
#define MOST_LOOKS 100000

typedef struct _Header Header;
struct _Header {
    Header *next, *previous;
    const TinkerBlockClass *owner;
    gsize bytes;
    max_align_t memory[];
};

static GMutex mutex;
static Header *list;

static const guint8 *band_of(const Header *header)
{
    return (const guint8 *)header->memory + header->bytes;
}

static Header *header_of(const void *memory)
{
    return (Header *)((guint8 *)memory - offsetof(Header, memory));
}

void *tinker_guarded_try_new(gsize bytes, const TinkerBlockClass *owner)
{
    Header *header = g_try_malloc0(sizeof(Header) + bytes + BAND_BYTES);
    if (header == NULL) return NULL;
    header->owner = owner;
    header->bytes = bytes;
    memset((guint8 *)header->memory + bytes, BAND_VALUE, BAND_BYTES);
    g_mutex_lock(&mutex);
    header->next = list;
    if (list != NULL) list->previous = header;
    list = header;
    g_mutex_unlock(&mutex);
    return header->memory;
}

void *tinker_guarded_new(gsize bytes, const TinkerBlockClass *owner)
{
    void *memory = tinker_guarded_try_new(bytes, owner);
    if (memory == NULL) g_error("failed to allocate %" G_GSIZE_FORMAT " bytes for a plugin", bytes);
    return memory;
}

void tinker_guarded_free(void *memory)
{
    if (memory == NULL) return;
    Header *header = header_of(memory);
    g_mutex_lock(&mutex);
    if (header->next != NULL) header->next->previous = header->previous;
    if (header->previous != NULL)
        header->previous->next = header->next;
    else
        list = header->next;
    g_mutex_unlock(&mutex);
    g_free(header);
}

gboolean tinker_guarded_is_whole(const void *memory)
{
    if (memory == NULL) return TRUE;
    const guint8 *band = band_of(header_of(memory));
    guint64 differs = 0;
    for (int i = 0; i < BAND_BYTES; i += 8) {
        guint64 eight;
        memcpy(&eight, band + i, sizeof eight);
        differs |= eight ^ EIGHT_BAND_VALUES;
    }
    return differs == 0;
}

gboolean tinker_guarded_find_broken(const TinkerBlockClass **owner)
{
    int looks = 0;
    for (const Header *header = list; header != NULL && looks < MOST_LOOKS; header = header->next, looks++) {
        if (tinker_guarded_is_whole(header->memory)) continue;
        *owner = header->owner;
        return TRUE;
    }
    return FALSE;
}
