#include "honest-run.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"
#include "scene/read/scene-json.h"

#define CLAIMS         20
#define TIMES_A_CLAIM  16
#define TRUE_TOLERANCE 1e-13
/* Of the duration. */
#define FIRST_MOMENT 1e-6
/* Errors below this share of the scales are rounding. */
#define FLOOR (100 * DBL_EPSILON)
/* Of a claim: so well has the truth to be known. */
#define KNOWN             0.25
#define COLUMNS_OF_BODY   4
#define COLUMNS_OF_ANCHOR 2

/* Records ---------------------------------------------------------------------------------------------------------- */

/* Where the rows of a run go, and what it claims at each of them. */
typedef struct {
    double *rows, *claimed; /* either may be NULL */
    guint columns;
    gsize count;
} Record;

static gboolean keep(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Record *record = data;
    if (record->rows != NULL)
        memcpy(record->rows + record->count * record->columns, values, record->columns * sizeof(double));
    if (record->claimed != NULL) record->claimed[record->count] = tinker_simulation_error(simulation);
    record->count++;
    return TRUE;
}

/* Runs the scene at these times. *believed, where it is not NULL, gets the time (s) up to which the record is to be
 * believed and the motion predictable. */
static gboolean run(const HonestyTruth *truth, const HonestyMethod *method, const double *at, gsize count,
                    gboolean estimate, Record *record, double *believed, GError **error)
{
    g_autoptr(TinkerModel) model = tinker_model_new(truth->scene, error);
    if (model == NULL) return FALSE;
    TinkerRunOptions options = tinker_run_options_of(truth->scene);
    options.method = method->method;
    options.tolerance = method->tolerance;
    options.step = method->steps_in_a_turn > 0 ? 1 / (truth->text->rate * method->steps_in_a_turn) : options.step;
    options.at = at;
    options.at_count = count;
    options.estimate = estimate;
    g_autoptr(GArray) columns = tinker_columns_new();
    if (!tinker_columns_add_list(columns, truth->scene, truth->columns->str, error)) return FALSE;
    record->columns = columns->len;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, error);
    if (simulation == NULL) return FALSE;
    gboolean done = tinker_simulation_run(simulation, columns, keep, record, error);
    const TinkerSummary *summary = tinker_simulation_summary(simulation);
    if (believed != NULL) *believed = fmin(summary->valid_until, summary->predictable_until);
    return done;
}

/* Scales ----------------------------------------------------------------------------------------------------------- */

static void widen(double box[4], const double place[2])
{
    for (int k = 0; k < 2; k++) {
        box[k] = fmin(box[k], place[k]);
        box[2 + k] = fmax(box[2 + k], place[k]);
    }
}

/* How far bodies and the anchors that hold them have reached, and how fast bodies have been. */
static void find_scales(HonestyTruth *truth, guint columns)
{
    double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY}, speed = 0;
    for (gsize i = 0; i < truth->times; i++) {
        const double *body = truth->truth + i * columns;
        for (int b = 0; b < truth->text->bodies; b++, body += COLUMNS_OF_BODY) {
            widen(box, body);
            speed = fmax(speed, hypot(body[2], body[3]));
        }
        for (int a = 0; a < truth->text->anchors; a++, body += COLUMNS_OF_ANCHOR)
            widen(box, body);
        truth->extent[i] = hypot(box[2] - box[0], box[3] - box[1]);
        truth->speed[i] = speed;
    }
}

/* Time by time, the largest error of `rows` against the truth so far, in units of the scales then. */
static void find_errors(const HonestyTruth *truth, const double *rows, guint columns, double *errors)
{
    double apart = 0, faster = 0;
    for (gsize i = 0; i < truth->times; i++) {
        const double *is = rows + i * columns, *ought = truth->truth + i * columns;
        for (int b = 0; b < truth->text->bodies; b++, is += COLUMNS_OF_BODY, ought += COLUMNS_OF_BODY) {
            apart = fmax(apart, hypot(is[0] - ought[0], is[1] - ought[1]));
            faster = fmax(faster, hypot(is[2] - ought[2], is[3] - ought[3]));
        }
        double places = truth->extent[i] > 0 ? apart / truth->extent[i] : 0;
        double speeds = truth->speed[i] > 0 ? faster / truth->speed[i] : 0;
        errors[i] = fmax(places, speeds);
    }
}

/* Truth ------------------------------------------------------------------------------------------------------------ */

static int by_value(const void *left, const void *right)
{
    double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

/* Claims are made at times that nothing in the scene knows of. Errors are found at those and at times between them, a
 * quarter of which lie in the first moments, whatever those are: that is where stiff motion is fastest. */
static void draw_times(HonestyTruth *truth, guint32 seed)
{
    g_autoptr(GRand) dice = g_rand_new_with_seed(seed);
    for (gsize i = 0; i < truth->times; i++) {
        double share = g_rand_double(dice);
        gboolean early = i >= truth->claims && i % 4 == 0;
        truth->at[i] = truth->text->duration * (early ? pow(FIRST_MOMENT, share) : share);
    }
    truth->at[truth->times - 1] = 0;
    memcpy(truth->claimed_at, truth->at, truth->claims * sizeof(double));
    qsort(truth->claimed_at, truth->claims, sizeof(double), by_value);
    qsort(truth->at, truth->times, sizeof(double), by_value);
}

static GString *columns_of(const RandomScene *text)
{
    GString *columns = g_string_new(NULL);
    for (int i = 0; i < text->bodies; i++)
        g_string_append_printf(columns, "%sm%d.x,m%d.y,m%d.vx,m%d.vy", i > 0 ? "," : "", i, i, i, i);
    for (int i = 0; i < text->anchors; i++)
        g_string_append_printf(columns, ",A%d.x,A%d.y", i, i);
    return columns;
}

static gboolean find_truth(HonestyTruth *truth, GError **error)
{
    static const HonestyMethod truest = {"truth", "dop853", TRUE_TOLERANCE, 0};
    static const HonestyMethod second = {"second", "dopri5", TRUE_TOLERANCE, 0};
    Record record = {truth->truth, NULL, 0, 0}, other = {truth->other, NULL, 0, 0};
    if (!run(truth, &truest, truth->at, truth->times, FALSE, &record, NULL, error)) return FALSE;
    if (!run(truth, &second, truth->at, truth->times, FALSE, &other, NULL, error)) return FALSE;
    find_scales(truth, record.columns);
    find_errors(truth, truth->other, record.columns, truth->doubt);
    return TRUE;
}

HonestyTruth *honesty_truth_new(TinkerCatalogue *catalogue, const RandomScene *text, guint32 seed, GError **error)
{
    g_autoptr(HonestyTruth) truth = g_new0(HonestyTruth, 1);
    truth->text = text;
    truth->columns = columns_of(text);
    truth->claims = CLAIMS;
    truth->times = CLAIMS * TIMES_A_CLAIM;
    gsize row = (gsize)(text->bodies * COLUMNS_OF_BODY + text->anchors * COLUMNS_OF_ANCHOR);
    double **arrays[] = {&truth->at, &truth->claimed_at, &truth->extent, &truth->speed, &truth->doubt};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = g_new0(double, truth->times);
    truth->truth = g_new0(double, truth->times *row);
    truth->other = g_new0(double, truth->times *row);
    draw_times(truth, seed);
    truth->scene = tinker_scene_read_text(catalogue, text->text, strlen(text->text), NULL, NULL, error);
    if (truth->scene == NULL || !find_truth(truth, error)) return NULL;
    return g_steal_pointer(&truth);
}

void honesty_truth_free(HonestyTruth *truth)
{
    if (truth == NULL) return;
    tinker_scene_free(truth->scene);
    g_string_free(truth->columns, TRUE);
    gpointer arrays[] = {truth->at,     truth->claimed_at, truth->truth, truth->other,
                         truth->extent, truth->speed,      truth->doubt};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(truth);
}

/* Judgement -------------------------------------------------------------------------------------------------------- */

/* Claims are made in a run with few samples, errors found in one with many: what is recorded does not change the
 * motion. */
gboolean honesty_judge(const HonestyTruth *truth, const HonestyMethod *method, GArray *samples, guint *left_out,
                       GError **error)
{
    g_autofree double *claimed = g_new0(double, truth->claims), *errors = g_new0(double, truth->times);
    gsize row = (gsize)(truth->text->bodies * COLUMNS_OF_BODY + truth->text->anchors * COLUMNS_OF_ANCHOR);
    g_autofree double *rows = g_new0(double, truth->times *row);
    Record claims = {NULL, claimed, 0, 0}, record = {rows, NULL, 0, 0};
    double believed;
    if (!run(truth, method, truth->claimed_at, truth->claims, TRUE, &claims, &believed, error)) return FALSE;
    if (!run(truth, method, truth->at, truth->times, FALSE, &record, NULL, error)) return FALSE;
    find_errors(truth, rows, record.columns, errors);
    for (gsize i = 0, time = 0; i < truth->claims; i++) {
        while (truth->at[time] < truth->claimed_at[i])
            time++;
        HonestySample sample = {claimed[i], fmax(errors[time], FLOOR)};
        gboolean believable = truth->claimed_at[i] < believed || believed >= truth->text->duration;
        gboolean known = truth->doubt[time] <= KNOWN * sample.claimed;
        if (believable && known && !isnan(sample.claimed))
            g_array_append_val(samples, sample);
        else
            ++*left_out;
    }
    return TRUE;
}
