/* The strip below the pages: to the start, play or pause, step, the time line, the time, the speed. */
#ifndef TINKER_GUI_PLAYBAR_H
#define TINKER_GUI_PLAYBAR_H

#include <gtk/gtk.h>

#include "gui/document/player.h"
#include "gui/window/event-marks.h"

#define TINKER_TYPE_PLAYBAR (tinker_playbar_get_type())
G_DECLARE_FINAL_TYPE(TinkerPlaybar, tinker_playbar, TINKER, PLAYBAR, GtkWidget)

/* Follows this player, which it takes a reference of; the buttons are the actions win.play, win.step,
 * win.reset, and a time that is typed is given to win.go-to. */
void tinker_playbar_set_player(TinkerPlaybar *playbar, TinkerPlayer *player);
/* Looks whether more is known of the run, which happens while nothing moves. */
void tinker_playbar_update(TinkerPlaybar *playbar);

/* The marks on the time line. Borrowed. */
TinkerEventMarks *tinker_playbar_marks(TinkerPlaybar *playbar);

#endif
