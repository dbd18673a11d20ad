/* One good library, and with PLANT_... defined the same with one fault. It has line laws (pull, rub), force elements
 * (pair, follow), a field (gather), a body (ball), constraints (keep, hold), a motion (sway) and an integrator
 * (simple). */
#include <locale.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <cairo.h>
#include <tinker/sdk.h>

#ifdef PLANT_prints_checked
int __printf_chk(int flag, const char *format, ...);
#endif

#ifdef PLANT_exports
TINKER_EXPORT int another_symbol(void);
int another_symbol(void)
{
    return 1;
}
#endif

#if defined(PLANT_counts) || defined(PLANT_counts_rows)
static double prepared;
static TinkerStatus prepare(TinkerBatch *batch)
{
    prepared++;
    return TINKER_OK;
}
#elif defined(PLANT_prepares_umask)
static TinkerStatus prepare(TinkerBatch *batch)
{
    umask(0);
    return TINKER_OK;
}
#endif

#ifdef PLANT_opens_locale
__attribute__((constructor)) static void change_locale(void)
{
    setlocale(LC_NUMERIC, "C.UTF-8");
}
#endif

/* pull: T = k (L - L0) + c rate */

enum { STIFFNESS, REST_LENGTH, DAMPING };

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    const double *k = tinker_column(batch, STIFFNESS), *rest = tinker_column(batch, REST_LENGTH);
    const double *c = tinker_column(batch, DAMPING);
    for (int32_t i = 0; i < batch->count; i++) {
#if defined(PLANT_nan)
        if (length[i] == 0) return result[i] = NAN, TINKER_OK;
#elif defined(PLANT_exit)
        if (length[i] == 0) exit(3);
#elif defined(PLANT_ends_well)
        if (length[i] == 0)
            exit(77); // by which a child might say that all is well, and test harnesses that a test is skipped
#elif defined(PLANT_abort)
        if (length[i] == 0) abort();
#elif defined(PLANT_crash)
        if (length[i] == 0) raise(SIGSEGV);
#elif defined(PLANT_hang)
        for (volatile int waiting = 1; waiting && length[i] == 0;)
            ;
#endif
        result[i] = k[i] * (length[i] - rest[i]) + c[i] * rate[i];
#if defined(PLANT_far_nan)
        if (length[i] > 20 && length[i] < 1e6) result[i] = NAN; // farther than the kit's ends, but in other units
#elif defined(PLANT_quotient)
        result[i] *= (k[i] + length[i]) / (k[i] + length[i]); // 0 / 0 where both vanish
#elif defined(PLANT_gives)
        result[i] -= 2 * c[i] * rate[i];
#elif defined(PLANT_constant)
        result[i] += 0.5;
#elif defined(PLANT_remembers)
        static int calls;
        if (i == 0) calls++;
        if (calls % 2) result[i] *= 1 + 4 * DBL_EPSILON;
#elif defined(PLANT_counts)
        result[i] *= 1 + 1e-13 * prepared;
#endif
    }
#if defined(PLANT_allots)
    void *volatile memory = malloc(16);
    free(memory);
#elif defined(PLANT_prints)
    puts("tension");
#elif defined(PLANT_prints_checked)
    __printf_chk(1, "tension\n"); // what printf is compiled to with -D_FORTIFY_SOURCE
#elif defined(PLANT_masks)
    umask(0);
#elif defined(PLANT_writes_beyond)
    ((volatile double *)result)[batch->count] = 0;
#elif defined(PLANT_writes_before)
    ((volatile double *)result)[-1] = 0;
#elif defined(PLANT_reads_beyond)
    (void)((const volatile double *)rate)[batch->count];
#elif defined(PLANT_writes_input)
    *(volatile double *)length = *length;
#endif
    return TINKER_OK;
}

static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    for (int32_t i = 0; i < batch->count; i++) {
        by_length[i] = tinker_column(batch, STIFFNESS)[i];
        by_rate[i] = tinker_column(batch, DAMPING)[i];
#if defined(PLANT_gives) || defined(PLANT_sign)
        by_rate[i] = -by_rate[i];
#endif
    }
    return TINKER_OK;
}

static TinkerStatus pull_energy(TinkerBatch *batch, const double *length, double *stored)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double x = length[i] - tinker_column(batch, REST_LENGTH)[i];
        stored[i] = 0.5 * tinker_column(batch, STIFFNESS)[i] * x * x;
#if defined(PLANT_slope)
        stored[i] *= 1.001;
#elif defined(PLANT_constant)
        stored[i] += 0.5 * length[i];
#endif
    }
    return TINKER_OK;
}

#if !defined(PLANT_gives) && !defined(PLANT_constant)
static TinkerStatus pull_linear(TinkerBatch *batch, double *stiffness, double *damping, double *length,
                                double *at_length)
{
    for (int32_t i = 0; i < batch->count; i++) {
        stiffness[i] = tinker_column(batch, STIFFNESS)[i];
        damping[i] = tinker_column(batch, DAMPING)[i];
        length[i] = tinker_column(batch, REST_LENGTH)[i];
        at_length[i] = 0;
#if defined(PLANT_form)
        stiffness[i] *= 1.001;
#elif defined(PLANT_counts)
        stiffness[i] *= 1 + 1e-13 * prepared;
#endif
    }
    return TINKER_OK;
}
#endif

#if defined(PLANT_break)
static double next_break(TinkerBatch *batch)
{
    return batch->time;
}
#endif

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    tinker_end_distances(batch->count, input->ends, result);
    for (int32_t i = 0; i < batch->count; i++) {
#if defined(PLANT_first)
        const int32_t own = 0;
#else
        const int32_t own = i;
#endif
        result[i] = tinker_column(batch, STIFFNESS)[own] * (result[i] - tinker_column(batch, REST_LENGTH)[i]);
    }
#if defined(PLANT_quantity_beyond)
    ((volatile double *)result)[batch->count] = 0;
#endif
    return TINKER_OK;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
#if defined(PLANT_ink)
    style->circle(style, cairo, TINKER_COLOUR_BODY, -1, a->x + 2, a->y + 5, 0.5);
#elif defined(PLANT_size_nan)
    style->box(style, cairo, TINKER_COLOUR_BODY, -1, a->x, a->y, NAN, 0.1, 0);
#elif defined(PLANT_saves)
    cairo_save(cairo);
#elif defined(PLANT_pushes)
    cairo_push_group(cairo);
#elif defined(PLANT_breaks_cairo)
    cairo_pop_group_to_source(cairo);
#endif
}

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
#if defined(PLANT_unhittable)
    return tinker_ends_hit(instance, x, y, reach);
#else
    return tinker_connector_hit(instance, x, y, reach);
#endif
}

/* pair: F = k d on the first end and minus that on the second; it tells of no store. */

static TinkerStatus pair_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y;
        double k = tinker_column(batch, STIFFNESS)[i];
        double *f = &force[4 * i];
#if defined(PLANT_place)
        const double rest = tinker_column(batch, REST_LENGTH)[i];
        const double x = a->x + batch->origin[0], y = a->y + batch->origin[1];
        k *= 1 + 0.01 * (x * x + y * y) / (rest * rest);
#elif defined(PLANT_direction)
        const double length = tinker_length(dx, dy);
        k *= 1 + 0.1 * (length == 0 ? 0 : fabs(dx) / length);
#endif
#if defined(PLANT_origin)
        k *= 1 + 0.01 * fabs(batch->origin[0]) / tinker_column(batch, REST_LENGTH)[i];
#endif
        f[0] = k * dx;
        f[1] = k * dy;
        f[2] = -f[0];
        f[3] = -f[1];
#if defined(PLANT_unbalanced)
        f[2] *= 1.001;
        f[3] *= 1.001;
#elif defined(PLANT_moment)
        f[0] -= k * dy;
        f[1] += k * dx;
        f[2] += k * dy;
        f[3] -= k * dx;
#endif
    }
    return TINKER_OK;
}

/* follow: a jet at the first end, held along the line from the second: forces do not sum to zero, and need not. */

static TinkerStatus follow_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = a->x - b->x, dy = a->y - b->y, length = tinker_length(dx, dy);
        const double thrust = length == 0 ? 0 : tinker_column(batch, 0)[i];
        force[4 * i] = length == 0 ? 0 : thrust * (dx / length);
        force[4 * i + 1] = length == 0 ? 0 : thrust * (dy / length);
        force[4 * i + 2] = force[4 * i + 3] = 0;
    }
    return TINKER_OK;
}

/* gather: each body is drawn to all others, k d. */

static TinkerStatus gather_force(TinkerBatch *batch, const TinkerBodies *bodies, double *force)
{
    double k = 0;
    for (int32_t i = 0; i < batch->count; i++)
        k += tinker_column(batch, STIFFNESS)[i];
    for (int32_t b = 0; b < bodies->range; b++) {
        const TinkerPoint *own = &bodies->points[bodies->first + b];
        double x = 0, y = 0;
        for (int32_t other = 0; other < bodies->count; other++) {
            x += bodies->points[other].x - own->x;
            y += bodies->points[other].y - own->y;
        }
        force[2 * b] = k * x;
        force[2 * b + 1] = k * y;
#if defined(PLANT_body_nan)
        if (own->x == 0) force[2 * b] = NAN;
#endif
    }
    return TINKER_OK;
}

/* rub: Hertz's contact, F (e / D)^1.5 with e = D - L where that is positive, and dry friction that is rounded off, R
 * tanh(rate / s): right, with a kink in the slope and a bend within centimetres. */

enum { HARDNESS, DIAMETER, FRICTION, ROUNDING };

static double depth_of(const TinkerBatch *batch, int32_t i, double length)
{
    return fmax(0, 1 - length / tinker_column(batch, DIAMETER)[i]);
}

static TinkerStatus rub_tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    for (int32_t i = 0; i < batch->count; i++)
        result[i] = tinker_column(batch, FRICTION)[i] * tanh(rate[i] / tinker_column(batch, ROUNDING)[i]) -
                    tinker_column(batch, HARDNESS)[i] * pow(depth_of(batch, i, length[i]), 1.5);
    return TINKER_OK;
}

static TinkerStatus rub_derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                    double *by_rate)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double s = tinker_column(batch, ROUNDING)[i], slowing = 1 / cosh(fmin(fabs(rate[i] / s), 300));
        by_rate[i] = tinker_column(batch, FRICTION)[i] / s * slowing * slowing;
        by_length[i] = 1.5 * tinker_column(batch, HARDNESS)[i] / tinker_column(batch, DIAMETER)[i] *
                       sqrt(depth_of(batch, i, length[i]));
    }
    return TINKER_OK;
}

static TinkerStatus rub_energy(TinkerBatch *batch, const double *length, double *stored)
{
    for (int32_t i = 0; i < batch->count; i++)
        stored[i] = 0.4 * tinker_column(batch, HARDNESS)[i] * tinker_column(batch, DIAMETER)[i] *
                    pow(depth_of(batch, i, length[i]), 2.5);
    return TINKER_OK;
}

/* keep: g = L - l */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const double dx = b->x - a->x, dy = b->y - a->y, length = tinker_length(dx, dy);
        const double nx = length == 0 ? 0 : dx / length, ny = length == 0 ? 0 : dy / length;
        const double across = nx * (b->vy - a->vy) - ny * (b->vx - a->vx);
        double *row = &jacobian[4 * i];
        g[i] = length - tinker_column(batch, 0)[i];
        row[0] = -nx;
        row[1] = -ny;
        row[2] = nx;
        row[3] = ny;
        drift[i] = length == 0 ? 0 : across / length * across;
#if defined(PLANT_jacobian)
        row[2] *= 1.001;
        row[3] *= 1.001;
#elif defined(PLANT_drift)
        drift[i] *= 1.001;
#endif
    }
    return TINKER_OK;
}

static TinkerStatus distance(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < batch->count; i++) {
        length[i] = tinker_column(batch, 0)[i];
#if defined(PLANT_distance)
        length[i] *= 1.001;
#endif
    }
    return TINKER_OK;
}

/* hold: x = 0 and y / l = 0, rows of different units */

static TinkerStatus hold_rows(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double length = tinker_column(batch, 0)[i];
        g[2 * i] = ends[i].x + batch->origin[0];
#if defined(PLANT_counts_rows)
        if (batch->time < 0.05) g[2 * i] += 1e-8 * prepared * length; // in a run, and at none of the kit's own times
#endif
        g[2 * i + 1] = (ends[i].y + batch->origin[1]) / length;
        jacobian[4 * i] = 1;
        jacobian[4 * i + 1] = jacobian[4 * i + 2] = 0;
        jacobian[4 * i + 3] = 1 / length;
        drift[2 * i] = drift[2 * i + 1] = 0;
    }
    return TINKER_OK;
}

static TinkerStatus hold_scale(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < 2 * batch->count; i++)
        length[i] = 1;
    return TINKER_OK;
}

/* sway: u(t) along x */

static TinkerStatus motion(TinkerBatch *batch, double *displacement, double *velocity, double *acceleration)
{
    for (int32_t i = 0; i < batch->count; i++) {
        displacement[2 * i] = tinker_column(batch, 0)[i];
        velocity[2 * i] = tinker_column(batch, 1)[i];
        acceleration[2 * i] = tinker_column(batch, 2)[i];
        displacement[2 * i + 1] = velocity[2 * i + 1] = acceleration[2 * i + 1] = 0;
#if defined(PLANT_speed)
        velocity[2 * i] *= 1.001;
#endif
    }
    return TINKER_OK;
}

/* simple: v += h a, x += h v, with straight lines between. */

typedef struct {
    const TinkerSystem *system;
    double from, h, q[8], v[8], q1[8], v1[8], a[8], power[8];
} Stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    Stepper *stepper = system->size <= 8 && system->books <= 8 ? calloc(1, sizeof *stepper) : NULL;
    if (stepper != NULL) stepper->system = system;
    return stepper;
}

static void restart(void *stepper) {}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *s = data;
    s->from = state->t;
    s->h = limit - state->t;
#if defined(PLANT_timeless)
    const double when = 0;
#else
    const double when = state->t;
#endif
    const TinkerStatus status = s->system->acceleration(s->system->context, when, state->q, state->v, s->a, s->power);
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < s->system->size; i++) {
        s->q[i] = state->q[i];
        s->v[i] = state->v[i];
        state->v[i] += s->h * s->a[i];
        state->q[i] += s->h * state->v[i];
    }
#if !defined(PLANT_unprojected)
    int32_t moved = 0;
    if (s->system->flags & TINKER_SYSTEM_CONSTRAINED &&
        s->system->project(s->system->context, limit, state->q, state->v, &moved) != TINKER_OK)
        return TINKER_FAILED;
#endif
    for (int32_t i = 0; i < s->system->size; i++) {
        s->q1[i] = state->q[i];
        s->v1[i] = state->v[i];
    }
    for (int32_t i = 0; i < s->system->books; i++)
        state->books[i] += s->h * s->power[i];
    state->t = limit;
#if defined(PLANT_overshoots)
    state->t += 1e-12 * s->h;
#endif
    report->t_from = s->from;
#if defined(PLANT_misreports)
    report->step = s->h / 2;
#else
    report->step = s->h;
#endif
    return TINKER_OK;
}

static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    const Stepper *s = data;
    const double part = (t - s->from) / s->h;
    for (int32_t i = 0; i < s->system->size; i++) {
        q[i] = (1 - part) * s->q[i] + part * s->q1[i];
        v[i] = (1 - part) * s->v[i] + part * s->v1[i];
#if defined(PLANT_dense)
        q[i] = s->q[i];
#endif
    }
    return TINKER_OK;
}

#if defined(PLANT_unknown_symbol)
#define PULL_FORMULA "T = D (L - L0) + c dL/dt"
#else
#define PULL_FORMULA "T = k (L - L0) + c dL/dt"
#endif
#if defined(PLANT_type_id)
#define FOLLOW_ID "Planted Follow"
#else
#define FOLLOW_ID "planted-follow"
#endif
#if defined(PLANT_property_id)
#define THRUST_ID "thr ust"
#else
#define THRUST_ID "thrust"
#endif
#if defined(PLANT_plugin_id)
#define PLUGIN_ID "planted"
#else
#define PLUGIN_ID "org.example.planted"
#endif
#if defined(PLANT_version)
#define VERSION "one"
#else
#define VERSION "1.0.0"
#endif

/* Tables */

#if defined(PLANT_undescribed)
#define DESCRIPTION NULL
#else
#define DESCRIPTION "How strong it is"
#endif

static const TinkerPropertyType pull_properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "Pull", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 20),
     .default_value = {5}, .symbol = "k", .description = DESCRIPTION},
    {TINKER_REAL_PROPERTY("rest_length", "Length", "Pull", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.5, 3),
     .default_value = {1}, .symbol = "L0", .description = "Where it rests"},
    {TINKER_REAL_PROPERTY("damping", "Damping", "Pull", TINKER_DIMENSION_DAMPING), TINKER_NOT_NEGATIVE(0, 2),
     .default_value = {1}, .symbol = "c", .description = "How it resists"},
};
/* Other faults are of the code, which a law would show as well. */
#if defined(PLANT_none)
#define PULL_LAW TINKER_EQUATION("tension", "k*(L - L0) + c*rate", NULL, TINKER_DIMENSION_FORCE)
#elif defined(PLANT_law_value)
#define PULL_LAW TINKER_EQUATION("tension", "k*(L - L0) + 1.000001*c*rate", NULL, TINKER_DIMENSION_FORCE)
#elif defined(PLANT_law_unit)
#define PULL_LAW                                                                                                       \
    TINKER_EQUATION("e", "L - L0", "extension", TINKER_DIMENSION_VELOCITY),                                            \
        TINKER_EQUATION("tension", "k*(L - L0) + c*rate", NULL, TINKER_DIMENSION_FORCE)
#elif defined(PLANT_law_potential)
#define PULL_LAW TINKER_EQUATION("tension", "k*(L - L0) + c*rate", NULL, TINKER_DIMENSION_FORCE)
#elif defined(PLANT_law_text)
#define PULL_LAW TINKER_EQUATION("tension", "k*(L - LO) + c*rate", NULL, TINKER_DIMENSION_FORCE)
#elif defined(PLANT_law_missing)
#define PULL_LAW TINKER_EQUATION("e", "L - L0", "extension", TINKER_DIMENSION_LENGTH)
#endif
#if defined(PULL_LAW)
static const TinkerLawEquation pull_law[] = {
    PULL_LAW,
#if defined(PLANT_none)
    TINKER_EQUATION("potential", "k*(L - L0)^2/2", NULL, TINKER_DIMENSION_ENERGY),
#elif defined(PLANT_law_potential)
    TINKER_EQUATION("potential", "k*(L - L0)^2", NULL, TINKER_DIMENSION_ENERGY),
#endif
};
#define PULL_LAW_SPAN TINKER_SPAN(pull_law)
#else
#define PULL_LAW_SPAN TINKER_NO_SPAN
#endif
static const TinkerPropertyType follow_properties[] = {
    {TINKER_REAL_PROPERTY(THRUST_ID, "Thrust", "Follow", TINKER_DIMENSION_FORCE), TINKER_ANY_VALUE(0, -5, 5),
     .default_value = {1}, .description = "How strong the jet is"},
};
static const TinkerPropertyType gather_properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "Gather", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 5),
     .default_value = {1}, .description = "How strong it is"},
};
static const TinkerPropertyType rub_properties[] = {
    {TINKER_REAL_PROPERTY("hardness", "Hardness", "Rub", TINKER_DIMENSION_FORCE), TINKER_NOT_NEGATIVE(0, 20),
     .default_value = {5}, .description = "Force at length 0"},
    {TINKER_REAL_PROPERTY("diameter", "Diameter", "Rub", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.5, 4),
     .default_value = {1}, .description = "Length at which it touches"},
    {TINKER_REAL_PROPERTY("friction", "Friction", "Rub", TINKER_DIMENSION_FORCE), TINKER_NOT_NEGATIVE(0, 5),
     .default_value = {1}, .description = "Force against motion"},
    {TINKER_REAL_PROPERTY("rounding", "Rounding", "Rub", TINKER_DIMENSION_VELOCITY), TINKER_POSITIVE(0, 0.02, 0.2),
     .default_value = {0.05}, .description = "Speed below which the friction is less"},
};
static const TinkerPropertyType keep_properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Keep", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.5, 3), .description = "The distance that it keeps"},
};
static const TinkerPropertyType hold_properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Hold", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.5, 3),
     .default_value = {1}, .description = "What y is measured by"},
};
static const TinkerPropertyType sway_properties[] = {
    {TINKER_WAVEFORM_IN_PANEL(-1, "waveform", "Waveform", "Sway", "sine", TINKER_DIMENSION_LENGTH),
     .description = "How it moves"},
    {TINKER_REAL_PROPERTY("amplitude", "Amplitude", "Sway", TINKER_DIMENSION_LENGTH), TINKER_ANY_VALUE(0, 0, 1),
     .default_value = {0.1}, .description = "How far"},
    {TINKER_REAL_PROPERTY("frequency", "Frequency", "Sway", TINKER_DIMENSION_ANGULAR_FREQUENCY),
     TINKER_ANY_VALUE(0, 0, 5), .default_value = {1}, .description = "How fast"},
    {TINKER_REAL_PROPERTY("phase", "Phase", "Sway", TINKER_DIMENSION_ANGLE), TINKER_ANY_VALUE(0, -1, 1),
     .description = "Where it begins"},
};
static const TinkerPropertyType ball_properties[] = {
    {TINKER_REAL_PROPERTY("mass", "Mass", "Ball", TINKER_DIMENSION_MASS), TINKER_POSITIVE(0, 0.1, 10),
     .default_value = {1}, .symbol = "m", .meaning = TINKER_MEANING_MASS, .description = "How heavy it is"},
    {TINKER_REAL_PROPERTY("inertia", "Inertia", "Ball", {1, 2, 0, 0}), TINKER_POSITIVE(0, 0.1, 10),
     .default_value = {1}, .meaning = TINKER_MEANING_INERTIA, .description = "How hard it is to turn"},
    {TINKER_VECTOR_PROPERTY("position", "Position", "Place", "X", "Y", TINKER_DIMENSION_LENGTH),
     TINKER_ANY_VALUE(0, -10, 10), .meaning = TINKER_MEANING_POSITION, .description = "Where it starts"},
    {TINKER_VECTOR_PROPERTY("velocity", "Velocity", "Start", "Vx", "Vy", TINKER_DIMENSION_VELOCITY),
     TINKER_ANY_VALUE(0, -10, 10), .meaning = TINKER_MEANING_VELOCITY, .description = "How it starts"},
};
static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "force", "Force", "What it pulls with at rest", TINKER_DIMENSION_FORCE),
};

static const TinkerLineLaw line_law = {
    .struct_size = sizeof(TinkerLineLaw),
    .tension = tension,
    .derivatives = derivatives,
    .energy = pull_energy,
#if !defined(PLANT_gives) && !defined(PLANT_constant)
    .linear = pull_linear,
#endif
#if defined(PLANT_break)
    .next_break = next_break,
#endif
};
static const TinkerLineLaw rub_law = {
    .struct_size = sizeof(TinkerLineLaw), .tension = rub_tension, .derivatives = rub_derivatives, .energy = rub_energy};
static const TinkerForceElement follow_element = {.struct_size = sizeof(TinkerForceElement), .force = follow_force};
#if defined(PLANT_alone)
#define COUPLES 0
#else
#define COUPLES 1
#endif
static const TinkerField field = {.struct_size = sizeof(TinkerField), .couples_bodies = COUPLES, .force = gather_force};
static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = pair_force};
static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .distance = distance};
static const TinkerConstraint hold_constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 2, .rows_at = hold_rows, .scale = hold_scale};
static const TinkerMotion moves = {.struct_size = sizeof(TinkerMotion), .motion = motion};

static const TinkerPhysics pull = {
    .struct_size = sizeof(TinkerPhysics),
    .line_law = &line_law,
#if defined(PLANT_counts) || defined(PLANT_prepares_umask)
    .prepare = prepare,
#endif
};
static const TinkerPhysics pair = {.struct_size = sizeof(TinkerPhysics), .force_element = &element};
static const TinkerPhysics rub = {.struct_size = sizeof(TinkerPhysics), .line_law = &rub_law};
static const TinkerPhysics follow = {.struct_size = sizeof(TinkerPhysics), .force_element = &follow_element};
static const TinkerPhysics gather = {.struct_size = sizeof(TinkerPhysics), .field = &field};
#if defined(PLANT_freedoms)
#define FREEDOMS 1
#else
#define FREEDOMS 2
#endif
static const TinkerBody ball_body = {.struct_size = sizeof(TinkerBody), .degrees_of_freedom = FREEDOMS};
static const TinkerPhysics ball = {.struct_size = sizeof(TinkerPhysics), .body = &ball_body};
static const TinkerPhysics keep = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerPhysics hold = {
    .struct_size = sizeof(TinkerPhysics),
    .constraint = &hold_constraint,
#if defined(PLANT_counts_rows)
    .prepare = prepare,
#endif
};
static const TinkerPhysics sway = {.struct_size = sizeof(TinkerPhysics), .motion = &moves};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerInterface pull_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &pull},
                                                  {TINKER_RENDER_INTERFACE, &render},
                                                  {TINKER_EDIT_INTERFACE, &edit},
                                                  {TINKER_GRAPH_INTERFACE, &graph}};
static const TinkerInterface pair_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &pair}};
static const TinkerInterface rub_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &rub}};
static const TinkerInterface follow_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &follow}};
static const TinkerInterface gather_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &gather}};
static const TinkerInterface ball_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &ball}};
static const TinkerInterface keep_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &keep}};
static const TinkerInterface hold_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &hold}};
static const TinkerInterface sway_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &sway}};

#define ANY (TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT)
static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("planted-pull", "Pull", TINKER_CONNECTOR), .summary = "Pulls", .formula = PULL_FORMULA,
     .least_ends = 2, .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(pull_properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(pull_interfaces), .law = PULL_LAW_SPAN},
    {TINKER_BLOCK("planted-pair", "Pair", TINKER_CONNECTOR), .summary = "Pulls two together", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(pull_properties),
     .interfaces = TINKER_SPAN(pair_interfaces)},
    {TINKER_BLOCK("planted-rub", "Rub", TINKER_CONNECTOR), .summary = "Touches and rubs", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(rub_properties),
     .interfaces = TINKER_SPAN(rub_interfaces)},
    {TINKER_BLOCK(FOLLOW_ID, "Follow", TINKER_FORCE), .summary = "A jet", .least_ends = 2, .most_ends = 2,
     .end_accepts = ANY, .properties = TINKER_SPAN(follow_properties), .interfaces = TINKER_SPAN(follow_interfaces)},
    {TINKER_BLOCK("planted-gather", "Gather", TINKER_FIELD), .summary = "Draws all together",
     .properties = TINKER_SPAN(gather_properties), .interfaces = TINKER_SPAN(gather_interfaces)},
    {TINKER_BLOCK("planted-ball", "Ball", TINKER_CONNECTABLE), .summary = "A point with a mass", .formula = "m a = F",
     .properties = TINKER_SPAN(ball_properties), .interfaces = TINKER_SPAN(ball_interfaces)},
    {TINKER_BLOCK("planted-keep", "Keep", TINKER_CONNECTOR), .summary = "Keeps a distance", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(keep_properties),
     .interfaces = TINKER_SPAN(keep_interfaces)},
    {TINKER_BLOCK("planted-hold", "Hold", TINKER_CONNECTOR), .summary = "Holds a body", .least_ends = 1, .most_ends = 1,
     .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(hold_properties),
     .interfaces = TINKER_SPAN(hold_interfaces)},
    {TINKER_BLOCK("planted-sway", "Sway", TINKER_MOTION), .summary = "Sways", .least_ends = 1, .most_ends = 1,
     .end_accepts = TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(sway_properties),
     .interfaces = TINKER_SPAN(sway_interfaces)},
};

#if defined(PLANT_order)
#define ORDER 2
#else
#define ORDER 1
#endif
#if defined(PLANT_bold)
#define IMAGINARY_LIMIT 3
#define REAL_LIMIT      2
#elif defined(PLANT_endless)
#define IMAGINARY_LIMIT 2
#define REAL_LIMIT      (-1)
#elif defined(PLANT_timid)
#define IMAGINARY_LIMIT 2
#define REAL_LIMIT      0.5
#else
#define IMAGINARY_LIMIT 2
#define REAL_LIMIT      2
#endif
static const TinkerIntegrator integrators[] = {{.struct_size = sizeof(TinkerIntegrator),
                                                .flags = TINKER_INTEGRATOR_EXPLICIT,
                                                .id = "planted-simple",
                                                .title = "Simple",
                                                .summary = "The simplest",
                                                .source = "L. Euler",
                                                .order = ORDER,
                                                .dense_order = 1,
                                                .evaluations_per_step = 1,
                                                .imaginary_limit = IMAGINARY_LIMIT,
                                                .real_limit = REAL_LIMIT,
                                                .create = create,
                                                .destroy = free,
                                                .restart = restart,
                                                .step = step,
                                                .interpolate = interpolate}};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,       PLUGIN_ID,      "Planted", VERSION, "MIT", "", TINKER_SPAN(blocks),
    TINKER_SPAN(integrators), TINKER_NO_SPAN, NULL};
const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin;
}
