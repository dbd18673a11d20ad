/* The page of all graphs of the scene, with a row to add one. */
#ifndef TINKER_GUI_GRAPH_PAGE_H
#define TINKER_GUI_GRAPH_PAGE_H

#include <gtk/gtk.h>

#include "gui/document/player.h"

#define TINKER_TYPE_GRAPH_PAGE (tinker_graph_page_get_type())
G_DECLARE_FINAL_TYPE(TinkerGraphPage, tinker_graph_page, TINKER, GRAPH_PAGE, GtkWidget)

/* Takes references. (transfer floating) */
GtkWidget *tinker_graph_page_new(TinkerDocument *document, TinkerPlayer *player);

#endif
