/* The integrators that are linked in, each behind the vtable of the SDK's integrator.h.
 *
 * They are constant tables: nothing here has state, and every function may be called from any thread. The steppers that
 * the tables create belong to one thread at a time.
 */
#ifndef TINKER_NUMERICS_INTEGRATORS_H
#define TINKER_NUMERICS_INTEGRATORS_H

#include <tinker/integrator.h>

/* The built-in integrator with this id ("rk4"), static, or NULL where there is none. */
const TinkerIntegrator *tinker_integrator_builtin(const char *id);

/* All built-in integrators, simplest first; static, ended by NULL. */
const TinkerIntegrator *const *tinker_integrator_builtins(void);

#endif
