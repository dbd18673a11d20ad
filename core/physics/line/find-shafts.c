/* Whether a model is one of shafts: pins, gears and torsional laws, one by one. */
#include "numerics/solve/disjoint-sets.h"
#include "physics/contact/contacts.h"
#include "physics/line/shafts.h"
#include "physics/line/tolerances.h"
#include "physics/model/angles.h"
#include "physics/model/breaks.h"
#include "physics/model/points.h"
#include "plugin/call/call.h"

static TinkerShaftLook look_new(const TinkerModel *model)
{
    const gsize n = (gsize)model->bodies;
    TinkerShaftLook look = {model,
                            g_new(int32_t, n),
                            g_new(int32_t, n),
                            g_new(double, n),
                            g_new(int32_t, n),
                            g_new0(gboolean, n),
                            g_array_new(FALSE, FALSE, sizeof(TinkerTorsion))};
    tinker_sets_begin(look.geared, model->bodies);
    tinker_sets_begin(look.parent, model->bodies);
    tinker_sets_begin(look.coaxial, model->bodies);
    for (gsize i = 0; i < n; i++)
        look.ratio[i] = 1;
    return look;
}

void tinker_shaft_look_clear(TinkerShaftLook *look)
{
    g_free(look->geared);
    g_free(look->parent);
    g_free(look->ratio);
    g_free(look->coaxial);
    g_free(look->pinned);
    g_array_unref(look->torsions);
}

int32_t tinker_shaft_weight(TinkerShaftLook *look, int32_t body, double *weight)
{
    *weight = 1;
    while (look->parent[body] != body) {
        const int32_t next = look->parent[body];
        look->ratio[body] *= look->ratio[next]; /* of the next but one; 1 where that is the last */
        look->parent[body] = look->parent[next];
        *weight *= look->ratio[body];
        body = look->parent[body];
    }
    return body;
}

/* weight of b = ratio * weight of a; FALSE where that contradicts what is known. */
static gboolean relate(TinkerShaftLook *look, int32_t a, int32_t b, double ratio)
{
    double of_a, of_b;
    const int32_t first = tinker_shaft_weight(look, a, &of_a), second = tinker_shaft_weight(look, b, &of_b);
    if (first == second) return fabs(of_b - ratio * of_a) <= TINKER_SAME_RATIO * fabs(of_b);
    look->parent[second] = first;
    look->ratio[second] = ratio * of_a / of_b;
    return TRUE;
}

/* The body whose turn a point is; -1: it is no body's. */
static int32_t body_of_turn(const TinkerModel *model, int32_t turn)
{
    return tinker_model_attachment(model, turn)->body;
}

/* Joints ----------------------------------------------------------------------------------------------------------- */

/* What keeps the two ends of a row of the batch at one place: centres at a support, or at each other. */
static gboolean look_at_pin(TinkerShaftLook *look, const TinkerConstraintBatch *part, int32_t row)
{
    const TinkerModel *model = look->model;
    const int32_t *ends = part->end_points + part->batch->end_offsets[row];
    const int32_t body = MIN(ends[0], ends[1]), other = MAX(ends[0], ends[1]);
    if (part->batch->end_offsets[row + 1] - part->batch->end_offsets[row] != 2 || body >= model->bodies) return FALSE;
    if (other < model->bodies)
        tinker_sets_join(look->coaxial, body, other);
    else if (other >= model->first_support)
        look->pinned[body] = TRUE;
    return other < model->bodies || other >= model->first_support;
}

static gboolean look_at_pins(TinkerShaftLook *look, const TinkerConstraintBatch *part)
{
    for (int32_t row = 0; row < part->batch->count; row++)
        if (!look_at_pin(look, part, row)) return FALSE;
    return TRUE;
}

/* Rows over the angles of two bodies, which those of a pin may come before. */
static gboolean look_at_gears(TinkerShaftLook *look, const TinkerConstraintBatch *part)
{
    TinkerBlockBatch *batch = part->batch;
    const TinkerConstraint *constraint = part->constraint;
    if (part->angles == NULL || constraint->turning == NULL || constraint->unilateral != 0 ||
        (constraint->rows != 1 && constraint->rows != 3))
        return FALSE;
    g_autofree double *factors = g_new0(double, MAX(batch->end_count, 1));
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    if (TINKER_CALL_BATCH(batch, "turning", &view, constraint->turning(&view, factors)) != TINKER_OK) return FALSE;
    for (int32_t row = 0; row < batch->count; row++) {
        int32_t found = 0, body[2];
        double factor[2];
        for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++) {
            const int32_t turned = body_of_turn(look->model, part->angles->turns[e]);
            if (turned < 0 || factors[e] == 0) continue;
            if (found == 2) return FALSE;
            body[found] = turned;
            factor[found++] = factors[e];
        }
        if (constraint->rows == 3 && !look_at_pin(look, part, row)) return FALSE;
        if (found < 2 || body[0] == body[1] || !relate(look, body[0], body[1], -factor[0] / factor[1])) return FALSE;
        tinker_sets_join(look->geared, body[0], body[1]);
    }
    return TRUE;
}

static gboolean look_at_joints(TinkerShaftLook *look)
{
    const TinkerConstraints *all = &look->model->constraints;
    if (all->straight != NULL && all->straight->len > 0) return FALSE;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (!(part->coincident ? look_at_pins(look, part) : look_at_gears(look, part))) return FALSE;
    }
    for (int32_t i = 0; i < look->model->bodies; i++)
        if (look->pinned[i]) look->pinned[tinker_sets_first(look->coaxial, i)] = TRUE;
    for (int32_t i = 0; i < look->model->bodies; i++)
        if (!look->pinned[tinker_sets_first(look->coaxial, i)] || tinker_model_turn_of(look->model, i) < 0)
            return FALSE;
    return TRUE;
}

/* Torsional laws --------------------------------------------------------------------------------------------------- */

/* rad, at the start. */
static double angle_at(const TinkerModel *model, int32_t turn)
{
    const TinkerAttachment *at = tinker_model_attachment(model, turn);
    return at->body >= 0 ? tinker_model_angle(model, at->body, model->q_start) : at->x;
}

static gboolean look_at_torsions(TinkerShaftLook *look, const TinkerAskedBatch *asked)
{
    TinkerBlockBatch *batch = asked->batch;
    const TinkerForceElement *element = batch->block_class->physics->force_element;
    if (asked->angles == NULL || element->torsion == NULL) return FALSE;
    const gsize count = (gsize)MAX(batch->count, 1);
    g_autofree double *values = g_new0(double, 3 * count);
    g_autofree int32_t *columns = g_new0(int32_t, count);
    double *stiffness = values, *damping = values + count, *rest = values + 2 * count;
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    if (TINKER_CALL_BATCH(batch, "torsion", &view, element->torsion(&view, stiffness, damping, rest, columns)) !=
        TINKER_OK)
        return FALSE;
    for (int32_t row = 0; row < batch->count; row++) {
        const int32_t first = batch->end_offsets[row], ends = batch->end_offsets[row + 1] - first;
        const int32_t *turns = asked->angles->turns + first;
        const gboolean has_wave = columns[row] >= 0;
        TinkerTorsion torsion = {
            {body_of_turn(look->model, turns[0]), ends > 1 ? body_of_turn(look->model, turns[1]) : -1}};
        torsion.stiffness = stiffness[row];
        torsion.damping = damping[row];
        torsion.batch = batch;
        torsion.column = columns[row];
        torsion.row = row;
        if (ends > 2 || (ends < 2 && (stiffness[row] != 0 || damping[row] != 0))) return FALSE;
        /* the books of the model go by the class, those of the form by what a law does */
        if (damping[row] != 0 && !element->dissipates) return FALSE;
        if (has_wave && element->dissipates) return FALSE;
        if (ends > 1) torsion.turned = angle_at(look->model, turns[1]) - angle_at(look->model, turns[0]) - rest[row];
        const gboolean ties =
            torsion.body[0] >= 0 && torsion.body[1] >= 0 && (stiffness[row] != 0 || damping[row] != 0);
        if (ties && !relate(look, torsion.body[0], torsion.body[1], 1)) return FALSE;
        g_array_append_val(look->torsions, torsion);
    }
    return TRUE;
}

static gboolean look_at_forces(TinkerShaftLook *look)
{
    for (guint i = 0; i < look->model->asked_forces->len; i++)
        if (!look_at_torsions(look, &g_array_index(look->model->asked_forces, TinkerAskedBatch, i))) return FALSE;
    return TRUE;
}

/* Whether nothing but joints and torsional laws acts on what turns. Uniform fields act at centres, which are held. */
static gboolean nothing_else_acts(const TinkerModel *model)
{
    return model->bodies > 0 && model->turning == model->bodies && model->moving_supports == 0 &&
           model->lines.count == 0 && model->asked_lines->len == 0 && model->asked_fields->len == 0 &&
           model->driven->len == 0 && model->constant_force == NULL &&
           (model->contacts == NULL || tinker_contacts_are_round(model->contacts));
}

/* Those of waveforms that have no form were looked for before. */
static gboolean have_signals(const TinkerShaftLook *look)
{
    for (guint i = 0; i < look->torsions->len; i++) {
        const TinkerTorsion *torsion = &g_array_index(look->torsions, TinkerTorsion, i);
        if (torsion->column < 0) continue;
        const TinkerWaveformEvaluator *evaluator =
            tinker_block_batch_evaluator(torsion->batch, torsion->column, torsion->row);
        if (evaluator == NULL || tinker_waveform_signals(evaluator) == 0) return FALSE;
    }
    return TRUE;
}

gboolean tinker_find_shafts(const TinkerModel *model, TinkerShaftLook *look)
{
    *look = look_new(model);
    return !tinker_model_is_struck(model) && nothing_else_acts(model) && look_at_joints(look) && look_at_forces(look) &&
           have_signals(look);
}
