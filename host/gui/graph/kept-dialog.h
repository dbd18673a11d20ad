/* The runs that are kept: shown or hidden, called otherwise, taken away. */
#ifndef TINKER_GUI_KEPT_DIALOG_H
#define TINKER_GUI_KEPT_DIALOG_H

#include <gtk/gtk.h>

#include "gui/document/document.h"
#include "gui/document/kept-runs.h"

/* Opens it over a window; the runs are called what they are beside the document's scene. */
void tinker_kept_dialog_open(GtkWindow *over, TinkerDocument *document, TinkerKeptRuns *runs);

#endif
