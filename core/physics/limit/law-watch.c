/* Steps along typed laws; see the header. */
#include "physics/limit/law-watch.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/force/law-paths.h"
#include "physics/limit/law-chatter.h"
#include "physics/limit/tolerances.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* That a step is looked at in, and is to be gentle in. */
#define PARTS 8
/* Fixed steps that are looked at together, where the law is gentle over all of them. */
#define GROUP 8
/* Tolerances of the usual step: shorter ones resolve a law that sets in. */
#define RESOLVES 64
/* Parts of one step in which what may have been missed is searched. */
#define MOST_LOOKS 2000

struct _TinkerLawWatch {
    TinkerIslandRun *run;
    TinkerModel *model;
    GArray *forces;          /* of TinkerLawForce */
    TinkerPoint *points;     /* those of each end of the steps of a group, and of one more place; of an adaptive method
                                where the step began, and where it ended */
    double times[GROUP + 1]; /* s: of those ends */
    int steps;               /* in the group */
    double *room;            /* what the next ones lie in */
    TinkerState from;        /* where the step began */
    double *force, *power;   /* evaluated there */
    TinkerEvaluated start;   /* they; its time is NAN where that was not done */
    double work, error;      /* of projections, where the step began */
    double most;             /* s: the next step goes no farther; INFINITY */
    double speed;            /* m/s: of the fastest, where the laws are looked at */
    double end;              /* s: of the run; 0 at first */
    double usual;            /* s: how long steps were lately, however short they are now */
};

TinkerLawWatch *tinker_law_watch_new(TinkerIslandRun *run)
{
    const gsize n = (gsize)run->model->coordinates, points = (gsize)run->model->points;
    const gsize books = (gsize)run->system.system.books;
    GArray *forces = tinker_law_forces(run->model);
    if (forces->len == 0) {
        g_array_unref(forces);
        return NULL;
    }
    TinkerLawWatch *self = g_new0(TinkerLawWatch, 1);
    *self = (TinkerLawWatch){.run = run, .model = run->model, .forces = forces, .most = INFINITY};
    self->points = g_new0(TinkerPoint, (GROUP + 2) * points);
    self->room = g_new0(double, 3 * n + 2 * books + 1);
    self->from = (TinkerState){.q = self->room, .v = self->room + n, .books = self->room + 3 * n};
    self->force = self->room + 2 * n;
    self->power = self->room + 3 * n + books;
    return self;
}

void tinker_law_watch_free(TinkerLawWatch *self)
{
    if (self == NULL) return;
    g_array_unref(self->forces);
    g_free(self->points);
    g_free(self->room);
    g_free(self);
}

void tinker_law_watch_set_end(TinkerLawWatch *self, double end)
{
    self->end = end;
}

/* Looking ---------------------------------------------------------------------------------------------------------- */

/* All points where the state has them. */
static TinkerStatus place(TinkerLawWatch *self, TinkerPoint *points)
{
    TinkerIslandRun *run = self->run;
    tinker_island_run_place(run);
    const TinkerStatus status = tinker_model_set_time(self->model, run->state.t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(self->model, run->q, run->v);
    memcpy(points, self->model->point, (gsize)self->model->points * sizeof(TinkerPoint));
    return TINKER_OK;
}

/* Goes through all bodies: once for all laws that are looked at. */
static void find_speed(TinkerLawWatch *self)
{
    const TinkerSystem *system = &self->run->system.system;
    const TinkerState *state = &self->run->state;
    double extent;
    system->scales(system->context, state->q, state->v, &extent, &self->speed);
}

/* kg m/s: an impulse on a mass that is let pass. Nothing passes of what has never moved, down to the least numbers. */
static double let_pass(const TinkerLawWatch *self, double mass, double share)
{
    return mass * fmax(share * self->speed, TINKER_LAW_NOTHING);
}

/* Whether a law sets in on what is at rest, within a step that is short beside the usual one: it is another at the end
 * of the step than at its start, and goes on so, and beside the speed that it gives in a usual step nothing is missed.
 */
static gboolean sets_in(const TinkerLawWatch *self, const TinkerLawForce *law, const TinkerLawStep *step)
{
    if (step->to - step->from > RESOLVES * self->run->choice.tolerance * self->usual) return FALSE;
    const double change = fabs(tinker_law_force_at(law, step, 1) - tinker_law_force_at(law, step, 0));
    return law->mass * self->speed < TINKER_LAW_AT_REST * change * self->usual;
}

/* The first part of the step in which a law is not gentle and matters: where it begins, of the first where it ends, as
 * a share of the step; 1 where there is none. */
static double first_rough(const TinkerLawWatch *self, const TinkerLawForce *law, const TinkerLawStep *step)
{
    TinkerInterval force;
    if (law->is_gentle) return 1;
    const double passes = let_pass(self, law->mass, self->run->choice.tolerance);
    const double part = (step->to - step->from) / PARTS;
    for (int i = 0; i < PARTS; i++)
        if (!tinker_law_enclose(law, step, (double)i / PARTS, (double)(i + 1) / PARTS, &force) &&
            !((force.high - force.low) * part <= passes) && !sets_in(self, law, step))
            return (double)MAX(i, 1) / PARTS;
    return 1;
}

/* N: between the least and the largest force at the ends and in the middle of a part. */
static double spread(const TinkerLawForce *law, const TinkerLawStep *step, double at, double width)
{
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i <= 2; i++) {
        const double force = tinker_law_force_at(law, step, at + 0.5 * i * width);
        least = fmin(least, force);
        most = fmax(most, force);
    }
    return most - least;
}

/* Looks for more than what was found to be missed so far: how much a law changes, as is seen at places, in a part of
 * the step that it is not gentle in, or in a part of that. An enclosure alone is no proof. */
static void find_missed(const TinkerLawWatch *self, TinkerLawForce *law, const TinkerLawStep *step)
{
    TinkerInterval force;
    if (tinker_law_enclose(law, step, 0, 1, &force)) return;
    const double h = step->to - step->from;
    double width = 1.0 / PARTS, at = 0, most = fmax(law->missed.impulse, let_pass(self, law->mass, TINKER_LAW_MISSED));
    for (int i = 0; i < MOST_LOOKS && at < 1; i++) {
        const gboolean gentle = tinker_law_enclose(law, step, at, at + width, &force);
        const gboolean matters = (force.high - force.low) * width * h > most && !(gentle && width * PARTS >= 1);
        const double seen = matters ? spread(law, step, at, width) : 0;
        if (seen * width * h > most) {
            most = seen * width * h;
            law->missed = (TinkerLawMissed){most, seen, step->from + at * h, h};
        }
        if (matters && !gentle && width > TINKER_LAW_LEAST) {
            width *= 0.5;
            continue;
        }
        at += width;
        width = fmin(fmin(2 * width, 1.0 / PARTS), 1 - at);
    }
}

static TinkerPoint *points_of(const TinkerLawWatch *self, int end)
{
    return self->points + (gsize)end * (gsize)self->model->points;
}

static TinkerLawStep step_of(const TinkerLawWatch *self, int from, int to)
{
    return (TinkerLawStep){self->times[from],   self->times[to],     points_of(self, from),
                           points_of(self, to), self->model->origin, to - from == 1};
}

/* Looks at the steps of a group, which is then over. */
static void end_group(TinkerLawWatch *self)
{
    const TinkerLawStep all = step_of(self, 0, self->steps);
    TinkerInterval force;
    find_speed(self);
    for (guint i = 0; i < self->forces->len && self->steps > 0; i++) {
        TinkerLawForce *law = &g_array_index(self->forces, TinkerLawForce, i);
        if (tinker_law_enclose(law, &all, 0, 1, &force)) continue;
        for (int k = 0; k < self->steps; k++) {
            const TinkerLawStep one = step_of(self, k, k + 1);
            find_missed(self, law, &one);
        }
    }
    self->steps = 0;
}

/* That of the block of which most was missed; NULL where that is of another law, or nothing beside the speed that there
 * has been. */
static const TinkerLawMissed *missed_of(const TinkerLawWatch *self, guint i)
{
    const TinkerLawForce *law = &g_array_index(self->forces, TinkerLawForce, i);
    for (guint k = 0; k < self->forces->len; k++) {
        const TinkerLawForce *other = &g_array_index(self->forces, TinkerLawForce, k);
        if (other->block != law->block || k == i) continue;
        if (other->missed.impulse > law->missed.impulse) return NULL;
        if (other->missed.impulse == law->missed.impulse && k < i) return NULL;
    }
    const gboolean matters = law->missed.impulse > let_pass(self, law->mass, TINKER_LAW_MISSED);
    return matters ? &law->missed : NULL;
}

void tinker_law_watch_tell(TinkerLawWatch *self)
{
    end_group(self);
    for (guint i = 0; i < self->forces->len; i++) {
        const TinkerLawMissed *missed = missed_of(self, i);
        if (missed == NULL) continue;
        const TinkerLawForce *law = &g_array_index(self->forces, TinkerLawForce, i);
        double *most = &self->run->summary.missed;
        *most = fmax(*most, missed->impulse / (missed->impulse + law->mass * self->speed));
        tinker_summary_warn_of_method(
            &self->run->summary,
            g_strdup_printf(_("%s: at about t = %.6g s its law changes by %.3g N within a small part of a "
                              "step of %.3g s, which %s does not resolve (take an adaptive method, such as "
                              "dopri5, or a much smaller step)"),
                            tinker_scene_block_name(self->model->scene, law->block), missed->at, missed->change,
                            missed->step, self->run->choice.method->id));
    }
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

static TinkerStatus begin(TinkerLawWatch *self)
{
    const TinkerIslandRun *run = self->run;
    const gsize bytes = (gsize)run->system.system.size * sizeof(double);
    self->from.t = run->state.t;
    memcpy(self->from.q, run->state.q, bytes);
    memcpy(self->from.v, run->state.v, bytes);
    memcpy(self->from.books, run->state.books, (gsize)run->system.system.books * sizeof(double));
    self->start.t = NAN;
    self->work = run->system.projection_work;
    self->error = run->system.position_error;
    return place(self, self->points);
}

/* To make the step again: however often, what the method evaluates first is evaluated once. */
static TinkerStatus go_back(TinkerLawWatch *self)
{
    TinkerModelSystem *of = &self->run->system;
    const TinkerState *from = &self->from;
    TinkerStatus status = TINKER_OK;
    tinker_island_run_go_back(self->run, from, self->work, self->error);
    if (isnan(self->start.t))
        status = of->system.acceleration(of->system.context, from->t, from->q, from->v, self->force, self->power);
    if (status != TINKER_OK) return status;
    self->start = (TinkerEvaluated){from->t, from->q, from->v, self->force, self->power};
    of->known = &self->start;
    return TINKER_OK;
}

/* All laws along the whole of a step. */
static void enclose_all(TinkerLawWatch *self, const TinkerLawStep *step)
{
    for (guint i = 0; i < self->forces->len; i++) {
        TinkerLawForce *law = &g_array_index(self->forces, TinkerLawForce, i);
        law->is_gentle = tinker_law_enclose(law, step, 0, 1, &law->whole);
    }
}

/* The share of the step that is gentle; 1: all of it. */
static double gentle_share(TinkerLawWatch *self, const TinkerLawStep *step)
{
    double share = 1;
    find_speed(self);
    for (guint i = 0; i < self->forces->len && share > 1.0 / PARTS; i++)
        share = fmin(share, first_rough(self, &g_array_index(self->forces, TinkerLawForce, i), step));
    return share;
}

/* A step of a fixed length. What an event changed between two of them begins another group. */
static TinkerStatus step_in_group(TinkerLawWatch *self, double limit, TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    const gsize bytes = (gsize)self->model->points * sizeof(TinkerPoint);
    TinkerPoint *now = points_of(self, GROUP + 1);
    TinkerStatus status = place(self, now);
    if (self->steps > 0 && memcmp(now, points_of(self, self->steps), bytes) != 0) end_group(self);
    if (self->steps == 0) {
        memcpy(points_of(self, 0), now, bytes);
        self->times[0] = run->state.t;
    }
    if (status == TINKER_OK) status = tinker_island_run_make_step(run, limit, report);
    if (status == TINKER_OK) status = place(self, points_of(self, self->steps + 1));
    if (status != TINKER_OK) return status;
    self->times[++self->steps] = run->state.t;
    if (self->steps == GROUP) end_group(self);
    return TINKER_OK;
}

/* Behind a step: stops a run whose law jumps back and forth without end. */
static TinkerStatus look_for_chatter(TinkerLawWatch *self, const TinkerLawStep *step)
{
    for (guint i = 0; i < self->forces->len; i++) {
        TinkerLawForce *law = &g_array_index(self->forces, TinkerLawForce, i);
        if (!tinker_law_chatters(law, step, self->end)) continue;
        tinker_model_tell_failure(
            self->model,
            _("%s: its law jumps back and forth in steps of %.3g s, as a force does that turns against the motion "
              "whenever that turns, and the run would hardly end (let it pass through zero gently, as tanh(vx/0.001) "
              "does in place of vx/abs(vx), or take the friction of a support)"),
            tinker_scene_block_name(self->model->scene, law->block), step->to - step->from);
        return TINKER_FAILED;
    }
    return TINKER_OK;
}

/* A step that is made again as long as it is not gentle. */
static TinkerStatus step_adaptively(TinkerLawWatch *self, double limit, TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    const double from = run->state.t, least = TINKER_LAW_LEAST * fmax(from, limit - from);
    TinkerStatus status = begin(self);
    self->times[0] = from;
    limit = fmin(limit, from + self->most);
    for (int rejected = 0; status == TINKER_OK; rejected++) {
        status = tinker_island_run_make_step(run, limit, report);
        if (status == TINKER_OK) status = place(self, points_of(self, 1));
        if (status != TINKER_OK) break;
        report->rejected = rejected += report->rejected;
        self->times[1] = run->state.t;
        const TinkerLawStep step = step_of(self, 0, 1);
        enclose_all(self, &step);
        const double h = run->state.t - from, share = h <= least ? 1 : gentle_share(self, &step);
        if (share >= 1) {
            self->most = 2 * fmax(h, self->most);
            self->usual = fmax(h, TINKER_LAW_FADING * self->usual);
            return look_for_chatter(self, &step);
        }
        status = go_back(self);
        self->most = share * h;
        limit = from + self->most;
    }
    return status;
}

TinkerStatus tinker_law_watch_step(TinkerLawWatch *self, double limit, TinkerStepReport *report)
{
    if (tinker_method_is_adaptive(self->run->choice.method)) return step_adaptively(self, limit, report);
    return step_in_group(self, limit, report);
}
