/* Snapshots of tables. Property columns are copied; those of waveforms are filled by evaluators (batch-waveforms.c),
 * and typed laws are compiled (batch-laws.c). */
#include "scene/frame/batch-laws.h"
#include "scene/frame/batch-waveforms.h"

#include "plugin/call/guarded.h"
#include "plugin/call/words.h"
#include "units/compiled/compiled.h"
#include "units/quantity/point-text.h"

/* The rows of a table that are taken; their number is answered. */
static int32_t choose_rows(const TinkerSceneTable *table, const gboolean *include, int32_t *rows)
{
    int32_t count = 0;
    for (int32_t row = 0; row < table->count; row++)
        if (include == NULL || include[table->ids[row]]) rows[count++] = row;
    return count;
}

/* One piece of memory: the batch, and behind it so many bytes for its arrays, those of the widest entries first. */
static TinkerBlockBatch *allot(TinkerScene *scene, const TinkerBlockClass *block_class, int32_t count, gsize bytes)
{
    TinkerBlockBatch *batch = g_malloc0(sizeof(TinkerBlockBatch) + bytes);
    batch->scene = scene;
    batch->block_class = block_class;
    batch->count = count;
    batch->earliest = -INFINITY;
    batch->latest = INFINITY;
    batch->columns = (double **)(gpointer)(batch + 1);
    const TinkerBlockType *type = block_class->type;
    batch->ends = type->least_ends == type->most_ends ? type->least_ends : -1;
    return batch;
}

static void count_ends(TinkerBlockBatch *batch, const TinkerSceneTable *table, const int32_t *rows)
{
    for (int32_t i = 0; i < batch->count; i++)
        batch->end_offsets[i + 1] =
            batch->end_offsets[i] + table->end_offsets[rows[i] + 1] - table->end_offsets[rows[i]];
    batch->end_count = batch->end_offsets[batch->count];
}

static gsize ends_of(const TinkerSceneTable *table, const int32_t *rows, int32_t count)
{
    gsize ends = 0;
    for (int32_t i = 0; i < count; i++)
        ends += (gsize)(table->end_offsets[rows[i] + 1] - table->end_offsets[rows[i]]);
    return ends;
}

/* With copies of all that the table says of the rows. */
static TinkerBlockBatch *copy_rows(TinkerScene *scene, const TinkerSceneTable *table, const int32_t *rows,
                                   int32_t count)
{
    const gsize columns = (gsize)table->block_class->column_count, n = (gsize)count, ends = ends_of(table, rows, count);
    const gsize bytes = columns * (sizeof(double *) + n * sizeof(double)) + ends * sizeof(TinkerSceneEnd) +
                        (n + 1) * sizeof(int32_t) + n * sizeof(TinkerBlockId);
    TinkerBlockBatch *batch = allot(scene, table->block_class, count, bytes);
    double *entries = (double *)(gpointer)(batch->columns + columns);
    for (gsize column = 0; column < columns; column++, entries += n) {
        batch->columns[column] = entries;
        for (gsize i = 0; i < n; i++)
            entries[i] = table->columns[column][rows[i]];
    }
    batch->end = (TinkerSceneEnd *)(gpointer)entries;
    batch->end_offsets = (int32_t *)(gpointer)(batch->end + ends);
    batch->ids = (TinkerBlockId *)(gpointer)(batch->end_offsets + n + 1);
    count_ends(batch, table, rows);
    for (int32_t i = 0; i < count; i++) {
        batch->ids[i] = table->ids[rows[i]];
        for (int32_t e = batch->end_offsets[i], from = table->end_offsets[rows[i]]; e < batch->end_offsets[i + 1];)
            batch->end[e++] = table->ends[from++];
    }
    return batch;
}

/* Of rows that lie one behind the other in a batch whose columns change no more: a window on them. */
static TinkerBlockBatch *borrow_rows(const TinkerBlockBatch *of, const TinkerSceneTable *table, const int32_t *rows,
                                     int32_t count)
{
    const gsize columns = (gsize)of->block_class->column_count;
    TinkerBlockBatch *batch =
        allot(of->scene, of->block_class, count, columns * sizeof(double *) + ((gsize)count + 1) * sizeof(int32_t));
    for (gsize column = 0; column < columns; column++)
        batch->columns[column] = of->columns[column] + rows[0];
    batch->end_offsets = (int32_t *)(gpointer)(batch->columns + columns);
    batch->end = of->end + of->end_offsets[rows[0]];
    batch->ids = of->ids + rows[0];
    count_ends(batch, table, rows);
    return batch;
}

static void block_batch_free(TinkerBlockBatch *batch)
{
    for (int32_t i = 0; i < batch->evaluator_count; i++)
        tinker_waveform_evaluator_free(batch->evaluators[i]);
    g_free(batch->evaluators);
    g_free(batch->evaluator_rows);
    g_free(batch->waveform_columns);
    g_free(batch->pieces);
    tinker_guarded_free(batch->scratch);
    for (int32_t i = 0; i < batch->count * batch->law_count; i++)
        tinker_typed_free(batch->laws[i]);
    g_free(batch->laws);
    for (int32_t i = 0; i < batch->count * batch->point_list_count; i++)
        g_free((gpointer)batch->point_lists[i].points);
    g_free(batch->point_lists);
    g_free(batch->end_masses);
    g_free(batch->law_fault);
    g_clear_pointer(&batch->law_notes, g_ptr_array_unref);
    g_free(batch);
}

/* The lists of points of one block; one that cannot be read is empty, and told as a law is that cannot. */
static void take_points(TinkerBlockBatch *batch, int32_t row)
{
    TinkerPointList *list = batch->point_lists + (gsize)row * (gsize)batch->point_list_count;
    for (int32_t p = 0; p < batch->block_class->property_count; p++) {
        const TinkerPropertyType *type = &batch->block_class->properties[p];
        if ((type->flags & TINKER_TEXT_POINTS) == 0) continue;
        g_autoptr(GError) error = NULL;
        const char *text = tinker_scene_get_text(batch->scene, batch->ids[row], p);
        GArray *points = tinker_point_text_parse(text, type->dimension, &error);
        list->count = points != NULL ? (int32_t)points->len / 2 : 0;
        if (points != NULL) list->points = (const double *)(gpointer)g_array_free(points, FALSE);
        if (error != NULL && batch->law_fault == NULL)
            batch->law_fault = g_strdup_printf("%s: %s: %s", tinker_scene_block_name(batch->scene, batch->ids[row]),
                                               type->id, error->message);
        list++;
    }
}

static void take_all_points(TinkerBlockBatch *batch)
{
    for (int32_t p = 0; p < batch->block_class->property_count; p++)
        batch->point_list_count += (batch->block_class->properties[p].flags & TINKER_TEXT_POINTS) != 0;
    if (batch->point_list_count == 0) return;
    batch->point_lists = g_new0(TinkerPointList, (gsize)batch->count * (gsize)batch->point_list_count);
    for (int32_t row = 0; row < batch->count; row++)
        take_points(batch, row);
}

static TinkerBlockBatch *complete(TinkerBlockBatch *batch)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    tinker_block_batch_copy_waveforms(batch);
    tinker_block_batch_compile_laws(batch);
    take_all_points(batch);
    if (physics != NULL && physics->scratch_size > 0)
        batch->scratch = tinker_guarded_new((gsize)physics->scratch_size, batch->block_class);
    return batch;
}

GPtrArray *tinker_batches_new(TinkerScene *scene, const gboolean *include)
{
    GPtrArray *batches = g_ptr_array_new_with_free_func((GDestroyNotify)block_batch_free);
    for (int32_t number = 0; number < tinker_scene_table_count(scene); number++) {
        TinkerSceneTable table;
        tinker_scene_table(scene, number, &table);
        g_autofree int32_t *rows = g_new(int32_t, MAX(table.count, 1));
        int32_t count = choose_rows(&table, include, rows);
        if (count > 0) g_ptr_array_add(batches, complete(copy_rows(scene, &table, rows, count)));
    }
    return batches;
}

GPtrArray *tinker_batches_take(const GPtrArray *batches, const int32_t *numbers, int32_t count)
{
    GPtrArray *taken = g_ptr_array_new_with_free_func((GDestroyNotify)block_batch_free);
    g_autofree int32_t *rows = g_new(int32_t, MAX(count, 1));
    int32_t first = 0, next = 0;
    for (guint i = 0; i < batches->len && next < count; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(batches, i);
        int32_t own = 0;
        for (; next < count && numbers[next] - first < batch->count; next++)
            rows[own++] = numbers[next] - first;
        first += batch->count;
        if (own == 0) continue;
        const TinkerSceneTable table = {batch->block_class, batch->count,
                                        batch->ids,         (const double *const *)batch->columns,
                                        batch->end,         batch->end_offsets};
        const gboolean together = rows[own - 1] - rows[0] == own - 1 && batch->waveforms == 0;
        g_ptr_array_add(taken, complete(together ? borrow_rows(batch, &table, rows, own)
                                                 : copy_rows(batch->scene, &table, rows, own)));
    }
    return taken;
}

int32_t tinker_batches_most_rows(const GPtrArray *batches)
{
    int32_t most = 0;
    for (guint i = 0; i < batches->len; i++)
        most = MAX(most, ((const TinkerBlockBatch *)g_ptr_array_index(batches, i))->count);
    return most;
}

const char *tinker_block_batch_name(const void *source, int32_t row)
{
    const TinkerBlockBatch *batch = source;
    return row >= 0 && row < batch->count ? tinker_scene_block_name(batch->scene, batch->ids[row]) : NULL;
}

char *tinker_block_batch_refusal(const TinkerBlockBatch *batch, const TinkerBatch *view, const char *otherwise)
{
    const int32_t row = CLAMP(view->failed_instance, 0, batch->count - 1);
    g_autofree char *words = tinker_plugin_words(batch->block_class, NULL, view->failure);
    return g_strdup_printf("%s: %s", tinker_scene_block_name(batch->scene, batch->ids[row]),
                           words != NULL ? words : otherwise);
}

TinkerBatch tinker_block_batch_view(TinkerBlockBatch *batch, double t)
{
    return (TinkerBatch){
        .struct_size = sizeof(TinkerBatch),
        .count = batch->count,
        .ends = batch->ends,
        .end_offsets = batch->ends < 0 ? batch->end_offsets : NULL,
        .columns = (const double *const *)batch->columns,
        .scratch = batch->scratch,
        .time = tinker_block_batch_inside(batch, t),
        .failed_instance = -1,
        .law_count = batch->law_count,
        .laws = (const TinkerTypedLaw *const *)batch->laws,
        .point_list_count = batch->point_list_count,
        .point_lists = batch->point_lists,
    };
}

double tinker_block_batch_meaning(const TinkerBlockBatch *batch, int32_t row, int32_t meaning, int32_t component,
                                  double otherwise)
{
    int32_t column = tinker_block_class_meaning_column(batch->block_class, meaning);
    return column < 0 ? otherwise : batch->columns[column + component][row];
}
