/* Rows of what a block's descriptor declares: numbers, vectors component by component, texts, choices and switches.
 *
 * The local origin is shown as the offset of the block from it. Typing an offset moves the block; the origin stays. */
#include <glib/gi18n.h>
#include <math.h>

#include "analysis/start/joined.h"
#include "gui/property/property-rows.h"
#include "gui/text/block-words.h"
#include "gui/text/number-text.h"
#include "gui/text/translate.h"
#include "law/typed-law.h"
#include "scene/frame/frame-quantity.h"

static const TinkerPropertyType *type_of(const TinkerScene *scene, const TinkerPropertyRow *row)
{
    TinkerBlockId block = g_array_index(row->blocks, TinkerBlockId, 0);
    return &tinker_scene_block_class(scene, block)->properties[row->property];
}

/* The name --------------------------------------------------------------------------------------------------------- */

static gboolean rename_block(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                             gconstpointer name, GError **error)
{
    GError *cause = NULL;
    if (tinker_history_rename_block(history, block, name, &cause)) return TRUE;
    property_fail(error, cause, NULL, NULL);
    return FALSE;
}

static gboolean set_name(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    TinkerBlockId other = tinker_scene_find_block(tinker_document_scene(document), text);
    if (*text == '\0') return property_refuse(error, _("A block needs a name."));
    if (other != TINKER_NO_BLOCK && other != g_array_index(row->blocks, TinkerBlockId, 0))
        return property_refuse(error, _("Another block is called “%s” already."), text);
    return property_edit_all(document, row, rename_block, text, error);
}

void property_rows_add_name(PropertyBuilder *builder)
{
    TinkerPropertyRow *row = property_builder_add(builder, TINKER_ROW_TEXT, _("Appearance"), _("Name"),
                                                  _("What it is called; no two blocks have the same name."));
    property_row_take_text(row, g_strdup(tinker_scene_block_name(builder->scene, builder->blocks[0])));
    row->set = set_name;
    if (builder->block_class != NULL) return;
    row = property_builder_add(builder, TINKER_ROW_READING, _("Appearance"), _("Type"),
                               _("No installed plugin provides this type of block."));
    property_row_take_text(
        row, g_strdup_printf(_("%s (not installed)"), tinker_scene_block_type(builder->scene, builder->blocks[0])));
}

/* Values ----------------------------------------------------------------------------------------------------------- */

static double offset_of(const TinkerScene *scene, const TinkerBlockClass *block_class, TinkerBlockId block,
                        int32_t component)
{
    int32_t origin = tinker_block_class_meaning_column(block_class, TINKER_MEANING_LOCAL_ORIGIN);
    int32_t position = tinker_block_class_meaning_column(block_class, TINKER_MEANING_POSITION);
    return tinker_scene_get(scene, block, position + component) - tinker_scene_get(scene, block, origin + component);
}

static gboolean is_offset(const TinkerBlockClass *block_class, int32_t property)
{
    return block_class->meanings[TINKER_MEANING_LOCAL_ORIGIN] == property &&
           block_class->meanings[TINKER_MEANING_POSITION] >= 0;
}

/* What is shown of a block, SI; NAN where it is not known. */
static double value_of(const PropertyBuilder *builder, TinkerBlockId block, int32_t property, int32_t component)
{
    const TinkerBlockClass *block_class = builder->block_class;
    const TinkerPropertyType *type = &block_class->properties[property];
    TinkerFrame *frame = tinker_player_frame(builder->player);
    double value = NAN;
    if (is_offset(block_class, property)) return offset_of(builder->scene, block_class, block, component);
    if (type->flags & TINKER_DERIVED) {
        int32_t quantity = tinker_block_class_quantity(block_class, type->id);
        if (quantity < 0 || tinker_player_value(builder->player, block, quantity, &value)) return value;
        return frame != NULL && tinker_frame_quantity(frame, block, quantity, &value) ? value : NAN;
    }
    int32_t column = block_class->first_columns[property] + component;
    value = tinker_scene_get(builder->scene, block, column);
    return isnan(value) && frame != NULL ? tinker_frame_column(frame, block, column) : value;
}

static char *number_text(const PropertyBuilder *builder, const TinkerPropertyType *type, const char *unit, double value)
{
    if (isnan(value)) return g_strdup("");
    if (type->kind == TINKER_KIND_INTEGER) return g_strdup_printf("%.0f", value);
    return tinker_number_write(value, type->dimension, unit, builder->system, builder->trims);
}

/* Setting ---------------------------------------------------------------------------------------------------------- */

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

/* "greater than 0 kg", "from 0 to 1"; NULL where anything goes. (transfer full) */
static char *range_text(const TinkerPropertyType *type, const char *unit)
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

static gboolean set_number(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
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
        g_autofree char *range = range_text(type, row->unit),
                        *given = tinker_number_short(entered.value, row->unit, PROPERTY_DIGITS);
        return property_refuse(error, _("“%s” must be %s (it is %s)."), row->title, range, given);
    }
    return property_edit_all(document, row, edit_number, &entered, error);
}

static gboolean set_offset(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    static const TinkerDimension length = {0, 1, 0, 0};
    Entered entered = {.scene = tinker_document_scene(document)};
    return property_parse_number(text, length, row->unit, &entered.value, error) &&
           property_edit_all(document, row, edit_offset, &entered, error);
}

static gboolean choose_number(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    Entered entered = {.scene = tinker_document_scene(document), .value = choice};
    return property_edit_all(document, row, edit_number, &entered, error);
}

static gboolean set_text(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    return property_edit_all(document, row, edit_text, text, error);
}

/* One that cannot be read is not taken; its numbers may still be to come. */
static gboolean set_law(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    GError *cause = NULL;
    if (!tinker_scene_has_block(scene, g_array_index(row->blocks, TinkerBlockId, 0)))
        return property_refuse(error, _("The block is no longer there."));
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, g_array_index(row->blocks, TinkerBlockId, 0));
    g_autoptr(TinkerExpression) law =
        text[0] != '\0' ? tinker_typed_parse(block_class, row->property, text, &cause) : NULL;
    if (cause == NULL) return set_text(document, row, text, error);
    property_fail(error, cause, NULL, NULL);
    return FALSE;
}

/* Rows ------------------------------------------------------------------------------------------------------------- */

/* (transfer full) */
static char *default_text(const PropertyBuilder *builder, int32_t property, int32_t component, const char *unit)
{
    const TinkerPropertyType *type = &builder->block_class->properties[property];
    if (type->flags & (TINKER_DERIVED | TINKER_READ_ONLY) || is_offset(builder->block_class, property)) return NULL;
    if ((type->flags & TINKER_DEFAULT_AS_PLACED) != 0 && type->meaning == TINKER_MEANING_RADIUS)
        return g_strdup(_("That of what its first end is on, where nothing is entered."));
    if (type->flags & TINKER_DEFAULT_AS_PLACED) return g_strdup(_("As long as placed, where nothing is entered."));
    if (type->flags & TINKER_DEFAULT_AS_SHAPED) return g_strdup(_("As shaped, where nothing is entered."));
    if (type->flags & TINKER_DEFAULT_NONE) return g_strdup(_("None of its own, where nothing is entered."));
    if (type->flags & TINKER_DEFAULT_SAME_AS) {
        int32_t from = tinker_block_class_property(builder->block_class, type->default_from);
        const char *title =
            from >= 0 ? tinker_translate(builder->block_class->properties[from].title) : type->default_from;
        return g_strdup_printf(_("The same as “%s”, where nothing is entered."), title);
    }
    if (type->kind == TINKER_KIND_SWITCH || type->kind == TINKER_KIND_CHOICE) return NULL;
    g_autofree char *value = number_text(builder, type, unit, type->default_value[component]);
    return g_strdup_printf(_("Default: %s"), value);
}

/* Everything that is known about a property, a line each. (transfer full) */
static char *describe(const PropertyBuilder *builder, int32_t property, int32_t component, const char *unit)
{
    const TinkerPropertyType *type = &builder->block_class->properties[property];
    GString *text = g_string_new(tinker_translate(type->description));
    if (type->symbol != NULL) g_string_append_printf(text, _("\nSymbol: %s"), type->symbol);
    g_autofree char *range = range_text(type, unit), *by_default = default_text(builder, property, component, unit);
    if (range != NULL) g_string_append_printf(text, _("\nMust be %s"), range);
    if (by_default != NULL) g_string_append_printf(text, "\n%s", by_default);
    return g_string_free(text, FALSE);
}

/* Where something else is shown, the offset, it must not. */
static gboolean needs_title(const PropertyBuilder *builder, int32_t property, int32_t component)
{
    return !is_offset(builder->block_class, property) &&
           tinker_component_needs_title(&builder->block_class->properties[property], component);
}

/* The label of a row, and what it is sorted by. (transfer full) */
static char *title_of(const PropertyBuilder *builder, int32_t property, int32_t component, const char **sorted_by)
{
    const TinkerPropertyType *type = &builder->block_class->properties[property];
    const char *title = tinker_translate(type->title);
    const char *label = type->kind == TINKER_KIND_VECTOR ? type->component_titles[component] : NULL;
    *sorted_by = NULL;
    if (label == NULL) return g_strdup(title);
    if (!needs_title(builder, property, component)) return g_strdup(tinker_translate(label));
    *sorted_by = title;
    return g_strdup_printf("%s %s", title, tinker_translate(label));
}

static TinkerPropertyRow *add_row(PropertyBuilder *builder, int32_t property, int32_t component, TinkerRowKind kind)
{
    const TinkerPropertyType *type = &builder->block_class->properties[property];
    const char *unit = tinker_block_class_unit(builder->block_class, type->id, type->dimension,
                                               builder->system == TINKER_UNIT_SYSTEM_ENGLISH);
    g_autofree char *description = kind == TINKER_ROW_TEXT ? g_strdup(tinker_translate(type->description))
                                                           : describe(builder, property, component, unit);
    const char *sorted_by;
    g_autofree char *title = title_of(builder, property, component, &sorted_by);
    TinkerPropertyRow *row = property_builder_add(builder, kind, property_group_of(builder, type), title, description);
    if (sorted_by != NULL) property_row_sort_by(row, sorted_by);
    row->property = property;
    row->component = component;
    row->unit = unit;
    row->given = tinker_scene_property_given(builder->scene, builder->blocks[0], property);
    return row;
}

/* "stiffness", "velocity.x"; NULL where it is not of the selected block alone, or not set. (transfer full) */
static char *control_name(const PropertyBuilder *builder, const TinkerPropertyRow *row)
{
    const TinkerPropertyType *type = &builder->block_class->properties[row->property];
    if (!row->sensitive || row->set != set_number || builder->count != 1 ||
        tinker_document_selected(builder->document) != builder->blocks[0])
        return NULL;
    return type->kind == TINKER_KIND_VECTOR ? g_strdup_printf("%s.%c", type->id, "xy"[row->component])
                                            : g_strdup(type->id);
}

static void add_number(PropertyBuilder *builder, int32_t property, int32_t component)
{
    const TinkerPropertyType *type = &builder->block_class->properties[property];
    TinkerPropertyRow *row = add_row(builder, property, component, TINKER_ROW_NUMBER);
    double first = value_of(builder, builder->blocks[0], property, component);
    property_row_take_text(row, number_text(builder, type, row->unit, first));
    for (int i = 1; i < builder->count && !row->mixed; i++) {
        double value = value_of(builder, builder->blocks[i], property, component);
        if (value == first) continue; /* thousands may be selected */
        g_autofree char *text = number_text(builder, type, row->unit, value);
        row->mixed = !g_str_equal(text, row->text);
    }
    if (row->mixed) property_row_take_text(row, g_strdup(""));
    row->sensitive = !(type->flags & (TINKER_READ_ONLY | TINKER_DERIVED)) &&
                     !property_plays_no_part(builder->scene, builder->blocks[0], property);
    row->set = is_offset(builder->block_class, property) ? set_offset : set_number;
    row->control = control_name(builder, row);
}

static void add_choice(PropertyBuilder *builder, int32_t property, TinkerRowKind kind)
{
    const TinkerPropertyType *type = &builder->block_class->properties[property];
    TinkerPropertyRow *row = add_row(builder, property, 0, kind);
    int32_t column = builder->block_class->first_columns[property];
    row->chosen = (int)tinker_scene_get(builder->scene, builder->blocks[0], column);
    for (int i = 1; i < builder->count && !row->mixed; i++)
        row->mixed = (int)tinker_scene_get(builder->scene, builder->blocks[i], column) != row->chosen;
    if (row->mixed) row->chosen = -1;
    if (kind == TINKER_ROW_CHOICE) {
        row->choices = g_new0(char *, (gsize)type->choice_count + 1);
        for (int32_t i = 0; i < type->choice_count; i++)
            row->choices[i] = g_strdup(tinker_translate(type->choices[i]));
    }
    row->sensitive = !(type->flags & (TINKER_READ_ONLY | TINKER_DERIVED));
    row->choose = choose_number;
}

static void add_text(PropertyBuilder *builder, int32_t property)
{
    TinkerPropertyRow *row = add_row(builder, property, 0, TINKER_ROW_TEXT);
    property_row_take_text(row, g_strdup(tinker_scene_get_text(builder->scene, builder->blocks[0], property)));
    for (int i = 1; i < builder->count && !row->mixed; i++)
        row->mixed = !g_str_equal(tinker_scene_get_text(builder->scene, builder->blocks[i], property), row->text);
    if (row->mixed) property_row_take_text(row, g_strdup(""));
    row->sensitive = !(builder->block_class->properties[property].flags & TINKER_READ_ONLY);
    row->is_law = (builder->block_class->properties[property].flags & TINKER_TEXT_LAW) != 0;
    row->set = row->is_law ? set_law : set_text;
}

void property_rows_add_property(PropertyBuilder *builder, int32_t property)
{
    switch (builder->block_class->properties[property].kind) {
    case TINKER_KIND_TEXT:
        add_text(builder, property);
        break;
    case TINKER_KIND_SWITCH:
        add_choice(builder, property, TINKER_ROW_SWITCH);
        break;
    case TINKER_KIND_CHOICE:
        add_choice(builder, property, TINKER_ROW_CHOICE);
        break;
    case TINKER_KIND_WAVEFORM:
        property_rows_add_waveform(builder, property);
        break;
    case TINKER_KIND_VECTOR:
        add_number(builder, property, 0);
        add_number(builder, property, 1);
        break;
    default:
        add_number(builder, property, 0);
        break;
    }
}
