/* A toy that jams and swings by turns: geometry of the jam, energy of the swing, the place of the strikes. */
#include "woodpecker-case.h"

#include <math.h>

#include "measures.h"
#include "program.h"

/* When the first event of a kind after a time is; fails the test where there is none. `block`: among its blocks; NULL:
 * any. */
static double next_event(const TestSceneRun *run, const char *kind, const char *block, double after)
{
    const cJSON *event, *each;
    cJSON_ArrayForEach(event, cJSON_GetObjectItemCaseSensitive(run->summary, "events"))
    {
        const double time = cJSON_GetObjectItemCaseSensitive(event, "time")->valuedouble;
        if (time <= after || !g_str_equal(cJSON_GetObjectItemCaseSensitive(event, "kind")->valuestring, kind)) continue;
        cJSON_ArrayForEach(each, cJSON_GetObjectItemCaseSensitive(event, "blocks"))
        {
            if (block == NULL || g_str_equal(each->valuestring, block)) return time;
        }
    }
    g_error("no %s after %g s", kind, after);
}

/* How far a sleeve of half width w and half height h tilts on a pole of half width p: w cos a - h sin a = p. */
static double jamming_angle(double w, double h, double p)
{
    double low = 0.0, high = 0.5;
    for (int i = 0; i < 100; i++) {
        const double angle = 0.5 * (low + high);
        if (w * cos(angle) - h * sin(angle) > p)
            low = angle;
        else
            high = angle;
    }
    return low;
}

/* Jammed, the sleeve has the tilt at which it touches the pole on both sides, and does not creep; the bird swings about
 * the hinge with what energy it has, of its motion, its spring and its weight. Its beak strikes where the pole is, and
 * the strikes follow one another as evenly as a cycle that has been reached from elsewhere lets them. */
void check_woodpecker(const char *path)
{
    const double pole = 0.04, tilt = jamming_angle(0.0496, 0.0928, pole);
    const double mass = 0.45, arm = 0.24, inertia = 0.01792 + mass * arm * arm, stiffness = 8.96;
    const char *options[] = {"--tolerance", "1e-11", NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    double struck[4], jammed[2], time = 0.0;
    for (int i = 0; i < 4; i++)
        struck[i] = time = next_event(run, "rest", "Woodpecker", time);
    for (int i = 2; i < 4; i++)
        CLOSE(struck[i] - struck[i - 1], struck[1] - struck[0], 0.02 * struck[1]);
    jammed[0] = next_event(run, "stick", NULL, struck[0]);
    jammed[1] = next_event(run, "slip", NULL, jammed[0]);
    g_assert_cmpfloat(jammed[1] - jammed[0], >, 0.1);

    const double times[] = {struck[0], jammed[0] + 0.01, 0.5 * (jammed[0] + jammed[1]), jammed[1] - 0.01};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    const double angle = test_table_value(record, 0, "Woodpecker.angle"), beak[] = {-0.3216, 0.32};
    CLOSE(test_table_value(record, 0, "Woodpecker.x") + beak[0] * cos(angle) - beak[1] * sin(angle), pole, 1e-8);
    double energy = 0.0;
    for (gsize row = 1; row < G_N_ELEMENTS(times); row++) {
        const double turned = test_table_value(record, row, "Woodpecker.angle");
        const double rate = test_table_value(record, row, "Woodpecker.angular velocity");
        const double now = 0.5 * inertia * rate * rate + 0.5 * stiffness * (turned + tilt) * (turned + tilt) +
                           mass * GRAVITY * arm * sin(turned);
        CLOSE(test_table_value(record, row, "Right shoe.angle"), -tilt, 1e-9);
        CLOSE(test_table_value(record, row, "Right shoe.y"), test_table_value(record, 1, "Right shoe.y"), 1e-9);
        if (row > 1) CLOSE(now, energy, 1e-8);
        energy = now;
    }
}
