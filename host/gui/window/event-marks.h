/* Marks over the time line: the instants at which something happened in the run, or a curve has an extremum. A click on
 * one goes there, and the line says in its tooltip what happened where the pointer is. */
#ifndef TINKER_GUI_EVENT_MARKS_H
#define TINKER_GUI_EVENT_MARKS_H

#include <gtk/gtk.h>

#include "gui/document/player.h"

#define TINKER_TYPE_EVENT_MARKS (tinker_event_marks_get_type())
G_DECLARE_FINAL_TYPE(TinkerEventMarks, tinker_event_marks, TINKER, EVENT_MARKS, GtkWidget)

/* The line with its marks; the line is a scale of time (s), floating. (transfer floating) */
GtkWidget *tinker_event_marks_new(GtkWidget *line);
void tinker_event_marks_set_player(TinkerEventMarks *marks, TinkerPlayer *player);

/* The curve whose extrema are marked, too, above the line its maxima and below it its minima, each of TinkerRunEvent *;
 * NULL: none. Takes references. */
void tinker_event_marks_set_extrema(TinkerEventMarks *marks, GPtrArray *maxima, GPtrArray *minima);

/* Looks whether there are others. */
void tinker_event_marks_update(TinkerEventMarks *marks);

#endif
