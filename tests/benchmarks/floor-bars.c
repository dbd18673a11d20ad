/* A chain of bars pinned end to end, by RATTLE. With n[k] = k x (arm of the near end of bar k) = (r_y, -r_x), r half
 * the bar, and the square of its radius of gyration G, the impulses p[k] of the pins solve the system of 2 x 2 blocks
 *
 *   S[k][k] = I + n[k] n[k]^T / G + (the same of bar k - 1),   S[k][k + 1] = -I + n[k] n[k]^T / G,
 *
 * and bar k gets p[k] - p[k + 1] and, about its centre, n[k] . (p[k] + p[k + 1]). */
#include "floors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GRAVITY     9.81
#define MOST_ROUNDS 20

typedef struct {
    double x, y, angle;
} Place;

typedef struct {
    double x, y;
} Vector;

typedef struct {
    double xx, xy, yy;
} Symmetric;

struct FloorBars {
    int n;
    double length, gyration_square;
    Place *start, *q, *v;
    Vector *arm;                 /* halves of the bars now */
    Vector *normal, *p;          /* n at the start of the step; impulses, one more, 0 */
    Symmetric *inverse, *beside; /* the factor */
};

FloorBars *floor_bars_new(int bars, const double *angles, double length)
{
    FloorBars *chain = calloc(1, sizeof *chain);
    const size_t n = (size_t)bars;
    chain->start = calloc(n, sizeof(Place));
    chain->q = calloc(n, sizeof(Place));
    chain->v = calloc(n, sizeof(Place));
    chain->arm = calloc(n, sizeof(Vector));
    chain->normal = calloc(n, sizeof(Vector));
    chain->p = calloc(n + 1, sizeof(Vector));
    chain->inverse = calloc(n, sizeof(Symmetric));
    chain->beside = calloc(n, sizeof(Symmetric));
    chain->n = bars;
    chain->length = length;
    chain->gyration_square = length * length / 12;
    double x = 0, y = 0;
    for (size_t k = 0; k < n; k++) {
        const double dx = length * sin(angles[k]), dy = -length * cos(angles[k]);
        chain->start[k] = (Place){x + 0.5 * dx, y + 0.5 * dy, atan2(dy, dx)};
        x += dx;
        y += dy;
    }
    floor_bars_reset(chain);
    return chain;
}

void floor_bars_free(FloorBars *chain)
{
    void *arrays[] = {chain->start,  chain->q, chain->v,       chain->arm,
                      chain->normal, chain->p, chain->inverse, chain->beside};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        free(arrays[i]);
    free(chain);
}

void floor_bars_reset(FloorBars *chain)
{
    memcpy(chain->q, chain->start, (size_t)chain->n * sizeof(Place));
    memset(chain->v, 0, (size_t)chain->n * sizeof(Place));
}

static void find_arms(FloorBars *chain)
{
    for (int k = 0; k < chain->n; k++)
        chain->arm[k] =
            (Vector){0.5 * chain->length * cos(chain->q[k].angle), 0.5 * chain->length * sin(chain->q[k].angle)};
}

/* Factors S of the arms at hand, and keeps their directions. */
static void factor(FloorBars *chain)
{
    const double by = 1 / chain->gyration_square;
    Symmetric before = {0, 0, 0}; /* I + n n^T / G of the bar before; none before the first */
    for (int k = 0; k < chain->n; k++) {
        const Vector n = chain->normal[k] = (Vector){chain->arm[k].y, -chain->arm[k].x};
        const Symmetric own = {1 + by * n.x * n.x, by * n.x * n.y, 1 + by * n.y * n.y};
        Symmetric s = {own.xx + before.xx, own.xy + before.xy, own.yy + before.yy};
        if (k > 0) { /* less E^T P^-1 E */
            const Symmetric e = chain->beside[k - 1], p = chain->inverse[k - 1];
            const double a = p.xx * e.xx + p.xy * e.xy, b = p.xx * e.xy + p.xy * e.yy;
            const double c = p.xy * e.xx + p.yy * e.xy, d = p.xy * e.xy + p.yy * e.yy;
            s.xx -= e.xx * a + e.xy * c;
            s.xy -= e.xx * b + e.xy * d;
            s.yy -= e.xy * b + e.yy * d;
        }
        const double scale = 1 / (s.xx * s.yy - s.xy * s.xy);
        chain->inverse[k] = (Symmetric){s.yy * scale, -s.xy * scale, s.xx * scale};
        chain->beside[k] = (Symmetric){own.xx - 2, own.xy, own.yy - 2};
        before = own;
    }
}

static Vector times(Symmetric s, Vector v)
{
    return (Vector){s.xx * v.x + s.xy * v.y, s.xy * v.x + s.yy * v.y};
}

/* Solves for what is in p, and gives the impulses to a state, `rate` times as much to another. */
static void push(FloorBars *chain, Place *to, double rate, Place *also)
{
    Vector *p = chain->p;
    for (int k = 1; k < chain->n; k++) {
        const Vector off = times(chain->beside[k - 1], times(chain->inverse[k - 1], p[k - 1]));
        p[k] = (Vector){p[k].x - off.x, p[k].y - off.y};
    }
    p[chain->n] = (Vector){0, 0};
    for (int k = chain->n - 1; k >= 0; k--) {
        const Vector off = k + 1 < chain->n ? times(chain->beside[k], p[k + 1]) : (Vector){0, 0}, n = chain->normal[k];
        p[k] = times(chain->inverse[k], (Vector){p[k].x - off.x, p[k].y - off.y});
        const double turn = (n.x * (p[k].x + p[k + 1].x) + n.y * (p[k].y + p[k + 1].y)) / chain->gyration_square;
        const double x = p[k].x - p[k + 1].x, y = p[k].y - p[k + 1].y;
        to[k] = (Place){to[k].x + x, to[k].y + y, to[k].angle + turn};
        if (also != NULL) also[k] = (Place){also[k].x + rate * x, also[k].y + rate * y, also[k].angle + rate * turn};
    }
}

/* Leaves minus the gaps of the pins in p; answers the largest. */
static double find_gaps(FloorBars *chain)
{
    double x = 0, y = 0, most = 0;
    for (int k = 0; k < chain->n; k++) {
        const Place *at = &chain->q[k];
        const Vector arm = chain->arm[k], gap = {at->x - arm.x - x, at->y - arm.y - y};
        chain->p[k] = (Vector){-gap.x, -gap.y};
        most = fmax(most, fmax(fabs(gap.x), fabs(gap.y)));
        x = at->x + arm.x;
        y = at->y + arm.y;
    }
    return most;
}

static void project_velocities(FloorBars *chain)
{
    double x = 0, y = 0;
    for (int k = 0; k < chain->n; k++) {
        const Place *v = &chain->v[k];
        const Vector arm = chain->arm[k];
        const double turned_x = -v->angle * arm.y, turned_y = v->angle * arm.x;
        chain->p[k] = (Vector){x - (v->x - turned_x), y - (v->y - turned_y)};
        x = v->x + turned_x;
        y = v->y + turned_y;
    }
    push(chain, chain->v, 0, NULL);
}

void floor_bars_steps(FloorBars *chain, double h, long steps)
{
    const double rounding = 1e-15 * chain->length * chain->n;
    find_arms(chain);
    factor(chain);
    for (long i = 0; i < steps; i++) {
        for (int k = 0; k < chain->n; k++) {
            Place *q = &chain->q[k], *v = &chain->v[k];
            v->y -= 0.5 * h * GRAVITY;
            *q = (Place){q->x + h * v->x, q->y + h * v->y, q->angle + h * v->angle};
        }
        for (int round = 0; round < MOST_ROUNDS; round++) {
            find_arms(chain);
            if (find_gaps(chain) <= rounding) break;
            push(chain, chain->q, 1 / h, chain->v);
        }
        factor(chain);
        for (int k = 0; k < chain->n; k++)
            chain->v[k].y -= 0.5 * h * GRAVITY;
        project_velocities(chain);
    }
}

double floor_bars_error(FloorBars *chain)
{
    find_arms(chain);
    return find_gaps(chain) / chain->length;
}
