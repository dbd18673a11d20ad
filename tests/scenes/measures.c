/* Measures of a run, worked out from records alone. */
#include "measures.h"

#include <complex.h>
#include <math.h>
#include <string.h>

#include "program.h"

/* Samples in a period, for amplitudes. */
enum { PERIOD_SAMPLES = 16 };

TestTable *measure_at(const char *path, const double *times, gsize count)
{
    TestSceneRun *run = test_scene_run_at(path, times, count, "1e-11");
    TestTable *record = run->record;
    cJSON_Delete(run->summary);
    g_free(run);
    return record;
}

TestTable *measure_columns_at(const char *path, const char *time, const char *columns)
{
    const char *options[] = {"--at", time, "--tolerance", "1e-11", "--columns", columns, NULL};
    TestSceneRun *run = test_scene_run(path, options);
    TestTable *record = run->record;
    cJSON_Delete(run->summary);
    g_free(run);
    return record;
}

double measure_amplitude(const TestTable *record, const char *column, double w)
{
    double complex sum = 0.0;
    for (gsize row = 0; row < record->rows; row++)
        sum += test_table_value(record, row, column) * cexp(-I * w * test_table_value(record, row, "time"));
    return 2.0 / (double)record->rows * cabs(sum);
}

TestTable *measure_last_period(const char *path, double w, double until)
{
    double times[PERIOD_SAMPLES];
    for (int i = 0; i < PERIOD_SAMPLES; i++)
        times[i] = until - 2.0 * G_PI / w * (double)(PERIOD_SAMPLES - 1 - i) / PERIOD_SAMPLES;
    return measure_at(path, times, PERIOD_SAMPLES);
}

/* Energy of all masses in the record's row: kinetic, weight under gravity, and what the springs named have stored. */
static double mechanical_energy(const cJSON *scene, const TestTable *record, gsize row, double gravity)
{
    double energy = 0.0;
    const cJSON *block;
    cJSON_ArrayForEach(block, cJSON_GetObjectItemCaseSensitive(scene, "blocks"))
    {
        const char *name = cJSON_GetObjectItemCaseSensitive(block, "name")->valuestring;
        const char *type = cJSON_GetObjectItemCaseSensitive(block, "type")->valuestring;
        g_autofree char *y = g_strconcat(name, ".y", NULL), *vx = g_strconcat(name, ".vx", NULL);
        g_autofree char *vy = g_strconcat(name, ".vy", NULL), *stored = g_strconcat(name, ".energy", NULL);
        if (strcmp(type, "mass") == 0) {
            const double m = cJSON_GetObjectItemCaseSensitive(block, "mass")->valuedouble;
            const double u = test_table_value(record, row, vx), v = test_table_value(record, row, vy);
            energy += 0.5 * m * (u * u + v * v) + m * gravity * test_table_value(record, row, y);
        } else if (strcmp(type, "spring") == 0) {
            energy += test_table_value(record, row, stored);
        }
    }
    return energy;
}

/* Names of everything that mechanical_energy looks at. */
static char *energy_columns(const cJSON *scene)
{
    GString *list = g_string_new(NULL);
    const cJSON *block;
    cJSON_ArrayForEach(block, cJSON_GetObjectItemCaseSensitive(scene, "blocks"))
    {
        const char *name = cJSON_GetObjectItemCaseSensitive(block, "name")->valuestring;
        const char *type = cJSON_GetObjectItemCaseSensitive(block, "type")->valuestring;
        const char *comma = list->len > 0 ? "," : "";
        if (strcmp(type, "mass") == 0)
            g_string_append_printf(list, "%s%s.y,%s.vx,%s.vy", comma, name, name, name);
        else if (strcmp(type, "spring") == 0)
            g_string_append_printf(list, "%s%s.energy", comma, name);
    }
    return g_string_free(list, FALSE);
}

void measure_check_energy(const char *path, double gravity, const char *duration)
{
    cJSON *scene = test_read_json(path);
    g_autofree char *columns = energy_columns(scene);
    const char *options[] = {"--duration",  duration, "--interval", "0.1",   "--method", "auto",
                             "--tolerance", "1e-11",  "--columns",  columns, NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    const double start = mechanical_energy(scene, run->record, 0, gravity);
    double kinetic = 0.0, worst = 0.0;
    for (gsize row = 0; row < run->record->rows; row++) {
        kinetic = fmax(kinetic, mechanical_energy(scene, run->record, row, 0.0));
        worst = fmax(worst, fabs(mechanical_energy(scene, run->record, row, gravity) - start));
    }
    cJSON_Delete(scene);
    g_assert_cmpfloat(kinetic, >, 0.1);
    g_assert_cmpfloat(worst, <, 1e-8 * kinetic);
}

double measure_quarter_period(double angle)
{
    double a = 1.0, b = cos(0.5 * angle);
    while (fabs(a - b) > 1e-15) {
        const double mean = 0.5 * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return 0.5 * G_PI / a;
}
