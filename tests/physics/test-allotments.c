/* No memory is allotted inside a running step, whatever takes part in it. */
#include "allotments.h"
#include "physics-fixture.h"

#include "numerics/methods/integrators.h"
#include "physics/run/simulation.h"

static const char *const scenes[] = {
    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [2, 0]}, {'type': 'mass', 'position': [4, 0]},"
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1}, {'type': 'damper', 'ends': ['Mass 0', "
    "'Mass "
    "1']}, {'type': 'motor', 'ends': ['Mass 0']}, {'type': 'wind', 'drag': 0.1},"
    "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1, 'frequency': 3}",

    "{'type': 'support'}, {'type': 'mass', 'position': [2, 0]},"
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 1}, {'type': 'damper', 'ends': ['Support 0', "
    "'Mass 0']},"
    "{'type': 'motor', 'ends': ['Mass 0']}, {'type': 'wind', 'drag_quadratic': 0.1},"
    "{'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': 'sin(t)*exp(-t)'}}",

    "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1, 0]}, {'type': 'mass', "
    "'position': [2, "
    "0]},"
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
    "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1, 'frequency': 3},"
    "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",

    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [2, 0]}, {'type': 'mass', 'position': [2, 1]},"
    "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 3, 'length': 1},"
    "{'type': 'bundle', 'ends': ['Mass 0', 'Mass 1', 'Support 0'], 'stiffness': 2}, {'type': 'attraction', 'strength': "
    "1},"
    "{'type': 'torsion', 'ends': ['Mass 0', 'Support 0', 'Mass 1'], 'stiffness': 1},"
    "{'type': 'orbit', 'ends': ['Support 0'], 'radius': 0.1, 'rate': 2},"
    "{'type': 'actuator', 'ends': ['Mass 0', 'Mass 1'], 'waveform': {'expression': '1 + 0.1*sin(t)^2'}}",

    /* one rests, one slides, two on a rod rest; no contact changes */
    "{'type': 'gravity'}, {'type': 'support', 'width': 1e6}, {'type': 'mass', 'position': [0, 0.6]}, {'type': 'mass', "
    "'position': [2, 0.6], 'velocity': [1e4, 0]}, {'type': 'mass', 'position': [-3, 0.6]}, {'type': 'mass', "
    "'position': "
    "[-4, 0.6]}, {'type': 'rod', 'ends': ['Mass 2', 'Mass 3']}",
};

/* The first scene is linear, the others are not. */
static void test_steps(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    gsize count = method->flags & TINKER_INTEGRATOR_LINEAR ? 1 : G_N_ELEMENTS(scenes);
    /* an adaptive step of what only rests or slides ends with its piece, and a new piece may allot */
    if (method->flags & TINKER_INTEGRATOR_ADAPTIVE) count--;
    for (gsize i = 0; i < count; i++) {
        int at_first = allotments;
        g_autoptr(PhysicsRun) run =
            physics_prepare(&(PhysicsOptions){.method = method->id, .duration = 1e3, .interval = 1, .tolerance = 1e-6},
                            "%s", scenes[i]);
        g_assert_cmpint(allotments, >, at_first);
        int before = allotments;
        gboolean stepped = TRUE;
        for (int step = 0; step < 200 && stepped; step++)
            stepped = tinker_simulation_step(run->simulation, &run->error);
        int after = allotments;
        g_assert_no_error(run->error);
        g_assert_true(stepped); /* the end of a run may allot */
        g_assert_cmpint(after, ==, before);
    }
}

static void add_tests(void)
{
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        g_autofree char *name = g_strdup_printf("/physics/allotments/%s", (*method)->id);
        g_test_add_data_func(name, *method, test_steps);
    }
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
