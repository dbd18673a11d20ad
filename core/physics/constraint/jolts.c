#include "physics/constraint/jolts.h"

#include "physics/constraint/constraints.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

GArray *tinker_jolts_new(void)
{
    return g_array_new(FALSE, TRUE, sizeof(TinkerJolt));
}

static TinkerJolt *jolt_of(GArray *jolts, double time, TinkerBlockId by, TinkerBlockId on)
{
    for (guint i = jolts->len; i > 0; i--) {
        TinkerJolt *jolt = &g_array_index(jolts, TinkerJolt, i - 1);
        if (jolt->time != time) break;
        if (jolt->by == by && jolt->on == on) return jolt;
    }
    const TinkerJolt jolt = {.time = time, .by = by, .on = on};
    g_array_append_val(jolts, jolt);
    return &g_array_index(jolts, TinkerJolt, jolts->len - 1);
}

void tinker_jolts_add(GArray *jolts, const TinkerModel *model, double time, TinkerBlockId by, int32_t coordinate,
                      double impulse)
{
    if (impulse == 0) return;
    TinkerJolt *jolt = jolt_of(jolts, time, by, model->body_blocks[tinker_model_moved_by(model, coordinate)]);
    if (coordinate < 2 * model->bodies)
        jolt->impulse[coordinate % 2] += impulse;
    else
        jolt->spin += impulse * model->turns[coordinate - 2 * model->bodies].gyration;
}

/* What a row does, with the Jacobian that it has in this array. `given`: see tinker_jolts_add_pull; or NULL. */
static void add_row(GArray *jolts, const TinkerModel *model, double time, int32_t row, const double *jacobian,
                    double multiplier, double *given)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
        for (int32_t k = 0; k < 2 && all->points[e] < model->bodies; k++) {
            const int32_t coordinate = 2 * all->points[e] + k;
            const double impulse = jacobian[2 * e + k] * multiplier;
            tinker_jolts_add(jolts, model, time, all->blocks[row], coordinate, impulse);
            if (given != NULL) given[coordinate] += impulse / model->coordinate_mass[coordinate];
        }
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++) {
        const int32_t coordinate = all->turns[k].coordinate;
        const double impulse = jacobian[2 * all->entries + k] * multiplier;
        tinker_jolts_add(jolts, model, time, all->blocks[row], coordinate, impulse);
        if (given != NULL) given[coordinate] += impulse / model->coordinate_mass[coordinate];
    }
}

void tinker_jolts_add_pull(GArray *jolts, const TinkerModel *model, double time, int32_t row, double multiplier,
                           double *given)
{
    add_row(jolts, model, time, row, model->constraints.own_jacobian, multiplier, given);
}

void tinker_jolts_add_rows(GArray *jolts, const TinkerModel *model, double time)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; row < all->rows; row++)
        if (all->blocks[row] >= 0) add_row(jolts, model, time, row, all->jacobian, all->lambda[row], NULL);
}
