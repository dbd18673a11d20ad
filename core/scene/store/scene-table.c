/* Tables: the blocks of one class, a column of doubles per property component. Rows are kept in the order of their ids;
 * adding at the end is amortised O(1), removing or bringing back takes a pass over the table, for however many at once.
 */
#include <math.h>
#include <string.h>

#include "scene/store/scene-data.h"

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

static void make_room_for_ends(SceneTable *table, int32_t total)
{
    if (total <= table->end_room) return;
    table->end_room = MAX(total, table->end_room + table->end_room / 2);
    table->ends = g_renew(TinkerSceneEnd, table->ends, table->end_room);
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

/* A new row has the defaults and detached ends. */
static void begin_row(SceneTable *table, int32_t row, TinkerBlockId id)
{
    table->ids[row] = id;
    for (int32_t end = table->end_offsets[row]; end < table->end_offsets[row + 1]; end++)
        table->ends[end] = (TinkerSceneEnd){TINKER_NO_BLOCK, 0, 0};
    for (int32_t p = 0; p < table->block_class->property_count; p++) {
        if (table->texts[p] != NULL) table->texts[p][row] = NULL;
        if (table->waveforms[p] != NULL) table->waveforms[p][row] = NULL;
        scene_table_set_default(table, row, p);
    }
    scene_table_resolve(table, row);
}

void scene_table_append(TinkerScene *scene, SceneTable *table, TinkerBlockId id, int32_t end_count)
{
    const int32_t row = table->count, total = table->end_offsets[row] + end_count;
    if (row == table->room) table_grow(table);
    make_room_for_ends(table, total);
    table->end_offsets[row + 1] = total;
    begin_row(table, row, id);
    table->count++;
    renumber(scene, table, row);
}

/* Several rows at once --------------------------------------------------------------------------------------------- */

/* The array's entry `from` becomes the one `to`, for each row in turn: `from` is never before `to` in a table that gets
 * shorter. */
#define GATHER(array, kept, count)                                                                                     \
    for (int32_t i = 0; i < (count); i++)                                                                              \
    (array)[i] = (array)[(kept)[i]]

static void gather_ends(SceneTable *table, const int32_t *kept, int32_t count)
{
    int32_t offset = 0;
    for (int32_t i = 0; i < count; i++) {
        const int32_t from = table->end_offsets[kept[i]], ends = table->end_offsets[kept[i] + 1] - from;
        if (ends > 0) memmove(table->ends + offset, table->ends + from, (gsize)ends * sizeof *table->ends);
        table->end_offsets[i] = offset;
        offset += ends;
    }
    table->end_offsets[count] = offset;
}

void scene_table_remove(TinkerScene *scene, SceneTable *table, GHashTable *blocks)
{
    const TinkerBlockClass *block_class = table->block_class;
    g_autofree int32_t *kept = g_new(int32_t, MAX(table->count, 1));
    int32_t count = 0;
    for (int32_t row = 0; row < table->count; row++) {
        if (g_hash_table_contains(blocks, GINT_TO_POINTER(table->ids[row])))
            clear_row(table, row);
        else
            kept[count++] = row;
    }
    gather_ends(table, kept, count);
    GATHER(table->ids, kept, count);
    for (int32_t c = 0; c < block_class->column_count; c++)
        GATHER(table->columns[c], kept, count);
    for (int32_t p = 0; p < block_class->property_count; p++) {
        GATHER(table->given[p], kept, count);
        if (table->texts[p] != NULL) GATHER(table->texts[p], kept, count);
        if (table->waveforms[p] != NULL) GATHER(table->waveforms[p], kept, count);
    }
    table->count = count;
    renumber(scene, table, 0);
}

/* Entry i of an array becomes the one to[i], from the last on: `to` is never before i. */
#define SPREAD(array, to, count)                                                                                       \
    for (int32_t i = (count); i-- > 0;)                                                                                \
    (array)[(to)[i]] = (array)[i]

static void spread_ends(SceneTable *table, const int32_t *to, const int32_t *offsets)
{
    for (int32_t i = table->count; i-- > 0;) {
        const int32_t ends = scene_table_end_count(table, i);
        if (ends > 0)
            memmove(table->ends + offsets[to[i]], scene_table_ends(table, i), (gsize)ends * sizeof *table->ends);
    }
}

/* Opens the rows `at` for `count` more, and moves the others to the rows `to`. */
static void spread(SceneTable *table, const int32_t *to, const SceneNewRow *rows, const int32_t *at, int32_t count)
{
    const TinkerBlockClass *block_class = table->block_class;
    const int32_t total = table->count + count;
    g_autofree int32_t *offsets = g_new0(int32_t, total + 1);
    while (table->room < total)
        table_grow(table);
    for (int32_t i = 0; i < table->count; i++)
        offsets[to[i] + 1] = scene_table_end_count(table, i);
    for (int32_t i = 0; i < count; i++)
        offsets[at[i] + 1] = rows[i].end_count;
    for (int32_t row = 0; row < total; row++)
        offsets[row + 1] += offsets[row];
    make_room_for_ends(table, offsets[total]);
    spread_ends(table, to, offsets);
    memcpy(table->end_offsets, offsets, ((gsize)total + 1) * sizeof *offsets);
    SPREAD(table->ids, to, table->count);
    for (int32_t c = 0; c < block_class->column_count; c++)
        SPREAD(table->columns[c], to, table->count);
    for (int32_t p = 0; p < block_class->property_count; p++) {
        SPREAD(table->given[p], to, table->count);
        if (table->texts[p] != NULL) SPREAD(table->texts[p], to, table->count);
        if (table->waveforms[p] != NULL) SPREAD(table->waveforms[p], to, table->count);
    }
    table->count = total;
}

void scene_table_insert(TinkerScene *scene, SceneTable *table, const SceneNewRow *rows, int32_t count)
{
    g_autofree int32_t *to = g_new(int32_t, MAX(table->count, 1)), *at = g_new(int32_t, MAX(count, 1));
    int32_t next = 0;
    for (int32_t i = 0; i < table->count; i++) {
        for (; next < count && rows[next].id < table->ids[i]; next++)
            at[next] = i + next;
        to[i] = i + next;
    }
    for (; next < count; next++)
        at[next] = table->count + next;
    spread(table, to, rows, at, count);
    for (int32_t i = 0; i < count; i++)
        begin_row(table, at[i], rows[i].id);
    renumber(scene, table, 0);
}

void scene_table_set_default(SceneTable *table, int32_t row, int32_t property)
{
    const TinkerPropertyType *type = &table->block_class->properties[property];
    int32_t first = table->block_class->first_columns[property];
    const guint32 elsewhere = TINKER_DEFAULT_AS_PLACED | TINKER_DEFAULT_AS_SHAPED | TINKER_DEFAULT_NONE;
    const gboolean no_value = (type->flags & elsewhere) != 0;
    table->given[property][row] = 0;
    for (int32_t c = 0; c < tinker_kind_columns(type->kind); c++) {
        double value = type->kind == TINKER_KIND_WAVEFORM ? 0 : type->default_value[c];
        table->columns[first + c][row] = no_value ? NAN : value;
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
