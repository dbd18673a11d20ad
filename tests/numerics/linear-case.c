#include "linear-case.h"

#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"

#define TERMS 26

__extension__ typedef __float128 Quad;

static TinkerStatus give_signals(void *context, TinkerSignal *signals)
{
    const LinearCase *c = context;
    memcpy(signals, c->signals, (gsize)c->linear.signal_count * sizeof *signals);
    return TINKER_OK;
}

void case_init(LinearCase *c, int32_t size)
{
    memset(c, 0, sizeof *c);
    for (int32_t i = 0; i < size; i++)
        c->mass[i] = 1.0;
    c->linear = (TinkerLinearSystem){.struct_size = sizeof c->linear,
                                     .size = size,
                                     .anchor_count = 1,
                                     .mass = c->mass,
                                     .drag = c->drag,
                                     .edges = c->edges,
                                     .anchors = c->anchors,
                                     .loads = c->loads,
                                     .forces = c->forces,
                                     .motions = c->motions,
                                     .damper_book = -1,
                                     .drag_book = -1,
                                     .support_book = -1};
    c->system = (TinkerSystem){.struct_size = sizeof c->system,
                               .size = size,
                               .context = c,
                               .mass = c->mass,
                               .linear = &c->linear,
                               .signals = give_signals};
}

void case_keep_books(LinearCase *c)
{
    c->system.books = CASE_BOOKS;
    c->linear.damper_book = 0;
    c->linear.drag_book = 1;
    c->linear.support_book = 2;
}

TinkerLinearEdge *case_edge(LinearCase *c, int32_t a, int32_t b, double stiffness, double damping)
{
    g_assert_cmpint(c->linear.edge_count, <, CASE_MOST);
    TinkerLinearEdge *edge = &c->edges[c->linear.edge_count++];
    *edge = (TinkerLinearEdge){.a = a, .b = b, .stiffness = stiffness, .damping = damping};
    return edge;
}

int32_t case_anchor(LinearCase *c, double place)
{
    c->anchors[c->linear.anchor_count++] = place;
    return -c->linear.anchor_count;
}

int32_t case_polynomial(LinearCase *c, double c0, double c1, double c2, double c3)
{
    c->signals[c->linear.signal_count] =
        (TinkerSignal){.kind = TINKER_SIGNAL_POLYNOMIAL, .coefficient = {c0, c1, c2, c3}};
    return c->linear.signal_count++;
}

int32_t case_harmonic(LinearCase *c, double amplitude, double rate, double phase)
{
    c->signals[c->linear.signal_count] =
        (TinkerSignal){.kind = TINKER_SIGNAL_HARMONIC, .coefficient = {amplitude, rate, phase, 0.0}};
    return c->linear.signal_count++;
}

void case_force(LinearCase *c, int32_t target, int32_t signal, int32_t book, double factor)
{
    c->forces[c->linear.force_count++] = (TinkerSignalUse){target, signal, book, 0, factor};
}

void case_motion(LinearCase *c, int32_t end, int32_t signal, double factor)
{
    c->motions[c->linear.motion_count++] = (TinkerSignalUse){-1 - end, signal, -1, 0, factor};
}

void case_load(LinearCase *c, int32_t target, int32_t book, double force)
{
    c->loads[c->linear.load_count++] = (TinkerConstantLoad){target, book, force};
}

int case_run(LinearCase *c, double to, int steps)
{
    const TinkerIntegrator *exact = tinker_integrator_builtin("exact");
    TinkerIntegratorOptions options = {.struct_size = sizeof options};
    TinkerStepReport report = {.struct_size = sizeof report};
    void *stepper = exact->create(&c->system, &options);
    g_assert_nonnull(stepper);
    TinkerState state = {c->t, c->q, c->v, c->books};
    double from = c->t;
    int taken = 0;
    for (int i = 1; i <= steps; i++) {
        double limit = i == steps ? to : from + (to - from) * i / steps;
        while (state.t < limit) {
            g_assert_cmpint(exact->step(stepper, &state, limit, &report), ==, TINKER_OK);
            g_assert_cmpint(++taken, <, 10000000);
        }
    }
    exact->destroy(stepper);
    c->t = to;
    return taken;
}

/* --- series --- */

typedef Quad Series[TERMS];

typedef struct {
    LinearCase *c;
    Quad x[CASE_MOST], v[CASE_MOST], wave[CASE_MOST][2], books[CASE_BOOKS];
    double sign[CASE_MOST];
    Series place[CASE_MOST], speed[CASE_MOST], signal[CASE_MOST], quarter[CASE_MOST], force[CASE_MOST];
} Work;

static void signal_series(Work *w, Quad t)
{
    for (int32_t s = 0; s < w->c->linear.signal_count; s++) {
        const TinkerSignal *signal = &w->c->signals[s];
        const double *c = signal->coefficient;
        memset(w->signal[s], 0, sizeof w->signal[s]);
        if (signal->kind == TINKER_SIGNAL_POLYNOMIAL) {
            Quad u = t - (Quad)signal->origin;
            w->signal[s][0] = c[0] + u * (c[1] + u * (c[2] + u * c[3]));
            w->signal[s][1] = c[1] + u * (2 * (Quad)c[2] + u * 3 * (Quad)c[3]);
            w->signal[s][2] = c[2] + 3 * (Quad)c[3] * u;
            w->signal[s][3] = c[3];
            continue;
        }
        w->signal[s][0] = w->wave[s][0];
        w->quarter[s][0] = w->wave[s][1];
        for (int k = 0; k + 1 < TERMS; k++) {
            w->signal[s][k + 1] = (Quad)c[1] * w->quarter[s][k] / (k + 1);
            w->quarter[s][k + 1] = -(Quad)c[1] * w->signal[s][k] / (k + 1);
        }
    }
}

/* Term k of where an end is, and of how fast it goes. */
static void end_term(const Work *w, int32_t end, int k, Quad *place, Quad *speed)
{
    if (end >= 0) {
        *place = w->place[end][k];
        *speed = w->speed[end][k];
        return;
    }
    *place = k == 0 ? w->c->anchors[-1 - end] : 0.0;
    *speed = 0.0;
    for (int32_t m = 0; m < w->c->linear.motion_count; m++) {
        const TinkerSignalUse *use = &w->c->motions[m];
        if (use->target != -1 - end) continue;
        *place += use->factor * w->signal[use->signal][k];
        if (k + 1 < TERMS) *speed += use->factor * (k + 1) * w->signal[use->signal][k + 1];
    }
}

static Quad pull_term(const Work *w, int32_t e, int k, Quad *rate)
{
    const TinkerLinearEdge *edge = &w->c->edges[e];
    Quad a, b, ua, ub;
    end_term(w, edge->a, k, &a, &ua);
    end_term(w, edge->b, k, &b, &ub);
    Quad d = b - a;
    if (k == 0) d -= w->sign[e] * (Quad)edge->length;
    *rate = ub - ua;
    return (k == 0 ? (Quad)(w->sign[e] * edge->tension) : 0) + edge->stiffness * d + edge->damping * *rate;
}

static void motion_series(Work *w)
{
    LinearCase *c = w->c;
    for (int32_t i = 0; i < c->linear.size; i++) {
        w->place[i][0] = w->x[i];
        w->speed[i][0] = w->v[i];
    }
    for (int k = 0; k + 1 < TERMS; k++) {
        for (int32_t i = 0; i < c->linear.size; i++)
            w->force[i][k] = -(Quad)c->drag[i] * w->speed[i][k];
        for (int32_t e = 0; e < c->linear.edge_count; e++) {
            Quad rate, pull = pull_term(w, e, k, &rate);
            if (c->edges[e].a >= 0) w->force[c->edges[e].a][k] += pull;
            if (c->edges[e].b >= 0) w->force[c->edges[e].b][k] -= pull;
        }
        for (int32_t l = 0; k == 0 && l < c->linear.load_count; l++)
            w->force[c->loads[l].target][0] += c->loads[l].force;
        for (int32_t f = 0; f < c->linear.force_count; f++)
            w->force[c->forces[f].target][k] += c->forces[f].factor * w->signal[c->forces[f].signal][k];
        for (int32_t i = 0; i < c->linear.size; i++) {
            w->place[i][k + 1] = w->speed[i][k] / (k + 1);
            w->speed[i][k + 1] = w->force[i][k] / c->mass[i] / (k + 1);
        }
    }
}

static Quad value_at(const Quad *series, Quad h)
{
    Quad sum = 0;
    for (int k = TERMS - 1; k >= 0; k--)
        sum = series[k] + h * sum;
    return sum;
}

/* The integral of a product over h. */
static Quad work_of(const Quad *a, const Quad *b, Quad h)
{
    Series product = {0};
    for (int i = 0; i < TERMS; i++)
        for (int j = 0; i + j + 1 < TERMS; j++)
            product[i + j + 1] += a[i] * b[j] / (i + j + 1);
    return value_at(product, h);
}

static void add_work(Work *w, int32_t book, Quad work)
{
    if (book >= 0) w->books[book] += work;
}

static void book_series(Work *w, Quad h)
{
    LinearCase *c = w->c;
    for (int32_t e = 0; e < c->linear.edge_count; e++) {
        const TinkerLinearEdge *edge = &c->edges[e];
        Series pull, rate, anchors;
        for (int k = 0; k < TERMS; k++) {
            Quad place, ua = 0, ub = 0;
            pull[k] = pull_term(w, e, k, &rate[k]);
            if (edge->a < 0) end_term(w, edge->a, k, &place, &ua);
            if (edge->b < 0) end_term(w, edge->b, k, &place, &ub);
            anchors[k] = ub - ua;
        }
        add_work(w, c->linear.damper_book, -(Quad)edge->damping * work_of(rate, rate, h));
        add_work(w, c->linear.support_book, work_of(pull, anchors, h));
    }
    for (int32_t i = 0; i < c->linear.size; i++)
        add_work(w, c->linear.drag_book, -(Quad)c->drag[i] * work_of(w->speed[i], w->speed[i], h));
    for (int32_t f = 0; f < c->linear.force_count; f++) {
        const TinkerSignalUse *use = &c->forces[f];
        add_work(w, use->book, use->factor * work_of(w->signal[use->signal], w->speed[use->target], h));
    }
    for (int32_t l = 0; l < c->linear.load_count; l++) {
        const Quad *place = w->place[c->loads[l].target];
        add_work(w, c->loads[l].book, c->loads[l].force * (value_at(place, h) - place[0]));
    }
}

void case_run_by_series(LinearCase *c, double to, int steps)
{
    Work *w = g_new0(Work, 1);
    w->c = c;
    for (int32_t i = 0; i < c->linear.size; i++) {
        w->x[i] = c->q[i];
        w->v[i] = c->v[i];
    }
    for (int32_t s = 0; s < c->linear.signal_count; s++) {
        const double *k = c->signals[s].coefficient;
        long double phase = (long double)k[1] * ((long double)c->t - c->signals[s].origin) + k[2];
        w->wave[s][0] = k[0] * (Quad)sinl(phase);
        w->wave[s][1] = k[0] * (Quad)cosl(phase);
    }
    signal_series(w, c->t);
    for (int32_t i = 0; i < c->linear.size; i++)
        w->place[i][0] = w->x[i];
    for (int32_t e = 0; e < c->linear.edge_count; e++) {
        Quad a, b, speed;
        end_term(w, c->edges[e].a, 0, &a, &speed);
        end_term(w, c->edges[e].b, 0, &b, &speed);
        w->sign[e] = b - a < 0 ? -1.0 : 1.0;
    }
    Quad h = ((Quad)to - (Quad)c->t) / steps;
    for (int k = 0; k < steps; k++) {
        signal_series(w, (Quad)c->t + k * h);
        motion_series(w);
        if (c->system.books > 0) book_series(w, h);
        for (int32_t i = 0; i < c->linear.size; i++) {
            w->x[i] = value_at(w->place[i], h);
            w->v[i] = value_at(w->speed[i], h);
        }
        for (int32_t s = 0; s < c->linear.signal_count; s++) {
            w->wave[s][0] = value_at(w->signal[s], h);
            w->wave[s][1] = value_at(w->quarter[s], h);
        }
    }
    for (int32_t i = 0; i < c->linear.size; i++) {
        c->q[i] = (double)w->x[i];
        c->v[i] = (double)w->v[i];
    }
    for (int b = 0; b < CASE_BOOKS; b++)
        c->books[b] += (double)w->books[b];
    c->t = to;
    g_free(w);
}

static double end_place(const LinearCase *c, int32_t end)
{
    if (end >= 0) return c->q[end];
    double place = c->anchors[-1 - end];
    for (int32_t m = 0; m < c->linear.motion_count; m++) {
        if (c->motions[m].target != -1 - end) continue;
        const TinkerSignal *signal = &c->signals[c->motions[m].signal];
        const double *k = signal->coefficient;
        double u = c->t - signal->origin;
        double value = signal->kind == TINKER_SIGNAL_HARMONIC ? k[0] * sin(k[1] * u + k[2])
                                                              : k[0] + u * (k[1] + u * (k[2] + u * k[3]));
        place += c->motions[m].factor * value;
    }
    return place;
}

double case_energy(const LinearCase *c)
{
    double energy = 0.0;
    for (int32_t i = 0; i < c->linear.size; i++)
        energy += 0.5 * c->mass[i] * c->v[i] * c->v[i];
    for (int32_t e = 0; e < c->linear.edge_count; e++) {
        double d = fabs(end_place(c, c->edges[e].b) - end_place(c, c->edges[e].a));
        energy +=
            0.5 * c->edges[e].stiffness * (d - c->edges[e].length) * (d - c->edges[e].length) + c->edges[e].tension * d;
    }
    for (int32_t l = 0; l < c->linear.load_count; l++)
        if (c->loads[l].book < 0) energy -= c->loads[l].force * c->q[c->loads[l].target];
    return energy;
}

void assert_near(double value, double truth, double tolerance)
{
    if (!(fabs(value - truth) <= tolerance))
        g_error("%.17g instead of %.17g: off by %.3g, allowed %.3g", value, truth, fabs(value - truth), tolerance);
}
