/* Start positions that a constraint can have: the bodies at its ends are moved until its rows hold.
 *
 * Gauss-Newton steps of least norm, dx = -J^T (J J^T)^-1 g, over the places of all ends; rows that hold as g <= 0 are
 * left alone where they do. Rows that say the same twice make J J^T singular: a small share of its trace on the
 * diagonal bears that. Each step looks at the scene anew, since lengths that are taken as placed follow the ends. */
#include "conformance/probe/scene-start.h"

#include <math.h>

#include "conformance/probe/state.h"
#include "scene/frame/frame.h"

#define STEPS     40
#define NEAR      1e-10 /* of g; the host corrects what is left */
#define SINGULAR  1e-12 /* of the trace */
#define MOST_ROWS 64

/* The block as an instance of its own, as it stands at t = 0 and at rest. (transfer full) */
static KitState *state_of(TinkerFrame *frame, const TinkerScene *scene, TinkerBlockId block)
{
    KitState *state = g_new0(KitState, 1);
    const TinkerBlockClass *c = state->block_class = tinker_scene_block_class(scene, block);
    const int32_t ends = tinker_scene_end_count(scene, block);
    state->count = 1;
    state->ends = c->type->least_ends == c->type->most_ends ? ends : -1;
    state->offsets = g_new0(int32_t, 2);
    state->offsets[1] = ends;
    state->columns = g_new0(double *, c->column_count + 1);
    state->placed_columns = g_new0(double *, c->column_count + 1);
    for (int32_t k = 0; k < c->column_count; k++) {
        state->columns[k] = g_new0(double, 2);
        state->columns[k][0] = tinker_frame_column(frame, block, k);
        state->placed_columns[k] = g_memdup2(state->columns[k], 2 * sizeof(double));
    }
    state->points = g_new0(TinkerPoint, ends + 1);
    for (int32_t e = 0; e < ends; e++) {
        double place[2];
        tinker_frame_end(frame, tinker_scene_end(scene, block, e), place);
        state->points[e] = (TinkerPoint){place[0], place[1], 0, 0};
    }
    state->lengths = g_new0(double, 2);
    state->rates = g_new0(double, 2);
    state->accelerations = g_new0(double, 2 * ends + 1);
    state->forces = g_new0(double, 2 * ends + 1);
    state->multipliers = g_new0(double, c->physics->constraint->rows + 1);
    state->contacts = g_new0(double, 5);
    state->poses = g_new0(TinkerPose, ends + 1);
    state->torques = g_new0(double, ends + 1);
    state->has_angle = g_new0(int32_t, ends + 1);
    for (int32_t e = 0; e < ends; e++) {
        double x, y;
        const TinkerBlockId on = tinker_scene_end(scene, block, e).block;
        state->has_angle[e] = tinker_block_class_has_angle(tinker_scene_block_class(scene, on));
        tinker_frame_centre(frame, on, &x, &y, &state->poses[e].angle);
    }
    state->placed = g_memdup2(state->points, ((gsize)ends + 1) * sizeof(TinkerPoint));
    state->placed_poses = g_memdup2(state->poses, ((gsize)ends + 1) * sizeof(TinkerPose));
    g_strlcpy(state->label, "the start of a run", sizeof state->label);
    return state;
}

/* Solves the symmetric, positive definite a x = b of n rows in place of b: Cholesky's way, without pivots. */
static gboolean solve(double *a, double *b, int n)
{
    for (int i = 0; i < n; i++) {
        for (int k = 0; k <= i; k++) {
            double sum = a[i * n + k];
            for (int j = 0; j < k; j++)
                sum -= a[i * n + j] * a[k * n + j];
            if (i == k && !(sum > 0)) return FALSE;
            a[i * n + k] = i == k ? sqrt(sum) : sum / a[k * n + k];
        }
        for (int j = 0; j < i; j++)
            b[i] -= a[i * n + j] * b[j];
        b[i] /= a[i * n + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++)
            b[i] -= a[j * n + i] * b[j];
        b[i] /= a[i * n + i];
    }
    return TRUE;
}

/* What the rows miss, with the rows of their Jacobian in `active`. */
static double find_active(const KitState *state, const KitAnswer *answer, double *g, const double **active, int *count)
{
    const TinkerConstraint *constraint = state->block_class->physics->constraint;
    const int32_t ends = kit_state_end_count(state);
    double worst = 0;
    *count = 0;
    for (int32_t r = 0; r < constraint->rows; r++) {
        if (constraint->unilateral && answer->values[0][r] <= 0) continue;
        g[*count] = -answer->values[0][r];
        active[(*count)++] = answer->values[1] + 2 * r * ends;
        worst = fmax(worst, fabs(answer->values[0][r]));
    }
    return worst;
}

/* Where the ends are to go; FALSE where the rows say nothing of it. */
static gboolean step_ends(const KitState *state, double *g, const double *const *active, int count)
{
    const int32_t size = 2 * kit_state_end_count(state);
    double square[MOST_ROWS * MOST_ROWS], trace = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < count; k++) {
            double sum = 0;
            for (int32_t j = 0; j < size; j++)
                sum += active[i][j] * active[k][j];
            square[i * count + k] = sum;
            if (i == k) trace += sum;
        }
    for (int i = 0; i < count; i++)
        square[i * count + i] += SINGULAR * trace;
    if (!solve(square, g, count)) return FALSE;
    for (int32_t j = 0; j < size; j++) {
        double by = 0;
        for (int i = 0; i < count; i++)
            by += active[i][j] * g[i];
        TinkerPoint *p = &state->points[j / 2];
        *(j % 2 == 0 ? &p->x : &p->y) += by;
    }
    return TRUE;
}

static void place_bodies(TinkerScene *scene, TinkerBlockId block, const KitState *from, const KitState *to)
{
    for (int32_t e = 0; e < kit_state_end_count(from); e++) {
        const TinkerBlockId body = tinker_scene_end(scene, block, e).block;
        const TinkerBlockClass *c = tinker_scene_block_class(scene, body);
        const int32_t column = tinker_block_class_meaning_column(c, TINKER_MEANING_POSITION);
        const double place[2] = {tinker_scene_get(scene, body, column) + to->points[e].x - from->points[e].x,
                                 tinker_scene_get(scene, body, column + 1) + to->points[e].y - from->points[e].y};
        tinker_scene_set(scene, body, c->meanings[TINKER_MEANING_POSITION], place, NULL);
    }
}

/* One step; FALSE where there is none to be made: all hold, or the block does not answer. */
static gboolean step_scene(KitCheck *check, const KitFunction *rows, TinkerScene *scene, TinkerBlockId block)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return FALSE;
    g_autoptr(KitState) state = state_of(frame, scene, block);
    const char *failure;
    kit_phase(check, "prepare or check at %s", state->label);
    if (kit_state_prepare(state, &failure) != TINKER_OK) return FALSE;
    g_autoptr(KitAnswer) answer = kit_call(check, rows, state);
    g_autoptr(KitState) moved = kit_state_copy(state);
    double g[MOST_ROWS];
    const double *active[MOST_ROWS];
    int count;
    if (answer->status != TINKER_OK || !(find_active(state, answer, g, active, &count) > NEAR)) return FALSE;
    if (!step_ends(moved, g, active, count)) return FALSE;
    place_bodies(scene, block, state, moved);
    return TRUE;
}

void kit_fit_start(KitCheck *check, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerPhysics *physics = tinker_scene_block_class(scene, block)->physics;
    if (physics == NULL || physics->constraint == NULL || physics->constraint->rows > MOST_ROWS) return;
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *rows = kit_function(functions, "rows_at");
    for (int i = 0; i < STEPS && step_scene(check, rows, scene, block); i++) {
    }
}
