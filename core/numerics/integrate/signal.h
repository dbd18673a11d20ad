/* Signals of the SDK's integrator.h, evaluated. */
#ifndef TINKER_NUMERICS_SIGNAL_H
#define TINKER_NUMERICS_SIGNAL_H

#include <math.h>

#include <tinker/integrator.h>

/* At time t: of a polynomial its value and three derivatives; of A sin(w s + phi) that, A cos(w s + phi), 0 and 0. */
static inline void tinker_signal_values(const TinkerSignal *signal, double t, double values[4])
{
    const double *c = signal->coefficient;
    double s = t - signal->origin;
    if (signal->kind == TINKER_SIGNAL_HARMONIC) {
        double phase = c[1] * s + c[2];
        values[0] = c[0] * sin(phase);
        values[1] = c[0] * cos(phase);
        values[2] = values[3] = 0.0;
        return;
    }
    values[0] = c[0] + s * (c[1] + s * (c[2] + s * c[3]));
    values[1] = c[1] + s * (2.0 * c[2] + s * (3.0 * c[3]));
    values[2] = 2.0 * c[2] + 6.0 * c[3] * s;
    values[3] = 6.0 * c[3];
}

#endif
