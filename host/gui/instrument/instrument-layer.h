/* The controls and meters on the canvas, each at its place in the world, as far as that can be seen; they are dragged
 * by their titles, or moved by Shift and the arrow keys. */
#ifndef TINKER_GUI_INSTRUMENT_LAYER_H
#define TINKER_GUI_INSTRUMENT_LAYER_H

#include "gui/graph/graph-layer.h"
#include "gui/instrument/instrument-edit.h"

#define TINKER_TYPE_INSTRUMENT_LAYER (tinker_instrument_layer_get_type())
G_DECLARE_FINAL_TYPE(TinkerInstrumentLayer, tinker_instrument_layer, TINKER, INSTRUMENT_LAYER, GtkWidget)

/* Over that canvas, whose graphs new ones do not cover. Takes references. (transfer floating) */
GtkWidget *tinker_instrument_layer_new(TinkerCanvas *canvas, TinkerGraphLayer *graphs, TinkerDocument *document,
                                       TinkerPlayer *player);

/* A place in the view that is free of blocks, graphs and other instruments; it makes way where no run tells yet where
 * blocks go. */
void tinker_instrument_layer_find_room(TinkerInstrumentLayer *layer, TinkerInstrumentPlace *place);

/* Draws them as they are seen, where they are on the canvas. */
void tinker_instrument_layer_draw(TinkerInstrumentLayer *layer, cairo_t *cairo);

#endif
