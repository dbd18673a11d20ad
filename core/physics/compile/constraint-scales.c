/* By what lengths constraint rows are measured. */
#include <math.h>

#include "physics/compile/compile-private.h"
#include "physics/compile/constraint-parts.h"
#include "physics/compile/tolerances.h"
#include "physics/model/points.h"

/* The larger side of the box about all points that something can be at; where these are one place but for the places
 * in them, as of two discs on one pin, the largest radius of gyration. */
static double extent_of(const TinkerModel *model)
{
    double far = 0, gyration = 0;
    double least[2] = {INFINITY, INFINITY}, greatest[2] = {-INFINITY, -INFINITY};
    for (int32_t i = 0; i < model->points; i++) {
        if (i >= model->bodies && i < model->first_attachment) continue;
        if (i >= model->first_attachment && tinker_model_attachment(model, i)->turn) continue;
        const double place[2] = {model->point[i].x, model->point[i].y};
        for (int k = 0; k < 2; k++) {
            least[k] = MIN(least[k], place[k]);
            greatest[k] = MAX(greatest[k], place[k]);
            far = MAX(far, fabs(place[k] + model->origin[k]));
        }
    }
    const double extent = MAX(greatest[0] - least[0], greatest[1] - least[1]), rounding = TINKER_LEAST_EXTENT * far;
    if (extent > rounding) return extent;
    for (int32_t turn = 0; turn < model->turning; turn++)
        gyration = MAX(gyration, model->turns[turn].gyration);
    return MAX(rounding, gyration);
}

static void find_scales_of(TinkerModel *model, const TinkerConstraintBatch *part, double extent)
{
    TinkerConstraints *all = &model->constraints;
    double *scale = all->scales + part->first_row;
    TinkerBatch view = tinker_block_batch_view(part->batch, 0.0);
    gboolean told = part->constraint->scale != NULL &&
                    TINKER_CALL_BATCH(part->batch, "scale", &view, part->constraint->scale(&view, scale)) == TINKER_OK;
    for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++) {
        all->inverse_scales[row] = 1.0 / all->scales[row];
        if (told && all->scales[row] > 0) continue;
        double largest = part->constraint->joint != 0 ? extent : 0;
        const TinkerPoint *first = &model->point[all->ends_at[all->row_starts[row]]];
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
            const TinkerPoint *other = &model->point[all->ends_at[e]];
            if (part->angles != NULL &&
                e - all->row_starts[row] >= (all->row_starts[row + 1] - all->row_starts[row]) / 2)
                break; /* turns are no places */
            largest = MAX(largest, hypot(other->x - first->x, other->y - first->y));
        }
        if (largest < TINKER_ROUNDED_DISTANCE * extent) largest = extent;
        all->scales[row] = largest > 0 ? largest : 1.0;
        all->inverse_scales[row] = 1.0 / all->scales[row];
    }
}

void tinker_constraints_find_scales(TinkerModel *model)
{
    const double extent = extent_of(model);
    const GArray *batches = model->constraints.batches;
    for (guint i = 0; i < batches->len; i++)
        find_scales_of(model, &g_array_index(batches, TinkerConstraintBatch, i), extent);
}
