/* dimensions: the laws of nature do not know our units. With kg, m and s exchanged for others, all inputs are rescaled
 * by their declared dimensions, and the results have to rescale by theirs. The units differ by powers of two, so that
 * this is exact but for what roots and powers round. A constant that hides in the code, or a wrong dimension in the
 * declaration, shows. Radians are not exchanged: the sine of an angle knows its unit.
 *
 * Each row of a constraint has a unit of its own (a distance and an angle may be held by one block), which is found as
 * the power by which its g rescales. */
#include <math.h>

#include "conformance/probe/sample-laws.h"
#include "conformance/probe/state.h"

#define CLOSE     1e-9
#define MOST_ROWS 64

/* Powers of two that a kg, an m and an s become; */
typedef struct {
    int mass, length, time;
} Units;

/* and those by which the rows of a constraint rescale. */
typedef struct {
    int of[MOST_ROWS];
} Rows;

static double factor(Units units, TinkerDimension d)
{
    return ldexp(1.0, units.mass * d.mass + units.length * d.length + units.time * d.time);
}

static void scale(double *values, gsize count, double by)
{
    for (gsize i = 0; i < count; i++)
        values[i] *= by;
}

static void scale_columns(KitState *state, Units units)
{
    const TinkerBlockClass *c = state->block_class;
    for (int32_t k = 0; k < c->property_count; k++)
        for (int32_t part = 0; part < tinker_kind_columns(c->properties[k].kind); part++) {
            TinkerDimension d = c->properties[k].dimension;
            if (c->properties[k].kind == TINKER_KIND_WAVEFORM) d.time = (int8_t)(d.time - part);
            scale(state->columns[c->first_columns[k] + part], (gsize)state->count, factor(units, d));
            scale(state->placed_columns[c->first_columns[k] + part], (gsize)state->count, factor(units, d));
        }
}

static void scale_points(TinkerPoint *points, int32_t count, Units units)
{
    const double length = ldexp(1.0, units.length), speed = ldexp(1.0, units.length - units.time);
    for (int32_t i = 0; i < count; i++)
        points[i] =
            (TinkerPoint){points[i].x * length, points[i].y * length, points[i].vx * speed, points[i].vy * speed};
}

/* A multiplier times a row's change is work. */
static KitState *rescaled(const KitState *state, Units units, const Rows *g)
{
    const gsize count = (gsize)state->count, ends = (gsize)kit_state_end_count(state);
    const int32_t rows = kit_state_rows(state);
    const double force = factor(units, (TinkerDimension)TINKER_DIMENSION_FORCE);
    KitState *copy = kit_state_copy(state);
    scale_columns(copy, units);
    scale_points(copy->points, (int32_t)ends, units);
    scale_points(copy->placed, (int32_t)ends, units);
    scale_points(copy->bodies, copy->body_count, units);
    scale(copy->lengths, count, ldexp(1.0, units.length));
    scale(copy->rates, count, ldexp(1.0, units.length - units.time));
    scale(copy->accelerations, 2 * ends, ldexp(1.0, units.length - 2 * units.time));
    scale(copy->forces, 2 * ends, force);
    scale(copy->torques, ends, force * ldexp(1.0, units.length));
    scale(copy->contacts, 4 * count, force);
    for (gsize e = 0; e < ends; e++) {
        copy->poses[e].rate *= ldexp(1.0, -units.time);
        copy->poses[e].acceleration *= ldexp(1.0, -2 * units.time);
        copy->placed_poses[e].rate *= ldexp(1.0, -units.time);
    }
    for (int32_t k = 0; k < state->count * rows; k++)
        scale(copy->multipliers + k, 1, force * ldexp(1.0, units.length - g->of[k % rows]));
    scale(copy->masses, (gsize)copy->body_count, ldexp(1.0, units.mass));
    copy->time *= ldexp(1.0, units.time);
    g_strlcpy(copy->label, "other units", sizeof copy->label);
    return copy;
}

/* The row that an entry belongs to. */
static int32_t row_of(const KitOutput *output, const KitState *state, gsize entry)
{
    const int32_t rows = kit_state_rows(state), instance = kit_output_instance(output, state, entry);
    if (output->extent == KIT_ROWS) return (int32_t)entry % rows;
    const int32_t within = (int32_t)entry - rows * state->offsets[instance];
    return within / (state->offsets[instance + 1] - state->offsets[instance]);
}

static void tell_difference(KitCheck *check, const KitFunction *function, const KitOutput *kind, const KitState *state,
                            gsize number, double before, double given, double expected, Units units)
{
    const gsize entry = number / (gsize)kind->width;
    const double kg = ldexp(1.0, -units.mass), m = ldexp(1.0, -units.length), s = ldexp(1.0, -units.time);
    g_autofree char *whose = kit_entry_name(kind, state, entry), *values = kit_entry_describe(kind, state, entry);
    if (!isfinite(before))
        kit_fail(check, "%s: \"%s\" of %s is not finite at %s, so that no dimension is to be told (%s)", function->name,
                 kind->name, whose, state->label, values);
    else if (!isfinite(given))
        kit_fail(check, "%s: \"%s\" of %s is %.9g, but not finite in units of %g kg, %g m and %g s (%s)",
                 function->name, kind->name, whose, before, kg, m, s, values);
    else
        kit_fail(check,
                 "%s: \"%s\" of %s is %.9g; in units of %g kg, %g m and %g s it is %.9g, %.9g was expected: a "
                 "constant hides in the law, or a declared dimension is wrong (%s)",
                 function->name, kind->name, whose, before, kg, m, s, given, expected, values);
}

static void compare(KitCheck *check, const KitFunction *function, int output, const KitState *state,
                    const KitAnswer *before, const KitAnswer *after, Units units, const Rows *g)
{
    const KitOutput *kind = &function->outputs[output];
    const gsize width = (gsize)kind->width;
    for (gsize i = 0; i < before->entries[output] && !kind->integers && !kind->tolerance; i++) {
        const int of_row = kind->of_g ? g->of[row_of(kind, state, i / width)] : 0;
        const double by = factor(units, kind->dimension[i % width]) * ldexp(1.0, of_row);
        const double expected = before->values[output][i] * by, given = after->values[output][i];
        if (kit_output_is_absent(kind, state, expected) && isnan(given)) continue;
        double size = fabs(expected);
        for (gsize k = i - i % width; k < i - i % width + width; k++) // components of a vector round together
            if (tinker_kind_columns(TINKER_KIND_VECTOR) == kind->width)
                size = fmax(size, fabs(before->values[output][k]) * by);
        if (given == expected || fabs(given - expected) <= CLOSE * size) continue;
        tell_difference(check, function, kind, state, i, before->values[output][i], given, expected, units);
        return;
    }
}

/* The powers of two by which the rows rescale, of each from its first g that is not 0. */
static Rows find_rows(KitCheck *check, const GArray *functions, const KitState *state, Units units)
{
    Rows g = {{0}};
    const KitFunction *function = kit_function(functions, "rows_at");
    if (function == NULL) return g;
    const gsize rows = (gsize)kit_state_rows(state);
    g_autoptr(KitState) other = rescaled(state, units, &g);
    g_autoptr(KitAnswer) before = kit_call_well(check, function, state), after = kit_call_well(check, function, other);
    gboolean found[MOST_ROWS] = {FALSE};
    for (gsize i = 0; before != NULL && after != NULL && i < before->entries[0]; i++) {
        const double ratio = after->values[0][i] / before->values[0][i];
        if (found[i % rows] || !isfinite(ratio) || !(ratio > 0)) continue;
        g.of[i % rows] = (int)lrint(log2(ratio));
        found[i % rows] = TRUE;
    }
    return g;
}

static void try_units(KitCheck *check, const GArray *functions, const KitState *state, Units units)
{
    const Rows g = find_rows(check, functions, state, units);
    g_autoptr(KitState) other = rescaled(state, units, &g);
    const char *failure;
    if (kit_state_prepare(other, &failure) != TINKER_OK)
        kit_fail(check, "in other units it refuses the same values: %s", failure != NULL ? failure : "no reason");
    for (guint i = 0; i < functions->len && !kit_decided(check); i++) {
        const KitFunction *function = &g_array_index(functions, KitFunction, i);
        g_autoptr(KitAnswer) before = kit_call(check, function, state);
        if (before->status != TINKER_OK) continue;
        g_autoptr(KitAnswer) after = kit_call_well(check, function, other);
        for (int k = 0; after != NULL && k < function->output_count && !kit_decided(check); k++)
            compare(check, function, k, state, before, after, units, &g);
    }
}

void kit_try_dimensions(KitCheck *check)
{
    static const Units exchanges[] = {{2, 0, 0}, {0, 3, 0}, {0, 0, -2}, {1, -2, 3}};
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const TinkerPhysics *physics = check->block_class->physics;
    int32_t typed;
    if (functions->len == 0) kit_skip(check, "it offers no function over batches");
    if (kit_sample_laws(check->block_class, &typed) != NULL) kit_skip(check, "its law is typed, in plain SI numbers");
    if (physics != NULL && physics->constraint != NULL && physics->constraint->rows > MOST_ROWS)
        kit_skip(check, "it has more than %d rows", MOST_ROWS);
    for (gsize i = 0; i < G_N_ELEMENTS(exchanges) && !kit_decided(check); i++) {
        g_autoptr(KitState) state = kit_state_new(check, KIT_COUNT);
        if (state != NULL) try_units(check, functions, state, exchanges[i]);
    }
}
