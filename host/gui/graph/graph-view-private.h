/* What the files of a graph's view share. */
#ifndef TINKER_GUI_GRAPH_VIEW_PRIVATE_H
#define TINKER_GUI_GRAPH_VIEW_PRIVATE_H

#include "gui/graph/graph-plot.h"
#include "gui/graph/graph-view.h"

struct _TinkerGraphView {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    int number;
    char *identity; /* block, quantities */
    gboolean floats, show_values;
    GtkWidget *bar, *title, *place_button, *plot, *corner;
    gint64 told; /* us: when the value was told last */
};

/* Its commands, by menu and by key; graph-commands.c. */
void graph_view_install_commands(GtkWidgetClass *widget_class);
/* Opens the menu by the right button. */
void graph_view_on_right_press(GtkGestureClick *gesture, int presses, double x, double y, TinkerGraphView *view);

#endif
