/* One damped oscillator in closed form.
 *
 * With delta = c/2 the roots are -delta +- sqrt(delta^2 - omega^2). Sums that would cancel are written otherwise:
 * the slow root as omega^2 / (delta + gamma), differences of exponentials by expm1, and where everything is small
 * the series of exp(A h) - I itself, whose small entries then keep their digits.
 */
#include <math.h>

#include "numerics/exact/linear-response.h"

#define SERIES_TERMS 16

/* X <- h/k (I + X) A, from the last term to the first. */
static void by_series(double scale, double below, double c, double h, double f[4])
{
    for (int k = 0; k < 4; k++)
        f[k] = 0.0;
    for (int k = SERIES_TERMS; k > 0; k--) {
        double x = h / k, f00 = 1.0 + f[0], f01 = f[1], f10 = f[2], f11 = 1.0 + f[3];
        f[0] = x * (f01 * below);
        f[1] = x * (f00 * scale - f01 * c);
        f[2] = x * (f11 * below);
        f[3] = x * (f10 * scale - f11 * c);
    }
}

/* `s` is the response to a unit velocity; its factors in the other entries. */
static void place(double scale, double below, double s, double f[4])
{
    f[1] = scale * s;
    f[2] = below * s;
}

static void underdamped(double omega, double delta, double h, double f[4], double *s)
{
    double rate = sqrt((omega - delta) * (omega + delta)), fade = exp(-delta * h);
    *s = fade * sin(rate * h) / rate;
    if (delta == 0.0) {
        double half = sin(0.5 * omega * h);
        f[0] = f[3] = -2.0 * half * half;
        return;
    }
    double middle = fade * cos(rate * h);
    f[0] = middle + delta * *s - 1.0;
    f[3] = middle - delta * *s - 1.0;
}

static void overdamped(double omega, double delta, double h, double f[4], double *s)
{
    double gamma = sqrt((fabs(delta) - omega) * (fabs(delta) + omega)), sum = fabs(delta) + gamma;
    double slow = copysign(omega * (omega / sum), -delta), fast = copysign(sum, -delta), apart = slow - fast;
    double x = -apart * h;
    *s = exp(slow * h) * h * (x == 0.0 ? 1.0 : expm1(x) / x);
    if (gamma > 0.25 * fabs(delta)) {
        double slowly = expm1(slow * h), fastly = expm1(fast * h);
        f[0] = (slow / apart) * fastly - (fast / apart) * slowly;
        f[3] = (slow / apart) * slowly - (fast / apart) * fastly;
        return;
    }
    double middle = 0.5 * (exp(slow * h) + exp(fast * h));
    f[0] = middle + delta * *s - 1.0;
    f[3] = middle - delta * *s - 1.0;
}

void tinker_linear_oscillator(double omega, double c, double h, double propagator[4])
{
    double scale = tinker_linear_scale(omega), below = omega > 0.0 ? -omega : 0.0, s;
    if ((omega + fabs(c)) * fabs(h) < 0.5) {
        by_series(scale, below, c, h, propagator);
        return;
    }
    if (omega == 0.0) {
        propagator[0] = 0.0;
        propagator[3] = expm1(-c * h);
        s = c == 0.0 ? h : -propagator[3] / c;
    } else if (fabs(0.5 * c) < omega) {
        underdamped(omega, 0.5 * c, h, propagator, &s);
    } else {
        overdamped(omega, 0.5 * c, h, propagator, &s);
    }
    place(scale, below, s, propagator);
}

/* (1 - (1 - exp(-x)) / x) / x, by its series where that cancels. */
static double second_integral(double x)
{
    if (fabs(x) > 0.5) return (1.0 + expm1(-x) / x) / x;
    double sum = 0.0;
    for (int k = SERIES_TERMS + 2; k >= 2; k--)
        sum = (1.0 - x * sum) / k;
    return sum;
}

/* Under a force f that stays the oscillator moves about f / omega^2 as it would about 0. */
void tinker_linear_push(double omega, double c, double h, const double propagator[4], double push[2])
{
    if (omega > 0.0) {
        push[0] = -propagator[0] / omega;
        push[1] = -propagator[2] / omega;
        return;
    }
    push[0] = h * h * second_integral(c * h);
    push[1] = c == 0.0 ? h : -expm1(-c * h) / c;
}
