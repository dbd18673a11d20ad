/* Laws for blocks into which they are typed: of the last of such properties, half the sum of the squares of its first
 * arguments. Every instance has the same. */
#include "conformance/probe/sample-laws.h"

#include <string.h>

#include "law/typed-law.h"
#include "units/quantity/point-text.h"

#define MOST_INSTANCES 1024
#define MOST_ARGUMENTS 2 /* L, or x and y */

static int32_t last_law(const TinkerBlockClass *block_class, int32_t *count)
{
    int32_t last = -1;
    *count = 0;
    for (int32_t p = 0; p < block_class->property_count; p++) {
        if ((block_class->properties[p].flags & TINKER_TEXT_LAW) == 0) continue;
        last = p;
        ++*count;
    }
    return last;
}

static const char *text_of(G_GNUC_UNUSED int32_t property, void *data)
{
    return data;
}

static TinkerTypedLaw *sample_of(const TinkerBlockClass *block_class, int32_t property)
{
    const TinkerPropertyType *type = &block_class->properties[property];
    g_autoptr(GString) text = g_string_new("0");
    for (int32_t i = 0; i < MIN(type->choice_count, MOST_ARGUMENTS); i++)
        if (strcmp(type->choices[i], "t") != 0) g_string_append_printf(text, " + %s^2/2", type->choices[i]);
    return tinker_typed_new(block_class, property, text_of, text->str, NULL);
}

const struct TinkerTypedLaw *const *kit_sample_laws(const TinkerBlockClass *block_class, int32_t *count)
{
    static GMutex mutex;
    static GHashTable *known; /* class to its array, for good */
    const int32_t property = last_law(block_class, count);
    if (property < 0) return NULL;
    g_mutex_lock(&mutex);
    if (known == NULL) known = g_hash_table_new(NULL, NULL);
    TinkerTypedLaw **laws = g_hash_table_lookup(known, block_class);
    if (laws == NULL) {
        laws = g_new0(TinkerTypedLaw *, MOST_INSTANCES * *count);
        laws[*count - 1] = sample_of(block_class, property);
        for (int32_t i = 1; i < MOST_INSTANCES; i++)
            laws[(i + 1) * *count - 1] = laws[*count - 1];
        g_hash_table_insert(known, (void *)block_class, laws);
    }
    g_mutex_unlock(&mutex);
    return (const struct TinkerTypedLaw *const *)laws;
}

static TinkerPointList default_points(const TinkerPropertyType *type)
{
    GArray *points =
        tinker_point_text_parse(type->default_text != NULL ? type->default_text : "", type->dimension, NULL);
    if (points == NULL) return (TinkerPointList){0};
    const int32_t count = (int32_t)points->len / 2;
    return (TinkerPointList){(const double *)(gpointer)g_array_free(points, FALSE), count, 0};
}

const TinkerPointList *kit_sample_points(const TinkerBlockClass *block_class, int32_t *count)
{
    static GMutex mutex;
    static GHashTable *known; /* class to its array, for good */
    *count = 0;
    for (int32_t p = 0; p < block_class->property_count; p++)
        *count += (block_class->properties[p].flags & TINKER_TEXT_POINTS) != 0;
    if (*count == 0) return NULL;
    g_mutex_lock(&mutex);
    if (known == NULL) known = g_hash_table_new(NULL, NULL);
    TinkerPointList *lists = g_hash_table_lookup(known, block_class);
    if (lists == NULL) {
        lists = g_new0(TinkerPointList, MOST_INSTANCES * *count);
        for (int32_t p = 0, k = 0; p < block_class->property_count; p++)
            if ((block_class->properties[p].flags & TINKER_TEXT_POINTS) != 0)
                lists[k++] = default_points(&block_class->properties[p]);
        for (int32_t i = *count; i < MOST_INSTANCES * *count; i++)
            lists[i] = lists[i - *count];
        g_hash_table_insert(known, (void *)block_class, lists);
    }
    g_mutex_unlock(&mutex);
    return lists;
}
