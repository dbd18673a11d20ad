/* Copies of a plugin's structs. Sizes and strides are checked before anything behind them is read. */
#include "plugin/descriptor/copy.h"

#include <string.h>

#include "plugin/trust/refuse.h"

/* Beyond these a number is garbage rather than a declaration. */
#define MOST_STRUCT_SIZE 65536
#define MOST_ELEMENTS    10000

static gboolean check_struct_size(guint32 struct_size, const char *what, TinkerShape shape, GError **error)
{
    if (struct_size < shape.least)
        return tinker_refuse(error, "struct_size of %s is %u, at least %zu is needed", what, struct_size, shape.least);
    if (struct_size > MOST_STRUCT_SIZE)
        return tinker_refuse(error, "struct_size of %s is %u, at most %d is allowed", what, struct_size,
                             MOST_STRUCT_SIZE);
    // A size that is no multiple of the alignment could end within a member.
    if (struct_size % shape.alignment != 0)
        return tinker_refuse(error, "struct_size of %s is %u, a multiple of %zu was expected", what, struct_size,
                             shape.alignment);
    return TRUE;
}

static gboolean check_span(const TinkerSpan *span, const char *what, TinkerShape shape, GError **error)
{
    if (span->count < 0 || span->count > MOST_ELEMENTS)
        return tinker_refuse(error, "the number of %s is %d, 0 to %d was expected", what, span->count, MOST_ELEMENTS);
    if (span->count == 0) return TRUE;
    if (span->data == NULL) return tinker_refuse(error, "the data of %d %s is NULL", span->count, what);
    if ((guintptr)span->data % shape.alignment != 0)
        return tinker_refuse(error, "the data of %s is not aligned to %zu bytes", what, shape.alignment);
    if (span->stride < 0 || (gsize)span->stride < shape.least)
        return tinker_refuse(error, "the stride of %s is %d bytes, at least %zu are needed", what, span->stride,
                             shape.least);
    if (span->stride > MOST_STRUCT_SIZE || (gsize)span->stride % shape.alignment != 0)
        return tinker_refuse(error, "the stride of %s is %d bytes, a multiple of %zu up to %d was expected", what,
                             span->stride, shape.alignment, MOST_STRUCT_SIZE);
    return TRUE;
}

static void copy_bytes(void *target, const void *source, gsize source_size, TinkerShape shape)
{
    memcpy(target, source, MIN(source_size, shape.size));
    if (shape.sized) *(guint32 *)target = (guint32)shape.size;
}

/* Bytes that the element of a span may be read to, 0 when refused. */
static gsize element_size(const void *element, const TinkerSpan *span, const char *what, TinkerShape shape,
                          GError **error)
{
    if (!shape.sized) return (gsize)span->stride;
    const guint32 struct_size = *(const guint32 *)element;
    if (!check_struct_size(struct_size, what, shape, error)) return 0;
    if (struct_size > (guint32)span->stride) {
        tinker_refuse(error, "struct_size of %s is %u, more than their stride of %d bytes", what, struct_size,
                      span->stride);
        return 0;
    }
    return struct_size;
}

gpointer tinker_arena_allocate(GPtrArray *arena, gsize size)
{
    gpointer memory = g_malloc0(MAX(size, 1));
    g_ptr_array_add(arena, memory);
    return memory;
}

const char *tinker_arena_text(GPtrArray *arena, const char *text)
{
    char *copy = g_strdup(text);
    g_ptr_array_add(arena, copy);
    return copy;
}

gpointer tinker_struct_copy(const void *source, const char *what, TinkerShape shape, GPtrArray *arena, GError **error)
{
    const guint32 struct_size = *(const guint32 *)source;
    if (!check_struct_size(struct_size, what, shape, error)) return NULL;
    gpointer copy = tinker_arena_allocate(arena, shape.size);
    copy_bytes(copy, source, struct_size, shape);
    return copy;
}

gpointer tinker_span_copy(const TinkerSpan *span, const char *what, TinkerShape shape, GPtrArray *arena, GError **error)
{
    if (!check_span(span, what, shape, error)) return NULL;
    char *copy = tinker_arena_allocate(arena, (gsize)span->count * shape.size);
    for (int32_t i = 0; i < span->count; i++) {
        const char *element = (const char *)span->data + (gsize)i * (gsize)span->stride;
        const gsize size = element_size(element, span, what, shape, error);
        if (size == 0) return NULL;
        copy_bytes(copy + (gsize)i * shape.size, element, size, shape);
    }
    return copy;
}
