#include <math.h>

#include "numerics/contact/contact-private.h"
#include "numerics/contact/tolerances.h"
#include "numerics/roots/step-roots.h"

typedef struct {
    const TinkerImpact *impact;
    double *offset, *impulses;
    double *after, *terms; /* 2m */
    TinkerContactResult result;
} Trial;

/* Impulses with a share of the restitution, and what energy they take from the bodies (0 where that is rounding); -1
 * where there are none: bodies that wedge cannot part against their friction. Where memory lacked once nothing is tried
 * any more. */
static double lost_energy(void *data, double share)
{
    Trial *trial = data;
    const TinkerImpact *impact = trial->impact;
    if (trial->result == TINKER_CONTACT_NO_MEMORY) return -1;
    TinkerContactProblem problem = {impact->count, impact->delassus, trial->offset, impact->friction,
                                    NULL,          impact->motion,   impact->bearer};
    for (int32_t k = 0; k < impact->count; k++) {
        double normal = impact->velocity[2 * k];
        double least = impact->least != NULL ? impact->least[k]
                       : normal < 0          ? -share * impact->restitution[k] * normal
                                             : 0;
        trial->offset[2 * k] = normal - least;
        trial->offset[2 * k + 1] = impact->velocity[2 * k + 1];
    }
    trial->result = tinker_contact_solve(&problem, trial->impulses);
    if (trial->result != TINKER_CONTACT_SOLVED) return -1;
    if (impact->least != NULL) return 0;
    double gained = 0, size = 0;
    tinker_contact_velocities(&problem, trial->impulses, trial->after, trial->terms);
    for (int32_t i = 0; i < 2 * impact->count; i++) {
        /* offsets differ from velocities by what is asked for */
        const double after = trial->after[i] + (impact->velocity[i] - trial->offset[i]);
        gained += trial->impulses[i] * (impact->velocity[i] + after) / 2;
        size += fabs(trial->impulses[i]) * trial->terms[i];
    }
    return fabs(gained) <= TINKER_ENERGY_ROUNDING * size ? 0 : -gained;
}

/* For tinker_step_refine: what is rounding counts as a little lost. */
static double lost_or_none(void *data, double share)
{
    double lost = lost_energy(data, share);
    return lost == 0 ? 1e-300 : lost;
}

TinkerContactResult tinker_impact_solve(const TinkerImpact *impact, double *impulses)
{
    double few[6 * 8];
    const gsize m = (gsize)impact->count;
    g_autofree double *many = m > 8 ? g_try_new(double, 6 * m) : NULL;
    if (m > 8 && many == NULL) return TINKER_CONTACT_NO_MEMORY;
    double *room = many != NULL ? many : few;
    Trial trial = {impact, room, impulses, room + 2 * m, room + 4 * m, TINKER_CONTACT_SOLVED};
    if (lost_energy(&trial, 1) >= 0 || impact->least != NULL) return trial.result;
    if (lost_energy(&trial, 0) < 0 && trial.result != TINKER_CONTACT_SOLVED) {
        lost_energy(&trial, 1); /* of others, where one is blocked */
        return trial.result;
    }
    double share = tinker_step_refine(0, 1, lost_or_none, &trial);
    for (double back = 1e-15; lost_energy(&trial, share) < 0 && share > 0; back *= 4)
        share = MAX(share - back, 0);
    return trial.result;
}
