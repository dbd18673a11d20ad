/* The menus of what controls and meters a block, or the scene, can have. */
#ifndef TINKER_GUI_INSTRUMENT_MENU_H
#define TINKER_GUI_INSTRUMENT_MENU_H

#include <gio/gio.h>

#include "scene/store/scene.h"

/* Items of win.add-control, whose target is the number's name; of win.add-meter, that of the quantity. (transfer full)
 */
GMenuModel *tinker_control_menu_new(const TinkerBlockClass *block_class);
GMenuModel *tinker_meter_menu_new(const TinkerScene *scene, TinkerBlockId block);

#endif
