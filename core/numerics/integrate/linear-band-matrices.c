/* The matrices of a linear system whose band is narrow, put together once. */
#include "numerics/integrate/linear-band-private.h"
#include "numerics/solve/narrow-band.h"

#define WIDEST_BAND 12

static void add_to_band(TinkerLinearBand *self, double *matrix, int32_t row, int32_t column, double value)
{
    int32_t low = MIN(row, column), apart = MAX(row, column) - low;
    matrix[(gsize)apart * self->stride + (gsize)low] += value;
}

static int32_t place_of(const TinkerLinearBand *self, int32_t end)
{
    return end >= 0 ? self->place[end] : end;
}

static void add_edge(TinkerLinearBand *self, const TinkerLinearEdge *edge)
{
    int32_t a = place_of(self, edge->a), b = place_of(self, edge->b);
    double *matrices[] = {self->stiffness, self->damping}, values[] = {edge->stiffness, edge->damping};
    for (int m = 0; m < 2; m++) {
        if (a >= 0) add_to_band(self, matrices[m], a, a, values[m]);
        if (b >= 0) add_to_band(self, matrices[m], b, b, values[m]);
        if (a >= 0 && b >= 0) add_to_band(self, matrices[m], a, b, -values[m]);
    }
    self->damped |= edge->damping != 0;
    double push = edge->tension - edge->stiffness * edge->length;
    if (push != 0) self->turning[self->turning_count++] = (TinkerTurningEdge){a, b, push, 0};
}

static void assemble(TinkerLinearBand *self)
{
    const TinkerLinearSystem *linear = self->linear;
    for (int32_t i = 0; i < self->n; i++) {
        int32_t p = self->place[i];
        self->mass[p] = linear->mass[i];
        if (linear->drag == NULL) continue;
        add_to_band(self, self->damping, p, p, linear->drag[i]);
        self->damped |= linear->drag[i] != 0;
    }
    for (int32_t e = 0; e < linear->edge_count; e++)
        if (linear->edges[e].a != linear->edges[e].b) add_edge(self, &linear->edges[e]);
}

/* FALSE where an edge joins places that the pattern does not bring together. */
static gboolean edges_fit(const TinkerLinearBand *self)
{
    for (int32_t e = 0; e < self->linear->edge_count; e++) {
        const TinkerLinearEdge *edge = &self->linear->edges[e];
        if (edge->a >= 0 && edge->b >= 0 && ABS(self->place[edge->a] - self->place[edge->b]) > self->width)
            return FALSE;
    }
    return TRUE;
}

static void allot(TinkerLinearBand *self)
{
    gsize n = (gsize)self->n, w = (gsize)self->width, stride = n + 2 * w, diagonals = (w + 1) * stride;
    self->stride = stride;
    self->memory = g_new0(double, 2 * diagonals + 2 * stride + 5 * n + 1);
    double *next = self->memory;
    self->stiffness = next + w;
    self->damping = next + diagonals + w;
    self->q = next + 2 * diagonals + w;
    self->v = self->q + stride;
    next += 2 * diagonals + 2 * stride;
    double **of_size[] = {&self->mass, &self->steady, &self->load, &self->x, &self->at};
    for (gsize i = 0; i < G_N_ELEMENTS(of_size); i++, next += n)
        *of_size[i] = next;
    self->turning = g_new0(TinkerTurningEdge, MAX(self->linear->edge_count, 1));
    self->signals = g_new0(TinkerSignal, MAX(self->linear->signal_count, 1));
    gsize anchors = (gsize)MAX(self->linear->anchor_count, 1);
    self->anchor = g_new0(double, anchors);
    self->anchor_rate = g_new0(double, anchors);
    self->anchor_move = g_new0(double, anchors);
}

TinkerLinearBand *tinker_linear_band_new(const TinkerSystem *system)
{
    if (system->linear == NULL || system->pattern == NULL || system->pattern->size != system->linear->size) return NULL;
    TinkerLinearBand *self = g_new0(TinkerLinearBand, 1);
    self->system = system;
    self->linear = system->linear;
    self->n = system->linear->size;
    self->place = g_new0(int32_t, MAX(self->n, 1));
    self->width = tinker_narrow_band(system->pattern, self->place);
    if (self->width > WIDEST_BAND || !edges_fit(self)) {
        tinker_linear_band_free(self);
        return NULL;
    }
    gboolean in_order = TRUE;
    for (int32_t i = 0; i < self->n; i++)
        in_order &= self->place[i] == i;
    if (!in_order) self->order = g_new0(int32_t, self->n);
    for (int32_t i = 0; i < self->n && !in_order; i++)
        self->order[self->place[i]] = i;
    allot(self);
    assemble(self);
    tinker_banded_ldl_init(&self->ldl, self->n, self->width);
    return self;
}

void tinker_linear_band_free(TinkerLinearBand *self)
{
    if (self == NULL) return;
    tinker_banded_ldl_clear(&self->ldl);
    gpointer arrays[] = {self->place,   self->order,  self->memory,      self->turning,
                         self->signals, self->anchor, self->anchor_rate, self->anchor_move};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}
