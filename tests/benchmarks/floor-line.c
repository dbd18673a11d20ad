/* Unit masses in a line, each on a spring and a damper from the one before: a frame on a moving base by Runge-Kutta
 * steps, and the stiff chain by average acceleration, whose equations are factored once. Displacements from rest alone.
 */
#include "floors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STOREYS 4
#define MASSES  50

/* The spring and damper behind mass i. */
typedef struct {
    double stiffness[MASSES], damping[MASSES];
} Line;

static inline void accelerations(const Line *line, int count, const double *x, const double *v, double base,
                                 double base_rate, double *a)
{
    double pull = line->stiffness[0] * (x[0] - base) + line->damping[0] * (v[0] - base_rate);
    for (int i = 0; i + 1 < count; i++) {
        double next = line->stiffness[i + 1] * (x[i + 1] - x[i]) + line->damping[i + 1] * (v[i + 1] - v[i]);
        a[i] = next - pull;
        pull = next;
    }
    a[count - 1] = -pull;
}

/* The frame -------------------------------------------------------------------------------------------------------- */

static const Line frame = {{600, 540, 480, 420}, {1.2, 1.2, 1.2, 1.2}};

static void on_base(double t, const double *x, const double *v, double *a)
{
    double base = 0.05 * sin(7.3 * t) + 0.01 * sin(19.1 * t);
    double rate = 0.05 * 7.3 * cos(7.3 * t) + 0.01 * 19.1 * cos(19.1 * t);
    accelerations(&frame, STOREYS, x, v, base, rate, a);
}

static void shift(const double *from, const double *rate, double h, double *to)
{
    for (int i = 0; i < STOREYS; i++)
        to[i] = from[i] + h * rate[i];
}

void floor_frame_steps(FloorFrame *at, double h, long steps)
{
    for (long n = 0; n < steps; n++) {
        double t = (double)at->steps * h, *x = at->x, *v = at->v;
        double x2[STOREYS], v2[STOREYS], v3[STOREYS], v4[STOREYS], a[4][STOREYS];
        on_base(t, x, v, a[0]);
        shift(x, v, 0.5 * h, x2);
        shift(v, a[0], 0.5 * h, v2);
        on_base(t + 0.5 * h, x2, v2, a[1]);
        shift(x, v2, 0.5 * h, x2);
        shift(v, a[1], 0.5 * h, v3);
        on_base(t + 0.5 * h, x2, v3, a[2]);
        shift(x, v3, h, x2);
        shift(v, a[2], h, v4);
        on_base(t + h, x2, v4, a[3]);
        for (int i = 0; i < STOREYS; i++) {
            x[i] += h / 6.0 * (v[i] + 2.0 * (v2[i] + v3[i]) + v4[i]);
            v[i] += h / 6.0 * (a[0][i] + 2.0 * (a[1][i] + a[2][i]) + a[3][i]);
        }
        at->steps++;
    }
}

/* The stiff chain -------------------------------------------------------------------------------------------------- */

struct FloorStiffChain {
    Line line;
    double h, x[MASSES], v[MASSES], a[MASSES];
    double lower[MASSES], inverse[MASSES]; /* of M + h/2 C + h^2/4 K = L D L': below its diagonal, and 1 / D */
};

FloorStiffChain *floor_stiff_chain_new(double h)
{
    FloorStiffChain *chain = calloc(1, sizeof *chain);
    Line *line = &chain->line;
    chain->h = h;
    for (int i = 0; i < MASSES; i++) {
        line->stiffness[i] = i % 2 == 0 ? 1e2 : 1e8;
        line->damping[i] = 0.02 * sqrt(line->stiffness[i]);
    }
    for (int i = 0; i < MASSES; i++) {
        int last = i + 1 == MASSES;
        double damping = line->damping[i] + (last ? 0 : line->damping[i + 1]);
        double stiffness = line->stiffness[i] + (last ? 0 : line->stiffness[i + 1]);
        double diagonal = 1 + 0.5 * h * damping + 0.25 * h * h * stiffness;
        double beside = i == 0 ? 0 : -(0.5 * h * line->damping[i] + 0.25 * h * h * line->stiffness[i]);
        chain->lower[i] = i == 0 ? 0 : beside * chain->inverse[i - 1];
        chain->inverse[i] = 1 / (diagonal - chain->lower[i] * beside);
    }
    floor_stiff_chain_reset(chain);
    return chain;
}

void floor_stiff_chain_free(FloorStiffChain *chain)
{
    free(chain);
}

void floor_stiff_chain_reset(FloorStiffChain *chain)
{
    memset(chain->v, 0, sizeof chain->v);
    for (int i = 0; i < MASSES; i++)
        chain->x[i] = (i / 2 + 1) / 25.0;
    accelerations(&chain->line, MASSES, chain->x, chain->v, 0, 0, chain->a);
}

void floor_stiff_chain_steps(FloorStiffChain *chain, long steps)
{
    double h = chain->h, *x = chain->x, *v = chain->v, *a = chain->a;
    for (long n = 0; n < steps; n++) {
        for (int i = 0; i < MASSES; i++) {
            x[i] += h * v[i] + 0.25 * h * h * a[i];
            v[i] += 0.5 * h * a[i];
        }
        accelerations(&chain->line, MASSES, x, v, 0, 0, a);
        for (int i = 1; i < MASSES; i++)
            a[i] -= chain->lower[i] * a[i - 1];
        a[MASSES - 1] *= chain->inverse[MASSES - 1];
        for (int i = MASSES - 2; i >= 0; i--)
            a[i] = a[i] * chain->inverse[i] - chain->lower[i + 1] * a[i + 1];
        for (int i = 0; i < MASSES; i++) {
            x[i] += 0.25 * h * h * a[i];
            v[i] += 0.5 * h * a[i];
        }
    }
}

double floor_stiff_chain_place(const FloorStiffChain *chain, int mass)
{
    return chain->x[mass];
}
