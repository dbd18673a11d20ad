/* Rows of what a block's descriptor declares: numbers, vectors component by component, texts, choices and switches.
 *
 * The local origin is shown as the offset of the block from it. Typing an offset moves the block; the origin stays. */
#include <glib/gi18n.h>
#include <math.h>

#include "gui/property/property-rows.h"
#include "gui/text/block-words.h"
#include "gui/text/number-text.h"
#include "gui/text/translate.h"
#include "scene/frame/frame-quantity.h"

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
    g_autofree char *range = property_range_text(type, unit),
                    *by_default = default_text(builder, property, component, unit);
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
    if (!row->sensitive || row->set != property_set_number || builder->count != 1 ||
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
    row->set = is_offset(builder->block_class, property) ? property_set_offset : property_set_number;
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
    row->choose = property_choose_number;
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
    row->set = row->is_law ? property_set_law : property_set_text;
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
