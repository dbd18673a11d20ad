/* Contact in the run of an island: finds the instants at which contacts close, open, stick or slip, ends the step
 * there, and changes what is closed. Between them the island is stepped as if it had no contacts but for the closed
 * ones' equations. */
#ifndef TINKER_CORE_CONTACT_RUN_H
#define TINKER_CORE_CONTACT_RUN_H

#include "physics/contact/contacts.h"
#include "physics/island/island-run.h"

typedef struct _TinkerContactRun TinkerContactRun;

/* NULL where nothing of the island can touch anything. The run is borrowed. (transfer full) */
TinkerContactRun *tinker_contact_run_new(TinkerIslandRun *run);
void tinker_contact_run_free(TinkerContactRun *contact_run);

/* At t = 0: closes what touches, with an impact where it approaches. */
gboolean tinker_contact_run_start(TinkerContactRun *contact_run, GError **error);

/* The state stands on an event that was found and not yet passed: passes it. Does nothing where there is none. */
gboolean tinker_contact_run_pass(TinkerContactRun *contact_run, GError **error);

/* At a break: forces may have jumped, so that what is closed or sticks is asked anew. */
gboolean tinker_contact_run_reclassify(TinkerContactRun *contact_run, GError **error);

/* Around a blow that changes velocities: the first lets what meets at the instant do so before it, and the island is
 * stepped in the plane from there on; the second lets contacts answer, which by Newton's law do not rebound. `given`:
 * by coordinate, the changes of velocities that blocks gave.
 */
gboolean tinker_contact_run_open_blow(TinkerContactRun *contact_run, GError **error);
gboolean tinker_contact_run_close_blow(TinkerContactRun *contact_run, const double *given, GError **error);

/* Before a step to `limit`, which becomes an event that is known to come before it: notes where it starts.
 * TINKER_FAILED, told by the model: bodies overlap that never met. */
TinkerStatus tinker_contact_run_begin(TinkerContactRun *contact_run, double *limit);

/* After the step: looks for the first event in it, and where there is one steps again, to that instant. */
TinkerStatus tinker_contact_run_look(TinkerContactRun *contact_run, TinkerStepReport *report);

/* After a step that failed at its start: forces of what slides may have grown beyond all bounds there, as the equations
 * of sliding bodies do in finite time where those become singular (Painleve). Ends the sliding by an impulse, as of a
 * jam. FALSE: nothing jams there, and the step failed for another cause. */
gboolean tinker_contact_run_jam(TinkerContactRun *contact_run);

/* How a body has been turned by what it touched (rad); NAN: as it was placed. */
double tinker_contact_run_orientation(TinkerContactRun *contact_run, int32_t body, double t);

/* The last instant (s) at which velocities jumped, or are to do so at the state's; -INFINITY for none. */
double tinker_contact_run_last_impact(const TinkerContactRun *contact_run);

/* The last of them (s) that is behind the state; -INFINITY for none. */
double tinker_contact_run_passed_impact(const TinkerContactRun *contact_run);

/* Whether the state stands on an event that was found and not yet passed. */
gboolean tinker_contact_run_has_pending_event(const TinkerContactRun *contact_run);

/* How many states it has looked at in search of events: what it costs. */
gint64 tinker_contact_run_looks(const TinkerContactRun *contact_run);

/* How often the closed contacts have changed. */
gint64 tinker_contact_run_changes(const TinkerContactRun *contact_run);

#endif
