/* States: what they own, copies and slices. */
#include "conformance/probe/state.h"

#include "conformance/probe/sample-laws.h"

#include <string.h>

#include "plugin/call/process-state.h"

static gpointer part(gconstpointer array, gsize first, gsize count, gsize size)
{
    gpointer copy = g_malloc0((count + 1) * size);
    if (count > 0) memcpy(copy, (const char *)array + first * size, count * size);
    return copy;
}

static double *numbers(const double *array, int32_t first, int32_t count)
{
    return part(array, (gsize)first, (gsize)count, sizeof *array);
}

static double **cut_columns(const KitState *cut, double *const *from, int32_t first)
{
    const int32_t columns = cut->block_class->column_count;
    double **copy = g_new0(double *, columns + 1);
    for (int32_t c = 0; c < columns; c++)
        copy[c] = numbers(from[c], first, cut->count);
    return copy;
}

KitState *kit_state_slice(const KitState *state, int32_t first, int32_t count)
{
    KitState *cut = g_new(KitState, 1);
    *cut = *state;
    const int32_t from = state->offsets[first], ends = state->offsets[first + count] - from;
    const int32_t rows = kit_state_rows(state);
    const TinkerPhysics *physics = state->block_class->physics;
    cut->count = count;
    cut->first = state->first + first;
    cut->offsets = part(state->offsets, (gsize)first, (gsize)count + 1, sizeof(int32_t));
    for (int32_t i = 0; i <= count; i++)
        cut->offsets[i] -= from;
    cut->columns = cut_columns(cut, state->columns, first);
    cut->placed_columns = cut_columns(cut, state->placed_columns, first);
    cut->points = part(state->points, (gsize)from, (gsize)ends, sizeof(TinkerPoint));
    cut->lengths = numbers(state->lengths, first, count);
    cut->rates = numbers(state->rates, first, count);
    cut->accelerations = numbers(state->accelerations, 2 * from, 2 * ends);
    cut->forces = numbers(state->forces, 2 * from, 2 * ends);
    cut->poses = part(state->poses, (gsize)from, (gsize)ends, sizeof(TinkerPose));
    cut->placed = part(state->placed, (gsize)from, (gsize)ends, sizeof(TinkerPoint));
    cut->placed_poses = part(state->placed_poses, (gsize)from, (gsize)ends, sizeof(TinkerPose));
    cut->has_angle = part(state->has_angle, (gsize)from, (gsize)ends, sizeof(int32_t));
    cut->torques = numbers(state->torques, from, ends);
    cut->multipliers = numbers(state->multipliers, rows * first, rows * count);
    cut->contacts = numbers(state->contacts, 4 * first, 4 * count);
    cut->bodies = part(state->bodies, 0, (gsize)state->body_count, sizeof(TinkerPoint));
    cut->masses = numbers(state->masses, 0, state->body_count);
    const gsize scratch = physics == NULL ? 0 : (gsize)physics->scratch_size;
    cut->scratch = state->scratch == NULL ? NULL : part(state->scratch, 0, scratch, 1);
    return cut;
}

KitState *kit_state_copy(const KitState *state)
{
    return kit_state_slice(state, 0, state->count);
}

void kit_state_free(KitState *state)
{
    if (state == NULL) return;
    for (int32_t c = 0; c < state->block_class->column_count; c++) {
        g_free(state->columns[c]);
        g_free(state->placed_columns[c]);
    }
    g_free(state->columns);
    g_free(state->placed_columns);
    g_free(state->has_angle);
    g_free(state->offsets);
    g_free(state->points);
    g_free(state->lengths);
    g_free(state->rates);
    g_free(state->accelerations);
    g_free(state->forces);
    g_free(state->poses);
    g_free(state->placed);
    g_free(state->placed_poses);
    g_free(state->torques);
    g_free(state->multipliers);
    g_free(state->contacts);
    g_free(state->bodies);
    g_free(state->masses);
    g_free(state->scratch);
    g_free(state);
}

TinkerBatch kit_state_view(const KitState *state, const double **columns)
{
    for (int32_t c = 0; c < state->block_class->column_count; c++)
        columns[c] = state->columns[c];
    const gboolean angles = tinker_block_class_speaks_of_angles(state->block_class);
    TinkerBatch view = {
        .struct_size = sizeof(TinkerBatch),
        .first = state->first,
        .count = state->count,
        .ends = state->ends,
        .end_offsets = state->ends < 0 ? state->offsets : NULL,
        .columns = columns,
        .scratch = state->scratch,
        .time = state->time,
        .origin = {state->origin[0], state->origin[1]},
        .failed_instance = -1,
        .poses = angles ? state->poses : NULL,
        .placed = angles ? state->placed : NULL,
        .placed_poses = angles ? state->placed_poses : NULL,
        .has_angle = angles ? state->has_angle : NULL,
        .placed_columns = angles ? (const double *const *)state->placed_columns : NULL,
    };
    view.laws = kit_sample_laws(state->block_class, &view.law_count);
    view.point_lists = kit_sample_points(state->block_class, &view.point_list_count);
    return view;
}

TinkerStatus kit_state_prepare(KitState *state, const char **failure)
{
    const TinkerPhysics *physics = state->block_class->physics;
    *failure = NULL;
    if (physics == NULL) return TINKER_OK;
    g_free(state->scratch);
    state->scratch = physics->scratch_size > 0 ? g_malloc0((gsize)physics->scratch_size) : NULL;
    g_autofree const double **columns = g_new0(const double *, state->block_class->column_count + 1);
    TinkerBatch view = kit_state_view(state, columns);
    TinkerStatus status = physics->prepare == NULL ? TINKER_OK : tinker_prepare(physics, &view);
    if (status == TINKER_OK && physics->constraint != NULL && physics->constraint->check != NULL)
        status = physics->constraint->check(&view);
    *failure = view.failure;
    return status;
}

static void describe_property(const KitState *state, int32_t property, int32_t instance, GString *text)
{
    const TinkerBlockClass *block_class = state->block_class;
    const int32_t first = block_class->first_columns[property];
    const int32_t columns = tinker_kind_columns(block_class->properties[property].kind);
    if (columns == 0) return;
    g_string_append_printf(text, "%s%s = ", text->len > 0 ? ", " : "", block_class->properties[property].id);
    for (int32_t c = 0; c < columns; c++)
        g_string_append_printf(text, "%s%.6g", c > 0 ? " " : "", state->columns[first + c][instance]);
}

/* All instances act on one another's bodies: those of a field. */
static char *describe_together(const KitState *state)
{
    GString *text = g_string_new(NULL);
    if (state->count > 1) g_string_append_printf(text, "%d instances together", state->count);
    for (int32_t i = 0; state->count == 1 && i < state->block_class->property_count; i++)
        describe_property(state, i, 0, text);
    if (text->len == 0) g_string_append(text, "it has no properties");
    return g_string_free(text, FALSE);
}

char *kit_state_describe_body(const KitState *state, int32_t body)
{
    g_autofree char *instances = describe_together(state);
    const TinkerPoint *p = &state->bodies[body];
    return g_strdup_printf("%s, body %d of %.6g kg at (%.6g, %.6g) with velocity (%.6g, %.6g)", instances, body,
                           state->masses[body], p->x, p->y, p->vx, p->vy);
}

char *kit_state_describe(const KitState *state, int32_t instance)
{
    if (instance < 0 || instance >= state->count) return describe_together(state);
    GString *text = g_string_new(NULL);
    for (int32_t i = 0; i < state->block_class->property_count; i++)
        describe_property(state, i, instance, text);
    const TinkerPhysics *physics = state->block_class->physics;
    if (physics != NULL && physics->line_law != NULL) {
        g_string_append_printf(text, "%sL = %.6g, rate = %.6g", text->len > 0 ? ", " : "", state->lengths[instance],
                               state->rates[instance]);
        return g_string_free(text, FALSE);
    }
    for (int32_t e = state->offsets[instance]; e < state->offsets[instance + 1]; e++) {
        const TinkerPoint *p = &state->points[e];
        g_string_append_printf(text, "%send %d at (%.6g, %.6g) with velocity (%.6g, %.6g)", text->len > 0 ? ", " : "",
                               e - state->offsets[instance], p->x, p->y, p->vx, p->vy);
        if (tinker_block_class_speaks_of_angles(state->block_class))
            g_string_append_printf(text, " turned by %.6g rad at %.6g rad/s", state->poses[e].angle,
                                   state->poses[e].rate);
    }
    return g_string_free(text, FALSE);
}

char *kit_entry_name(const KitOutput *output, const KitState *state, gsize entry)
{
    if (output->extent == KIT_ONCE) return g_strdup("the whole");
    if (output->extent == KIT_BODIES) return g_strdup_printf("body %d", state->first_body + (int32_t)entry);
    return g_strdup_printf("instance %d", kit_output_instance(output, state, entry));
}

char *kit_entry_describe(const KitOutput *output, const KitState *state, gsize entry)
{
    if (output->extent == KIT_BODIES) return kit_state_describe_body(state, state->first_body + (int32_t)entry);
    return kit_state_describe(state, kit_output_instance(output, state, entry));
}
