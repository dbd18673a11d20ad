/* In the order of the descriptor, as in the panel of properties and the menu of graphs. */
#include "gui/instrument/instrument-menu.h"

#include "gui/text/block-words.h"
#include "gui/text/translate.h"
#include "scene/store/quantities.h"

static void append(GMenu *menu, const char *label, const char *action, const char *target)
{
    g_autoptr(GMenuItem) item = g_menu_item_new(label, NULL);
    g_menu_item_set_action_and_target_value(item, action, g_variant_new_string(target));
    g_menu_append_item(menu, item);
}

static void append_control(GMenu *menu, const TinkerPropertyType *property)
{
    if (property->flags & (TINKER_READ_ONLY | TINKER_DERIVED)) return;
    if (property->meaning == TINKER_MEANING_LOCAL_ORIGIN) return; /* which moves nothing */
    if (property->kind != TINKER_KIND_VECTOR) {
        append(menu, tinker_translate(property->title), "win.add-control", property->id);
        return;
    }
    for (int i = 0; i < 2; i++) {
        g_autofree char *label = tinker_property_words(property, i);
        g_autofree char *name = g_strdup_printf("%s.%c", property->id, "xy"[i]);
        append(menu, label, "win.add-control", name);
    }
}

GMenuModel *tinker_control_menu_new(const TinkerBlockClass *block_class)
{
    GMenu *menu = g_menu_new();
    for (int32_t p = 0; block_class != NULL && p < block_class->property_count; p++) {
        const TinkerPropertyType *property = &block_class->properties[p];
        const int32_t kind = property->kind;
        if (kind == TINKER_KIND_REAL || kind == TINKER_KIND_INTEGER || kind == TINKER_KIND_SWITCH ||
            kind == TINKER_KIND_VECTOR)
            append_control(menu, property);
    }
    return G_MENU_MODEL(menu);
}

GMenuModel *tinker_meter_menu_new(const TinkerScene *scene, TinkerBlockId block)
{
    GMenu *menu = g_menu_new();
    g_auto(GStrv) names = tinker_scene_quantity_names(scene, block);
    for (char **name = names; *name != NULL; name++) {
        const int32_t number = tinker_scene_find_quantity(scene, block, *name);
        if (number < 0 || tinker_quantity_other(number) != TINKER_NO_BLOCK)
            continue; /* a distance: as many as blocks */
        append(menu, tinker_translate(tinker_scene_quantity_type(scene, block, number).title), "win.add-meter", *name);
    }
    return G_MENU_MODEL(menu);
}
