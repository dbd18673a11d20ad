/* Running a scene by one method after the other; see the header. */
#include "net-run.h"

#include <math.h>
#include <string.h>

#include "net-table.h"
#include "net-take.h"
#include "numerics/methods/integrators.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "scene/read/scene-json.h"

#define IMPULSE "impulse"
#define OWN     "own"

/* How far a run goes, at most: what takes long is cut by counts, never by the clock, so that every machine cuts at the
 * same place. */
#define LONGEST         10.0 /* s */
#define LEAST_STEPS     50
#define MOST_BODY_STEPS 200000 /* of a fixed step: steps, each counted once for every body */
#define MOST_CALLS      4000   /* of `cancelled`, one in some 256 of those */
#define SAMPLES         24

GStrv net_methods_new(TinkerCatalogue *catalogue)
{
    g_autoptr(GStrvBuilder) methods = g_strv_builder_new();
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    g_strv_builder_add_many(methods, "auto", IMPULSE, OWN, NULL);
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++)
        g_strv_builder_add(methods, (*each)->id);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        for (guint k = 0; k < library->integrators->len; k++)
            g_strv_builder_add(methods, g_ptr_array_index(library->integrators, k));
    }
    return g_strv_builder_end(methods);
}

static gboolean has_had_enough(void *data)
{
    int *calls = data;
    return ++*calls > MOST_CALLS;
}

static TinkerRunOptions options_of(TinkerScene *scene, const TinkerModel *model, const char *method, int *calls)
{
    TinkerRunOptions options = tinker_run_options_of(scene);
    if (!g_str_equal(method, OWN)) {
        options.accuracy = 0;
        options.impulses = g_str_equal(method, IMPULSE);
        options.method = options.impulses ? "auto" : method;
    }
    const double steps = fmax(MOST_BODY_STEPS / fmax(tinker_model_sizes(model).bodies, 1), LEAST_STEPS);
    const double longest = fmax(fmin(LONGEST, steps * options.step), LEAST_STEPS * options.step);
    options.duration = fmin(options.duration, longest);
    options.interval = options.duration / SAMPLES;
    options.bands = TRUE;
    options.cancelled = has_had_enough;
    options.data = calls;
    return options;
}

/* Every quantity of every block, whether it is usually recorded or not. */
static GArray *all_columns(TinkerScene *scene)
{
    GArray *columns = tinker_columns_new();
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        const TinkerBlockClass *class = tinker_scene_block_class(scene, block);
        for (int32_t q = 0; class != NULL && q < class->quantity_count; q++)
            tinker_columns_add_quantity(columns, scene, block, q);
    }
    return columns;
}

/* The hash of bytes, which are put into the store under it. (transfer full) */
static char *keep(const void *bytes, gsize length, const char *store, GError **error)
{
    g_autofree char *hash = g_compute_checksum_for_data(G_CHECKSUM_SHA256, bytes, length);
    g_autofree char *path = store != NULL ? g_build_filename(store, hash, NULL) : NULL;
    if (path != NULL && !g_file_test(path, G_FILE_TEST_EXISTS) &&
        !g_file_set_contents(path, bytes, (gssize)length, error))
        return NULL;
    return g_steal_pointer(&hash);
}

static void add_refused(GPtrArray *table, const NetScene *scene, const char *method, const GError *why)
{
    const char *fields[] = {scene->name, method, "refused", "0", "-", "-", "-", "0", "0", why->message, NULL};
    net_table_add(table, fields);
}

static const char *status_of(const GError *failure)
{
    if (failure == NULL) return "done";
    if (g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY)) return "missed";
    return g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED) ? "cut" : "stopped";
}

static gboolean add_run(GPtrArray *table, const NetScene *scene, const char *method, const NetTake *take,
                        const TinkerSummary *summary, const GError *failure, const char *store, GError **error)
{
    g_autofree char *text = net_summary_text(summary);
    g_autofree char *record = keep(take->record->data, take->record->len, store, error);
    g_autofree char *estimate = record == NULL ? NULL : keep(take->estimate->data, take->estimate->len, store, error);
    g_autofree char *told = estimate == NULL ? NULL : keep(text, strlen(text), store, error);
    g_autofree char *samples = g_strdup_printf("%" G_GINT64_FORMAT, take->samples);
    g_autofree char *steps = g_strdup_printf("%" G_GINT64_FORMAT, summary->steps);
    g_autofree char *evaluations = g_strdup_printf("%" G_GINT64_FORMAT, summary->evaluations);
    if (told == NULL) return FALSE;
    const char *fields[] = {scene->name,
                            method,
                            status_of(failure),
                            samples,
                            record,
                            estimate,
                            told,
                            steps,
                            evaluations,
                            failure != NULL ? failure->message : "-",
                            NULL};
    net_table_add(table, fields);
    return TRUE;
}

static gboolean run(TinkerScene *read, const NetScene *scene, const char *method, const char *store, GPtrArray *table,
                    GError **error)
{
    g_autoptr(GError) failure = NULL;
    int calls = 0;
    g_autoptr(TinkerModel) model = tinker_model_new(read, &failure);
    if (model == NULL) {
        add_refused(table, scene, method, failure);
        return TRUE;
    }
    TinkerRunOptions options = options_of(read, model, method, &calls);
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &failure);
    if (simulation == NULL) {
        add_refused(table, scene, method, failure);
        return TRUE;
    }
    g_autoptr(GArray) columns = all_columns(read);
    g_autoptr(NetTake) take = net_take_new(columns);
    TinkerSampleTaker taker = net_take_samples(take);
    tinker_accurate_run(&simulation, columns, &taker, &failure);
    return add_run(table, scene, method, take, tinker_simulation_summary(simulation), failure, store, error);
}

gboolean net_run_scene(TinkerCatalogue *catalogue, const NetScene *scene, GHashTable *wanted, const char *store,
                       GPtrArray *table, GError **error)
{
    g_auto(GStrv) methods = net_methods_new(catalogue);
    g_autoptr(GError) unreadable = NULL;
    TinkerScene *read = tinker_scene_read_text(catalogue, scene->text, strlen(scene->text), NULL, NULL, &unreadable);
    gboolean fine = TRUE;
    for (char **method = methods; fine && *method != NULL; method++) {
        g_autofree char *key = g_strdup_printf("%s\t%s", scene->name, *method);
        if (wanted != NULL && !g_hash_table_contains(wanted, key)) continue;
        if (read == NULL)
            add_refused(table, scene, *method, unreadable);
        else
            fine = run(read, scene, *method, store, table, error);
    }
    tinker_scene_free(read);
    return fine;
}
