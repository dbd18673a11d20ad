/* The page *Modes*: how the scene moves of itself, a little, about its rest. The mode that is chosen swings on the
 * canvas. */
#ifndef TINKER_GUI_MODES_PAGE_H
#define TINKER_GUI_MODES_PAGE_H

#include "gui/canvas/canvas.h"
#include "gui/document/document.h"
#include "gui/document/player.h"
#include "gui/mode/modes-task.h"

#define TINKER_TYPE_MODES_PAGE (tinker_modes_page_get_type())
G_DECLARE_FINAL_TYPE(TinkerModesPage, tinker_modes_page, TINKER, MODES_PAGE, GtkWidget)

/* Takes a reference to the document, the player, which stands still while a mode swings, and to the task, which works
 * the modes out. (transfer floating) */
GtkWidget *tinker_modes_page_new(TinkerDocument *document, TinkerPlayer *player, TinkerCanvas *canvas,
                                 TinkerModesTask *task);

#endif
