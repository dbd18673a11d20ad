/* Icons of blocks are drawings of plugins, and are made when the window starts: one that crashes would end the program
 * at every start. So the first drawing of an icon in a run leaves a mark in the state folder for as long as it lasts. A
 * mark that is still there when its run has ended tells of a drawing that ended it: the icon is left out from then on,
 * until the plugin's file is another. */
#ifndef TINKER_GUI_ICON_GUARD_H
#define TINKER_GUI_ICON_GUARD_H

#include "gui/widget/notice-bar.h"
#include "render/picture/icon.h"

/* As tinker_paint_block_icon; draws nothing where the icon is left out. */
void tinker_guarded_icon_paint(cairo_t *cairo, const TinkerBlockClass *block_class, double width, double height,
                               const TinkerTheme *theme);

/* A notice for each icon that is left out, naming block type and plugin; its button has it drawn again at the next
 * start. Of TinkerNotice *. (transfer full) */
GPtrArray *tinker_guarded_icon_notices(void);

#endif
