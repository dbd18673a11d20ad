/* The summary of a whole run: as it begins, and from those of its islands. */
#include <math.h>

#include "physics/event/contact-run.h"
#include "physics/island/island-run.h"
#include "physics/model/model.h"
#include "physics/run/island-runs.h"
#include "physics/system/summary.h"

void tinker_event_free(gpointer data)
{
    TinkerEvent *event = data;
    g_free(event->kind);
    g_free(event->blocks);
    g_clear_pointer(&event->alternatives, g_array_unref);
    g_free(event);
}

static void island_summary_free(gpointer data)
{
    TinkerIslandSummary *island = data;
    g_array_unref(island->bodies);
    g_free(island);
}

void tinker_island_runs_open_summary(TinkerIslandRuns *self)
{
    TinkerSummary *summary = &self->summary;
    const TinkerModel *model = self->model;
    summary->start_impulse = model->start_impulse;
    summary->error_estimate = NAN;
    summary->predictable_until = INFINITY;
    summary->accuracy = self->options.accuracy;
    summary->tries = g_array_new(FALSE, FALSE, sizeof(TinkerTry));
    summary->determined_until = INFINITY;
    summary->islands = g_ptr_array_new_with_free_func(island_summary_free);
    summary->events = g_ptr_array_new_with_free_func(tinker_event_free);
    summary->warnings = tinker_warnings_new();
    tinker_warnings_add_copies(summary->warnings, model->warnings);
    char *unmet = tinker_options_unmet(&self->options, model);
    if (unmet != NULL) tinker_summary_warn_of_scene(summary, unmet);
}

void tinker_island_runs_clear_summary(TinkerIslandRuns *self)
{
    g_clear_pointer(&self->summary.tries, g_array_unref);
    g_clear_pointer(&self->summary.islands, g_ptr_array_unref);
    g_clear_pointer(&self->summary.events, g_ptr_array_unref);
    g_clear_pointer(&self->summary.warnings, g_ptr_array_unref);
}

static void add_energy(TinkerSummary *whole, const TinkerSummary *part)
{
    whole->kinetic_start += part->kinetic_start;
    whole->kinetic_end += part->kinetic_end;
    whole->potential_start += part->potential_start;
    whole->potential_end += part->potential_end;
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        whole->books[book] += part->books[book];
    whole->energy_balance_error = fmax(whole->energy_balance_error, part->energy_balance_error);
}

static void add_run(TinkerSummary *whole, TinkerIslandRun *run)
{
    const TinkerSummary *part = &run->summary;
    whole->steps += part->steps;
    whole->rejected_steps += part->rejected_steps;
    whole->evaluations += run->model->evaluations;
    if (run->contacts != NULL) whole->contact_changes += tinker_contact_run_changes(run->contacts);
    whole->simulated_s = fmin(whole->simulated_s, part->simulated_s);
    whole->valid_until = fmin(whole->valid_until, part->valid_until);
    whole->determined_until = fmin(whole->determined_until, part->determined_until);
    whole->missed = fmax(whole->missed, part->missed);
    whole->constraint_position_error = fmax(whole->constraint_position_error, part->constraint_position_error);
    whole->constraint_velocity_error = fmax(whole->constraint_velocity_error, part->constraint_velocity_error);
    add_energy(whole, part);
    if (whole->method == NULL) {
        whole->method = part->method;
        whole->adaptive = part->adaptive;
        whole->step = part->step;
        whole->tolerance = part->tolerance;
    } else if (!g_str_equal(whole->method, part->method)) {
        whole->method = "auto";
    }
}

/* At the first look; by what method, at each, as a contact may have changed that. */
static void tell_islands(TinkerIslandRuns *self)
{
    GPtrArray *islands = self->summary.islands;
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        const TinkerSummary *part = &run->summary;
        if (i == islands->len) {
            TinkerIslandSummary *added = g_new0(TinkerIslandSummary, 1);
            added->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
            g_array_append_vals(added->bodies, run->model->body_blocks, (guint)run->model->bodies);
            g_ptr_array_add(islands, added);
        }
        TinkerIslandSummary *island = g_ptr_array_index(islands, i);
        island->method = part->method;
        island->adaptive = part->adaptive;
        island->step = part->step;
        island->tolerance = part->tolerance;
    }
}

/* Islands run one after another between samples: events are told in the order of their times, whatever the samples are;
 * those of one instant island by island, and within one as they followed on one another: the sort keeps that order. */
static int by_time(const void *left, const void *right)
{
    const TinkerEvent *l = *(TinkerEvent *const *)left, *r = *(TinkerEvent *const *)right;
    if (l->time != r->time) return l->time < r->time ? -1 : 1;
    return (l->island > r->island) - (l->island < r->island);
}

void tinker_island_runs_add_up(TinkerIslandRuns *self)
{
    TinkerSummary *whole = &self->summary, kept = *whole;
    *whole = (TinkerSummary){
        .simulated_s = INFINITY,
        .valid_until = INFINITY,
        .determined_until = INFINITY,
        .wall_s = kept.wall_s,
        .start_impulse = kept.start_impulse,
        .error_estimate = kept.error_estimate,
        .predictable_until = kept.predictable_until,
        .accuracy = kept.accuracy,
        .tries = kept.tries,
        .islands = kept.islands,
        .events = kept.events,
        .warnings = kept.warnings,
    };
    g_ptr_array_sort(whole->events, by_time);
    for (guint i = 0; i < self->runs->len; i++)
        add_run(whole, g_ptr_array_index(self->runs, i));
    tell_islands(self);
}
