/* Rows of a function of time: its type, and the text of an expression. (Those of a table: property-rows-table.c.)
 *
 * A type of block that would show its waveform here, but of which none is attached yet, has the row Type alone:
 * choosing one adds the block. */
#include <glib/gi18n.h>

#include "gui/property/property-rows.h"
#include "gui/text/translate.h"

enum { CHOICE_NONE, CHOICE_SINE, CHOICE_COSINE, CHOICE_EXPRESSION, CHOICE_TABLE };

/* In the order of the choices. */
static const TinkerWaveformKind kinds[] = {TINKER_WAVEFORM_NONE, TINKER_WAVEFORM_SINE, TINKER_WAVEFORM_COSINE,
                                           TINKER_WAVEFORM_EXPRESSION, TINKER_WAVEFORM_TABLE};

static gboolean is_harmonic(TinkerWaveformKind kind)
{
    return kind == TINKER_WAVEFORM_SINE || kind == TINKER_WAVEFORM_COSINE;
}

static gboolean uses(const TinkerPropertyType *waveform, const char *id)
{
    return g_strcmp0(waveform->amplitude, id) == 0 || g_strcmp0(waveform->frequency, id) == 0 ||
           g_strcmp0(waveform->phase, id) == 0;
}

gboolean property_plays_no_part(const TinkerScene *scene, TinkerBlockId block, int32_t property)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    gboolean used = FALSE;
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *type = &block_class->properties[i];
        if (type->kind != TINKER_KIND_WAVEFORM || !uses(type, block_class->properties[property].id)) continue;
        if (is_harmonic(tinker_waveform_kind(tinker_scene_get_waveform(scene, block, i)))) return FALSE;
        used = TRUE;
    }
    return used;
}

/* Setting ---------------------------------------------------------------------------------------------------------- */

static gboolean choose_type(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    if (choice >= CHOICE_TABLE)
        return property_refuse(error, _("A table is read from a file that the scene’s own file names."));
    g_autoptr(TinkerWaveform) waveform =
        choice == CHOICE_EXPRESSION ? NULL : tinker_waveform_new_harmonic(kinds[choice]);
    return property_set_waveform(document, row, waveform, error);
}

static gboolean set_expression(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    GError *cause = NULL;
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(text, &cause);
    if (waveform == NULL) {
        property_fail(error, cause, NULL, NULL);
        return FALSE;
    }
    return property_set_waveform(document, row, waveform, error);
}

/* Rows ------------------------------------------------------------------------------------------------------------- */

/* A table that there is can be kept, and a file be chosen for another one. */
static TinkerPropertyRow *add_type(PropertyBuilder *builder, const TinkerPropertyType *type, int32_t property,
                                   gboolean with_table)
{
    static const char *const titles[] = {N_("None"), N_("Sine"), N_("Cosine"), N_("Expression"), N_("Table")};
    int count = with_table ? CHOICE_TABLE + 1 : CHOICE_TABLE;
    TinkerPropertyRow *row = property_builder_add(builder, TINKER_ROW_CHOICE, property_group_of(builder, type),
                                                  tinker_translate(type->title), tinker_translate(type->description));
    row->choices = g_new0(char *, G_N_ELEMENTS(titles) + 2);
    for (int i = 0; i < count; i++)
        row->choices[i] = g_strdup(_(titles[i]));
    row->choices[count] = g_strdup(with_table ? _("Another Table…") : _("Table…"));
    row->file_choice = count;
    row->property = property;
    row->choose = choose_type;
    return row;
}

static void add_expression(PropertyBuilder *builder, const TinkerPropertyType *type, int32_t property)
{
    TinkerWaveform *first = tinker_scene_get_waveform(builder->scene, builder->blocks[0], property);
    g_autofree char *description =
        g_strdup_printf(_("A function of t (s), as in 0.1*sin(2*pi*t). Its value is in %s."),
                        *tinker_unit_si_symbol(type->dimension) != '\0' ? tinker_unit_si_symbol(type->dimension) : "1");
    TinkerPropertyRow *row =
        property_builder_add(builder, TINKER_ROW_TEXT, property_group_of(builder, type), _("Expression"), description);
    property_row_take_text(row, g_strdup(tinker_waveform_expression(first)));
    for (int i = 1; i < builder->count && !row->mixed; i++) {
        TinkerWaveform *waveform = tinker_scene_get_waveform(builder->scene, builder->blocks[i], property);
        row->mixed = g_strcmp0(tinker_waveform_expression(waveform), row->text) != 0;
    }
    if (row->mixed) property_row_take_text(row, g_strdup(""));
    row->property = property;
    row->set = set_expression;
}

static int choice_of(const PropertyBuilder *builder, int block, int32_t property)
{
    TinkerWaveformKind kind =
        tinker_waveform_kind(tinker_scene_get_waveform(builder->scene, builder->blocks[block], property));
    int choice = 0;
    while (kinds[choice] != kind)
        choice++;
    return choice;
}

void property_rows_add_waveform(PropertyBuilder *builder, int32_t property)
{
    const TinkerPropertyType *type = &builder->block_class->properties[property];
    int chosen = choice_of(builder, 0, property);
    gboolean mixed = FALSE;
    for (int i = 1; i < builder->count && !mixed; i++)
        mixed = choice_of(builder, i, property) != chosen;
    TinkerPropertyRow *row = add_type(builder, type, property, !mixed && chosen == CHOICE_TABLE);
    row->chosen = mixed ? -1 : chosen;
    row->mixed = mixed;
    row->given = tinker_scene_property_given(builder->scene, builder->blocks[0], property);
    if (!mixed && chosen == CHOICE_EXPRESSION) add_expression(builder, type, property);
    if (!mixed && chosen == CHOICE_TABLE) property_rows_add_table(builder, type, property);
}

void property_rows_add_missing_waveform(PropertyBuilder *builder, const TinkerBlockClass *block_class, int32_t property)
{
    TinkerPropertyRow *row = add_type(builder, &block_class->properties[property], property, FALSE);
    row->chosen = CHOICE_NONE;
    row->given = FALSE;
    row->data = block_class;
}
