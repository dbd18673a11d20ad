/* Products of the forces' derivatives with a vector: what implicit halves of a step and the forecast of a stable step need.
 * Line laws and fields give theirs exactly; the others' part is left out, which a forecast can bear and an implicit step
 * corrects in its next iteration. */
#include <math.h>
#include <string.h>

#include "physics/model-private.h"

/* A line's derivatives at the state in the points: along the line and across it. */
typedef struct {
    double x, y;   /* unit vector from a to b */
    double along;  /* N/m or N s/m */
    double across; /* N/m: T / L */
} LineDerivative;

static void add_line(const TinkerModel *model, int32_t a, int32_t b, const LineDerivative *line, const double *d,
                     double *force)
{
    double ax = a < model->bodies ? d[2 * a] : 0, ay = a < model->bodies ? d[2 * a + 1] : 0;
    double bx = b < model->bodies ? d[2 * b] : 0, by = b < model->bodies ? d[2 * b + 1] : 0;
    double dx = bx - ax, dy = by - ay;
    double along = line->along * (line->x * dx + line->y * dy), across = line->across * (line->x * dy - line->y * dx);
    double fx = along * line->x - across * line->y, fy = along * line->y + across * line->x;
    force[2 * a] += fx;
    force[2 * a + 1] += fy;
    force[2 * b] -= fx;
    force[2 * b + 1] -= fy;
}

static double geometry(const TinkerModel *model, int32_t a, int32_t b, LineDerivative *line, double *rate)
{
    const TinkerPoint *pa = &model->point[a], *pb = &model->point[b];
    double dx = pb->x - pa->x, dy = pb->y - pa->y, length = sqrt(dx * dx + dy * dy);
    double inverse = length > 0 ? 1.0 / length : 0.0;
    *line = (LineDerivative){dx * inverse, dy * inverse, 0, 0};
    *rate = line->x * (pb->vx - pa->vx) + line->y * (pb->vy - pa->vy);
    return length;
}

static void add_merged(const TinkerModel *model, gboolean damping, const double *d, double *force)
{
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < lines->count; i++) {
        LineDerivative line;
        double rate, length = geometry(model, lines->a[i], lines->b[i], &line, &rate);
        line.along = damping ? lines->damping[i] : lines->stiffness[i];
        if (!damping && length > 0)
            line.across = (lines->tension[i] + lines->stiffness[i] * (length - lines->length[i])) / length;
        add_line(model, lines->a[i], lines->b[i], &line, d, force);
    }
}

static void add_asked(TinkerModel *model, const TinkerAskedBatch *asked, gboolean damping, const double *d,
                      double *force)
{
    const TinkerLineLaw *law = asked->batch->block_class->physics->line_law;
    for (int32_t i = 0; i < asked->batch->count; i++) {
        int32_t a = asked->end_points[2 * i], b = asked->end_points[2 * i + 1];
        LineDerivative line;
        double rate, length = geometry(model, a, b, &line, &rate), by_length = 0, by_rate = 0;
        TinkerBatch view = tinker_model_view(model, asked->batch, i, 1, model->column_views);
        if (law->derivatives != NULL) {
            if (law->derivatives(&view, &length, &rate, &by_length, &by_rate) != TINKER_OK) continue;
        } else {
            double dl = 1e-6 * length, dr = 1e-6 * (fabs(rate) > 0 ? fabs(rate) : 1.0);
            double l[2] = {length - dl, length + dl}, r[2] = {rate - dr, rate + dr}, low, high;
            if (dl > 0 && law->tension(&view, &l[0], &rate, &low) == TINKER_OK &&
                law->tension(&view, &l[1], &rate, &high) == TINKER_OK)
                by_length = (high - low) / (2 * dl);
            if (law->tension(&view, &length, &r[0], &low) == TINKER_OK &&
                law->tension(&view, &length, &r[1], &high) == TINKER_OK)
                by_rate = (high - low) / (2 * dr);
        }
        line.along = damping ? by_rate : by_length;
        add_line(model, a, b, &line, d, force);
    }
}

/* A field without derivatives is left out. */
static void add_field(TinkerModel *model, const TinkerAskedBatch *asked, gboolean damping, const double *d,
                      double *force)
{
    const TinkerBlockBatch *batch = asked->batch;
    const TinkerField *field = batch->block_class->physics->field;
    double *jacobian = model->chunk; /* has room for 8 a body */
    TinkerBodies bodies = {sizeof(TinkerBodies), model->bodies, model->point, model->mass, 0, model->bodies};
    TinkerBatch view = tinker_model_view(model, batch, 0, batch->count, model->column_views);
    if (field->derivatives == NULL || field->derivatives(&view, &bodies, jacobian) != TINKER_OK) return;
    for (int32_t i = 0; i < model->bodies; i++) {
        const double *j = jacobian + 8 * (gsize)i + (damping ? 4 : 0);
        force[2 * i] += j[0] * d[2 * i] + j[1] * d[2 * i + 1];
        force[2 * i + 1] += j[2] * d[2 * i] + j[3] * d[2 * i + 1];
    }
}

static TinkerStatus product(TinkerModel *model, gboolean damping, const double *d, double *out)
{
    memset(model->force, 0, 2 * (gsize)model->points * sizeof(double));
    add_merged(model, damping, d, model->force);
    for (guint i = 0; i < model->asked_lines->len; i++)
        add_asked(model, &g_array_index(model->asked_lines, TinkerAskedBatch, i), damping, d, model->force);
    for (guint i = 0; i < model->asked_fields->len; i++)
        add_field(model, &g_array_index(model->asked_fields, TinkerAskedBatch, i), damping, d, model->force);
    for (int32_t i = 0; i < 2 * model->bodies; i++) {
        out[i] = model->force[i] * model->inverse_mass[i / 2];
        if (damping) out[i] -= model->field_drag * model->inverse_mass[i / 2] * d[i];
    }
    return TINKER_OK;
}

TinkerStatus tinker_model_damping_product(TinkerModel *model, const double *dv, double *out)
{
    return product(model, TRUE, dv, out);
}

TinkerStatus tinker_model_stiffness_product(TinkerModel *model, const double *dq, double *out)
{
    return product(model, FALSE, dq, out);
}
