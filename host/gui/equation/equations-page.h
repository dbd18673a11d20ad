/* The page "Equations" of the side panel: the model as equations, and of what is selected its diagram and its books. */
#ifndef TINKER_GUI_EQUATIONS_PAGE_H
#define TINKER_GUI_EQUATIONS_PAGE_H

#include "gui/equation/model-task.h"

#include <gtk/gtk.h>

#define TINKER_TYPE_EQUATIONS_PAGE (tinker_equations_page_get_type())
G_DECLARE_FINAL_TYPE(TinkerEquationsPage, tinker_equations_page, TINKER, EQUATIONS_PAGE, GtkWidget)

/* Takes references. (transfer floating) */
GtkWidget *tinker_equations_page_new(TinkerDocument *document, TinkerPlayer *player);

/* Whether what it shows is yet to be worked out. */
gboolean tinker_equations_page_is_behind(TinkerEquationsPage *page);

#endif
