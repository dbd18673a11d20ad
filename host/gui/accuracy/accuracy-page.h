/* The page "Accuracy": measures speed against accuracy on the scene, shows the result as a chart and a table, and uses
 * the point that is chosen. Signals: "told"   (const char *text) something was done that the user should hear of
 */
#ifndef TINKER_GUI_ACCURACY_PAGE_H
#define TINKER_GUI_ACCURACY_PAGE_H

#include <gtk/gtk.h>

#include "gui/document/document.h"

#define TINKER_TYPE_ACCURACY_PAGE (tinker_accuracy_page_get_type())
G_DECLARE_FINAL_TYPE(TinkerAccuracyPage, tinker_accuracy_page, TINKER, ACCURACY_PAGE, GtkWidget)

/* Takes a reference. To be called once. */
void tinker_accuracy_page_set_document(TinkerAccuracyPage *page, TinkerDocument *document);

/* Measures, as its button does; the result is there when it measures no more. */
void tinker_accuracy_page_measure(TinkerAccuracyPage *page);
gboolean tinker_accuracy_page_is_measuring(TinkerAccuracyPage *page);

#endif
