/* The bottom line of the window: accuracy at a glance. */
#ifndef TINKER_GUI_STATUS_LINE_H
#define TINKER_GUI_STATUS_LINE_H

#include <gtk/gtk.h>

#include "gui/document/status-text.h"

#define TINKER_TYPE_STATUS_LINE (tinker_status_line_get_type())
G_DECLARE_FINAL_TYPE(TinkerStatusLine, tinker_status_line, TINKER, STATUS_LINE, GtkWidget)

TinkerStatusLine *tinker_status_line_new(void);

/* Shows these facts. */
void tinker_status_line_show(TinkerStatusLine *line, const TinkerStatusFacts *facts);

#endif
