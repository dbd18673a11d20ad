/* What one step of each method does to an oscillator, over the planes in which regions of stability are drawn.
 *
 * The plane of h lambda: a motion goes as exp(lambda t), and a damped oscillator has a pair of such lambda, one above
 * the other. It says all about methods that treat places and velocities alike. The plane of (h omega, h c / m): for
 * those that do not. */
#ifndef DOCS_GROWTH_H
#define DOCS_GROWTH_H

#include <glib.h>

#include <tinker/integrator.h>

typedef enum { PLANE_OF_ROOTS, PLANE_OF_DAMPING } Plane;

typedef struct Method Method;
struct Method {
    const char *id;
    Plane plane;
    /* The factor by which the motion grows at a step. */
    double (*growth)(const Method *method, double x, double y);
    /* The largest error of steps in a row over ten turns of what is fastest, relative to the motion's start; NULL: not
     * drawn. */
    double (*error)(const Method *method, double x, double y);
    int order; /* of a formula that comes in several */
};

/* The methods whose regions are drawn; ended by one without an id. The five orders of cvode-bdf come one after the
 * other. */
extern const Method docs_methods[];

const TinkerIntegrator *docs_integrator(const Method *method);

/* The edge of the region of the backward differentiation formula of this order, at a turn of angle: what
 * sum_j (1 - exp(-i angle))^j / j is, j up to the order. */
void docs_bdf_edge(int order, double angle, double *real, double *imaginary);

/* The motion of an undamped oscillator after ten periods, with so many steps a period: the part by which it is missed.
 */
double docs_error_of_ten_periods(const char *id, double steps_a_period);

/* Growth of an undamped oscillator at one step; `spectral_radius` of generalized-alpha. */
double docs_undamped_growth(const char *id, double spectral_radius, double turn);

#endif
