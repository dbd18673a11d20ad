/* From break to break: waveforms are smooth inside a piece, and what jumps between two pieces is looked after here. */
#include <math.h>

#include "physics/simulation-private.h"

/* A support's place and speed may change by this much of the scales at a break without a rod feeling a jump. */
#define JUMP_TOLERANCE 1e-9

/* The block of a constraint that is attached to the point, or TINKER_NO_BLOCK. */
static TinkerBlockId constraint_at(const TinkerModel *model, int32_t point)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; row < all->rows; row++)
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            if (all->points[e] == point) return all->blocks[row];
    return TINKER_NO_BLOCK;
}

static gboolean refuse_jump(TinkerSimulation *simulation, int32_t support, TinkerBlockId felt_by, GError **error)
{
    TinkerModel *model = simulation->model;
    TinkerBlockId block = g_array_index(model->support_points, TinkerSupportPoint, support).support;
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
        "%s: its motion jumps at t = %.10g s, which %s cannot follow (give it a motion without a jump in place or "
        "speed, or use a spring)",
        tinker_scene_block_name(model->scene, block), simulation->state.t,
        tinker_scene_block_name(model->scene, felt_by));
    return FALSE;
}

static gboolean check_jumps(TinkerSimulation *simulation, const TinkerPoint *before, GError **error)
{
    TinkerModel *model = simulation->model;
    double extent, speed;
    simulation->system.system.scales(&simulation->system, simulation->state.q, simulation->state.v, &extent, &speed);
    for (guint i = 0; i < model->support_points->len; i++) {
        if (!g_array_index(model->support_points, TinkerSupportPoint, i).moving) continue;
        const TinkerPoint *now = &model->point[model->bodies + (int32_t)i];
        gboolean jumps = hypot(now->x - before[i].x, now->y - before[i].y) > JUMP_TOLERANCE * extent ||
                         hypot(now->vx - before[i].vx, now->vy - before[i].vy) > JUMP_TOLERANCE * MAX(speed, extent);
        TinkerBlockId felt_by = jumps ? constraint_at(model, model->bodies + (int32_t)i) : TINKER_NO_BLOCK;
        if (felt_by != TINKER_NO_BLOCK) return refuse_jump(simulation, (int32_t)i, felt_by, error);
    }
    return TRUE;
}

static double potential(TinkerSimulation *simulation)
{
    TinkerModel *model = simulation->model;
    TinkerEnergy energy = {0};
    tinker_model_set_state(model, simulation->state.q, simulation->state.v);
    return tinker_model_energy(model, &energy) == TINKER_OK ? energy.potential : 0;
}

/* A support that jumps stretches springs at once: that work belongs to its motion. */
static void book_jump(TinkerSimulation *simulation, double gain)
{
    for (int32_t i = 0; i < simulation->system.system.books; i++)
        if (simulation->system.book_of[i] == TINKER_BOOK_SUPPORT_MOTION) simulation->state.books[i] += gain;
}

gboolean tinker_simulation_enter_piece(TinkerSimulation *simulation, double horizon, GError **error)
{
    TinkerModel *model = simulation->model;
    double t = simulation->state.t, next = tinker_model_next_break(model, t, horizon);
    simulation->ends_on_break = isfinite(next);
    simulation->piece_end = simulation->ends_on_break ? next : horizon;
    double inside = simulation->piece_end > t ? 0.5 * (t + simulation->piece_end) : t + 0.5;
    gboolean moving = model->moving_supports > 0;
    guint supports = model->support_points->len;
    g_autofree TinkerPoint *before =
        moving ? g_memdup2(model->point + model->bodies, supports * sizeof(TinkerPoint)) : NULL;
    double stored = 0;
    if (moving && t > 0) {
        if (tinker_model_set_time(model, t) != TINKER_OK)
            return tinker_simulation_fail(simulation, model->failure, error);
        for (guint i = 0; i < supports; i++)
            before[i] = model->point[model->bodies + (int32_t)i];
        stored = potential(simulation);
    }
    tinker_model_enter_piece(model, inside);
    if (tinker_model_set_time(model, t) != TINKER_OK) return tinker_simulation_fail(simulation, model->failure, error);
    if (moving && t > 0) {
        if (!check_jumps(simulation, before, error)) return FALSE;
        book_jump(simulation, potential(simulation) - stored);
    }
    simulation->method->restart(simulation->stepper);
    return TRUE;
}
