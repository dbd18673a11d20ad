/* Who looks when changes no bit: every bundled scene and random ones, by every method, contacts as events and as
 * impulses, with samples of several kinds. Times that two records share have the same values to the last bit, and runs
 * of one length the same summary. */
#include "physics-fixture.h"

#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

/* s: of a bundled scene, which may be longer; every method goes so far. */
#define LONGEST 0.8
#define SAMPLES 10
/* In a crowd, beside those of the base. */
#define CROWD  57
#define RANDOM 60

typedef struct {
    GArray *samples; /* of double: time and values */
    gsize width;
    TinkerModel *model;
    TinkerSimulation *simulation;
    GError *error;
} Record;

static void record_clear(Record *record)
{
    g_array_unref(record->samples);
    tinker_simulation_free(record->simulation);
    tinker_model_free(record->model);
    g_clear_error(&record->error);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Record, record_clear)

static gboolean keep(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Record *record = data;
    (void)simulation, (void)error;
    g_array_append_val(record->samples, time);
    g_array_append_vals(record->samples, values, (guint)record->width - 1);
    return TRUE;
}

/* FALSE where the method does not suit the scene. */
static gboolean make_record(TinkerScene *scene, const TinkerRunOptions *options, Record *record)
{
    g_autoptr(GArray) columns = tinker_columns_default(scene);
    record->samples = g_array_new(FALSE, FALSE, sizeof(double));
    record->width = columns->len + 1;
    record->model = tinker_model_new(scene, &record->error);
    g_assert_no_error(record->error);
    record->simulation = tinker_simulation_new(record->model, options, &record->error);
    if (record->simulation == NULL) return FALSE;
    tinker_simulation_run(record->simulation, columns, keep, record, &record->error);
    return TRUE;
}

static gsize length_of(const Record *record)
{
    return record->samples->len / record->width;
}

static const double *row_of(const Record *record, gsize i)
{
    return &g_array_index(record->samples, double, i * record->width);
}

static void compare_rows(const char *what, const Record *base, const Record *other)
{
    gsize k = 0, shared = 0;
    for (gsize i = 0; i < length_of(other); i++) {
        const double *row = row_of(other, i);
        while (k < length_of(base) && row_of(base, k)[0] < row[0])
            k++;
        if (k == length_of(base) || row_of(base, k)[0] != row[0]) continue;
        shared++;
        for (gsize c = 1; c < base->width; c++) {
            if (memcmp(&row[c], &row_of(base, k)[c], sizeof(double)) == 0) continue;
            g_test_fail_printf("%s: at t = %.17g s column %d is %.17g, and was %.17g", what, row[0], (int)c, row[c],
                               row_of(base, k)[c]);
            return;
        }
    }
    if (base->error == NULL && shared == 0) g_test_fail_printf("%s: no sample in common", what);
}

static void compare_summaries(const char *what, const Record *base, const Record *other)
{
    const TinkerSummary *l = tinker_simulation_summary(base->simulation);
    const TinkerSummary *r = tinker_simulation_summary(other->simulation);
    gboolean same = l->steps == r->steps && l->rejected_steps == r->rejected_steps && l->evaluations == r->evaluations;
    const double left[] = {l->simulated_s,     l->valid_until,   l->kinetic_end,
                           l->potential_end,   l->kinetic_start, l->energy_balance_error,
                           l->potential_start, l->start_impulse, l->constraint_position_error};
    const double right[] = {r->simulated_s,     r->valid_until,   r->kinetic_end,
                            r->potential_end,   r->kinetic_start, r->energy_balance_error,
                            r->potential_start, r->start_impulse, r->constraint_position_error};
    same = same && memcmp(left, right, sizeof left) == 0 && memcmp(l->books, r->books, sizeof l->books) == 0;
    same = same && l->events->len == r->events->len;
    for (guint i = 0; same && i < l->events->len; i++) {
        const TinkerEvent *a = g_ptr_array_index(l->events, i), *b = g_ptr_array_index(r->events, i);
        same = a->time == b->time && g_str_equal(a->kind, b->kind) && g_str_equal(a->blocks, b->blocks);
    }
    if (!same)
        g_test_fail_printf("%s: the summary is another one (steps %d and %d, evaluations %d and %d, events %d and %d)",
                           what, (int)l->steps, (int)r->steps, (int)l->evaluations, (int)r->evaluations,
                           (int)l->events->len, (int)r->events->len);
}

/* `whole`: the run is as long as the base. */
static void compare(const char *what, TinkerScene *scene, const TinkerRunOptions *options, const Record *base,
                    gboolean whole)
{
    g_auto(Record) other = {0};
    g_assert_true(make_record(scene, options, &other));
    compare_rows(what, base, &other);
    if (base->error == NULL && other.error != NULL && whole) g_test_fail_printf("%s: %s", what, other.error->message);
    if (base->error == NULL && whole) compare_summaries(what, base, &other);
}

static int by_size(const void *left, const void *right)
{
    double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

/* A run that is looked at ten times, and the same looked at otherwise: rarely, often, at a crowd of times, at two that
 * end it early, and beyond its end. */
static void check(const char *what, TinkerScene *scene, TinkerRunOptions options, GRand *random)
{
    double duration = options.duration, times[SAMPLES + CROWD + 1];
    options.interval = duration / SAMPLES;
    options.estimate = FALSE;
    g_auto(Record) base = {0};
    if (!make_record(scene, &options, &base)) return;
    static const double shares[] = {1, 0.31, 0.0137, 1.0 / (7 * SAMPLES)};
    for (gsize i = 0; i < G_N_ELEMENTS(shares); i++) {
        g_autofree char *name = g_strdup_printf("%s, interval %g", what, shares[i] * duration);
        options.interval = shares[i] * duration;
        compare(name, scene, &options, &base, TRUE);
    }
    gsize count = 0;
    for (gsize i = 0; i < length_of(&base); i++)
        times[count++] = row_of(&base, i)[0];
    const double last = times[count - 1], early[] = {times[count / 3], times[count / 2]};
    for (int i = 0; i < CROWD; i++)
        times[count++] = g_rand_double_range(random, 0, last);
    qsort(times, count, sizeof(double), by_size);
    options.at = times;
    options.at_count = count;
    g_autofree char *crowd = g_strdup_printf("%s, a crowd", what), *less = g_strdup_printf("%s, early", what);
    compare(crowd, scene, &options, &base, TRUE);
    options.at = early;
    options.at_count = G_N_ELEMENTS(early);
    compare(less, scene, &options, &base, FALSE);
    const double beyond[] = {early[1], last, 1.3 * duration};
    g_autofree char *more = g_strdup_printf("%s, beyond", what);
    options.at = beyond;
    options.at_count = G_N_ELEMENTS(beyond);
    compare(more, scene, &options, &base, FALSE);
}

/* A scene that says itself that contacts are impulses is a pile, which by events would take minutes: so by them alone.
 */
static void check_methods(const char *what, TinkerScene *scene, double duration, GRand *random)
{
    TinkerRunOptions options = tinker_run_options_of(scene);
    const gboolean pile = options.impulses;
    options.duration = duration;
    options.step = 0.004;
    options.tolerance = 1e-7;
    options.impulses = FALSE;
    options.method = "auto";
    g_autofree char *automatic = g_strdup_printf("%s: auto", what);
    if (!pile) check(automatic, scene, options, random);
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); !pile && *each != NULL; each++) {
        g_autofree char *name = g_strdup_printf("%s: %s", what, (*each)->id);
        options.method = (*each)->id;
        check(name, scene, options, random);
    }
    g_autofree char *impulses = g_strdup_printf("%s: impulses", what);
    options.impulses = TRUE;
    check(impulses, scene, options, random);
}

static void test_bundled(gconstpointer data)
{
    const char *name = data;
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), name, NULL);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(scene_fixture_catalogue(), path, NULL, &error);
    g_assert_no_error(error);
    g_autoptr(GRand) random = g_rand_new_with_seed(g_str_hash(name));
    check_methods(name, scene, fmin(LONGEST, tinker_scene_head(scene)->run.duration), random);
}

/* Random scenes ---------------------------------------------------------------------------------------------------- */

static double between(GRand *random, double low, double high)
{
    return g_rand_double_range(random, low, high);
}

static gboolean one_in(GRand *random, int count)
{
    return g_rand_int_range(random, 0, count) == 0;
}

/* Masses in a row, each joined to the one before: by springs along one line, or by rods and springs in the plane. */
static void add_chain(GString *blocks, GRand *random, gboolean line)
{
    int masses = g_rand_int_range(random, 1, 5);
    double x = 0, y = 2;
    g_string_append(blocks, "{'type': 'support', 'name': 'S', 'position': [0, 2], 'solid': false}");
    for (int i = 0; i < masses; i++) {
        gboolean rod = !line && one_in(random, 2);
        char before[16] = "S";
        if (i > 0) g_snprintf(before, sizeof before, "m%d", i - 1);
        x += between(random, 0.5, 1.2);
        if (!line) y += between(random, -0.6, 0.6);
        g_string_append_printf(blocks,
                               ", {'type': 'mass', 'name': 'm%d', 'mass': %.17g, 'position': [%.17g, %.17g],"
                               "'velocity': [%.17g, 0]}, {'type': '%s', 'ends': ['%s', 'm%d']%s}",
                               i, between(random, 0.2, 2), x, y, rod || !line ? 0 : between(random, -1, 1),
                               rod ? "rod" : "spring", before, i, rod ? "" : ", 'stiffness': 40");
        if (!rod && one_in(random, 2))
            g_string_append_printf(blocks, ", {'type': 'damper', 'ends': ['%s', 'm%d'], 'damping': %.17g}", before, i,
                                   between(random, 0.1, 2));
    }
    static const char *const waveforms[] = {"'cosine', 'frequency': 8.3, 'phase': 0.4",
                                            "{'expression': 'square(9*t) + 0.3*t'}", "{'expression': 'exp(sin(4*t))'}"};
    if (!one_in(random, 3))
        g_string_append_printf(blocks, ", {'type': 'motor', 'ends': ['m%d'], 'angle': %.17g, 'waveform': %s}",
                               masses - 1, line ? 0 : between(random, -3, 3),
                               waveforms[g_rand_int_range(random, 0, 3)]);
    if (one_in(random, 3))
        g_string_append(blocks, ", {'type': 'support-motion', 'ends': ['S'], 'amplitude': 0.1, 'frequency': 7}");
}

/* Masses that fall into a wedge of two plates, or onto one that moves. */
static void add_wedge(GString *blocks, GRand *random)
{
    double restitution = one_in(random, 2) ? 0 : between(random, 0.1, 1), friction = one_in(random, 2) ? 0 : 0.4;
    for (int side = -1; side <= 1; side += 2)
        g_string_append_printf(blocks,
                               "{'type': 'support', 'name': 'P%d', 'position': [%d, 0], 'orientation': %.17g, 'width': "
                               "4.4, 'restitution': %.17g, 'static_friction': %.17g, 'dynamic_friction': %.17g}, ",
                               side, 2 * side, side * between(random, 0.1, 0.7), restitution, friction, 0.7 * friction);
    g_string_append_printf(blocks, "{'type': 'mass', 'name': 'm0', 'position': [%.17g, 1.6], 'velocity': [%.17g, 0]}",
                           between(random, -1, 1), between(random, -1, 1));
    if (one_in(random, 2))
        g_string_append_printf(blocks,
                               ", {'type': 'mass', 'name': 'm1', 'position': [%.17g, 2.4]}, {'type': '%s', 'ends': "
                               "['m0', 'm1']}",
                               between(random, -1, 1), one_in(random, 2) ? "rod" : "spring");
    if (one_in(random, 3))
        g_string_append(blocks, ", {'type': 'support-motion', 'ends': ['P1'], 'amplitude': 0.05, 'frequency': 12}");
}

static void test_random(gconstpointer data)
{
    int number = GPOINTER_TO_INT(data);
    g_autoptr(GRand) random = g_rand_new_with_seed(5000 + (guint32)number);
    g_autoptr(GString) blocks = g_string_new(NULL);
    int kind = number % 3;
    if (kind == 2)
        add_wedge(blocks, random);
    else
        add_chain(blocks, random, kind == 0);
    if (kind > 0) g_string_append(blocks, ", {'type': 'gravity'}");
    if (kind > 0 && one_in(random, 3)) g_string_append(blocks, ", {'type': 'wind', 'drag': 0.2}");
    g_test_message("%s", blocks->str);
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks->str);
    g_autofree char *what = g_strdup_printf("random scene %d", number);
    check_methods(what, scene, between(random, 0.3, 1.2), random);
}

static void add_tests(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GDir) folder = g_dir_open(g_getenv("TINKER_SCENES"), 0, &error);
    g_assert_no_error(error);
    for (const char *name; (name = g_dir_read_name(folder)) != NULL;) {
        if (!g_str_has_suffix(name, ".tinker.json")) continue;
        g_autofree char *path = g_strdup_printf("/physics/same-bits/bundled/%s", name);
        g_test_add_data_func_full(path, g_strdup(name), test_bundled, g_free);
    }
    for (int i = 0; i < RANDOM; i++) {
        g_autofree char *path = g_strdup_printf("/physics/same-bits/random/%d", i);
        g_test_add_data_func(path, GINT_TO_POINTER(i), test_random);
    }
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
