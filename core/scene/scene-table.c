/* Tables: the blocks of one class, a column of doubles per property component. Rows are kept in the order of their ids;
 * adding at the end is amortised O(1), removing or bringing back moves what lies behind. */
#include <math.h>
#include <string.h>

#include "scene/scene-private.h"

/* Opens or closes the gap of one entry in an array of `count` entries. */
#define OPEN_GAP(array, at, count)                                                                                     \
    memmove((array) + (at) + 1, (array) + (at), ((size_t)(count) - (at)) * sizeof *(array))
#define CLOSE_GAP(array, at, count)                                                                                    \
    memmove((array) + (at), (array) + (at) + 1, ((size_t)(count) - (at)-1) * sizeof *(array))

static TinkerWaveform *new_default_waveform(const TinkerPropertyType *property)
{
    const char *text = property->default_text;
    if (g_strcmp0(text, "sine") == 0) return tinker_waveform_new_harmonic(TINKER_WAVEFORM_SINE);
    if (g_strcmp0(text, "cosine") == 0) return tinker_waveform_new_harmonic(TINKER_WAVEFORM_COSINE);
    return tinker_waveform_new_harmonic(TINKER_WAVEFORM_NONE);
}

static SceneTable *table_new(const TinkerBlockClass *block_class, int32_t number)
{
    SceneTable *table = g_new0(SceneTable, 1);
    gsize properties = (gsize)block_class->property_count;
    table->block_class = block_class;
    table->number = number;
    table->columns = g_new0(double *, (gsize)block_class->column_count + 1);
    table->given = g_new0(guint8 *, properties + 1);
    table->texts = g_new0(char **, properties + 1);
    table->waveforms = g_new0(TinkerWaveform **, properties + 1);
    table->default_waveforms = g_new0(TinkerWaveform *, properties + 1);
    table->end_offsets = g_new0(int32_t, 1);
    for (gsize p = 0; p < properties; p++) {
        const TinkerPropertyType *property = &block_class->properties[p];
        if (property->kind == TINKER_KIND_WAVEFORM) table->default_waveforms[p] = new_default_waveform(property);
        if (property->flags & TINKER_DEFAULT_SAME_AS) table->borrows = TRUE;
    }
    return table;
}

static void table_grow(SceneTable *table)
{
    const TinkerBlockClass *block_class = table->block_class;
    table->room = table->room == 0 ? 8 : table->room + table->room / 2;
    gsize room = (gsize)table->room;
    table->ids = g_renew(TinkerBlockId, table->ids, room);
    table->end_offsets = g_renew(int32_t, table->end_offsets, room + 1);
    for (int32_t c = 0; c < block_class->column_count; c++)
        table->columns[c] = g_renew(double, table->columns[c], room);
    for (int32_t p = 0; p < block_class->property_count; p++) {
        table->given[p] = g_renew(guint8, table->given[p], room);
        if (block_class->properties[p].kind == TINKER_KIND_TEXT)
            table->texts[p] = g_renew(char *, table->texts[p], room);
        if (block_class->properties[p].kind == TINKER_KIND_WAVEFORM)
            table->waveforms[p] = g_renew(TinkerWaveform *, table->waveforms[p], room);
    }
}

/* Makes room for `by` more ends (or fewer, where negative) in front of the end with this offset. */
static void move_ends(SceneTable *table, int32_t from, int32_t by)
{
    int32_t total = table->end_offsets[table->count];
    if (total + by > table->end_room) {
        table->end_room = MAX(total + by, table->end_room + table->end_room / 2);
        table->ends = g_renew(TinkerSceneEnd, table->ends, table->end_room);
    }
    if (total > from)
        memmove(table->ends + from + by, table->ends + from, (size_t)(total - from) * sizeof *table->ends);
}

/* The slots of a row and of those behind it follow a move. */
static void renumber(TinkerScene *scene, const SceneTable *table, int32_t from)
{
    for (int32_t row = from; row < table->count; row++) {
        SceneSlot *slot = scene_slot(scene, table->ids[row]);
        slot->table = table->number;
        slot->row = row;
    }
}

static void clear_row(SceneTable *table, int32_t row)
{
    for (int32_t p = 0; p < table->block_class->property_count; p++) {
        if (table->texts[p] != NULL) g_free(table->texts[p][row]);
        if (table->waveforms[p] != NULL && table->waveforms[p][row] != NULL)
            tinker_waveform_unref(table->waveforms[p][row]);
    }
}

SceneTable *scene_table_for(TinkerScene *scene, const TinkerBlockClass *block_class)
{
    SceneTable *table = g_hash_table_lookup(scene->table_of, block_class);
    if (table != NULL) return table;
    table = table_new(block_class, (int32_t)scene->tables->len);
    g_ptr_array_add(scene->tables, table);
    g_hash_table_insert(scene->table_of, (gpointer)block_class, table);
    return table;
}

void scene_table_free(SceneTable *table)
{
    for (int32_t row = 0; row < table->count; row++)
        clear_row(table, row);
    for (int32_t c = 0; c < table->block_class->column_count; c++)
        g_free(table->columns[c]);
    for (int32_t p = 0; p < table->block_class->property_count; p++) {
        g_free(table->given[p]);
        g_free(table->texts[p]);
        g_free(table->waveforms[p]);
        g_clear_pointer(&table->default_waveforms[p], tinker_waveform_unref);
    }
    g_free(table->columns);
    g_free(table->given);
    g_free(table->texts);
    g_free(table->waveforms);
    g_free(table->default_waveforms);
    g_free(table->ids);
    g_free(table->end_offsets);
    g_free(table->ends);
    g_free(table);
}

void scene_table_insert(TinkerScene *scene, SceneTable *table, int32_t row, TinkerBlockId id, int32_t end_count)
{
    const TinkerBlockClass *block_class = table->block_class;
    if (table->count == table->room) table_grow(table);
    OPEN_GAP(table->ids, row, table->count);
    table->ids[row] = id;
    for (int32_t c = 0; c < block_class->column_count; c++)
        OPEN_GAP(table->columns[c], row, table->count);

    int32_t first_end = table->end_offsets[row];
    move_ends(table, first_end, end_count);
    for (int32_t end = 0; end < end_count; end++)
        table->ends[first_end + end] = (TinkerSceneEnd){TINKER_NO_BLOCK, 0, 0};
    for (int32_t r = table->count; r >= row; r--)
        table->end_offsets[r + 1] = table->end_offsets[r] + end_count;

    for (int32_t p = 0; p < block_class->property_count; p++) {
        OPEN_GAP(table->given[p], row, table->count);
        if (table->texts[p] != NULL) {
            OPEN_GAP(table->texts[p], row, table->count);
            table->texts[p][row] = NULL;
        }
        if (table->waveforms[p] != NULL) {
            OPEN_GAP(table->waveforms[p], row, table->count);
            table->waveforms[p][row] = NULL;
        }
        scene_table_set_default(table, row, p);
    }
    table->count++;
    scene_table_resolve(table, row);
    renumber(scene, table, row);
}

void scene_table_remove(TinkerScene *scene, SceneTable *table, int32_t row)
{
    const TinkerBlockClass *block_class = table->block_class;
    clear_row(table, row);
    int32_t end_count = scene_table_end_count(table, row);
    move_ends(table, table->end_offsets[row + 1], -end_count);
    for (int32_t r = row + 1; r < table->count; r++)
        table->end_offsets[r] = table->end_offsets[r + 1] - end_count;

    CLOSE_GAP(table->ids, row, table->count);
    for (int32_t c = 0; c < block_class->column_count; c++)
        CLOSE_GAP(table->columns[c], row, table->count);
    for (int32_t p = 0; p < block_class->property_count; p++) {
        CLOSE_GAP(table->given[p], row, table->count);
        if (table->texts[p] != NULL) CLOSE_GAP(table->texts[p], row, table->count);
        if (table->waveforms[p] != NULL) CLOSE_GAP(table->waveforms[p], row, table->count);
    }
    table->count--;
    renumber(scene, table, row);
}

void scene_table_set_default(SceneTable *table, int32_t row, int32_t property)
{
    const TinkerPropertyType *type = &table->block_class->properties[property];
    int32_t first = table->block_class->first_columns[property];
    gboolean as_placed = (type->flags & TINKER_DEFAULT_AS_PLACED) != 0;
    table->given[property][row] = 0;
    for (int32_t c = 0; c < tinker_kind_columns(type->kind); c++) {
        double value = type->kind == TINKER_KIND_WAVEFORM ? 0 : type->default_value[c];
        table->columns[first + c][row] = as_placed ? NAN : value;
    }
}

void scene_table_resolve(SceneTable *table, int32_t row)
{
    if (!table->borrows) return;
    const TinkerBlockClass *block_class = table->block_class;
    for (int32_t p = 0; p < block_class->property_count; p++) {
        const TinkerPropertyType *type = &block_class->properties[p];
        if (!(type->flags & TINKER_DEFAULT_SAME_AS) || table->given[p][row]) continue;
        int32_t from = tinker_block_class_property(block_class, type->default_from);
        for (int32_t c = 0; c < tinker_kind_columns(type->kind); c++)
            table->columns[block_class->first_columns[p] + c][row] =
                table->columns[block_class->first_columns[from] + c][row];
    }
}

int32_t tinker_scene_table_count(const TinkerScene *scene)
{
    return (int32_t)scene->tables->len;
}

void tinker_scene_table(TinkerScene *scene, int32_t number, TinkerSceneTable *table)
{
    g_assert(number >= 0 && number < (int32_t)scene->tables->len);
    const SceneTable *own = g_ptr_array_index(scene->tables, number);
    *table = (TinkerSceneTable){
        .block_class = own->block_class,
        .count = own->count,
        .ids = own->ids,
        .columns = (const double *const *)own->columns,
        .ends = own->ends,
        .end_offsets = own->end_offsets,
    };
}
