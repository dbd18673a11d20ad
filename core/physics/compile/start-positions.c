/* Whether the start positions nearly fit the constraints; what does not is refused by name, with the number that would
 * fit. */
#include "physics/compile/start-private.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/model-data.h"

/* The column of the length that a row keeps from end to end; -1 where it says no such thing, as of what is wound. */
static int32_t path_column(const TinkerBlockClass *block_class, int32_t ends)
{
    int32_t property = block_class->meanings[TINKER_MEANING_LENGTH];
    if (property < 0 || ends < 2 || tinker_block_class_is_wound(block_class)) return -1;
    gboolean along = ends == 2 || (block_class->properties[property].flags & TINKER_DEFAULT_AS_PLACED) != 0;
    return along ? block_class->first_columns[property] : -1;
}

static double path_length(const TinkerModel *model, int32_t row, int32_t ends)
{
    const TinkerConstraints *all = &model->constraints;
    double length = 0;
    for (int32_t e = all->row_starts[row] + 1; e < all->row_starts[row] + ends; e++) {
        const TinkerPoint *a = &model->point[all->ends_at[e - 1]], *b = &model->point[all->ends_at[e]];
        length += hypot(b->x - a->x, b->y - a->y);
    }
    return length;
}

/* Where the row would be met if one end moved, a body's, by the row's derivatives: exactly for a row that is linear
 * along them, roughly for others. Answers that body, or -1 where the row moves none. */
static int32_t nearest_fit(const TinkerModel *model, int32_t row, double place[2])
{
    const TinkerConstraints *all = &model->constraints;
    int32_t body = -1;
    double steepest = 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const int32_t point = all->points[e];
        const double *slope = &all->jacobian[2 * e], square = slope[0] * slope[0] + slope[1] * slope[1];
        if (point >= model->bodies || !(square > steepest)) continue;
        steepest = square;
        body = point;
        place[0] = model->origin[0] + model->point[point].x - all->g[row] * slope[0] / square;
        place[1] = model->origin[1] + model->point[point].y - all->g[row] * slope[1] / square;
    }
    return body >= 0 && isfinite(place[0]) && isfinite(place[1]) ? body : -1;
}

static void refuse_misfit(const TinkerModel *model, int32_t row, const char *name, GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    double place[2];
    const char *unit = tinker_constraints_row_unit(model, row);
    const int32_t body = nearest_fit(model, row, place);
    const gboolean turned = strcmp(unit, "rad") == 0;
    g_autofree char *hint =
        turned ? g_strdup(_("turn what one of its ends is on, or change its properties"))
        : body < 0
            ? g_strdup(_("move its ends, or change its properties"))
            : g_strdup_printf(_("it fits with %s at about (%.5g, %.5g) m"),
                              tinker_scene_block_name(model->scene, model->body_blocks[body]), place[0], place[1]);
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                _("%s: the start positions miss it by %.3g %s (at most %.3g %s is corrected; %s)"), name,
                fabs(all->g[row]), unit, TINKER_START_MISS * all->scales[row], unit, hint);
}

/* A joint by one of its rows in m: both components of what lies between its ends, or that across a line. */
static void refuse_joint(const TinkerModel *model, const TinkerConstraintBatch *part, int32_t row, const char *name,
                         GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    const TinkerPoint *a = &model->point[all->ends_at[all->row_starts[row]]];
    const TinkerPoint *b = &model->point[all->ends_at[all->row_starts[row] + 1]];
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                part->constraint->joint == 1
                    ? _("%s: its ends do not fit together at t = 0: they are at (%.10g, %.10g) and (%.10g, %.10g) m "
                        "(move one to the other; at most %.0e of the scene's extent, %.3g m, is corrected)")
                    : _("%s: its ends do not fit together at t = 0: they are at (%.10g, %.10g) and (%.10g, %.10g) m "
                        "(move one onto the line through the other, or turn that; at most %.0e of the scene's extent, "
                        "%.3g m, is corrected)"),
                name, a->x + model->origin[0], a->y + model->origin[1], b->x + model->origin[0],
                b->y + model->origin[1], TINKER_START_MISS, TINKER_START_MISS * all->scales[row]);
}

static gboolean refuse_row(const TinkerModel *model, const TinkerConstraintBatch *part, int32_t row, GError **error)
{
    const TinkerBlockBatch *batch = part->batch;
    int32_t instance = (row - part->first_row) / part->constraint->rows;
    int32_t ends = batch->end_offsets[instance + 1] - batch->end_offsets[instance];
    int32_t column = path_column(batch->block_class, ends);
    const char *name = tinker_scene_block_name(model->scene, batch->ids[instance]);
    const gboolean of_angle = strcmp(tinker_constraints_row_unit(model, row), "rad") == 0;
    if (part->constraint->joint != 0 && !of_angle) {
        refuse_joint(model, part, row, name, error);
    } else if (column >= 0) {
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                    ends == 2 ? _("%s: its length is %.10g m, but its ends are %.10g m apart at t = 0 (move an end, "
                                  "change the length, or leave the length out)")
                              : _("%s: its length is %.10g m, but the path through its ends is %.10g m long at t = 0 "
                                  "(move an end, change the length, or leave the length out)"),
                    name, batch->columns[column][instance], path_length(model, row, ends));
    } else {
        refuse_misfit(model, row, name, error);
    }
    return FALSE;
}

gboolean tinker_start_check_positions(const TinkerModel *model, GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        TinkerBatch view = tinker_block_batch_view(part->batch, 0.0);
        if (part->constraint->check != NULL &&
            TINKER_CALL_BATCH(part->batch, "check", &view, part->constraint->check(&view)) != TINKER_OK) {
            g_autofree char *why =
                tinker_block_batch_refusal(part->batch, &view, _("its properties do not make a constraint"));
            g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE, why);
            return FALSE;
        }
        for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++)
            if (part->constraint->unilateral ? !(all->g[row] <= TINKER_START_MISS * all->scales[row])
                                             : !(fabs(all->g[row]) <= TINKER_START_MISS * all->scales[row]))
                return refuse_row(model, part, row, error);
    }
    return TRUE;
}
