/* Closed forms of rolling, throws between walls and the driven wheel; momentum and energy through blows; the fall of a
 * domino as an integral of its energy. */
#include "meeting-cases.h"

#include <glib/gstdio.h>
#include <math.h>
#include <unistd.h>

#include "measures.h"
#include "program.h"

/* Moments about the point that touches the floor: a = F (cos(alpha) - r / R) / (m + I / R^2), with I = m R^2 / 2. What
 * the floor holds it with is the rest of m a. */
void check_pulled_spool(const char *path)
{
    const struct {
        const char *name;
        double angle, start;
    } spools[] = {{"Flat", 0.0, 2.0}, {"Critical", RADIANS(60.0), 0.0}, {"Steep", RADIANS(90.0), -2.0}};
    const double pull = 4.0, mass = 2.0, radius = 0.5, hub = 0.25, times[] = {0.7, 2.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize i = 0; i < G_N_ELEMENTS(spools); i++) {
        const double a = pull * (cos(spools[i].angle) - hub / radius) / (1.5 * mass);
        g_autofree char *x = g_strconcat(spools[i].name, ".x", NULL);
        g_autofree char *angle = g_strconcat(spools[i].name, ".angle", NULL);
        g_autofree char *friction = g_strconcat(spools[i].name, ".friction force", NULL);
        for (gsize row = 0; row < G_N_ELEMENTS(times); row++) {
            const double way = 0.5 * a * times[row] * times[row];
            CLOSE(test_table_value(record, row, x), spools[i].start + way, 1e-12);
            CLOSE(test_table_value(record, row, angle), -way / radius, 1e-12);
        }
        g_autoptr(TestTable) forces = measure_columns_at(path, "1.5", friction);
        CLOSE(test_table_value(forces, 0, friction), mass * a - pull * cos(spools[i].angle), 1e-11);
    }
}

/* A domino that turns about its lower edge without slipping: how fast, from its energy, when it has turned so far. */
static double domino_rate(double turned, double start_rate)
{
    const double width = 0.1, height = 0.8, inertia = (width * width + height * height) / 3.0; /* a kilogram's */
    const double risen = 0.5 * height * (cos(turned) - 1.0) + 0.5 * width * sin(turned);
    return sqrt(start_rate * start_rate - 2.0 * GRAVITY * risen / inertia);
}

/* When the first one's upper edge has come over the gap to the next: the integral of 1 / rate, by Simpson's rule. */
static double first_strike(double gap, double height, double start_rate)
{
    enum { INTERVALS = 2000 };
    const double end = asin(gap / height), step = end / INTERVALS;
    double sum = 1.0 / domino_rate(0.0, start_rate) + 1.0 / domino_rate(end, start_rate);
    for (int i = 1; i < INTERVALS; i++)
        sum += (i % 2 == 1 ? 4.0 : 2.0) / domino_rate(i * step, start_rate);
    return sum * step / 3.0;
}

/* When each domino is first struck by the one before it. */
static void find_strikes(const TestSceneRun *run, double *struck, int dominoes)
{
    for (int k = 1; k < dominoes; k++) {
        g_autofree char *striking = g_strdup_printf("Domino %d", k), *hit = g_strdup_printf("Domino %d", k + 1);
        const cJSON *event;
        struck[k] = INFINITY;
        cJSON_ArrayForEach(event, cJSON_GetObjectItemCaseSensitive(run->summary, "events"))
        {
            const cJSON *blocks = cJSON_GetObjectItemCaseSensitive(event, "blocks");
            const double time = cJSON_GetObjectItemCaseSensitive(event, "time")->valuedouble;
            if (cJSON_GetArraySize(blocks) != 2 || time >= struck[k]) continue;
            if (g_str_equal(cJSON_GetArrayItem(blocks, 0)->valuestring, striking) &&
                g_str_equal(cJSON_GetArrayItem(blocks, 1)->valuestring, hit))
                struck[k] = time;
        }
    }
}

/* The first strike falls when its integral says; the others follow in order, each sooner than the one before. What all
 * of them move and weigh never becomes more. */
void check_dominoes(const char *path)
{
    enum { DOMINOES = 5 };
    const double width = 0.1, height = 0.8;
    const char *options[] = {"--tolerance", "1e-11", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    double struck[DOMINOES] = {0.0};
    find_strikes(run, struck, DOMINOES);
    CLOSE(struck[1], first_strike(0.3, height, 0.8), 1e-9);
    for (int k = 2; k < DOMINOES; k++) {
        g_assert_cmpfloat(struck[k], >, struck[k - 1]);
        if (k > 2) g_assert_cmpfloat(struck[k] - struck[k - 1], <, struck[k - 1] - struck[k - 2]);
    }

    double before = INFINITY;
    for (gsize row = 0; row < run->record->rows; row++) {
        double energy = 0.0;
        for (int k = 1; k <= DOMINOES; k++) {
            double state[4];
            static const char *const quantities[] = {"y", "vx", "vy", "angular velocity"};
            for (int q = 0; q < 4; q++) {
                g_autofree char *column = g_strdup_printf("Domino %d.%s", k, quantities[q]);
                state[q] = test_table_value(run->record, row, column);
            }
            energy += GRAVITY * state[0] + 0.5 * (state[1] * state[1] + state[2] * state[2]) +
                      (width * width + height * height) / 24.0 * state[3] * state[3];
        }
        g_assert_cmpfloat(energy, <, before + 1e-9);
        before = energy;
    }
    g_assert_cmpfloat(test_table_value(run->record, run->record->rows - 1, "Domino 5.angle"), <, -0.5);
}

/* A copy of a scene with another law of impact. (transfer full) */
static char *with_impact_law(const char *path, const char *law)
{
    GError *error = NULL;
    char *copy = NULL;
    cJSON *scene = test_read_json(path);
    cJSON_ReplaceItemInObjectCaseSensitive(cJSON_GetObjectItemCaseSensitive(scene, "run"), "impact_law",
                                           cJSON_CreateString(law));
    char *text = cJSON_Print(scene);
    close(g_file_open_tmp("XXXXXX.tinker.json", &copy, &error));
    g_assert_no_error(error);
    g_assert_true(g_file_set_contents(copy, text, -1, NULL));
    cJSON_free(text);
    cJSON_Delete(scene);
    return copy;
}

/* The first ball comes down after a quarter of its period with v. Four that touch go on with one speed u, for nothing
 * parts them: m v = m w + 4 m u and v^2 = w^2 + 4 u^2 leave w = -3 v / 5, u = 2 v / 5. So by Newton's law and by
 * Poisson's. */
void check_newtons_cradle_at_once(const char *path)
{
    const double length = 2.0, swing = asin(0.6), quarter = measure_quarter_period(swing) * sqrt(length / GRAVITY);
    const double speed = sqrt(2.0 * GRAVITY * length * (1.0 - cos(swing)));
    const double times[] = {quarter - 1e-9, quarter + 1e-9};
    g_autofree char *poisson = with_impact_law(path, "poisson");
    const char *const scenes[] = {path, poisson};
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        g_autoptr(TestTable) record = measure_at(scenes[i], times, G_N_ELEMENTS(times));
        for (int ball = 1; ball <= 5; ball++) {
            g_autofree char *vx = g_strdup_printf("Ball %d.vx", ball);
            CLOSE(test_table_value(record, 0, vx), ball == 1 ? speed : 0.0, 1e-7);
            CLOSE(test_table_value(record, 1, vx), (ball == 1 ? -0.6 : 0.4) * speed, 1e-7);
        }
    }
    g_unlink(poisson);
}

static int in_order(const void *a, const void *b)
{
    const double difference = *(const double *)a - *(const double *)b;
    return (difference > 0.0) - (difference < 0.0);
}

/* When a ball that starts in the middle of 3 m by 4 m, 1 m left of it, with (5, 6) m/s meets a side. Between the walls
 * its way is even; the ceiling sends it back as fast as it came, the floor, too. (transfer full) */
static GArray *bounces_in_box(double until)
{
    const double wide = 4.0 - 0.5, high = 0.5 * (3.0 - 0.5), across = 5.0, up = 6.0;
    const double at_ceiling = sqrt(up * up - 2.0 * GRAVITY * high), at_floor = sqrt(up * up + 2.0 * GRAVITY * high);
    GArray *times = g_array_new(FALSE, FALSE, sizeof(double));
    for (double time = (0.5 * wide + 1.0) / across; time < until; time += wide / across)
        g_array_append_val(times, time);
    for (double time = (up - at_ceiling) / GRAVITY; time < until; time += (at_floor - at_ceiling) / GRAVITY)
        g_array_append_val(times, time);
    g_array_sort(times, in_order);
    return times;
}

void check_ball_in_a_box(const char *path)
{
    const double duration = 3.0;
    const char *options[] = {NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    g_autoptr(GArray) expected = bounces_in_box(duration);
    const cJSON *events = cJSON_GetObjectItemCaseSensitive(run->summary, "events");
    g_assert_cmpint(cJSON_GetArraySize(events), ==, (int)expected->len);
    for (guint i = 0; i < expected->len; i++) {
        const cJSON *event = cJSON_GetArrayItem(events, (int)i);
        g_assert_cmpstr(cJSON_GetObjectItemCaseSensitive(event, "kind")->valuestring, ==, "impact");
        CLOSE(cJSON_GetObjectItemCaseSensitive(event, "time")->valuedouble, g_array_index(expected, double, i), 1e-12);
    }
    for (gsize row = 0; row < run->record->rows; row++) {
        const double vx = test_table_value(run->record, row, "Ball.vx"),
                     vy = test_table_value(run->record, row, "Ball.vy");
        const double energy = 0.5 * (vx * vx + vy * vy) + GRAVITY * test_table_value(run->record, row, "Ball.y");
        CLOSE(energy, 0.5 * (5.0 * 5.0 + 6.0 * 6.0), 1e-12);
        CLOSE(test_table_value(run->record, row, "Ball.angular velocity"), 0.0, 1e-15);
    }
}

/* The pin, at r = C / sqrt(2) from the crank's bearing, touches one side of a slot, whose middle line is as far from it
 * as the slot has room: the wheel's angle is that of the way from its bearing to the pin and asin(room / distance) more
 * or less, by which side it is. It is carried on the way in and held back on the way out. */
void check_geneva_wheel(const char *path)
{
    const double centres = 2.0, crank = centres * G_SQRT2 / 2.0, room = 0.002, rate = 2.0 * G_PI;
    const double times[] = {0.1, 0.15, 0.2, 0.25, 0.28, 0.32, 0.36};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 0, "Wheel.angle"), 0.0, 1e-15);
    for (gsize row = 1; row < G_N_ELEMENTS(times); row++) {
        const double turned = rate * times[row] - G_PI / 2.0;
        const double x = crank * cos(turned) - centres, y = crank * sin(turned), distance = hypot(x, y);
        const double vx = -rate * crank * sin(turned), vy = rate * crank * cos(turned);
        const double slot = atan2(y, -x) + G_PI / 4.0; /* turned from where the pin came in, clockwise */
        const double side = times[row] <= 0.25 ? 1.0 : -1.0;
        const double parting = (x * vx + y * vy) / distance;
        CLOSE(test_table_value(record, row, "Wheel.angle"), -slot + side * asin(room / distance), 1e-9);
        CLOSE(test_table_value(record, row, "Wheel.angular velocity"),
              (x * vy - y * vx) / (distance * distance) -
                  side * room * parting / (distance * sqrt(distance * distance - room * room)),
              1e-7);
    }
    CLOSE(test_table_value(record, 3, "Wheel.angular velocity") / rate, -2.414213562373095, 1e-9);
}

/* Before the ball arrives: what flies is where a throw of first order has it, g h t / 2 too low, and ten boxes stand.
 * Momentum along the floor is the ball's. Behind it: what moved has come to less, and boxes lie on the floor that did
 * not. */
void check_pile_and_ball(const char *path)
{
    const double step = 0.001, before = 0.4, times[] = {0.0, before, 1.5};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    CLOSE(test_table_value(record, 1, "Ball.x"), -2.6 + 6.0 * before, 1e-12);
    CLOSE(test_table_value(record, 1, "Ball.y"), 0.7 + 3.0 * before - 0.5 * GRAVITY * before * (before + step), 1e-12);
    double momentum = 4.0 * test_table_value(record, 1, "Ball.vx");
    for (int box = 1; box <= 10; box++) {
        static const char *const quantities[] = {"x", "y", "angle"};
        for (gsize q = 0; q < G_N_ELEMENTS(quantities); q++) {
            g_autofree char *column = g_strdup_printf("Box %d.%s", box, quantities[q]);
            CLOSE(test_table_value(record, 1, column), test_table_value(record, 0, column), 1e-9);
        }
        g_autofree char *vx = g_strdup_printf("Box %d.vx", box);
        momentum += test_table_value(record, 1, vx);
    }
    CLOSE(momentum, 24.0, 1e-9);
    g_assert_cmpfloat(test_table_value(record, 2, "Box 10.y"), <, test_table_value(record, 0, "Box 10.y") - 0.4);
    g_assert_cmpfloat(fabs(test_table_value(record, 2, "Ball.vx")), <, 6.0);
}
