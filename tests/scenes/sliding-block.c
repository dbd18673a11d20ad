/* In a piece from one event to the next, tau after its start:
 *   ground: a = a0 + j tau, v and x its integrals; block: v = w + s grip tau with s = -1, 0 (held) or 1.
 * It is let go where |a| passes the grip, and held again where both velocities meet and |a| is within the grip. */
#include "sliding-block.h"

#include <math.h>

typedef struct {
    double ground_x, ground_v, block_x, block_v;
    double slip; /* 1, -1: friction pushes it that way; 0: held */
} Motion;

/* The first root of c0 + c1 u + c2 u^2 in (0, h]; h where there is none. c0 = 0 is the root that was just left. */
static double first_root(double c0, double c1, double c2, double h)
{
    double roots[2] = {-1.0, -1.0};
    const double inside = c1 * c1 - 4.0 * c0 * c2;
    if (c0 == 0.0) {
        if (c2 != 0.0) roots[0] = -c1 / c2;
    } else if (c2 == 0.0) {
        if (c1 != 0.0) roots[0] = -c0 / c1;
    } else if (inside >= 0.0) {
        const double q = -0.5 * (c1 + copysign(sqrt(inside), c1));
        roots[0] = q / c2;
        if (q != 0.0) roots[1] = c0 / q;
    }
    double first = h;
    for (int k = 0; k < 2; k++)
        if (roots[k] > 0.0 && roots[k] < first) first = roots[k];
    return first;
}

/* When the piece that begins with acceleration a and slope j ends, at most h later. */
static double length_of_piece(const Motion *motion, double a, double j, double grip, double h)
{
    if (motion->slip == 0.0) return fmin(first_root(a - grip, j, 0.0, h), first_root(a + grip, j, 0.0, h));
    return first_root(motion->block_v - motion->ground_v, motion->slip * grip - a, -0.5 * j, h);
}

static void move(Motion *motion, double a, double j, double grip, double u)
{
    const double push = motion->slip * grip;
    const double dx = u * (motion->ground_v + u * (0.5 * a + u * j / 6.0)), dv = u * (a + 0.5 * u * j);
    const double dw = motion->slip == 0.0 ? dv : push * u;
    motion->block_x += motion->slip == 0.0 ? dx : u * (motion->block_v + 0.5 * push * u);
    motion->ground_x += dx;
    motion->ground_v += dv;
    motion->block_v = motion->slip == 0.0 ? motion->ground_v : motion->block_v + dw;
}

/* What the block does from here, where its velocity is the ground's, whose acceleration is a with slope j. */
static void meet(Motion *motion, double a, double j, double grip)
{
    motion->block_v = motion->ground_v;
    const gboolean within = fabs(a) < grip - 1e-12 || (fabs(a) <= grip + 1e-12 && a * j <= 0.0);
    motion->slip = within ? 0.0 : copysign(1.0, a);
}

/* From one row to `h` later. */
static void pass(Motion *motion, double a, double j, double grip, double h)
{
    double done = 0.0;
    while (done < h) {
        const double u = length_of_piece(motion, a + j * done, j, grip, h - done);
        const gboolean event = u < h - done;
        move(motion, a + j * done, j, grip, u);
        done = event ? done + u : h;
        if (event) meet(motion, a + j * done, j, grip);
    }
}

void sliding_block_at(const double *times, const double *acceleration, gsize count, double grip, const double *at,
                      gsize at_count, double *block, double *ground)
{
    Motion motion = {0};
    gsize next = 0;
    for (gsize row = 0; row + 1 < count; row++) {
        const double h = times[row + 1] - times[row], j = (acceleration[row + 1] - acceleration[row]) / h;
        for (; next < at_count && at[next] <= times[row + 1]; next++) {
            Motion until = motion;
            pass(&until, acceleration[row], j, grip, at[next] - times[row]);
            block[next] = until.block_x;
            ground[next] = until.ground_x;
        }
        pass(&motion, acceleration[row], j, grip, h);
    }
    g_assert_cmpuint(next, ==, at_count);
}
