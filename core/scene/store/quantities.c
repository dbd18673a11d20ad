/* Names and kinds of quantities: declared ones by their class, implied ones by tables. */
#include "scene/store/quantities.h"

#include <string.h>

#include <tinker/declare.h>
#include <tinker/physics.h>

#define SCENE_NAME  "Scene"
#define DISTANCE_TO "distance to "

/* In the order of their numbers. */
static const TinkerQuantityType implied[] = {
    TINKER_QUANTITY(0, "length", "Length", "Distance between the ends", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(0, "angle", "Angle", "Of the way from the first end to the second, counter-clockwise from +x",
                    TINKER_DIMENSION_ANGLE),
    TINKER_QUANTITY(0, "angle rate", "Angle Rate", "How fast the angle grows", TINKER_DIMENSION_ANGULAR_FREQUENCY),
    TINKER_QUANTITY(0, "path length", "Path Length", "Length of the way since the start of the run",
                    TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType of_scene[TINKER_SCENE_QUANTITIES] = {
    TINKER_QUANTITY(0, "kinetic energy", "Kinetic Energy", "Of all masses", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "potential energy", "Potential Energy", "Of all masses in fields, 0 at the origin",
                    TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "stored energy", "Stored Energy", "In springs and the like", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "energy", "Total Energy", "Kinetic, potential and stored energy", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "damper loss", "Damper Loss", "What dampers have taken", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "friction loss", "Friction Loss", "What friction has taken", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "impact loss", "Impact Loss", "What impacts have taken", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "dissipated energy", "Dissipated Energy", "What dampers, friction and impacts have taken",
                    TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "supplied energy", "Supplied Energy", "What motors, wind and moved supports have given",
                    TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "x momentum", "X Momentum", "Of all masses", TINKER_DIMENSION_MOMENTUM),
    TINKER_QUANTITY(0, "y momentum", "Y Momentum", "Of all masses", TINKER_DIMENSION_MOMENTUM),
};

gboolean tinker_scene_find_owner(const TinkerScene *scene, const char *name, TinkerBlockId *block)
{
    *block = tinker_scene_find_block(scene, name);
    return *block != TINKER_NO_BLOCK || strcmp(name, SCENE_NAME) == 0;
}

const char *tinker_scene_split_name(const TinkerScene *scene, const char *text, TinkerBlockId *block)
{
    for (const char *dot = strrchr(text, '.'); dot != NULL; dot = g_strrstr_len(text, dot - text, ".")) {
        g_autofree char *before = g_strndup(text, (gsize)(dot - text));
        if (tinker_scene_find_owner(scene, before, block)) return dot + 1;
    }
    return NULL;
}

const char *tinker_scene_owner_name(const TinkerScene *scene, TinkerBlockId block)
{
    return block == TINKER_NO_BLOCK ? SCENE_NAME : tinker_scene_block_name(scene, block);
}

/* What implies quantities: two ends, a centre, a body that can move. */
static gboolean has_two_ends(const TinkerBlockClass *block_class)
{
    return block_class->type->least_ends == 2 && block_class->type->most_ends == 2;
}

static gboolean has_centre(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->physics != NULL && block_class->physics->body != NULL;
}

static gboolean is_implied(const TinkerBlockClass *block_class, int32_t number)
{
    if (number == TINKER_IMPLIED_PATH_LENGTH) return tinker_block_class_moves(block_class);
    return has_two_ends(block_class);
}

static TinkerQuantityType implied_type(const TinkerBlockClass *block_class, int32_t number)
{
    TinkerQuantityType type = implied[number - TINKER_IMPLIED_LENGTH];
    if (number == TINKER_IMPLIED_ANGLE && tinker_block_class_is_about_turning(block_class))
        type.description = "From what its first end is on to what its second is on, counting turns";
    return type;
}

char *tinker_quantity_distance_to(const char *other)
{
    return g_strconcat(DISTANCE_TO, other, NULL);
}

const char *tinker_quantity_other_name(const char *id)
{
    return g_str_has_prefix(id, DISTANCE_TO) ? id + strlen(DISTANCE_TO) : NULL;
}

char *tinker_quantity_renamed(const char *id, const char *from, const char *to)
{
    const char *other = tinker_quantity_other_name(id);
    return other != NULL && strcmp(other, from) == 0 ? tinker_quantity_distance_to(to) : NULL;
}

static int32_t find_distance(const TinkerScene *scene, TinkerBlockId block, const char *id)
{
    const char *name = tinker_quantity_other_name(id);
    if (name == NULL || !has_centre(tinker_scene_block_class(scene, block))) return -1;
    TinkerBlockId other = tinker_scene_find_block(scene, name);
    gboolean found = other != TINKER_NO_BLOCK && other != block && has_centre(tinker_scene_block_class(scene, other));
    return found ? TINKER_IMPLIED_DISTANCE + other : -1;
}

int32_t tinker_scene_find_quantity(const TinkerScene *scene, TinkerBlockId block, const char *id)
{
    for (int32_t i = 0; block == TINKER_NO_BLOCK && i < TINKER_SCENE_QUANTITIES; i++)
        if (strcmp(of_scene[i].id, id) == 0) return i;
    const TinkerBlockClass *block_class = block == TINKER_NO_BLOCK ? NULL : tinker_scene_block_class(scene, block);
    if (block_class == NULL) return -1;
    int32_t number = tinker_block_class_quantity(block_class, id);
    for (int32_t i = 0; number < 0 && i < (int32_t)G_N_ELEMENTS(implied); i++)
        if (strcmp(implied[i].id, id) == 0 && is_implied(block_class, TINKER_IMPLIED_LENGTH + i))
            number = TINKER_IMPLIED_LENGTH + i;
    return number >= 0 ? number : find_distance(scene, block, id);
}

TinkerQuantityType tinker_scene_quantity_type(const TinkerScene *scene, TinkerBlockId block, int32_t number)
{
    if (block == TINKER_NO_BLOCK) return of_scene[number];
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (number < TINKER_IMPLIED_LENGTH) return block_class->quantities[number];
    if (number - TINKER_IMPLIED_LENGTH < (int32_t)G_N_ELEMENTS(implied)) return implied_type(block_class, number);
    const char *other = tinker_scene_block_name(scene, tinker_quantity_other(number));
    g_autofree char *id = tinker_quantity_distance_to(other), *title = g_strconcat(TINKER_DISTANCE_TITLE, other, NULL);
    return (TinkerQuantityType)TINKER_QUANTITY(0, g_intern_string(id), g_intern_string(title),
                                               "Distance between the centres", TINKER_DIMENSION_LENGTH);
}

GArray *tinker_class_quantities(const TinkerBlockClass *block_class)
{
    static const TinkerQuantityType distance =
        TINKER_QUANTITY(0, DISTANCE_TO "BLOCK", "Distance to BLOCK", "Distance between the centres of the two",
                        TINKER_DIMENSION_LENGTH);
    GArray *types = g_array_new(FALSE, FALSE, sizeof(TinkerQuantityType));
    g_array_append_vals(types, block_class->quantities, (guint)block_class->quantity_count);
    for (int32_t i = 0; i < (int32_t)G_N_ELEMENTS(implied); i++) {
        const TinkerQuantityType type = implied_type(block_class, TINKER_IMPLIED_LENGTH + i);
        if (is_implied(block_class, TINKER_IMPLIED_LENGTH + i) && tinker_block_class_quantity(block_class, type.id) < 0)
            g_array_append_val(types, type);
    }
    if (has_centre(block_class)) g_array_append_val(types, distance);
    return types;
}

GStrv tinker_scene_quantity_names(const TinkerScene *scene, TinkerBlockId block)
{
    g_autoptr(GStrvBuilder) names = g_strv_builder_new();
    const TinkerBlockClass *block_class = block == TINKER_NO_BLOCK ? NULL : tinker_scene_block_class(scene, block);
    for (int32_t i = 0; block == TINKER_NO_BLOCK && i < TINKER_SCENE_QUANTITIES; i++)
        g_strv_builder_add(names, of_scene[i].id);
    if (block_class == NULL) return g_strv_builder_end(names);
    g_autoptr(GArray) types = tinker_class_quantities(block_class);
    for (guint i = 0; i < types->len; i++)
        g_strv_builder_add(names, g_array_index(types, TinkerQuantityType, i).id);
    return g_strv_builder_end(names);
}
