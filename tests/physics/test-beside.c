/* The companion on a thread of its own: what comes out has the same bits as where one thread does all, whoever looks
 * when; it is the run's thread that asks and tells the user; and a companion that fails, or that nobody wants any
 * more, keeps nothing from ending. */
#include <math.h>
#include <string.h>

#include "numerics/sharing/sharing.h"
#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/plan/run-options.h"

#define PENDULUM                                                                                                       \
    "{'type': 'support', 'solid': false}, {'type': 'gravity'}, {'type': 'mass', 'position': [1, 0]},"                  \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 100}"
#define DOUBLE_PENDULUM                                                                                                \
    "{'type': 'support', 'solid': false}, {'type': 'gravity'}, {'type': 'mass', 'position': [1, 0]},"                  \
    "{'type': 'mass', 'position': [2, 0.1]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"                        \
    "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}"
/* Ends that pass each other, beside what is driven with breaks, and what needs no companion. */
#define PASSING                                                                                                        \
    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0], 'velocity': [-0.7, 0]},"                \
    "{'type': 'mass', 'position': [2, 0]},"                                                                            \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 200, 'rest_length': 0},"                         \
    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 50, 'rest_length': 1},"                             \
    "{'type': 'support', 'solid': false, 'position': [5, 0]}, {'type': 'mass', 'position': [5, -1.2]},"                \
    "{'type': 'spring', 'ends': ['Support 1', 'Mass 2'], 'rest_length': 1},"                                           \
    "{'type': 'motor', 'ends': ['Mass 2'], 'waveform': {'expression': 'step(sin(3*t))'}},"                             \
    "{'type': 'mass', 'position': [9, -1.5]}, {'type': 'motor', 'ends': ['Mass 3'], 'waveform': 'sine'}"
#define BOUNCING                                                                                                       \
    "{'type': 'support', 'width': 50, 'restitution': 1}, {'type': 'gravity'},"                                         \
    "{'type': 'mass', 'position': [0, 2], 'velocity': [0.01, 0]}, {'type': 'mass', 'position': [1, 2.5]},"             \
    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 30}"
/* At the middle of a step, which begins then (s), the force is 0/0: half a step ends there. */
#define STEP     0.0078125
#define FAILS_AT 45.0
#define FAILING                                                                                                        \
    "{'type': 'mass'}, {'type': 'motor', 'ends': ['Mass 0'],"                                                          \
    "'waveform': {'expression': 'sin(t-45.00390625)/(t-45.00390625)'}}"

typedef struct {
    const char *name, *blocks;
    PhysicsOptions options;
} Case;

static const Case cases[] = {
    {"dop853", PENDULUM, {.method = "dop853", .duration = 250, .tolerance = 1e-9}},
    {"dopri5", PENDULUM, {.method = "dopri5", .duration = 120, .interval = 0.03, .tolerance = 1e-7}},
    {"rk4", PENDULUM, {.method = "rk4", .duration = 60, .step = 5e-3}},
    {"verlet", PENDULUM, {.method = "verlet", .duration = 60, .step = 5e-3}},
    {"verlet6, rods", DOUBLE_PENDULUM, {.method = "verlet6", .duration = 30, .step = 5e-3}},
    {"dop853, rods", DOUBLE_PENDULUM, {.method = "dop853", .duration = 200, .interval = 0.05, .tolerance = 1e-9}},
    {"auto, passing", PASSING, {.method = "auto", .duration = 150, .interval = 0.1}},
    {"dop853, passing, bands", PASSING, {.method = "dop853", .duration = 60, .interval = 0.1, .bands = TRUE}},
    {"auto, bouncing", BOUNCING, {.method = "auto", .duration = 100, .interval = 0.1, .tolerance = 1e-9}},
    {"impulses, bouncing", BOUNCING, {.method = "auto", .duration = 50, .step = 5e-3, .impulses = TRUE}},
    {"failing", FAILING, {.method = "verlet", .duration = 75, .step = STEP}},
    {"failing, bands", FAILING, {.method = "verlet", .duration = 75, .step = STEP, .bands = TRUE}},
};

#define COLUMNS 4

/* What a run showed. */
typedef struct {
    GArray *values, *claims; /* of double */
    GArray *found;           /* of double: what the run was told of, as soon as it was found */
    GString *told;           /* what stands in the summary */
    gint64 threads;          /* of this process, at most */
    gboolean looks;
} Shown;

static void shown_clear(Shown *shown)
{
    g_array_unref(shown->values);
    g_array_unref(shown->claims);
    g_array_unref(shown->found);
    g_string_free(shown->told, TRUE);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Shown, shown_clear)

/* 0 where the system does not tell. */
static gint64 count_threads(void)
{
    gint64 count = 0;
    g_autoptr(GDir) tasks = g_dir_open("/proc/self/task", 0, NULL);
    while (tasks != NULL && g_dir_read_name(tasks) != NULL)
        count++;
    return count;
}

static gboolean note(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Shown *shown = data;
    g_array_append_val(shown->values, time);
    g_array_append_vals(shown->values, values, COLUMNS);
    shown->threads = MAX(shown->threads, count_threads());
    const double *bands = shown->looks ? tinker_simulation_bands(simulation) : NULL;
    if (bands != NULL) g_array_append_vals(shown->claims, bands, COLUMNS);
    const double claim = shown->looks ? tinker_simulation_error(simulation) : 0;
    if (shown->looks) g_array_append_val(shown->claims, claim);
    return TRUE;
}

static void note_found(const TinkerFound *found, void *data)
{
    Shown *shown = data;
    const double numbers[] = {found->t, found->error, found->predictable_until};
    g_array_append_vals(shown->found, numbers, G_N_ELEMENTS(numbers));
    if (found->bands != NULL) g_array_append_vals(shown->found, found->bands, COLUMNS);
}

static void show(const Case *this, int threads, gboolean looks, Shown *shown)
{
    PhysicsOptions options = this->options;
    *shown = (Shown){.values = g_array_new(FALSE, FALSE, sizeof(double)),
                     .claims = g_array_new(FALSE, FALSE, sizeof(double)),
                     .found = g_array_new(FALSE, FALSE, sizeof(double)),
                     .told = g_string_new(NULL),
                     .looks = looks};
    options.estimate = TRUE;
    options.columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy";
    options.found = note_found;
    options.found_data = shown;
    tinker_share_set_threads(threads);
    g_autoptr(PhysicsRun) run = physics_prepare(&options, "%s", this->blocks);
    g_assert_cmpuint(run->columns->len, ==, COLUMNS);
    g_assert_true(tinker_simulation_run(run->simulation, run->columns, note, shown, &run->error));
    g_assert_no_error(run->error);
    const TinkerSummary *summary = tinker_simulation_summary(run->simulation);
    g_string_printf(shown->told, "error %a, predictable until %a, %d steps, %d evaluations, balance %a",
                    summary->error_estimate, summary->predictable_until, (int)summary->steps, (int)summary->evaluations,
                    summary->energy_balance_error);
    for (guint i = 0; i < summary->warnings->len; i++)
        g_string_append_printf(shown->told, "\n%s", tinker_warnings_text(summary->warnings, i));
    if (options.bands && this->options.duration > 0) {
        const double *bands = tinker_simulation_bands(run->simulation);
        for (guint c = 0; c < run->columns->len; c++)
            g_string_append_printf(shown->told, "\nband %a", bands[c]);
    }
}

static void assert_same(const Shown *left, const Shown *right)
{
    g_assert_cmpmem(left->values->data, left->values->len * sizeof(double), right->values->data,
                    right->values->len * sizeof(double));
    g_assert_cmpstr(left->told->str, ==, right->told->str);
    g_assert_cmpmem(left->found->data, left->found->len * sizeof(double), right->found->data,
                    right->found->len * sizeof(double));
    if (left->looks && right->looks)
        g_assert_cmpmem(left->claims->data, left->claims->len * sizeof(double), right->claims->data,
                        right->claims->len * sizeof(double));
}

/* What is told when it is found, and what who waits is told at the sample, are one and the same. */
static void assert_found(const Case *this, const Shown *looked_at)
{
    const guint bands = this->options.bands ? COLUMNS : 0, claim = bands + 1, found = 3 + bands;
    guint told = 0;
    for (guint i = 1; (i + 1) * claim <= looked_at->claims->len && (i + 1) * found <= looked_at->found->len; i++) {
        const double *one = &g_array_index(looked_at->claims, double, i *claim);
        const double *other = &g_array_index(looked_at->found, double, i *found);
        if (isnan(other[1])) break; /* the companion stopped, and nothing more is found */
        g_assert_cmpfloat(other[0], ==, g_array_index(looked_at->values, double, i *(1 + COLUMNS)));
        g_assert_cmpfloat(other[1], ==, one[bands]);
        g_assert_cmpmem(&other[3], bands * sizeof(double), one, bands * sizeof(double));
        told++;
    }
    g_assert_cmpuint(told, >, 3);
}

static void test_same_bits(gconstpointer data)
{
    const Case *this = data;
    g_auto(Shown) alone = {0};
    g_auto(Shown) looked_at = {0};
    show(this, 1, FALSE, &alone);
    show(this, 1, TRUE, &looked_at);
    assert_same(&alone, &looked_at);
    assert_found(this, &looked_at);
    for (int round = 0; round < 3; round++) {
        g_auto(Shown) beside = {0};
        show(this, 2, round == 2, &beside);
        assert_same(&alone, &beside);
        assert_same(&looked_at, &beside);
        if (round < 2 && alone.threads > 0 && !this->options.bands)
            g_assert_cmpint(beside.threads, ==, alone.threads + 1);
    }
}

/* Its warning names the time, and comes before those that the run has later. */
static void test_failing(void)
{
    for (int threads = 1; threads <= 2; threads++) {
        PhysicsOptions options = {.method = "verlet", .duration = 75, .step = STEP, .estimate = TRUE};
        tinker_share_set_threads(threads);
        g_autoptr(PhysicsRun) run = physics_run(&options, FAILING);
        const GPtrArray *warnings = run->summary->warnings;
        g_autofree char *words =
            g_strdup_printf("there is no error estimate beyond t = %.6g s: the companion run", FAILS_AT);
        guint found = 0;
        for (guint i = 0; i < warnings->len; i++)
            found += g_str_has_prefix(tinker_warnings_text(warnings, i), words);
        g_assert_cmpint(found, ==, 1);
        g_assert_true(isnan(run->summary->error_estimate));
        g_assert_cmpfloat(run->summary->simulated_s, ==, 75);
    }
}

/* A user who has had enough after some questions, and what was asked by whom. */
typedef struct {
    GThread *runs;
    gint64 asked, after, elsewhere, told;
} User;

static gboolean had_enough(void *data)
{
    User *user = data;
    user->elsewhere += g_thread_self() != user->runs;
    return ++user->asked > user->after;
}

static void progress(double t, double duration, void *data)
{
    User *user = data;
    user->elsewhere += g_thread_self() != user->runs;
    user->told++;
}

/* Answers whether the run was stopped. */
static gboolean run_for(User *user, const char *blocks, const char *method)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.method = method;
    options.step = 5e-3;
    options.tolerance = 1e-9;
    options.duration = 60;
    options.interval = 0.5;
    options.cancelled = had_enough;
    options.progress = progress;
    options.data = user;
    user->runs = g_thread_self();
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    g_assert_no_error(error);
    if (tinker_simulation_run(simulation, NULL, NULL, NULL, &error)) return FALSE;
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED);
    const TinkerSummary *summary = tinker_simulation_summary(simulation);
    g_assert_cmpfloat(summary->simulated_s, <, 60);
    return TRUE;
}

static void test_users(void)
{
    for (int threads = 1; threads <= 2; threads++) {
        tinker_share_set_threads(threads);
        User patient = {.after = G_MAXINT64};
        g_assert_false(run_for(&patient, PENDULUM, "rk4"));
        g_assert_cmpint(patient.elsewhere, ==, 0);
        g_assert_cmpint(patient.told, >, 10);
        for (gint64 after = 2; after < patient.asked * 3 / 4; after += MAX(patient.asked / 8, 1)) {
            User user = {.after = after};
            g_assert_true(run_for(&user, PENDULUM, "rk4"));
            g_assert_cmpint(user.elsewhere, ==, 0);
        }
    }
}

static void add_tests(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *path = g_strdup_printf("/physics/beside/same-bits/%s", cases[i].name);
        g_test_add_data_func(path, &cases[i], test_same_bits);
    }
    g_test_add_func("/physics/beside/failing", test_failing);
    g_test_add_func("/physics/beside/users", test_users);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
