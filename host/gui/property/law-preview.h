/* A law that is being typed, as the equations of a scene are typeset, with a note on its units beneath. */
#ifndef TINKER_GUI_LAW_PREVIEW_H
#define TINKER_GUI_LAW_PREVIEW_H

#include <gtk/gtk.h>

#include "gui/property/property-list.h"

#define TINKER_TYPE_LAW_PREVIEW (tinker_law_preview_get_type())
G_DECLARE_FINAL_TYPE(TinkerLawPreview, tinker_law_preview, TINKER, LAW_PREVIEW, GtkWidget)

/* Takes a reference. (transfer floating) */
GtkWidget *tinker_law_preview_new(TinkerDocument *document);

/* Shows what the text would be as the law of a row (TinkerPropertyRow.is_law); nothing of an empty one. Of one that
 * cannot be read the law before it stays, dimmed; the error is a sentence, and `column` (from 1, 0: none) the place in
 * the text that it is about. */
gboolean tinker_law_preview_show(TinkerLawPreview *preview, const TinkerPropertyRow *row, const char *text, int *column,
                                 GError **error);

#endif
