/* Islands of bodies that turn on fixed axes, tied by gears, torsional springs and dampers: with theta_i the angle of
 * body i and w_i its weight, all bodies that gears tie together move by one coordinate x (m),
 *
 *     theta_i = theta_i(0) + w_i x,   sum(I_i w_i^2) x'' = torques, each times its weight.
 *
 * Gears give the ratios of the weights. Across a torsional spring or damper both weights are chosen alike, W, so that
 * it is an edge of stiffness k W^2, without a length; what it is turned by at the start is a constant load. Where these
 * choices contradict each other, as round a closed ring of shafts of several ratios, there is no such form. */
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "physics/line/shafts.h"
#include "physics/model/points.h"

/* Numbers the shafts, and gives every body its weight. */
static void number_shafts(TinkerLinearForm *form, TinkerShaftLook *look)
{
    const TinkerModel *model = form->model;
    TinkerShafts *shafts = form->shafts = g_new0(TinkerShafts, 1);
    shafts->shaft_of = g_new0(int32_t, model->bodies);
    shafts->weight = g_new0(double, model->bodies);
    shafts->leader = g_new0(int32_t, model->bodies);
    for (int32_t i = 0; i < model->bodies; i++) {
        const int32_t first = tinker_sets_first(look->geared, i),
                      root = tinker_shaft_weight(look, i, &shafts->weight[i]);
        shafts->weight[i] *= model->turns[model->turn_of[root]].by_gyration;
        if (first == i) shafts->leader[form->system.size++] = i;
        shafts->shaft_of[i] = first == i ? form->system.size - 1 : shafts->shaft_of[first];
        form->least_extent = fmax(form->least_extent, 2 / fabs(shafts->weight[i]));
    }
}

static void add_torsion(TinkerLinearForm *form, const TinkerTorsion *torsion)
{
    const TinkerShafts *shafts = form->shafts;
    const int32_t motors = tinker_model_book_index(form->model, TINKER_BOOK_MOTORS);
    const int32_t input =
        torsion->column >= 0 ? tinker_form_add_input(form, torsion->batch, torsion->column, torsion->row) : -1;
    TinkerLinearEdge edge = {-1, -1, 0, 0, 0, 0};
    for (int end = 0; end < 2; end++) {
        const int32_t body = torsion->body[end];
        if (body < 0) continue;
        const int32_t shaft = shafts->shaft_of[body];
        const double weight = shafts->weight[body], along = end == 0 ? weight : -weight;
        *(end == 0 ? &edge.a : &edge.b) = shaft;
        edge.stiffness = torsion->stiffness * weight * weight;
        edge.damping = torsion->damping * weight * weight;
        tinker_form_add_load(form, shaft, -1, along * torsion->stiffness * torsion->turned);
        if (input >= 0) tinker_form_drive(form, shaft, input, motors, along);
    }
    if (edge.a == edge.b || (edge.stiffness == 0 && edge.damping == 0)) return;
    form->edges[form->system.edge_count++] = edge;
}

static TinkerLinearForm *form_of(TinkerModel *model, TinkerShaftLook *look)
{
    TinkerLinearForm *form = g_new0(TinkerLinearForm, 1);
    form->model = model;
    form->one_coordinate = TRUE;
    number_shafts(form, look);
    tinker_form_allot(form, (gsize)look->torsions->len, 1);
    for (int32_t i = 0; i < model->bodies; i++) {
        const double moved = form->shafts->weight[i] * model->turns[model->turn_of[i]].gyration;
        form->mass[form->shafts->shaft_of[i]] += model->mass[i] * moved * moved;
    }
    form->system.anchor_count = 1; /* what stands, at 0 */
    for (guint i = 0; i < look->torsions->len; i++)
        add_torsion(form, &g_array_index(look->torsions, TinkerTorsion, i));
    tinker_form_close(form);
    return form;
}

TinkerLinearForm *tinker_shafts_form_new(TinkerModel *model)
{
    TinkerShaftLook look;
    TinkerLinearForm *form = tinker_find_shafts(model, &look) ? form_of(model, &look) : NULL;
    tinker_shaft_look_clear(&look);
    return form;
}

void tinker_shafts_free(TinkerShafts *shafts)
{
    if (shafts == NULL) return;
    g_free(shafts->shaft_of);
    g_free(shafts->weight);
    g_free(shafts->leader);
    g_free(shafts);
}

void tinker_shafts_expand(const TinkerLinearForm *form, const double *x, const double *u, double *q, double *v)
{
    const TinkerModel *model = form->model;
    memcpy(q, model->q_start, (gsize)model->coordinates * sizeof(double));
    memset(v, 0, (gsize)model->coordinates * sizeof(double));
    for (int32_t i = 0; i < model->bodies; i++) {
        const int32_t shaft = form->shafts->shaft_of[i], turn = tinker_model_turn_of(model, i);
        const double moved = form->shafts->weight[i] * model->turns[model->turn_of[i]].gyration;
        q[turn] += moved * x[shaft];
        v[turn] = moved * u[shaft];
    }
}

void tinker_shafts_reduce(const TinkerLinearForm *form, const double *q, const double *v, double *x, double *u)
{
    const TinkerModel *model = form->model;
    for (int32_t shaft = 0; shaft < form->system.size; shaft++) {
        const int32_t body = form->shafts->leader[shaft], turn = tinker_model_turn_of(model, body);
        const double moved = form->shafts->weight[body] * model->turns[model->turn_of[body]].gyration;
        x[shaft] = (q[turn] - model->q_start[turn]) / moved;
        u[shaft] = v[turn] / moved;
    }
}
