/* Block classes: a block type as the rest of the core uses it, and the questions asked of one. */
#include "plugin/descriptor/class-build.h"

#include <string.h>

#include "plugin/descriptor/copy.h"
#include "plugin/descriptor/text-check.h"
#include "plugin/trust/refuse.h"
#include "units/quantity/units.h"

static const char *const categories[] = {TINKER_CONNECTABLE, TINKER_CONNECTOR, TINKER_FORCE,
                                         TINKER_MOTION,      TINKER_FIELD,     TINKER_JOINT,
                                         TINKER_ROPE,        TINKER_MEASURE,   NULL};

static gboolean check_category(const char *category, GError **error)
{
    if (!tinker_check_text(category, "its category", TRUE, error)) return FALSE;
    if (g_strv_contains(categories, category)) return TRUE;
    g_autofree char *known = g_strjoinv(", ", (char **)categories);
    return tinker_refuse(error, "its category is \"%s\", one of %s was expected", category, known);
}

static gboolean check_ends(const TinkerBlockType *type, GError **error)
{
    if (type->least_ends < 0)
        return tinker_refuse(error, "its least number of ends is %d, at least 0 was expected", type->least_ends);
    if (type->most_ends != -1 && type->most_ends < type->least_ends)
        return tinker_refuse(error, "it has at least %d and at most %d ends (-1 stands for any number)",
                             type->least_ends, type->most_ends);
    if (type->most_ends != 0 && (type->end_accepts & (TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT)) == 0)
        return tinker_refuse(error, "its ends accept neither bodies nor supports");
    return TRUE;
}

/* An icon lies beside the library: its path must not lead out of that folder. */
static gboolean check_icon(const char *icon_path, GError **error)
{
    if (!tinker_check_text(icon_path, "its icon path", FALSE, error)) return FALSE;
    if (icon_path != NULL && (g_path_is_absolute(icon_path) || strstr(icon_path, "..") != NULL))
        return tinker_refuse(error, "its icon path \"%s\" leads out of the plugin's folder", icon_path);
    return TRUE;
}

static gboolean check_type(TinkerBlockType *type, GError **error)
{
    if (type->schema_version < 1)
        return tinker_refuse(error, "its schema version is %d, at least 1 was expected", type->schema_version);
    if (!tinker_check_text(type->title, "its title", FALSE, error) ||
        !tinker_check_text(type->summary, "its summary", FALSE, error) ||
        !tinker_check_text(type->help_link, "its help link", FALSE, error))
        return FALSE;
    if (type->title == NULL) type->title = type->id;
    if (type->title[0] == '\0' || strchr(type->title, '\n') != NULL)
        return tinker_refuse(error, "its title must be one line of text, because its blocks are named after it");
    if (type->summary == NULL) type->summary = "";
    return check_category(type->category, error) && check_icon(type->icon_path, error) && check_ends(type, error);
}

/* What a short struct leaves out and zero would misstate. */
static TinkerPropertyType *copy_properties(const TinkerBlockType *type, GPtrArray *arena, GError **error)
{
    TinkerPropertyType *copies =
        tinker_span_copy(&type->properties, "properties", TINKER_SHAPE_THROUGH(TinkerPropertyType, id), arena, error);
    if (copies == NULL) return NULL;
    for (int32_t i = 0; i < type->properties.count; i++) {
        const TinkerPropertyType *own =
            (const void *)((const char *)type->properties.data + (gsize)i * (gsize)type->properties.stride);
        if (!TINKER_HAS(TinkerPropertyType, own, panel)) copies[i].panel = -1;
        if (copies[i].title == NULL) copies[i].title = copies[i].id;
        if (copies[i].group == NULL) copies[i].group = "";
        if (copies[i].description == NULL) copies[i].description = "";
    }
    return copies;
}

static gboolean check_quantity(const TinkerBlockClass *block_class, int32_t number, GError **error)
{
    const TinkerQuantityType *quantity = &block_class->quantities[number];
    g_autofree char *what = g_strdup_printf("the id of quantity %d", number);
    // "Mass 0.x,Spring 0.tension" picks columns: an id must not look like two.
    if (!tinker_check_id(quantity->id, what, ".,", error)) return FALSE;
    if (tinker_block_class_quantity(block_class, quantity->id) != number)
        return tinker_refuse(error, "two quantities have the id \"%s\"", quantity->id);
    return tinker_check_text(quantity->title, "the title of a quantity", FALSE, error) &&
           tinker_check_text(quantity->description, "the description of a quantity", FALSE, error);
}

static gboolean add_quantities(TinkerBlockClass *block_class, GPtrArray *arena, GError **error)
{
    TinkerQuantityType *copies = tinker_span_copy(&block_class->type->quantities, "quantities",
                                                  TINKER_SHAPE_THROUGH(TinkerQuantityType, id), arena, error);
    if (copies == NULL) return FALSE;
    block_class->quantities = copies;
    block_class->quantity_count = block_class->type->quantities.count;
    for (int32_t i = 0; i < block_class->quantity_count; i++) {
        if (!check_quantity(block_class, i, error)) return FALSE;
        if (copies[i].title == NULL) copies[i].title = copies[i].id;
        if (copies[i].description == NULL) copies[i].description = "";
    }
    return TRUE;
}

/* What stands in an equation is read where it is used (law/block-law.h): one that is wrong is no reason to refuse. */
static gboolean add_law(TinkerBlockClass *block_class, GPtrArray *arena, GError **error)
{
    TinkerLawEquation *copies = tinker_span_copy(&block_class->type->law, "equations of the law",
                                                 TINKER_SHAPE_THROUGH(TinkerLawEquation, is), arena, error);
    if (copies == NULL) return FALSE;
    block_class->law = copies;
    block_class->law_count = block_class->type->law.count;
    for (int32_t i = 0; i < block_class->law_count; i++) {
        if (!tinker_check_id(copies[i].symbol, "the symbol of an equation of its law", "", error) ||
            !tinker_check_text(copies[i].is, "an equation of its law", TRUE, error) ||
            !tinker_check_text(copies[i].means, "the meaning of an equation of its law", FALSE, error))
            return FALSE;
    }
    return TRUE;
}

static void number_columns(TinkerBlockClass *block_class, GPtrArray *arena)
{
    int32_t *first = tinker_arena_allocate(arena, (gsize)block_class->property_count * sizeof(int32_t));
    int32_t next = 0;
    for (int32_t i = 0; i < block_class->property_count; i++) {
        first[i] = next;
        next += tinker_kind_columns(block_class->properties[i].kind);
    }
    block_class->first_columns = first;
    block_class->column_count = next;
}

static void find_meanings(TinkerBlockClass *block_class)
{
    for (int32_t meaning = 0; meaning < TINKER_MEANING_COUNT; meaning++)
        block_class->meanings[meaning] = -1;
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const int32_t meaning = block_class->properties[i].meaning;
        if (meaning != TINKER_MEANING_NONE) block_class->meanings[meaning] = i;
    }
}

static gboolean build(TinkerBlockClass *block_class, TinkerBlockType *type, GPtrArray *arena, GError **error)
{
    if (!check_type(type, error)) return FALSE;
    block_class->properties = copy_properties(type, arena, error);
    if (block_class->properties == NULL) return FALSE;
    block_class->property_count = type->properties.count;
    if (!add_quantities(block_class, arena, error) || !add_law(block_class, arena, error)) return FALSE;
    if (!tinker_block_class_check_properties(block_class, error)) return FALSE;
    number_columns(block_class, arena);
    find_meanings(block_class);
    return tinker_block_class_add_interfaces(block_class, arena, error);
}

const TinkerBlockClass *tinker_block_class_build(TinkerBlockType *type, const TinkerPlugin *plugin, const char *path,
                                                 GPtrArray *arena, GError **error)
{
    TinkerBlockClass *block_class = tinker_arena_allocate(arena, sizeof *block_class);
    block_class->type = type;
    block_class->plugin = plugin;
    block_class->path = path;
    if (build(block_class, type, arena, error)) return block_class;
    g_prefix_error(error, "block type \"%s\": ", type->id);
    return NULL;
}

int32_t tinker_kind_columns(int32_t kind)
{
    static const int32_t columns[] = {
        [TINKER_KIND_REAL] = 1, [TINKER_KIND_INTEGER] = 1, [TINKER_KIND_SWITCH] = 1,   [TINKER_KIND_CHOICE] = 1,
        [TINKER_KIND_TEXT] = 0, [TINKER_KIND_VECTOR] = 2,  [TINKER_KIND_WAVEFORM] = 3,
    };
    return kind >= 0 && kind < (int32_t)G_N_ELEMENTS(columns) ? columns[kind] : 0;
}

int32_t tinker_block_class_meaning_column(const TinkerBlockClass *block_class, int32_t meaning)
{
    if (meaning <= TINKER_MEANING_NONE || meaning >= TINKER_MEANING_COUNT) return -1;
    const int32_t property = block_class->meanings[meaning];
    return property < 0 ? -1 : block_class->first_columns[property];
}

static const TinkerBody *body_of(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->physics != NULL ? block_class->physics->body : NULL;
}

gboolean tinker_block_class_moves(const TinkerBlockClass *block_class)
{
    const TinkerBody *body = body_of(block_class);
    return body != NULL && body->degrees_of_freedom > 0;
}

gboolean tinker_block_class_turns(const TinkerBlockClass *block_class)
{
    const TinkerBody *body = body_of(block_class);
    return body != NULL && body->degrees_of_freedom == 3;
}

gboolean tinker_block_class_stands(const TinkerBlockClass *block_class)
{
    const TinkerBody *body = body_of(block_class);
    return body != NULL && body->degrees_of_freedom == 0;
}

gboolean tinker_block_class_accepts(const TinkerBlockClass *block_class, const TinkerBlockClass *target)
{
    const uint32_t needed = tinker_block_class_moves(target)    ? TINKER_ACCEPTS_BODY
                            : tinker_block_class_stands(target) ? TINKER_ACCEPTS_SUPPORT
                                                                : 0;
    return (block_class->type->end_accepts & needed) != 0;
}

gboolean tinker_block_class_has_angle(const TinkerBlockClass *block_class)
{
    return tinker_block_class_turns(block_class) || tinker_block_class_stands(block_class);
}

gboolean tinker_block_class_speaks_of_angles(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    if (physics == NULL || physics->body != NULL) return FALSE;
    return (physics->constraint != NULL && physics->constraint->angles != 0) ||
           (physics->force_element != NULL && physics->force_element->angles != 0);
}

gboolean tinker_block_class_is_about_turning(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    if (physics == NULL || block_class->type->least_ends != 2 || block_class->type->most_ends != 2) return FALSE;
    return (physics->constraint != NULL && (physics->constraint->joint == 1 || physics->constraint->coincident != 0)) ||
           (physics->force_element != NULL && physics->force_element->torsion != NULL);
}

gboolean tinker_block_class_is_wound(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    if (physics == NULL || physics->body != NULL || physics->constraint == NULL) return FALSE;
    return physics->constraint->angles != 0 && physics->constraint->rows == 1 && block_class->type->least_ends == 2 &&
           block_class->type->most_ends == 2 && block_class->meanings[TINKER_MEANING_RADIUS] >= 0 &&
           block_class->meanings[TINKER_MEANING_LENGTH] >= 0;
}

gboolean tinker_block_class_strikes(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    return physics != NULL && physics->force_element != NULL && physics->force_element->next_blow != NULL;
}

gboolean tinker_block_class_is_shown_elsewhere(const TinkerBlockClass *block_class)
{
    for (int32_t i = 0; i < block_class->property_count; i++)
        if (block_class->properties[i].panel >= 0) return TRUE;
    return FALSE;
}

/* What the block says itself; NULL: nothing. */
static const char *chosen_unit(const TinkerBlockClass *block_class, const char *id, int english)
{
    const TinkerSpan *choices = block_class->units == NULL ? NULL : &block_class->units->choices;
    for (int32_t i = 0; choices != NULL && i < choices->count; i++) {
        const TinkerUnitChoice *choice = (const TinkerUnitChoice *)choices->data + i;
        const char *unit = english ? choice->english : choice->si;
        if (unit != NULL && strcmp(choice->id, id) == 0) return unit;
    }
    return NULL;
}

const char *tinker_block_class_unit(const TinkerBlockClass *block_class, const char *id, TinkerDimension dimension,
                                    int english)
{
    const char *chosen = chosen_unit(block_class, id, english);
    if (chosen != NULL) return chosen;
    return tinker_unit_for(dimension, english ? TINKER_UNIT_SYSTEM_ENGLISH : TINKER_UNIT_SYSTEM_SI);
}

const char *tinker_block_class_si_unit(const TinkerBlockClass *block_class, const char *id, TinkerDimension dimension)
{
    const char *chosen = chosen_unit(block_class, id, FALSE);
    TinkerUnit unit;
    const gboolean is_si =
        chosen != NULL && chosen[0] != '\0' && tinker_unit_parse(chosen, &unit, NULL) && unit.factor == 1;
    return is_si ? tinker_unit_in_ascii(chosen) : tinker_unit_si_symbol(dimension);
}
