/* Compiling, first part: bodies that can move become coordinates. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/compile/compile-private.h"
#include "physics/model/model-data.h"

static const TinkerBody *body_of(const TinkerBlockBatch *batch)
{
    return batch->block_class->physics != NULL ? batch->block_class->physics->body : NULL;
}

static gboolean check_class(const TinkerBlockBatch *batch, GError **error)
{
    const TinkerBlockClass *block_class = batch->block_class;
    const char *lacks = NULL;
    if (body_of(batch) == NULL) return TRUE;
    if (tinker_block_class_meaning_column(block_class, TINKER_MEANING_POSITION) < 0)
        lacks = _("a property that means its position");
    else if (body_of(batch)->degrees_of_freedom >= 2 &&
             tinker_block_class_meaning_column(block_class, TINKER_MEANING_MASS) < 0)
        lacks = _("a property that means its mass");
    else if (body_of(batch)->degrees_of_freedom == 3 &&
             tinker_block_class_meaning_column(block_class, TINKER_MEANING_INERTIA) < 0)
        lacks = _("a property that means its inertia");
    else if (!(body_of(batch)->degrees_of_freedom == 0 || body_of(batch)->degrees_of_freedom == 2 ||
               body_of(batch)->degrees_of_freedom == 3))
        lacks = _("a number of degrees of freedom that there is (0, 2 or 3)");
    if (lacks == NULL) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_PLUGIN,
                _("the block type \"%s\" cannot be run: its plugin %s lacks %s"), block_class->type->id,
                block_class->path, lacks);
    return FALSE;
}

/* By number of a block: whether it can move, or something hangs on it. */
static gboolean *find_reach(const TinkerModel *model)
{
    gboolean *within = g_new0(gboolean, MAX(tinker_block_index_count(model->numbers), 1));
    int32_t number = 0;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        gboolean can_move = body_of(batch) != NULL && body_of(batch)->degrees_of_freedom > 0;
        for (int32_t row = 0; row < batch->count; row++, number++)
            within[number] |= can_move;
        for (int32_t e = 0; physics != NULL && physics->motion == NULL && e < batch->end_count; e++)
            within[tinker_block_index_find(model->numbers, batch->end[e].block)] = TRUE;
    }
    return within;
}

/* The origin is moved only where what is stepped lies far away from it, and to a place with few bits, so that the
 * subtraction is exact. Supports that nothing hangs on have no say in it. */
static void find_origin(TinkerModel *model)
{
    g_autofree gboolean *within = find_reach(model);
    double least[2] = {INFINITY, INFINITY}, greatest[2] = {-INFINITY, -INFINITY};
    const gboolean *counts = within;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; body_of(batch) != NULL && row < batch->count; row++)
            for (int32_t k = 0; counts[row] && k < 2; k++) {
                double place = tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, k, 0);
                least[k] = MIN(least[k], place);
                greatest[k] = MAX(greatest[k], place);
            }
        counts += batch->count;
    }
    double extent = MAX(greatest[0] - least[0], greatest[1] - least[1]);
    if (!(extent > 0) || !isfinite(extent)) return;
    double grain = exp2(ceil(log2(extent)));
    for (int32_t k = 0; k < 2; k++) {
        double centre = 0.5 * (least[k] + greatest[k]);
        double grains = nearbyint(centre / grain); /* infinite for a scene that is a speck in one direction */
        if (fabs(centre) > 8.0 * extent && isfinite(grains)) model->origin[k] = grain * grains;
    }
}

static void set_centre(TinkerModel *model, TinkerBlockId block, int32_t point)
{
    model->centre_point[tinker_block_index_find(model->numbers, block)] = point;
}

/* Turns are numbered in the order of their bodies. */
static void add_turn(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, int32_t body)
{
    const double inertia = tinker_block_batch_meaning(batch, row, TINKER_MEANING_INERTIA, 0, 1.0);
    const int32_t number = model->turning++, coordinate = 2 * model->bodies + number;
    const double gyration = sqrt(inertia / model->mass[body]);
    model->turn_of[body] = number;
    model->turns[number] =
        (TinkerTurn){.body = body, .gyration = gyration, .by_gyration = 1 / gyration, .place = NAN, .cosine = 1};
    model->coordinate_mass[coordinate] = model->mass[body];
    model->q_start[coordinate] = gyration * tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0.0);
    model->v_start[coordinate] =
        gyration * tinker_block_batch_meaning(batch, row, TINKER_MEANING_ANGULAR_VELOCITY, 0, 0.0);
}

static void add_body(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, int32_t number)
{
    double mass = tinker_block_batch_meaning(batch, row, TINKER_MEANING_MASS, 0, 1.0);
    model->body_blocks[number] = batch->ids[row];
    model->mass[number] = mass;
    model->inverse_mass[number] = 1.0 / mass;
    for (int32_t k = 0; k < 2; k++) {
        model->coordinate_mass[2 * number + k] = mass;
        model->q_start[2 * number + k] =
            tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, k, 0) - model->origin[k];
        model->v_start[2 * number + k] = tinker_block_batch_meaning(batch, row, TINKER_MEANING_VELOCITY, k, 0);
    }
    set_centre(model, batch->ids[row], number);
    if (body_of(batch)->degrees_of_freedom == 3) add_turn(model, batch, row, number);
}

static void allot_bodies(TinkerModel *model, int32_t turning)
{
    gsize n = (gsize)MAX(model->bodies, 1), coordinates = 2 * n + (gsize)turning;
    model->coordinates = 2 * model->bodies + turning;
    model->body_blocks = g_new0(TinkerBlockId, n);
    model->of_bodies = g_new0(double, 2 * n + 4 * coordinates);
    model->mass = model->of_bodies;
    model->inverse_mass = model->mass + n;
    model->coordinate_mass = model->inverse_mass + n;
    model->q_start = model->coordinate_mass + coordinates;
    model->v_start = model->q_start + coordinates;
    model->constant_acceleration = model->v_start + coordinates;
    if (turning == 0) return;
    model->turns = g_new0(TinkerTurn, turning);
    model->turn_of = g_new(int32_t, n);
    memset(model->turn_of, 0xff, n * sizeof(int32_t));
}

static void add_bodies(TinkerModel *model)
{
    int32_t turning = 0, number = 0;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const int32_t freedoms = body_of(batch) != NULL ? body_of(batch)->degrees_of_freedom : 0;
        if (freedoms > 0) model->bodies += batch->count;
        if (freedoms == 3) turning += batch->count;
    }
    allot_bodies(model, turning);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (body_of(batch) == NULL || body_of(batch)->degrees_of_freedom == 0) continue;
        for (int32_t row = 0; row < batch->count; row++)
            add_body(model, batch, row, number++);
    }
    model->points = model->first_attachment = number + (turning + 1) / 2;
}

static gboolean check_masses(const TinkerModel *model, GError **error)
{
    for (int32_t i = 0; i < model->bodies; i++) {
        if (isfinite(model->mass[i]) && isfinite(model->inverse_mass[i])) continue;
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                    _("%s: its mass is %g kg, whose reciprocal no number can hold (give it at least 1e-300 kg)"),
                    tinker_scene_block_name(model->scene, model->body_blocks[i]), model->mass[i]);
        return FALSE;
    }
    for (int32_t k = 0; k < model->turning; k++) {
        const TinkerTurn *turn = &model->turns[k];
        if (isnormal(turn->gyration) && isfinite(1 / turn->gyration)) continue;
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
            _("%s: with its inertia its radius of gyration is %g m, which nothing can be reckoned with (give it "
              "an inertia above 0, or leave it out)"),
            tinker_scene_block_name(model->scene, model->body_blocks[turn->body]), turn->gyration);
        return FALSE;
    }
    return TRUE;
}

gboolean tinker_model_compile_bodies(TinkerModel *model, GError **error)
{
    for (guint i = 0; i < model->batches->len; i++)
        if (!check_class(g_ptr_array_index(model->batches, i), error)) return FALSE;
    model->numbers = tinker_block_index_of_batches(model->batches);
    const int32_t blocks = tinker_block_index_count(model->numbers);
    model->centre_point = g_new(int32_t, MAX(blocks, 1));
    for (int32_t i = 0; i < blocks; i++)
        model->centre_point[i] = -1;
    find_origin(model);
    add_bodies(model);
    return check_masses(model, error);
}
