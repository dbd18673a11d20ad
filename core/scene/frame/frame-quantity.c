/* Asks the graph interface about a batch of one block. What a run would know, and a frame does not, is left out: the
 * interface's functions answer that it is not known yet. */
#include "scene/frame/frame-quantity.h"

#include <math.h>

#include "plugin/call/call.h"
#include "plugin/call/guarded.h"
#include "plugin/call/process-state.h"

/* A batch of one, and the memory that it points to. */
typedef struct {
    TinkerBatch batch;
    const double **columns;
    TinkerPoint *points; /* its ends; of a body, its own centre */
    int32_t point_count;
    TinkerPose *poses;
    double *forces, *torques;
    int32_t *has_angle;
    void *scratch;
} Single;

static void single_clear(Single *single)
{
    g_free(single->columns);
    g_free(single->points);
    g_free(single->forces);
    g_free(single->poses);
    g_free(single->torques);
    g_free(single->has_angle);
    tinker_guarded_free(single->scratch);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Single, single_clear)

/* Where the block's ends are, whatever lane it is drawn in; FALSE where one is loose. */
static gboolean fill_points(Single *single, TinkerFrame *frame, TinkerBlockId block, const TinkerInstance *instance)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    single->point_count = MAX(instance->ends, 1);
    single->points = g_new0(TinkerPoint, single->point_count);
    if (instance->ends == 0) single->points[0] = (TinkerPoint){instance->x, instance->y, 0, 0};
    for (int32_t k = 0; k < instance->ends; k++) {
        double place[2];
        TinkerSceneEnd end = tinker_scene_end(scene, block, k);
        if (end.block == TINKER_NO_BLOCK) return FALSE;
        tinker_frame_end(frame, end, place);
        single->points[k] = (TinkerPoint){place[0], place[1], 0, 0};
    }
    return TRUE;
}

static void fill_batch(Single *single, const TinkerFrame *frame, const TinkerBlockClass *block_class,
                       const TinkerInstance *instance)
{
    single->columns = g_new(const double *, MAX(block_class->column_count, 1));
    for (int32_t c = 0; c < block_class->column_count; c++)
        single->columns[c] = instance->columns + c;
    const TinkerPhysics *physics = block_class->physics;
    if (physics != NULL && physics->scratch_size > 0)
        single->scratch = tinker_guarded_new((gsize)physics->scratch_size, block_class);
    single->batch = (TinkerBatch){
        .struct_size = sizeof(TinkerBatch),
        .count = 1,
        .ends = instance->ends,
        .columns = single->columns,
        .scratch = single->scratch,
        .time = tinker_frame_time(frame),
    };
}

static const char *name_of_single(const void *name, int32_t row)
{
    return name;
}

#define CALL_SINGLE(block_name, function, call)                                                                        \
    TINKER_CALL(call, .phase = (function), .block_class = block_class, .batch = &single.batch, .name = name_of_single, \
                .source = (block_name))

/* As placed: of a body its own, of a connector those of what its ends are on. */
static void fill_poses(Single *single, const TinkerFrame *frame, TinkerBlockId block, const TinkerInstance *instance)
{
    const gsize count = (gsize)MAX(single->point_count, 1);
    single->poses = g_new0(TinkerPose, count);
    single->torques = g_new0(double, count);
    single->batch.poses = single->batch.placed_poses = single->poses;
    single->batch.placed = single->points;
    single->batch.angular = single->torques;
    single->batch.placed_columns = single->columns;
    single->batch.has_angle = single->has_angle = g_new0(int32_t, count);
    for (int32_t k = 0; k < (int32_t)count; k++) {
        const TinkerBlockId on =
            instance->ends > 0 ? tinker_scene_end(tinker_frame_scene(frame), block, k).block : block;
        double x, y;
        const TinkerBlockClass *c = tinker_scene_block_class(tinker_frame_scene(frame), on);
        single->has_angle[k] = tinker_block_class_has_angle(c);
        tinker_frame_centre(frame, on, &x, &y, &single->poses[k].angle);
        single->poses[k].rate = tinker_frame_meaning(frame, on, TINKER_MEANING_ANGULAR_VELOCITY, 0, 0);
    }
}

gboolean tinker_frame_quantity(TinkerFrame *frame, TinkerBlockId block, int32_t quantity, double *value)
{
    TinkerInstance instance;
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    if (block_class == NULL || block_class->graph == NULL || !tinker_frame_instance(frame, block, &instance))
        return FALSE;
    g_auto(Single) single = {0};
    if (!fill_points(&single, frame, block, &instance)) return FALSE;
    fill_batch(&single, frame, block_class, &instance);
    const TinkerPhysics *physics = block_class->physics;
    if (physics != NULL && physics->prepare != NULL &&
        CALL_SINGLE(instance.name, "prepare", tinker_prepare(physics, &single.batch)) != TINKER_OK)
        return FALSE;

    fill_poses(&single, frame, block, &instance);
    TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput), .ends = single.points, .poses = single.poses};
    if (physics != NULL && physics->force_element != NULL) {
        single.forces = g_new0(double, 2 * (gsize)single.point_count);
        if (CALL_SINGLE(instance.name, "force",
                        physics->force_element->force(&single.batch, single.points, single.forces)) == TINKER_OK)
            input.forces = single.forces;
        if (input.forces != NULL && physics->force_element->angles != 0) input.torques = single.torques;
    }
    double result = NAN;
    TinkerStatus status =
        CALL_SINGLE(instance.name, "values", block_class->graph->values(&single.batch, &input, quantity, &result));
    if (status != TINKER_OK || !isfinite(result)) return FALSE;
    *value = result;
    return TRUE;
}
