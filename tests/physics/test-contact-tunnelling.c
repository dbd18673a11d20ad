/* Nothing passes a top unseen: however fast, however long the step, however thin the plate, and however briefly it
 * dips. */
#include "contact-checks.h"
#include "one-island.h"

#include "numerics/methods/integrators.h"
#include "physics/event/contact-run-private.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

static const char *const all_methods[] = {"auto",   "dop853",  "dopri5",  "semi-implicit-euler", "rk4",
                                          "verlet", "verlet6", "newmark", "generalized-alpha"};

static PhysicsOptions with_step(const char *method, double step, double duration)
{
    return (PhysicsOptions){
        .method = method, .step = step, .tolerance = 1e-11, .duration = duration, .interval = duration};
}

/* From 1 m straight at a plate of 1 nm, back elastically, or staying there. */
static void check_bullet(const char *method, double v, double step, double duration, double e)
{
    PhysicsOptions options = with_step(method, step, duration);
    g_autoptr(PhysicsRun) run =
        physics_run(&options,
                    "{'type': 'support', 'position': [0, -0.0000000005], 'height': 0.000000001, "
                    "'restitution': %g}, " CONTACT_POINT ", 'position': [0.3, 1], 'velocity': [0, -%.17g]}",
                    e, v);
    double back[4] = {0.3, v * duration - 1, 0, v}, stopped[4] = {0.3, 0, 0, 0};
    contact_assert_state(run, "Mass 0", e > 0 ? back : stopped, e > 0 ? 1e-12 * v * fmax(1, duration) : 1e-12);
    contact_assert_event(run, e > 0 ? "impact" : "rest", "Mass 0, Support 0", 1 / v, 1e-12 / v + 1e-22);
}

static void test_bullets(void)
{
    static const double speeds[] = {1e4, 1e6, 1e8}, steps[] = {1e-6, 1e-3, 1, 10};
    for (gsize m = 0; m < G_N_ELEMENTS(all_methods); m++) {
        for (gsize i = 0; i < G_N_ELEMENTS(speeds); i++) {
            for (gsize k = 0; k < G_N_ELEMENTS(steps); k++) {
                double duration = steps[k] < 1e-3 ? 2.5e-4 : 3 * steps[k];
                check_bullet(all_methods[m], speeds[i], steps[k], duration, 1);
                check_bullet(all_methods[m], speeds[i], steps[k], duration, 0);
            }
        }
    }
}

/* Three plates in one step: the first one counts. */
static void test_the_first_of_several(void)
{
    for (gsize m = 0; m < G_N_ELEMENTS(all_methods); m++) {
        PhysicsOptions options = with_step(all_methods[m], 1, 2);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, "{'type': 'support', 'position': [0, -2], 'height': 0.01},"
                                  "{'type': 'support', 'position': [0, -0.005], 'height': 0.01},"
                                  "{'type': 'support', 'position': [0, -1], 'height': 0.01}," CONTACT_POINT
                                  ", 'position': [0, 1], 'velocity': [0, -5000]}");
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-11);
        contact_assert_event(run, "rest", "Mass 0, Support 1", 1.0 / 5000, 1e-14);
        contact_assert_count(run, "rest", 1);
    }
}

/* A thousand elastic impacts between two plates within one step. */
static void test_to_and_fro(void)
{
    const double v = 100, duration = 10.03;
    for (gsize m = 0; m < G_N_ELEMENTS(all_methods); m++) {
        PhysicsOptions options = with_step(all_methods[m], 20, duration);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, "{'type': 'support', 'position': [0, -0.005], 'height': 0.01, 'restitution': 1},"
                      "{'type': 'support', 'position': [0, 1.005], 'height': 0.01, 'orientation': '180 deg', "
                      "'restitution': 1}," CONTACT_POINT ", 'position': [0, 0.25], 'velocity': [0, 100]}");
        double phase = fmod(0.25 + v * duration, 2), state[4];
        physics_state(run, "Mass 0", state);
        physics_assert_near("y", state[1], phase < 1 ? phase : 2 - phase, 1e-9);
        physics_assert_near("vy", state[3], phase < 1 ? v : -v, 1e-10);
        contact_assert_count(run, "impact", 1003);
    }
}

/* Thrown up through the plate, it comes back onto its top within the same step: at both ends of it the mass is below.
 * Semi- implicit Euler's throw does not reach the top with such a step. */
static void test_up_and_down_in_a_step(void)
{
    static const double steps[] = {0.38, 0.41, 1, 10};
    double landing = (2 + sqrt(4 - 0.2 * g)) / g;
    for (gsize m = 0; m < G_N_ELEMENTS(all_methods); m++) {
        if (g_str_equal(all_methods[m], "semi-implicit-euler")) continue;
        for (gsize k = 0; k < G_N_ELEMENTS(steps); k++) {
            PhysicsOptions options = with_step(all_methods[m], steps[k], 3 * steps[k]);
            g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                                    "}," CONTACT_POINT ", 'position': [0, -0.1], 'velocity': [0, 2]}");
            contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
            contact_assert_event(run, "rest", NULL, landing, 1e-11);
        }
    }
}

/* A plate that darts up and is gone again within a step kicks a mass that floats above it. */
static void test_kicked_within_a_step(void)
{
    const double w = 20, touch = asin(0.5) / w, duration = 1;
    double kick = 0.1 * w * cos(w * touch);
    for (gsize m = 0; m < G_N_ELEMENTS(all_methods); m++) {
        PhysicsOptions options = with_step(all_methods[m], duration, duration);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_FLOOR "}, " CONTACT_POINT ", 'position': [0, 0.05]}, {'type': 'support-motion', "
                                    "'ends': ['Support 0'], 'angle': '90 deg', 'amplitude': 0.1, 'frequency': 20}");
        contact_assert_state(run, "Mass 0", (double[]){0, 0.05 + kick * (duration - touch), 0, kick}, 1e-10);
        contact_assert_event(run, "impact", NULL, touch, 1e-11); /* the table slows down: they part at once */
    }
}

/* A ceiling 1 nm above the highest place of a throw is not touched; 1 nm below it, it is. */
static void test_grazing(void)
{
    const double v = 3, top = v * v / 2 / g, duration = 1, depth = 1e-9;
    for (gsize i = 0; i < 6; i++) {
        for (int above = -1; above <= 1; above += 2) {
            double ceiling = top + above * depth;
            PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
            g_autoptr(PhysicsRun) run =
                physics_run(&options,
                            CONTACT_WEIGHT "{'type': 'support', 'position': [0, %.17g], "
                                           "'orientation': '180 deg'}, " CONTACT_POINT ", 'velocity': [0, 3]}",
                            ceiling + 0.2);
            double touch = (v - sqrt(2 * g * depth)) / g, fall = duration - touch;
            double passed[4] = {0, v * duration - g / 2 * duration * duration, 0, v - g * duration};
            double stopped[4] = {0, ceiling - g / 2 * fall * fall, 0, -g * fall};
            /* at 1e-4 m/s, rounding of 1e-14 m moves the touch by 1e-10 s; the two ways lie 1e-4 m apart */
            /* it touches at 1e-4 m/s: rounding of a place, 1e-16 m in each of a thousand steps, is 1e-9 s of that time
             */
            contact_assert_state(run, "Mass 0", above > 0 ? passed : stopped, above > 0 ? 1e-9 : 1e-8);
            physics_assert_near("touches", run->summary->events->len > 0, above < 0, 0);
        }
    }
}

/* Along a plate 1 nm above its top: the parabola of a light pull down and up again touches it or not. */
static void test_grazing_from_above(void)
{
    for (gsize i = 0; i < 6; i++) {
        for (int above = -1; above <= 1; above += 2) {
            /* y'' = 8 from y' = -4: the lowest place lies 1 m below the start, at t = 0.5 */
            PhysicsOptions options = contact_options(&contact_methods[i], 1.25, NULL);
            g_autoptr(PhysicsRun) run =
                physics_run(&options,
                            "{'type': 'gravity', 'acceleration': 8, 'angle': '90 deg'}," CONTACT_FLOOR
                            "}, " CONTACT_POINT ", 'position': [0, %.17g], 'velocity': [0, -4]}",
                            1 + above * 1e-9);
            double touch = 0.5 - sqrt(1e-9 / 4), rise = 1.25 - touch;
            double passed[4] = {0, 1 + 1e-9 - 4 * 1.25 + 4 * 1.5625, 0, 6},
                   stopped[4] = {0, 4 * rise * rise, 0, 8 * rise};
            contact_assert_state(run, "Mass 0", above > 0 ? passed : stopped, above > 0 ? 1e-9 : 1e-8);
            physics_assert_near("touches", run->summary->events->len > 0, above < 0, 0);
        }
    }
}

/* Two discs that approach each other, taken from one step to the next to where they overlap: however that may come, no
 * run goes on from there. */
static void test_missed(void)
{
    const TinkerChoice choice = {.method = tinker_integrator_builtin("rk4"), .step = 1e-3};
    g_autoptr(GError) error = NULL;
    g_auto(OneIsland) one = {0};
    one_island_open(&one, "{'type': 'disc', 'name': 'A', 'radius': 0.5, 'position': [0, 0], 'velocity': [1, 0]},"
                          "{'type': 'disc', 'name': 'B', 'radius': 0.5, 'position': [3, 0], 'velocity': [-1, 0]}");
    one_island_start(&one, &choice, 1);
    g_assert_true(tinker_island_run_step(one.run, 1, &error));
    one.run->state.q[0] += 2.1;
    g_assert_false(tinker_island_run_step(one.run, 1, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN);
    g_assert_nonnull(strstr(error->message, "A and B overlap there, by 0.102 m"));
}

/* Two corners of a block lie on a thin table, whose side they are on is noted once for each, however often a disc that
 * bounces on the block strikes all three. */
static void test_noted_once(void)
{
    const TinkerChoice choice = {.method = tinker_integrator_builtin("rk4"), .step = 1e-3};
    g_autoptr(GError) error = NULL;
    g_auto(OneIsland) one = {0};
    one_island_open(&one, CONTACT_WEIGHT
                    "{'type': 'support', 'solid': false}, {'type': 'bar', 'position': [0, 0], 'length': 4, 'width': 0, "
                    "'solid': true},"
                    "{'type': 'weld', 'ends': ['Support 0', 'Bar 0']}, {'type': 'box', 'width': 1, 'height': 0.5,"
                    " 'position': [0, 0.25]}, {'type': 'disc', 'radius': 0.1, 'position': [0, 0.65],"
                    " 'restitution': 1}");
    one_island_start(&one, &choice, 1);
    const TinkerContactRun *contacts = one.run->contacts;
    while (one.run->state.t < 1) {
        g_assert_true(tinker_island_run_step(one.run, 1, &error));
        g_assert_cmpuint(contacts->struck->len, <=, 2);
    }
    g_assert_cmpuint(contacts->struck->len, ==, 2);
    g_assert_cmpint(g_array_index(contacts->struck, int32_t, 0), !=, g_array_index(contacts->struck, int32_t, 1));
    g_assert_cmpuint(one.whole.events->len, >, 4); /* from 5 cm it comes back each 0.2 s */
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-tunnelling/bullets", test_bullets);
    g_test_add_func("/physics/contact-tunnelling/the-first-of-several", test_the_first_of_several);
    g_test_add_func("/physics/contact-tunnelling/to-and-fro", test_to_and_fro);
    g_test_add_func("/physics/contact-tunnelling/up-and-down-in-a-step", test_up_and_down_in_a_step);
    g_test_add_func("/physics/contact-tunnelling/kicked-within-a-step", test_kicked_within_a_step);
    g_test_add_func("/physics/contact-tunnelling/grazing", test_grazing);
    g_test_add_func("/physics/contact-tunnelling/grazing-from-above", test_grazing_from_above);
    g_test_add_func("/physics/contact-tunnelling/missed", test_missed);
    g_test_add_func("/physics/contact-tunnelling/noted-once", test_noted_once);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
