/* An acceleration is taken from the forces and not from velocities, so that it is that of the instant, on either side
 * of an impact too. */
#include "common/overlay/motion-vectors.h"

#include <glib/gi18n.h>
#include <math.h>

static const TinkerVectorLook looks[TINKER_VECTOR_KINDS] = {
    [TINKER_VECTOR_VELOCITY] = {TINKER_ARROW_MOTION, "v", N_("Velocity"), TINKER_DIMENSION_VELOCITY},
    [TINKER_VECTOR_ACCELERATION] = {TINKER_ARROW_ACCELERATION, "a", N_("Acceleration"), TINKER_DIMENSION_ACCELERATION},
    [TINKER_VECTOR_NET_FORCE] = {TINKER_ARROW_NET, "ΣF", N_("Net force"), TINKER_DIMENSION_FORCE},
};

const TinkerVectorLook *tinker_vector_look(TinkerVectorKind kind)
{
    return &looks[kind];
}

gboolean tinker_block_moves(TinkerScene *scene, TinkerBlockId block)
{
    return tinker_block_class_moves(tinker_scene_block_class(scene, block));
}

gboolean tinker_vector_choice_any(const TinkerVectorChoice *choice)
{
    gboolean any = FALSE;
    for (int k = 0; k < TINKER_VECTOR_KINDS; k++)
        any = any || choice->kinds[k];
    return any;
}

GArray *tinker_motion_vectors_array(void)
{
    return g_array_new(FALSE, FALSE, sizeof(TinkerMotionVector));
}

static void add(GArray *vectors, TinkerFrame *frame, TinkerBlockId body, TinkerVectorKind kind, double x, double y)
{
    TinkerMotionVector vector = {.of = body, .kind = kind, .value_x = x, .value_y = y};
    double orientation;
    tinker_frame_centre(frame, body, &vector.x, &vector.y, &orientation);
    g_array_append_val(vectors, vector);
}

void tinker_motion_vectors_add_velocity(GArray *vectors, TinkerFrame *frame, TinkerBlockId body, double vx, double vy)
{
    add(vectors, frame, body, TINKER_VECTOR_VELOCITY, vx, vy);
}

void tinker_motion_vectors_add_velocities(GArray *vectors, TinkerFrame *frame, TinkerSimulation *simulation)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId body = tinker_scene_block_at(scene, place);
        TinkerBodySample state;
        if (tinker_simulation_body(simulation, body, &state))
            tinker_motion_vectors_add_velocity(vectors, frame, body, state.vx, state.vy);
    }
}

void tinker_motion_vectors_add_forces(GArray *vectors, TinkerFrame *frame, const GArray *acting,
                                      const TinkerVectorChoice *wanted)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    if (!wanted->kinds[TINKER_VECTOR_ACCELERATION] && !wanted->kinds[TINKER_VECTOR_NET_FORCE]) return;
    g_autofree double *sums = g_new0(double, 2 * (gsize)tinker_scene_id_limit(scene) + 2);
    g_autofree gboolean *moves = g_new0(gboolean, (gsize)tinker_scene_id_limit(scene) + 1);
    for (guint i = 0; i < acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, i);
        if (!tinker_scene_has_block(scene, force->on) || !tinker_block_moves(scene, force->on)) continue;
        sums[2 * force->on] += force->fx;
        sums[2 * force->on + 1] += force->fy;
        moves[force->on] = TRUE;
    }
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId body = tinker_scene_block_at(scene, place);
        const double *sum = &sums[2 * body], mass = tinker_frame_meaning(frame, body, TINKER_MEANING_MASS, 0, NAN);
        if (!moves[body]) continue;
        if (wanted->kinds[TINKER_VECTOR_NET_FORCE]) add(vectors, frame, body, TINKER_VECTOR_NET_FORCE, sum[0], sum[1]);
        if (wanted->kinds[TINKER_VECTOR_ACCELERATION] && mass > 0)
            add(vectors, frame, body, TINKER_VECTOR_ACCELERATION, sum[0] / mass, sum[1] / mass);
    }
}

void tinker_motion_vectors_measure(const GArray *vectors, double greatest[TINKER_VECTOR_KINDS])
{
    for (guint i = 0; i < vectors->len; i++) {
        const TinkerMotionVector *vector = &g_array_index(vectors, TinkerMotionVector, i);
        const double size = hypot(vector->value_x, vector->value_y);
        if (isfinite(size)) greatest[vector->kind] = fmax(greatest[vector->kind], size);
    }
}

double tinker_motion_vectors_scale(double greatest, const TinkerView *view, double previous)
{
    const TinkerForceArrow longest = {.fx = greatest};
    if (!(greatest > 0)) return previous;
    return view->scale * tinker_arrows_scale(&longest, 1, view, previous / view->scale);
}
