/* Closed forms, put together from event to event: free flight is a parabola, sliding too, a block on a spring swings
 * about a place that friction shifts. Times of events that have no closed form come from bisection. */
#include "contact-cases.h"

#include <math.h>

#include "measures.h"
#include "program.h"
#include "sliding-block.h"

/* A value of the record at a time. */
static double at(const TestTable *record, double time, const char *column)
{
    return test_table_value(record, test_table_row(record, time), column);
}

/* The middle of an interval in which f changes its sign once, to the last bit. */
static double bisect(double (*f)(double t, const double *given), const double *given, double low, double high)
{
    const double sign = f(low, given) > 0.0 ? 1.0 : -1.0;
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (low + high);
        if (sign * f(middle, given) > 0.0)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* Tops at y = 0.2 and boxes of 0.8: what stands, stands at y = 0.6. */
void check_one_sided_support(const char *path)
{
    const double down = sqrt(2.0 * 1.6 / GRAVITY), rise = 8.0 / GRAVITY;
    const double highest = -2.0 + 0.5 * GRAVITY * rise * rise;
    const double landing = rise + sqrt(2.0 * (highest - 0.6) / GRAVITY);
    const double times[] = {0.5, down - 1e-4, down + 1e-4, landing - 1e-4, landing + 1e-4, 1.5};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double t = times[row], fallen = 0.5 * GRAVITY * t * t;
        CLOSE(test_table_value(record, row, "Stopped.y"), t < down ? 2.2 - fallen : 0.6, 1e-10);
        CLOSE(test_table_value(record, row, "Stopped.vy"), t < down ? -GRAVITY * t : 0.0, 1e-9);
        CLOSE(test_table_value(record, row, "Falls through.y"), 2.2 - fallen, 1e-10);
        CLOSE(test_table_value(record, row, "Thrown from below.y"), t < landing ? -2.0 + 8.0 * t - fallen : 0.6, 1e-10);
    }
    g_autoptr(TestTable) forces =
        measure_columns_at(path, "0.3,1.5", "Stopped.normal force,Falls through.normal force,Facing up.contact force");
    g_assert_cmpfloat(at(forces, 0.3, "Stopped.normal force"), ==, 0.0);
    CLOSE(at(forces, 1.5, "Stopped.normal force"), GRAVITY, 1e-9);
    CLOSE(at(forces, 1.5, "Facing up.contact force"), GRAVITY, 1e-9);
    g_assert_cmpfloat(at(forces, 1.5, "Falls through.normal force"), ==, 0.0);
}

/* Where the mass of incline-landing is, and how fast, at the start of each stage. */
typedef struct {
    double t, x, y, vx, vy;
} Flight;

/* Later by `time` with a constant acceleration. */
static Flight later(Flight from, double ax, double ay, double time)
{
    return (Flight){from.t + time, from.x + from.vx * time + 0.5 * ax * time * time,
                    from.y + from.vy * time + 0.5 * ay * time * time, from.vx + ax * time, from.vy + ay * time};
}

/* From rest at (-1.56, 3.99) onto the incline, down it and off its end, onto the floor, to rest there. The top of the
 * incline goes through n (0.2) above its centre (0, 1.2); the box stands off by another 0.3. The floor's top is at
 * -2.4. */
static void incline_stages(Flight stages[5])
{
    const double s = sin(RADIANS(-25)), c = cos(RADIANS(-25)), down = -s - 0.2 * c;
    stages[0] = (Flight){0.0, -1.56, 3.99, 0.0, 0.0};
    const double gap = -s * stages[0].x + c * (stages[0].y - 1.2) - 0.5;
    Flight impact = later(stages[0], 0.0, -GRAVITY, sqrt(2.0 * gap / c / GRAVITY));
    /* Across the top it stops; along the top friction takes 0.2 of what the top gives. */
    const double along = impact.vy * s - 0.2 * -impact.vy * c;
    stages[1] = impact;
    stages[1].vx = along * c;
    stages[1].vy = along * s;
    /* It slides until its centre is 3 m down from the middle. */
    const double way = 3.0 - (c * impact.x + s * (impact.y - 1.2)), a = GRAVITY * down;
    stages[2] = later(stages[1], a * c, a * s, (sqrt(along * along + 2.0 * a * way) - along) / a);
    const double drop = stages[2].y + 2.1;
    const double fall = (stages[2].vy + sqrt(stages[2].vy * stages[2].vy + 2.0 * GRAVITY * drop)) / GRAVITY;
    stages[3] = later(stages[2], 0.0, -GRAVITY, fall);
    stages[3].vx = fmax(0.0, stages[3].vx - 0.4 * -stages[3].vy);
    stages[3].vy = 0.0;
    stages[4] = later(stages[3], -0.4 * GRAVITY, 0.0, stages[3].vx / (0.4 * GRAVITY));
}

void check_incline_landing(const char *path)
{
    const double s = sin(RADIANS(-25)), c = cos(RADIANS(-25)), a = GRAVITY * (-s - 0.2 * c);
    Flight stages[5];
    incline_stages(stages);
    const double accelerations[4][2] = {{0.0, -GRAVITY}, {a * c, a * s}, {0.0, -GRAVITY}, {-0.4 * GRAVITY, 0.0}};
    double times[9];
    for (int k = 0; k < 4; k++) {
        times[2 * k] = 0.5 * (stages[k].t + stages[k + 1].t);
        times[2 * k + 1] = stages[k + 1].t - 1e-5;
    }
    times[8] = stages[4].t + 0.3;
    g_assert_cmpfloat(times[8], <, 4.0);
    g_assert_cmpfloat(stages[3].vx, >, 0.1);
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (int row = 0; row < 9; row++) {
        const int k = MIN(row / 2, 3);
        const Flight expected =
            row == 8 ? stages[4] : later(stages[k], accelerations[k][0], accelerations[k][1], times[row] - stages[k].t);
        CLOSE(test_table_value(record, (gsize)row, "Mass 0.x"), expected.x, 1e-9);
        CLOSE(test_table_value(record, (gsize)row, "Mass 0.y"), expected.y, 1e-9);
        CLOSE(test_table_value(record, (gsize)row, "Mass 0.vx"), expected.vx, 1e-8);
        CLOSE(test_table_value(record, (gsize)row, "Mass 0.vy"), expected.vy, 1e-8);
    }
}

/* Held; s = g (sin a - 0.5 cos a) t^2 / 2; the same until it meets the stop, 2.3 m down. */
void check_friction_incline(const char *path)
{
    const double angles[] = {RADIANS(20), RADIANS(26.57), RADIANS(35)};
    const double times[] = {0.0, 1.0, 1.6, 2.0, 10.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (int block = 1; block <= 3; block++) {
        g_autofree char *x = g_strdup_printf("Block %d.x", block), *y = g_strdup_printf("Block %d.y", block);
        const double s = sin(angles[block - 1]), c = cos(angles[block - 1]);
        const double pull = block == 1 ? 0.0 : GRAVITY * (s - 0.5 * c);
        for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
            const double dx = test_table_value(record, row, x) - test_table_value(record, 0, x);
            const double dy = test_table_value(record, row, y) - test_table_value(record, 0, y);
            const double way = fmin(0.5 * pull * times[row] * times[row], 2.3);
            CLOSE(dx, -c * way, 1e-9);
            CLOSE(dy, -s * way, 1e-9);
        }
    }
    g_autoptr(TestTable) forces =
        measure_columns_at(path, "5", "Block 1.friction force,Block 1.normal force,Block 2.friction force");
    CLOSE(at(forces, 5, "Block 1.friction force"), GRAVITY * sin(angles[0]), 1e-9);
    CLOSE(at(forces, 5, "Block 1.normal force"), GRAVITY * cos(angles[0]), 1e-9);
    CLOSE(at(forces, 5, "Block 2.friction force"), 0.5 * GRAVITY * cos(angles[1]), 1e-9);
}

/* Height above the place of rest of a ball dropped from h, after t. */
static double bounce_height(double h, double e, double t)
{
    double flight = sqrt(2.0 * h / GRAVITY), speed = sqrt(2.0 * GRAVITY * h);
    if (t < flight) return h - 0.5 * GRAVITY * t * t;
    for (t -= flight; speed > 1e-9; t -= flight) {
        speed *= e;
        flight = 2.0 * speed / GRAVITY;
        if (t < flight) return t * (speed - 0.5 * GRAVITY * t);
    }
    return 0.0;
}

void check_bouncing_balls(const char *path)
{
    const double times[] = {0.5, 1.0, 1.5, 1.9, 1.95, 3.0, 5.0, 5.8, 5.83, 8.0};
    const double height = 2.05, rest = -0.75, first = sqrt(2.0 * height / GRAVITY);
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    static const double restitutions[] = {0.0, 0.5, 0.8, 1.0};
    for (gsize ball = 0; ball < G_N_ELEMENTS(restitutions); ball++) {
        const double e = restitutions[ball];
        g_autofree char *y = g_strdup_printf("Ball %g.y", e), *vy = g_strdup_printf("Ball %g.vy", e);
        for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
            CLOSE(test_table_value(record, row, y), rest + bounce_height(height, e, times[row]), 1e-9);
            if (e < 1.0 && times[row] > first * (1.0 + e) / (1.0 - e))
                CLOSE(test_table_value(record, row, vy), 0.0, 1e-12);
        }
    }
}

/* Half swings of pi / w about places that friction shifts by 0.2 m g / k; it stops where 0.25 m g / k holds it. */
void check_friction_oscillator(const char *path)
{
    const double w = sqrt(40.0), half = G_PI / w, shift = 0.2 * GRAVITY / 40.0, hold = 0.25 * GRAVITY / 40.0;
    const double times[] = {0.2, half, 1.3, 3.3, 4.9, 5.0, 6.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        double from = 1.0, t = times[row];
        while (t > half && fabs(from) > hold) {
            from = -copysign(fabs(from) - 2.0 * shift, from);
            t -= half;
        }
        const double middle = copysign(shift, from);
        const double x = fabs(from) > hold ? middle + (from - middle) * cos(w * t) : from;
        CLOSE(test_table_value(record, row, "Block.x"), x, 1e-9);
    }
    CLOSE(test_table_value(record, 6, "Block.x"), 1.0 - 20.0 * shift, 1e-9);
    CLOSE(test_table_value(record, 6, "Block.vx"), 0.0, 1e-12);
}

/* Rides until the spring pulls with 0.5 m g, slips about the place where it pulls with 0.3 m g, and meets the belt's
 * speed again as far beyond that place as it left before it. */
void check_stick_slip_belt(const char *path)
{
    const double v = 0.3, w = sqrt(10.0), leaves = 0.5 * GRAVITY / 10.0, middle = 0.3 * GRAVITY / 10.0;
    const double ride = 2.0 * (leaves - middle) / v, slip = 2.0 * (G_PI - atan(w * (leaves - middle) / v)) / w;
    const double times[] = {1.0, leaves / v, 2.0, 2.9, 3.5, 5.0, 6.5, 8.0, 11.9};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(ride + slip, 2.586, 5e-4);
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
        const double since = times[row] - leaves / v, u = since - floor(since / (ride + slip)) * (ride + slip);
        double x = v * times[row], speed = v;
        if (since >= 0.0 && u < slip) {
            x = middle + (leaves - middle) * cos(w * u) + v / w * sin(w * u);
            speed = v * cos(w * u) - w * (leaves - middle) * sin(w * u);
        } else if (since >= 0.0) {
            x = 2.0 * middle - leaves + v * (u - slip);
        }
        CLOSE(test_table_value(record, row, "Block.x"), x, 1e-9);
        CLOSE(test_table_value(record, row, "Block.vx"), speed, 1e-8);
    }
}

/* Table at -0.1 cos(12 t). Given when it left: height over the table after t, and its acceleration against gravity's.
 */
static double height_over_table(double t, const double *left)
{
    const double from = -0.1 * cos(12.0 * left[0]), speed = 1.2 * sin(12.0 * left[0]), u = t - left[0];
    return from + speed * u - 0.5 * GRAVITY * u * u + 0.1 * cos(12.0 * t);
}

/* When it leaves the table for the first time from t on, riding. */
static double next_lift_off(double t)
{
    const double phase = acos(-GRAVITY / 14.4), period = 2.0 * G_PI / 12.0, turn = fmod(12.0 * t, 2.0 * G_PI);
    /* Between that phase and its mirror image the table falls faster than a stone. */
    if (turn >= phase && turn <= 2.0 * G_PI - phase) return t;
    return (ceil((12.0 * t - phase) / (2.0 * G_PI))) * period + phase / 12.0;
}

void check_lift_off(const char *path)
{
    double times[12];
    for (int i = 0; i < 12; i++)
        times[i] = 0.11 + 0.1234 * i;
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    gsize row = 0, flying = 0;
    for (double t = 0.0; row < G_N_ELEMENTS(times);) {
        const double left = next_lift_off(t);
        double first = left + 1e-3;
        while (height_over_table(first, &left) > 0.0)
            first += 1e-3;
        const double landed = bisect(height_over_table, &left, first - 1e-3, first);
        for (; row < G_N_ELEMENTS(times) && times[row] < landed; row++) {
            const double table = -0.1 * cos(12.0 * times[row]);
            const double over = times[row] > left ? height_over_table(times[row], &left) : 0.0;
            flying += over > 0.0;
            CLOSE(test_table_value(record, row, "Takes off.y"), -0.2 + table + over, 1e-8);
            CLOSE(test_table_value(record, row, "Stays.y"), -0.2 + 0.5 * table, 1e-10);
        }
        t = landed;
    }
    g_assert_cmpuint(flying, >, 2);
    g_assert_cmpuint(flying, <, 11);
}

/* With both ends on wall and floor L a" = g sin a for the angle a from the vertical; the wall carries g sin a (3 cos a
 * - 2 cos a0) per mass. Integrated from rest by the classical method with steps far below what is asked here. */
static double ladder_leaves_wall(double from, double length)
{
    const double h = 1e-4, rate = GRAVITY / length, until = acos(2.0 / 3.0 * cos(from));
    double angle = from, speed = 0.0, t = 0.0;
    for (;;) {
        const double k1 = rate * sin(angle), v2 = speed + 0.5 * h * k1;
        const double k2 = rate * sin(angle + 0.5 * h * speed), v3 = speed + 0.5 * h * k2;
        const double k3 = rate * sin(angle + 0.5 * h * v2), v4 = speed + h * k3;
        const double k4 = rate * sin(angle + h * v3);
        const double next = angle + h / 6.0 * (speed + 2.0 * v2 + 2.0 * v3 + v4);
        if (next > until) return t + (until - angle) / speed;
        angle = next;
        speed += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        t += h;
    }
}

void check_sliding_ladder(const char *path)
{
    const double length = 4.0, a0 = RADIANS(20), head = 0.2 + 2.0 / 3.0 * length * cos(a0);
    const double speed = sqrt(2.0 * GRAVITY * length * pow(cos(a0), 3) / 27.0);
    const double leaves = ladder_leaves_wall(a0, length);
    const double times[] = {0.5 * leaves, leaves, leaves + 0.1, 2.9};
    g_assert_cmpfloat(leaves, <, 2.0);
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 0, "Head.x"), 0.2, 1e-10);
    CLOSE(test_table_value(record, 1, "Head.x"), 0.2, 1e-8);
    CLOSE(test_table_value(record, 1, "Head.y"), head, 1e-7);
    g_assert_cmpfloat(test_table_value(record, 2, "Head.x"), >, 0.2 + 1e-6);
    /* From there on the momentum along the floor stays: twice the speed of both in the end. */
    const double together = test_table_value(record, 2, "Head.vx") + test_table_value(record, 2, "Foot.vx");
    CLOSE(together, 2.0 * speed, 1e-8);
    CLOSE(test_table_value(record, 3, "Head.vx"), speed, 1e-8);
    CLOSE(test_table_value(record, 3, "Foot.vx"), speed, 1e-8);
    CLOSE(test_table_value(record, 3, "Head.y"), 0.2, 1e-10);
    for (gsize row = 0; row < G_N_ELEMENTS(times); row++)
        CLOSE(test_table_value(record, row, "Foot.y"), 0.2, 1e-10);
}

void check_el_centro_block(const char *path)
{
    g_autofree char *file = g_build_filename(g_getenv("TINKER_SCENES"), "el-centro-1940-ns.csv", NULL);
    g_autofree char *text = test_read_file(file);
    g_autoptr(TestTable) quake = test_table_new(text);
    g_autofree double *time = g_new(double, quake->rows), *acceleration = g_new(double, quake->rows);
    for (gsize row = 0; row < quake->rows; row++) {
        time[row] = test_table_value(quake, row, "time");
        acceleration[row] = 9.81 * quake->values[row * quake->columns + 1];
    }
    const double times[] = {1.0, 2.2, 2.61, 5.0, 8.0, 12.345, 20.0, 31.0};
    enum { TIMES = G_N_ELEMENTS(times) };
    double held[TIMES], slides[TIMES], ground[TIMES];
    sliding_block_at(time, acceleration, quake->rows, 0.4 * GRAVITY, times, TIMES, held, ground);
    sliding_block_at(time, acceleration, quake->rows, 0.1 * GRAVITY, times, TIMES, slides, ground);
    g_autoptr(TestTable) record = measure_at(path, times, TIMES);
    double farthest = 0.0;
    for (gsize row = 0; row < TIMES; row++) {
        CLOSE(held[row], ground[row], 1e-13);
        CLOSE(test_table_value(record, row, "Held.x"), held[row], 1e-9);
        CLOSE(test_table_value(record, row, "Slides.x"), slides[row], 1e-8);
        farthest = fmax(farthest, fabs(slides[row] - ground[row]));
    }
    g_assert_cmpfloat(farthest, >, 0.02);
}
