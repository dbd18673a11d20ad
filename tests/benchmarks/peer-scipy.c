/* Runs peer-scipy.py and reads what it prints. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "peers.h"

#define NO_SCIPY 3

static void clear_row(gpointer row)
{
    g_free(((PeerScipyRow *)row)->method);
}

static double number(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItem(object, key);
    return cJSON_IsNumber(item) ? item->valuedouble : NAN;
}

static const char *string(const cJSON *object, const char *key)
{
    const char *text = cJSON_GetStringValue(cJSON_GetObjectItem(object, key));
    return text != NULL ? text : "";
}

static double error_at_end(const PeerProblem *problem, const cJSON *end)
{
    double y[PEER_MOST_RATES];
    if (cJSON_GetArraySize(end) != problem->size) return NAN;
    for (int i = 0; i < problem->size; i++)
        y[i] = cJSON_GetArrayItem(end, i)->valuedouble;
    return problem->error(problem->duration, y);
}

static void add_row(GArray *rows, const char *line)
{
    cJSON *object = cJSON_Parse(line);
    const PeerProblem *problem = peer_problem_find(string(object, "scene"), string(object, "form"));
    if (problem != NULL) {
        PeerScipyRow row = {
            .method = g_strdup(string(object, "method")),
            .problem = problem,
            .tolerance = number(object, "tolerance"),
            .median = number(object, "median"),
            .least = number(object, "least"),
            .error = number(object, "error"),
        };
        const cJSON *end = cJSON_GetObjectItem(object, "end");
        if (end != NULL) row.error = error_at_end(problem, end);
        g_array_append_val(rows, row);
    }
    cJSON_Delete(object);
}

/* NULL where this Python is missing or has no SciPy. One thread: the others have no more. */
static char *output_of(const char *python, const char *scene)
{
    const char *arguments[] = {python, BENCHMARK_SCIPY, scene, NULL};
    char *output = NULL;
    int status = 0;
    g_auto(GStrv) environment = g_environ_setenv(g_get_environ(), "OPENBLAS_NUM_THREADS", "1", TRUE);
    if (!g_spawn_sync(NULL, (char **)arguments, environment, G_SPAWN_SEARCH_PATH, NULL, NULL, &output, NULL, &status,
                      NULL))
        return NULL;
    g_autoptr(GError) error = NULL;
    if (g_spawn_check_wait_status(status, &error)) return output;
    if (!g_error_matches(error, G_SPAWN_EXIT_ERROR, NO_SCIPY)) g_printerr("%s: %s\n", python, error->message);
    g_free(output);
    return NULL;
}

GArray *peer_scipy(const char *scene)
{
    static const char *const pythons[] = {"python3", "/usr/bin/python3"};
    GArray *rows = g_array_new(FALSE, FALSE, sizeof(PeerScipyRow));
    g_array_set_clear_func(rows, clear_row);
    g_autofree char *output = NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(pythons) && output == NULL; i++)
        output = output_of(pythons[i], scene);
    if (output == NULL) return rows;
    g_auto(GStrv) lines = g_strsplit(output, "\n", -1);
    for (int i = 0; lines[i] != NULL; i++)
        if (lines[i][0] != '\0') add_row(rows, lines[i]);
    return rows;
}
