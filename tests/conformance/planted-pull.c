/* A line law that is drawn too. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <cairo.h>

#include "planted.h"

#ifdef PLANT_prints_checked
int __printf_chk(int flag, const char *format, ...);
#endif

/* pull: T = k (L - L0) + c rate */

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
        result[i] *= 1 + 1e-13 * planted_prepared;
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
        stiffness[i] *= 1 + 1e-13 * planted_prepared;
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

#if defined(PLANT_undescribed)
#define DESCRIPTION NULL
#else
#define DESCRIPTION "How strong it is"
#endif

#if defined(PLANT_same_symbol)
#define REST_SYMBOL "k"
#else
#define REST_SYMBOL "L0"
#endif

const TinkerPropertyType planted_pull_properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "Stiffness", "Pull", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 20),
     .default_value = {5}, .symbol = "k", .description = DESCRIPTION},
    {TINKER_REAL_PROPERTY("rest_length", "Length", "Pull", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.5, 3),
     .default_value = {1}, .symbol = REST_SYMBOL, .description = "Where it rests"},
    {TINKER_REAL_PROPERTY("damping", "Damping", "Pull", TINKER_DIMENSION_DAMPING), TINKER_NOT_NEGATIVE(0, 2),
     .default_value = {1}, .symbol = "c", .description = "How it resists"},
};

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
const TinkerLawEquation planted_pull_law[] = {
    PULL_LAW,
#if defined(PLANT_none)
    TINKER_EQUATION("potential", "k*(L - L0)^2/2", NULL, TINKER_DIMENSION_ENERGY),
#elif defined(PLANT_law_potential)
    TINKER_EQUATION("potential", "k*(L - L0)^2", NULL, TINKER_DIMENSION_ENERGY),
#endif
};
#endif

const TinkerQuantityType planted_quantities[] = {
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

static const TinkerPhysics pull = {
    .struct_size = sizeof(TinkerPhysics),
    .line_law = &line_law,
#if defined(PLANT_counts) || defined(PLANT_prepares_umask)
    .prepare = planted_prepare,
#endif
};

static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

const TinkerInterface planted_pull_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &pull},
                                                   {TINKER_RENDER_INTERFACE, &render},
                                                   {TINKER_EDIT_INTERFACE, &edit},
                                                   {TINKER_GRAPH_INTERFACE, &graph}};
