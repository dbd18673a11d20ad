/* Waveforms: one face for harmonic functions, expressions and tables, and the evaluator that a run holds. */
#include "units/waveform/waveform-pole.h"

#include <math.h>
#include <string.h>

#include "units/expression/expression-form.h"
#include "units/waveform/table-private.h"

#define MOST_INSTRUCTIONS 1024 /* of an expression that is given as a tree */
/* ulp: beside the end of a piece. A root that begins there is off by the root of that. */
#define BESIDE (2 * TINKER_MERGED)

struct _TinkerWaveform {
    gatomicrefcount references;
    TinkerWaveformKind kind;
    TinkerWaveform *origin; /* that this one is a shift of, or NULL */
    double shift;           /* s: the origin is evaluated at t + shift */
    char *text;             /* of an expression that was read from one */
    TinkerProgram *program; /* of an expression; it has the shift in it */
    TinkerTable *table;     /* of a table; the origin's where there is one */
};

struct _TinkerWaveformEvaluator {
    TinkerWaveform *waveform;
    double amplitude, frequency, phase;
    gboolean smooth;
    TinkerProgramState piece;  /* of an expression: the piece entered last, */
    double inside;             /* s: a time in it; NAN where there is but one */
    TinkerProgramState search; /* and the scratch of next_break */
    gsize table_piece;
};

static TinkerWaveform *waveform_new(TinkerWaveformKind kind)
{
    TinkerWaveform *waveform = g_new0(TinkerWaveform, 1);
    g_atomic_ref_count_init(&waveform->references);
    waveform->kind = kind;
    return waveform;
}

static TinkerWaveform *waveform_of_table(TinkerTable *table)
{
    if (table == NULL) return NULL;
    TinkerWaveform *waveform = waveform_new(TINKER_WAVEFORM_TABLE);
    waveform->table = table;
    return waveform;
}

static void store(TinkerJet jet, double result[3])
{
    result[0] = jet.value;
    result[1] = jet.first;
    result[2] = jet.second;
}

/* The number of rows up to and including t. By the rows' own shifted times, so that a break that was reported is met.
 */
static gsize table_piece(const TinkerWaveform *waveform, double t)
{
    const TinkerTable *table = waveform->table;
    gsize piece = tinker_table_piece(table, t + waveform->shift);
    while (piece < table->rows && table->times[piece] - waveform->shift <= t)
        piece++;
    while (piece > 0 && table->times[piece - 1] - waveform->shift > t)
        piece--;
    return piece;
}

/* The first row after t. */
static double next_row(const TinkerWaveform *waveform, double t, double horizon)
{
    const gsize row = table_piece(waveform, t);
    if (row == waveform->table->rows) return INFINITY;
    const double next = waveform->table->times[row] - waveform->shift;
    return next <= horizon ? next : INFINITY;
}

TinkerWaveform *tinker_waveform_new_harmonic(TinkerWaveformKind kind)
{
    g_return_val_if_fail(kind == TINKER_WAVEFORM_NONE || kind == TINKER_WAVEFORM_SINE || kind == TINKER_WAVEFORM_COSINE,
                         NULL);
    return waveform_new(kind);
}

TinkerWaveform *tinker_waveform_new_expression(const char *text, GError **error)
{
    TinkerProgram *program = tinker_program_parse(text, 0.0, error);
    if (program == NULL) return NULL;
    TinkerWaveform *waveform = waveform_new(TINKER_WAVEFORM_EXPRESSION);
    waveform->text = g_strdup(text);
    waveform->program = program;
    return waveform;
}

TinkerWaveform *tinker_waveform_new_switching(const TinkerExpression *of_time)
{
    static const char *const names[] = {"t"};
    g_autoptr(TinkerProgram) program = tinker_program_of_tree(of_time, names, 1, MOST_INSTRUCTIONS);
    if (program == NULL || !tinker_program_switches(program)) return NULL;
    TinkerWaveform *waveform = waveform_new(TINKER_WAVEFORM_EXPRESSION);
    waveform->program = g_steal_pointer(&program);
    return waveform;
}

TinkerWaveform *tinker_waveform_new_table(const double *times, const double *values, gsize rows, TinkerTableKind kind,
                                          GError **error)
{
    const gsize size = MIN(rows, TINKER_TABLE_MOST_ROWS) * sizeof(double);
    return waveform_of_table(tinker_table_new(g_memdup2(times, size), g_memdup2(values, size), rows, kind, error));
}

TinkerWaveform *tinker_waveform_new_table_file(const char *path, int column, double scale, TinkerTableKind kind,
                                               GError **error)
{
    return waveform_of_table(tinker_table_read(path, column, scale, kind, error));
}

static gboolean is_value_table(const TinkerWaveform *waveform)
{
    return waveform->kind == TINKER_WAVEFORM_TABLE && waveform->table->kind == TINKER_TABLE_VALUE;
}

gboolean tinker_waveform_prepare_smooth(TinkerWaveform *waveform, GError **error)
{
    return !is_value_table(waveform) || tinker_table_prepare_spline(waveform->table, error);
}

TinkerWaveform *tinker_waveform_shifted(TinkerWaveform *waveform, double by)
{
    g_return_val_if_fail(isfinite(waveform->shift + by), NULL);
    TinkerWaveform *origin = waveform->origin == NULL ? waveform : waveform->origin;
    const double shift = waveform->shift + by;
    if (shift == 0 || origin->kind == TINKER_WAVEFORM_NONE) return tinker_waveform_ref(origin);
    TinkerWaveform *shifted = waveform_new(origin->kind);
    shifted->origin = tinker_waveform_ref(origin);
    shifted->shift = shift;
    shifted->table = origin->table;
    if (origin->kind != TINKER_WAVEFORM_EXPRESSION) return shifted;
    shifted->text = tinker_expression_shift_text(origin->text, shift);
    shifted->program = tinker_program_parse(origin->text, shift, NULL);
    g_assert(shifted->program != NULL); /* the text was read before */
    return shifted;
}

TinkerWaveform *tinker_waveform_ref(TinkerWaveform *waveform)
{
    g_atomic_ref_count_inc(&waveform->references);
    return waveform;
}

void tinker_waveform_unref(TinkerWaveform *waveform)
{
    if (!g_atomic_ref_count_dec(&waveform->references)) return;
    g_free(waveform->text);
    g_clear_pointer(&waveform->program, tinker_program_free);
    if (waveform->origin == NULL) g_clear_pointer(&waveform->table, tinker_table_free);
    g_clear_pointer(&waveform->origin, tinker_waveform_unref);
    g_free(waveform);
}

TinkerWaveformKind tinker_waveform_kind(const TinkerWaveform *waveform)
{
    return waveform->kind;
}

const char *tinker_waveform_expression(const TinkerWaveform *waveform)
{
    return waveform->text;
}

gboolean tinker_waveform_table_facts(const TinkerWaveform *waveform, TinkerTableFacts *facts)
{
    const TinkerTable *table = waveform->table;
    if (table == NULL) return FALSE;
    *facts = (TinkerTableFacts){table->rows, table->kind, table->column, table->scale};
    return TRUE;
}

TinkerWaveformEvaluator *tinker_waveform_evaluator_new(TinkerWaveform *waveform, double amplitude, double frequency,
                                                       double phase, gboolean smooth)
{
    TinkerWaveformEvaluator *evaluator = g_new0(TinkerWaveformEvaluator, 1);
    evaluator->waveform = tinker_waveform_ref(waveform);
    evaluator->amplitude = amplitude;
    evaluator->frequency = frequency;
    evaluator->phase = waveform->shift == 0 ? phase : phase + frequency * waveform->shift;
    evaluator->smooth = smooth && is_value_table(waveform);
    g_autoptr(GError) error = NULL;
    if (evaluator->smooth && !tinker_table_prepare_spline(waveform->table, &error))
        g_error("failed to allocate what a table needs: %s", error->message);
    if (waveform->program != NULL) {
        tinker_program_state_init(&evaluator->piece, waveform->program, FALSE);
        tinker_program_state_init(&evaluator->search, waveform->program, TRUE);
    }
    tinker_waveform_enter_piece(evaluator, 0);
    return evaluator;
}

void tinker_waveform_evaluator_free(TinkerWaveformEvaluator *evaluator)
{
    if (evaluator->waveform->program != NULL) {
        tinker_program_state_clear(&evaluator->piece);
        tinker_program_state_clear(&evaluator->search);
    }
    tinker_waveform_unref(evaluator->waveform);
    g_free(evaluator);
}

void tinker_waveform_enter_piece(TinkerWaveformEvaluator *evaluator, double inside)
{
    if (evaluator->waveform->kind == TINKER_WAVEFORM_EXPRESSION) {
        tinker_program_decide(&evaluator->piece, inside);
        evaluator->inside = tinker_program_switches(evaluator->waveform->program) ? inside : NAN;
    } else if (evaluator->waveform->kind == TINKER_WAVEFORM_TABLE) {
        evaluator->table_piece = table_piece(evaluator->waveform, inside);
    }
}

/* The end of a piece is known to some roundings: what is a root within it may be that of a negative number there. */
static TinkerJet evaluate_expression(const TinkerWaveformEvaluator *evaluator, double t)
{
    const TinkerJet at = tinker_program_evaluate(&evaluator->piece, t);
    const double nearer = tinker_ulps(t, BESIDE), left = evaluator->inside - t;
    if (!isnan(at.value) || !(fabs(left) > nearer)) return at;
    return tinker_program_evaluate(&evaluator->piece, t + copysign(nearer, left));
}

void tinker_waveform_evaluate(const TinkerWaveformEvaluator *evaluator, double t, double result[3])
{
    const TinkerWaveform *waveform = evaluator->waveform;
    const double amplitude = evaluator->amplitude, rate = evaluator->frequency;
    double sine, cosine;
    switch (waveform->kind) {
    case TINKER_WAVEFORM_SINE:
    case TINKER_WAVEFORM_COSINE:
        sincos(rate * t + evaluator->phase, &sine, &cosine);
        result[0] = amplitude * (waveform->kind == TINKER_WAVEFORM_SINE ? sine : cosine);
        result[1] = amplitude * rate * (waveform->kind == TINKER_WAVEFORM_SINE ? cosine : -sine);
        result[2] = -rate * rate * result[0];
        return;
    case TINKER_WAVEFORM_EXPRESSION:
        store(evaluate_expression(evaluator, t), result);
        return;
    case TINKER_WAVEFORM_TABLE:
        tinker_table_evaluate(waveform->table, evaluator->table_piece, evaluator->smooth, t + waveform->shift, result);
        return;
    case TINKER_WAVEFORM_NONE:
        memset(result, 0, 3 * sizeof *result);
        return;
    }
}

int tinker_waveform_signals(const TinkerWaveformEvaluator *evaluator)
{
    const TinkerProgram *program = evaluator->waveform->program;
    return program == NULL ? 1 : 1 + tinker_program_harmonics(program);
}

/* The second derivative of a polynomial of degree 3 changes by 6 c3 in a unit of time. */
static TinkerSignal table_form(const TinkerWaveformEvaluator *evaluator, double t)
{
    double here[3], ahead[3];
    tinker_waveform_evaluate(evaluator, t, here);
    tinker_waveform_evaluate(evaluator, t + 1.0, ahead);
    return (TinkerSignal){TINKER_SIGNAL_POLYNOMIAL, 0, t, {here[0], here[1], here[2] / 2, (ahead[2] - here[2]) / 6}};
}

static TinkerSignal harmonic_form(const TinkerWaveformEvaluator *evaluator)
{
    const double quarter = evaluator->waveform->kind == TINKER_WAVEFORM_COSINE ? G_PI_2 : 0.0;
    return (TinkerSignal){
        TINKER_SIGNAL_HARMONIC, 0, 0.0, {evaluator->amplitude, evaluator->frequency, evaluator->phase + quarter, 0.0}};
}

static void expression_form(const TinkerWaveformEvaluator *evaluator, double t, TinkerSignal *signals)
{
    TinkerForm form;
    tinker_program_form(&evaluator->piece, t, &form);
    signals[0] = (TinkerSignal){TINKER_SIGNAL_POLYNOMIAL, 0, t, {0}};
    memcpy(signals[0].coefficient, form.polynomial, sizeof(form.polynomial));
    for (int i = 1; i < tinker_waveform_signals(evaluator); i++) {
        TinkerHarmonic harmonic = i <= form.count ? form.harmonics[i - 1] : (TinkerHarmonic){0};
        signals[i] =
            (TinkerSignal){TINKER_SIGNAL_HARMONIC, 0, t, {harmonic.amplitude, harmonic.frequency, harmonic.phase, 0.0}};
    }
}

void tinker_waveform_form(const TinkerWaveformEvaluator *evaluator, double t, TinkerSignal *signals)
{
    switch (evaluator->waveform->kind) {
    case TINKER_WAVEFORM_SINE:
    case TINKER_WAVEFORM_COSINE:
        *signals = harmonic_form(evaluator);
        return;
    case TINKER_WAVEFORM_EXPRESSION:
        expression_form(evaluator, t, signals);
        return;
    case TINKER_WAVEFORM_TABLE:
    case TINKER_WAVEFORM_NONE:
        *signals = table_form(evaluator, t);
        return;
    }
}

double tinker_waveform_next_break(const TinkerWaveformEvaluator *evaluator, double t, double horizon)
{
    if (!isfinite(t) || !(horizon > t)) return INFINITY;
    if (evaluator->waveform->kind == TINKER_WAVEFORM_TABLE) return next_row(evaluator->waveform, t, horizon);
    if (evaluator->waveform->kind != TINKER_WAVEFORM_EXPRESSION) return INFINITY;
    TinkerProgramState search = evaluator->search;
    return tinker_program_next_break(&search, t, horizon);
}

double tinker_waveform_next_pole(const TinkerWaveformEvaluator *evaluator, double t, double end)
{
    if (!isfinite(t) || !isfinite(end) || !(end > t)) return INFINITY;
    if (evaluator->waveform->kind != TINKER_WAVEFORM_EXPRESSION) return INFINITY;
    TinkerProgramState search = evaluator->search;
    return tinker_program_next_pole(&search, t, end);
}
