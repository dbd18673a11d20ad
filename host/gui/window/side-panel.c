/* Two parts with a movable border; a block that is activated in the outline is edited above. */
#include "gui/window/side-panel.h"

#include <glib/gi18n.h>

#include "gui/canvas/outline.h"
#include "gui/property/property-panel.h"

#define PAGE_HEIGHT      160 /* px: at least */
#define OUTLINE_HEIGHT   130 /* where there is room */
#define EQUATIONS_WIDTH  440
#define EQUATIONS_HEIGHT 300     /* that of a window of 500, but for the head of the outline */
#define STACK            "stack" /* data of the panel: what holds its pages */
#define OUTLINE          "outline"
#define PROPERTIES       "properties"

static GtkWidget *scrolled(GtkWidget *child)
{
    GtkWidget *window = gtk_scrolled_window_new();
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(window), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(window), child);
    return window;
}

/* Pages behind a switch: what the scene is about, what a block is, and how it starts. */
static GtkWidget *pages_of(GtkWidget *stack, GtkWidget *card, GtkWidget *properties, GtkWidget *start,
                           GtkWidget *equations)
{
    GtkWidget *switcher = gtk_stack_switcher_new(), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0);
    gtk_stack_add_titled(GTK_STACK(stack), scrolled(card), "scene", _("Scene"));
    gtk_stack_add_titled(GTK_STACK(stack), properties, "properties", _("Properties"));
    gtk_stack_add_titled(GTK_STACK(stack), scrolled(start), "start", _("Start"));
    GtkWidget *model = scrolled(equations);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(model), GTK_POLICY_AUTOMATIC, GTK_POLICY_AUTOMATIC);
    gtk_widget_set_size_request(model, EQUATIONS_WIDTH, EQUATIONS_HEIGHT);
    gtk_stack_add_titled(GTK_STACK(stack), model, "equations", _("Equations"));
    gtk_stack_set_hhomogeneous(GTK_STACK(stack), FALSE); /* equations are larger than the rest */
    gtk_stack_set_vhomogeneous(GTK_STACK(stack), FALSE);
    gtk_widget_set_size_request(stack, -1, PAGE_HEIGHT);
    gtk_stack_set_visible_child_name(GTK_STACK(stack), "properties");
    gtk_stack_switcher_set_stack(GTK_STACK_SWITCHER(switcher), GTK_STACK(stack));
    gtk_box_layout_set_homogeneous(GTK_BOX_LAYOUT(gtk_widget_get_layout_manager(switcher)), FALSE);
    gtk_widget_add_css_class(switcher, "panel-switcher");
    gtk_widget_set_vexpand(stack, TRUE);
    gtk_box_append(GTK_BOX(box), switcher);
    gtk_box_append(GTK_BOX(box), stack);
    return box;
}

/* A scene that is opened is introduced, if it says what it is about. */
static void on_replaced(TinkerDocument *document, GtkStack *stack)
{
    const char *description = tinker_scene_head(tinker_document_scene(document))->description;
    gtk_stack_set_visible_child_name(stack, *description != '\0' ? "scene" : "properties");
}

/* Whoever selects a block wants to know about that. */
static void on_selection_changed(TinkerDocument *document, GtkStack *stack)
{
    int selected;
    tinker_document_selection(document, &selected);
    if (selected > 0 && g_strcmp0(gtk_stack_get_visible_child_name(stack), "scene") == 0)
        gtk_stack_set_visible_child_name(stack, "properties");
}

GtkWidget *tinker_side_panel_new(TinkerDocument *document, TinkerPlayer *player, GtkWidget *start, GtkWidget *card,
                                 GtkWidget *equations)
{
    GtkWidget *paned = gtk_paned_new(GTK_ORIENTATION_VERTICAL);
    GtkWidget *properties = tinker_property_panel_new(document, player), *outline = tinker_outline_new(document);
    GtkWidget *stack = gtk_stack_new(), *pages = pages_of(stack, card, properties, start, equations);
    g_object_set_data(G_OBJECT(paned), STACK, stack);
    g_object_set_data(G_OBJECT(paned), OUTLINE, outline);
    g_object_set_data(G_OBJECT(paned), PROPERTIES, properties);
    gtk_widget_set_size_request(outline, -1, OUTLINE_HEIGHT);
    gtk_paned_set_start_child(GTK_PANED(paned), pages);
    gtk_paned_set_end_child(GTK_PANED(paned), outline);
    gtk_paned_set_shrink_start_child(GTK_PANED(paned), FALSE);
    gtk_paned_set_resize_end_child(GTK_PANED(paned), FALSE);
    gtk_widget_set_vexpand(paned, TRUE);
    gtk_widget_add_css_class(paned, "side-panel");
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), stack, 0);
    g_signal_connect_object(document, "selection-changed", G_CALLBACK(on_selection_changed), stack, 0);
    g_signal_connect_object(outline, "activated", G_CALLBACK(tinker_property_panel_focus), properties,
                            G_CONNECT_SWAPPED);
    return paned;
}

GtkWidget *tinker_side_panel_properties(GtkWidget *side_panel)
{
    return g_object_get_data(G_OBJECT(side_panel), PROPERTIES);
}

GtkWidget *tinker_side_panel_outline(GtkWidget *side_panel)
{
    return g_object_get_data(G_OBJECT(side_panel), OUTLINE);
}

gboolean tinker_side_panel_show(GtkWidget *side_panel, const char *page)
{
    GtkStack *stack = g_object_get_data(G_OBJECT(side_panel), STACK);
    if (gtk_stack_get_child_by_name(stack, page) == NULL) return FALSE;
    gtk_stack_set_visible_child_name(stack, page);
    return TRUE;
}
