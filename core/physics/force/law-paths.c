/* Typed laws along a step; see the header. */
#include "physics/force/law-paths.h"
#include "physics/model/points.h"

#include <math.h>
#include <string.h>

/* Listing ---------------------------------------------------------------------------------------------------------- */

/* The names that typed-law.h reserves; FALSE where another is among them, which says nothing here. There is room for
 * all: a class with more is refused as it is loaded. */
static gboolean name_arguments(TinkerLawForce *law, const TinkerPropertyType *type)
{
    static const char *const names[] = {"x", "y", "vx", "vy", "t", "m", "L", "rate"};
    law->count = type->choice_count;
    for (int32_t i = 0; i < type->choice_count; i++) {
        gsize k = 0;
        while (k < G_N_ELEMENTS(names) && strcmp(names[k], type->choices[i]) != 0)
            k++;
        if (k == G_N_ELEMENTS(names)) return FALSE;
        law->arguments[i] = (TinkerLawArgument)k;
    }
    return TRUE;
}

static void add(GArray *list, TinkerLawForce law, const TinkerCompiled *force)
{
    law.force = force;
    if (!tinker_compiled_is_always_gentle(force)) g_array_append_val(list, law);
}

/* A law that is an energy acts by its slopes along places; one that is neither that nor a force is something else. */
static void add_law(GArray *list, TinkerLawForce law, const struct TinkerTypedLaw *typed,
                    const TinkerPropertyType *type)
{
    const TinkerDimension energy = TINKER_DIMENSION_ENERGY, force = TINKER_DIMENSION_FORCE;
    if (typed == NULL || !name_arguments(&law, type)) return;
    if (memcmp(&type->dimension, &force, sizeof force) == 0) add(list, law, typed->value);
    if (memcmp(&type->dimension, &energy, sizeof energy) != 0) return;
    for (int i = 0; i < law.count; i++)
        if (law.arguments[i] == TINKER_LAW_X || law.arguments[i] == TINKER_LAW_Y || law.arguments[i] == TINKER_LAW_L)
            add(list, law, typed->slopes[i]);
}

static void add_row(GArray *list, TinkerLawForce law, const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerBlockClass *of = batch->block_class;
    struct TinkerTypedLaw **typed = batch->laws + (gsize)row * (gsize)batch->law_count;
    law.block = batch->ids[row];
    for (int32_t p = 0; p < of->property_count; p++)
        if ((of->properties[p].flags & TINKER_TEXT_LAW) != 0) add_law(list, law, *typed++, &of->properties[p]);
}

static double mass_at(const TinkerModel *model, int32_t point)
{
    const int32_t body = tinker_model_body_of(model, point);
    return body >= 0 ? model->mass[body] : INFINITY;
}

/* Blocks at the ends that they have: at one place, or between two. */
static void add_ends(GArray *list, const TinkerModel *model, const TinkerAskedBatch *asked)
{
    const TinkerBlockBatch *batch = asked->batch;
    for (int32_t row = 0; batch->law_count > 0 && row < batch->count; row++) {
        const int32_t *points = asked->end_points + batch->end_offsets[row];
        const int32_t ends = batch->end_offsets[row + 1] - batch->end_offsets[row];
        TinkerLawForce law = {.a = points[0], .b = ends == 2 ? points[1] : -1};
        law.mass = ends == 2 ? fmin(mass_at(model, law.a), mass_at(model, law.b)) : mass_at(model, law.a);
        if (ends <= 2 && isfinite(law.mass)) add_row(list, law, batch, row);
    }
}

static void add_field(GArray *list, const TinkerModel *model, const TinkerBlockBatch *batch)
{
    for (int32_t row = 0; batch->law_count > 0 && row < batch->count; row++)
        for (int32_t body = 0; body < model->bodies; body++)
            add_row(list, (TinkerLawForce){.a = body, .b = -1, .mass = model->mass[body]}, batch, row);
}

GArray *tinker_law_forces(const TinkerModel *model)
{
    GArray *list = g_array_new(FALSE, FALSE, sizeof(TinkerLawForce));
    for (guint i = 0; i < model->asked_lines->len; i++)
        add_ends(list, model, &g_array_index(model->asked_lines, TinkerAskedBatch, i));
    for (guint i = 0; i < model->asked_forces->len; i++)
        add_ends(list, model, &g_array_index(model->asked_forces, TinkerAskedBatch, i));
    for (guint i = 0; i < model->asked_fields->len; i++)
        add_field(list, model, g_array_index(model->asked_fields, TinkerAskedBatch, i).batch);
    return list;
}

/* Ways ------------------------------------------------------------------------------------------------------------- */

/* One coordinate at the two ends of a step of h. */
typedef struct {
    double h, x0, v0, x1, v1;
} Way;

/* Where it may be, and how fast, in a part of the step. */
typedef struct {
    TinkerInterval place, rate;
} Reach;

static double place_at(const Way *way, double s)
{
    const double by = way->x1 - way->x0, u0 = way->h * way->v0, u1 = way->h * way->v1;
    return way->x0 + s * (u0 + s * (3 * by - 2 * u0 - u1 + s * (u0 + u1 - 2 * by)));
}

static double rate_at(const Way *way, double s)
{
    const double by = way->x1 - way->x0, u0 = way->h * way->v0, u1 = way->h * way->v1;
    return (u0 + s * (2 * (3 * by - 2 * u0 - u1) + 3 * s * (u0 + u1 - 2 * by))) / way->h;
}

/* m: the motion bends by about this; where it swings by up to 2.8 rad in the step, the cubic is nearer than that to it:
 * of a cosine, (omega h)^4 / 384 against (omega h)^2 / 48. */
static double room_beside(const Way *way)
{
    const double by = way->x1 - way->x0;
    return (fabs(by - way->h * (2 * way->v0 + way->v1) / 3) + fabs(by - way->h * (way->v0 + 2 * way->v1) / 3)) / 16;
}

static TinkerInterval around(const double *values, int count, double room)
{
    TinkerInterval all = {values[0], values[0]};
    for (int i = 1; i < count; i++)
        all = (TinkerInterval){fmin(all.low, values[i]), fmax(all.high, values[i])};
    return (TinkerInterval){all.low - room, all.high + room};
}

/* A cubic lies within its control points. */
static Reach reach_of(const Way *way, double low, double high)
{
    const double part = (high - low) * way->h, x0 = place_at(way, low), x1 = place_at(way, high);
    const double v0 = rate_at(way, low), v1 = rate_at(way, high), room = room_beside(way);
    const double places[] = {x0, x0 + part * v0 / 3, x1 - part * v1 / 3, x1};
    const double rates[] = {v0, 3 * (x1 - x0) / part - v0 - v1, v1};
    return (Reach){around(places, 4, room), around(rates, 3, 8 * room / way->h)};
}

static Way way_of(const TinkerLawForce *law, const TinkerLawStep *step, int axis)
{
    const TinkerPoint *p = &step->first[law->a], *q = &step->last[law->a];
    const double h = step->to - step->from;
    Way way = axis == 0 ? (Way){h, p->x, p->vx, q->x, q->vx} : (Way){h, p->y, p->vy, q->y, q->vy};
    if (law->b < 0) {
        way.x0 += step->origin[axis];
        way.x1 += step->origin[axis];
        return way;
    }
    const TinkerPoint *r = &step->first[law->b], *s = &step->last[law->b];
    return axis == 0 ? (Way){h, r->x - way.x0, r->vx - way.v0, s->x - way.x1, s->vx - way.v1}
                     : (Way){h, r->y - way.x0, r->vy - way.v0, s->y - way.x1, s->vy - way.v1};
}

/* Laws ------------------------------------------------------------------------------------------------------------- */

/* Where two ends may be to each other in a part of a step: apart in x and y, and in their distance. */
typedef struct {
    Reach axis[2], length;
} Between;

static Reach length_of_box(const Reach axis[2])
{
    const TinkerInterval length = tinker_interval_sqrt(
        tinker_interval_add(tinker_interval_power(axis[0].place, 2), tinker_interval_power(axis[1].place, 2)));
    const TinkerInterval product = tinker_interval_add(tinker_interval_multiply(axis[0].place, axis[0].rate),
                                                       tinker_interval_multiply(axis[1].place, axis[1].rate));
    return (Reach){length, tinker_interval_divide(product, length)};
}

/* Ends that turn about each other keep a distance that no box about their ways tells. FALSE where its cubic is farther
 * from that of the ways than they may be from the motion, as of ends that pass each other. */
static gboolean length_of_ways(const Way way[2], Way *length)
{
    static const double looks[] = {0.25, 0.5, 0.75};
    const double l0 = hypot(way[0].x0, way[1].x0), l1 = hypot(way[0].x1, way[1].x1);
    const double room = room_beside(&way[0]) + room_beside(&way[1]);
    *length = (Way){way[0].h, l0, (way[0].x0 * way[0].v0 + way[1].x0 * way[1].v0) / l0, l1,
                    (way[0].x1 * way[0].v1 + way[1].x1 * way[1].v1) / l1};
    for (gsize i = 0; i < G_N_ELEMENTS(looks); i++) {
        const double s = looks[i];
        if (!(fabs(place_at(length, s) - hypot(place_at(&way[0], s), place_at(&way[1], s))) <= room)) return FALSE;
    }
    return TRUE;
}

static TinkerInterval argument_of(const TinkerLawForce *law, TinkerLawArgument argument, const Between *between,
                                  TinkerInterval time)
{
    switch (argument) {
    case TINKER_LAW_X:
    case TINKER_LAW_Y:
        return between->axis[argument - TINKER_LAW_X].place;
    case TINKER_LAW_VX:
    case TINKER_LAW_VY:
        return between->axis[argument - TINKER_LAW_VX].rate;
    case TINKER_LAW_T:
        return time;
    case TINKER_LAW_L:
        return between->length.place;
    case TINKER_LAW_RATE:
        return between->length.rate;
    default:
        return tinker_interval_point(law->mass);
    }
}

/* s: at a share of the step. The two ends, which may be breaks, are taken a little within it. */
static double time_at(const TinkerLawStep *step, double share)
{
    const double length = step->to - step->from;
    const double first = step->from + tinker_time_beside(step->from, length);
    const double last = step->to - tinker_time_beside(step->to, length);
    const double t = step->from + share * length;
    return first < last ? CLAMP(t, first, last) : t;
}

gboolean tinker_law_enclose(const TinkerLawForce *law, const TinkerLawStep *step, double low, double high,
                            TinkerInterval *force)
{
    const Way way[2] = {way_of(law, step, 0), way_of(law, step, 1)};
    Between between = {{reach_of(&way[0], low, high), reach_of(&way[1], low, high)}, {{0, 0}, {0, 0}}};
    Way length;
    if (law->b >= 0)
        between.length = length_of_ways(way, &length) ? reach_of(&length, low, high) : length_of_box(between.axis);
    const TinkerInterval time = {time_at(step, low), time_at(step, high)};
    TinkerInterval arguments[TINKER_TYPED_MOST_ARGUMENTS];
    int by_time = -1; /* breaks, which no step crosses */
    for (int i = 0; i < law->count; i++) {
        arguments[i] = argument_of(law, law->arguments[i], &between, time);
        if (step->in_piece && law->arguments[i] == TINKER_LAW_T) by_time = i;
    }
    return tinker_compiled_enclose(law->force, arguments, by_time, force);
}

double tinker_law_force_at(const TinkerLawForce *law, const TinkerLawStep *step, double at)
{
    const Way way[2] = {way_of(law, step, 0), way_of(law, step, 1)};
    Between between;
    double arguments[TINKER_TYPED_MOST_ARGUMENTS];
    for (int k = 0; k < 2; k++)
        between.axis[k] =
            (Reach){tinker_interval_point(place_at(&way[k], at)), tinker_interval_point(rate_at(&way[k], at))};
    between.length = length_of_box(between.axis);
    const TinkerInterval time = tinker_interval_point(time_at(step, at));
    for (int i = 0; i < law->count; i++) {
        const TinkerInterval argument = argument_of(law, law->arguments[i], &between, time);
        arguments[i] = 0.5 * (argument.low + argument.high);
    }
    return tinker_compiled_value(law->force, arguments);
}
