/* Start conditions as the window offers them: words, values as they are typed, a menu, and what applying one does. No
 * widget. */
#ifndef TINKER_GUI_START_OFFER_H
#define TINKER_GUI_START_OFFER_H

#include "analysis/start/start-conditions.h"
#include "gui/document/player.h"

/* What it is called on a button or in a menu, which have header capitals in English. (transfer full) */
char *tinker_start_button_label(const TinkerStartOption *option);

/* A label with header capitals: "Released from Equilibrium". (transfer full) */
char *tinker_start_button_text(const char *label);

/* The value as it is now, in the unit that the scene shows: "0.05000 m", trimmed "0.05 m". (transfer full) */
char *tinker_start_value_text(TinkerScene *scene, const TinkerStartOption *option, gboolean trims);

/* Reads what was typed into SI. A number without a unit is in the unit that the scene shows. Errors:
 * TINKER_UNITS_ERROR. */
gboolean tinker_start_value_parse(TinkerScene *scene, const TinkerStartOption *option, const char *text, double *si,
                                  GError **error);

/* The option of this kind about this other block, or NULL. Borrowed. */
const TinkerStartOption *tinker_start_find(const GPtrArray *options, TinkerStartKind kind, TinkerBlockId other);

/* Makes it so, as one step for undo, and takes the player back to the start. Errors as of tinker_start_apply; then
 * nothing has changed. */
gboolean tinker_start_do(TinkerDocument *document, TinkerPlayer *player, const TinkerStartOption *option, double value,
                         GError **error);

/* What asks for no value, of the one block that is selected, as the action "win.start" with kind and other block, (ii).
 * NULL where there is none. (transfer full) */
GMenuModel *tinker_start_menu_new(TinkerDocument *document);

#endif
