/* A popover over a control, in which its range and step are typed. */
#ifndef TINKER_GUI_INSTRUMENT_RANGE_H
#define TINKER_GUI_INSTRUMENT_RANGE_H

#include <gtk/gtk.h>

#include "gui/document/document.h"

void tinker_instrument_range_popup(GtkWidget *over, TinkerDocument *document, int number);

#endif
