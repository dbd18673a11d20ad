/* Rods on supports that move, against an independent integration of the angle. */
#include "physics-fixture.h"
#include "physics/model/model.h"

#include <math.h>

#define SHAKEN_SAMPLES 2000 /* forty to a swing of the fast one: of too few a run warns */

/* A support at u(t) along the vertical; theta from the downward vertical: L theta'' = -(g + u'') sin theta. */
typedef struct {
    double length, gravity, amplitude, rate;
} Shaken;

static void shaken_rate(double t, const double *y, double *rate, const void *data)
{
    const Shaken *s = data;
    double up = -s->amplitude * s->rate * s->rate * sin(s->rate * t);
    rate[0] = y[1];
    rate[1] = -(s->gravity + up) / s->length * sin(y[0]);
}

static void check_shaken(const Shaken *s, double theta, double duration, int steps, double bound)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = duration,
                          .interval = duration / SHAKEN_SAMPLES,
                          .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy, Rod 0.tension"},
        "{'type': 'support', 'solid': false}, {'type': 'gravity', 'acceleration': %.17g},"
        "{'type': 'mass', 'position': [%.17g, %.17g], 'velocity': [0, %.17g]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': %.17g},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': %.17g, 'frequency': %.17g, 'angle': '90 deg'}",
        s->gravity, s->length * sin(theta), -s->length * cos(theta), s->amplitude * s->rate, s->length, s->amplitude,
        s->rate);
    g_assert_cmpuint(run->summary->warnings->len, ==, 0);
    double y[2] = {theta, 0};
    for (gsize i = 1; i < physics_samples(run); i++) {
        double t = physics_time(run, i), up = s->amplitude * sin(s->rate * t), speed = s->amplitude * s->rate;
        physics_rk4(2, y, physics_time(run, i - 1), t, steps / SHAKEN_SAMPLES, shaken_rate, s);
        double c = cos(y[0]), n = sin(y[0]), acceleration = -up * s->rate * s->rate;
        physics_assert_near("x", physics_value(run, i, 0), s->length * n, bound);
        physics_assert_near("y", physics_value(run, i, 1), up - s->length * c, bound);
        physics_assert_near("vx", physics_value(run, i, 2), s->length * y[1] * c, bound * speed);
        physics_assert_near("vy", physics_value(run, i, 3), speed * cos(s->rate * t) + s->length * y[1] * n,
                            bound * speed);
        double tension = (s->gravity + acceleration) * c + s->length * y[1] * y[1];
        physics_assert_near("tension", physics_value(run, i, 4), tension, bound * speed * s->rate);
    }
}

/* Kapitza's pendulum stands upside down while its support shakes fast enough: (A w)^2 > 2 g L. */
static void test_kapitza(void)
{
    Shaken s = {1.0, 9.81, 0.1, 100};
    check_shaken(&s, 3.0, 3, 40000, 1e-8);
}

static void test_slowly_shaken(void)
{
    Shaken s = {1.3, 9.81, 0.4, 4};
    check_shaken(&s, 0.5, 5, 40000, 1e-8);
}

/* The support's motion pulls the rod sideways; the mass on the turning ring of two moving supports keeps its length. */
static void test_length_on_moving_support(void)
{
    static const char *const methods[] = {"rk4", "verlet"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[m],
                              .duration = 50,
                              .interval = 0.137,
                              .columns = "Rod 0.length error, Rod 1.length error"},
            "{'type': 'support', 'solid': false}, {'type': 'gravity'}, {'type': 'mass', 'position': [0, -1]},"
            "{'type': 'mass', 'position': [0.5, -2]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
            "{'type': 'rod', 'ends': ['Mass 1', 'Mass 0']},"
            "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.5, 'frequency': 3, 'waveform': 'cosine'},"
            "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.5, 'frequency': 3, 'angle': '90 deg',"
            " 'phase': 1}");
        for (gsize i = 0; i < physics_samples(run); i++)
            for (gsize k = 0; k < 2; k++)
                physics_assert_near("length error", physics_value(run, i, k), 0, 1e-10);
        g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-10);
    }
}

/* A rod cannot follow a jump of its support, in place or in speed; a bend of the speed it can. */
static PhysicsRun *with_motion(const char *expression)
{
    return physics_try(&(PhysicsOptions){.duration = 2},
                       "{'type': 'support', 'solid': false, 'name': 'Ceiling'}, {'type': 'mass', 'position': [0, -1]},"
                       "{'type': 'rod', 'name': 'Stick', 'ends': ['Ceiling', 'Mass 0']},"
                       "{'type': 'support-motion', 'ends': ['Ceiling'], 'waveform': {'expression': '%s'}}",
                       expression);
}

static void test_jumps(void)
{
    g_autoptr(PhysicsRun) place = with_motion("0.1*step(t - 0.5)"), speed = with_motion("0.1*ramp(t - 0.5)");
    physics_assert_refused(place, TINKER_MODEL_ERROR_SCENE, "Ceiling", "Stick", "0.5 s", NULL);
    physics_assert_refused(speed, TINKER_MODEL_ERROR_SCENE, "Ceiling", "Stick", "0.5 s", NULL);
    g_autoptr(PhysicsRun) smooth = with_motion("0.1*ramp(t - 0.5)^2");
    g_assert_no_error(smooth->error);
}

/* An expression that is not 0 at the start: the rod's length as placed is that to the support where it is then. */
static void test_displaced_at_start(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.columns = "Rod 0.length error, Mass 0.x, Mass 0.y"},
                    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [3.5, -4]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 5},"
                    "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': 'cosine', 'amplitude': 0.5}");
    physics_assert_near("x", physics_last(run, 1), 3.5, 1e-14);
    physics_assert_near("y", physics_last(run, 2), -4, 1e-14);
}

/* A velocity of rounding at a pin that stands, beside a support that moves and is joined to nothing: it contradicts
 * nothing. The disc, of 0.08 kg m^2 on 2 N m/rad, swings with 5 rad/s. */
static void test_rounded_at_start(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.columns = "Disc 0.angle"},
                    "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [3, 0]},"
                    "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.1, 'frequency': 2},"
                    "{'type': 'disc', 'position': [0, 0], 'inertia': 0.08, 'angular_velocity': 1, 'velocity': [0, "
                    "1e-17], 'solid': false},"
                    "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                    "{'type': 'torsional-spring', 'ends': ['Disc 0', 'Support 1'], 'stiffness': 2}");
    physics_assert_near("angle", physics_last(run, 0), sin(5.0) / 5, 1e-10);
}

static void add_tests(void)
{
    g_test_add_func("/physics/moving-rods/kapitza", test_kapitza);
    g_test_add_func("/physics/moving-rods/slowly-shaken", test_slowly_shaken);
    g_test_add_func("/physics/moving-rods/length-on-moving-support", test_length_on_moving_support);
    g_test_add_func("/physics/moving-rods/jumps", test_jumps);
    g_test_add_func("/physics/moving-rods/displaced-at-start", test_displaced_at_start);
    g_test_add_func("/physics/moving-rods/rounded-at-start", test_rounded_at_start);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
