/* One damped oscillator, m = 1 kg, k = 25 N/m, c = 0.4 N s/m. */
#include "floors.h"

static double acceleration(double x, double v)
{
    return -25.0 * x - 0.4 * v;
}

void floor_oscillator_steps(FloorOscillator *at, double h, long steps)
{
    double x = at->x, v = at->v;
    for (long i = 0; i < steps; i++) {
        double a1 = acceleration(x, v), v2 = v + 0.5 * h * a1;
        double a2 = acceleration(x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
        double a3 = acceleration(x + 0.5 * h * v2, v3), v4 = v + h * a3;
        double a4 = acceleration(x + h * v3, v4);
        x += h / 6.0 * (v + 2.0 * (v2 + v3) + v4);
        v += h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4);
    }
    *at = (FloorOscillator){x, v};
}
