/* The double pendulum in its two angles. With d = angle1 - angle2 and unit masses and lengths,
 *
 *   2 a1 + cos d a2 = -sin d w2^2 - 2 g sin angle1,   cos d a1 + a2 = sin d w1^2 - g sin angle2,
 *
 * solved by Cramer's rule; the determinant 2 - cos^2 d is never below 1. */
#include "floors.h"

#include <math.h>

#define GRAVITY 9.81

static void accelerations(const double *angle, const double *rate, double *a)
{
    double sine1 = sin(angle[0]), cosine1 = cos(angle[0]), sine2 = sin(angle[1]), cosine2 = cos(angle[1]);
    double s = sine1 * cosine2 - cosine1 * sine2, c = cosine1 * cosine2 + sine1 * sine2;
    double first = -s * rate[1] * rate[1] - 2.0 * GRAVITY * sine1, second = s * rate[0] * rate[0] - GRAVITY * sine2;
    double inverse = 1.0 / (2.0 - c * c);
    a[0] = (first - c * second) * inverse;
    a[1] = (2.0 * second - c * first) * inverse;
}

static void stage(const FloorDoublePendulum *at, double h, const double *rate, const double *a, FloorDoublePendulum *to)
{
    for (int k = 0; k < 2; k++) {
        to->angle[k] = at->angle[k] + h * rate[k];
        to->rate[k] = at->rate[k] + h * a[k];
    }
}

void floor_double_pendulum_steps(FloorDoublePendulum *at, double h, long steps)
{
    FloorDoublePendulum y = *at, y2, y3, y4;
    double a1[2], a2[2], a3[2], a4[2];
    for (long i = 0; i < steps; i++) {
        accelerations(y.angle, y.rate, a1);
        stage(&y, 0.5 * h, y.rate, a1, &y2);
        accelerations(y2.angle, y2.rate, a2);
        stage(&y, 0.5 * h, y2.rate, a2, &y3);
        accelerations(y3.angle, y3.rate, a3);
        stage(&y, h, y3.rate, a3, &y4);
        accelerations(y4.angle, y4.rate, a4);
        for (int k = 0; k < 2; k++) {
            y.angle[k] += h / 6.0 * (y.rate[k] + 2.0 * (y2.rate[k] + y3.rate[k]) + y4.rate[k]);
            y.rate[k] += h / 6.0 * (a1[k] + 2.0 * (a2[k] + a3[k]) + a4[k]);
        }
    }
    *at = y;
}
