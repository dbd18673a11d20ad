/* Copies of what a plugin declares, in structs of this host's own size.
 *
 * A plugin compiled with older headers has shorter structs, one compiled with newer headers longer ones. A copy has
 * this host's size: what the plugin does not know is zero, what the host does not know is left behind.
 */
#ifndef TINKER_PLUGIN_COPY_H
#define TINKER_PLUGIN_COPY_H

#include "plugin/descriptor/block-class.h"

/* How a struct is laid out on this host. */
typedef struct {
    gsize least;     /* bytes that the other side must have */
    gsize size;      /* sizeof */
    gsize alignment; /* _Alignof */
    gboolean sized;  /* it begins with struct_size; else a span's stride is its size */
} TinkerShape;

/* The shape of a struct that begins with struct_size, of which all up to `member` must be there. */
#define TINKER_SHAPE_THROUGH(type, member)                                                                             \
    ((TinkerShape){offsetof(type, member) + sizeof(((type *)0)->member), sizeof(type), _Alignof(type), TRUE})

/* The shape of an element without struct_size. */
#define TINKER_SHAPE_PLAIN(type) ((TinkerShape){sizeof(type), sizeof(type), _Alignof(type), FALSE})

/* Memory that lives as long as the arena, zeroed. The arena holds it with g_free. */
gpointer tinker_arena_allocate(GPtrArray *arena, gsize size);

/* A copy of a text that lives as long as the arena. */
const char *tinker_arena_text(GPtrArray *arena, const char *text);

/* A copy of one struct that begins with struct_size. `what` names it in the message of a refusal. NULL when refused. */
gpointer tinker_struct_copy(const void *source, const char *what, TinkerShape shape, GPtrArray *arena, GError **error);

/* A dense copy of a span's elements; never NULL but when refused. */
gpointer tinker_span_copy(const TinkerSpan *span, const char *what, TinkerShape shape, GPtrArray *arena,
                          GError **error);

#endif
