/* The forces at the time that is shown, worked out once for all who show them. No widget. */
#ifndef TINKER_GUI_FORCES_NOW_H
#define TINKER_GUI_FORCES_NOW_H

#include "gui/document/player.h"

/* Of TinkerActingForce, of the player's present time; empty where the scene cannot run. Where working them out takes
 * long, those of a little earlier while it plays. Borrowed, valid until the next call. */
const GArray *tinker_forces_now(TinkerDocument *document, TinkerPlayer *player);

#endif
