/* Checks of a block type's properties, so that the rest of the core can rely on them. */
#include <math.h>
#include <string.h>
#include <tinker/typed-law.h>

#include "plugin/descriptor/class-build.h"
#include "plugin/descriptor/text-check.h"
#include "plugin/trust/refuse.h"
#include "units/quantity/units.h"

#define MOST_CHOICES 1000

/* What a property that carries a meaning has to be. */
typedef struct {
    const char *name;
    int32_t kind;
    TinkerDimension dimension;
} Meaning;

static const Meaning meanings[TINKER_MEANING_COUNT] = {
    [TINKER_MEANING_POSITION] = {"the position", TINKER_KIND_VECTOR, {0, 1, 0, 0}},
    [TINKER_MEANING_VELOCITY] = {"the velocity", TINKER_KIND_VECTOR, {0, 1, -1, 0}},
    [TINKER_MEANING_ORIENTATION] = {"the orientation", TINKER_KIND_REAL, {0, 0, 0, 1}},
    [TINKER_MEANING_MASS] = {"the mass", TINKER_KIND_REAL, {1, 0, 0, 0}},
    [TINKER_MEANING_INERTIA] = {"the inertia", TINKER_KIND_REAL, {1, 2, 0, 0}},
    [TINKER_MEANING_ANGULAR_VELOCITY] = {"the angular velocity", TINKER_KIND_REAL, {0, 0, -1, 1}},
    [TINKER_MEANING_LOCAL_ORIGIN] = {"the local origin", TINKER_KIND_VECTOR, {0, 1, 0, 0}},
    [TINKER_MEANING_WIDTH] = {"the width", TINKER_KIND_REAL, {0, 1, 0, 0}},
    [TINKER_MEANING_HEIGHT] = {"the height", TINKER_KIND_REAL, {0, 1, 0, 0}},
    [TINKER_MEANING_SOLID] = {"the solidity", TINKER_KIND_SWITCH, {0, 0, 0, 0}},
    [TINKER_MEANING_STATIC_FRICTION] = {"the static friction", TINKER_KIND_REAL, {0, 0, 0, 0}},
    [TINKER_MEANING_DYNAMIC_FRICTION] = {"the dynamic friction", TINKER_KIND_REAL, {0, 0, 0, 0}},
    [TINKER_MEANING_RESTITUTION] = {"the restitution", TINKER_KIND_REAL, {0, 0, 0, 0}},
    [TINKER_MEANING_LENGTH] = {"the length", TINKER_KIND_REAL, {0, 1, 0, 0}},
    [TINKER_MEANING_RADIUS] = {"the radius", TINKER_KIND_REAL, {0, 1, 0, 0}},
    [TINKER_MEANING_CENTRE_OF_MASS] = {"the centre of mass", TINKER_KIND_VECTOR, {0, 1, 0, 0}},
    [TINKER_MEANING_INSTANT] = {"the instant", TINKER_KIND_REAL, {0, 0, 1, 0}},
    [TINKER_MEANING_ROLLING_RESISTANCE] = {"the rolling resistance", TINKER_KIND_REAL, {0, 1, 0, 0}},
    [TINKER_MEANING_COLLIDES] = {"whether it collides", TINKER_KIND_SWITCH, {0, 0, 0, 0}},
};

static const char *const kind_names[] = {"real", "integer", "switch", "choice", "text", "vector", "waveform"};

static gboolean check_texts(const TinkerPropertyType *property, GError **error)
{
    return tinker_check_text(property->title, "its title", FALSE, error) &&
           tinker_check_text(property->group, "its group", FALSE, error) &&
           tinker_check_text(property->symbol, "its symbol", FALSE, error) &&
           tinker_check_text(property->description, "its description", FALSE, error) &&
           tinker_check_text(property->component_titles[0], "its first component's title", FALSE, error) &&
           tinker_check_text(property->component_titles[1], "its second component's title", FALSE, error) &&
           tinker_check_text(property->default_text, "its default text", FALSE, error);
}

static gboolean check_codes(const TinkerBlockClass *block_class, const TinkerPropertyType *property, GError **error)
{
    if (property->kind < 0 || property->kind >= (int32_t)G_N_ELEMENTS(kind_names))
        return tinker_refuse(error, "its kind is %d, 0 to %d was expected", property->kind,
                             (int)G_N_ELEMENTS(kind_names) - 1);
    if (property->variability < TINKER_STRUCTURAL || property->variability > TINKER_TUNABLE)
        return tinker_refuse(error, "its variability is %d, %d to %d was expected", property->variability,
                             TINKER_STRUCTURAL, TINKER_TUNABLE);
    const int32_t most_ends = block_class->type->most_ends;
    if (property->panel < -1 || (most_ends != -1 && property->panel >= most_ends))
        return tinker_refuse(error,
                             "its panel is that of end %d, but the block has at most %d ends (-1: its own panel)",
                             property->panel, most_ends);
    return TRUE;
}

static gboolean check_meaning(const TinkerBlockClass *block_class, int32_t number, GError **error)
{
    const TinkerPropertyType *property = &block_class->properties[number];
    if (property->meaning < 0 || property->meaning >= TINKER_MEANING_COUNT)
        return tinker_refuse(error, "its meaning is %d, 0 to %d was expected", property->meaning,
                             TINKER_MEANING_COUNT - 1);
    if (property->meaning == TINKER_MEANING_NONE) return TRUE;
    const Meaning *meaning = &meanings[property->meaning];
    for (int32_t i = 0; i < number; i++) {
        if (block_class->properties[i].meaning == property->meaning)
            return tinker_refuse(error, "it means %s, and so does \"%s\"; one property may", meaning->name,
                                 block_class->properties[i].id);
    }
    if (property->kind != meaning->kind)
        return tinker_refuse(error, "it means %s and is of kind %s, %s was expected", meaning->name,
                             kind_names[property->kind], kind_names[meaning->kind]);
    if (!tinker_dimension_equal(property->dimension, meaning->dimension))
        return tinker_refuse(error, "it means %s and has the unit \"%s\", \"%s\" was expected", meaning->name,
                             tinker_unit_si_symbol(property->dimension), tinker_unit_si_symbol(meaning->dimension));
    return TRUE;
}

static gboolean check_choices(const TinkerPropertyType *property, GError **error)
{
    if (property->choice_count < 0 || property->choice_count > MOST_CHOICES)
        return tinker_refuse(error, "it has %d choices, 0 to %d was expected", property->choice_count, MOST_CHOICES);
    const gboolean formula = (property->flags & TINKER_TEXT_LAW) != 0;
    if ((property->flags & (TINKER_TEXT_LAW | TINKER_TEXT_QUANTITY | TINKER_TEXT_POINTS)) != 0 &&
        property->kind != TINKER_KIND_TEXT)
        return tinker_refuse(
            error, "it is a formula, a number with any unit or a list of points and of kind %s, text was expected",
            kind_names[property->kind]);
    if (formula && property->choice_count > TINKER_TYPED_MOST_ARGUMENTS)
        return tinker_refuse(error, "it is a formula of %d arguments, at most %d were expected", property->choice_count,
                             TINKER_TYPED_MOST_ARGUMENTS);
    for (int32_t i = 0; formula && i < property->choice_count; i++)
        if (property->choices == NULL || property->choices[i] == NULL)
            return tinker_refuse(error, "it is a formula whose argument %d has no name", i + 1);
    if (property->kind != TINKER_KIND_CHOICE) return TRUE;
    if (property->choice_count == 0 || property->choices == NULL)
        return tinker_refuse(error, "it is a choice without choices");
    for (int32_t i = 0; i < property->choice_count; i++) {
        if (!tinker_check_id(property->choices[i], "a choice", "", error)) return FALSE;
        for (int32_t earlier = 0; earlier < i; earlier++) {
            if (strcmp(property->choices[earlier], property->choices[i]) == 0)
                return tinker_refuse(error, "the choice \"%s\" appears twice", property->choices[i]);
        }
    }
    const double value = property->default_value[0];
    if (!(value >= 0 && value < property->choice_count) || value != floor(value))
        return tinker_refuse(error, "its default is choice %g, a whole number from 0 to %d was expected", value,
                             property->choice_count - 1);
    return TRUE;
}

static gboolean check_limits(const TinkerPropertyType *property, GError **error)
{
    const gboolean has_minimum = (property->flags & TINKER_HAS_MINIMUM) != 0;
    const gboolean has_maximum = (property->flags & TINKER_HAS_MAXIMUM) != 0;
    if ((has_minimum && isnan(property->hard_minimum)) || (has_maximum && isnan(property->hard_maximum)))
        return tinker_refuse(error, "a bound of its range is not a number");
    if (has_minimum && has_maximum && property->hard_minimum > property->hard_maximum)
        return tinker_refuse(error, "its minimum %g is above its maximum %g", property->hard_minimum,
                             property->hard_maximum);
    if ((property->flags & TINKER_HAS_SOFT_RANGE) != 0 && !(property->soft_minimum < property->soft_maximum))
        return tinker_refuse(error, "its soft minimum %g is not below its soft maximum %g", property->soft_minimum,
                             property->soft_maximum);
    return TRUE;
}

static gboolean within_limits(const TinkerPropertyType *property, double value)
{
    const guint32 flags = property->flags;
    if ((flags & TINKER_HAS_MINIMUM) != 0 &&
        (value < property->hard_minimum || ((flags & TINKER_OPEN_MINIMUM) != 0 && value == property->hard_minimum)))
        return FALSE;
    return (flags & TINKER_HAS_MAXIMUM) == 0 || value < property->hard_maximum ||
           (value == property->hard_maximum && (flags & TINKER_OPEN_MAXIMUM) == 0);
}

static gboolean check_default(const TinkerPropertyType *property, GError **error)
{
    const int components = property->kind == TINKER_KIND_VECTOR ? 2 : 1;
    // A default that is never used as a value need not be one.
    const guint32 elsewhere = TINKER_DERIVED | TINKER_READ_ONLY | TINKER_DEFAULT_AS_PLACED | TINKER_DEFAULT_SAME_AS |
                              TINKER_DEFAULT_AS_SHAPED | TINKER_DEFAULT_NONE;
    for (int i = 0; i < components; i++) {
        const double value = property->default_value[i];
        if (!isfinite(value)) return tinker_refuse(error, "its default is not a finite number");
        const gboolean bounded = property->kind == TINKER_KIND_REAL || property->kind == TINKER_KIND_INTEGER ||
                                 property->kind == TINKER_KIND_VECTOR;
        if (bounded && (property->flags & elsewhere) == 0 && !within_limits(property, value))
            return tinker_refuse(error, "its default %g lies outside its own range", value);
    }
    const double value = property->default_value[0];
    if (property->kind == TINKER_KIND_INTEGER && value != floor(value))
        return tinker_refuse(error, "its default is %g, a whole number was expected", value);
    if (property->kind == TINKER_KIND_SWITCH && value != 0 && value != 1)
        return tinker_refuse(error, "its default is %g, 0 or 1 was expected", value);
    return TRUE;
}

static gboolean check_scaling(const TinkerBlockClass *block_class, const char *role, const char *id, GError **error)
{
    if (id == NULL) return TRUE;
    g_autofree char *what = g_strdup_printf("the name of its %s", role);
    if (!tinker_check_id(id, what, "", error)) return FALSE;
    const int32_t number = tinker_block_class_property(block_class, id);
    if (number < 0) return tinker_refuse(error, "its %s is \"%s\", which is no property of the block", role, id);
    if (block_class->properties[number].kind != TINKER_KIND_REAL)
        return tinker_refuse(error, "its %s \"%s\" is not a real number", role, id);
    return TRUE;
}

static gboolean check_waveform(const TinkerBlockClass *block_class, const TinkerPropertyType *property, GError **error)
{
    static const char *const waveforms[] = {"none", "sine", "cosine", NULL};
    if (property->kind != TINKER_KIND_WAVEFORM) return TRUE;
    if (property->default_text != NULL && !g_strv_contains(waveforms, property->default_text))
        return tinker_refuse(error, "its default is the waveform \"%s\", one of none, sine, cosine was expected",
                             property->default_text);
    return check_scaling(block_class, "amplitude", property->amplitude, error) &&
           check_scaling(block_class, "frequency", property->frequency, error) &&
           check_scaling(block_class, "phase", property->phase, error);
}

static gboolean check_same_as(const TinkerBlockClass *block_class, int32_t number, GError **error)
{
    const TinkerPropertyType *property = &block_class->properties[number];
    if ((property->flags & TINKER_DEFAULT_SAME_AS) == 0) return TRUE;
    if (!tinker_check_id(property->default_from, "the name of the property it defaults to", "", error)) return FALSE;
    const int32_t source = tinker_block_class_property(block_class, property->default_from);
    if (source < 0)
        return tinker_refuse(error, "it defaults to \"%s\", which is no property of the block", property->default_from);
    const TinkerPropertyType *other = &block_class->properties[source];
    if (other->kind != property->kind || !tinker_dimension_equal(other->dimension, property->dimension))
        return tinker_refuse(error, "it defaults to \"%s\", which has another kind or unit", other->id);
    // One link suffices and cannot run in a circle.
    if ((other->flags & TINKER_DEFAULT_SAME_AS) != 0)
        return tinker_refuse(error, "it defaults to \"%s\", which itself defaults to another property", other->id);
    return TRUE;
}

static gboolean check_sources(const TinkerBlockClass *block_class, int32_t number, GError **error)
{
    const TinkerPropertyType *property = &block_class->properties[number];
    const TinkerBlockType *type = block_class->type;
    if ((property->flags & TINKER_DERIVED) != 0 && tinker_block_class_quantity(block_class, property->id) < 0)
        return tinker_refuse(error, "it is derived, but the block has no quantity of this id");
    if ((property->flags & TINKER_DEFAULT_AS_PLACED) != 0 && type->least_ends < 2)
        return tinker_refuse(error,
                             "it defaults to the length from end to end, but the block may have %d (at least 2 ends "
                             "are needed)",
                             type->least_ends);
    if ((property->flags & TINKER_DEFAULT_NONE) != 0 && property->kind != TINKER_KIND_REAL)
        return tinker_refuse(error, "it may be left without a value and is of kind %s, real was expected",
                             kind_names[property->kind]);
    return check_same_as(block_class, number, error);
}

static gboolean check_property(const TinkerBlockClass *block_class, int32_t number, GError **error)
{
    const TinkerPropertyType *property = &block_class->properties[number];
    return check_texts(property, error) && check_codes(block_class, property, error) &&
           check_meaning(block_class, number, error) && check_choices(property, error) &&
           check_limits(property, error) && check_default(property, error) &&
           check_waveform(block_class, property, error) && check_sources(block_class, number, error);
}

gboolean tinker_block_class_check_properties(const TinkerBlockClass *block_class, GError **error)
{
    static const char *const own_keys[] = {"type", "name", "ends", NULL};
    // Ids first: the other checks look properties up by them.
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const char *id = block_class->properties[i].id;
        g_autofree char *what = g_strdup_printf("the id of property %d", i);
        if (!tinker_check_id(id, what, ".,", error)) return FALSE;
        if (tinker_block_class_property(block_class, id) != i)
            return tinker_refuse(error, "two properties have the id \"%s\"", id);
        if (g_strv_contains(own_keys, id))
            return tinker_refuse(error, "a property has the id \"%s\", which is a key of every block in a scene", id);
    }
    for (int32_t i = 0; i < block_class->property_count; i++) {
        if (!check_property(block_class, i, error)) {
            g_prefix_error(error, "property \"%s\": ", block_class->properties[i].id);
            return FALSE;
        }
    }
    return TRUE;
}
