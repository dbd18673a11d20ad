/* How far steps go while lines are idle; see the header. */
#include "physics/event/idle-lines.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/event/tolerances.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* Halvings of a range of lengths, to rounding. */
#define HALVINGS 100
/* Ways of which each is too short to leave the range. */
#define WAYS 200

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

/* Brings points and their accelerations to the run's state. */
static TinkerStatus place(TinkerIdleLines *self)
{
    TinkerIslandRun *run = self->run;
    TinkerModel *model = self->model;
    TinkerSystem *system = &run->system.system;
    const gint64 evaluations = model->evaluations;
    TinkerStatus status =
        system->acceleration(system->context, run->state.t, run->state.q, run->state.v, self->acceleration, NULL);
    model->evaluations = evaluations; /* looking costs the method nothing */
    if (status != TINKER_OK) return status;
    tinker_island_run_place(run);
    status = tinker_model_set_time(model, run->state.t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, run->q, run->v);
    double direction[2];
    if (run->q == run->state.q) {
        memcpy(model->point_acceleration, self->acceleration, (gsize)model->coordinates * sizeof(double));
        if (model->turning > 0) tinker_model_accelerate_attachments(model);
        return TINKER_OK;
    }
    tinker_linear_form_is_straight(run->island->linear, direction);
    for (int32_t body = 0; body < model->bodies; body++)
        for (int k = 0; k < 2; k++)
            model->point_acceleration[2 * body + k] = self->acceleration[body] * direction[k];
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

/* m/s: how fast the room shrinks; of what rests, m/s^2. */
static double closing_of(const Line *line, const Ends *ends, double length)
{
    const double outwards = room_inwards(line, length) < line->beyond - length ? -1.0 : 1.0;
    const double rate = outwards * (ends->d[0] * ends->u[0] + ends->d[1] * ends->u[1]) / length;
    return rate != 0 ? rate : outwards * (ends->d[0] * ends->a[0] + ends->d[1] * ends->a[1]) / length;
}

/* s: so long after t the ends, going on as they are accelerated, may at the earliest have covered a way (m). */
static double soonest(const Ends *ends, double t, double way)
{
    const double strongest = hypot(ends->a[0], ends->a[1]);
    const double speed = hypot(ends->u[0] + t * ends->a[0], ends->u[1] + t * ends->a[1]);
    return 2 * way / (speed + sqrt(speed * speed + 2 * strongest * way));
}

/* s: how long the ends stay within the range, at most `most`; never too long. Each way ends where the room that there
 * is, but for half of what is nothing, could be used up at the earliest: a step that ends beyond the range by rounding
 * would have met the force. */
static double time_within(const Line *line, const Ends *ends, double most)
{
    double t = 0;
    for (int i = 0; i < WAYS && t < most; i++) {
        const double x = ends->d[0] + t * (ends->u[0] + 0.5 * t * ends->a[0]);
        const double y = ends->d[1] + t * (ends->u[1] + 0.5 * t * ends->a[1]);
        const double room = room_of(line, hypot(x, y));
        if (i > 0 && !(room > line->nothing)) return t;
        t += soonest(ends, t, fmax(room, line->nothing) - 0.5 * line->nothing);
    }
    return fmin(t, most);
}

/* A step that begins at the end of the range goes only so far beyond it that the next one begins with the force. */
static double limit_of(const TinkerIdleLines *self, const Line *line, double limit)
{
    const Ends ends = ends_of(self->model, line);
    const double length = hypot(ends.d[0], ends.d[1]), room = room_of(line, length), from = self->run->state.t;
    if (!(room >= -line->nothing) || !(length > 0)) return limit;
    const double within = time_within(line, &ends, limit - from);
    const gboolean at_end = room <= line->nothing && closing_of(line, &ends, length) > 0;
    if (!at_end && within > TINKER_IDLE_END * fabs(from)) return fmin(limit, from + within);
    return fmin(limit, from + soonest(&ends, 0, TINKER_IDLE_BEYOND * length));
}

double tinker_idle_lines_limit(TinkerIdleLines *self, double limit)
{
    if (!tinker_method_is_adaptive(self->run->choice.method) || place(self) != TINKER_OK) return limit;
    for (guint i = 0; i < self->lines->len; i++)
        limit = limit_of(self, &g_array_index(self->lines, Line, i), limit);
    return limit;
}
