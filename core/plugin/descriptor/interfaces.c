/* The interfaces of a block type: found once, by id, copied to the host's size and checked for what is required. */
#include <string.h>

#include "plugin/descriptor/class-build.h"
#include "plugin/descriptor/copy.h"
#include "plugin/descriptor/text-check.h"
#include "plugin/trust/refuse.h"
#include "units/quantity/units.h"

/* The first eight bytes: struct_size and one number. What else is required is said function by function. */
#define LEAST_HEAD  8
#define SHAPE(type) ((TinkerShape){LEAST_HEAD, sizeof(type), _Alignof(type), TRUE})

typedef gboolean (*AddInterface)(TinkerBlockClass *block_class, const void *vtable, GPtrArray *arena, GError **error);

static gboolean lacks(const char *interface, const char *function, GError **error)
{
    return tinker_refuse(error, "its \"%s\" lacks the required function \"%s\"", interface, function);
}

static gboolean add_physics(TinkerBlockClass *block_class, const void *vtable, GPtrArray *arena, GError **error)
{
    block_class->physics = tinker_physics_copy(vtable, block_class, arena, error);
    return block_class->physics != NULL;
}

static gboolean add_render(TinkerBlockClass *block_class, const void *vtable, GPtrArray *arena, GError **error)
{
    const TinkerRender *render =
        tinker_struct_copy(vtable, "\"" TINKER_RENDER_INTERFACE "\"", SHAPE(TinkerRender), arena, error);
    if (render == NULL) return FALSE;
    if (render->draw == NULL) return lacks(TINKER_RENDER_INTERFACE, "draw", error);
    block_class->render = render;
    return TRUE;
}

static gboolean add_edit(TinkerBlockClass *block_class, const void *vtable, GPtrArray *arena, GError **error)
{
    const TinkerEdit *edit =
        tinker_struct_copy(vtable, "\"" TINKER_EDIT_INTERFACE "\"", SHAPE(TinkerEdit), arena, error);
    if (edit == NULL) return FALSE;
    if (edit->hit == NULL) return lacks(TINKER_EDIT_INTERFACE, "hit", error);
    if (edit->move == NULL) return lacks(TINKER_EDIT_INTERFACE, "move", error);
    if (edit->move_absolute == NULL) return lacks(TINKER_EDIT_INTERFACE, "move_absolute", error);
    block_class->edit = edit;
    return TRUE;
}

static gboolean add_graph(TinkerBlockClass *block_class, const void *vtable, GPtrArray *arena, GError **error)
{
    const TinkerGraph *graph =
        tinker_struct_copy(vtable, "\"" TINKER_GRAPH_INTERFACE "\"", SHAPE(TinkerGraph), arena, error);
    if (graph == NULL) return FALSE;
    if (graph->values == NULL) return lacks(TINKER_GRAPH_INTERFACE, "values", error);
    block_class->graph = graph;
    return TRUE;
}

static gboolean check_unit(const char *unit, TinkerDimension dimension, const char *id, GError **error)
{
    if (unit == NULL) return TRUE;
    TinkerUnit parsed;
    g_autoptr(GError) reason = NULL;
    if (!tinker_check_text(unit, "a unit", TRUE, error)) return FALSE;
    if (!tinker_unit_parse(unit, &parsed, &reason))
        return tinker_refuse(error, "the unit \"%s\" of \"%s\": %s", unit, id, reason->message);
    if (!tinker_dimension_equal(parsed.dimension, dimension))
        return tinker_refuse(error,
                             "the unit \"%s\" of \"%s\" has the dimension of \"%s\", that of \"%s\" was expected", unit,
                             id, tinker_unit_si_symbol(parsed.dimension), tinker_unit_si_symbol(dimension));
    return TRUE;
}

static gboolean check_unit_choice(const TinkerBlockClass *block_class, const TinkerUnitChoice *choice, GError **error)
{
    if (!tinker_check_id(choice->id, "the id of a unit choice", "", error)) return FALSE;
    const int32_t property = tinker_block_class_property(block_class, choice->id);
    const int32_t quantity = tinker_block_class_quantity(block_class, choice->id);
    if (property < 0 && quantity < 0)
        return tinker_refuse(error, "a unit is chosen for \"%s\", which is neither property nor quantity", choice->id);
    const TinkerDimension dimension =
        property >= 0 ? block_class->properties[property].dimension : block_class->quantities[quantity].dimension;
    return check_unit(choice->si, dimension, choice->id, error) &&
           check_unit(choice->english, dimension, choice->id, error);
}

static gboolean add_units(TinkerBlockClass *block_class, const void *vtable, GPtrArray *arena, GError **error)
{
    TinkerUnits *units = tinker_struct_copy(vtable, "\"" TINKER_UNITS_INTERFACE "\"", SHAPE(TinkerUnits), arena, error);
    if (units == NULL) return FALSE;
    TinkerUnitChoice *choices =
        tinker_span_copy(&units->choices, "unit choices", TINKER_SHAPE_PLAIN(TinkerUnitChoice), arena, error);
    if (choices == NULL) return FALSE;
    for (int32_t i = 0; i < units->choices.count; i++) {
        if (!check_unit_choice(block_class, &choices[i], error)) return FALSE;
        if (choices[i].si != NULL) choices[i].si = tinker_unit_in_print(choices[i].si);
        if (choices[i].english != NULL) choices[i].english = tinker_unit_in_print(choices[i].english);
    }
    units->choices.data = choices;
    units->choices.stride = (int32_t)sizeof(TinkerUnitChoice);
    block_class->units = units;
    return TRUE;
}

static const struct {
    const char *id;
    AddInterface add;
} known_interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, add_physics}, {TINKER_RENDER_INTERFACE, add_render}, {TINKER_EDIT_INTERFACE, add_edit},
    {TINKER_UNITS_INTERFACE, add_units},     {TINKER_GRAPH_INTERFACE, add_graph},
};

/* An interface of an id that this host does not know is somebody else's affair. */
static gboolean add_interface(TinkerBlockClass *block_class, const TinkerInterface *interface, GPtrArray *arena,
                              GError **error)
{
    if (interface->vtable == NULL) return tinker_refuse(error, "its interface \"%s\" is NULL", interface->id);
    for (gsize i = 0; i < G_N_ELEMENTS(known_interfaces); i++) {
        if (strcmp(known_interfaces[i].id, interface->id) == 0)
            return known_interfaces[i].add(block_class, interface->vtable, arena, error);
    }
    return TRUE;
}

gboolean tinker_block_class_add_interfaces(TinkerBlockClass *block_class, GPtrArray *arena, GError **error)
{
    const TinkerSpan *span = &block_class->type->interfaces;
    const TinkerInterface *interfaces =
        tinker_span_copy(span, "interfaces", TINKER_SHAPE_PLAIN(TinkerInterface), arena, error);
    if (interfaces == NULL) return FALSE;
    for (int32_t i = 0; i < span->count; i++) {
        if (!tinker_check_id(interfaces[i].id, "the id of an interface", "", error)) return FALSE;
        for (int32_t earlier = 0; earlier < i; earlier++) {
            if (strcmp(interfaces[earlier].id, interfaces[i].id) == 0)
                return tinker_refuse(error, "it offers \"%s\" twice", interfaces[i].id);
        }
        if (!add_interface(block_class, &interfaces[i], arena, error)) return FALSE;
    }
    if (block_class->quantity_count > 0 && block_class->graph == NULL)
        return tinker_refuse(error, "it has %d quantities, but no \"%s\" that gives their values",
                             block_class->quantity_count, TINKER_GRAPH_INTERFACE);
    return TRUE;
}
