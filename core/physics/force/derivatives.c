/* The derivatives of a line whose plugin is asked. */
#include "physics/force/derivatives.h"
#include "physics/force/tolerances.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"

#define MOST_SLOPES 10

typedef struct {
    const TinkerBlockBatch *batch;
    TinkerBatch *view;
    const TinkerLineLaw *law;
    double length, rate;
    double reach; /* m: how far its ends are from the origin */
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

/* dT/dL at length 0 where T is 0, from lengths above it alone: (4 T(h) - T(2 h)) / 2 h is good to h^2. No length is
 * known to measure h by but how far the line is from the origin, so h shrinks until the slope settles. One that does
 * not goes to 0, as of L^3, or to infinity, as of the root of L. */
static TinkerStatus slope_at_zero(const Asked *asked, double *slope)
{
    double h = TINKER_LAW_STEP * (asked->reach > 0 ? asked->reach : 1.0), least = TINKER_SLOPE_UNSETTLED, first = NAN,
           last = NAN;
    for (int k = 0; k < MOST_SLOPES && least > TINKER_SLOPE_SETTLED; k++, h *= 0.1) {
        double length[2] = {h, 2 * h}, tension[2];
        for (int i = 0; i < 2; i++) {
            TinkerStatus status = ask_tension(asked, &length[i], &asked->rate, &tension[i]);
            if (status != TINKER_OK) return status;
        }
        double value = (4 * tension[0] - tension[1]) / (2 * h);
        double change = value == last ? 0 : fabs(value - last) / fabs(value);
        if (k == 0) first = value;
        last = value;
        if (!(change < least)) continue;
        least = change;
        *slope = value;
    }
    if (least == TINKER_SLOPE_UNSETTLED) *slope = fabs(last) < fabs(first) ? 0 : INFINITY;
    return TINKER_OK;
}

/* dT/dL and dT/drate by differences. */
static TinkerStatus differences(const Asked *asked, double tension, double *by_length, double *by_rate)
{
    TinkerStatus status = TINKER_OK;
    *by_length = 0;
    if (asked->length > 0)
        status = difference(asked, TINKER_LAW_STEP * asked->length, 0, by_length);
    else if (tension == 0)
        status = slope_at_zero(asked, by_length);
    if (status != TINKER_OK) return status;
    return difference(asked, 0, TINKER_LAW_STEP * fmax(fabs(asked->rate), 1.0), by_rate);
}

static TinkerStatus ask(const Asked *asked, TinkerLineDerivatives *line)
{
    double tension, along, damping;
    TinkerStatus status = ask_tension(asked, &asked->length, &asked->rate, &tension);
    if (status != TINKER_OK) return status;
    if (asked->law->derivatives != NULL)
        status =
            TINKER_CALL_BATCH(asked->batch, "derivatives", asked->view,
                              asked->law->derivatives(asked->view, &asked->length, &asked->rate, &along, &damping));
    else
        status = differences(asked, tension, &along, &damping);
    if (status != TINKER_OK) return status;
    if (asked->length > 0) {
        line->along = along;
        line->damping = damping;
        line->across = tension / asked->length;
    } else {
        tinker_line_at_one_place(line, tension, along, damping);
    }
    return TINKER_OK;
}

TinkerStatus tinker_asked_line_derivatives(TinkerModel *model, const TinkerAskedBatch *asked, int32_t row,
                                           TinkerLineDerivatives *line)
{
    const TinkerBlockBatch *batch = asked->batch;
    const int32_t *ends = asked->end_points + 2 * (gsize)row;
    TinkerBatch view = tinker_model_view(model, batch, row, 1, model->column_views);
    Asked law = {.batch = batch, .view = &view, .law = batch->block_class->physics->line_law};
    law.rate = tinker_line_geometry(model, ends[0], ends[1], line);
    law.length = line->length;
    law.reach = hypot(model->point[ends[0]].x, model->point[ends[0]].y);
    TinkerStatus status = ask(&law, line);
    if (status == TINKER_RETRY_SMALLER) return status;
    if (status != TINKER_OK) return tinker_model_fail(model, batch, row, "tension", view.failure);
    if (!isfinite(line->along + line->across + line->damping))
        return tinker_model_not_finite(model, batch, row, "stiffness or damping");
    return TINKER_OK;
}
