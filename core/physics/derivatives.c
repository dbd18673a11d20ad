/* The derivatives of a line whose plugin is asked. */
#include "physics/derivatives-private.h"

/* Of a length or a rate: rounding and curvature both stay some nine digits below the law. */
#define DIFFERENCE 1e-6

typedef struct {
    const TinkerBlockBatch *batch;
    TinkerBatch *view;
    const TinkerLineLaw *law;
    double length, rate;
} Asked;

static TinkerStatus ask_tension(const Asked *asked, const double *length, const double *rate, double *tension)
{
    return TINKER_CALL_BATCH(asked->batch, "tension", asked->view,
                             asked->law->tension(asked->view, length, rate, tension));
}

/* (T(+) - T(-)) / 2 over a change of the length or of the rate. */
static TinkerStatus difference(const Asked *asked, double dl, double dr, double *derivative)
{
    double length[2] = {asked->length - dl, asked->length + dl}, rate[2] = {asked->rate - dr, asked->rate + dr};
    double low, high;
    TinkerStatus status = ask_tension(asked, &length[0], &rate[0], &low);
    if (status == TINKER_OK) status = ask_tension(asked, &length[1], &rate[1], &high);
    if (status == TINKER_OK) *derivative = (high - low) / (2 * (dl + dr));
    return status;
}

static TinkerStatus ask(const Asked *asked, TinkerLineDerivatives *line)
{
    double tension;
    TinkerStatus status = ask_tension(asked, &asked->length, &asked->rate, &tension);
    if (status != TINKER_OK) return status;
    line->across = asked->length > 0 ? tension / asked->length : 0;
    if (asked->law->derivatives != NULL)
        return TINKER_CALL_BATCH(
            asked->batch, "derivatives", asked->view,
            asked->law->derivatives(asked->view, &asked->length, &asked->rate, &line->along, &line->damping));
    if (asked->length > 0) status = difference(asked, DIFFERENCE * asked->length, 0, &line->along);
    if (status != TINKER_OK) return status;
    return difference(asked, 0, DIFFERENCE * fmax(fabs(asked->rate), 1.0), &line->damping);
}

TinkerStatus tinker_asked_line_derivatives(TinkerModel *model, const TinkerAskedBatch *asked, int32_t row,
                                           TinkerLineDerivatives *line)
{
    const TinkerBlockBatch *batch = asked->batch;
    const int32_t *ends = asked->end_points + 2 * (gsize)row;
    TinkerBatch view = tinker_model_view(model, batch, row, 1, model->column_views);
    Asked law = {.batch = batch, .view = &view, .law = batch->block_class->physics->line_law};
    law.length = tinker_line_geometry(model, ends[0], ends[1], line, &law.rate);
    TinkerStatus status = ask(&law, line);
    if (status == TINKER_RETRY_SMALLER) return status;
    if (status != TINKER_OK) return tinker_model_fail(model, batch, row, "tension", view.failure);
    if (!isfinite(line->along + line->across + line->damping))
        return tinker_model_not_finite(model, batch, row, "stiffness or damping");
    return TINKER_OK;
}
