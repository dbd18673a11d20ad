/* Implicit methods on compiled models: stiff springs with rods against the limit of no springs at all, conserved energy
 * of a pendulum, laws that are asked, failures that say what to do. */
#include "physics-fixture.h"

#include "numerics/methods/integrators.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/system.h"
#include "test-systems.h"

#include <math.h>
#include <string.h>

#define MOST 64

/* A model behind a method; `place` is q relative to the origin. */
typedef struct {
    PhysicsRun *run;
    TinkerModelSystem system;
    const TinkerIntegrator *method;
    void *stepper;
    double q[MOST], v[MOST], books[TINKER_BOOK_COUNT];
    TinkerState state;
    TinkerStepReport report;
} March;

static void march_init(March *this, const char *method, double radius, const char *blocks)
{
    *this = (March){.run = physics_prepare(&(PhysicsOptions){.duration = 1}, "%s", blocks)};
    tinker_model_system_init(&this->system, this->run->model, NULL);
    tinker_model_system_offer_jacobian(&this->system);
    const TinkerSystem *system = &this->system.system;
    g_assert_cmpint(system->size, <=, MOST);
    TinkerIntegratorOptions options = {.struct_size = sizeof options, .spectral_radius = radius};
    this->method = tinker_integrator_builtin(method);
    this->stepper = this->method->create(system, &options);
    memcpy(this->q, this->run->model->q_start, sizeof(double) * (gsize)system->size);
    memcpy(this->v, this->run->model->v_start, sizeof(double) * (gsize)system->size);
    this->state = (TinkerState){0, this->q, this->v, this->books};
    this->report.struct_size = sizeof(TinkerStepReport);
}

static TinkerStatus march_to(March *this, double t, int steps)
{
    double from = this->state.t;
    TinkerStatus status = TINKER_OK;
    for (int i = 1; i <= steps && status == TINKER_OK; i++)
        status = this->method->step(this->stepper, &this->state, from + i * ((t - from) / steps), &this->report);
    return status;
}

static void march_clear(March *this)
{
    this->method->destroy(this->stepper);
    tinker_model_system_clear(&this->system);
    physics_run_free(this->run);
}

static void add_methods(const char *name, GTestDataFunc test)
{
    static const char *const methods[] = {"newmark", "generalized-alpha"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        g_autofree char *path = g_strdup_printf("/physics/implicit/%s/%s", methods[i], name);
        g_test_add_data_func(path, methods[i], test);
    }
}

#define PENDULUM_PAIR(link)                                                                                            \
    "{'type': 'support'}, {'type': 'mass', 'mass': 1, 'position': [1, 0]},"                                            \
    "{'type': 'mass', 'mass': 1, 'position': [1, -1]}, {'type': 'gravity'},"                                           \
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, " link

static double difference(const March *this, const double truth[8])
{
    double largest = 0;
    for (int k = 0; k < 4; k++) {
        double place = this->q[k] + this->run->model->origin[k % 2];
        largest = fmax(largest, fmax(fabs(place - truth[k]), fabs(this->v[k] - truth[4 + k])));
    }
    return largest;
}

/* A double pendulum whose second rod is a spring of 1e8 N/m: the step is 140 times what resolves it, so what is left is
 * the motion with two rods, but for 1e-7 m of stretch. */
static void test_stiff_spring_and_rod(gconstpointer data)
{
    g_autoptr(PhysicsRun) rods = physics_run(&(PhysicsOptions){.duration = 1.5, .tolerance = 1e-12},
                                             PENDULUM_PAIR("{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}"));
    double truth[8], error[2];
    for (int i = 0; i < 2; i++) {
        g_autofree char *name = g_strdup_printf("Mass %d", i);
        double state[4];
        physics_state(rods, name, state);
        memcpy(truth + 2 * i, state, 2 * sizeof(double));
        memcpy(truth + 4 + 2 * i, state + 2, 2 * sizeof(double));
    }
    for (int fine = 0; fine < 2; fine++) {
        March this;
        march_init(&this, data, 0.8,
                   PENDULUM_PAIR("{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 1e8}"));
        g_assert_cmpint(march_to(&this, 1.5, fine ? 300 : 150), ==, TINKER_OK);
        error[fine] = difference(&this, truth);
        march_clear(&this);
    }
    g_test_message("%s: %g, %g: order %g", (const char *)data, error[0], error[1], log2(error[0] / error[1]));
    g_assert_cmpfloat(fabs(log2(error[0] / error[1]) - 2), <, 0.1);
}

static double energy(March *this)
{
    TinkerEnergy found;
    tinker_model_set_state(this->run->model, this->q, this->v);
    g_assert_cmpint(tinker_model_energy(this->run->model, &found), ==, TINKER_OK);
    return found.kinetic + found.potential;
}

/* 45 periods of a wide swing, 220 steps each: the energy error of the first ten is not left behind. */
static void test_pendulum_energy(gconstpointer data)
{
    March this;
    march_init(&this, data, 0.8,
               "{'type': 'support'}, {'type': 'mass', 'position': [1, 0]}, {'type': 'gravity'},"
               "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    double start = energy(&this), early = 0, late = 0;
    for (int i = 1; i <= 1000; i++) {
        g_assert_cmpint(march_to(&this, 0.1 * i, 10), ==, TINKER_OK);
        double error = fabs(energy(&this) - start);
        early = i <= 200 ? fmax(early, error) : early;
        late = i > 800 ? fmax(late, error) : late;
    }
    g_test_message("%s: %g J, then %g J", (const char *)data, early, late);
    g_assert_cmpfloat(late, <, 1.15 * early);
    march_clear(&this);
}

/* Tiny steps of a swing from 2 rad: what an iteration leaves in each does not add up, and energy is kept to far more
 * than the 5e-5 J a second that it was off by. */
static void test_tiny_steps(gconstpointer data)
{
    March this;
    march_init(&this, data, 0.8,
               "{'type': 'support'}, {'type': 'mass', 'position': [0.9092974268256817, 0.4161468365471424]},"
               "{'type': 'gravity'}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    const double start = energy(&this);
    g_assert_cmpint(march_to(&this, 1, 100000), ==, TINKER_OK);
    physics_assert_near("energy", energy(&this), start, 5e-8);
    march_clear(&this);
}

static double cubic_error(const char *method, int steps)
{
    March this;
    double rate = 0.8 * sqrt(7), sn, cn, dn;
    march_init(&this, method, 0.8,
               "{'type': 'support', 'position': [-2, 0]}, {'type': 'mass', 'position': [0.8, 0]},"
               "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 7, 'length': 2}");
    g_assert_cmpint(march_to(&this, 4, steps), ==, TINKER_OK);
    jacobi(4 * rate, G_SQRT2 / 2, &sn, &cn, &dn);
    double error = fabs(this.q[0] + this.run->model->origin[0] - 0.8 * cn) + fabs(this.v[0] + 0.8 * rate * sn * dn);
    march_clear(&this);
    return error;
}

/* x'' = -7 x^3, by a law that gives no derivatives. */
static void test_asked_line(gconstpointer data)
{
    double order = log2(cubic_error(data, 400) / cubic_error(data, 800));
    g_test_message("%s: order %g", (const char *)data, order);
    g_assert_cmpfloat(fabs(order - 2), <, 0.1);
}

/* A mass between two compressed springs, a little beside their line, which it leaves at 632 / s. */
#define BUCKLING                                                                                                       \
    "{'type': 'support', 'position': [-1, 0]}, {'type': 'support', 'position': [1, 0]},"                               \
    "{'type': 'mass', 'position': [0, 0.001]},"                                                                        \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 1e6, 'rest_length': 1.2},"                       \
    "{'type': 'spring', 'ends': ['Mass 0', 'Support 1'], 'stiffness': 1e6, 'rest_length': 1.2}"

static void test_buckling(gconstpointer data)
{
    static const double steps[] = {1e-5, 1e-4, 1e-3, 1e-2, 1};
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        March this;
        march_init(&this, data, 0.8, BUCKLING);
        double start = energy(&this);
        TinkerStatus status = march_to(&this, 400 * steps[i], 400);
        g_test_message("%s, %g s: status %d, energy %g of %g", (const char *)data, steps[i], status, energy(&this),
                       start);
        g_assert_true(isfinite(energy(&this)));
        if (i < 1) g_assert_cmpint(status, ==, TINKER_OK);
        if (i < 1) g_assert_cmpfloat(fabs(energy(&this) / start - 1), <, 0.01);
        if (status != TINKER_OK) g_assert_nonnull(strstr(this.report.failure, "smaller step"));
        march_clear(&this);
    }
}

/* Smooth discs that run into one another on a floor, of which the first goes round its end: what presses two of them
 * together is all that couples them. Against an explicit method of order 8. */
static void test_pressed_discs(gconstpointer data)
{
    static const char *const blocks =
        "{'type': 'gravity'}, {'type': 'support', 'position': [0, -0.2], 'width': 2, 'height': 0.4,"
        " 'static_friction': 0, 'dynamic_friction': 0},"
        "{'type': 'disc', 'position': [0.9, 0.13404060190403086], 'radius': 0.13404060190403086, 'mass': 0.76,"
        " 'velocity': [0.12, 0], 'static_friction': 0, 'dynamic_friction': 0},"
        "{'type': 'disc', 'position': [0.35, 0.23801296523990828], 'radius': 0.23801296523990828, 'mass': 1.33,"
        " 'velocity': [1.14, 0], 'static_friction': 0, 'dynamic_friction': 0},"
        "{'type': 'disc', 'position': [-0.2, 0.1515738836889722], 'radius': 0.1515738836889722, 'mass': 1.19,"
        " 'velocity': [1.71, 0], 'static_friction': 0, 'dynamic_friction': 0}";
    PhysicsOptions options = {.duration = 0.6,
                              .tolerance = 1e-11,
                              .method = "dop853",
                              .columns = "Disc 0.x, Disc 0.y, Disc 1.x, Disc 1.y, Disc 2.x"};
    g_autoptr(PhysicsRun) truth = physics_run(&options, "%s", blocks);
    options.method = data;
    for (int finer = 0; finer < 2; finer++) {
        options.step = finer ? 1e-3 : 5e-3;
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
        for (gsize column = 0; column < 5; column++)
            physics_assert_near("place", physics_last(run, column), physics_last(truth, column), finer ? 4e-7 : 1e-5);
    }
}

static void add_tests(void)
{
    add_methods("pressed-discs", test_pressed_discs);
    add_methods("stiff-spring-and-rod", test_stiff_spring_and_rod);
    add_methods("pendulum-energy", test_pendulum_energy);
    add_methods("tiny-steps", test_tiny_steps);
    add_methods("asked-line", test_asked_line);
    add_methods("buckling", test_buckling);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
