/* Forces whose stiffness or damping varies in time. With F the force of a block, it varies where F(x + d, t) - F(x, t)
 * - F(x + d, 0) + F(x, 0) is not 0: a change of places and speeds does something else at another time. What is added to
 * a force in time alone, as a waveform, leaves that 0. */
#include "physics/linearise/left-out.h"

#include <float.h>
#include <math.h>

#include "physics/force/forces.h"
#include "physics/linearise/tolerances.h"
#include "physics/model/state.h"

/* s: without common multiples, so that a law that comes again is not met at one phase each time; late ones for laws
 * that set in late. */
static const double times[] = {1e-3, 0.0137, 0.1, 0.37, 1.13, 2.9, 7.3, 31, 117};

typedef enum { LINES, ELEMENTS, FIELDS } Kind;

/* What a block does at one state: so many forces. Borrowed, until the next are asked for. */
typedef struct {
    const double *force, *torque;
    int32_t forces, torques;
} Answer;

static TinkerStatus ask_line(TinkerModel *model, const TinkerAskedBatch *asked, int32_t row, Answer *answer)
{
    TinkerBatch view = tinker_model_view(model, asked->batch, row, 1, model->column_views);
    TinkerLineChunk chunk;
    const TinkerStatus status = tinker_model_ask_lines(model, asked->batch, asked->end_points + 2 * row, &view, &chunk);
    *answer = (Answer){.force = chunk.tension, .forces = 1};
    return status;
}

static TinkerStatus ask_element(TinkerModel *model, const TinkerAskedBatch *asked, int32_t row, Answer *answer)
{
    const int32_t *ends = asked->batch->end_offsets + row;
    TinkerElementForces forces;
    const TinkerStatus status =
        tinker_model_ask_element(model, asked->batch, asked->end_points + ends[0], row, 1, &forces);
    if (status != TINKER_OK) return status;
    const int32_t count = ends[1] - ends[0];
    *answer = (Answer){forces.force, forces.torque, 2 * count, forces.turns != NULL ? count : 0};
    return status;
}

static TinkerStatus ask(TinkerModel *model, Kind kind, const TinkerAskedBatch *asked, int32_t row, Answer *answer)
{
    if (kind == LINES) return ask_line(model, asked, row, answer);
    if (kind == ELEMENTS) return ask_element(model, asked, row, answer);
    *answer = (Answer){.forces = 2 * model->bodies};
    return tinker_model_ask_field(model, asked->batch, row, 1, &answer->force);
}

/* The state that differences are taken between: where the model is made linear, at rest, and one beside it. */
typedef struct {
    double *q[2], *v[2];
    GArray *forces[4]; /* of double: of both states at t = 0, and at another time */
} Probe;

/* FALSE where a force cannot be worked out. */
static gboolean take(TinkerModel *model, Probe *probe, Kind kind, const TinkerAskedBatch *asked, int32_t row, int which)
{
    Answer answer;
    tinker_model_set_state(model, probe->q[which % 2], probe->v[which % 2]);
    if (ask(model, kind, asked, row, &answer) != TINKER_OK) return FALSE;
    g_array_set_size(probe->forces[which], 0);
    g_array_append_vals(probe->forces[which], answer.force, (guint)answer.forces);
    if (answer.torques > 0) g_array_append_vals(probe->forces[which], answer.torque, (guint)answer.torques);
    return TRUE;
}

static gboolean differs(const Probe *probe)
{
    double change = 0, difference = 0, largest = 0;
    for (guint i = 0; i < probe->forces[0]->len; i++) {
        double f[4];
        for (int k = 0; k < 4; k++) {
            f[k] = g_array_index(probe->forces[k], double, i);
            largest = fmax(largest, fabs(f[k]));
        }
        difference = fmax(difference, fmax(fabs(f[1] - f[0]), fabs(f[3] - f[2])));
        change = fmax(change, fabs(f[3] - f[2] - f[1] + f[0]));
    }
    return change > fmax(TINKER_VARIES * difference, 64 * DBL_EPSILON * largest);
}

static gboolean varies(TinkerModel *model, Probe *probe, Kind kind, TinkerAskedBatch *asked, int32_t row)
{
    gboolean found = FALSE;
    if (!take(model, probe, kind, asked, row, 0) || !take(model, probe, kind, asked, row, 1)) return FALSE;
    for (gsize i = 0; i < G_N_ELEMENTS(times) && !found; i++) {
        model->time = times[i];
        if (asked->batch->evaluator_count > 0) tinker_block_batch_enter_behind(asked->batch, times[i]);
        if (asked->batch->waveforms > 0) tinker_block_batch_set_time(asked->batch, times[i]);
        found = take(model, probe, kind, asked, row, 2) && take(model, probe, kind, asked, row, 3) && differs(probe);
    }
    model->time = 0;
    if (asked->batch->evaluator_count > 0) tinker_block_batch_enter_behind(asked->batch, 0);
    if (asked->batch->waveforms > 0) tinker_block_batch_set_steady(asked->batch);
    return found;
}

/* Away from the state by a small part of the extent, to every side by another share, so that nothing cancels. */
static void probe_init(Probe *probe, const TinkerModel *model, const double *q, double extent)
{
    const gsize n = (gsize)model->coordinates;
    for (int k = 0; k < 2; k++) {
        probe->q[k] = g_memdup2(q, MAX(n, 1) * sizeof(double));
        probe->v[k] = g_new0(double, MAX(n, 1));
    }
    for (int k = 0; k < 4; k++)
        probe->forces[k] = g_array_new(FALSE, FALSE, sizeof(double));
    for (gsize i = 0; i < n; i++) {
        const double share = 0.5 + fmod(0.6180339887498949 * (double)(i + 1), 1.0);
        probe->q[1][i] += TINKER_PROBE_STEP * extent * share;
        probe->v[1][i] = TINKER_PROBE_STEP * extent * (2 - share);
    }
}

static void probe_clear(Probe *probe)
{
    for (int k = 0; k < 2; k++) {
        g_free(probe->q[k]);
        g_free(probe->v[k]);
    }
    for (int k = 0; k < 4; k++)
        g_array_unref(probe->forces[k]);
}

void tinker_linearise_add_varying(TinkerModel *model, const double *q, double extent, GArray *list)
{
    const GArray *all[] = {model->asked_lines, model->asked_forces, model->asked_fields};
    Probe probe;
    probe_init(&probe, model, q, extent);
    for (Kind kind = LINES; kind <= FIELDS; kind++) {
        for (guint i = 0; i < all[kind]->len; i++) {
            TinkerAskedBatch *asked = &g_array_index(all[kind], TinkerAskedBatch, i);
            for (int32_t row = 0; row < asked->batch->count; row++) {
                const TinkerLeftOut out = {TINKER_LEFT_OUT_VARIATION, asked->batch->ids[row], TINKER_NO_BLOCK};
                if (varies(model, &probe, kind, asked, row)) g_array_append_val(list, out);
            }
        }
    }
    model->failure = ""; /* a law that has no value at one of these times fails nothing */
    tinker_model_set_state(model, probe.q[0], probe.v[0]);
    probe_clear(&probe);
}
