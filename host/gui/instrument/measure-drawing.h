/* What is measured, drawn on the canvas: places, legs, an arc, and the value on a ground of its own. */
#ifndef TINKER_GUI_MEASURE_DRAWING_H
#define TINKER_GUI_MEASURE_DRAWING_H

#include <gtk/gtk.h>

#include "gui/instrument/measuring.h"
#include "render/draw/view.h"

/* On all of a widget that lies over the canvas, whose fonts it takes. */
void tinker_measuring_draw(const TinkerMeasuring *measuring, TinkerFrame *frame, const TinkerView *view,
                           GtkWidget *widget, cairo_t *cairo);

#endif
