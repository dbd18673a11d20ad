/* How high the order may be.
 *
 * Above order 2 the formulas are unstable along a part of the imaginary axis: a fast vibration without damping, of
 * which nothing is to be seen any more, would tie the step to its own period. CVODE's stability limit detection (A. C.
 * Hindmarsh, Applied Numerical Mathematics 17 (1995) 311-318) reports that a step is held down by stability, but
 * also where a slowly decaying vibration is being followed. What tells the two apart is the step: an order of up to 5
 * that follows the fastest vibration takes steps of about
 *
 *     omega h = 0.9 tolerance^(1/6)
 *
 * (the error of order 5 falls as h^6). A reported step of more than twice that follows something slower, and is then
 * taken with order 2, which is stable for every step. The cap is lifted where steps become short again.
 */
#include "stepper-private.h"

#include <math.h>

#define FULL_ORDER   5
#define STABLE_ORDER 2

#define UNRESOLVED 1.8 /* omega h over tolerance^(1/6): the fastest vibration is not followed ... */
#define RESOLVED   0.5 /* ... and is */
/* Steps that order 2 needs to find its length. */
#define STEPS_TO_SETTLE 100

void stepper_order_restart(Stepper *stepper)
{
    stepper->stability_reports = 0;
    stepper->steps_since_cap = 0;
    CVodeSetMaxOrd(stepper->cvode, stepper->capped ? STABLE_ORDER : FULL_ORDER);
}

/* omega h of the fastest vibration in the last step, against what order 5 would take to follow it. */
static double coarseness(const Stepper *stepper)
{
    double h = 0.0;
    CVodeGetLastStep(stepper->cvode, &h);
    return h * stepper->fastest / pow(stepper->tolerance, 1.0 / (FULL_ORDER + 1));
}

int stepper_order_watch(Stepper *stepper)
{
    if (stepper->capped) {
        if (++stepper->steps_since_cap <= STEPS_TO_SETTLE || coarseness(stepper) > RESOLVED) return 0;
        stepper->capped = 0;
        CVodeSetMaxOrd(stepper->cvode, FULL_ORDER);
        return 0;
    }
    long reports = 0;
    CVodeGetNumStabLimOrderReds(stepper->cvode, &reports);
    int reported = reports > stepper->stability_reports;
    stepper->stability_reports = reports;
    stepper->capped = reported && coarseness(stepper) > UNRESOLVED;
    return stepper->capped;
}
