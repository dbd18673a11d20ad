/* Offering what a process left behind that did not end properly. */
#ifndef TINKER_GUI_WINDOW_RECOVERY_H
#define TINKER_GUI_WINDOW_RECOVERY_H

#include "gui/window/window.h"

/* Asks whether to recover what there is, if anything; opens it in this window, and in new ones. */
void tinker_window_offer_recovery(TinkerWindow *window, AdwApplication *application);

#endif
