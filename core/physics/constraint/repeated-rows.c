/* Rows that repeat others; see the header. */
#include "physics/constraint/repeated-rows.h"
#include "physics/model/points.h"

#include <stdlib.h>
#include <string.h>

/* A block of a batch, with its ends in an order that does not depend on how they were given, where they may be given
 * either way. */
typedef struct {
    const TinkerModel *model;
    const TinkerConstraintBatch *part;
    int32_t instance;
    gboolean turned; /* its ends are the other way round */
} Block;

static int compare_numbers(double left, double right)
{
    return left < right ? -1 : left > right;
}

/* Two points by where on which block they are. */
static int compare_places(const TinkerModel *model, int32_t left, int32_t right)
{
    static const TinkerAttachment centre = {.x = 0, .y = 0};
    const TinkerBlockId blocks[2] = {tinker_model_block_of(model, left), tinker_model_block_of(model, right)};
    if (blocks[0] != blocks[1]) return blocks[0] < blocks[1] ? -1 : 1;
    const TinkerAttachment *a = left < model->bodies ? &centre : tinker_model_attachment(model, left);
    const TinkerAttachment *b = right < model->bodies ? &centre : tinker_model_attachment(model, right);
    const int by_x = compare_numbers(a->x, b->x);
    return by_x != 0 ? by_x : compare_numbers(a->y, b->y);
}

static int32_t end_of(const Block *block, int32_t number)
{
    const int32_t *offsets = block->part->batch->end_offsets + block->instance;
    return block->part->end_points[block->turned ? offsets[1] - 1 - number : offsets[0] + number];
}

/* By what they say: 0 where that is the same. */
static int compare_blocks(const Block *a, const Block *b)
{
    const TinkerBlockBatch *batch = a->part->batch;
    const int32_t *offsets = batch->end_offsets;
    const int32_t ends = offsets[a->instance + 1] - offsets[a->instance],
                  others = offsets[b->instance + 1] - offsets[b->instance];
    if (ends != others) return ends < others ? -1 : 1;
    for (int32_t k = 0; k < ends; k++) {
        const int order = compare_places(a->model, end_of(a, k), end_of(b, k));
        if (order != 0) return order;
    }
    if (a->part->distances != NULL)
        return compare_numbers(a->part->distances[a->instance], a->part->distances[b->instance]);
    for (int32_t c = 0; c < batch->block_class->column_count && !a->part->coincident; c++) {
        const int order = memcmp(&batch->columns[c][a->instance], &batch->columns[c][b->instance], sizeof(double));
        if (order != 0) return order;
    }
    return 0;
}

static int in_order(const void *left, const void *right)
{
    const Block *a = left, *b = right;
    const int order = compare_blocks(a, b);
    return order != 0 ? order : a->instance < b->instance ? -1 : 1;
}

/* Rows that hold in one direction only, or that prescribe a motion, are for others to tell apart; what is typed or
 * drawn is not compared. */
static gboolean may_repeat(const TinkerConstraintBatch *part)
{
    const TinkerConstraint *constraint = part->constraint;
    const TinkerBlockBatch *batch = part->batch;
    return batch->count > 1 && constraint->unilateral == 0 && constraint->prescribed_rate == NULL &&
           batch->evaluator_count == 0 && batch->law_count == 0 && batch->point_list_count == 0;
}

static void list_rows(GArray *found, const Block *first, const Block *again, int32_t copies)
{
    const int32_t rows = first->part->constraint->rows, begin = first->part->first_row;
    const double sign = first->part->coincident && first->turned != again->turned ? -1 : 1;
    for (int32_t r = 0; r < rows; r++) {
        TinkerRepeatedRow row = {.row = begin + again->instance * rows + r,
                                 .first = begin + first->instance * rows + r,
                                 .copies = copies,
                                 .sign = sign};
        g_array_append_val(found, row);
    }
}

static void look_through(const TinkerModel *model, const TinkerConstraintBatch *part, GArray *found)
{
    const int32_t count = part->batch->count;
    const gboolean either_way = part->coincident || part->distances != NULL;
    g_autofree Block *blocks = g_new(Block, count);
    for (int32_t i = 0; i < count; i++) {
        const int32_t *ends = part->end_points + part->batch->end_offsets[i];
        blocks[i] = (Block){model, part, i, either_way && compare_places(model, ends[0], ends[1]) > 0};
    }
    qsort(blocks, (gsize)count, sizeof(Block), in_order);
    for (int32_t i = 0, after; i < count; i = after) {
        for (after = i + 1; after < count && compare_blocks(&blocks[i], &blocks[after]) == 0;)
            after++;
        for (int32_t k = i + 1; k < after; k++)
            list_rows(found, &blocks[i], &blocks[k], after - i);
    }
}

static int by_first(const void *left, const void *right)
{
    const TinkerRepeatedRow *a = left, *b = right;
    if (a->first != b->first) return a->first < b->first ? -1 : 1;
    return a->row < b->row ? -1 : 1;
}

gboolean tinker_repeated_rows_find(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    g_autoptr(GArray) found = g_array_new(FALSE, FALSE, sizeof(TinkerRepeatedRow));
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (may_repeat(part)) look_through(model, part, found);
    }
    if (found->len == 0) return TRUE;
    qsort(found->data, found->len, sizeof(TinkerRepeatedRow), by_first);
    all->repeats = g_try_new0(gboolean, all->rows);
    if (all->repeats == NULL) return FALSE;
    all->repeated_count = (int32_t)found->len;
    all->repeated = g_memdup2(found->data, found->len * sizeof(TinkerRepeatedRow));
    for (int32_t i = 0; i < all->repeated_count; i++)
        all->repeats[all->repeated[i].row] = TRUE;
    return TRUE;
}

void tinker_repeated_rows_place(TinkerConstraints *all)
{
    for (int32_t i = 0; i < all->repeated_count; i++) {
        TinkerRepeatedRow *of = &all->repeated[i];
        of->slot = tinker_sparse_ldl_slot(all->ldl, of->row, of->row);
        of->first_slot = tinker_sparse_ldl_slot(all->ldl, of->first, of->first);
    }
}

double tinker_repeated_rows_fold(const TinkerConstraints *all, double *b)
{
    double most = 0;
    for (int32_t i = 0, after; i < all->repeated_count; i = after) {
        const int32_t first = all->repeated[i].first, copies = all->repeated[i].copies;
        const double own = b[first];
        double sum = 0, least = 0, greatest = 0; /* of what the others ask for beyond it */
        for (after = i; after < i + copies - 1; after++) {
            const TinkerRepeatedRow *of = &all->repeated[after];
            const double beyond = of->sign * b[of->row] - own;
            sum += beyond;
            least = MIN(least, beyond);
            greatest = MAX(greatest, beyond);
            b[of->row] = 0;
        }
        const double mean = sum / copies;
        b[first] = own + mean;
        most = MAX(most, MAX(greatest - mean, mean - least));
    }
    return most;
}

void tinker_repeated_rows_spread(const TinkerConstraints *all, double *x)
{
    for (int32_t i = 0, after; i < all->repeated_count; i = after) {
        const int32_t first = all->repeated[i].first, copies = all->repeated[i].copies;
        const double share = x[first] / copies;
        x[first] = share;
        for (after = i; after < i + copies - 1; after++)
            x[all->repeated[after].row] = all->repeated[after].sign * share;
    }
}
