/* gap = n . (centre - top) - height / 2, with n the normal of the plate's solid side; a body is over the plate while its
 * centre's foot lies within the width. */
#include "physics/passing.h"

#include <math.h>

/* Pairs that are looked at; beyond, looking would cost more than stepping. */
#define MOST_PAIRS 100000

typedef struct {
    TinkerBlockId block;
    int32_t point;
    double normal[2], half_width, half_height;
} Plate;

typedef struct {
    TinkerBlockId block;
    int32_t point;
    double half_height;
} Box;

struct _TinkerPassing {
    TinkerModel *model;
    GArray *plates, *boxes;
    gboolean *above; /* box by box */
    gboolean first, warned;
};

static double meaning(const TinkerBlockBatch *batch, int32_t row, int32_t what, double otherwise)
{
    int32_t column = tinker_block_class_meaning_column(batch->block_class, what);
    return column < 0 ? otherwise : batch->columns[column][row];
}

static void add_batch(TinkerPassing *passing, const TinkerBlockBatch *batch, int32_t shape)
{
    for (int32_t row = 0; row < batch->count; row++) {
        double half_height = 0.5 * meaning(batch, row, TINKER_MEANING_HEIGHT, 0);
        int32_t point = passing->model->centre_point[batch->ids[row]];
        if (shape == TINKER_SHAPE_BOX) {
            Box box = {batch->ids[row], point, half_height};
            g_array_append_val(passing->boxes, box);
        } else if (meaning(batch, row, TINKER_MEANING_SOLID, 1) != 0) {
            double angle = meaning(batch, row, TINKER_MEANING_ORIENTATION, 0);
            Plate plate = {batch->ids[row],
                           point,
                           {-sin(angle), cos(angle)},
                           0.5 * meaning(batch, row, TINKER_MEANING_WIDTH, 0),
                           half_height};
            g_array_append_val(passing->plates, plate);
        }
    }
}

TinkerPassing *tinker_passing_new(TinkerModel *model)
{
    TinkerPassing *passing = g_new0(TinkerPassing, 1);
    *passing = (TinkerPassing){
        model, g_array_new(FALSE, FALSE, sizeof(Plate)), g_array_new(FALSE, FALSE, sizeof(Box)), NULL, TRUE, FALSE};
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        int32_t shape = physics != NULL && physics->body != NULL ? physics->body->shape : TINKER_SHAPE_NONE;
        if (shape == TINKER_SHAPE_BOX || shape == TINKER_SHAPE_PLATE) add_batch(passing, batch, shape);
    }
    gsize pairs = (gsize)passing->plates->len * passing->boxes->len;
    if (pairs == 0 || pairs > MOST_PAIRS) {
        tinker_passing_free(passing);
        return NULL;
    }
    passing->above = g_new0(gboolean, pairs);
    return passing;
}

void tinker_passing_free(TinkerPassing *passing)
{
    if (passing == NULL) return;
    g_array_unref(passing->plates);
    g_array_unref(passing->boxes);
    g_free(passing->above);
    g_free(passing);
}

static void warn(TinkerPassing *passing, const Box *box, const Plate *plate, double t, GPtrArray *warnings)
{
    TinkerScene *scene = passing->model->scene;
    passing->warned = TRUE;
    g_ptr_array_add(warnings, g_strdup_printf("%s passed through %s before t = %.4g s: contact is not modelled yet "
                                              "(set \"solid\" of %s to false if that is meant)",
                                              tinker_scene_block_name(scene, box->block),
                                              tinker_scene_block_name(scene, plate->block), t,
                                              tinker_scene_block_name(scene, plate->block)));
}

void tinker_passing_look(TinkerPassing *passing, double t, GPtrArray *warnings)
{
    if (passing == NULL || passing->warned) return;
    const TinkerPoint *points = passing->model->point;
    gboolean *above = passing->above;
    for (guint i = 0; i < passing->boxes->len; i++) {
        const Box *box = &g_array_index(passing->boxes, Box, i);
        for (guint j = 0; j < passing->plates->len; j++, above++) {
            const Plate *plate = &g_array_index(passing->plates, Plate, j);
            double dx = points[box->point].x - points[plate->point].x,
                   dy = points[box->point].y - points[plate->point].y;
            double gap = plate->normal[0] * dx + plate->normal[1] * dy - plate->half_height - box->half_height;
            double along = plate->normal[1] * dx - plate->normal[0] * dy;
            gboolean over = fabs(along) <= plate->half_width;
            if (*above && over && gap < 0 && !passing->first && !passing->warned)
                warn(passing, box, plate, t, warnings);
            *above = gap >= 0;
        }
    }
    passing->first = FALSE;
}
