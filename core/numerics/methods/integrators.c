/* The list of built-in integrators. A new method is one file with one table, and one line here. */
#include "numerics/methods/integrators.h"

#include <glib.h>

#include "numerics/integrate/stepping.h"

static const TinkerIntegrator *const builtins[] = {
    &tinker_integrator_semi_implicit_euler,
    &tinker_integrator_verlet,
    &tinker_integrator_rk4,
    &tinker_integrator_dopri5,
    &tinker_integrator_dop853,
    &tinker_integrator_verlet6,
    &tinker_integrator_newmark,
    &tinker_integrator_generalized_alpha,
    &tinker_integrator_exact,
    NULL,
};

const TinkerIntegrator *tinker_integrator_builtin(const char *id)
{
    for (const TinkerIntegrator *const *each = builtins; *each; each++)
        if (g_strcmp0((*each)->id, id) == 0) return *each;
    return NULL;
}

const TinkerIntegrator *const *tinker_integrator_builtins(void)
{
    return builtins;
}
