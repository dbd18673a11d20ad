/* What the files of the search for events share. */
#ifndef TINKER_CORE_CONTACT_SEARCH_PRIVATE_H
#define TINKER_CORE_CONTACT_SEARCH_PRIVATE_H

#include "physics/event/contact-run-private.h"

/* contact-falls.c */

/* Whether the trigger's value follows from where the bodies are and how they move, without the forces on them. */
gboolean tinker_trigger_is_of_place(const TinkerTrigger *trigger);

/* Brings the model to a time within the last step; *v gets the velocities of the bodies then. Where the forces of
 * contacts that were worked out last are those of that time they stand: every contact that has just begun to slip asks
 * for the step's start. */
TinkerStatus tinker_contact_search_look(TinkerContactRun *contact_run, double t, double **v);
/* Likewise, for what triggers alone ask for: that may be kept of the step's start. */
TinkerStatus tinker_contact_search_ask(TinkerContactRun *contact_run, double t, double **v);
TinkerStatus tinker_contact_search_value(TinkerContactRun *contact_run, double t, const TinkerTrigger *trigger,
                                         double *value);

/* The first fall of one trigger between two times and before one that is known, by its values at the nodes between
 * them; INFINITY for none, NAN where it has to be looked at more closely. */
double tinker_contact_search_first_fall(TinkerContactRun *contact_run, const TinkerTrigger *trigger,
                                        const double *values, double from, double to, double known);

/* contact-soon.c */

/* Whether no trigger comes near its level, by far: from the values at the ends of the step, and where these change from
 * the one in its middle as well. What is at the end serves the next step as what is at its start. *clear is FALSE where
 * that is not so, or not sure. */
TinkerStatus tinker_contact_search_far_off(TinkerContactRun *contact_run, double from, double to, gboolean *clear);
/* Where contacts follow upon one another, the first event is that of a place soon after the step's start. Then nothing
 * has to be known of forces behind it. *done is FALSE where that is not so, or not sure. */
TinkerStatus tinker_contact_search_soon(TinkerContactRun *contact_run, double from, double to, TinkerTrigger *found,
                                        double *time, gboolean *done);

#endif
