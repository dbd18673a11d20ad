/* Differences are central, of the widths h, 2 h and 4 h, extrapolated from two neighbours each to h^4. The first of
 * these is wrong by a fifteenth of how far the two are apart where the function is smooth (Richardson). So where they
 * are further apart than is allowed nothing is told: there is a kink between, or the function bends within a few
 * widths, as the square root near 0 and a friction that is rounded off do. */
#include "conformance/probe/differences.h"

#include <math.h>

#define WIDTH  2e-3
#define PLACES 7

/* In widths; the middle one is the state itself. */
static const double places[PLACES] = {-4, -2, -1, 0, 1, 2, 4};

void kit_move_line(KitState *state, int which, double by)
{
    for (int32_t i = 0; i < state->count; i++)
        *(which == 0 ? &state->lengths[i] : &state->rates[i]) += by;
}

static void shift_point(TinkerPoint *p, int which, double by)
{
    *(which == 0 ? &p->x : which == 1 ? &p->y : which == 2 ? &p->vx : &p->vy) += by;
}

void kit_move_body(KitState *state, int which, double by)
{
    shift_point(&state->bodies[which / 4], which % 4, by);
}

void kit_move_end(KitState *state, int which, double by)
{
    for (int32_t i = 0; i < state->count; i++)
        if (state->offsets[i] + which / 2 < state->offsets[i + 1])
            shift_point(&state->points[state->offsets[i] + which / 2], which % 2, by);
}

void kit_turn_end(KitState *state, int which, double by)
{
    for (int32_t i = 0; i < state->count; i++)
        if (state->offsets[i] + which < state->offsets[i + 1]) state->poses[state->offsets[i] + which].angle += by;
}

void kit_go_on(KitState *state, int which, double by)
{
    const TinkerBlockClass *c = state->block_class;
    state->time += by;
    for (int32_t k = 0; k < c->property_count; k++) {
        if (c->properties[k].kind != TINKER_KIND_WAVEFORM) continue;
        double *const *wave = state->columns + c->first_columns[k];
        for (int32_t i = 0; i < state->count; i++) {
            wave[0][i] += by * (wave[1][i] + 0.5 * by * wave[2][i]);
            wave[1][i] += by * wave[2][i];
        }
    }
    for (int32_t e = 0; which == 1 && e < kit_state_end_count(state); e++) {
        state->points[e].x += by * state->points[e].vx;
        state->points[e].y += by * state->points[e].vy;
        state->poses[e].angle += by * state->poses[e].rate;
    }
}

/* The difference over `k` places to both sides of the middle one. */
static double difference(const double f[PLACES], int k, int degree)
{
    const int middle = PLACES / 2;
    const double h = places[middle + k] * WIDTH;
    return degree == 1 ? (f[middle + k] - f[middle - k]) / (2 * h)
                       : ((f[middle + k] - f[middle]) - (f[middle] - f[middle - k])) / (h * h);
}

static double slope_of(const double f[PLACES], int degree, KitNearness nearness)
{
    const double at_1 = difference(f, 1, degree), at_2 = difference(f, 2, degree), at_4 = difference(f, 3, degree);
    const double near = (4 * at_1 - at_2) / 3, far = (4 * at_2 - at_4) / 3;
    const double size = fmax(fabs(near), nearness.floor * fabs(f[PLACES / 2]));
    return fabs(near - far) <= 5 * nearness.close * size ? near : NAN; // so the error is a third of what is allowed
}

double *kit_slopes(KitCheck *check, const KitFunction *function, const KitState *state, KitMove move, int which,
                   int degree, KitNearness nearness)
{
    g_autoptr(GPtrArray) answers = g_ptr_array_new_with_free_func((GDestroyNotify)kit_answer_free);
    for (gsize i = 0; i < PLACES; i++) {
        g_autoptr(KitState) moved = kit_state_copy(state);
        move(moved, which, places[i] * WIDTH);
        KitAnswer *answer = kit_call_well(check, function, moved);
        if (answer == NULL) return NULL;
        g_ptr_array_add(answers, answer);
    }
    const gsize entries = ((KitAnswer *)answers->pdata[0])->entries[0];
    double *result = g_new(double, entries + 1);
    for (gsize i = 0; i < entries; i++) {
        double f[PLACES];
        for (int k = 0; k < PLACES; k++)
            f[k] = ((KitAnswer *)answers->pdata[k])->values[0][i];
        result[i] = slope_of(f, degree, nearness);
    }
    return result;
}
