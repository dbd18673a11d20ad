/* Friction of pins: r mu / sqrt(1 + mu^2) times the pin's force, which sticks; against closed forms and an integral of
 * the pendulum's one coordinate, whose torque depends on the force that it changes. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

static const double g = CONTACT_GRAVITY;

#define ANCHOR "{'type': 'support', 'position': [0, 0], 'solid': false},"

static double arm_of(double radius, double mu)
{
    return radius * mu / sqrt(1 + mu * mu);
}

/* A balanced disc on a pin slows down evenly, the pin's force being its weight; it stops, and stays to the last bit. */
static void test_spins_down(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        const double arm = arm_of(0.1, 0.3), inertia = 2 * 0.25 / 2, rate = 20, bound = contact_methods[i].polynomial;
        const double stops = inertia * rate / (arm * 2 * g), turned = rate * stops / 2, at[] = {0, 1, 10, 12};
        PhysicsOptions options =
            contact_options(&contact_methods[i], 12,
                            "Disc 0.angle, Disc 0.angular velocity, Disc 0.x, Disc 0.y, Pin 0.torque, Pin 0.force y");
        options.at = at;
        options.at_count = G_N_ELEMENTS(at);
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT ANCHOR
                                                "{'type': 'disc', 'radius': 0.5, 'mass': 2, 'position': [0, 0],"
                                                " 'angular_velocity': 20, 'solid': false}, {'type': 'pin', 'ends':"
                                                " ['Support 0', 'Disc 0'], 'friction_radius': 0.1, 'friction': 0.3}");
        contact_assert_event(run, "stick", "Pin 0", stops, fmax(bound, 1e-9));
        g_assert_cmpuint(run->summary->events->len, ==, 1);
        physics_assert_near("torque", physics_value(run, 1, 4), arm * 2 * g, 1e-12);
        physics_assert_near("force", physics_value(run, 1, 5), -2 * g, 1e-12);
        physics_assert_near("rate", physics_value(run, 1, 1), rate - arm * 2 * g / inertia, bound);
        physics_assert_near("turned", physics_last(run, 0), turned, fmax(10 * bound, 1e-9));
        for (gsize column = 0; column < 4; column++)
            g_assert_cmpfloat(physics_value(run, 2, column), ==, physics_last(run, column));
        physics_assert_near("at rest", physics_last(run, 1), 0, 1e-30);
        physics_assert_near("no torque", physics_last(run, 4), 0, 1e-12);
        contact_assert_taken(run, inertia * rate * rate / 2, 0, fmax(bound, 1e-8));
    }
}

/* Two that have nothing to do with each other are stepped apart, and what is recorded of each pin is its own torque. */
static void test_apart(void)
{
    static const double masses[] = {2, 3}, radii[] = {0.1, 0.2}, coefficients[] = {0.3, 0.7};
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 0.5, .interval = 0.1, .columns = "Pin 0.torque, Pin 1.torque"},
        CONTACT_WEIGHT ANCHOR
        "{'type': 'disc', 'mass': %g, 'position': [0, 0], 'angular_velocity': 200, 'solid': false},"
        "{'type': 'disc', 'mass': %g, 'position': [9, 0], 'angular_velocity': 200, 'solid': false},"
        "{'type': 'pin', 'ends': ['Support 0', 'Disc 0'], 'friction_radius': %g, 'friction': %g},"
        "{'type': 'pin', 'ends': [{'block': 'Support 0', 'at': [9, 0]}, 'Disc 1'], 'friction_radius': %g, 'friction': "
        "%g}",
        masses[0], masses[1], radii[0], coefficients[0], radii[1], coefficients[1]);
    g_assert_cmpuint(run->summary->islands->len, ==, 2);
    for (gsize sample = 0; sample < physics_samples(run); sample++)
        for (gsize pin = 0; pin < 2; pin++)
            physics_assert_near("torque", physics_value(run, sample, pin),
                                arm_of(radii[pin], coefficients[pin]) * masses[pin] * g, 1e-11);
}

/* A bar that hangs askew stays where m g l sin a is at most the arm times m g: l sin a <= arm. */
static void test_cone(void)
{
    const double arm = arm_of(0.05, 0.4);
    for (int k = 0; k < 2; k++) {
        const double askew = asin(arm / 0.5) + (k == 0 ? -1e-6 : 1e-6), x = 0.5 * sin(askew), y = -0.5 * cos(askew);
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 60, .columns = "Bar 0.x, Bar 0.y, Bar 0.angle, Pin 0.torque"},
            CONTACT_WEIGHT ANCHOR "{'type': 'bar', 'length': 1, 'position': [%.17g, %.17g], 'orientation': %.17g},"
                                  "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}],"
                                  " 'friction_radius': 0.05, 'friction': 0.4}",
            x, y, askew - G_PI / 2);
        if (k == 0) {
            g_assert_cmpuint(run->summary->events->len, ==, 0);
            physics_assert_near("angle", physics_last(run, 2), askew - G_PI / 2, 0);
            physics_assert_near("x", physics_last(run, 0), x, 1e-16);
            physics_assert_near("torque", physics_last(run, 3), -g * x, 1e-12);
        } else {
            g_assert_cmpfloat(physics_last(run, 2), <, askew - G_PI / 2 - 1e-9);
        }
    }
}

typedef struct {
    double arm, sign; /* of the rate */
} Rubbing;

/* A bar of 1 kg and 1 m on a pin at its end, at an angle from the horizontal. With the centre's acceleration F is
 * (g sin - l w^2, g cos + l alpha) along the bar and across it, and (I alpha + g l cos)^2 = arm^2 F^2 is a quadratic of
 * alpha, of which the root counts whose torque is against the rate. */
static void swings(double t, const double *y, double *rate, const void *data)
{
    const Rubbing *rubbing = data;
    const double inertia = 1.0 / 3, l = 0.5, along = g * sin(y[0]) - l * y[1] * y[1], weight = g * cos(y[0]);
    const double square = rubbing->arm * rubbing->arm;
    const double a = inertia * inertia - square * l * l, b = inertia * l * weight - square * l * weight,
                 c = l * l * weight * weight - square * (weight * weight + along * along);
    rate[0] = y[1];
    rate[1] = (-b - rubbing->sign * sqrt(fmax(b * b - a * c, 0))) / a;
}

/* A pendulum from the horizontal through its first turn back, and what friction takes on the way. */
static void test_pendulum(void)
{
    const double h = 1e-4;
    Rubbing rubbing = {arm_of(0.05, 0.4), -1};
    double y[2] = {0, 0}, before[2], turns = 0, at[] = {0, 0.5, 0.9, 1.2, 1.6};
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1.6,
                                      .at = at,
                                      .at_count = G_N_ELEMENTS(at),
                                      .columns = "Bar 0.angle, Bar 0.angular velocity, Pin 0.torque, Pin 0.force"},
                    CONTACT_WEIGHT ANCHOR "{'type': 'bar', 'length': 1, 'position': [0.5, 0]},"
                                          "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}],"
                                          " 'friction_radius': 0.05, 'friction': 0.4}");
    gsize sample = 1;
    double t = 0;
    while (sample < G_N_ELEMENTS(at)) {
        const double to = fmin(t + h, at[sample]);
        before[0] = y[0], before[1] = y[1];
        physics_rk4(2, y, t, to, 1, swings, &rubbing);
        if (t > 0.1 && rubbing.sign * y[1] < 0) { /* halve to where the rate is 0, and go on the other way */
            double from = t, until = to;
            for (int k = 0; k < 60; k++) {
                const double middle = (from + until) / 2;
                y[0] = before[0], y[1] = before[1];
                physics_rk4(2, y, t, middle, 1, swings, &rubbing);
                *(rubbing.sign * y[1] < 0 ? &until : &from) = middle;
            }
            turns = t = until;
            y[1] = 0;
            rubbing.sign = -rubbing.sign;
            continue;
        }
        t = to;
        if (t != at[sample]) continue;
        physics_assert_near("angle", physics_value(run, sample, 0), y[0], 1e-9);
        physics_assert_near("rate", physics_value(run, sample, 1), y[1], 1e-8);
        physics_assert_near("torque", fabs(physics_value(run, sample, 2)), rubbing.arm * physics_value(run, sample, 3),
                            1e-12);
        sample++;
    }
    contact_assert_event(run, "reversal", "Pin 0", turns, 1e-9);
}

/* A support that is turned evenly drags a balanced disc along until both turn alike, and from then on exactly. */
static void test_dragged_along(void)
{
    const double arm = arm_of(0.1, 0.3), inertia = 2 * 0.25 / 2, alpha = arm * 2 * g / inertia, w = 3, amplitude = 50;
    /* 50 sin(3 t / 50) turns with 3 cos(0.06 t): met where alpha t is that, and from then on slowly enough to follow */
    double meets = w / alpha;
    for (int k = 0; k < 50; k++)
        meets = w * cos(w / amplitude * meets) / alpha;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 4, .columns = "Disc 0.angular velocity, Pin 0.torque, Disc 0.angle"},
        CONTACT_WEIGHT ANCHOR "{'type': 'support-turn', 'ends': ['Support 0'], 'waveform': 'sine', 'amplitude': 50,"
                              " 'frequency': 0.06}, {'type': 'disc', 'radius': 0.5, 'mass': 2, 'position': [0, 0],"
                              " 'solid': false}, {'type': 'pin', 'ends': ['Support 0', 'Disc 0'],"
                              " 'friction_radius': 0.1, 'friction': 0.3}");
    contact_assert_event(run, "stick", "Pin 0", meets, 1e-9);
    const double rate = w * cos(w / amplitude * 4), turned = alpha * meets * meets / 2;
    physics_assert_near("rate", physics_last(run, 0), rate, 1e-11);
    physics_assert_near("angle", physics_last(run, 2),
                        turned + amplitude * (sin(w / amplitude * 4) - sin(w / amplitude * meets)), 1e-9);
    physics_assert_near("torque", physics_last(run, 1), inertia * w * w / amplitude * sin(w / amplitude * 4), 1e-9);
}

/* Two discs on one pin of which nothing is held: the torque is inner, and with no force there is none. */
static void test_free(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 2, .columns = "Disc 0.angular velocity, Disc 1.angular velocity"},
                    "{'type': 'disc', 'position': [0, 0], 'angular_velocity': 3},"
                    "{'type': 'disc', 'position': [0, 0], 'angular_velocity': 1},"
                    "{'type': 'pin', 'ends': ['Disc 0', 'Disc 1'], 'friction_radius': 0.1, 'friction': 0.5}");
    physics_assert_near("first", physics_last(run, 0), 3, 1e-12);
    physics_assert_near("second", physics_last(run, 1), 1, 1e-12);
}

/* Their places may miss one another by rounding: what is corrected is a share of their size. */
static void test_one_place(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Disc 0.angular velocity"},
                    "{'type': 'disc', 'position': [4, 0.3], 'angular_velocity': 3, 'solid': false},"
                    "{'type': 'disc', 'position': [4, 0.30000000002], 'solid': false}, {'type': 'mass'},"
                    "{'type': 'pin', 'ends': ['Disc 0', 'Disc 1']}");
    physics_assert_near("rate", physics_last(run, 0), 3, 1e-9);
}

static void test_refused(void)
{
    g_autoptr(PhysicsRun) mass =
        physics_try(&(PhysicsOptions){.duration = 1},
                    ANCHOR "{'type': 'mass', 'position': [0, 0]}, {'type': 'pin', 'ends': ['Support 0', 'Mass 0'],"
                           " 'friction_radius': 0.1, 'friction': 0.3}");
    physics_assert_refused(mass, TINKER_MODEL_ERROR_SCENE, "Pin 0", "friction", "angle", NULL);
    g_autoptr(PhysicsRun) exact = physics_try(
        &(PhysicsOptions){.duration = 1, .method = "exact"},
        ANCHOR "{'type': 'disc', 'position': [0, 0], 'solid': false}, {'type': 'pin', 'ends': ['Support 0', 'Disc 0'],"
               " 'friction_radius': 0.1, 'friction': 0.3}");
    physics_assert_refused(exact, TINKER_MODEL_ERROR_METHOD, "pins have friction", NULL);
}

/* Two pins hold one disc to a support: their shares are not determined, which the run says. */
static void test_share(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.1}, CONTACT_WEIGHT ANCHOR
                    "{'type': 'disc', 'position': [0, 0], 'angular_velocity': 2, 'solid': false},"
                    "{'type': 'pin', 'ends': ['Support 0', 'Disc 0'], 'friction_radius': 0.1, 'friction':"
                    " 0.3}, {'type': 'pin', 'ends': ['Support 0', 'Disc 0']}");
    gboolean told = FALSE;
    for (guint i = 0; i < run->summary->warnings->len; i++)
        told |= strstr(tinker_warnings_text(run->summary->warnings, i), "share") != NULL;
    g_assert_true(told);
}

/* A pin that alone holds what it holds has a force that is determined, beside rods that are one too many. */
static void test_not_shared(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.1}, CONTACT_WEIGHT ANCHOR
                    "{'type': 'bar', 'position': [0.5, 0], 'length': 1}, {'type': 'pin', 'ends': ['Support 0',"
                    " {'block': 'Bar 0', 'at': [-0.5, 0]}], 'friction_radius': 0.1, 'friction': 0.3}, {'type': 'mass',"
                    " 'position': [1, -1]}, {'type': 'rod', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, 'Mass 0']},"
                    "{'type': 'rod', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, 'Mass 0']}");
    for (guint i = 0; i < run->summary->warnings->len; i++)
        g_assert_null(strstr(tinker_warnings_text(run->summary->warnings, i), "share"));
}

/* A bar of m = 2 kg, l = 1 m about its end: a blow S at its middle gives w = S (l / 2) / (m l^2 / 3), as if the pin
 * were smooth, and the run says so, once. */
static void test_struck(void)
{
    const double at[] = {1.5, 2.5};
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 3, .columns = "Bar 0.angular velocity", .at = at, .at_count = 2},
        ANCHOR "{'type': 'bar', 'mass': 2, 'length': 1, 'position': [0.5, 0]},"
               "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}],"
               " 'friction_radius': 1e-9, 'friction': 0.4},"
               "{'type': 'impulse', 'ends': ['Bar 0'], 'impulse': 1, 'angle': 1.5707963267948966, 'time': 1},"
               "{'type': 'impulse', 'ends': ['Bar 0'], 'angular_impulse': 0.5, 'time': 2}");
    physics_assert_near("struck", physics_value(run, 0, 0), 0.75, 1e-6);
    physics_assert_near("struck again", physics_value(run, 1, 0), 1.5, 1e-6);
    const GPtrArray *warnings = run->summary->warnings;
    g_assert_cmpuint(warnings->len, ==, 1);
    g_assert_true(
        g_str_has_prefix(tinker_warnings_text(warnings, 0), "Pin 0: its friction takes no part in the blow at 1 s"));
}

/* Runs for 2 s; the one warning has to be of a blow at that time, of Pin 0. */
static void assert_blow_at(double time, const char *blocks)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 2}, CONTACT_WEIGHT ANCHOR "%s", blocks);
    const char *told = "Pin 0: its friction takes no part in the blow at ";
    const GPtrArray *warnings = run->summary->warnings;
    g_assert_cmpuint(warnings->len, ==, 1);
    const char *warning = tinker_warnings_text(warnings, 0);
    g_assert_true(g_str_has_prefix(warning, told));
    physics_assert_near("told at", g_ascii_strtod(warning + strlen(told), NULL), time, 1e-5);
}

#define PIN "'friction_radius': 1e-3, 'friction': 0.4}"
#define HANGING                                                                                                        \
    "{'type': 'bar', 'solid': true, 'length': 1, 'position': [0, -0.5], 'orientation': -1.5707963267948966},"          \
    "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}], " PIN                                 \
    ", {'type': 'impulse', 'ends': ['Bar 0'], 'impulse': 1, 'time': 1.5}, "

/* A blow is one of a pin only where it reaches what the pin holds: not that of a ball on the floor beside it, nor of
 * what a spring or a slack rope joins to it. But that of a ball which falls onto a wheel towards its axle is, for
 * sqrt(2 h / g), though the wheel turns on as it did. */
static void test_struck_elsewhere(void)
{
    assert_blow_at(1.5, HANGING "{'type': 'support', 'position': [0, -3.2], 'width': 9},"
                                "{'type': 'disc', 'radius': 0.1, 'position': [2, -2.4]}");
    assert_blow_at(1.5,
                   HANGING "{'type': 'mass', 'position': [1, -1]}, {'type': 'spring', 'ends': ['Bar 0', 'Mass 0']},"
                           "{'type': 'impulse', 'ends': ['Mass 0'], 'impulse': 1, 'time': 0.5}");
    assert_blow_at(1.5,
                   HANGING "{'type': 'mass', 'position': [1, -1]}, {'type': 'impulse', 'ends': ['Mass 0'],"
                           " 'impulse': 1, 'time': 0.5}, {'type': 'rope', 'ends': ['Bar 0', 'Mass 0'], 'length': 99}");
    assert_blow_at(sqrt(2 * 1.5 / g),
                   "{'type': 'disc', 'radius': 0.1, 'position': [0, 0], 'angular_velocity': 2},"
                   "{'type': 'pin', 'ends': ['Support 0', 'Disc 0'], " PIN
                   ", {'type': 'disc', 'radius': 0.1, 'position': [0, 1.7], 'restitution': 0, 'static_friction': 0,"
                   " 'dynamic_friction': 0}");
}

/* A wheel at rest on a rough pin, which a loose box on the floor presses aside: only what touches the wheel bears on
 * the pin, with the force P of the spring behind the box, and not the weight of the box on the floor. A torque of no
 * more than arm |(P, m g)| moves the wheel by nothing; one of more by what it is more. */
static void test_loose_beside(void)
{
    const double limit = arm_of(0.1, 0.3) * hypot(40, 2 * g), inertia = 2 * 0.25 / 2, torques[] = {1.27, 1.29};
    for (gsize i = 0; i < G_N_ELEMENTS(torques); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 1, .columns = "Disc 0.angle, Disc 0.angular velocity, Pin 0.torque"},
            CONTACT_WEIGHT ANCHOR
            "{'type': 'support', 'position': [3, -0.05], 'solid': false},"
            "{'type': 'support', 'position': [0, -1.25], 'width': 20, " CONTACT_SMOOTH "},"
            "{'type': 'disc', 'radius': 0.5, 'mass': 2, 'position': [0, 0], " CONTACT_SMOOTH "},"
            "{'type': 'box', 'mass': 2, 'width': 0.5, 'height': 2, 'position': [0.75, -0.05], " CONTACT_SMOOTH "},"
            "{'type': 'pin', 'ends': ['Support 0', 'Disc 0'], 'friction_radius': 0.1, 'friction': 0.3},"
            "{'type': 'torque', 'ends': ['Disc 0'], 'waveform': {'expression': '%g'}},"
            "{'type': 'spring', 'ends': ['Box 0', 'Support 1'], 'stiffness': 40, 'rest_length': 3.25}",
            torques[i]);
        const double rate = fmax(torques[i] - limit, 0) / inertia;
        g_assert_cmpuint(run->summary->events->len, ==, 0);
        physics_assert_near("torque", physics_last(run, 2), fmin(torques[i], limit), 1e-12);
        physics_assert_near("rate", physics_last(run, 1), rate, 1e-12);
        physics_assert_near("angle", physics_last(run, 0), rate / 2, rate > 0 ? 1e-12 : 0);
    }
}

/* A pin whose friction sticks and slips by turns with what it strikes, at 1.113 s, is none that opens; and what it
 * holds back is of what touches the bodies it joins, not of a box on the floor beside them. Up to and past there the
 * run comes, whatever its steps, and its books close. */
static void run_by_turns(double tolerance)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1.114, .interval = 0.01, .tolerance = tolerance, .impact_law = "poisson"},
        "{'type': 'gravity', 'name': 'g', 'acceleration': 9.81},"
        "{'type': 'support', 'name': 'F', 'position': [0.0, -0.2], 'orientation': 0, 'width': 9.436024161281118, "
        "'height': 0.4, 'static_friction': 0.9, 'dynamic_friction': 0.9, 'restitution': 0.3},"
        "{'type': 'support', 'name': 'L', 'position': [-2.918012080640559, 2.0], 'orientation': -1.5707963267948966, "
        "'width': 8, 'height': 0.4, 'static_friction': 0.9, 'dynamic_friction': 0.9, 'restitution': 0.3},"
        "{'type': 'box', 'name': 'box1', 'position': [0.0, 0.9], 'mass': 1, 'velocity': [-0.15171576746732196, "
        "1.5679420360648302], 'width': 0.44271781646957753, 'height': 0.443194295713911, 'orientation': "
        "2.3397795972409376, 'angular_velocity': 0},"
        "{'type': 'box', 'name': 'box4', 'position': [0.8493787752001747, 1.3416769631040908], 'mass': 10, 'velocity': "
        "[-0.8550525789244752, -1.7273393513162851], 'width': 0.1788308643864824, 'height': 0.24318095320013025, "
        "'orientation': 0, 'angular_velocity': 0},"
        "{'type': 'disc', 'name': 'disc6', 'position': [-1.6987575504003494, 1.7833539262081817], 'mass': 0.1, "
        "'velocity': [1.519069245856171, 0.022357200934094212], 'restitution': 0.5, 'static_friction': 0.4, "
        "'dynamic_friction': 0.3, 'radius': 0.1761905499897736, 'orientation': -0.6258801905084326, "
        "'angular_velocity': 0},"
        "{'type': 'disc', 'name': 'disc7', 'position': [0.0, 3.7499999999999996], 'mass': 2, 'velocity': "
        "[-1.7389630922907569, 0.5126511291541793], 'radius': 0.2829595079492624, 'orientation': 0, "
        "'angular_velocity': 0.32730509211012304, 'rolling_resistance': 0.01},"
        "{'type': 'bumper', 'name': 'bu1', 'ends': ['disc7', 'box1'], 'stiffness': 500, 'damping': 2.2691456468505304, "
        "'length': 2.0258820913141675},"
        "{'type': 'pin', 'name': 'pi2', 'ends': [{'block': 'disc6', 'at': [1.1619353284509666, 0.5673848877904593]}, "
        "{'block': 'box4', 'at': [-1.274068162800262, 0.22083848155204544]}], 'friction_radius': 0.03, 'friction': "
        "0.3}");
    physics_assert_near("the books", run->summary->energy_balance_error, 0, 1e-6);
}

static void test_by_turns(void)
{
    static const double tolerances[] = {1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
    for (gsize i = 0; i < G_N_ELEMENTS(tolerances); i++)
        run_by_turns(tolerances[i]);
}

static void add_tests(void)
{
    g_test_add_func("/pin-friction/loose-beside", test_loose_beside);
    g_test_add_func("/pin-friction/by-turns", test_by_turns);
    g_test_add_func("/pin-friction/spins-down", test_spins_down);
    g_test_add_func("/pin-friction/apart", test_apart);
    g_test_add_func("/pin-friction/cone", test_cone);
    g_test_add_func("/pin-friction/pendulum", test_pendulum);
    g_test_add_func("/pin-friction/dragged-along", test_dragged_along);
    g_test_add_func("/pin-friction/free", test_free);
    g_test_add_func("/pin-friction/refused", test_refused);
    g_test_add_func("/pin-friction/share", test_share);
    g_test_add_func("/pin-friction/not-shared", test_not_shared);
    g_test_add_func("/pin-friction/one-place", test_one_place);
    g_test_add_func("/pin-friction/struck", test_struck);
    g_test_add_func("/pin-friction/struck-elsewhere", test_struck_elsewhere);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
