/* Two parts with a movable border; a block that is activated in the outline is edited above. */
#include "side-panel.h"

#include "outline.h"
#include "property-panel.h"

#define PROPERTIES_HEIGHT 240 /* px: at least */
#define OUTLINE_HEIGHT    168

GtkWidget *tinker_side_panel_new(TinkerDocument *document, TinkerPlayer *player)
{
    GtkWidget *paned = gtk_paned_new(GTK_ORIENTATION_VERTICAL);
    GtkWidget *properties = tinker_property_panel_new(document, player), *outline = tinker_outline_new(document);
    gtk_widget_set_size_request(properties, -1, PROPERTIES_HEIGHT);
    gtk_widget_set_size_request(outline, -1, OUTLINE_HEIGHT);
    gtk_paned_set_start_child(GTK_PANED(paned), properties);
    gtk_paned_set_end_child(GTK_PANED(paned), outline);
    gtk_paned_set_shrink_start_child(GTK_PANED(paned), FALSE);
    gtk_paned_set_shrink_end_child(GTK_PANED(paned), FALSE);
    gtk_paned_set_resize_end_child(GTK_PANED(paned), FALSE);
    gtk_widget_set_vexpand(paned, TRUE);
    gtk_widget_add_css_class(paned, "side-panel");
    g_signal_connect_object(outline, "activated", G_CALLBACK(tinker_property_panel_focus), properties,
                            G_CONNECT_SWAPPED);
    return paned;
}
