/* A scene shifted, or turned about the origin: its states, its properties, and the answers that are expected then. */
#include "conformance/rule/rules-symmetry-private.h"

static void change_place(const SymmetryChange *change, double *x, double *y)
{
    const double from_x = *x, from_y = *y;
    if (!change->turn) {
        *x += change->by[0];
        *y += change->by[1];
        return;
    }
    *x = change->by[0] * from_x - change->by[1] * from_y;
    *y = change->by[1] * from_x + change->by[0] * from_y;
}

static void change_direction(const SymmetryChange *change, double *x, double *y)
{
    if (change->turn) change_place(change, x, y);
}

void symmetry_change_points(const SymmetryChange *change, TinkerPoint *points, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        change_place(change, &points[i].x, &points[i].y);
        change_direction(change, &points[i].vx, &points[i].vy);
    }
}

void symmetry_change_property(KitState *state, int32_t number, const SymmetryChange *change)
{
    const TinkerPropertyType *property = &state->block_class->properties[number];
    double *const *columns = state->columns + state->block_class->first_columns[number];
    for (int32_t i = 0; i < state->count; i++) {
        if (property->kind == TINKER_KIND_VECTOR)
            change_place(change, &columns[0][i], &columns[1][i]);
        else
            columns[0][i] += change->angle;
    }
}

void symmetry_change_answer(const KitFunction *function, KitAnswer *answer, const SymmetryChange *change)
{
    for (int k = 0; k < function->output_count; k++)
        for (gsize i = 0; function->outputs[k].width == 2 && i + 1 < answer->entries[k]; i += 2)
            change_direction(change, &answer->values[k][i], &answer->values[k][i + 1]);
}

void symmetry_change_joint_rows(const KitFunction *function, const KitState *state, KitAnswer *answer,
                                const SymmetryChange *change)
{
    const int32_t rows = kit_state_rows(state);
    for (int k = 0; k < function->output_count; k++) {
        const gsize all = answer->entries[k] / (gsize)MAX(state->count, 1), one = all / (gsize)rows;
        for (int32_t i = 0; i < state->count; i++)
            for (gsize c = 0; c < one; c++) {
                double *first = &answer->values[k][(gsize)i * all + c];
                change_direction(change, first, first + one);
            }
    }
}
