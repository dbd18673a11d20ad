/* Which quantities a run records. */
#ifndef TINKER_GUI_RECORDED_QUANTITIES_H
#define TINKER_GUI_RECORDED_QUANTITIES_H

#include "gui/document/document.h"
#include "gui/document/run-task.h"

/* All of the scene, where those are not many; else what its graphs and the selection show. Its energies only where they
 * are shown, where the run is to be `brief`. And what was asked for (of TinkerQuantity). Of TinkerQuantity. (transfer
 * full) */
GArray *tinker_recorded_quantities(TinkerDocument *document, const GArray *asked, gboolean brief);

#endif
