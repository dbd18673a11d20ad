/* One control or meter: its title, what it is turned or read by, its value. Its commands are actions instrument.* of
 * the widget. */
#ifndef TINKER_GUI_INSTRUMENT_VIEW_H
#define TINKER_GUI_INSTRUMENT_VIEW_H

#include <gtk/gtk.h>

#include "gui/instrument/hand.h"

#define TINKER_TYPE_INSTRUMENT_VIEW (tinker_instrument_view_get_type())
G_DECLARE_FINAL_TYPE(TinkerInstrumentView, tinker_instrument_view, TINKER, INSTRUMENT_VIEW, GtkWidget)

/* Of the instrument of this number in tinker_scene_instruments. The hand is borrowed and outlives it. (transfer
 * floating) */
TinkerInstrumentView *tinker_instrument_view_new(TinkerDocument *document, TinkerPlayer *player, TinkerHand *hand,
                                                 int number);

/* Whether it can show this one, so that it can stay where the scene has changed; and which it shows from now on. */
gboolean tinker_instrument_view_fits(TinkerInstrumentView *view, const TinkerSceneInstrument *instrument);
void tinker_instrument_view_set_number(TinkerInstrumentView *view, int number);
int tinker_instrument_view_number(TinkerInstrumentView *view);

/* What it is moved by. Borrowed. */
GtkWidget *tinker_instrument_view_bar(TinkerInstrumentView *view);

#endif
