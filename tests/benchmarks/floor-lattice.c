/* A lattice as a plain list of springs between masses that are packed as (x, y, vx, vy): four springs are worked out at
 * a time, in vectors of four, and their forces added one after the other. */
#include "floors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STIFFNESS 1000.0
#define DAMPING   0.5

/* x, y, vx, vy of a mass, or one of them of four springs; a mass's force. */
typedef double Row __attribute__((vector_size(32)));
typedef double Pair __attribute__((vector_size(16)));

struct FloorLattice {
    int masses, springs;
    int *a, *b;
    double *stiffness, *damping, *length;
    Row *now, *stage;
    Pair *acceleration[4];
};

int floor_lattice_springs(const FloorLattice *lattice)
{
    return lattice->springs;
}

static void add_spring(FloorLattice *lattice, int a, int b, double length)
{
    int i = lattice->springs++;
    lattice->a[i] = a;
    lattice->b[i] = b;
    lattice->length[i] = length;
    lattice->stiffness[i] = STIFFNESS;
    lattice->damping[i] = DAMPING;
}

static void add_springs(FloorLattice *lattice, int n)
{
    for (int i = 0; i < n * n; i++) {
        int column = i % n, left = column > 0;
        int right = column < n - 1, above = i / n < n - 1;
        if (right) add_spring(lattice, i, i + 1, 1.0);
        if (above) add_spring(lattice, i, i + n, 1.0);
        if (right && above) add_spring(lattice, i, i + n + 1, sqrt(2.0));
        if (left && above) add_spring(lattice, i, i + n - 1, sqrt(2.0));
    }
}

FloorLattice *floor_lattice_new(int n, const double *places)
{
    size_t masses = (size_t)n * (size_t)n, springs = 4 * masses;
    FloorLattice *lattice = calloc(1, sizeof *lattice);
    lattice->masses = n * n;
    lattice->a = calloc(springs, sizeof(int));
    lattice->b = calloc(springs, sizeof(int));
    lattice->stiffness = calloc(springs, sizeof(double));
    lattice->damping = calloc(springs, sizeof(double));
    lattice->length = calloc(springs, sizeof(double));
    lattice->now = aligned_alloc(sizeof(Row), masses * sizeof(Row));
    lattice->stage = aligned_alloc(sizeof(Row), masses * sizeof(Row));
    for (int k = 0; k < 4; k++)
        lattice->acceleration[k] = aligned_alloc(sizeof(Pair), masses * sizeof(Pair));
    add_springs(lattice, n);
    for (size_t i = 0; i < masses; i++)
        lattice->now[i] = (Row){places[2 * i], places[2 * i + 1], 0, 0};
    return lattice;
}

void floor_lattice_free(FloorLattice *lattice)
{
    free(lattice->a);
    free(lattice->b);
    free(lattice->stiffness);
    free(lattice->damping);
    free(lattice->length);
    free(lattice->now);
    free(lattice->stage);
    for (int k = 0; k < 4; k++)
        free(lattice->acceleration[k]);
    free(lattice);
}

void floor_lattice_place(const FloorLattice *lattice, int mass, double place[2])
{
    place[0] = lattice->now[mass][0];
    place[1] = lattice->now[mass][1];
}

/* One spring, for those that are left over. */
static void add_force(const FloorLattice *lattice, int i, const Row *restrict at, Pair *restrict force)
{
    Row d = at[lattice->b[i]] - at[lattice->a[i]];
    double inverse = 1.0 / sqrt(d[0] * d[0] + d[1] * d[1]);
    double damping = lattice->damping[i] * (d[0] * d[2] + d[1] * d[3]) * inverse * inverse;
    double scale = lattice->stiffness[i] * (1.0 - lattice->length[i] * inverse) + damping;
    Pair f = {scale * d[0], scale * d[1]};
    force[lattice->a[i]] += f;
    force[lattice->b[i]] -= f;
}

/* Four springs: the differences of their ends as rows, turned into columns, and the forces turned back. */
static inline void add_four(const FloorLattice *lattice, int first, const Row *restrict at, Pair *restrict force)
{
    const int *a = lattice->a + first, *b = lattice->b + first;
    Row d0 = at[b[0]] - at[a[0]], d1 = at[b[1]] - at[a[1]], d2 = at[b[2]] - at[a[2]], d3 = at[b[3]] - at[a[3]];
    Row xv01 = __builtin_shufflevector(d0, d1, 0, 4, 2, 6), xv23 = __builtin_shufflevector(d2, d3, 0, 4, 2, 6);
    Row yw01 = __builtin_shufflevector(d0, d1, 1, 5, 3, 7), yw23 = __builtin_shufflevector(d2, d3, 1, 5, 3, 7);
    Row x = __builtin_shufflevector(xv01, xv23, 0, 1, 4, 5), vx = __builtin_shufflevector(xv01, xv23, 2, 3, 6, 7);
    Row y = __builtin_shufflevector(yw01, yw23, 0, 1, 4, 5), vy = __builtin_shufflevector(yw01, yw23, 2, 3, 6, 7);
    Row square = x * x + y * y, root;
    for (int k = 0; k < 4; k++)
        root[k] = sqrt(square[k]);
    Row inverse = 1.0 / root, stiffness, damping, length;
    memcpy(&stiffness, lattice->stiffness + first, sizeof(Row));
    memcpy(&damping, lattice->damping + first, sizeof(Row));
    memcpy(&length, lattice->length + first, sizeof(Row));
    Row scale = stiffness * (1.0 - length * inverse) + damping * (x * vx + y * vy) * inverse * inverse;
    Row fx = scale * x, fy = scale * y;
    for (int k = 0; k < 4; k++) {
        Pair f = {fx[k], fy[k]};
        force[a[k]] += f;
        force[b[k]] -= f;
    }
}

/* All masses are 1 kg, so a force is an acceleration. */
static void accelerations(const FloorLattice *lattice, const Row *at, Pair *a)
{
    int i = 0;
    memset(a, 0, (size_t)lattice->masses * sizeof(Pair));
    for (; i + 4 <= lattice->springs; i += 4)
        add_four(lattice, i, at, a);
    for (; i < lattice->springs; i++)
        add_force(lattice, i, at, a);
}

static void stage(FloorLattice *lattice, double hv, double haa, double ha, const Pair *restrict b,
                  const Pair *restrict a)
{
    const Row *restrict from = lattice->now;
    Row *restrict to = lattice->stage;
    for (int i = 0; i < lattice->masses; i++) {
        Row p = from[i];
        to[i] = (Row){p[0] + hv * p[2] + haa * b[i][0], p[1] + hv * p[3] + haa * b[i][1], p[2] + ha * a[i][0],
                      p[3] + ha * a[i][1]};
    }
}

static void advance(FloorLattice *lattice, double h)
{
    Pair *const *a = lattice->acceleration;
    Row *restrict now = lattice->now;
    for (int i = 0; i < lattice->masses; i++) {
        Pair middle = a[1][i] + a[2][i], along = h * h / 6.0 * (a[0][i] + middle);
        Pair gain = h / 6.0 * (a[0][i] + 2.0 * middle + a[3][i]);
        Row p = now[i];
        now[i] = p + (Row){h * p[2] + along[0], h * p[3] + along[1], gain[0], gain[1]};
    }
}

void floor_lattice_steps(FloorLattice *lattice, double h, long steps)
{
    Pair *const *a = lattice->acceleration;
    for (long i = 0; i < steps; i++) {
        accelerations(lattice, lattice->now, a[0]);
        stage(lattice, 0.5 * h, 0.0, 0.5 * h, a[0], a[0]);
        accelerations(lattice, lattice->stage, a[1]);
        stage(lattice, 0.5 * h, 0.25 * h * h, 0.5 * h, a[0], a[1]);
        accelerations(lattice, lattice->stage, a[2]);
        stage(lattice, h, 0.5 * h * h, h, a[1], a[2]);
        accelerations(lattice, lattice->stage, a[3]);
        advance(lattice, h);
    }
}
