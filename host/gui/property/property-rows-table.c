/* Rows of a waveform that is a table: its file, and how that is read. Each change reads the file again. */
#include <glib/gi18n.h>
#include <glib/gstdio.h>
#include <math.h>

#include "gui/document/carry-tables.h"
#include "gui/property/property-rows.h"
#include "scene/value/table-source.h"

/* The waveform of the blocks, where all have the same; else NULL. */
static TinkerWaveform *common_waveform(TinkerScene *scene, const TinkerBlockId *blocks, int count, int32_t property)
{
    TinkerWaveform *first = tinker_scene_get_waveform(scene, blocks[0], property);
    for (int i = 1; i < count; i++)
        if (tinker_scene_get_waveform(scene, blocks[i], property) != first) return NULL;
    return first;
}

/* Reading ---------------------------------------------------------------------------------------------------------- */

static const TinkerPropertyType *type_of(TinkerScene *scene, const TinkerPropertyRow *row)
{
    const TinkerBlockClass *block_class = row->data;
    if (block_class == NULL)
        block_class = tinker_scene_block_class(scene, g_array_index(row->blocks, TinkerBlockId, 0));
    return &block_class->properties[row->property];
}

/* As the table that the row has is read, where it has one; `former` is that one, or NULL. Without a file. */
static TinkerTableSource present_source(TinkerScene *scene, const TinkerPropertyRow *row, TinkerWaveform **former)
{
    TinkerTableFacts facts = {.column = 0};
    *former = NULL;
    if (row->data == NULL)
        *former = common_waveform(scene, (const TinkerBlockId *)(void *)row->blocks->data, (int)row->blocks->len,
                                  row->property);
    if (*former != NULL && (!tinker_waveform_table_facts(*former, &facts) || facts.column == 0)) *former = NULL;
    if (*former == NULL) return (TinkerTableSource){.column = 1, .scale = 1, .kind = TINKER_TABLE_VALUE};
    return (TinkerTableSource){.column = facts.column, .scale = facts.scale, .kind = facts.kind};
}

static gboolean fail(GError **error, GError *cause)
{
    property_fail(error, cause, NULL, NULL);
    return FALSE;
}

/* Whether there is a folder for tables, and what is to be set. */
static gboolean check_target(TinkerDocument *document, const TinkerPropertyRow *row, const char *scene_path,
                             GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    for (guint i = 0; i < row->blocks->len; i++)
        if (!tinker_scene_has_block(scene, g_array_index(row->blocks, TinkerBlockId, i)))
            return property_refuse(error, _("The block is no longer there."));
    if (scene_path != NULL) return TRUE;
    return property_refuse(error, _("Save the scene first: a table is read from its folder."));
}

static gboolean read_table(TinkerDocument *document, const TinkerPropertyRow *row, const TinkerTableSource *source,
                           TinkerWaveform *former, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    GError *cause = NULL;
    g_autoptr(TinkerWaveform) waveform =
        tinker_scene_read_table(scene, tinker_document_base(document), source, type_of(scene, row), former, &cause);
    return waveform != NULL ? property_set_waveform(document, row, waveform, error) : fail(error, cause);
}

/* Files ------------------------------------------------------------------------------------------------------------ */

gboolean tinker_property_row_check_file(TinkerDocument *document, const TinkerPropertyRow *row, const char *path,
                                        char **copy, GError **error)
{
    const char *scene_path = tinker_document_path(document);
    TinkerWaveform *former;
    GError *cause = NULL;
    *copy = NULL;
    if (!check_target(document, row, scene_path, error)) return FALSE;
    TinkerTableSource source = present_source(tinker_document_scene(document), row, &former);
    g_autoptr(TinkerWaveform) waveform =
        tinker_waveform_new_table_file(path, source.column, source.scale, source.kind, &cause);
    if (waveform == NULL) return fail(error, cause);
    g_autofree char *name = table_name_in_scene(scene_path, path);
    if (name == NULL) *copy = table_name_of_copy(scene_path, path);
    return TRUE;
}

gboolean tinker_property_row_choose_file(TinkerDocument *document, const TinkerPropertyRow *row, const char *path,
                                         GError **error)
{
    const char *scene_path = tinker_document_path(document);
    TinkerWaveform *former;
    gboolean made = FALSE;
    g_autofree char *name = NULL;
    if (!tinker_property_row_check_file(document, row, path, &name, error)) return FALSE;
    if (name == NULL)
        name = table_name_in_scene(scene_path, path);
    else if (!table_copy_beside(scene_path, path, name, &made, error))
        return FALSE;
    TinkerTableSource source = present_source(tinker_document_scene(document), row, &former);
    source.file = name;
    if (read_table(document, row, &source, former, error)) return TRUE;
    g_autofree char *folder = g_path_get_dirname(scene_path), *target = g_build_filename(folder, name, NULL);
    if (made) g_unlink(target);
    return FALSE;
}

/* How it is read --------------------------------------------------------------------------------------------------- */

/* As the row's table is read now. FALSE with an error where it is gone meanwhile. */
static gboolean find_source(TinkerDocument *document, const TinkerPropertyRow *row, TinkerTableSource *source,
                            TinkerWaveform **former, GError **error)
{
    if (!check_target(document, row, tinker_document_base(document), error)) return FALSE;
    *source = present_source(tinker_document_scene(document), row, former);
    return *former != NULL || property_refuse(error, _("The table is no longer there."));
}

/* Reads the same file in another way. */
static gboolean read_again(TinkerDocument *document, const TinkerPropertyRow *row, const TinkerTableSource *how,
                           TinkerWaveform *former, GError **error)
{
    g_autofree char *file = tinker_scene_table_file(tinker_document_scene(document), former);
    TinkerTableSource source = *how;
    if (file == NULL) return property_refuse(error, _("The table is no longer there."));
    source.file = file;
    return read_table(document, row, &source, former, error);
}

static gboolean set_column(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    static const TinkerDimension none = {0, 0, 0, 0};
    TinkerTableSource source;
    TinkerWaveform *former;
    double column;
    if (!find_source(document, row, &source, &former, error)) return FALSE;
    if (!property_parse_number(text, none, "", &column, error)) return FALSE;
    if (!(column >= 1 && column <= TINKER_TABLE_MOST_COLUMN && column == floor(column)))
        return property_refuse(error, _("“Column” must be a whole number from 1; column 0 is the time."));
    source.column = (int)column;
    return read_again(document, row, &source, former, error);
}

static gboolean set_scale(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    static const TinkerDimension none = {0, 0, 0, 0};
    TinkerTableSource source;
    TinkerWaveform *former;
    if (!find_source(document, row, &source, &former, error)) return FALSE;
    if (!property_parse_number(text, none, "", &source.scale, error)) return FALSE;
    return read_again(document, row, &source, former, error);
}

static gboolean choose_kind(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    TinkerTableSource source;
    TinkerWaveform *former;
    if (!find_source(document, row, &source, &former, error)) return FALSE;
    source.kind = choice == 1 ? TINKER_TABLE_ACCELERATION : TINKER_TABLE_VALUE;
    return read_again(document, row, &source, former, error);
}

/* Rows ------------------------------------------------------------------------------------------------------------- */

static TinkerPropertyRow *add_row(PropertyBuilder *builder, const TinkerPropertyType *type, int32_t property,
                                  TinkerRowKind kind, const char *title, const char *description)
{
    TinkerPropertyRow *row = property_builder_add(builder, kind, property_group_of(builder, type), title, description);
    row->property = property;
    return row;
}

static void add_scale(PropertyBuilder *builder, const TinkerPropertyType *type, int32_t property, double scale)
{
    char number[32];
    g_autofree char *description =
        g_strdup_printf(_("What the column is multiplied by. The product is in %s, or, of an acceleration, in m/s²."),
                        *tinker_unit_si_symbol(type->dimension) != '\0' ? tinker_unit_si_symbol(type->dimension) : "1");
    TinkerPropertyRow *row = add_row(builder, type, property, TINKER_ROW_NUMBER, _("Scale"), description);
    tinker_number_to_text(scale, number, sizeof number);
    property_row_take_text(row, g_strdup(number));
    row->set = set_scale;
}

/* Only what moves a place can be given by its acceleration. */
static void add_kind(PropertyBuilder *builder, const TinkerPropertyType *type, int32_t property, TinkerTableKind kind)
{
    static const TinkerDimension length = {.length = 1};
    if (!tinker_dimension_equal(type->dimension, length)) return;
    TinkerPropertyRow *row = add_row(builder, type, property, TINKER_ROW_CHOICE, _("Kind"),
                                     _("Whether the column holds displacements, read as a smooth curve, or "
                                       "accelerations, which are integrated."));
    row->choices = g_new0(char *, 3);
    row->choices[0] = g_strdup(_("Displacement"));
    row->choices[1] = g_strdup(_("Acceleration"));
    row->chosen = kind == TINKER_TABLE_ACCELERATION ? 1 : 0;
    row->choose = choose_kind;
}

void property_rows_add_table(PropertyBuilder *builder, const TinkerPropertyType *type, int32_t property)
{
    TinkerWaveform *waveform = common_waveform(builder->scene, builder->blocks, builder->count, property);
    TinkerTableFacts facts;
    if (waveform == NULL || !tinker_waveform_table_facts(waveform, &facts)) return;
    TinkerPropertyRow *rows =
        add_row(builder, type, property, TINKER_ROW_READING, _("Rows"), _("How many rows of numbers the table has."));
    property_row_take_text(rows, g_strdup_printf("%" G_GSIZE_FORMAT, facts.rows));
    g_autofree char *file = tinker_scene_table_file(builder->scene, waveform);
    if (file == NULL) return;

    g_autofree char *description = g_strdup_printf(_("The table, in the folder of the scene: %s"), file);
    TinkerPropertyRow *name = add_row(builder, type, property, TINKER_ROW_READING, _("File"), description);
    property_row_take_text(name, g_strdup(file));
    TinkerPropertyRow *column = add_row(builder, type, property, TINKER_ROW_NUMBER, _("Column"),
                                        _("Which column of the table is used, from 1; column 0 is the time in s."));
    property_row_take_text(column, g_strdup_printf("%d", facts.column));
    column->set = set_column;
    add_scale(builder, type, property, facts.scale);
    add_kind(builder, type, property, facts.kind);
}
