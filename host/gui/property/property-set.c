/* Setting what a block's descriptor declares, from what was typed or chosen. A number out of its range is refused in
 * words; what others depend on goes along. */
#include <glib/gi18n.h>
#include <math.h>

#include "analysis/start/joined.h"
#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"
#include "law/typed-law.h"

static const TinkerPropertyType *type_of(const TinkerScene *scene, const TinkerPropertyRow *row)
{
    TinkerBlockId block = g_array_index(row->blocks, TinkerBlockId, 0);
    return &tinker_scene_block_class(scene, block)->properties[row->property];
}

static gboolean store(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t property,
                      const double *values, GError **error)
{
    GError *cause = NULL;
    if (tinker_history_set(history, block, property, values, &cause)) return TRUE;
    property_fail(error, cause, tinker_scene_block_name(scene, block), tinker_scene_block_class(scene, block));
    return FALSE;
}

/* What an edit is told. */
typedef struct {
    TinkerScene *scene;
    double value;
    const char *text;
} Entered;

/* The static coefficient of friction is never below the dynamic one: what was typed counts, and the other one follows
 * where it has to, so that the two can be typed in either order. */
static gboolean take_other_friction_along(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block,
                                          int32_t property, double value, GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    const int32_t fixed = block_class->meanings[TINKER_MEANING_STATIC_FRICTION];
    const int32_t sliding = block_class->meanings[TINKER_MEANING_DYNAMIC_FRICTION];
    if (fixed < 0 || sliding < 0 || (property != fixed && property != sliding)) return TRUE;
    const int32_t other = property == fixed ? sliding : fixed;
    const double present = tinker_scene_get(scene, block, block_class->first_columns[other]);
    if (isnan(present) || (property == fixed ? present <= value : present >= value)) return TRUE;
    return store(history, scene, block, other, &value, error);
}

static gboolean edit_number(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                            gconstpointer data, GError **error)
{
    const Entered *entered = data;
    const TinkerBlockClass *block_class = tinker_scene_block_class(entered->scene, block);
    double values[2] = {0, 0};
    int32_t first = block_class->first_columns[row->property];
    for (int32_t c = 0; c < tinker_kind_columns(block_class->properties[row->property].kind); c++)
        values[c] = c == row->component ? entered->value : tinker_scene_get(entered->scene, block, first + c);
    const TinkerPlacement before = tinker_placement_of(entered->scene, block);
    GError *cause = NULL;
    if (!take_other_friction_along(history, entered->scene, block, row->property, values[0], error) ||
        !store(history, entered->scene, block, row->property, values, error))
        return FALSE;
    if (tinker_joined_follow(history, entered->scene, &before, &cause)) return TRUE;
    property_fail(error, cause, tinker_scene_block_name(entered->scene, block), block_class);
    return FALSE;
}

/* Gives the rest lengths that were left to the drawing of the springs on a block, so that moving it stretches them. */
static gboolean hold_rest_lengths(TinkerHistory *history, TinkerScene *scene, TinkerBlockId moved, GError **error)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    for (int32_t i = 0; frame != NULL && i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (block_class == NULL || block_class->physics == NULL || block_class->physics->line_law == NULL) continue;
        int32_t length = block_class->meanings[TINKER_MEANING_LENGTH];
        gboolean on_it = FALSE;
        for (int32_t e = 0; e < tinker_scene_end_count(scene, block); e++)
            on_it = on_it || tinker_scene_end(scene, block, e).block == moved;
        if (!on_it || length < 0 || tinker_scene_property_given(scene, block, length)) continue;
        double value = tinker_frame_meaning(frame, block, TINKER_MEANING_LENGTH, 0, NAN);
        if (isfinite(value) && !store(history, scene, block, length, &value, error)) return FALSE;
    }
    return frame != NULL;
}

/* The origin is held where it is, since by default it goes with the block. */
static gboolean edit_offset(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                            gconstpointer data, GError **error)
{
    const Entered *entered = data;
    const TinkerBlockClass *block_class = tinker_scene_block_class(entered->scene, block);
    int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    double origin[2], place[2];
    for (int32_t c = 0; c < 2; c++) {
        origin[c] = tinker_scene_get(entered->scene, block, block_class->first_columns[row->property] + c);
        place[c] = tinker_scene_get(entered->scene, block, block_class->first_columns[position] + c);
    }
    place[row->component] = origin[row->component] + entered->value;
    return hold_rest_lengths(history, entered->scene, block, error) &&
           store(history, entered->scene, block, row->property, origin, error) &&
           store(history, entered->scene, block, position, place, error);
}

static gboolean edit_default(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                             gconstpointer data, GError **error)
{
    tinker_history_unset(history, block, row->property);
    return TRUE;
}

static gboolean edit_text(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block, gconstpointer data,
                          GError **error)
{
    tinker_history_set_text(history, block, row->property, data);
    return TRUE;
}

char *property_range_text(const TinkerPropertyType *type, const char *unit)
{
    g_autofree char *least = tinker_number_short(type->hard_minimum, unit, PROPERTY_DIGITS);
    g_autofree char *most = tinker_number_short(type->hard_maximum, unit, PROPERTY_DIGITS);
    g_autofree char *low =
        g_strdup_printf(type->flags & TINKER_OPEN_MINIMUM ? _("greater than %s") : _("at least %s"), least);
    g_autofree char *high =
        g_strdup_printf(type->flags & TINKER_OPEN_MAXIMUM ? _("less than %s") : _("at most %s"), most);
    gboolean has_low = type->flags & TINKER_HAS_MINIMUM, has_high = type->flags & TINKER_HAS_MAXIMUM;
    if (has_low && has_high) return g_strdup_printf(_("%s and %s"), low, high);
    return has_low ? g_steal_pointer(&low) : has_high ? g_steal_pointer(&high) : NULL;
}

static gboolean is_outside(const TinkerPropertyType *type, double value)
{
    gboolean below = type->flags & TINKER_OPEN_MINIMUM ? value <= type->hard_minimum : value < type->hard_minimum;
    gboolean above = type->flags & TINKER_OPEN_MAXIMUM ? value >= type->hard_maximum : value > type->hard_maximum;
    return ((type->flags & TINKER_HAS_MINIMUM) && below) || ((type->flags & TINKER_HAS_MAXIMUM) && above);
}

gboolean property_set_number(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    Entered entered = {.scene = tinker_document_scene(document)};
    if (!tinker_scene_has_block(entered.scene, g_array_index(row->blocks, TinkerBlockId, 0)))
        return property_refuse(error, _("The block is no longer there."));
    const TinkerPropertyType *type = type_of(entered.scene, row);
    const guint32 may_be_left_out =
        TINKER_DEFAULT_AS_PLACED | TINKER_DEFAULT_SAME_AS | TINKER_DEFAULT_AS_SHAPED | TINKER_DEFAULT_NONE;
    if (*text == '\0' && (type->flags & may_be_left_out))
        return property_edit_all(document, row, edit_default, NULL, error);
    if (!property_parse_number(text, type->dimension, row->unit, &entered.value, error)) return FALSE;
    if (is_outside(type, entered.value)) {
        g_autofree char *range = property_range_text(type, row->unit),
                        *given = tinker_number_short(entered.value, row->unit, PROPERTY_DIGITS);
        return property_refuse(error, _("“%s” must be %s (it is %s)."), row->title, range, given);
    }
    return property_edit_all(document, row, edit_number, &entered, error);
}

gboolean property_set_offset(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    static const TinkerDimension length = {0, 1, 0, 0};
    Entered entered = {.scene = tinker_document_scene(document)};
    return property_parse_number(text, length, row->unit, &entered.value, error) &&
           property_edit_all(document, row, edit_offset, &entered, error);
}

gboolean property_choose_number(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    Entered entered = {.scene = tinker_document_scene(document), .value = choice};
    return property_edit_all(document, row, edit_number, &entered, error);
}

gboolean property_set_text(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    return property_edit_all(document, row, edit_text, text, error);
}

gboolean property_set_law(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    GError *cause = NULL;
    if (!tinker_scene_has_block(scene, g_array_index(row->blocks, TinkerBlockId, 0)))
        return property_refuse(error, _("The block is no longer there."));
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, g_array_index(row->blocks, TinkerBlockId, 0));
    g_autoptr(TinkerExpression) law =
        text[0] != '\0' ? tinker_typed_parse(block_class, row->property, text, &cause) : NULL;
    if (cause == NULL) return property_set_text(document, row, text, error);
    property_fail(error, cause, NULL, NULL);
    return FALSE;
}
