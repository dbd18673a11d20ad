/* Gauss-Kronrod 7/15 with bisection. Nodes and weights: Piessens et al., QUADPACK (1983), routine QK15. */
#include "numerics/roots/quadrature.h"

#include <math.h>

/* Halves of halves: so often. What is left then is a jump or a kink within 2^-40 of the interval. */
#define DEEPEST 40
/* Cuts in all: what asks for more is noise, of which halves are as rough as the whole. */
#define MOST_CUTS 1000

static const double nodes[8] = {0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                0.586087235467691130294144691693013, 0.405845151377397166906606412076961,
                                0.207784955007898467600689403773245, 0.0};
static const double kronrod[8] = {0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                  0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                  0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                  0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
static const double gauss[4] = {0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

typedef struct {
    TinkerIntegrandFunc function;
    TinkerKinkFunc kink;
    void *data;
    int32_t count;
    double tolerance, noise;
    int cuts; /* so far */
    double *sums, *kronrod, *gauss, *values;
} Integral;

/* What one node adds to both rules; every second one is Gauss's. */
static TinkerStatus add_node(const Integral *self, double t, int node)
{
    TinkerStatus status = self->function(t, self->values, self->data);
    for (int32_t i = 0; i < self->count; i++) {
        self->kronrod[i] += kronrod[node] * self->values[i];
        if (node % 2 == 1) self->gauss[i] += gauss[node / 2] * self->values[i];
    }
    return status;
}

/* Whether the rules agree about every function. */
static int agree(const Integral *self, double half)
{
    for (int32_t i = 0; i < self->count; i++) {
        const double value = half * self->kronrod[i], other = half * self->gauss[i];
        const double allowed = self->tolerance * (fabs(value) + fabs(self->sums[i]));
        if (fabs(value - other) > fmax(allowed, self->noise * half)) return 0;
    }
    return 1;
}

static TinkerStatus add_interval(Integral *self, double from, double to, int depth)
{
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    if (!(half > 0) || !(from < middle && middle < to)) return TINKER_OK;
    for (int32_t i = 0; i < self->count; i++)
        self->kronrod[i] = self->gauss[i] = 0;
    TinkerStatus status = add_node(self, middle, 7);
    for (int node = 0; node < 7 && status == TINKER_OK; node++) {
        status = add_node(self, middle - half * nodes[node], node);
        if (status == TINKER_OK) status = add_node(self, middle + half * nodes[node], node);
    }
    if (status != TINKER_OK) return status;
    const int ends = depth == DEEPEST || self->cuts == MOST_CUTS;
    const double cut = ends ? NAN : agree(self, half) ? self->kink(from, to, self->data) : middle;
    if (from < cut && cut < to) {
        self->cuts++;
        status = add_interval(self, from, cut, depth + 1);
        return status == TINKER_OK ? add_interval(self, cut, to, depth + 1) : status;
    }
    for (int32_t i = 0; i < self->count; i++)
        self->sums[i] += half * self->kronrod[i];
    return TINKER_OK;
}

TinkerStatus tinker_integrate(TinkerIntegrandFunc function, TinkerKinkFunc kink, void *data, int32_t count, double from,
                              double to, double tolerance, double noise, double *sums, double *room)
{
    Integral self = {function, kink, data, count, tolerance, noise, 0, sums, room, room + count, room + 2 * count};
    return add_interval(&self, from, to, 0);
}
