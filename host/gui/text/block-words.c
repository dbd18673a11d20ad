/* Says in one line what a sighted user sees of a block on the canvas. */
#include "gui/text/block-words.h"

#include <glib/gi18n.h>
#include <string.h>

#include "gui/text/translate.h"

#define DECIMALS 5

const char *tinker_block_type_title(const TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    return block_class != NULL ? tinker_translate(block_class->type->title) : tinker_scene_block_type(scene, block);
}

static const char *end_words(const TinkerScene *scene, TinkerBlockId block, int32_t end)
{
    TinkerBlockId on = tinker_scene_end(scene, block, end).block;
    return on != TINKER_NO_BLOCK ? tinker_scene_block_name(scene, on) : _("a loose end");
}

static char *ends_words(const TinkerScene *scene, TinkerBlockId block, int32_t count)
{
    if (count == 1) return g_strdup_printf(_("on %s"), end_words(scene, block, 0));
    if (count == 2) return g_strdup_printf(_("from %s to %s"), end_words(scene, block, 0), end_words(scene, block, 1));
    GString *text = g_string_new(_("between "));
    for (int32_t i = 0; i < count; i++)
        g_string_append_printf(text, "%s%s", i > 0 ? ", " : "", end_words(scene, block, i));
    return g_string_free(text, FALSE);
}

/* Where it is at the start, or what it connects: "at (0.00000 m, 2.00000 m)", "from Support 0 to Mass 0", "on Mass 0";
 * NULL of what has neither place nor ends. (transfer full) */
static char *place_words(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (block_class == NULL) return NULL;
    int32_t ends = tinker_scene_end_count(scene, block);
    if (ends > 0) return ends_words(scene, block, ends);
    int32_t property = block_class->meanings[TINKER_MEANING_POSITION];
    if (property < 0) return NULL;
    const TinkerPropertyType *type = &block_class->properties[property];
    TinkerUnitSystem system = tinker_scene_head(scene)->units;
    const char *unit =
        tinker_block_class_unit(block_class, type->id, type->dimension, system == TINKER_UNIT_SYSTEM_ENGLISH);
    int32_t column = block_class->first_columns[property];
    g_autofree char *x =
        tinker_quantity_format(tinker_scene_get(scene, block, column), type->dimension, unit, system, DECIMALS);
    g_autofree char *y =
        tinker_quantity_format(tinker_scene_get(scene, block, column + 1), type->dimension, unit, system, DECIMALS);
    return g_strdup_printf(_("at (%s, %s)"), x, y);
}

char *tinker_block_words(TinkerScene *scene, TinkerBlockId block)
{
    g_autofree char *place = place_words(scene, block);
    return g_strjoin(", ", tinker_scene_block_name(scene, block), tinker_block_type_title(scene, block), place, NULL);
}

/* Whether one text has the other in it, in whatever case. */
static gboolean holds(const char *text, const char *part)
{
    g_autofree char *folded_text = g_utf8_casefold(text, -1), *folded_part = g_utf8_casefold(part, -1);
    return strstr(folded_text, folded_part) != NULL;
}

gboolean tinker_component_needs_title(const TinkerPropertyType *type, int32_t component)
{
    const char *label = type->component_titles[component];
    return label != NULL && !holds(label, type->title) && !holds(type->group, type->title);
}

char *tinker_property_words(const TinkerPropertyType *type, int32_t component)
{
    const gboolean is_vector = type->kind == TINKER_KIND_VECTOR;
    const char *label = is_vector ? type->component_titles[component] : NULL;
    if (label == NULL)
        return g_strconcat(tinker_translate(type->title), !is_vector ? "" : component == 0 ? " x" : " y", NULL);
    if (holds(label, type->title)) return g_strdup(tinker_translate(label));
    /* of the origin itself, not of the offset that its heading is of */
    const gboolean by_title =
        type->meaning == TINKER_MEANING_LOCAL_ORIGIN || tinker_component_needs_title(type, component);
    return g_strdup_printf("%s %s", tinker_translate(by_title ? type->title : type->group), tinker_translate(label));
}
