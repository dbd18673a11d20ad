/* What the user is told of plugins that were refused. No widget. */
#ifndef TINKER_GUI_REFUSAL_NOTICES_H
#define TINKER_GUI_REFUSAL_NOTICES_H

#include "gui/widget/notice-bar.h"
#include "plugin/catalogue/catalogue.h"

/* A notice for each library that was refused, with the reason; of TinkerNotice *. Its button forgets all refusals, so
 * that the libraries are looked at again at the next start. The catalogue is borrowed for as long as the notices live.
 * (transfer full) */
GPtrArray *tinker_refusal_notices(TinkerCatalogue *catalogue);

#endif
