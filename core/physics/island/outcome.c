/* What becomes of the run of an island: events, how far it is valid, how it fails. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/island/island-run.h"
#include "physics/model/model.h"
#include "physics/system/books.h"
#include "physics/system/summary.h"
#include "physics/system/system.h"

void tinker_island_run_add_event(TinkerIslandRun *run, const char *kind, const char *blocks)
{
    TinkerEvent *event = g_new0(TinkerEvent, 1);
    *event = (TinkerEvent){
        .time = run->state.t, .island = run->model->body_blocks[0], .kind = g_strdup(kind), .blocks = g_strdup(blocks)};
    g_ptr_array_add(run->summary.events, event);
}

gboolean tinker_island_run_fail_at(TinkerIslandRun *run, double t, const char *why, GError **error)
{
    TinkerSummary *summary = &run->summary;
    summary->simulated_s = t;
    summary->valid_until = fmin(summary->valid_until, t);
    g_set_error(error, TINKER_MODEL_ERROR,
                run->model->lacks_memory ? TINKER_MODEL_ERROR_MEMORY : TINKER_MODEL_ERROR_RUN,
                _("the run stopped at t = %.6g s: %s; what was computed is to be believed up to t = %.6g s"), t,
                why != NULL && why[0] != '\0' ? why : _("a force or a constraint cannot be worked out there"),
                summary->valid_until);
    return FALSE;
}

gboolean tinker_island_run_fail(TinkerIslandRun *run, const char *why, GError **error)
{
    return tinker_island_run_fail_at(run, run->state.t, why, error);
}

TinkerStatus tinker_island_run_mark_valid(TinkerIslandRun *run)
{
    TinkerSummary *summary = &run->summary;
    run->looked_at = summary->steps;
    tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    tinker_island_run_place(run);
    double extent, speed;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    if (tinker_contacts_act(run->model->contacts)) extent = fmax(extent, tinker_contacts_extent(run->model->contacts));
    TinkerState plane = {run->state.t, run->q, run->v, run->state.books};
    TinkerStatus status = tinker_books_look(&run->books, &plane, extent, summary);
    if (status == TINKER_OK && run->books.imbalance <= TINKER_BALANCED) summary->valid_until = run->state.t;
    return status;
}

gboolean tinker_island_run_fail_step(TinkerIslandRun *run, const char *why, GError **error)
{
    g_autofree char *kept = g_strdup(why);
    tinker_island_run_mark_valid(run);
    return tinker_island_run_fail(run, kept, error);
}
