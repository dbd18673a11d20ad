/* Sources of the closed forms: any textbook of mechanics; the pendulum by Jacobi's elliptic functions, Kepler's ellipse
 * by his equation. */
#include "closed-form-motions.h"

#include "test-systems.h"

#include <complex.h>
#include <math.h>

/* Unit mass at x0 = 0.6 m, v0 = -0.4 m/s, k = 25 N/m: x'' + c x' + 25 x = f cos(w t). */
static void oscillator(double c, double f, double w, double t, Motion *motion)
{
    double complex s = I * w, steady = f / (25 + c * s + s * s), half = csqrt(c * c / 4 - 25);
    double complex first = -c / 2 + half, second = -c / 2 - half;
    double x0 = 0.6 - creal(steady), v0 = -0.4 - creal(s * steady);
    double complex a = (v0 - second * x0) / (first - second), b = x0 - a;
    motion->q[0] = creal(steady * cexp(s * t) + a * cexp(first * t) + b * cexp(second * t));
    motion->v[0] = creal(s * steady * cexp(s * t) + a * first * cexp(first * t) + b * second * cexp(second * t));
}

static void undamped(double t, Motion *motion)
{
    oscillator(0, 0, 0, t, motion);
}

static void under_damped(double t, Motion *motion)
{
    oscillator(0.8, 0, 0, t, motion);
}

static void over_damped(double t, Motion *motion)
{
    oscillator(14, 0, 0, t, motion);
}

static void critically_damped(double t, Motion *motion)
{
    double b = -0.4 + 5 * 0.6;
    motion->q[0] = (0.6 + b * t) * exp(-5 * t);
    motion->v[0] = (b - 5 * (0.6 + b * t)) * exp(-5 * t);
}

static void forced(double t, Motion *motion)
{
    oscillator(0.5, 3, 3.1, t, motion);
}

/* Driven at its own rate: the particular solution is t sin(5 t) f / 10. */
static void resonance(double t, Motion *motion)
{
    double c = cos(5 * t), s = sin(5 * t);
    motion->q[0] = 0.6 * c - 0.08 * s + 0.2 * t * s;
    motion->v[0] = -3 * s - 0.4 * c + 0.2 * (s + 5 * t * c);
}

/* 2 kg, 0.6 kg/s of drag: the speed goes to -2 * 9.81 / 0.6 as exp(-0.3 t). */
static void fall(double t, Motion *motion)
{
    double end = -9.81 / 0.3, decay = exp(-0.3 * t);
    motion->q[0] = 3 / 0.3 * (1 - decay);
    motion->v[0] = 3 * decay;
    motion->q[1] = end * t - (1 - end) * expm1(-0.3 * t) / 0.3;
    motion->v[1] = end + (1 - end) * decay;
}

static void pendulum(double angle, double t, Motion *motion)
{
    Pendulum p;
    pendulum_init(&p, 1, 9.81, angle * G_PI / 180, 0);
    pendulum_exact(&p, t, motion->q, motion->v);
}

static void small_pendulum(double t, Motion *motion)
{
    pendulum(10, t, motion);
}

static void wide_pendulum(double t, Motion *motion)
{
    pendulum(90, t, motion);
}

static void upright_pendulum(double t, Motion *motion)
{
    pendulum(179, t, motion);
}

/* 2 kg at 1.5 m on a spring of 50 N/m and 1 m: k (r - L) = m w^2 r. */
static void circle(double t, Motion *motion)
{
    const double w = sqrt(25.0 / 3);
    *motion = (Motion){{1.5 * cos(w * t), 1.5 * sin(w * t)}, {-1.5 * w * sin(w * t), 1.5 * w * cos(w * t)}};
}

/* A spring without length. */
static void ellipse(double t, Motion *motion)
{
    *motion = (Motion){{cos(4 * t), 0.5 * sin(4 * t)}, {-4 * sin(4 * t), 2 * cos(4 * t)}};
}

/* Unit masses on 20 N/m each and 5 N/m between them: w = sqrt(20) together, sqrt(30) against each other. */
static void two(double t, Motion *motion)
{
    double slow = sqrt(20), fast = sqrt(30), place[2] = {1, 2};
    for (int i = 0; i < 2; i++) {
        double sign = i == 0 ? 1 : -1;
        motion->q[2 * i] = place[i] + 0.2 * cos(slow * t) + sign * 0.1 * cos(fast * t);
        motion->v[2 * i] = -0.2 * slow * sin(slow * t) - sign * 0.1 * fast * sin(fast * t);
    }
}

/* Eight unit masses between walls, 100 N/m: mode n has the rate 20 sin(n pi / 18) and the shape sin(n i pi / 9). */
static void chain(double t, Motion *motion)
{
    static const int modes[] = {2, 5};
    for (int i = 0; i < 8; i++) {
        motion->q[2 * i] = i + 1;
        for (gsize m = 0; m < G_N_ELEMENTS(modes); m++) {
            double rate = 20 * sin(modes[m] * G_PI / 18), shape = 0.1 * sin(modes[m] * (i + 1) * G_PI / 9);
            motion->q[2 * i] += shape * cos(rate * t);
            motion->v[2 * i] -= shape * rate * sin(rate * t);
        }
    }
}

/* Two bodies of 3 and 1 kg that attract each other, G (m + M) = 1 m^3/s^2, half axis 1 m, e = 0.6, from the pericentre.
 */
static void kepler(double t, Motion *motion)
{
    const double e = 0.6, minor = 0.8;
    double anomaly = t;
    for (int i = 0; i < 50; i++)
        anomaly -= (anomaly - e * sin(anomaly) - t) / (1 - e * cos(anomaly));
    double rate = 1 / (1 - e * cos(anomaly)), share[2] = {-0.25, 0.75};
    for (int i = 0; i < 2; i++) {
        motion->q[2 * i] = share[i] * (cos(anomaly) - e);
        motion->q[2 * i + 1] = share[i] * minor * sin(anomaly);
        motion->v[2 * i] = -share[i] * sin(anomaly) * rate;
        motion->v[2 * i + 1] = share[i] * minor * cos(anomaly) * rate;
    }
}

#define OSCILLATOR                                                                                                     \
    "{'type': 'support', 'solid': false, 'position': [-2, 0]}, {'type': 'mass', 'position': [0.6, 0], 'velocity': "    \
    "[-0.4, 0]},"                                                                                                      \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2, 'stiffness': 25}"
#define DAMPER(c) ",{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': " #c "}"
#define MOTOR(f, w)                                                                                                    \
    ",{'type': 'motor', 'ends': ['Mass 0'], 'waveform': 'cosine', 'amplitude': " #f ", 'frequency': " #w "}"
#define PENDULUM(x, y)                                                                                                 \
    "{'type': 'support', 'solid': false}, {'type': 'gravity', 'acceleration': 9.81},"                                  \
    "{'type': 'mass', 'position': [" #x ", " #y "]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 1}"

/* Starts where the closed form does. */
static char *chain_blocks(void)
{
    Motion start = {0};
    chain(0, &start);
    GString *text =
        g_string_new("{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false, 'position': [9, 0]}");
    for (int i = 0; i < 8; i++)
        g_string_append_printf(text, ",{'type': 'mass', 'position': [%.17g, 0]}", start.q[2 * i]);
    for (int i = 0; i <= 8; i++) {
        g_autofree char *from = i == 0 ? g_strdup("Support 0") : g_strdup_printf("Mass %d", i - 1);
        g_autofree char *to = i == 8 ? g_strdup("Support 1") : g_strdup_printf("Mass %d", i);
        g_string_append_printf(text, ",{'type': 'spring', 'ends': ['%s', '%s'], 'rest_length': 1, 'stiffness': 100}",
                               from, to);
    }
    return g_string_free(text, FALSE);
}

char *closed_form_blocks(const ClosedForm *form)
{
    return form->blocks != NULL ? g_strdup(form->blocks) : chain_blocks();
}

const ClosedForm closed_forms[] = {
    {"undamped", 1, 5, 10, undamped, OSCILLATOR, 1, {{-2, 0}}},
    {"under-damped", 1, 5, 10, under_damped, OSCILLATOR DAMPER(0.8), 1, {{-2, 0}}},
    {"over-damped", 1, 12, 5, over_damped, OSCILLATOR DAMPER(14), 1, {{-2, 0}}},
    {"critically damped", 1, 5, 5, critically_damped, OSCILLATOR DAMPER(10), 1, {{-2, 0}}},
    {"forced", 1, 5, 10, forced, OSCILLATOR DAMPER(0.5) MOTOR(3, 3.1), 1, {{-2, 0}}},
    {"resonance", 1, 5, 10, resonance, OSCILLATOR MOTOR(2, 5), 1, {{-2, 0}}},
    {"fall",
     1,
     1,
     6,
     fall,
     "{'type': 'mass', 'mass': 2, 'velocity': [3, 1]}, {'type': 'gravity', 'acceleration': 9.81},"
     "{'type': 'wind', 'drag': 0.6}",
     0,
     {{0, 0}}},
    {"pendulum, 10 degrees",
     1,
     3,
     10,
     small_pendulum,
     PENDULUM(0.17364817766693036, -0.98480775301220802),
     1,
     {{0, 0}}},
    {"pendulum, 90 degrees", 1, 5, 10, wide_pendulum, PENDULUM(1, 0), 1, {{0, 0}}},
    {"pendulum, 179 degrees",
     1,
     6,
     10,
     upright_pendulum,
     PENDULUM(0.017452406437283512, 0.99984769515639127),
     1,
     {{0, 0}}},
    {"circle",
     1,
     5,
     10,
     circle,
     "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 2, 'position': [1.5, 0], 'velocity': [0, "
     "4.3301270189221932]},"
     "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 50}",
     1,
     {{0, 0}}},
    {"ellipse",
     1,
     4,
     10,
     ellipse,
     "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0], 'velocity': [0, 2]},"
     "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 0, 'stiffness': 16}",
     1,
     {{0, 0}}},
    {"two masses",
     2,
     5.5,
     10,
     two,
     "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.3, 0]}, {'type': 'mass', 'position': [2.1, "
     "0]},"
     "{'type': 'support', 'solid': false, 'position': [3, 0]},"
     "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1, 'stiffness': 20},"
     "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 1, 'stiffness': 5},"
     "{'type': 'spring', 'ends': ['Mass 1', 'Support 1'], 'rest_length': 1, 'stiffness': 20}",
     2,
     {{0, 0}, {3, 0}}},
    {"chain", 8, 16, 5, chain, NULL, 2, {{0, 0}, {9, 0}}},
    {"Kepler's ellipse",
     2,
     5,
     12,
     kepler,
     "{'type': 'mass', 'mass': 3, 'position': [-0.1, 0], 'velocity': [0, -0.5]}, {'type': 'mass', 'position': [0.3, 0],"
     "'velocity': [0, 1.5]}, {'type': 'attraction', 'strength': 0.25}",
     0,
     {{0, 0}}},
    {NULL, 0, 0, 0, NULL, NULL, 0, {{0, 0}}},
};
