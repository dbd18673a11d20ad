/* How far steps go while lines are idle; see the header. */
#include "physics/limit/idle-lines.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/limit/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* Halvings of a range of lengths, to rounding. */
#define HALVINGS 100
/* Parts of a step that are looked at. */
#define PARTS 400

typedef struct {
    int32_t a, b;        /* points */
    double from, beyond; /* m: idle at lengths between these; 0 and INFINITY where that has no end */
    double nothing;      /* m: so near to an end it is at it */
} Line;

struct _TinkerIdleLines {
    TinkerIslandRun *run;
    TinkerModel *model;
    GArray *lines;        /* of Line */
    double *acceleration; /* of the system */
};

/* Listing ---------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerModel *model;
    const TinkerBlockBatch *batch;
    int32_t row;
} Law;

static gboolean is_idle(const Law *law, double length)
{
    const double rate = 0;
    double tension = NAN;
    TinkerBatch view = tinker_model_view(law->model, law->batch, law->row, 1, law->model->column_views);
    const TinkerLineLaw *of = law->batch->block_class->physics->line_law;
    TinkerStatus status = TINKER_CALL_BATCH(law->batch, "tension", &view, of->tension(&view, &length, &rate, &tension));
    return status == TINKER_OK && tension == 0;
}

/* Between a length at which it is idle and one at which it is not. */
static double find_end(const Law *law, double idle, double busy)
{
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (idle + busy);
        if (is_idle(law, middle))
            idle = middle;
        else
            busy = middle;
    }
    return idle;
}

/* A range about a length, if there is one: a law that is 0 at one place alone, as a spring's where it is at rest, has
 * none. Neither has one that is 0 everywhere, as a damper's is while nothing moves. */
static gboolean find_range(const Law *law, double length, double least, double most, Line *line)
{
    if (!is_idle(law, length) || !is_idle(law, length * (1 - TINKER_IDLE_PROBE)) ||
        !is_idle(law, length * (1 + TINKER_IDLE_PROBE)))
        return FALSE;
    line->from = is_idle(law, least) ? 0 : find_end(law, length, least);
    line->beyond = is_idle(law, most) ? INFINITY : find_end(law, length, most);
    line->nothing = TINKER_IDLE_END * (line->from > 0 ? line->from : line->beyond);
    return line->from > 0 || isfinite(line->beyond);
}

/* What is idle far apart, as a bumper; near to each other, as a cord; or where it is placed. */
static void add_row(TinkerIdleLines *self, const TinkerAskedBatch *asked, int32_t row)
{
    const Law law = {self->model, asked->batch, row};
    Line line = {.a = asked->end_points[2 * row], .b = asked->end_points[2 * row + 1]};
    double a[2], b[2];
    tinker_model_start_place(self->model, line.a, a);
    tinker_model_start_place(self->model, line.b, b);
    const double placed = hypot(b[0] - a[0], b[1] - a[1]), scale = placed > 0 ? placed : 1.0;
    const double most = TINKER_IDLE_FAR * scale, least = scale / TINKER_IDLE_FAR;
    const double probes[] = {0.5 * most, 2 * least, scale};
    Line last = {0};
    for (gsize i = 0; i < G_N_ELEMENTS(probes); i++) {
        if (!find_range(&law, probes[i], least, most, &line)) continue;
        if (line.from == last.from && line.beyond == last.beyond) continue;
        last = line;
        g_array_append_val(self->lines, line);
    }
}

/* A range that a waveform moves is not known beforehand. */
static void list_lines(TinkerIdleLines *self)
{
    for (guint i = 0; i < self->model->asked_lines->len; i++) {
        const TinkerAskedBatch *asked = &g_array_index(self->model->asked_lines, TinkerAskedBatch, i);
        for (int32_t row = 0; asked->batch->waveforms == 0 && row < asked->batch->count; row++)
            add_row(self, asked, row);
    }
}

TinkerIdleLines *tinker_idle_lines_new(TinkerIslandRun *run)
{
    if (!tinker_method_is_adaptive(run->choice.method)) return NULL;
    TinkerIdleLines *self = g_new0(TinkerIdleLines, 1);
    *self = (TinkerIdleLines){run, run->model, g_array_new(FALSE, FALSE, sizeof(Line)), NULL};
    list_lines(self);
    if (self->lines->len == 0) {
        tinker_idle_lines_free(self);
        return NULL;
    }
    self->acceleration = g_new0(double, run->model->coordinates);
    return self;
}

void tinker_idle_lines_free(TinkerIdleLines *self)
{
    if (self == NULL) return;
    g_array_unref(self->lines);
    g_free(self->acceleration);
    g_free(self);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

/* The relative motion of a line's ends. */
typedef struct {
    double d[2], u[2], a[2];
} Ends;

static Ends ends_of(const TinkerModel *model, const Line *line)
{
    const TinkerPoint *a = &model->point[line->a], *b = &model->point[line->b];
    const double *by_a = model->point_acceleration + 2 * line->a, *by_b = model->point_acceleration + 2 * line->b;
    return (Ends){{b->x - a->x, b->y - a->y}, {b->vx - a->vx, b->vy - a->vy}, {by_b[0] - by_a[0], by_b[1] - by_a[1]}};
}

/* Brings points and their accelerations to the run's state: its coordinates are the model's, as no part of a scene with
 * such a line is linear. */
static TinkerStatus place(TinkerIdleLines *self)
{
    const TinkerState *state = &self->run->state;
    TinkerModel *model = self->model;
    TinkerSystem *system = &self->run->system.system;
    const gint64 evaluations = model->evaluations;
    TinkerStatus status = system->acceleration(system->context, state->t, state->q, state->v, self->acceleration, NULL);
    model->evaluations = evaluations; /* looking costs the method nothing */
    if (status == TINKER_OK) status = tinker_model_set_time(model, state->t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, state->q, state->v);
    memcpy(model->point_acceleration, self->acceleration, (gsize)model->coordinates * sizeof(double));
    if (model->turning > 0) tinker_model_accelerate_attachments(model);
    return TINKER_OK;
}

/* m: to the end of the range at its shorter lengths; INFINITY where it has none, and ends may pass each other. */
static double room_inwards(const Line *line, double length)
{
    return line->from > 0 ? length - line->from : INFINITY;
}

/* m: to the nearer end of the range; below 0 outside. */
static double room_of(const Line *line, double length)
{
    return fmin(room_inwards(line, length), line->beyond - length);
}

/* The square of the distance of ends that go on as they are accelerated, as a polynomial of the time, c[0] + c[1] t +
 * ... A rate and a growth that are rounding are 0. */
typedef struct {
    double c[5];
} Square;

static double product(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

static Square square_of(const Ends *ends)
{
    const double dd = product(ends->d, ends->d), uu = product(ends->u, ends->u), aa = product(ends->a, ends->a);
    const double rate = product(ends->d, ends->u), growth = uu + product(ends->d, ends->a);
    const gboolean changes = fabs(rate) > TINKER_IDLE_STEADY * sqrt(dd * uu);
    const gboolean bends = fabs(growth) > TINKER_IDLE_STEADY * (uu + sqrt(dd * aa));
    return (Square){{dd, changes ? 2 * rate : 0, bends ? growth : 0, product(ends->u, ends->a), 0.25 * aa}};
}

/* Whether it stays between two squares from t on for so long: it lies between its control points. */
static gboolean stays(const Square *square, const double range[2], double t, double part)
{
    static const double weights[5][5] = {{1, 0, 0, 0, 0},
                                         {1, 1.0 / 4, 0, 0, 0},
                                         {1, 1.0 / 2, 1.0 / 6, 0, 0},
                                         {1, 3.0 / 4, 1.0 / 2, 1.0 / 4, 0},
                                         {1, 1, 1, 1, 1}};
    const double *c = square->c;
    const double from_there[5] = {c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4]))),
                                  part * (c[1] + t * (2 * c[2] + t * (3 * c[3] + t * 4 * c[4]))),
                                  part * part * (c[2] + t * (3 * c[3] + t * 6 * c[4])),
                                  part * part * part * (c[3] + t * 4 * c[4]), part * part * part * part * c[4]};
    for (int i = 0; i < 5; i++) {
        double at = 0;
        for (int k = 0; k < 5; k++)
            at += weights[i][k] * from_there[k];
        if (!(at >= range[0] && at <= range[1])) return FALSE;
    }
    return TRUE;
}

/* s: how long the ends stay within the range, but for so much (m) at its ends, at most `most`; never too long. Ends
 * that are beyond that start at it. */
static double time_within(const Line *line, Square square, double margin, double most)
{
    const double from = line->from + margin, beyond = line->beyond - margin;
    const double range[2] = {line->from > 0 && from > 0 ? from * from : -INFINITY, beyond * beyond};
    double t = 0, part = most;
    square.c[0] = CLAMP(square.c[0], range[0], range[1]);
    for (int i = 0; i < PARTS && t < most && part > DBL_EPSILON * t; i++) {
        if (!stays(&square, range, t, part)) {
            part *= 0.5;
            continue;
        }
        if (part >= most - t) return most;
        t += part;
        part = fmin(2 * part, most - t);
    }
    return t;
}

/* Whether the ends, near an end of the range, move out of it; or turn about each other at a distance that only what
 * accelerates them later on would change. Neither comes nearer to the end in smaller steps. */
static gboolean is_at_end(const Line *line, const Square *square, double length)
{
    const double room = room_of(line, length), *c = square->c;
    const double outwards = room_inwards(line, length) < line->beyond - length ? -1.0 : 1.0;
    if (c[1] == 0 && c[2] == 0) return room <= TINKER_IDLE_BEYOND * length;
    return room <= line->nothing && outwards * (c[1] != 0 ? c[1] : c[2]) > 0;
}

/* A step that begins at the end of the range goes only so far beyond it that the next one begins with the force; any
 * other ends within it by half of what is nothing: one that ends beyond by rounding would have met the force. */
static double limit_of(const TinkerIdleLines *self, const Line *line, double limit)
{
    const Ends ends = ends_of(self->model, line);
    const double length = hypot(ends.d[0], ends.d[1]), from = self->run->state.t;
    if (!(room_of(line, length) >= -line->nothing) || !(length > 0)) return limit;
    const Square square = square_of(&ends);
    double within = 0;
    if (!is_at_end(line, &square, length)) within = time_within(line, square, 0.5 * line->nothing, limit - from);
    if (!(within > TINKER_IDLE_END * fabs(from)))
        within = time_within(line, square, -TINKER_IDLE_BEYOND * length, limit - from);
    return within < limit - from ? from + within : limit;
}

double tinker_idle_lines_limit(TinkerIdleLines *self, double limit)
{
    if (place(self) != TINKER_OK) return limit;
    for (guint i = 0; i < self->lines->len; i++)
        limit = limit_of(self, &g_array_index(self->lines, Line, i), limit);
    return limit;
}
