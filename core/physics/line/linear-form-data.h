/* What the files of the linear form share. */
#ifndef TINKER_CORE_LINEAR_FORM_DATA_H
#define TINKER_CORE_LINEAR_FORM_DATA_H

#include <math.h>

#include "physics/line/linear-form.h"
#include "physics/line/tolerances.h"
#include "physics/model/model-data.h"

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

/* Bodies that turn on fixed axes. */
typedef struct {
    int32_t *shaft_of; /* of each body: its coordinate in the form */
    double *weight;    /* of each body: rad that it turns by while that moves by 1 m */
    int32_t *leader;   /* of each coordinate: a body that moves by it */
} TinkerShafts;

struct _TinkerLinearForm {
    TinkerModel *model;
    gboolean one_coordinate; /* for each body on a line, or each shaft; else two for each body */
    gboolean straight;
    TinkerLine line;      /* of a straight one */
    TinkerShafts *shafts; /* NULL: it is none of shafts */
    double least_extent;  /* m: that errors are measured against; 0 but for shafts */
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

    /* of one coordinate for each */
    TinkerStraightEdge *inner, *anchored;
    int32_t inner_count, anchored_count;
    double *anchor_place, *anchor_speed; /* at the time evaluated last */
    double *load;                        /* N: constant, of each coordinate */
    double *inverse_mass;                /* 1/kg: of each coordinate */

    /* of these, where a method asked for it */
    TinkerPattern pattern;
    int32_t *row_starts, *columns;
    double *stiffness, *damping; /* by entry of the pattern */
};

/* Parts of a form under construction: memory for its edges and anchors, once its size is known; an input, or -1 where
 * the waveform has no form; uses of all its signals alike; a constant force, and one that an input drives by a factor,
 * on a coordinate; the end. */
void tinker_form_allot(TinkerLinearForm *form, gsize edges, gsize anchors);
int32_t tinker_form_add_input(TinkerLinearForm *form, const TinkerBlockBatch *batch, int32_t column, int32_t row);
void tinker_form_use_input(TinkerLinearForm *form, GArray **uses, int32_t target, int32_t number, int32_t book,
                           double factor);
void tinker_form_add_load(TinkerLinearForm *form, int32_t target, int32_t book, double force);
void tinker_form_drive(TinkerLinearForm *form, int32_t target, int32_t input, int32_t book, double factor);
void tinker_form_close(TinkerLinearForm *form);

/* The form of a model whose bodies turn on fixed axes; NULL where that is not so, or it is not linear. (transfer full)
 */
TinkerLinearForm *tinker_shafts_form_new(TinkerModel *model);
void tinker_shafts_free(TinkerShafts *shafts);

/* Its coordinates to and from those of the model. */
void tinker_shafts_expand(const TinkerLinearForm *form, const double *x, const double *u, double *q, double *v);
void tinker_shafts_reduce(const TinkerLinearForm *form, const double *q, const double *v, double *x, double *u);

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
