/* What the files of the linear form share. */
#ifndef TINKER_CORE_LINEAR_FORM_DATA_H
#define TINKER_CORE_LINEAR_FORM_DATA_H

#include <math.h>

#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"

/* What is off a line by no more than this share of the extent, the speeds, the loads lies along it. */
#define TINKER_LINE_ACROSS 1e-12

/* A line: places are offset + s * direction. */
typedef struct {
    double direction[2], offset[2];
} TinkerLine;

/* How far a vector leads across a line. */
static inline double tinker_line_across(const TinkerLine *line, double x, double y)
{
    return fabs(line->direction[0] * y - line->direction[1] * x);
}

/* One input: a waveform that drives a force or a place, as one signal or several that are added up. */
typedef struct {
    const TinkerWaveformEvaluator *evaluator;
    int32_t first_signal, signals;
} TinkerInput;

/* A force on a coordinate that an input drives. */
typedef struct {
    int32_t target, input, book;
    double factor;
} TinkerDrive;

/* A spring and a damper on a line, for the loops of a step: between the coordinates a and b, or between the anchor a
 * and the coordinate b. With d = x_b - x_a the pull is stiffness * d + offset * sign(d) + damping * dd/dt. */
typedef struct {
    int32_t a, b;
    double stiffness, offset, damping;
} TinkerStraightEdge;

struct _TinkerLinearForm {
    TinkerModel *model;
    gboolean straight;
    TinkerLine line; /* of a straight one */
    TinkerLinearSystem system;
    /* NULL where there are none: */
    GArray *loads;   /* of TinkerConstantLoad */
    GArray *forces;  /* of TinkerSignalUse */
    GArray *motions; /* of TinkerSignalUse */
    GArray *inputs;  /* of TinkerInput */
    GArray *drives;  /* of TinkerDrive: what `forces` says signal by signal */
    gpointer room;   /* which these and those of a straight one lie in: */
    TinkerLinearEdge *edges;
    double *anchors, *mass, *drag;
    int32_t *anchor_points; /* of each anchor: the model's point */

    /* of a straight one */
    TinkerStraightEdge *inner, *anchored;
    int32_t inner_count, anchored_count;
    double *anchor_place, *anchor_speed; /* at the time evaluated last */
    double *load;                        /* N: constant, of each coordinate */

    /* of a straight one, where a method asked for it */
    TinkerPattern pattern;
    int32_t *row_starts, *columns;
    double *stiffness, *damping; /* by entry of the pattern */
};

/* Works out pattern and values of the derivatives, once. */
void tinker_linear_form_differentiate(TinkerLinearForm *form);

/* The line that all bodies and what they hang on lie on and move along: to 1e-12 of their extent, of their speeds and
 * of their loads. FALSE where there is none. */
gboolean tinker_model_find_line(TinkerModel *model, TinkerLine *line);

/* The column of the batch that holds its waveform; -1. */
int32_t tinker_driven_column(const TinkerDrivenForce *driven);

/* The steady part of a driven force at the start (in units of its direction): its waveform without what swings about 0.
 */
double tinker_driven_steady(const TinkerDrivenForce *driven);

/* The direction of a motion at each row of its batch, and the waveform column that drives it; FALSE where a row is
 * driven otherwise. */
gboolean tinker_motion_directions(const TinkerBlockBatch *batch, double *direction, int32_t *columns);

/* The rate (1/s) at which a model on this line leaves it; 0 where it is stable across. */
double tinker_model_growth_across(TinkerModel *model, const TinkerLine *line);

#endif
