/* Waveforms: functions of time with exact first and second derivatives.
 *
 * A waveform is smooth between its breaks, the times at which a derivative jumps. A step of an integrator never crosses
 * one, but its stages do stand on both ends; so a waveform is evaluated *within a piece*: all switches (comparisons,
 * step, pulse, floor, table rows, ...) are decided once, inside the piece, and the smooth function that results is then
 * evaluated up to and including both ends.
 */
#ifndef TINKER_CORE_WAVEFORM_H
#define TINKER_CORE_WAVEFORM_H

#include <glib.h>

#include <tinker/integrator.h>

#include "units/expression/expression-tree.h"
#include "units/expression/time-inside.h"
#include "units/expression/waveform-error.h"

typedef enum {
    TINKER_WAVEFORM_NONE,       /* 0 */
    TINKER_WAVEFORM_SINE,       /* amplitude * sin(frequency * t + phase) */
    TINKER_WAVEFORM_COSINE,     /* amplitude * cos(frequency * t + phase) */
    TINKER_WAVEFORM_EXPRESSION, /* the value itself */
    TINKER_WAVEFORM_TABLE,      /* linear between its rows, as a value; C2 where it drives a place, see `smooth` */
} TinkerWaveformKind;

typedef enum {
    TINKER_TABLE_VALUE,
    TINKER_TABLE_ACCELERATION, /* integrated exactly to velocity and displacement from rest */
} TinkerTableKind;

/* Never changes, and may be used by any number of threads. */
typedef struct _TinkerWaveform TinkerWaveform;

/* none, sine or cosine. (transfer full) */
TinkerWaveform *tinker_waveform_new_harmonic(TinkerWaveformKind kind);

/* An expression in t, as docs/reference/expressions.md has it. NULL on failure, with an error whose message begins with
 * "column N: " and suggests the nearest name where one is near. (transfer full) */
TinkerWaveform *tinker_waveform_new_expression(const char *text, GError **error);

/* An expression in t that was read before, for the sake of its breaks. NULL: nothing in it switches, or it is too long.
 * (transfer full) */
TinkerWaveform *tinker_waveform_new_switching(const TinkerExpression *of_time);

/* A table of `rows` times (strictly increasing, s) and values, both copied. Before the first row the first value holds,
 * behind the last the last one (for an acceleration: 0). (transfer full) */
TinkerWaveform *tinker_waveform_new_table(const double *times, const double *values, gsize rows, TinkerTableKind kind,
                                          GError **error);

/* Reads column `column` of a CSV file (time in column 0; a header line, blank lines and lines that begin with # are
 * passed over), multiplies it by `scale`. Errors name file, line and column; TINKER_WAVEFORM_ERROR_FILE where the file,
 * or memory for it, cannot be had. (transfer full) */
TinkerWaveform *tinker_waveform_new_table_file(const char *path, int column, double scale, TinkerTableKind kind,
                                               GError **error);

/* Works out what reading the waveform as a smooth one needs (see tinker_waveform_evaluator_new), which a table's
 * evaluator else does, and ends the program where there is no memory: this says TINKER_WAVEFORM_ERROR_FILE. */
gboolean tinker_waveform_prepare_smooth(TinkerWaveform *waveform, GError **error);

/* The waveform as it is `by` (s, finite) later: f(t + by), with everything that belongs to it: breaks, jumps, forms,
 * and the velocity and displacement that a table of accelerations has grown to. A harmonic's phase advances by
 * frequency * by. What was shifted once can be shifted again. (transfer full) */
TinkerWaveform *tinker_waveform_shifted(TinkerWaveform *waveform, double by);

TinkerWaveform *tinker_waveform_ref(TinkerWaveform *waveform);
void tinker_waveform_unref(TinkerWaveform *waveform);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerWaveform, tinker_waveform_unref)

TinkerWaveformKind tinker_waveform_kind(const TinkerWaveform *waveform);

/* The text of an expression, of a shifted one as a function of the new t; else NULL. Borrowed. */
const char *tinker_waveform_expression(const TinkerWaveform *waveform);

/* What a table holds and, where it was read from a file, how it was read. */
typedef struct {
    gsize rows;
    TinkerTableKind kind;
    int column;   /* of the file; 0: it was not read from one */
    double scale; /* that the column was multiplied by */
} TinkerTableFacts;
/* FALSE of what is no table. */
gboolean tinker_waveform_table_facts(const TinkerWaveform *waveform, TinkerTableFacts *facts);

/* An evaluator: one waveform in use by one run, with its scaling and the switches of the piece it is in. Not shared
 * between threads; the waveform behind it may be. `smooth`: a value table is read as a C2 cubic spline (natural ends)
 * instead of linearly, as a place needs it. (transfer full) */
typedef struct _TinkerWaveformEvaluator TinkerWaveformEvaluator;
TinkerWaveformEvaluator *tinker_waveform_evaluator_new(TinkerWaveform *waveform, double amplitude, double frequency,
                                                       double phase, gboolean smooth);
void tinker_waveform_evaluator_free(TinkerWaveformEvaluator *evaluator);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerWaveformEvaluator, tinker_waveform_evaluator_free)

/* Enters the piece that contains `inside`, a time that is not itself a break. */
void tinker_waveform_enter_piece(TinkerWaveformEvaluator *evaluator, double inside);

/* Value, first and second derivative at t, by the switches of the piece entered last. */
void tinker_waveform_evaluate(const TinkerWaveformEvaluator *evaluator, double t, double result[3]);

/* As how many signals the waveform can be given in every one of its pieces: polynomials of t up to degree 3 and
 * harmonics, which are added up; at least 1. 0 where it has no such form. Expressions have it where they are made of
 * such terms. */
int tinker_waveform_signals(const TinkerWaveformEvaluator *evaluator);

/* Those signals in the piece entered last, about the time t, which is in the piece or at one of its ends. Allots
 * memory. */
void tinker_waveform_form(const TinkerWaveformEvaluator *evaluator, double t, TinkerSignal *signals);

/* What the waveform has at t = 0 without what varies: the constant of a polynomial of t, without the harmonics beside
 * it. 0 where it has no such form, as of exp(-t), which is forcing and no load. In the piece that begins at 0. */
double tinker_waveform_steady(const TinkerWaveformEvaluator *evaluator);

/* The first break after t and not after `horizon`; INFINITY where there is none. Switching arguments that are affine in
 * t are solved exactly; others by interval bisection, which finds every sign change that interval arithmetic cannot
 * exclude, down to a width of 4 ulp of t. Breaks nearer to t than that count as t itself. The work is bounded (half a
 * million instructions enclosed in one call); a horizon that is not searched by then is looked at in 1024 places. At a
 * time that is reported as a break nothing need jump. */
double tinker_waveform_next_break(const TinkerWaveformEvaluator *evaluator, double t, double horizon);

#endif
