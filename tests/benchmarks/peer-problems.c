/* The motions in equations of first order, and their truths. */
#include "peers.h"

#include <math.h>
#include <string.h>

#define GRAVITY      9.81
#define CHAIN_MASSES 50

/* S1 along its line: x, v ------------------------------------------------------------------------------------------ */

static void oscillator_rates(double t, const double *y, double *f)
{
    f[0] = y[1];
    f[1] = -25.0 * y[0] - 0.4 * y[1];
}

/* The closed form of m x'' + c x' + k x = 0 from rest at x = 1. */
static double oscillator_error(double t, const double *y)
{
    double decay = 0.2, frequency = sqrt(25.0 - decay * decay);
    return fabs(y[0] - exp(-decay * t) * (cos(frequency * t) + decay / frequency * sin(frequency * t)));
}

/* S2: x1, y1, x2, y2 and their rates ------------------------------------------------------------------------------- */

/* With rods r1 = p1, r2 = p2 - p1, both of length 1, and forces l1, l2 in them, a1 = g + l1 r1 - l2 r2 and
 * a2 = g + l2 r2. The lengths stay where r1.a1 = -|v1|^2 and r2.(a2 - a1) = -|v2 - v1|^2: two equations for l1 and l2.
 */
static void pendulum_rates(double t, const double *y, double *f)
{
    double rx = y[2] - y[0], ry = y[3] - y[1], wx = y[6] - y[4], wy = y[7] - y[5];
    double a = y[0] * y[0] + y[1] * y[1], b = y[0] * rx + y[1] * ry, c = 2.0 * (rx * rx + ry * ry);
    double first = GRAVITY * y[1] - (y[4] * y[4] + y[5] * y[5]), second = -(wx * wx + wy * wy);
    double inverse = 1.0 / (a * c - b * b), l1 = (c * first + b * second) * inverse;
    double l2 = (a * second + b * first) * inverse;
    memcpy(f, y + 4, 4 * sizeof *f);
    f[4] = l1 * y[0] - l2 * rx;
    f[5] = l1 * y[1] - l2 * ry - GRAVITY;
    f[6] = l2 * rx;
    f[7] = l2 * ry - GRAVITY;
}

/* Places of both masses 5 s after both rods were let go level, to 1e-15: the equations in angles in 64-bit mantissas,
 * by the method of order 4 with 50 000 and 100 000 steps, extrapolated. */
static double pendulum_error(double t, const double *y)
{
    static const double truth[] = {-0.58686920981627138, -0.80968174647180144, -1.550778469470442, -1.0759127348126536};
    double worst = 0;
    for (int i = 0; i < 4; i++)
        worst = fmax(worst, fabs(y[i] - truth[i]));
    return worst;
}

/* The same in the angles from straight down, and their rates; floor-double-pendulum.c has the derivation. */
static void angle_rates(double t, const double *y, double *f)
{
    double sine1 = sin(y[0]), cosine1 = cos(y[0]), sine2 = sin(y[1]), cosine2 = cos(y[1]);
    double s = sine1 * cosine2 - cosine1 * sine2, c = cosine1 * cosine2 + sine1 * sine2;
    double first = -s * y[3] * y[3] - 2.0 * GRAVITY * sine1, second = s * y[2] * y[2] - GRAVITY * sine2;
    double inverse = 1.0 / (2.0 - c * c);
    f[0] = y[2];
    f[1] = y[3];
    f[2] = (first - c * second) * inverse;
    f[3] = (2.0 * second - c * first) * inverse;
}

static double angle_error(double t, const double *y)
{
    double places[4] = {sin(y[0]), -cos(y[0])};
    places[2] = places[0] + sin(y[1]);
    places[3] = places[1] - cos(y[1]);
    return pendulum_error(t, places);
}

/* S6: x and v of each mass in turns, which keeps the Jacobian in a band -------------------------------------------- */

static void chain_rates(double t, const double *y, double *f)
{
    static const double stiffness[] = {1e2, 1e8}, damping[] = {0.02 * 1e1, 0.02 * 1e4};
    double behind = stiffness[0] * y[0] + damping[0] * y[1];
    for (int i = 0; i < CHAIN_MASSES; i++) {
        const double *at = y + 2 * i;
        int next = (i + 1) & 1;
        double ahead = i + 1 < CHAIN_MASSES ? stiffness[next] * (at[2] - at[0]) + damping[next] * (at[3] - at[1]) : 0.0;
        f[2 * i] = at[1];
        f[2 * i + 1] = ahead - behind;
        behind = ahead;
    }
}

/* Displacements after 10 s: the matrix exponential in arithmetic of 113 bits, by a Taylor series and 33 squarings. */
static const double chain_truth[CHAIN_MASSES] = {
    -0.039405348006644858, -0.039405387049709771, -0.078110615220800469, -0.078110653610967251, -0.11622000098903339,
    -0.11622003785409876,  -0.15189517448808532,  -0.15189520854051231,  -0.18442777878287533,  -0.18442780876896658,
    -0.21201261499923779,  -0.21201263858648822,  -0.23180052239309176,  -0.23180053805340645,  -0.24358046035104466,
    -0.24358046740809128,  -0.24615719686721241,  -0.2461571956006412,   -0.24123498132573645,  -0.24123497513051573,
    -0.23386123240108422,  -0.23386122563123679,  -0.22765312349857916,  -0.22765311958000792,  -0.22589290755500446,
    -0.22589290845362947,  -0.22934523100611365,  -0.22934523504991802,  -0.23394918328733694,  -0.2339491860322476,
    -0.23489046127049834,  -0.23489046070400205,  -0.2329160172899746,   -0.23291601515358895,  -0.23064362628571256,
    -0.23064362481213105,  -0.22989104719430348,  -0.22989104769079705,  -0.23158130007587172,  -0.23158130194872539,
    -0.23367524408748874,  -0.23367524469491621,  -0.23284211616639855,  -0.23284211450259751,  -0.23033418290019608,
    -0.23033418181619908,  -0.23064704102823658,  -0.23064704244896839,  -0.23318212190976101,  -0.23318212317135215,
};

/* The largest, relative to the largest displacement that there is at that time. */
static double chain_error(double t, const double *y)
{
    double worst = 0, largest = 0;
    for (int i = 0; i < CHAIN_MASSES; i++) {
        worst = fmax(worst, fabs(y[2 * i] - chain_truth[i]));
        largest = fmax(largest, fabs(chain_truth[i]));
    }
    return worst / largest;
}

static PeerProblem problems[] = {
    {.scene = "S1",
     .form = "Cartesian",
     .size = 2,
     .duration = 100,
     .start = {1, 0},
     .rates = oscillator_rates,
     .error = oscillator_error,
     .everywhere = TRUE},
    {.scene = "S2",
     .form = "Cartesian",
     .size = 8,
     .duration = 5,
     .start = {1, 0, 2, 0},
     .rates = pendulum_rates,
     .error = pendulum_error},
    {.scene = "S2",
     .form = "angles",
     .size = 4,
     .duration = 5,
     .start = {G_PI / 2, G_PI / 2},
     .rates = angle_rates,
     .error = angle_error},
    {.scene = "S6",
     .form = "Cartesian",
     .size = 2 * CHAIN_MASSES,
     .duration = 10,
     .rates = chain_rates,
     .half_band = 3,
     .error = chain_error},
    {.scene = NULL},
};

const PeerProblem *peer_problems(void)
{
    PeerProblem *chain = &problems[3];
    for (int i = 0; i < CHAIN_MASSES; i++)
        chain->start[2 * i] = (i / 2 + 1) / 25.0;
    return problems;
}

const PeerProblem *peer_problem_find(const char *scene, const char *form)
{
    for (const PeerProblem *problem = peer_problems(); problem->scene != NULL; problem++)
        if (strcmp(problem->scene, scene) == 0 && strcmp(problem->form, form) == 0) return problem;
    return NULL;
}
