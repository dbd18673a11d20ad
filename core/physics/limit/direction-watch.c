/* Looks for ends that meet; see the header. */
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>

#include "numerics/roots/step-roots.h"
#include "numerics/solve/largest.h"
#include "physics/event/contact-run.h"
#include "physics/island/island-run.h"
#include "physics/limit/direction-private.h"
#include "physics/limit/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

TinkerDirectionWatch *tinker_direction_watch_new(TinkerIslandRun *run)
{
    TinkerDirectionWatch *self = g_new0(TinkerDirectionWatch, 1);
    *self = (TinkerDirectionWatch){run, run->model, g_array_new(FALSE, FALSE, sizeof(TinkerDirectionLine)),
                                   .expected = INFINITY};
    tinker_model_watch_lines(run->model, tinker_direction_list(self));
    if (self->lines->len == 0) {
        tinker_direction_watch_free(self);
        return NULL;
    }
    gsize n = (gsize)run->model->coordinates;
    double **arrays[] = {&self->x, &self->u, &self->q, &self->v, &self->acceleration};
    self->room = g_new0(double, G_N_ELEMENTS(arrays) * n);
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = self->room + i * n;
    return self;
}

void tinker_direction_watch_free(TinkerDirectionWatch *self)
{
    if (self == NULL) return;
    g_array_unref(self->lines);
    g_free(self->room);
    g_free(self);
}

/* Meeting ---------------------------------------------------------------------------------------------------------- */

/* The energy of the ends where their acceleration takes the velocity to 0, which is within a step: the method need not
 * end there. */
static TinkerStatus least_energy(TinkerDirectionWatch *self, const TinkerDirectionLine *line, TinkerDirectionEnds ends,
                                 double *energy)
{
    const TinkerState *state = &self->run->state;
    double a[2];
    TinkerStatus status = tinker_direction_acceleration(self, line, state->t, state->q, state->v, a);
    double square = a[0] * a[0] + a[1] * a[1], later = -(ends.u[0] * a[0] + ends.u[1] * a[1]) / square;
    if (status != TINKER_OK || !(square > 0)) return status;
    for (int k = 0; k < 2; k++) {
        ends.d[k] += later * (ends.u[k] + 0.5 * later * a[k]);
        ends.u[k] += later * a[k];
    }
    ends.length = hypot(ends.d[0], ends.d[1]);
    ends.speed = hypot(ends.u[0], ends.u[1]);
    *energy = fmin(*energy, tinker_direction_energy(line, &ends));
    return TINKER_OK;
}

/* J: what rounding, the tolerance and the error of the energy may be of that. In the plane a moment of the relative
 * motion that is rounding keeps the ends apart by (mu l^2 / 2 |T0|)^(1/3). */
static double unknown_energy(const TinkerIslandRun *run, const TinkerDirectionLine *line, double extent, double speed)
{
    double tension = fabs(line->tension), share = TINKER_DIRECTION_ROUNDING, moment = 0;
    if (tinker_method_is_adaptive(run->choice.method)) share = fmax(share, run->choice.tolerance);
    if (!tinker_direction_is_straight(run)) moment = TINKER_ROUNDING_OF_MOMENTS * extent * speed * tension;
    return TINKER_SEEN * run->books.missing + share * tension * extent + cbrt(0.5 * line->mass * moment * moment);
}

/* Ends that are exactly at one place are parted the way that the other forces accelerate them, if they do: with a force
 * that jumps as they begin to move no step is small enough. */
static TinkerStatus part_ends(TinkerDirectionWatch *self, const TinkerDirectionLine *line,
                              const TinkerDirectionEnds *ends, double extent)
{
    TinkerIslandRun *run = self->run;
    TinkerModel *model = self->model;
    double pull[2];
    if (ends->length > 0 || tinker_direction_is_straight(run)) return TINKER_OK;
    TinkerStatus status = tinker_direction_acceleration(self, line, run->state.t, run->state.q, run->state.v, pull);
    double most = hypot(pull[0], pull[1]), size = extent + tinker_largest(run->system.system.size, run->state.q);
    double by = TINKER_PARTED * fmax(size, model->watched_length);
    if (status != TINKER_OK || !(most > 0) || !(by > 0)) return status;
    for (int k = 0; k < 2; k++) {
        if (line->b < model->bodies)
            run->state.q[2 * line->b + k] += by * pull[k] / most;
        else
            run->state.q[2 * line->a + k] -= by * pull[k] / most;
    }
    tinker_method_restart(run->choice.method, run->stepper);
    return TINKER_OK;
}

static void tell(TinkerDirectionWatch *self, const TinkerDirectionLine *line)
{
    TinkerIslandRun *run = self->run;
    g_autofree char *names = tinker_direction_names(self, line);
    tinker_island_run_add_event(run, "direction lost", names);
    run->summary.determined_until = fmin(run->summary.determined_until, run->state.t);
    tinker_summary_warn_of_scene(
        &run->summary,
        g_strdup_printf(_("%s: its ends meet at t = %.6g s and do not pass each other: its force has no "
                          "direction there, and what follows is one motion of many (the run is determined "
                          "up to then; start beside it, or with no force at length 0, as by a rest "
                          "length of 0)"),
                        names, run->state.t));
}

/* Of all bodies at the run's state: worked out once for all lines that are checked there. */
typedef struct {
    double extent, speed; /* m, m/s */
} Scales;

static Scales scales_of(const TinkerIslandRun *run)
{
    Scales scales;
    run->system.system.scales(run->system.system.context, run->state.q, run->state.v, &scales.extent, &scales.speed);
    return scales;
}

/* `closest`: the state is where the ends of the line are closest, to within less than a step. */
static TinkerStatus check_line(TinkerDirectionWatch *self, TinkerDirectionLine *line, const Scales *scales,
                               gboolean closest)
{
    TinkerIslandRun *run = self->run;
    const double extent = fmax(scales->extent, line->start);
    TinkerDirectionEnds ends;
    TinkerStatus status = tinker_direction_measure(self, line, run->state.t, &ends);
    if (status != TINKER_OK) return status;
    if (line->asked != NULL) line->tension = tinker_direction_tension(self->model, line->asked->batch, line->row);
    double energy = tinker_direction_energy(line, &ends);
    if (line->tension == 0 || energy > TINKER_DIRECTION_FAR * fabs(line->tension) * extent) return TINKER_OK;
    if (closest) status = least_energy(self, line, ends, &energy);
    if (closest && status == TINKER_OK)
        status = tinker_island_run_mark_valid(run); /* looks how far the energy is off */
    if (status != TINKER_OK || energy > unknown_energy(run, line, extent, scales->speed)) return status;
    line->lost = TRUE;
    tell(self, line);
    return part_ends(self, line, &ends, extent);
}

TinkerStatus tinker_direction_watch_check(TinkerDirectionWatch *self)
{
    TinkerStatus status = TINKER_OK;
    tinker_island_run_place(self->run);
    const Scales scales = scales_of(self->run);
    for (guint i = 0; status == TINKER_OK && i < self->lines->len; i++) {
        TinkerDirectionLine *line = &g_array_index(self->lines, TinkerDirectionLine, i);
        if (!line->lost) status = check_line(self, line, &scales, FALSE);
    }
    return status;
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

double tinker_direction_watch_begin(TinkerDirectionWatch *self, double limit)
{
    atomic_store_explicit(&self->model->came_near, FALSE, memory_order_relaxed);
    self->projection_work = self->run->system.projection_work;
    self->position_error = self->run->system.position_error;
    return MIN(limit, self->expected);
}

/* Ends that may meet within the step that began at `from`. */
typedef struct {
    TinkerDirectionWatch *watch;
    const TinkerDirectionLine *line;
    double from, time; /* s: time is when they are closest */
} Meeting;

static double closing_at(void *data, double t)
{
    const Meeting *meeting = data;
    TinkerDirectionEnds ends;
    return tinker_direction_measure(meeting->watch, meeting->line, t, &ends) == TINKER_OK ? ends.closing : NAN;
}

/* Sets the time at which they are closest; leaves it where they are no nearer then than lengths of interest: the
 * energies of a step that is long beside the motion tell nothing, and what an iteration tried on the way is no motion.
 */
static TinkerStatus refine_meeting(Meeting *meeting)
{
    TinkerDirectionWatch *self = meeting->watch;
    double closest = tinker_step_refine(meeting->from, self->run->state.t, closing_at, meeting);
    TinkerDirectionEnds ends;
    TinkerStatus status = tinker_direction_measure(self, meeting->line, closest, &ends);
    if (status == TINKER_OK && ends.length < self->model->watched_length) meeting->time = closest;
    return status;
}

/* Sets the time: INFINITY where they do not meet. From rest at one place nothing gets farther within the step than its
 * acceleration takes it; that is told by the step's beginning, since the force may have turned round within. */
static TinkerStatus find_meeting(Meeting *meeting)
{
    TinkerDirectionWatch *self = meeting->watch;
    const TinkerDirectionLine *line = meeting->line;
    double to = self->run->state.t, h = to - meeting->from, a[2];
    TinkerDirectionEnds first, last;
    meeting->time = INFINITY;
    TinkerStatus status = tinker_direction_measure(self, line, to, &last);
    if (status != TINKER_OK || last.closing > 0 || last.length > self->model->watched_length + 2 * h * last.speed)
        return status;
    status = tinker_direction_measure(self, line, meeting->from, &first);
    if (status != TINKER_OK || first.closing < 0) return status;
    status = tinker_direction_acceleration(self, line, meeting->from, self->x, self->u, a);
    double change = h * hypot(a[0], a[1]);
    double most = fabs(line->tension) * change * h + line->mass * change * change;
    if (status == TINKER_OK && fmin(tinker_direction_energy(line, &first), tinker_direction_energy(line, &last)) <=
                                   most + TINKER_SEEN * self->run->books.missing)
        return refine_meeting(meeting);
    return status;
}

static TinkerStatus check_closest(TinkerDirectionWatch *self)
{
    TinkerStatus status = TINKER_OK;
    self->expected = INFINITY;
    tinker_island_run_place(self->run);
    const Scales scales = scales_of(self->run);
    for (guint i = 0; status == TINKER_OK && i < self->lines->len; i++) {
        TinkerDirectionLine *line = &g_array_index(self->lines, TinkerDirectionLine, i);
        if (line->closest) status = check_line(self, line, &scales, TRUE);
        line->closest = FALSE;
    }
    return status;
}

/* Makes the step again, to an instant within it. */
static TinkerStatus step_again(TinkerDirectionWatch *self, double from, double instant, TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    const TinkerState start = {from, run->state.q, run->state.v, run->state.books};
    TinkerStatus status =
        tinker_method_interpolate(run->choice.method, run->stepper, from, start.q, start.v, start.books);
    if (status != TINKER_OK) return status;
    tinker_island_run_go_back(run, &start, self->projection_work, self->position_error);
    return tinker_island_run_make_step(run, instant, report);
}

/* Ends the step where ends of lines are closest, as dense output has it. A method that makes several steps of it gets
 * there with a later one. */
static TinkerStatus step_to(TinkerDirectionWatch *self, double from, double time, TinkerStepReport *report)
{
    TinkerStatus status = step_again(self, from, time, report);
    if (status != TINKER_OK) return status;
    if (self->run->state.t < time) {
        self->expected = time;
        return TINKER_OK;
    }
    return check_closest(self);
}

/* Methods that solve for a linear motion evaluate no forces. */
static gboolean came_near(const TinkerDirectionWatch *self)
{
    const TinkerIslandRun *run = self->run;
    if (atomic_load_explicit(&self->model->came_near, memory_order_relaxed)) return TRUE;
    gboolean solves =
        (run->choice.method->flags & TINKER_INTEGRATOR_IMPLICIT) != 0 && tinker_direction_is_straight(run);
    return solves && tinker_straight_system_is_near(&run->system, run->state.q);
}

/* Looks for lines whose ends met in the step that began at `from`. Apart, as few steps come near to that. */
static G_NO_INLINE TinkerStatus look_for_meetings(TinkerDirectionWatch *self, double from, TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    TinkerDirectionLine *first = NULL;
    double time = INFINITY;
    /* what an event of contact is about to change is looked at behind it */
    if (run->contacts != NULL && tinker_contact_run_has_pending_event(run->contacts)) return TINKER_OK;
    tinker_island_run_place(run);
    for (guint i = 0; i < self->lines->len; i++) {
        Meeting meeting = {.watch = self, .line = &g_array_index(self->lines, TinkerDirectionLine, i), .from = from};
        TinkerStatus status = meeting.line->lost ? TINKER_OK : find_meeting(&meeting);
        if (status != TINKER_OK) return status;
        if (meeting.line->lost || !(meeting.time < time)) continue;
        time = meeting.time;
        first = &g_array_index(self->lines, TinkerDirectionLine, i);
    }
    if (first == NULL) return TINKER_OK;
    first->closest = TRUE;
    return time > from && time < run->state.t ? step_to(self, from, time, report) : check_closest(self);
}

TinkerStatus tinker_direction_watch_look(TinkerDirectionWatch *self, double from, TinkerStepReport *report)
{
    /* an exact step ends where ends meet */
    if (tinker_method_is_exact(self->run->choice.method)) return tinker_direction_watch_check(self);
    if (self->run->state.t >= self->expected) return check_closest(self);
    if (isfinite(self->expected) || !came_near(self)) return TINKER_OK;
    return look_for_meetings(self, from, report);
}
