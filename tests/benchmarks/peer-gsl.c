/* The explicit and multistep methods of the GNU Scientific Library. Those of its implicit methods that could take a
 * stiff problem factor a full matrix and do not stop at order 2: they are not tried. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <string.h>

#include "peers.h"

#define FIRST_STEP 1e-3

static int rates(double t, const double *y, double *f, void *problem)
{
    ((const PeerProblem *)problem)->rates(t, y, f);
    return GSL_SUCCESS;
}

static gboolean solve(const Peer *peer, const PeerProblem *problem, double tolerance, double *y, PeerLook look,
                      void *data)
{
    const gsl_odeiv2_step_type *const *type = peer->kind;
    gsl_odeiv2_system system = {rates, NULL, (size_t)problem->size, (void *)problem};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, *type, FIRST_STEP, tolerance, tolerance);
    double t = 0;
    int status = GSL_SUCCESS;
    memcpy(y, problem->start, (gsize)problem->size * sizeof *y);
    while (status == GSL_SUCCESS && t < problem->duration) {
        status =
            gsl_odeiv2_evolve_apply(driver->e, driver->c, driver->s, &system, &t, problem->duration, &driver->h, y);
        if (look != NULL) look(t, y, data);
    }
    gsl_odeiv2_driver_free(driver);
    return status == GSL_SUCCESS;
}

const Peer *peer_gsl(void)
{
    static const Peer peers[] = {
        {"GSL", "rkf45", TRUE, TRUE, &gsl_odeiv2_step_rkf45, solve},
        {"GSL", "rk8pd", TRUE, TRUE, &gsl_odeiv2_step_rk8pd, solve},
        {"GSL", "msadams", FALSE, TRUE, &gsl_odeiv2_step_msadams, solve},
        {NULL},
    };
    gsl_set_error_handler_off();
    return peers;
}
