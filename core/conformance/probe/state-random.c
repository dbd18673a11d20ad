/* Random states: values as the declaration suggests them, drawn again where the block refuses them. */
#include <math.h>
#include <string.h>

#include "conformance/probe/state.h"

#define MOST_DRAWS 200
#define BODIES     9
#define NEAREST    0.4 /* m between two ends */
#define EXTENT     3.0 /* m: ends lie within this of the origin */
#define FASTEST    2.0 /* m/s */
#define TWO_PI     6.283185307179586
#define EXTRA_ENDS 3 /* beyond the least number, where it is open */

static double between(GRand *random, double least, double greatest)
{
    return least + (greatest - least) * g_rand_double_range(random, 0.05, 0.95);
}

/* The range that values are drawn from: the slider's, else what the hard range leaves about the default. */
static void ordinary_range(const TinkerPropertyType *property, double *least, double *greatest)
{
    const double standard = property->default_value[0], room = fmax(1.0, fabs(standard));
    *least = standard - room;
    *greatest = standard + room;
    if (property->flags & TINKER_HAS_SOFT_RANGE) {
        *least = property->soft_minimum;
        *greatest = property->soft_maximum;
    }
    if (property->flags & TINKER_HAS_MINIMUM && *least < property->hard_minimum) *least = property->hard_minimum;
    if (property->flags & TINKER_HAS_MAXIMUM && *greatest > property->hard_maximum) *greatest = property->hard_maximum;
    if (*least > *greatest) *least = *greatest = standard;
}

double kit_ordinary_value(const TinkerPropertyType *property, GRand *random)
{
    double least, greatest;
    ordinary_range(property, &least, &greatest);
    switch (property->kind) {
    case TINKER_KIND_SWITCH:
        return g_rand_boolean(random) ? 1.0 : 0.0;
    case TINKER_KIND_CHOICE:
        return g_rand_int_range(random, 0, property->choice_count);
    case TINKER_KIND_INTEGER:
        return ceil(least) >= floor(greatest) ? property->default_value[0]
                                              : floor(g_rand_double_range(random, ceil(least), floor(greatest) + 1.0));
    case TINKER_KIND_WAVEFORM:
        return between(random, -2.0, 2.0);
    default:
        return between(random, least, greatest);
    }
}

/* The lengths that a connector tends to are of the size of the distances between ends. */
static double draw_value(const TinkerPropertyType *property, GRand *random)
{
    const gboolean length = property->meaning == TINKER_MEANING_LENGTH || property->flags & TINKER_DEFAULT_AS_PLACED;
    const double value = kit_ordinary_value(property, random);
    double least, greatest;
    ordinary_range(property, &least, &greatest);
    if (!length || least > 4.0 || greatest < 0.5) return value;
    return between(random, fmax(least, 0.5), fmin(greatest, 4.0));
}

static void draw_columns(KitState *state, GRand *random)
{
    const TinkerBlockClass *block_class = state->block_class;
    state->columns = g_new0(double *, block_class->column_count + 1);
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *property = &block_class->properties[i];
        for (int32_t c = 0; c < tinker_kind_columns(property->kind); c++) {
            double *column = state->columns[block_class->first_columns[i] + c] = g_new(double, 2);
            const gboolean told = property->flags & (TINKER_READ_ONLY | TINKER_DERIVED);
            column[0] = told ? property->default_value[c & 1] : draw_value(property, random);
        }
    }
}

static TinkerPoint draw_point(GRand *random)
{
    return (TinkerPoint){between(random, -EXTENT, EXTENT), between(random, -EXTENT, EXTENT),
                         between(random, -FASTEST, FASTEST), between(random, -FASTEST, FASTEST)};
}

/* Points that keep their distance from one another. */
static TinkerPoint *draw_points(GRand *random, int32_t count)
{
    TinkerPoint *points = g_new0(TinkerPoint, count + 1);
    for (int32_t i = 0; i < count; i++) {
        gboolean apart = FALSE;
        for (int draw = 0; draw < MOST_DRAWS && !apart; draw++) {
            points[i] = draw_point(random);
            apart = TRUE;
            for (int32_t k = 0; k < i; k++)
                apart = apart && hypot(points[i].x - points[k].x, points[i].y - points[k].y) >= NEAREST;
        }
    }
    return points;
}

static double *draw_numbers(GRand *random, int32_t count, double greatest)
{
    double *values = g_new(double, count + 1);
    for (int32_t i = 0; i <= count; i++)
        values[i] = between(random, -greatest, greatest);
    return values;
}

/* Of a block that is itself a body, its centre is its one end. */
static int32_t draw_end_count(const TinkerBlockClass *block_class, GRand *random)
{
    const TinkerBlockType *type = block_class->type;
    if (block_class->physics != NULL && block_class->physics->body != NULL) return 1;
    if (type->most_ends == type->least_ends) return type->least_ends;
    const int32_t most = type->most_ends < 0 ? type->least_ends + EXTRA_ENDS : type->most_ends;
    return g_rand_int_range(random, MAX(type->least_ends, 1), MAX(most, 1) + 1);
}

static KitState *draw_instance(const TinkerBlockClass *block_class, GRand *random)
{
    KitState *state = g_new0(KitState, 1);
    state->block_class = block_class;
    state->count = 1;
    const int32_t ends = draw_end_count(block_class, random);
    const gboolean body = block_class->physics != NULL && block_class->physics->body != NULL;
    state->ends = body || block_class->type->least_ends == block_class->type->most_ends ? ends : -1;
    state->offsets = g_new0(int32_t, 2);
    state->offsets[1] = ends;
    draw_columns(state, random);
    state->points = draw_points(random, ends);
    state->lengths = draw_numbers(random, 1, 1);
    state->lengths[0] = between(random, 0.3, 4.0);
    state->rates = draw_numbers(random, 1, FASTEST);
    state->accelerations = draw_numbers(random, 2 * ends, 5);
    state->forces = draw_numbers(random, 2 * ends, 5);
    state->multipliers = draw_numbers(random, kit_state_rows(state), 5);
    state->contacts = draw_numbers(random, 4, 5);
    state->contacts[0] = fabs(state->contacts[0]);
    g_autoptr(GRand) turning = g_rand_copy(random); /* so that what is drawn from here on does not hang on them */
    state->poses = g_new0(TinkerPose, ends + 1);
    for (int32_t e = 0; e < ends; e++)
        state->poses[e] = (TinkerPose){between(turning, -4, 4), between(turning, -3, 3), between(turning, -5, 5)};
    state->torques = draw_numbers(turning, ends, 5);
    state->placed = draw_points(turning, ends);
    state->placed_columns = g_new0(double *, block_class->column_count + 1);
    for (int32_t c = 0; c < block_class->column_count; c++)
        state->placed_columns[c] = g_memdup2(state->columns[c], 2 * sizeof(double));
    state->has_angle = g_new0(int32_t, ends + 1);
    for (int32_t e = 0; e < ends; e++)
        state->has_angle[e] = g_rand_int_range(turning, 0, 8) > 0;
    for (int32_t e = 0; e < ends && tinker_block_class_speaks_of_angles(block_class); e++)
        if (!state->has_angle[e]) state->poses[e] = (TinkerPose){0, 0, 0};
    state->placed_poses = g_new0(TinkerPose, ends + 1);
    for (int32_t e = 0; e < ends; e++)
        if (state->has_angle[e])
            state->placed_poses[e] = (TinkerPose){between(turning, -4, 4), between(turning, -3, 3), 0};
    g_strlcpy(state->label, "ordinary values", sizeof state->label);
    return state;
}

static void add_bodies(KitState *state, const KitState *from)
{
    state->body_count = state->body_range = from->body_count;
    state->bodies = g_memdup2(from->bodies, (gsize)from->body_count * sizeof(TinkerPoint));
    state->masses = g_memdup2(from->masses, (gsize)from->body_count * sizeof(double));
    state->time = from->time;
}

/* Whether the block takes the instance: it prepares it, and every function answers. */
static gboolean is_taken(KitCheck *check, KitState *state, const GArray *functions, char **reason)
{
    const char *failure;
    kit_phase(check, "prepare or check");
    gboolean taken = kit_state_prepare(state, &failure) == TINKER_OK;
    for (guint i = 0; i < functions->len && taken; i++) {
        const KitFunction *function = &g_array_index(functions, KitFunction, i);
        g_autoptr(KitAnswer) answer = kit_call(check, function, state);
        taken = answer->status == TINKER_OK || (function->optional && answer->status == TINKER_RETRY_SMALLER);
        failure = answer->failure;
    }
    if (!taken) {
        g_free(*reason);
        *reason = g_strdup(failure != NULL ? failure : "it gives no reason");
    }
    return taken;
}

static gpointer joined(GPtrArray *parts, gsize offset, gsize (*entries)(const KitState *), gsize size)
{
    gsize whole = 0, at = 0;
    for (guint i = 0; i < parts->len; i++)
        whole += entries(parts->pdata[i]);
    char *array = g_malloc0((whole + 1) * size);
    for (guint i = 0; i < parts->len; i++) {
        const KitState *one = parts->pdata[i];
        const gsize count = entries(one);
        if (count > 0) memcpy(array + at * size, G_STRUCT_MEMBER(gpointer, one, offset), count * size);
        at += count;
    }
    return array;
}

static gsize one_each(const KitState *state)
{
    return 1;
}
static gsize ends_each(const KitState *state)
{
    return (gsize)kit_state_end_count(state);
}
static gsize pairs_each(const KitState *state)
{
    return 2 * ends_each(state);
}
static gsize rows_each(const KitState *state)
{
    return (gsize)kit_state_rows(state);
}
static gsize four_each(const KitState *state)
{
    return 4;
}

#define JOIN(parts, member, entries)                                                                                   \
    joined(parts, G_STRUCT_OFFSET(KitState, member), entries, sizeof *((KitState *)0)->member)

static KitState *join(GPtrArray *parts)
{
    const KitState *first = parts->pdata[0];
    KitState *state = g_new0(KitState, 1);
    *state = *first;
    state->count = (int32_t)parts->len;
    state->offsets = g_new0(int32_t, parts->len + 1);
    for (guint i = 0; i < parts->len; i++)
        state->offsets[i + 1] = state->offsets[i] + kit_state_end_count(parts->pdata[i]);
    state->columns = g_new0(double *, state->block_class->column_count + 1);
    state->placed_columns = g_new0(double *, state->block_class->column_count + 1);
    for (int32_t c = 0; c < state->block_class->column_count; c++) {
        state->columns[c] = g_new0(double, parts->len + 1);
        state->placed_columns[c] = g_new0(double, parts->len + 1);
        for (guint i = 0; i < parts->len; i++) {
            const KitState *one = parts->pdata[i];
            state->columns[c][i] = one->columns[c][0];
            state->placed_columns[c][i] = one->placed_columns[c][0];
        }
    }
    state->points = JOIN(parts, points, ends_each);
    state->lengths = JOIN(parts, lengths, one_each);
    state->rates = JOIN(parts, rates, one_each);
    state->accelerations = JOIN(parts, accelerations, pairs_each);
    state->forces = JOIN(parts, forces, pairs_each);
    state->multipliers = JOIN(parts, multipliers, rows_each);
    state->contacts = JOIN(parts, contacts, four_each);
    state->poses = JOIN(parts, poses, ends_each);
    state->torques = JOIN(parts, torques, ends_each);
    state->has_angle = JOIN(parts, has_angle, ends_each);
    state->placed = JOIN(parts, placed, ends_each);
    state->placed_poses = JOIN(parts, placed_poses, ends_each);
    state->scratch = NULL;
    add_bodies(state, first);
    return state;
}

/* The forces that graphs see are those that the block gives. */
static void fill_forces(KitCheck *check, KitState *state, const GArray *functions)
{
    const KitFunction *force = kit_function(functions, "force");
    if (force == NULL || force->outputs[0].extent != KIT_ENDS) return;
    g_autoptr(KitAnswer) answer = kit_call(check, force, state);
    if (answer->status != TINKER_OK) return;
    memcpy(state->forces, answer->values[0], answer->entries[0] * sizeof(double));
    if (force->output_count > 1) memcpy(state->torques, answer->values[1], answer->entries[1] * sizeof(double));
}

KitState *kit_state_new(KitCheck *check, int32_t count)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    g_autoptr(GPtrArray) parts = g_ptr_array_new_with_free_func((GDestroyNotify)kit_state_free);
    g_autofree char *reason = NULL;
    KitState common = {.body_count = BODIES, .time = between(check->random, 0.0, TWO_PI)};
    g_autofree TinkerPoint *bodies = common.bodies = draw_points(check->random, BODIES);
    g_autofree double *masses = common.masses = draw_numbers(check->random, BODIES, 2);
    for (int i = 0; i < BODIES; i++)
        masses[i] = 0.5 + fabs(masses[i]);
    (void)bodies;
    for (int draw = 0; draw < MOST_DRAWS + count && (int32_t)parts->len < count; draw++) {
        KitState *one = draw_instance(check->block_class, check->random);
        add_bodies(one, &common);
        if (is_taken(check, one, functions, &reason))
            g_ptr_array_add(parts, one);
        else
            kit_state_free(one);
    }
    if ((int32_t)parts->len < count) {
        kit_fail(check, "it refuses nearly all values within its declared ranges: %s", reason);
        return NULL;
    }
    KitState *state = join(parts);
    const char *failure;
    if (kit_state_prepare(state, &failure) != TINKER_OK) {
        kit_fail(check, "it takes instances one by one, but not together: %s", failure != NULL ? failure : "no reason");
        kit_state_free(state);
        return NULL;
    }
    fill_forces(check, state, functions);
    return state;
}
