/* Systems with closed-form motion, behind the SDK's TinkerSystem, for the tests of the integrators. */
#ifndef TINKER_TEST_SYSTEMS_H
#define TINKER_TEST_SYSTEMS_H

#include <glib.h>

#include <tinker/integrator.h>

#define TEST_SIZE  2
#define TEST_BOOKS 2

/* Two uncoupled unit masses, each x'' = -omega^2 x - gamma v + drive cos(drive_rate t), starting at different places.
 * Books: what the dampers take, what the drive gives. Lengths are in units of `unit` metres. */
typedef struct Oscillator {
    TinkerSystem system;
    double omega, gamma, drive, drive_rate, unit;
    int evaluations;
    double refuse_speed; /* where positive: TINKER_RETRY_SMALLER above this speed */
    double break_time;   /* accelerations are NaN after it */
} Oscillator;

void oscillator_init(Oscillator *oscillator, double omega, double gamma, double drive, double drive_rate);
void oscillator_exact(const Oscillator *oscillator, double t, double *q, double *v);
/* Kinetic plus potential energy. */
double oscillator_energy(const Oscillator *oscillator, const double *q, const double *v);

/* A point mass on a rod about the origin, in Cartesian coordinates, released at rest at the angle theta0 from the
 * downward vertical; `drag` is c/m of linear air drag. */
typedef struct Pendulum {
    TinkerSystem system;
    double length, gravity, theta0, drag;
    int evaluations, always_moved;
} Pendulum;

void pendulum_init(Pendulum *pendulum, double length, double gravity, double theta0, double drag);
/* Of the pendulum without drag, by Jacobi's elliptic functions. */
void pendulum_exact(const Pendulum *pendulum, double t, double *q, double *v);
double pendulum_period(const Pendulum *pendulum);
double pendulum_energy(const Pendulum *pendulum, const double *q, const double *v);

/* Jacobi's sn, cn, dn of modulus k by the arithmetic-geometric mean: Abramowitz and Stegun 16.4. */
void jacobi(double u, double k, double *sn, double *cn, double *dn);
/* The complete elliptic integral of the first kind: Abramowitz and Stegun 17.6. */
double elliptic_period(double k);

/* A state on arrays of its own. */
typedef struct TestState {
    TinkerState state;
    double q[TEST_SIZE], v[TEST_SIZE], books[TEST_BOOKS];
} TestState;

void test_state_init(TestState *test, double t);

/* Takes `steps` equal steps from `from` to `to`, adaptive methods with their error control switched off. */
void run_equal_steps(const TinkerIntegrator *method, const TinkerSystem *system, TestState *test, double to, int steps);

/* Options that make an adaptive method take the step h, and those of a tolerance. */
TinkerIntegratorOptions equal_step_options(double h);
TinkerIntegratorOptions tolerance_options(double tolerance);

/* Runs with the method's own steps to `to`; returns how many they were, fails the test where a step fails. */
int run_to(const TinkerIntegrator *method, const TinkerSystem *system, TestState *test, double to, double tolerance);

/* The largest difference of two arrays. */
double distance(int count, const double *left, const double *right);

#endif
