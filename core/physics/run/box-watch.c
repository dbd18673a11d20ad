/* Sweep and prune: the boxes are sorted by their lower sides along the axis on which they are spread wider, and only
 * those whose shadows on it overlap are looked at. From one sample to the next the order hardly changes, so it is kept,
 * and mended by insertion. */
#include "physics/run/box-watch.h"

#include <math.h>
#include <stdlib.h>

#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "scene/frame/boxes.h"
#include "scene/frame/tops.h"

typedef struct {
    TinkerBox box;
    double reach[2]; /* of the box as it is turned */
    double from, to; /* its shadow on the axis */
    double start_angle;
    int32_t body;
} Watched;

struct _TinkerBoxWatch {
    Watched *watched;
    Watched **order;
    int32_t count;
    int axis; /* that the order is by; -1: none yet */
};

static void add_batch(GArray *watched, const TinkerModel *model, const TinkerBlockBatch *batch)
{
    if (!tinker_class_can_lie(batch->block_class)) return;
    for (int32_t row = 0; row < batch->count; row++) {
        const double angle = tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0);
        Watched each = {.box = {.block = batch->ids[row],
                                .angle = angle,
                                .width = tinker_block_batch_meaning(batch, row, TINKER_MEANING_WIDTH, 0, 0),
                                .height = tinker_block_batch_meaning(batch, row, TINKER_MEANING_HEIGHT, 0, 0),
                                .collides = tinker_block_batch_meaning(batch, row, TINKER_MEANING_COLLIDES, 0, 0) != 0},
                        .start_angle = angle,
                        .body = tinker_model_centre(model, batch->ids[row])};
        tinker_box_reach(&each.box, each.reach);
        if (each.box.width > 0 && each.box.height > 0 && each.body >= 0 && each.body < model->bodies)
            g_array_append_val(watched, each);
    }
}

TinkerBoxWatch *tinker_box_watch_new(const TinkerModel *model)
{
    GArray *watched = g_array_new(FALSE, FALSE, sizeof(Watched));
    for (guint i = 0; i < model->batches->len; i++)
        add_batch(watched, model, g_ptr_array_index(model->batches, i));
    if (watched->len < 2) {
        g_array_unref(watched);
        return NULL;
    }
    TinkerBoxWatch *watch = g_new0(TinkerBoxWatch, 1);
    watch->count = (int32_t)watched->len;
    watch->axis = -1;
    watch->watched = (Watched *)(gpointer)g_array_free(watched, FALSE);
    watch->order = g_new(Watched *, watch->count);
    for (int32_t i = 0; i < watch->count; i++)
        watch->order[i] = &watch->watched[i];
    return watch;
}

void tinker_box_watch_free(TinkerBoxWatch *watch)
{
    if (watch == NULL) return;
    g_free(watch->watched);
    g_free(watch->order);
    g_free(watch);
}

static void place(TinkerBoxWatch *watch, const double *q, const double *orientation)
{
    for (int32_t i = 0; i < watch->count; i++) {
        Watched *each = &watch->watched[i];
        const double angle = isnan(orientation[each->body]) ? each->start_angle : orientation[each->body];
        each->box.x = q[2 * each->body];
        each->box.y = q[2 * each->body + 1];
        if (angle == each->box.angle) continue;
        each->box.angle = angle;
        tinker_box_reach(&each->box, each->reach);
    }
}

/* The axis on which the boxes are spread wider: 0 for x. */
static int wider_axis(const TinkerBoxWatch *watch)
{
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (int32_t i = 0; i < watch->count; i++) {
        const double at[2] = {watch->watched[i].box.x, watch->watched[i].box.y};
        for (int k = 0; k < 2; k++) {
            least[k] = fmin(least[k], at[k]);
            most[k] = fmax(most[k], at[k]);
        }
    }
    return most[1] - least[1] > most[0] - least[0];
}

static int compare(const void *a, const void *b)
{
    const Watched *first = *(Watched *const *)a, *second = *(Watched *const *)b;
    return first->from < second->from ? -1 : first->from > second->from;
}

static void sort(TinkerBoxWatch *watch)
{
    const int axis = wider_axis(watch);
    for (int32_t i = 0; i < watch->count; i++) {
        Watched *each = &watch->watched[i];
        const double at = axis == 0 ? each->box.x : each->box.y;
        each->from = at - each->reach[axis];
        each->to = at + each->reach[axis];
    }
    if (axis != watch->axis) qsort(watch->order, (size_t)watch->count, sizeof(Watched *), compare);
    watch->axis = axis;
    for (int32_t i = 1; i < watch->count; i++) {
        Watched *each = watch->order[i];
        int32_t k = i;
        for (; k > 0 && watch->order[k - 1]->from > each->from; k--)
            watch->order[k] = watch->order[k - 1];
        watch->order[k] = each;
    }
}

/* Keeps the pair with the lesser ids. */
static void keep(TinkerBlockId pair[2], TinkerBlockId a, TinkerBlockId b)
{
    const TinkerBlockId first = MIN(a, b), second = MAX(a, b);
    if (pair[0] != TINKER_NO_BLOCK && (first > pair[0] || (first == pair[0] && second >= pair[1]))) return;
    pair[0] = first;
    pair[1] = second;
}

gboolean tinker_box_watch_look(TinkerBoxWatch *watch, const double *q, const double *orientation, TinkerBlockId pair[2])
{
    place(watch, q, orientation);
    sort(watch);
    pair[0] = pair[1] = TINKER_NO_BLOCK;
    const int across = 1 - watch->axis;
    for (int32_t i = 0; i < watch->count; i++) {
        const Watched *a = watch->order[i];
        for (int32_t k = i + 1; k < watch->count && watch->order[k]->from < a->to; k++) {
            const Watched *b = watch->order[k];
            const double apart = across == 0 ? b->box.x - a->box.x : b->box.y - a->box.y;
            double time;
            if (a->box.collides && b->box.collides) continue;
            if (fabs(apart) < a->reach[across] + b->reach[across] && tinker_boxes_meet(&a->box, &b->box, 0, &time))
                keep(pair, a->box.block, b->box.block);
        }
    }
    return pair[0] != TINKER_NO_BLOCK;
}
