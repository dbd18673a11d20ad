/* Scenes that show what is often thought otherwise, held against what is true. */
#include "mistake-cases.h"

#include <glib.h>
#include <math.h>

#include "measures.h"
#include "program.h"

/* Which forces are not 0 in the diagram of a block at a time: one alone, the weight. */
static void check_only_weight(const char *path, const char *time, double weight)
{
    const char *words[] = {"diagram", path, "--block", "Ball", "--time", time, "--as", "json", NULL};
    g_autoptr(TestProgram) program = test_program_run(words);
    g_assert_cmpint(program->status, ==, 0);
    cJSON *diagram = cJSON_Parse(program->output);
    const cJSON *each, *forces = cJSON_GetObjectItemCaseSensitive(diagram, "forces");
    int acting = 0;
    cJSON_ArrayForEach(each, forces)
    {
        const cJSON *force = cJSON_GetObjectItemCaseSensitive(each, "force");
        const double x = cJSON_GetArrayItem(force, 0)->valuedouble, y = cJSON_GetArrayItem(force, 1)->valuedouble;
        if (hypot(x, y) == 0) continue;
        g_assert_cmpstr(cJSON_GetObjectItemCaseSensitive(each, "from")->valuestring, ==, "Gravity");
        CLOSE(x, 0.0, 1e-12);
        CLOSE(y, -weight, 1e-12);
        acting++;
    }
    g_assert_cmpint(acting, ==, 1);
    cJSON_Delete(diagram);
}

/* On its way up, at the top, where it is at rest for an instant, and down. */
void check_thrown_up(const char *path)
{
    const double top = 6.0 / GRAVITY, times[] = {0.2, top, 1.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        g_autofree char *time = g_strdup_printf("%.17g", times[row]);
        CLOSE(test_table_value(record, row, "Ball.vy"), 6.0 - GRAVITY * times[row], 1e-11);
        check_only_weight(path, time, 0.5 * GRAVITY);
        g_autoptr(TestTable) acceleration = measure_columns_at(path, time, "Ball.ay");
        CLOSE(test_table_value(acceleration, 0, "Ball.ay"), -GRAVITY, 1e-12);
    }
    CLOSE(test_table_value(record, 1, "Ball.y"), 36.0 / (2.0 * GRAVITY), 1e-11);
}

/* m g, m g cos 30 degrees, m g - F sin 60 degrees and m (g + a): of blocks that stay where they are put. */
void check_normal_forces(const char *path)
{
    static const char *const names[] = {"Level", "Inclined", "Pulled", "Lifted"};
    const double mass = 2.0, weight = mass * GRAVITY;
    const double expected[] = {weight, weight * cos(G_PI / 6.0), weight - 10.0 * sin(G_PI / 3.0),
                               mass * (GRAVITY + 1.0)};
    const double times[] = {0.0, 0.5, 1.9};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        g_autofree char *force = g_strdup_printf("%s.normal force", names[i]);
        g_autofree char *x = g_strdup_printf("%s.x", names[i]), *y = g_strdup_printf("%s.y", names[i]);
        g_autoptr(TestTable) forces = measure_columns_at(path, "0.5,1.9", force);
        for (gsize row = 1; row < record->rows; row++) {
            const double rise = i == 3 ? 0.5 * times[row] * times[row] : 0.0;
            CLOSE(test_table_value(forces, row - 1, force), expected[i], 1e-9);
            CLOSE(test_table_value(record, row, x), test_table_value(record, 0, x), 1e-9);
            CLOSE(test_table_value(record, row, y) - test_table_value(record, 0, y), rise, 1e-9);
        }
    }
}

/* From m v^2 / L = T - m g sin b and v^2 = 2 g L sin b: T = 3 m g sin b, where the bob is L sin b below the pivot. The
 * lowest point is reached after a quarter of a period. */
void check_rod_tension(const char *path)
{
    const double length = 2.0, pivot = 2.0;
    const double lowest = sqrt(length / GRAVITY) * measure_quarter_period(G_PI / 2.0);
    const double times[] = {0.0, 0.3, 0.6, lowest, 2.0};
    g_autoptr(TestTable) record = measure_at(path, times, G_N_ELEMENTS(times));
    for (gsize row = 0; row < record->rows; row++) {
        const double sine = (pivot - test_table_value(record, row, "Swinging.y")) / length;
        CLOSE(test_table_value(record, row, "Swinging rod.tension"), 3.0 * GRAVITY * sine, 1e-7);
        CLOSE(test_table_value(record, row, "Still rod.tension"), GRAVITY, 1e-9);
    }
    CLOSE(test_table_value(record, 0, "Swinging rod.tension"), 0.0, 1e-9);
    CLOSE(test_table_value(record, 3, "Swinging rod.tension"), 3.0 * GRAVITY, 1e-7);
}
