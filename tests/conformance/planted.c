/* One good library, and with PLANT_... defined the same with one fault. It has a line law (pull), a force element (pair), a
 * constraint (keep), a motion (sway) and an integrator (simple). */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

#include <tinker/sdk.h>

#ifdef PLANT_exports
TINKER_EXPORT int another_symbol(void);
int another_symbol(void)
{
    return 1;
}
#endif

#if defined(PLANT_counts)
static double prepared;
static TinkerStatus prepare(TinkerBatch *batch)
{
    prepared++;
    return TINKER_OK;
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
#elif defined(PLANT_abort)
        if (length[i] == 0) abort();
#elif defined(PLANT_crash)
        if (length[i] == 0) raise(SIGSEGV);
#elif defined(PLANT_hang)
        for (volatile int waiting = 1; waiting && length[i] == 0;)
            ;
#endif
        result[i] = k[i] * (length[i] - rest[i]) + c[i] * rate[i];
#if defined(PLANT_gives)
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
    return TINKER_OK;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
#if defined(PLANT_ink)
    style->circle(style, cairo, TINKER_COLOUR_BODY, -1, a->x + 2, a->y + 5, 0.5);
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
        k *= 1 + 0.01 * (a->x * a->x + a->y * a->y) / (rest * rest);
#elif defined(PLANT_direction)
        const double length = tinker_length(dx, dy);
        k *= 1 + 0.1 * (length == 0 ? 0 : fabs(dx) / length);
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
    const TinkerStatus status =
        s->system->acceleration(s->system->context, state->t, state->q, state->v, s->a, s->power);
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < s->system->size; i++) {
        s->q[i] = state->q[i];
        s->v[i] = state->v[i];
        state->v[i] += s->h * s->a[i];
        state->q[i] += s->h * state->v[i];
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
    report->step = s->h;
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
static const TinkerPropertyType keep_properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Keep", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.5, 3), .description = "The distance that it keeps"},
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
static const TinkerForceElement element = {.struct_size = sizeof(TinkerForceElement), .force = pair_force};
static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at, .distance = distance};
static const TinkerMotion moves = {.struct_size = sizeof(TinkerMotion), .motion = motion};

static const TinkerPhysics pull = {
    .struct_size = sizeof(TinkerPhysics),
    .line_law = &line_law,
#if defined(PLANT_counts)
    .prepare = prepare,
#endif
};
static const TinkerPhysics pair = {.struct_size = sizeof(TinkerPhysics), .force_element = &element};
static const TinkerPhysics keep = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};
static const TinkerPhysics sway = {.struct_size = sizeof(TinkerPhysics), .motion = &moves};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerInterface pull_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &pull},
                                                  {TINKER_RENDER_INTERFACE, &render},
                                                  {TINKER_EDIT_INTERFACE, &edit},
                                                  {TINKER_GRAPH_INTERFACE, &graph}};
static const TinkerInterface pair_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &pair}};
static const TinkerInterface keep_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &keep}};
static const TinkerInterface sway_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &sway}};

#define ANY (TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT)
static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("planted-pull", "Pull", TINKER_CONNECTOR), .summary = "Pulls", .formula = "T = k (L - L0) + c dL/dt",
     .least_ends = 2, .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(pull_properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(pull_interfaces)},
    {TINKER_BLOCK("planted-pair", "Pair", TINKER_CONNECTOR), .summary = "Pulls two together", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(pull_properties),
     .interfaces = TINKER_SPAN(pair_interfaces)},
    {TINKER_BLOCK("planted-keep", "Keep", TINKER_CONNECTOR), .summary = "Keeps a distance", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(keep_properties),
     .interfaces = TINKER_SPAN(keep_interfaces)},
    {TINKER_BLOCK("planted-sway", "Sway", TINKER_MOTION), .summary = "Sways", .least_ends = 1, .most_ends = 1,
     .end_accepts = TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(sway_properties),
     .interfaces = TINKER_SPAN(sway_interfaces)},
};

#if defined(PLANT_order)
#define ORDER 2
#else
#define ORDER 1
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
                                                .imaginary_limit = 2,
                                                .real_limit = 2,
                                                .create = create,
                                                .destroy = free,
                                                .restart = restart,
                                                .step = step,
                                                .interpolate = interpolate}};

static const TinkerPlugin plugin = {TINKER_PLUGIN_HEAD,  "org.example.planted",    "Planted",      "1.0.0", "MIT", "",
                                    TINKER_SPAN(blocks), TINKER_SPAN(integrators), TINKER_NO_SPAN, NULL};
const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin;
}
