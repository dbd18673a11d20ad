/* Tops that a motion turns: what lies, slides, rolls and lands on them. In the axes of the top, turned by a with the
 * rate w about the origin, a place (X, Y) has the acceleration
 *
 *     (X'' - w' Y - w^2 X - 2 w Y',  Y'' + w' X - w^2 Y + 2 w X').
 */
#include "contact-checks.h"
#include "physics-fixture.h"

#include <math.h>

#define G           CONTACT_GRAVITY
#define PLANK       "{'type': 'support', 'width': 20, 'height': 0.2, 'static_friction': %g, 'dynamic_friction': %g}, "
#define TURN        "{'type': 'support-turn', 'ends': ['Support 0'], 'waveform': {'expression': '%s'}}"
#define TOP         0.1
#define TO_AND_FRO  "0.3*sin(2*t)"
#define DISC_RADIUS 0.4

/* Of TO_AND_FRO: the angle and its derivatives. */
static void to_and_fro(double t, double turned[3])
{
    turned[0] = 0.3 * sin(2 * t);
    turned[1] = 0.6 * cos(2 * t);
    turned[2] = -1.2 * sin(2 * t);
}

static void assert_in_axes(const PhysicsRun *run, gsize sample, double angle, double along, double over, double bound)
{
    const double c = cos(angle), s = sin(angle);
    physics_assert_near("x", physics_value(run, sample, 0), c * along - s * over, bound);
    physics_assert_near("y", physics_value(run, sample, 1), s * along + c * over, bound);
}

/* Where something is along a top that turns TO_AND_FRO, (X, X') at t, and how the top has turned by then. */
typedef struct {
    double t, y[2], turned[3];
} Along;

/* Follows the law of y up to a sample, and holds the place recorded there, `over` the middle of the plank, against it.
 */
static void assert_follows(const PhysicsRun *run, gsize sample,
                           void (*law)(double t, const double *y, double *rate, const void *data), double over,
                           double bound, Along *along)
{
    physics_rk4(2, along->y, along->t, physics_time(run, sample), 500, law, NULL);
    along->t = physics_time(run, sample);
    to_and_fro(along->t, along->turned);
    assert_in_axes(run, sample, along->turned[0], along->y[0], over, bound);
}

typedef struct {
    double rate, friction, along, over;
} Held;

/* At the even rate w the top holds a mass at (X, Y) with N = m (g cos a - w^2 Y) and, along it, m (g sin a - w^2 X):
 * what friction may be more than that. */
static double friction_left(double t, const void *data)
{
    const Held *held = data;
    const double a = held->rate * t, square = held->rate * held->rate;
    return held->friction * (G * cos(a) - square * held->over) - (G * sin(a) - square * held->along);
}

static void test_slip(void)
{
    static const double rates[] = {0.2, 0.01};
    static const double heights[] = {0, 0.5};
    for (gsize i = 0; i < G_N_ELEMENTS(rates) * G_N_ELEMENTS(heights); i++) {
        const double rate = rates[i / 2], over = TOP + 0.5 * heights[i % 2];
        const double slips = contact_bisect(0, 1 / rate, friction_left, &(Held){rate, 0.5, 1, over});
        g_autofree char *angle = g_strdup_printf("%g*t", rate);
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = "auto", .duration = slips + 1, .columns = "Mass 0.x, Mass 0.y"},
            CONTACT_WEIGHT PLANK "{'type': 'mass', 'position': [1, %g], 'height': %g, 'velocity': [%g, %g]}, " TURN,
            0.5, 0.3, over, heights[i % 2], -rate * over, rate, angle);
        contact_assert_event(run, "slip", NULL, slips, 1e-8);
        if (rate < 0.1) physics_assert_near("at the angle of friction", rate * slips, atan(0.5), 1e-4);
        for (gsize k = 0; k < physics_samples(run) && physics_time(run, k) < slips; k++)
            assert_in_axes(run, k, rate * physics_time(run, k), 1, over, 1e-12);
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-8);
    }
}

/* A box that turns with the top needs no torque for that, and slips where a mass does; so does one on a level floor
 * that is pushed 0.1 m above it, with more of its weight on the corner in front: both corners slip at once. */
static void test_box_slips(void)
{
    const double rate = 0.2, over = TOP + 0.25;
    const double slips = contact_bisect(0, 1 / rate, friction_left, &(Held){rate, 0.5, 1, over});
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = slips + 0.5, .columns = "Box 0.x, Box 0.y"},
        CONTACT_WEIGHT PLANK "{'type': 'box', 'position': [1, %g], 'width': 0.3, 'height': 0.5, 'velocity': [%g, %g],"
                             " 'angular_velocity': %g}, " TURN,
        0.5, 0.3, over, -rate * over, rate, rate, "0.2*t");
    contact_assert_event(run, "slip", NULL, slips, 1e-8);
    contact_assert_count(run, "slip", 1);
    for (gsize k = 0; k < physics_samples(run) && physics_time(run, k) < slips; k++)
        assert_in_axes(run, k, rate * physics_time(run, k), 1, over, 1e-12);

    const double force = 2;
    g_autoptr(PhysicsRun) pushed = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 6, .columns = "Box 0.vx"},
        CONTACT_WEIGHT PLANK "{'type': 'box', 'mass': 2, 'position': [0, 0.2], 'width': 0.2, 'height': 0.2},"
                             "{'type': 'motor', 'ends': ['Box 0'], 'waveform': {'expression': '2*t'}}",
        0.5, 0.3);
    const double begins = 0.5 * 2 * G / force;
    contact_assert_event(pushed, "slip", NULL, begins, 1e-9);
    contact_assert_count(pushed, "slip", 1);
    const double speed = 0.5 * (36 - begins * begins) - 0.3 * G * (6 - begins);
    physics_assert_near("speed", physics_last(pushed, 0), speed, 1e-8);
}

/* A box slides to rest on a level floor while a force F = 2 t on its middle grows: m v' = F - 0.3 m g. Both of its
 * corners stop at once, and hold with the static coefficient until F = 0.5 m g, whatever its height. */
static void test_box_stops(void)
{
    static const double heights[] = {0.1, 0.4};
    const double braked = 0.3 * G, stops = braked - sqrt(braked * braked - 2), slips = 0.5 * G;
    for (gsize i = 0; i < G_N_ELEMENTS(heights); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = "auto", .duration = 6, .columns = "Box 0.vx"},
            CONTACT_WEIGHT PLANK "{'type': 'box', 'mass': 2, 'position': [0, %g], 'velocity': [1, 0], 'width': 0.4, "
                                 "'height': %g},"
                                 "{'type': 'motor', 'ends': ['Box 0'], 'waveform': {'expression': '2*t'}}",
            0.5, 0.3, TOP + 0.5 * heights[i], heights[i]);
        contact_assert_event(run, "stick", NULL, stops, 1e-9);
        contact_assert_event(run, "slip", NULL, slips, 1e-9);
        contact_assert_count(run, "reversal", 0);
        physics_assert_near("speed", physics_last(run, 0), 0.5 * (36 - slips * slips) - 0.3 * G * (6 - slips), 1e-8);
    }
}

/* y = (X, X'), without friction. */
static void slide(double t, const double *y, double *rate, const void *data)
{
    double turned[3];
    (void)data;
    to_and_fro(t, turned);
    rate[0] = y[1];
    rate[1] = -G * sin(turned[0]) + turned[2] * TOP + turned[1] * turned[1] * y[0];
}

static void test_smooth(void)
{
    static const struct {
        const char *method;
        double bound;
    } cases[] = {{"dop853", 1e-10}, {"rk4", 1e-10}, {"verlet", 3e-6}, {"newmark", 1e-5}};
    for (gsize m = 0; m < G_N_ELEMENTS(cases); m++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.method = cases[m].method,
                                          .duration = 2,
                                          .step = 1e-3,
                                          .columns = "Mass 0.x, Mass 0.y, Mass 0.normal force"},
                        CONTACT_WEIGHT PLANK
                        "{'type': 'mass', 'mass': 1, 'position': [1, 0.1], 'velocity': [-0.06, 0.6], 'width': 0,"
                        " 'height': 0}, " TURN,
                        0.0, 0.0, TO_AND_FRO);
        Along along = {.y = {1, 0}};
        const double *y = along.y, *turned = along.turned;
        for (gsize i = 0; i < physics_samples(run); i++) {
            assert_follows(run, i, slide, TOP, cases[m].bound, &along);
            const double press =
                G * cos(turned[0]) + turned[2] * y[0] - turned[1] * turned[1] * TOP + 2 * turned[1] * y[1];
            physics_assert_near("presses with", physics_value(run, i, 2), press, 10 * cases[m].bound);
        }
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-5);
    }
}

/* Where a mass without friction is along a top that turns evenly by w, from X0 with the speed v along it. */
typedef struct {
    double rate, from, speed;
} Sliding;

static double slides_to(double t, const void *data)
{
    const Sliding *sliding = data;
    const double w = sliding->rate, falls = G / (2 * w * w);
    return sliding->from * cosh(w * t) + (sliding->speed / w - falls) * sinh(w * t) + falls * sin(w * t);
}

static double to_the_end(double t, const void *data)
{
    return slides_to(t, data) + 10;
}

/* A mass leaves the end for good: it has no other place to lie on, and nothing follows. */
static void test_leaves_the_end(void)
{
    const Sliding sliding = {0.1, 1, -10};
    const double leaves = contact_bisect(0, 2, to_the_end, &sliding);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = leaves + 1},
                    CONTACT_WEIGHT PLANK "{'type': 'mass', 'position': [1, 0.1], 'velocity': [-10.01, 0.1],"
                                         " 'width': 0, 'height': 0}, " TURN,
                    0.0, 0.0, "0.1*t");
    contact_assert_event(run, "end", "Mass 0, Support 0", leaves, 1e-9);
    const TinkerEvent *last = g_ptr_array_index(run->summary->events, run->summary->events->len - 1);
    g_assert_true(last == contact_event_at(run, "end", leaves));
    g_assert_false(last->stays);
    TinkerBodySample body;
    g_assert_true(tinker_simulation_body(run->simulation, tinker_scene_find_block(run->scene, "Mass 0"), &body));
    physics_assert_near("turned as it left", body.orientation, 0.1 * leaves, 1e-9);
}

/* A disc that rolls, X' + r (w_disc - w) = 0: (m + I / r^2) X'' = m (w' Y + w^2 X - g sin a) + I w' / r. */
static void roll(double t, const double *y, double *rate, const void *data)
{
    double turned[3];
    (void)data;
    to_and_fro(t, turned);
    const double asked = turned[2] * (TOP + DISC_RADIUS) + turned[1] * turned[1] * y[0] - G * sin(turned[0]);
    rate[0] = y[1];
    rate[1] = (asked + 0.5 * turned[2] * DISC_RADIUS) / 1.5;
}

static void test_rolling(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){
            .method = "auto", .duration = 2, .tolerance = 1e-11, .columns = "Disc 0.x, Disc 0.y, Disc 0.angle"},
        CONTACT_WEIGHT PLANK "{'type': 'disc', 'mass': 3, 'radius': 0.4, 'position': [1, 0.5], 'velocity': [-0.3, 0.6],"
                             " 'angular_velocity': 0.6}, " TURN,
        1.0, 1.0, TO_AND_FRO);
    Along along = {.y = {1, 0}};
    for (gsize i = 0; i < physics_samples(run); i++) {
        assert_follows(run, i, roll, TOP + DISC_RADIUS, 1e-8, &along);
        const double rolled = along.turned[0] - (along.y[0] - 1) / DISC_RADIUS;
        physics_assert_near("angle", physics_value(run, i, 2), rolled, 1e-8);
    }
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-8);
}

/* Over a smooth top that turns evenly at BLOW_RATE: how far a mass is that falls from rest. */
#define BLOW_RATE 0.5
#define BLOW_X    2
#define BLOW_FROM 1.1

static double fallen_over(double t, const void *data)
{
    const double a = BLOW_RATE * t;
    (void)data;
    return -sin(a) * BLOW_X + cos(a) * (BLOW_FROM - 0.5 * G * t * t) - TOP;
}

/* Where it meets the top, this moves at w (-Y, X) in its own axes, and the speed along its normal beside that is thrown
 * back by half. */
static void test_blow(void)
{
    const double meets = contact_bisect(0, 1, fallen_over, NULL), a = BLOW_RATE * meets;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .duration = meets + 0.1, .columns = "Mass 0.vx, Mass 0.vy"},
                    CONTACT_WEIGHT "{'type': 'support', 'width': 20, 'height': 0.2, 'static_friction': 0, "
                                   "'dynamic_friction': 0, 'restitution': 0.5},"
                                   "{'type': 'mass', 'position': [2, 1.1], 'width': 0, 'height': 0}, " TURN,
                    "0.5*t");
    contact_assert_event(run, "impact", NULL, meets, 1e-9);
    const double n[2] = {-sin(a), cos(a)}, fallen = -G * meets, y = BLOW_FROM - 0.5 * G * meets * meets;
    const double along = cos(a) * BLOW_X + sin(a) * y, relative = n[1] * fallen - BLOW_RATE * along;
    const double thrown = -1.5 * relative;
    physics_assert_near("vx", physics_last(run, 0), thrown * n[0], 1e-8);
    physics_assert_near("vy", physics_last(run, 1), fallen + thrown * n[1] - G * 0.1, 1e-8);
}

static void test_impulses_refuse(void)
{
    g_autoptr(PhysicsRun) run =
        physics_try(&(PhysicsOptions){.method = "auto", .step = 1e-3, .impulses = TRUE, .duration = 1},
                    CONTACT_WEIGHT PLANK "{'type': 'mass', 'position': [1, 1]}, " TURN, 0.5, 0.3, TO_AND_FRO);
    physics_assert_refused(run, TINKER_MODEL_ERROR_METHOD, "Support 0 turns", "leave \"contacts\" out", NULL);
    /* what is told of is the body at the other end of the rod, not the first that may meet it */
    g_autoptr(PhysicsRun) tied =
        physics_try(&(PhysicsOptions){.method = "auto", .step = 1e-3, .impulses = TRUE, .duration = 1}, CONTACT_WEIGHT
                    "{'type': 'support', 'width': 6}, {'type': 'box', 'name': 'Far', 'position': [2, 0.5]},"
                    "{'type': 'box', 'name': 'Near', 'position': [0, 0.5]},"
                    "{'type': 'support', 'position': [2, 3], 'solid': false},"
                    "{'type': 'rod', 'ends': ['Support 1', 'Far']}, {'type': 'mass', 'position': [0, 2]},"
                    "{'type': 'rod', 'ends': ['Near', 'Mass 0']}");
    physics_assert_refused(tied, TINKER_MODEL_ERROR_METHOD, "constraints tie it to Near", "leave \"contacts\" out",
                           NULL);
}

static void add_tests(void)
{
    g_test_add_func("/contact/tilting/slip", test_slip);
    g_test_add_func("/contact/tilting/box-slips", test_box_slips);
    g_test_add_func("/contact/tilting/box-stops", test_box_stops);
    g_test_add_func("/contact/tilting/smooth", test_smooth);
    g_test_add_func("/contact/tilting/leaves-the-end", test_leaves_the_end);
    g_test_add_func("/contact/tilting/rolling", test_rolling);
    g_test_add_func("/contact/tilting/blow", test_blow);
    g_test_add_func("/contact/tilting/impulses-refuse", test_impulses_refuse);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
