/* Ruler and protractor over the canvas: a widget that is there while one of them is held, takes the pointer and the
 * keys, and draws what is measured. Signals:
 *   "measured"    there is something else to be read
 *   "put-away"    Escape: whoever gave it the tool takes it back
 */
#ifndef TINKER_GUI_MEASURE_LAYER_H
#define TINKER_GUI_MEASURE_LAYER_H

#include "gui/canvas/canvas.h"
#include "gui/instrument/measuring.h"

#define TINKER_TYPE_MEASURE_LAYER (tinker_measure_layer_get_type())
G_DECLARE_FINAL_TYPE(TinkerMeasureLayer, tinker_measure_layer, TINKER, MEASURE_LAYER, GtkWidget)

/* Takes references. (transfer floating) */
TinkerMeasureLayer *tinker_measure_layer_new(TinkerCanvas *canvas, TinkerDocument *document, TinkerPlayer *player);

/* Begins with a tool, and nothing measured. */
void tinker_measure_layer_begin(TinkerMeasureLayer *layer, TinkerMeasuringKind kind);

/* What is measured, with the place that is pointed at as the next one. */
TinkerMeasuring tinker_measure_layer_measuring(TinkerMeasureLayer *layer);

#endif
