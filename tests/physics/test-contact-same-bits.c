/* Contact changes nothing where nobody asked for it, and recording changes nothing where somebody did. */
#include "contact-checks.h"

#include "physics/contact/contacts.h"
#include "physics/system/summary.h"

#include <string.h>

/* --- only when asked for --- */

/* Masses on springs, dampers and rods that swing through where a support would be. */
static const char swinging[] =
    CONTACT_WEIGHT "{'type': 'support', 'position': [0, 2], 'solid': false}, " CONTACT_POINT
                   ", 'position': [1, 2]}, {'type': 'mass', 'position': [2, 2.5], 'mass': 0.5},"
                   "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'spring', 'ends': ['Mass 0', 'Mass 1']},"
                   "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 0.1}";

static void test_without_solid_supports(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 3, NULL);
        options.interval = 0.3;
        g_autoptr(PhysicsRun) bare = physics_run(&options, "%s", swinging);
        g_autoptr(PhysicsRun) anchor =
            physics_run(&options, "%s, {'type': 'support', 'position': [0, 1], 'width': 9, 'solid': false}", swinging);
        physics_assert_same_bits(bare, anchor);
        physics_assert_near("steps", (double)anchor->summary->steps, (double)bare->summary->steps, 0);
        physics_assert_near("evaluations", (double)anchor->summary->evaluations, (double)bare->summary->evaluations, 0);
        contact_assert_taken(bare, 0, 0, 0);
    }
}

/* A solid support that nothing reaches changes the state by no more than the method may be off. */
static void test_far_from_solid_supports(void)
{
    for (gsize i = 0; i < 2; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 3, NULL);
        g_autoptr(PhysicsRun) bare = physics_run(&options, "%s", swinging);
        g_autoptr(PhysicsRun) solid = physics_run(&options, "%s, {'type': 'support', 'position': [0, -50]}", swinging);
        double state[4];
        for (int k = 0; k < 2; k++) {
            const char *mass = k == 0 ? "Mass 0" : "Mass 1";
            physics_state(bare, mass, state);
            contact_assert_state(solid, mass, state, 1e-8);
        }
        g_assert_cmpuint(solid->summary->events->len, ==, 0);
    }
}

/* --- determinism --- */

/* Bounces, slides, sticks, slips and takes off. */
static const char everything[] = CONTACT_WEIGHT CONTACT_FLOOR
    ", 'width': 8, 'restitution': 0.6, 'static_friction': 0.5, 'dynamic_friction': 0.3},"
    "{'type': 'support', 'position': [3, 0], 'orientation': 1.2, 'restitution': 0.4},"
    "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.08, 'frequency': 9},"
    "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.02, 'frequency': 31, 'angle': 1.5708},"
    "{'type': 'mass', 'position': [0, 1.5], 'velocity': [1.1, 0]}," CONTACT_POINT
    ", 'position': [1, 2], 'velocity': [0.5, 1]}, {'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': "
    "12}, {'type': 'mass', 'mass': 0.3, 'position': [-1, 0.9]}, {'type': 'mass', 'position': [-2, 1.1]},"
    "{'type': 'rod', 'ends': ['Mass 2', 'Mass 3']}";

static void assert_same_events(const PhysicsRun *left, const PhysicsRun *right)
{
    g_assert_cmpuint(left->summary->events->len, ==, right->summary->events->len);
    for (guint i = 0; i < MIN(left->summary->events->len, right->summary->events->len); i++) {
        const TinkerEvent *l = g_ptr_array_index(left->summary->events, i);
        const TinkerEvent *r = g_ptr_array_index(right->summary->events, i);
        g_assert_cmpmem(&l->time, sizeof(double), &r->time, sizeof(double));
        g_assert_cmpstr(l->kind, ==, r->kind);
        g_assert_cmpstr(l->blocks, ==, r->blocks);
    }
}

/* A box, a disc and plates that fall onto a slope, on one another: bodies touch bodies. */
static const char tumbling[] = CONTACT_WEIGHT
    "{'type': 'support', 'position': [0, -0.1], 'width': 20, 'height': 0.2, 'orientation': -0.029, 'static_friction':"
    " 0.86, 'dynamic_friction': 0.688, 'restitution': 0.41}, {'type': 'box', 'mass': 1.086, 'width': 0.99, 'height':"
    " 0.78, 'position': [0.097, 1.2128], 'static_friction': 0, 'dynamic_friction': 0, 'restitution': 0}, {'type':"
    " 'disc', 'mass': 0.779, 'radius': 0.35, 'position': [0.07, 1.9528000000000003]}, {'type': 'plate', 'mass': 0.756,"
    " 'corners': [[0.271, 0.057], [-0.062, 0.27], [-0.178, -0.212]], 'position': [-0.235, 2.5531333333333337],"
    " 'static_friction': 1, 'dynamic_friction': 1}, {'type': 'plate', 'mass': 0.802, 'corners': [[0.31, 0.034],"
    " [-0.103, 0.294], [-0.154, -0.271]], 'position': [0.129, 3.5578000000000007], 'static_friction': 0.1,"
    " 'dynamic_friction': 0.1, 'restitution': 0.87}, {'type': 'plate', 'mass': 4.983, 'corners': [[-0.4, 0], [0.4, 0],"
    " [0.249, 0.336], [-0.249, 0.336]], 'position': [0.177, 4.1967707241910635]}";

static void assert_same_work(const PhysicsRun *left, const PhysicsRun *right)
{
    physics_assert_same_bits(left, right);
    assert_same_events(left, right);
    g_assert_cmpint(left->summary->steps, ==, right->summary->steps);
    g_assert_cmpint(left->summary->evaluations, ==, right->summary->evaluations);
}

static void assert_recording_changes_nothing(PhysicsOptions *options, const char *blocks)
{
    static const double intervals[] = {0.5, 0.00371, 1.0 / 60};
    const double at[] = {0.1, 1.0 / 3, options->duration};
    g_autoptr(PhysicsRun) once = physics_run(options, "%s", blocks);
    g_assert_cmpuint(once->summary->events->len, >, 5);
    g_autoptr(PhysicsRun) again = physics_run(options, "%s", blocks);
    assert_same_work(once, again);
    for (gsize k = 0; k < G_N_ELEMENTS(intervals); k++) {
        options->interval = intervals[k];
        g_autoptr(PhysicsRun) other = physics_run(options, "%s", blocks);
        assert_same_work(once, other);
    }
    options->at = at;
    options->at_count = G_N_ELEMENTS(at);
    g_autoptr(PhysicsRun) listed = physics_run(options, "%s", blocks);
    assert_same_work(once, listed);
}

static void test_recording(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options =
            contact_options(&contact_methods[i], 2, "Mass 0.x, Mass 0.normal force, Mass 2.contact force");
        assert_recording_changes_nothing(&options, everything);
    }
    PhysicsOptions options = {.method = "dop853", .tolerance = 1e-9, .duration = 1, .columns = "Box 0.ax, Disc 0.ax"};
    assert_recording_changes_nothing(&options, tumbling);
}

/* The same scene by two methods at fine tolerance or step: what has no closed form agrees. The books close. */
static void test_two_methods(void)
{
    PhysicsOptions options = contact_options(&contact_methods[0], 0.8, NULL);
    g_autoptr(PhysicsRun) automatic = physics_run(&options, "%s", everything);
    g_assert_cmpuint(automatic->summary->events->len, >, 5);
    static const struct {
        const char *method;
        double step, bound;
    } others[] = {{"dop853", 0, 1e-8}, {"rk4", 0.0003, 1e-6}, {"verlet6", 0.001, 1e-6}, {"newmark", 0.00005, 1e-4}};
    for (gsize i = 0; i < G_N_ELEMENTS(others); i++) {
        PhysicsOptions how = {.method = others[i].method, .step = others[i].step, .tolerance = 1e-12, .duration = 0.8};
        g_autoptr(PhysicsRun) run = physics_run(&how, "%s", everything);
        for (int k = 0; k < 4; k++) {
            g_autofree char *mass = g_strdup_printf("Mass %d", k);
            double state[4];
            physics_state(automatic, mass, state);
            contact_assert_state(run, mass, state, others[i].bound);
        }
        physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, i == 0 ? 1e-9 : 1e-4);
    }
    physics_assert_near("the error of the books", automatic->summary->energy_balance_error, 0, 1e-9);
}

/* What is not solid has no contact code at all; what nothing touches is asked for no force of contact. */
static void test_only_when_asked_for(void)
{
    PhysicsOptions options = contact_options(&contact_methods[0], 3, NULL);
    g_autoptr(PhysicsRun) bare = physics_run(&options, "%s", swinging);
    g_assert_null(bare->model->contacts);
    g_autoptr(PhysicsRun) far = physics_run(&options, "%s, {'type': 'support', 'position': [0, -50]}", swinging);
    g_assert_nonnull(far->model->contacts);
    g_assert_cmpint(far->model->contacts->evaluations, ==, 0);
    g_autoptr(PhysicsRun) lands = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR "}, " CONTACT_POINT "}");
    g_assert_cmpint(lands->model->contacts->evaluations, >, 0);
}

/* --- apart --- */

/* A box that slides and bears another, whose corners stick: more equations than the motion asks for. */
#define PILE(x, mass)                                                                                                  \
    "{'type': 'box', 'position': [" x ", 0.3], 'width': 2, 'height': 0.6, 'mass': " mass ", 'velocity': [2, 0]},"      \
    "{'type': 'box', 'position': [" x ", 0.75], 'width': 0.7, 'height': 0.3, 'velocity': [2, 0]}"

/* Two piles may meet, but do not touch: what one does is no part of the other's equations. */
static void test_piles_apart(void)
{
    const PhysicsOptions options = {.method = "rk4", .step = 1.0 / 256, .duration = 0.25};
    static const char floor[] =
        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 90, 'static_friction': 0.4, 'dynamic_friction': 0.37}";
    g_autoptr(PhysicsRun) alone = physics_run(&options, "%s, " PILE("0", "1.7"), floor);
    g_autoptr(PhysicsRun) beside = physics_run(&options, "%s, " PILE("0", "1.7") ", " PILE("20.3", "3.1"), floor);
    g_assert_cmpint(beside->model->contacts->group[0], ==, beside->model->contacts->group[3]);
    g_assert_cmpuint(alone->model->contacts->blocks->len, ==, 1);
    g_assert_cmpuint(beside->model->contacts->blocks->len, ==, 2);
    for (int k = 0; k < 2; k++) {
        double left[4], right[4];
        physics_state(alone, k == 0 ? "Box 0" : "Box 1", left);
        physics_state(beside, k == 0 ? "Box 0" : "Box 1", right);
        g_assert_cmpmem(left, sizeof(left), right, sizeof(right));
    }
}

/* A box on a smooth floor that a force of 4e-13 N pushes along has v = F t / m, however many others there are: what
 * counts as rounding of forces that cancel depends on its own contacts alone. */
static void test_small_force(void)
{
    const PhysicsOptions options = {.method = "rk4", .step = 1.0 / 64, .duration = 1, .columns = "Box 0.vx"};
    g_autoptr(GString) blocks =
        g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 90, " CONTACT_SMOOTH
                                                  "}, {'type': 'law-force', 'ends': ['Box 0'], 'force_x': '4e-13'}");
    for (int i = 0; i < 30; i++) {
        g_string_append_printf(blocks, ", {'type': 'box', 'position': [%d, 0.25], 'width': 1, 'height': 0.5}", 2 * i);
        if (i > 0 && i < 29) continue;
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
        physics_assert_near("speed", physics_last(run, 0), 4e-13, 1e-16);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-same-bits/without-solid-supports", test_without_solid_supports);
    g_test_add_func("/physics/contact-same-bits/far-from-solid-supports", test_far_from_solid_supports);
    g_test_add_func("/physics/contact-same-bits/only-when-asked-for", test_only_when_asked_for);
    g_test_add_func("/physics/contact-same-bits/piles-apart", test_piles_apart);
    g_test_add_func("/physics/contact-same-bits/recording", test_recording);
    g_test_add_func("/physics/contact-same-bits/small-force", test_small_force);
    g_test_add_func("/physics/contact-same-bits/two-methods", test_two_methods);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
