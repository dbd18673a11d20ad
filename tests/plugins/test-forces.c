/* Motor, support motion, gravity and wind against their laws; what a support refuses. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "plugin-fixture.h"

#define BODIES 23
#define PI     3.14159265358979323846

typedef struct {
    TinkerPoint points[BODIES];
    double masses[BODIES];
} Crowd;

static void crowd_init(Crowd *crowd)
{
    for (int i = 0; i < BODIES; i++) {
        crowd->points[i] = (TinkerPoint){random_value(), random_value(), random_value(), random_value()};
        crowd->masses[i] = fabs(random_value());
    }
}

static TinkerBodies crowd_range(const Crowd *crowd, int first, int range)
{
    return (TinkerBodies){sizeof(TinkerBodies), BODIES, crowd->points, crowd->masses, first, range};
}

static const TinkerField *field_of(const char *name)
{
    const TinkerField *field = block_physics(block_open(name))->field;
    g_assert_nonnull(field);
    g_assert_cmpint(field->couples_bodies, ==, 0);
    return field;
}

static void field_force(BlockBatch *batch, const Crowd *crowd, double *force)
{
    TinkerBatch view = block_batch_view(batch, 0, batch->count);
    const TinkerBodies bodies = crowd_range(crowd, 0, BODIES);
    g_assert_cmpint(field_of(batch->block->id)->force(&view, &bodies, force), ==, TINKER_OK);
}

/* Two instances with random properties. */
static BlockBatch *random_field(const char *name)
{
    BlockBatch *batch = block_batch_new(block_open(name), 2);
    for (int32_t column = 0; column < block_columns(batch->block); column++) {
        for (int i = 0; i < 2; i++) {
            batch->columns[column][i] = fabs(random_value());
        }
    }
    return batch;
}

static void test_gravity_points_straight_down(void)
{
    Crowd crowd;
    double force[2 * BODIES];
    crowd_init(&crowd);
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("gravity"), 1);
    field_force(batch, &crowd, force);
    for (int i = 0; i < BODIES; i++) {
        g_assert_cmpfloat(force[2 * i], ==, 0);
        g_assert_cmpfloat(force[2 * i + 1], ==, -9.81 * crowd.masses[i]);
    }
}

static void test_gravities_add_up(void)
{
    Crowd crowd;
    double force[2 * BODIES];
    crowd_init(&crowd);
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("gravity"), 2);
    block_batch_set(batch, 1, "acceleration", 0, 4);
    block_batch_set(batch, 1, "angle", 0, PI / 3);
    field_force(batch, &crowd, force);
    for (int i = 0; i < BODIES; i++) {
        assert_close(force[2 * i], 2 * crowd.masses[i], 1e-15);
        assert_close(force[2 * i + 1], (2 * sqrt(3) - 9.81) * crowd.masses[i], 1e-15);
    }
}

/* Force = -gradient of the energy: it is linear in place, so differences over any step are exact but for rounding. */
static void test_gravity_energy(void)
{
    Crowd crowd;
    double force[2 * BODIES], at, moved;
    crowd_init(&crowd);
    g_autoptr(BlockBatch) batch = random_field("gravity");
    field_force(batch, &crowd, force);
    TinkerBatch view = block_batch_view(batch, 0, 2);
    const TinkerBodies bodies = crowd_range(&crowd, 5, 1); /* the energy is that of all, whatever the range */
    const TinkerField *field = field_of("gravity");
    for (int k = 0; k < 2 * BODIES; k++) {
        double *place = k % 2 == 0 ? &crowd.points[k / 2].x : &crowd.points[k / 2].y;
        const double was = *place;
        g_assert_cmpint(field->energy(&view, &bodies, &at), ==, TINKER_OK);
        *place = was + 4096;
        g_assert_cmpint(field->energy(&view, &bodies, &moved), ==, TINKER_OK);
        *place = was;
        double scale = 0;
        for (int i = 0; i < BODIES; i++) {
            scale += crowd.masses[i] * (fabs(crowd.points[i].x) + fabs(crowd.points[i].y) + 4096);
        }
        scale *= batch->columns[0][0] + batch->columns[0][1];
        g_assert_cmpfloat_with_epsilon((moved - at) / 4096, -force[k], 1e-13 * scale / 4096);
    }
}

/* A mass at rest in a wind of 3-4-5: linear drag 2 * 5 along it, quadratic 0.5 * 25. */
static void test_wind_law(void)
{
    Crowd crowd = {0};
    double force[2 * BODIES];
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("wind"), 1);
    block_batch_set(batch, 0, "velocity", 0, 3);
    block_batch_set(batch, 0, "velocity", 1, 4);
    block_batch_set(batch, 0, "drag", 0, 2);
    crowd.points[1] = (TinkerPoint){7, 8, 3, 4};
    crowd.points[2] = (TinkerPoint){0, 0, 6, 8};
    field_force(batch, &crowd, force);
    const double linear[6] = {6, 8, 0, 0, -6, -8};
    g_assert_cmpmem(force, sizeof linear, linear, sizeof linear);
    block_batch_set(batch, 0, "drag", 0, 0);
    block_batch_set(batch, 0, "drag_quadratic", 0, 0.5);
    field_force(batch, &crowd, force);
    const double quadratic[6] = {7.5, 10, 0, 0, -7.5, -10};
    g_assert_cmpmem(force, sizeof quadratic, quadratic, sizeof quadratic);
}

/* Forces of both linear fields, rebuilt from their linear form. */
static void test_linear_fields(gconstpointer data)
{
    Crowd crowd;
    double force[2 * BODIES];
    TinkerLinearField law[2];
    crowd_init(&crowd);
    g_autoptr(BlockBatch) batch = random_field(data);
    const gboolean is_wind = strcmp(data, "wind") == 0;
    TinkerBatch view = block_batch_view(batch, 0, 2);
    if (is_wind) {
        g_assert_cmpint(field_of(data)->linear(&view, law), ==, TINKER_RETRY_SMALLER);
        block_batch_set(batch, 0, "drag_quadratic", 0, 0);
        g_assert_cmpint(field_of(data)->linear(&view, law), ==, TINKER_RETRY_SMALLER);
        block_batch_set(batch, 1, "drag_quadratic", 0, 0);
    }
    g_assert_cmpint(field_of(data)->linear(&view, law), ==, TINKER_OK);
    field_force(batch, &crowd, force);
    for (int i = 0; i < BODIES; i++) {
        const double velocity[2] = {crowd.points[i].vx, crowd.points[i].vy};
        for (int axis = 0; axis < 2; axis++) {
            double sum = 0, scale = 0;
            for (int k = 0; k < 2; k++) {
                const double weight = crowd.masses[i] * law[k].acceleration[axis], drag = law[k].drag * velocity[axis];
                sum += weight + law[k].force[axis] - drag;
                scale += fabs(weight) + fabs(law[k].force[axis]) + fabs(drag);
            }
            g_assert_cmpfloat_with_epsilon(sum, force[2 * i + axis], 4 * DBL_EPSILON * scale);
        }
    }
}

/* The Jacobian against central differences in place and velocity. All move fast against the air, where the differences'
 * own error, c2 step^2 / (6 |u|), is small; c2 |u| u is not smooth where u is 0. */
static void test_field_derivatives(gconstpointer data)
{
    Crowd crowd;
    double jacobian[8 * BODIES], up[2 * BODIES], down[2 * BODIES];
    crowd_init(&crowd);
    for (int i = 0; i < BODIES; i++) {
        crowd.points[i].vx += 4000;
        crowd.points[i].vy -= 3000;
    }
    g_autoptr(BlockBatch) batch = random_field(data);
    TinkerBatch view = block_batch_view(batch, 0, 2);
    const TinkerBodies bodies = crowd_range(&crowd, 0, BODIES);
    g_assert_cmpint(field_of(data)->derivatives(&view, &bodies, jacobian), ==, TINKER_OK);
    for (int variable = 0; variable < 4; variable++) {
        const double step = 0.125;
        Crowd higher = crowd, lower = crowd;
        for (int i = 0; i < BODIES; i++) {
            double *const above[4] = {&higher.points[i].x, &higher.points[i].y, &higher.points[i].vx,
                                      &higher.points[i].vy};
            double *const below[4] = {&lower.points[i].x, &lower.points[i].y, &lower.points[i].vx, &lower.points[i].vy};
            *above[variable] += step;
            *below[variable] -= step;
        }
        field_force(batch, &higher, up);
        field_force(batch, &lower, down);
        for (int k = 0; k < 2 * BODIES; k++) {
            const int column = 8 * (k / 2) + (variable < 2 ? 0 : 4) + 2 * (k % 2) + variable % 2;
            g_assert_cmpfloat_with_epsilon((up[k] - down[k]) / (2 * step), jacobian[column],
                                           1e-6 * fabs(jacobian[column]) + 1e-14 * fabs(up[k]) / step);
        }
    }
}

/* Every range gives the same bits as the whole, and rescaled units rescale the forces exactly. */
static void test_field_ranges_and_dimensions(gconstpointer data)
{
    Crowd crowd;
    double force[2 * BODIES], single[2 * BODIES];
    crowd_init(&crowd);
    g_autoptr(BlockBatch) batch = random_field(data);
    field_force(batch, &crowd, force);
    TinkerBatch view = block_batch_view(batch, 0, 2);
    for (int i = 0; i < BODIES; i++) {
        const TinkerBodies one = crowd_range(&crowd, i, 1);
        g_assert_cmpint(field_of(data)->force(&view, &one, &single[2 * i]), ==, TINKER_OK);
    }
    g_assert_cmpmem(single, sizeof single, force, sizeof force);
    block_batch_rescale(batch);
    points_rescale(crowd.points, BODIES);
    for (int i = 0; i < BODIES; i++) {
        crowd.masses[i] *= rescale_factor((TinkerDimension)TINKER_DIMENSION_MASS);
    }
    field_force(batch, &crowd, single);
    for (int k = 0; k < 2 * BODIES; k++) {
        g_assert_cmpfloat(single[k], ==, force[k] * rescale_factor((TinkerDimension)TINKER_DIMENSION_FORCE));
    }
}

/* Quarter turns are exact, also such as come from degrees; other angles are the library's. */
static void test_directions(void)
{
    const struct {
        double angle, x, y;
    } rows[] = {{0, 1, 0},
                {PI / 2, 0, 1},
                {PI, -1, 0},
                {-PI / 2, 0, -1},
                {270.0 * PI / 180.0, 0, -1},
                {-450.0 * (PI / 180.0), 0, -1},
                {720.0 * (PI / 180.0), 1, 0},
                {PI / 6, cos(PI / 6), sin(PI / 6)},
                {1e-9, 1, 1e-9},
                {1e300, cos(1e300), sin(1e300)}};
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        double direction[2];
        tinker_direction(rows[i].angle, direction);
        g_assert_cmpfloat(direction[0], ==, rows[i].x);
        g_assert_cmpfloat(direction[1], ==, rows[i].y);
    }
}

static void test_motor(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("motor"), 2);
    const TinkerForceElement *motor = block_physics(batch->block)->force_element;
    block_batch_set(batch, 0, "waveform", 0, -3);
    block_batch_set(batch, 0, "angle", 0, PI / 2);
    block_batch_set(batch, 1, "waveform", 0, 2);
    block_batch_set(batch, 1, "angle", 0, PI / 3);
    const TinkerPoint ends[2] = {{1, 2, 3, 4}, {5, 6, 7, 8}};
    double force[4], constant[4], direction[4];
    int32_t column[2];
    TinkerPose poses[2] = {{.angle = 0.7}, {.angle = 0.4}}; /* of what they are on; they do not follow it */
    TinkerBatch view = block_batch_view(batch, 0, 2);
    view.poses = poses;
    g_assert_cmpint(motor->force(&view, ends, force), ==, TINKER_OK);
    g_assert_cmpfloat(force[0], ==, 0);
    g_assert_cmpfloat(force[1], ==, -3);
    assert_close(force[2], 1, 4 * DBL_EPSILON);
    assert_close(force[3], sqrt(3), 4 * DBL_EPSILON);
    g_assert_cmpint(motor->linear(&view, constant, direction, column), ==, TINKER_OK);
    for (int i = 0; i < 2; i++) {
        g_assert_cmpint(column[i], ==, block_column(batch->block, "waveform"));
        const double value = view.columns[column[i]][i];
        g_assert_cmpfloat(constant[2 * i] + value * direction[2 * i], ==, force[2 * i]);
        g_assert_cmpfloat(constant[2 * i + 1] + value * direction[2 * i + 1], ==, force[2 * i + 1]);
    }
    g_assert_null(motor->energy);
    block_batch_set(batch, 1, "follows", 0, 1);
    poses[1].angle = PI / 6;
    g_assert_cmpint(motor->force(&view, ends, force), ==, TINKER_OK);
    g_assert_cmpfloat(force[1], ==, -3);
    assert_close(force[2], 0, 4 * DBL_EPSILON);
    assert_close(force[3], 2, 4 * DBL_EPSILON);
}

static void test_support_motion(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("support-motion"), 1);
    const TinkerMotion *role = block_physics(batch->block)->motion;
    const double wave[3] = {0.25, -2, 8};
    for (int k = 0; k < 3; k++) {
        block_batch_set(batch, 0, "waveform", k, wave[k]);
    }
    block_batch_set(batch, 0, "angle", 0, -PI / 2);
    double displacement[2], velocity[2], acceleration[2], direction[2];
    int32_t column;
    TinkerBatch view = block_batch_view(batch, 0, 1);
    g_assert_cmpint(role->motion(&view, displacement, velocity, acceleration), ==, TINKER_OK);
    g_assert_cmpfloat(displacement[0], ==, 0);
    g_assert_cmpfloat(displacement[1], ==, -0.25);
    g_assert_cmpfloat(velocity[1], ==, 2);
    g_assert_cmpfloat(acceleration[1], ==, -8);
    g_assert_cmpint(role->linear(&view, direction, &column), ==, TINKER_OK);
    g_assert_cmpint(column, ==, block_column(batch->block, "waveform"));
    g_assert_cmpfloat(view.columns[column][0] * direction[1], ==, displacement[1]);
}

static void test_support_refuses_sliding_above_rest(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("support"), 3);
    const TinkerPhysics *physics = block_physics(batch->block);
    TinkerBatch view = block_batch_view(batch, 0, 3);
    g_assert_cmpint(physics->prepare(&view), ==, TINKER_OK);
    block_batch_set(batch, 2, "dynamic_friction", 0, 0.6);
    g_assert_cmpint(physics->prepare(&view), ==, TINKER_FAILED);
    g_assert_cmpint(view.failed_instance, ==, 2);
    g_assert_nonnull(strstr(view.failure, "dynamic_friction"));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plugins/gravity/straight-down", test_gravity_points_straight_down);
    g_test_add_func("/plugins/gravity/several", test_gravities_add_up);
    g_test_add_func("/plugins/gravity/energy", test_gravity_energy);
    g_test_add_func("/plugins/wind/law", test_wind_law);
    g_test_add_data_func("/plugins/gravity/linear", "gravity", test_linear_fields);
    g_test_add_data_func("/plugins/wind/linear", "wind", test_linear_fields);
    g_test_add_data_func("/plugins/gravity/derivatives", "gravity", test_field_derivatives);
    g_test_add_data_func("/plugins/wind/derivatives", "wind", test_field_derivatives);
    g_test_add_data_func("/plugins/gravity/ranges", "gravity", test_field_ranges_and_dimensions);
    g_test_add_data_func("/plugins/wind/ranges", "wind", test_field_ranges_and_dimensions);
    g_test_add_func("/plugins/directions", test_directions);
    g_test_add_func("/plugins/motor/force", test_motor);
    g_test_add_func("/plugins/support-motion/motion", test_support_motion);
    g_test_add_func("/plugins/support/friction", test_support_refuses_sliding_above_rest);
    return g_test_run();
}
