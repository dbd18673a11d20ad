/* Where the energy of the run is and where it went: layers over time, and beside them bars of the present. */
#ifndef TINKER_GUI_ENERGY_CHART_H
#define TINKER_GUI_ENERGY_CHART_H

#include <gtk/gtk.h>

#include "gui/document/player.h"

/* (transfer floating) */
GtkWidget *tinker_energy_chart_new(TinkerDocument *document, TinkerPlayer *player);

#endif
