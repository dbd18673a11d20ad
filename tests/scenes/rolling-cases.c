/* Closed forms of rolling, friction of pins, tipping and rocking, and times of impacts from the elliptic integrals of a
 * rocking block. */
#include "rolling-cases.h"

#include <math.h>

#include "measures.h"
#include "program.h"

/* Down the plank: a = g sin(alpha) / (1 + I / (m R^2)), and it turns by what it has rolled. */
void check_rolling_race(const char *path)
{
    const struct {
        const char *name;
        double shape; /* I / (m R^2) */
    } bodies[] = {{"Disc", 0.5}, {"Hoop", 1.0}, {"Heavy disc", 0.5}};
    const double slope = RADIANS(20.0), radius = 0.4, time = 1.5;
    g_autoptr(TestTable) record = measure_at(path, &time, 1);
    for (gsize i = 0; i < G_N_ELEMENTS(bodies); i++) {
        const double a = GRAVITY * sin(slope) / (1.0 + bodies[i].shape);
        g_autofree char *vx = g_strconcat(bodies[i].name, ".vx", NULL);
        g_autofree char *angle = g_strconcat(bodies[i].name, ".angle", NULL);
        CLOSE(test_table_value(record, 0, vx), a * time * cos(slope), 1e-9);
        CLOSE(test_table_value(record, 0, angle), -0.5 * a * time * time / radius, 1e-9);
    }
}

/* It slips until v / (3 mu g), and goes on with two thirds of its speed. */
void check_slipping_to_rolling(const char *path)
{
    const double thrown = 6.0, friction = 0.2, radius = 0.4, rolls = thrown / (3.0 * friction * GRAVITY);
    const double times[] = {0.5, rolls - 1e-3, rolls + 1e-3, 2.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double slipped = fmin(times[row], rolls);
        CLOSE(test_table_value(record, row, "Disc.vx"), thrown - friction * GRAVITY * slipped, 1e-9);
        CLOSE(test_table_value(record, row, "Disc.angular velocity"), -2.0 * friction * GRAVITY * slipped / radius,
              1e-8);
    }
}

/* With a = (2 / 3) g rho / R a disc stops at t = v / a, v^2 / 2 a farther on, and has turned by what it has rolled. */
void check_rolling_resistance(const char *path)
{
    const struct {
        const char *x, *vx, *angle;
        double radius;
    } wheels[] = {{"Small wheel.x", "Small wheel.vx", "Small wheel.angle", 0.4},
                  {"Large wheel.x", "Large wheel.vx", "Large wheel.angle", 0.8}};
    const double thrown = 2.5, resistance = 0.04, times[] = {2.0, 3.8, 5.0, 7.6, 9.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize i = 0; i < G_N_ELEMENTS(wheels); i++) {
        const double a = 2.0 / 3.0 * GRAVITY * resistance / wheels[i].radius;
        for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
            const double t = fmin(times[row], thrown / a), way = thrown * t - 0.5 * a * t * t;
            CLOSE(test_table_value(record, row, wheels[i].x), way, 1e-8);
            CLOSE(test_table_value(record, row, wheels[i].vx), thrown - a * t, 1e-9);
            CLOSE(test_table_value(record, row, wheels[i].angle), -way / wheels[i].radius, 1e-8);
        }
    }
}

/* A wheel of inertia I on a pin that carries its weight slows down by r mu / sqrt(1 + mu^2) m g / I, and stops. */
void check_pin_friction(const char *path)
{
    const struct {
        const char *rate, *angle, *torque;
        double arm; /* of friction: 0.1 m and 0.2 m times 3/4 : 5/4 */
    } wheels[] = {{"Thin axle.angular velocity", "Thin axle.angle", "Thin pin.torque", 0.06},
                  {"Thick axle.angular velocity", "Thick axle.angle", "Thick pin.torque", 0.12}};
    const double turned = 20.0, times[] = {2.0, 5.0, 7.0, 14.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize i = 0; i < G_N_ELEMENTS(wheels); i++) {
        const double a = wheels[i].arm * GRAVITY / (0.5 * 0.8 * 0.8);
        for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
            const double t = fmin(times[row], turned / a);
            CLOSE(test_table_value(record, row, wheels[i].rate), turned - a * t, 1e-8);
            CLOSE(test_table_value(record, row, wheels[i].angle), turned * t - 0.5 * a * t * t, 1e-7);
        }
        g_autoptr(TestTable) torque = measure_columns_at(path, "2,14", wheels[i].torque);
        CLOSE(fabs(test_table_value(torque, 0, wheels[i].torque)), 4.0 * GRAVITY * wheels[i].arm, 1e-9);
        CLOSE(test_table_value(torque, 1, wheels[i].torque), 0.0, 1e-9);
    }
}

/* The tall box turns about its lower corner until it slips there, and its weight gives what it turns with. */
void check_tip_or_slide(const char *path)
{
    const double slope = RADIANS(25.0), width = 0.4, height = 1.2, half = 0.5 * hypot(width, height);
    const double times[] = {0.4, 0.6};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double a = GRAVITY * (sin(slope) - 0.3 * cos(slope));
        CLOSE(test_table_value(record, row, "Sliding box.vx"), a * cos(slope) * times[row], 1e-9);
        CLOSE(test_table_value(record, row, "Sliding box.angle"), -slope, 1e-10);
        CLOSE(test_table_value(record, row, "Resting box.vx"), 0.0, 1e-12);

        const double turned = test_table_value(record, row, "Tall box.angle");
        const double rate = test_table_value(record, row, "Tall box.angular velocity");
        const double corner = atan2(height, -width); /* from the lower corner to the centre, in the box's axes */
        const double fallen = half * (sin(corner - slope) - sin(corner + turned));
        g_assert_cmpfloat(turned, <, -slope - 0.05);
        CLOSE(rate * rate, 2.0 * GRAVITY * fallen / (half * half * 4.0 / 3.0), 1e-7);
    }
}

/* When a run had events of these kinds, in s, in order; the kinds are ended by NULL. (transfer full) */
static GArray *event_times(const TestSceneRun *run, const char *const *kinds)
{
    GArray *times = g_array_new(FALSE, FALSE, sizeof(double));
    const cJSON *event;
    cJSON_ArrayForEach(event, cJSON_GetObjectItemCaseSensitive(run->summary, "events"))
    {
        if (!g_strv_contains(kinds, cJSON_GetObjectItemCaseSensitive(event, "kind")->valuestring)) continue;
        const double time = cJSON_GetObjectItemCaseSensitive(event, "time")->valuedouble;
        g_array_append_val(times, time);
    }
    return times;
}

/* Impacts of a block of half sizes 0.1 m and 0.5 m that does not slip, let go at half of alpha = atan(0.1 / 0.5), each
 * with w after = (1 - 1.5 sin^2 alpha) w before: Housner's rocking block without small angles. */
void check_rocking_block(const char *path)
{
    const double impacts[] = {0.347093586789, 0.950920536478, 1.48793964311};
    const char *options[] = {"--tolerance", "1e-11", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    g_autoptr(GArray) found = event_times(run, (const char *const[]){"rest", "impact", NULL});
    g_assert_cmpuint(found->len, >=, G_N_ELEMENTS(impacts));
    for (gsize i = 0; i < G_N_ELEMENTS(impacts); i++)
        CLOSE(g_array_index(found, double, i), impacts[i], 1e-9);

    g_autofree char *around = g_strdup_printf("%.12f,%.12f", impacts[0] - 1e-7, impacts[0] + 1e-7);
    g_autoptr(TestTable) record = measure_columns_at(path, around, "Block.angular velocity");
    CLOSE(test_table_value(record, 1, "Block.angular velocity") / test_table_value(record, 0, "Block.angular velocity"),
          0.942307692307692, 1e-5);
}

/* The standing ladder: the wall pushes with m g / (2 tan f), the floor with that and m g. The sliding one leaves its
 * wall where sin f is two thirds of what it was. */
void check_ladder_on_wall(const char *path)
{
    const double mass = 10.0, start = RADIANS(65.0), wall = mass * GRAVITY / (2.0 * tan(start));
    const char *options[] = {"--tolerance", "1e-11", "--columns", "Standing ladder.contact force,Sliding ladder.angle",
                             NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    const gsize last = run->record->rows - 1;
    /* The magnitude of the sum of both: the ladder's weight alone. */
    CLOSE(test_table_value(run->record, last, "Standing ladder.contact force"), mass * GRAVITY, 1e-8);
    g_assert_cmpfloat(wall, <, 0.4 * mass * GRAVITY);

    g_autoptr(GArray) leaves = event_times(run, (const char *const[]){"take-off", NULL});
    g_assert_cmpuint(leaves->len, >, 0);
    g_assert_cmpfloat(g_array_index(leaves, double, 0), >, 0.0);
    g_autofree char *time = g_strdup_printf("%.15g", g_array_index(leaves, double, 0));
    g_autoptr(TestTable) then = measure_columns_at(path, time, "Sliding ladder.angle");
    CLOSE(sin(test_table_value(then, 0, "Sliding ladder.angle")), 2.0 / 3.0 * sin(start), 1e-8);
}

/* A quarter of the period of such an amplitude after it is let go, the first ball stops and the last goes on with its
 * speed, up to the same height; so back again. Those between them stay. */
void check_newtons_cradle(const char *path)
{
    const double length = 2.0, swing = asin(0.6), quarter = measure_quarter_period(swing) * sqrt(length / GRAVITY);
    const double speed = sqrt(2.0 * GRAVITY * length * (1.0 - cos(swing)));
    const double times[] = {quarter - 1e-9, quarter + 1e-9, 2.0 * quarter, 4.0 * quarter};
    const double first[] = {-1.0, -1.0, -1.0, -1.0 - length * sin(swing)};
    const double last[] = {1.0, 1.0, 1.0 + length * sin(swing), 1.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        CLOSE(test_table_value(record, row, "Ball 1.x"), first[row], 1e-7);
        CLOSE(test_table_value(record, row, "Ball 5.x"), last[row], 1e-7);
        CLOSE(test_table_value(record, row, "Ball 3.x"), 0.0, 1e-7);
        CLOSE(test_table_value(record, row, "Ball 1.vx"), row == 0 ? speed : 0.0, 1e-7);
        CLOSE(test_table_value(record, row, "Ball 5.vx"), row == 1 ? speed : 0.0, 1e-7);
    }
    /* nothing is magnified on the way: the run knows that, by other methods, too */
    static const char *methods[] = {"auto", "dopri5", "dop853"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        const char *options[] = {"--method", methods[i], NULL};
        g_autoptr(TestSceneRun) run = test_scene_run(path, options);
        CLOSE(test_summary_number(run, "error_estimate"), 0.0, 1e-8);
    }
}
