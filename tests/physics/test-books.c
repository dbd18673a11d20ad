/* Energy books: every entry against its closed form, and the balance. */
#include "physics-fixture.h"
#include "physics/model/model.h"

#include <complex.h>
#include <math.h>

#define BALANCE 1e-9

#define OSCILLATOR                                                                                                     \
    "{'type': 'support', 'position': [-2, 0]}, {'type': 'mass', 'mass': 2, 'position': [0.5, 0], 'velocity': [3, 0]}," \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2, 'stiffness': 50}"

static void assert_books(const PhysicsRun *run, const double truth[TINKER_BOOK_COUNT], double bound)
{
    static const char *const names[] = {"dampers", "friction",       "contacts",  "motors",
                                        "fields",  "support motion", "projection"};
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        physics_assert_near(names[book], run->summary->books[book], truth[book], bound);
    physics_assert_near("balance error", run->summary->energy_balance_error, 0, BALANCE);
}

/* A damper takes all there is in the end: 2 kg at 3 m/s, half a metre from rest on 50 N/m; the amplitude falls to
 * e^-20. */
static void test_damper_takes_all(void)
{
    const double start = 0.5 * 2 * 9 + 0.5 * 50 * 0.25;
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 20, .tolerance = 1e-11}, OSCILLATOR
                                            ",{'type': 'damper', 'ends': ['Mass 0', 'Support 0'], 'damping': 4}");
    assert_books(run, (double[TINKER_BOOK_COUNT]){[TINKER_BOOK_DAMPERS] = -start}, 1e-8);
    physics_assert_near("kinetic energy at the start", run->summary->kinetic_start, 9, 1e-14);
    physics_assert_near("potential energy at the start", run->summary->potential_start, 6.25, 1e-14);
    physics_assert_near("energy at the end", run->summary->kinetic_end + run->summary->potential_end, 0, 1e-14);
}

/* Free mass under F cos(w t): v = F sin(w t) / (m w), and all of its kinetic energy is the motor's work. */
static void test_motor(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1.7, .tolerance = 1e-11},
        "{'type': 'mass', 'mass': 2}, {'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 12, 'frequency': 3}");
    double v = 12 * sin(3 * 1.7) / (2 * 3);
    assert_books(run, (double[TINKER_BOOK_COUNT]){[TINKER_BOOK_MOTORS] = v * v}, 1e-9);
    physics_assert_near("kinetic energy", run->summary->kinetic_end, v * v, 1e-9);
}

/* Wind carries a mass from rest: v = w (1 - exp(-c t / m)), and its work is the kinetic energy. */
static void test_wind(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 4, .tolerance = 1e-11},
                    "{'type': 'mass', 'mass': 2}, {'type': 'wind', 'velocity': [3, 0], 'drag': 0.5}");
    double v = 3 * (1 - exp(-1));
    assert_books(run, (double[TINKER_BOOK_COUNT]){[TINKER_BOOK_FIELDS] = v * v}, 1e-9);
}

/* Fall through air: gravity is potential energy about y = 0 of the world, drag is the field's taking. */
static void test_fall_through_air(void)
{
    const double m = 2, c = 0.5, g = 9.81, t = 4, tau = m / c, end = g * tau;
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = t, .tolerance = 1e-11},
                                            "{'type': 'gravity'}, {'type': 'mass', 'mass': 2, 'position': [1, 100]},"
                                            "{'type': 'wind', 'drag': 0.5}");
    double v = end * (1 - exp(-t / tau)), fallen = end * t - end * tau * (1 - exp(-t / tau));
    assert_books(run, (double[TINKER_BOOK_COUNT]){[TINKER_BOOK_FIELDS] = 0.5 * m * v * v - m * g * fallen}, 1e-8);
    physics_assert_near("potential energy at the start", run->summary->potential_start, m * g * 100, 1e-10);
    physics_assert_near("potential energy at the end", run->summary->potential_end, m * g * (100 - fallen), 1e-8);
}

/* A far scene has the same books: the potential energy is the world's. */
static void test_potential_far_away(void)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 1},
                                            "{'type': 'gravity'}, {'type': 'mass', 'mass': 2, 'position': [1e6, 1e6]},"
                                            "{'type': 'support', 'position': [1000003, 1e6]},"
                                            "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'stiffness': 0}");
    physics_assert_near("potential", run->summary->potential_start, 2 * 9.81 * 1e6, 1e-8);
    physics_assert_near("potential", run->summary->potential_end, 2 * 9.81 * (1e6 - 9.81 / 2), 1e-7);
}

/* Base excitation at steady state: x'' + ... the support gives what the damper takes over whole periods. With
 * u = a sin(W t), the force on the support is -(k (x - u) + c (x' - u')), its power times -1 is the book. */
static void test_support_motion(void)
{
    const double m = 1, k = 25, c = 0.6, rate = 3, a = 0.2, t = 7.3;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = t, .tolerance = 1e-11},
                    "{'type': 'support'}, {'type': 'mass', 'position': [2, 0]}, {'type': 'spring', 'ends': ['Support "
                    "0', 'Mass 0']},"
                    "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 0.6},"
                    "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.2, 'frequency': 3}");
    /* z = x - u: m z'' + c z' + k z = m a W^2 sin(W t), z = Im(Z e^(iWt)) + free part, from z = 0, z' = -a W. */
    double complex s = I * rate, steady = m * a * rate * rate / (k + c * s + m * s * s);
    double decay = 0.5 * c / m, omega = sqrt(k / m - decay * decay);
    double z0 = -cimag(steady), v0 = -a * rate - cimag(s * steady);
    double complex free = z0 - I * (v0 + decay * z0) / omega, root = -decay + I * omega;
    double taken = 0, given = 0;
    const int n = 20000; /* Simpson's rule over smooth integrands */
    double z = 0, zv = 0;
    for (int i = 0; i <= n; i++) {
        double at = t * i / n, weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
        z = cimag(steady * cexp(s * at)) + creal(free * cexp(root * at));
        zv = cimag(s * steady * cexp(s * at)) + creal(root * free * cexp(root * at));
        taken += weight * t / n / 3 * c * zv * zv;
        given -= weight * t / n / 3 * (k * z + c * zv) * a * rate * cos(rate * at);
    }
    double truth[TINKER_BOOK_COUNT] = {[TINKER_BOOK_DAMPERS] = -taken, [TINKER_BOOK_SUPPORT_MOTION] = given};
    assert_books(run, truth, 1e-9);
    physics_assert_near("potential energy", run->summary->potential_end, 0.5 * k * z * z, 1e-9);
}

/* A support that jumps by 0.3 m stretches the spring at once. The mass is at rest then: its work is k 0.09 / 2. */
static void test_support_jump(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 2, .tolerance = 1e-11},
                    "{'type': 'support'}, {'type': 'mass', 'position': [2, 0]}, {'type': 'spring', 'ends': ['Support "
                    "0', 'Mass 0']},"
                    "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'expression': '0.3*step(t - 1)'}}");
    assert_books(run, (double[TINKER_BOOK_COUNT]){[TINKER_BOOK_SUPPORT_MOTION] = 0.5 * 25 * 0.09}, 1e-10);
}

/* A rod that is lifted at constant acceleration: the support's work is the energy that the hanging mass gets. */
static void test_lifted_rod(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 2, .tolerance = 1e-11},
        "{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'mass': 3, 'position': [0, -1]},"
        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
        "{'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'expression': '0.5*t^2'}, 'angle': '90 deg'}");
    assert_books(run, (double[TINKER_BOOK_COUNT]){[TINKER_BOOK_SUPPORT_MOTION] = 3 * (9.81 + 1) * 2}, 1e-9);
}

/* Projection brings a tight method's pendulum back by next to nothing; its work stands in the books and closes them. */
static void test_projection(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 20, .tolerance = 1e-11},
                    "{'type': 'gravity'}, {'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    assert_books(run, (double[TINKER_BOOK_COUNT]){0}, 1e-9);
    physics_assert_near("energy", run->summary->kinetic_end + run->summary->potential_end, 0, 1e-9);
}

/* Several springs and dampers between the same two masses keep their own energies: merging changes nothing. */
static void test_merged_lines(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 3, .tolerance = 1e-11},
                    "{'type': 'mass', 'mass': 1}, {'type': 'mass', 'mass': 2, 'position': [3, 0]},"
                    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 2, 'stiffness': 10},"
                    "{'type': 'spring', 'ends': ['Mass 1', 'Mass 0'], 'rest_length': 5, 'stiffness': 30},"
                    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'rest_length': 2.5, 'stiffness': 4}");
    g_assert_cmpint(tinker_model_sizes(run->model).merged_lines, ==, 1);
    physics_assert_near("potential at the start", run->summary->potential_start, 0.5 * (10 + 30 * 4 + 4 * 0.25), 1e-12);
    /* One spring of 44 N/m about its balance, from rest: x'' = -44 (1 + 1/2) x. */
    double balance = (20 + 150 + 10) / 44.0, stretch = (3 - balance) * cos(sqrt(66) * 3), length = balance + stretch;
    double stored = 0.5 * (10 * pow(length - 2, 2) + 30 * pow(length - 5, 2) + 4 * pow(length - 2.5, 2));
    physics_assert_near("potential at the end", run->summary->potential_end, stored, 1e-8);
    assert_books(run, (double[TINKER_BOOK_COUNT]){0}, 0);
}

/* A mass that two rods hold, and a damper from it to a support that is shaken along it: nothing moves that would tell
 * of the damper, which takes c A^2 w^2 cos^2(w t) all the same. */
static void test_held(void)
{
    static const char *const methods[] = {"dopri5", "dop853", "rk4", "cvode-bdf"};
    const double c = 2, speed = 0.2 * 20, t = 5;
    const double taken = -c * speed * speed * (t / 2 + sin(2 * 20 * t) / (4 * 20));
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = t, .tolerance = 1e-9, .method = methods[i]},
                        "{'type': 'support', 'position': [0, 1]}, {'type': 'support', 'position': [1, 1]},"
                        "{'type': 'support', 'position': [2, 0]}, {'type': 'mass', 'position': [0, 0]},"
                        "{'type': 'support-motion', 'ends': ['Support 2'], 'amplitude': 0.2, 'frequency': 20},"
                        "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, "
                        "{'type': 'rod', 'ends': ['Support 1', 'Mass 0']},"
                        "{'type': 'damper', 'ends': ['Mass 0', 'Support 2'], 'damping': 2}");
        assert_books(run,
                     (double[TINKER_BOOK_COUNT]){[TINKER_BOOK_DAMPERS] = taken, [TINKER_BOOK_SUPPORT_MOTION] = -taken},
                     1e-4);
    }
}

/* A disc that turns evenly, driven or by its mass alone, with a damper to a support that swings to and fro about it:
 * the damper takes c (W - A w cos(w t))^2. Times of whole swings stand still wherever they are cut evenly. */
static void assert_turns_evenly(const char *method, double w, double t, const char *disc, double bound)
{
    const double c = 2, swing = 0.2 * w;
    const double taken = -c * (t - 2 * swing * sin(w * t) / w + swing * swing * (t / 2 + sin(2 * w * t) / (4 * w)));
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = t, .tolerance = 1e-9, .method = method},
                    "{'type': 'support', 'solid': false}, {'type': 'support', 'solid': false}, %s,"
                    "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, {'type': 'support-turn', 'ends': ['Support 1'],"
                    " 'waveform': 'sine', 'amplitude': 0.2, 'frequency': %.17g},"
                    "{'type': 'torsional-damper', 'ends': ['Disc 0', 'Support 1'], 'damping': 2}",
                    disc, w);
    physics_assert_near(method, run->summary->books[TINKER_BOOK_DAMPERS], taken, bound);
    physics_assert_near("balance error", run->summary->energy_balance_error, 0, BALANCE);
}

static void test_even(void)
{
    static const char *const methods[] = {"dopri5", "dop853", "cvode-bdf"};
    static const char driven[] =
        "{'type': 'disc', 'position': [0, 0]}, {'type': 'drive', 'ends': ['Disc 0', 'Support 0'], 'speed': 1}";
    /* its velocity changes by 1e-7 of itself */
    static const char heavy[] = "{'type': 'disc', 'position': [0, 0], 'inertia': 1e7, 'angular_velocity': 1}";
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        assert_turns_evenly(methods[i], 20, 5, driven, 1e-4);
        assert_turns_evenly(methods[i], 8 * G_PI, 5, driven, 1e-4);
        assert_turns_evenly(methods[i], 2 * G_PI, 16, driven, 1e-4);
        assert_turns_evenly(methods[i], 20, 5, heavy, 1e-3);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/books/damper-takes-all", test_damper_takes_all);
    g_test_add_func("/physics/books/motor", test_motor);
    g_test_add_func("/physics/books/wind", test_wind);
    g_test_add_func("/physics/books/fall-through-air", test_fall_through_air);
    g_test_add_func("/physics/books/potential-far-away", test_potential_far_away);
    g_test_add_func("/physics/books/support-motion", test_support_motion);
    g_test_add_func("/physics/books/held", test_held);
    g_test_add_func("/physics/books/even", test_even);
    g_test_add_func("/physics/books/support-jump", test_support_jump);
    g_test_add_func("/physics/books/lifted-rod", test_lifted_rod);
    g_test_add_func("/physics/books/projection", test_projection);
    g_test_add_func("/physics/books/merged-lines", test_merged_lines);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
