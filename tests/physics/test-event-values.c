/* The columns on both sides of events, against closed forms; and that asking for them changes neither samples nor
 * steps.
 */
#include <math.h>
#include <string.h>

#include "physics-fixture.h"

#define GRAVITY 9.81
#define FALL    sqrt(2 / GRAVITY) /* s: from 1 m */

typedef struct {
    double time, before[8], behind[8];
} Event;

typedef struct {
    guint columns;
    GArray *events, *samples, *orientations; /* of Event; of double; of double */
    TinkerBlockId of;                        /* whose orientations */
    gint64 steps, evaluations;
} Taken;

static gboolean take_sample(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Taken *taken = data;
    g_array_append_val(taken->samples, time);
    g_array_append_vals(taken->samples, values, taken->columns);
    TinkerBodySample body;
    if (tinker_simulation_body(simulation, taken->of, &body)) g_array_append_val(taken->orientations, body.orientation);
    return TRUE;
}

static gboolean take_event(TinkerSimulation *simulation, double time, const double *before, const double *behind,
                           void *data, GError **error)
{
    Taken *taken = data;
    Event event = {.time = time};
    memcpy(event.before, before, taken->columns * sizeof(double));
    memcpy(event.behind, behind, taken->columns * sizeof(double));
    g_array_append_val(taken->events, event);
    return TRUE;
}

static void taken_free(Taken *taken)
{
    g_array_unref(taken->events);
    g_array_unref(taken->samples);
    g_array_unref(taken->orientations);
    g_free(taken);
}
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Taken, taken_free)

/* (transfer full) */
static Taken *take(const PhysicsOptions *options, gboolean at_events, const char *blocks)
{
    g_autoptr(PhysicsRun) run = physics_prepare(options, "%s", blocks);
    Taken *taken = g_new0(Taken, 1);
    const TinkerSampleTaker taker = {take_sample, NULL, at_events ? take_event : NULL, taken};
    taken->columns = run->columns->len;
    taken->events = g_array_new(FALSE, FALSE, sizeof(Event));
    taken->samples = g_array_new(FALSE, FALSE, sizeof(double));
    taken->orientations = g_array_new(FALSE, FALSE, sizeof(double));
    taken->of = tinker_scene_find_block(run->scene, "M");
    tinker_accurate_run(&run->simulation, run->columns, &taker, &run->error);
    g_assert_no_error(run->error);
    const TinkerSummary *summary = tinker_simulation_summary(run->simulation);
    taken->steps = summary->steps;
    taken->evaluations = summary->evaluations;
    return taken;
}

static const Event *event_of(const Taken *taken, guint number)
{
    return &g_array_index(taken->events, Event, number);
}

#define FLOOR                                                                                                          \
    "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], 'width': 8, 'restitution': 0.5, "                 \
    "'static_friction': 0, 'dynamic_friction': 0}, "
#define POINT "{'type': 'mass', 'width': 0, 'height': 0, 'restitution': 0.5, "
#define BALL  POINT "'name': 'M', 'position': [0, 1]}"
/* A mass that is struck by a top which turns to and fro, slides along it, and comes to rest on it. */
#define ON_A_TURNING_TOP                                                                                               \
    "{'type': 'gravity'}, {'type': 'support', 'width': 20, 'height': 0.2, 'static_friction': 0.3, "                    \
    "'dynamic_friction': 0.3}, {'type': 'mass', 'name': 'M', 'position': [1, 0.2], 'width': 0.2, 'height': 0.2, "      \
    "'velocity': [1, 0], 'static_friction': 0.3, 'dynamic_friction': 0.3}, {'type': 'support-turn', 'ends': "          \
    "['Support 0'], 'waveform': {'expression': '0.1*sin(4*t)'}}"

/* Dropped from 1 m, with a restitution of 0.5: the speed of impact is sqrt(2 g), and each flight lasts half as long. */
static void check_bounces(const char *method, const char *blocks)
{
    const PhysicsOptions options = {.method = method, .duration = 1.25, .interval = 0.05, .columns = "M.y,M.vy"};
    g_autoptr(Taken) taken = take(&options, TRUE, blocks);
    double t = FALL, speed = sqrt(2 * GRAVITY);
    g_assert_cmpuint(taken->events->len, ==, 4);
    for (guint i = 0; i < taken->events->len; i++) {
        const Event *event = event_of(taken, i);
        physics_assert_near("time", event->time, t, 1e-9);
        physics_assert_near("height before", event->before[0], 0, 1e-9);
        physics_assert_near("height behind", event->behind[0], 0, 1e-9);
        physics_assert_near("velocity before", event->before[1], -speed, 1e-8);
        physics_assert_near("velocity behind", event->behind[1], 0.5 * speed, 1e-8);
        speed *= 0.5;
        t += 2 * speed / GRAVITY;
    }
}

static void test_ball(void)
{
    check_bounces("dop853", FLOOR BALL);
    check_bounces("exact", FLOOR BALL);
}

/* Of two that fall one after the other, each is known at the other's impact: they are islands of their own, and one of
 * them flies in steps that go far beyond. */
static void test_two_balls(void)
{
    static const char blocks[] = FLOOR BALL ", " POINT "'name': 'N', 'position': [3, 1.2]}"
                                            ", " POINT "'name': 'P', 'position': [-9, 2]}";
    const PhysicsOptions options = {
        .duration = 0.7, .interval = 0.35, .columns = "M.vy,N.vy,N.y,P.vy,Scene.kinetic energy"};
    g_autoptr(Taken) taken = take(&options, TRUE, blocks);
    const double later = sqrt(2 * 1.2 / GRAVITY), rise = 0.5 * sqrt(2 * GRAVITY);
    g_assert_cmpuint(taken->events->len, ==, 2);
    const Event *first = event_of(taken, 0), *second = event_of(taken, 1);
    physics_assert_near("first", first->time, FALL, 1e-9);
    physics_assert_near("the other at the first", first->before[1], -GRAVITY * FALL, 1e-8);
    physics_assert_near("its height", first->behind[2], 0.2, 1e-9);
    physics_assert_near("the third at the first", first->before[3], -GRAVITY * FALL, 1e-8);
    physics_assert_near("second", second->time, later, 1e-9);
    physics_assert_near("the first at the second", second->before[0], rise - GRAVITY * (later - FALL), 1e-8);
    physics_assert_near("velocity before", second->before[1], -sqrt(2 * GRAVITY * 1.2), 1e-8);
    physics_assert_near("velocity behind", second->behind[1], 0.5 * sqrt(2 * GRAVITY * 1.2), 1e-8);
    const double lost = second->before[4] - second->behind[4];
    physics_assert_near("energy lost", lost, 0.75 * GRAVITY * 1.2, 1e-7);
}

/* A motor that is switched on pushes at once: the acceleration jumps by F / m, and nothing else does. */
static void test_switched_on(void)
{
    static const char blocks[] =
        "{'type': 'mass', 'name': 'M', 'mass': 2, 'position': [1, 0]}, "
        "{'type': 'motor', 'ends': ['M'], 'angle': 0, 'waveform': {'expression': 'if(t < 0.33, 0, 3)'}}";
    const PhysicsOptions options = {.duration = 1, .interval = 0.25, .columns = "M.ax,M.vx"};
    g_autoptr(Taken) taken = take(&options, TRUE, blocks);
    g_assert_cmpuint(taken->events->len, ==, 1);
    const Event *event = event_of(taken, 0);
    physics_assert_near("time", event->time, 0.33, 1e-12);
    physics_assert_near("acceleration before", event->before[0], 0, 1e-12);
    physics_assert_near("acceleration behind", fabs(event->behind[0]), 1.5, 1e-12);
    physics_assert_near("velocity", event->behind[1], event->before[1], 1e-12);
}

/* What slides comes to rest: its place goes on without a jump. At the same time, to the last bit, the force
 * on another begins to grow, which no column shows; its steps are shorter, so that it comes to that time later. The
 * event is told all the same. */
static void test_beside_a_break(void)
{
    static const char format[] =
        "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], 'width': 8}, "
        "{'type': 'mass', 'name': 'M', 'width': 0, 'height': 0, 'velocity': [1, 0], 'static_friction': 0.5, "
        "'dynamic_friction': 0.3}, {'type': 'mass', 'name': 'N', 'position': [9, 3]}, {'type': 'motor', "
        "'ends': ['N'], 'angle': 0, 'waveform': {'expression': '3*sin(200*t) + if(t < %.17g, 0, t - %.17g)'}}";
    const PhysicsOptions options = {.method = "dop853", .duration = 1, .interval = 0.25, .columns = "M.x,N.x"};
    g_autofree char *late = g_strdup_printf(format, 2.0, 2.0);
    g_autoptr(Taken) alone = take(&options, TRUE, late);
    g_assert_cmpuint(alone->events->len, ==, 1);
    const double stops = event_of(alone, 0)->time;
    g_autofree char *tied = g_strdup_printf(format, stops, stops);
    g_autoptr(Taken) taken = take(&options, TRUE, tied);
    g_assert_cmpuint(taken->events->len, ==, 1);
    physics_assert_near("time", event_of(taken, 0)->time, stops, 0);
}

/* Half waves of a force begin and end at 0, but for the rounding of pi: nothing jumps there. */
static void test_half_waves(void)
{
    static const char blocks[] = "{'type': 'mass', 'name': 'M', 'mass': 2, 'position': [1, 0]}, "
                                 "{'type': 'motor', 'ends': ['M'], 'angle': 0, 'waveform': "
                                 "{'expression': 'if(sin(2*pi*t) < 0, 0, sin(2*pi*t))'}}";
    const PhysicsOptions options = {.method = "dop853", .duration = 3.2, .interval = 0.1, .columns = "M.ax,M.vx,M.x"};
    g_autoptr(Taken) taken = take(&options, TRUE, blocks);
    g_assert_cmpuint(taken->events->len, ==, 0);
}

static void assert_same_angle(double left, double right)
{
    g_assert_true(left == right || (isnan(left) && isnan(right)));
}

/* Whoever asks at events gets the samples that all others get by the same steps, to the last bit. */
static void check_same(const PhysicsOptions *options, const char *blocks)
{
    g_autoptr(Taken) with = take(options, TRUE, blocks), without = take(options, FALSE, blocks);
    g_assert_cmpuint(with->events->len, >, 0);
    g_assert_cmpuint(without->events->len, ==, 0);
    g_assert_cmpuint(with->samples->len, ==, without->samples->len);
    g_assert_cmpint(memcmp(with->samples->data, without->samples->data, with->samples->len * sizeof(double)), ==, 0);
    g_assert_cmpuint(with->orientations->len, >, 0);
    for (guint i = 0; i < with->orientations->len; i++)
        assert_same_angle(g_array_index(with->orientations, double, i),
                          g_array_index(without->orientations, double, i));
    g_assert_cmpint(with->steps, ==, without->steps);
    g_assert_cmpint(with->evaluations, ==, without->evaluations);
}

static void test_same_samples(void)
{
    static const char two[] = FLOOR BALL ", " POINT "'name': 'N', 'position': [3, 1.3]}";
    static const char *const methods[] = {"auto", "dop853", "rk4", "verlet", "newmark"};
    PhysicsOptions options = {.duration = 1.5, .step = 7e-4, .interval = 0.01, .columns = "M.y,M.vy,N.y"};
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(methods); i++) {
        options.method = methods[i / 2];
        options.estimate = i % 2;
        check_same(&options, two);
    }
    options = (PhysicsOptions){.duration = 1, .interval = 0.01, .columns = "M.x,M.vx,M.ax"};
    check_same(&options, ON_A_TURNING_TOP);
}

/* The length of a path is added up to each event, too, and so rounds in another way. */
static void test_path_length(void)
{
    static const char *const methods[] = {"dop853", "rk4", "verlet"};
    for (gsize k = 0; k < G_N_ELEMENTS(methods); k++) {
        const PhysicsOptions options = {
            .method = methods[k], .duration = 1.5, .step = 7e-4, .interval = 0.01, .columns = "M.path length"};
        g_autoptr(Taken) with = take(&options, TRUE, FLOOR BALL), without = take(&options, FALSE, FLOOR BALL);
        g_assert_cmpuint(with->samples->len, ==, without->samples->len);
        for (guint i = 0; i < with->samples->len; i++)
            physics_assert_near("sample", g_array_index(with->samples, double, i),
                                g_array_index(without->samples, double, i), 1e-12);
        g_assert_cmpint(with->steps, ==, without->steps);
        g_assert_cmpint(with->evaluations, ==, without->evaluations);
    }
}

/* A force of 10^4 switchings a second is told no more often than it is sampled, and a few hundred times. */
static void test_bounded(void)
{
    static const char blocks[] =
        "{'type': 'mass', 'name': 'M', 'mass': 2, 'position': [1, 0]}, "
        "{'type': 'motor', 'ends': ['M'], 'angle': 0, 'waveform': {'expression': 'if(sin(2*pi*1000*t) < 0, -1, 1)'}}";
    const PhysicsOptions options = {.method = "rk4", .duration = 1, .interval = 0.01, .columns = "M.ax"};
    g_autoptr(Taken) taken = take(&options, TRUE, blocks);
    g_assert_cmpuint(taken->events->len, >=, 256);
    g_assert_cmpuint(taken->events->len, <=, 256 + 101);
}

static void add_tests(void)
{
    g_test_add_func("/physics/event-values/ball", test_ball);
    g_test_add_func("/physics/event-values/two-balls", test_two_balls);
    g_test_add_func("/physics/event-values/switched-on", test_switched_on);
    g_test_add_func("/physics/event-values/beside-a-break", test_beside_a_break);
    g_test_add_func("/physics/event-values/half-waves", test_half_waves);
    g_test_add_func("/physics/event-values/same-samples", test_same_samples);
    g_test_add_func("/physics/event-values/path-length", test_path_length);
    g_test_add_func("/physics/event-values/bounded", test_bounded);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
