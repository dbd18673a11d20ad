/* What the files of the layer share. */
#ifndef TINKER_GUI_INSTRUMENT_LAYER_PRIVATE_H
#define TINKER_GUI_INSTRUMENT_LAYER_PRIVATE_H

#include "gui/instrument/instrument-layer.h"
#include "gui/instrument/instrument-room.h"
#include "gui/instrument/instrument-view.h"

struct _TinkerInstrumentLayer {
    GtkWidget parent_instance;
    TinkerCanvas *canvas;
    TinkerGraphLayer *graphs;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerHand *hand;
    GPtrArray *views;        /* of TinkerInstrumentView, which are children: borrowed */
    GArray *boxes;           /* of TinkerGraphBox: where these are */
    InstrumentRoom room;     /* what they keep clear of: of blocks on a small canvas alone */
    gboolean has_looked;     /* that is up to date */
    TinkerPlayerState state; /* of the player when it was heard of last */
    gboolean awaits_run;     /* which began since, and whose way is not known yet */

    TinkerInstrumentView *dragged; /* borrowed; NULL: none */
    double press[2], from[2], way[2];
};

/* Places; instrument-places.c. */

/* On a small canvas they are smaller, so that they leave something of it to be seen. */
double instrument_layer_shrinkage(TinkerInstrumentLayer *layer);
/* Where one is wanted: always within the layer, however the canvas is looked at. One without a place stands at the
 * left, below the fields. */
TinkerGraphBox instrument_layer_wanted_box(TinkerInstrumentLayer *layer, TinkerInstrumentView *view);
/* The boxes of all, in order. One that is dragged goes where the pointer takes it, and the others stay until it is
 * there. */
void instrument_layer_arrange(TinkerInstrumentLayer *layer);
/* What is in the way is asked for when everything that shows the scene has caught up with it. */
void instrument_layer_look_again(TinkerInstrumentLayer *layer);
/* The player has moved, or begun or ended something. */
void instrument_layer_on_moved(TinkerInstrumentLayer *layer);
void instrument_layer_on_state_changed(TinkerInstrumentLayer *layer);

/* Takes the pointer and the keys that move a view; instrument-moving.c. */
void instrument_layer_let_move(TinkerInstrumentLayer *layer, TinkerInstrumentView *view);

#endif
