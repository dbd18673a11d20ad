/* A row of labels; screen readers get all of it as the label of the line. */
#include "gui/window/status-line.h"

#include <string.h>

#include "gui/widget/unparent.h"

struct _TinkerStatusLine {
    GtkWidget parent_instance;
    GtkWidget *boxes[TINKER_STATUS_COUNT], *icons[TINKER_STATUS_COUNT], *labels[TINKER_STATUS_COUNT];
    char *shown;
};

G_DEFINE_FINAL_TYPE(TinkerStatusLine, tinker_status_line, GTK_TYPE_WIDGET)

static void show_item(TinkerStatusLine *line, int part, const TinkerStatusItem *item)
{
    gtk_widget_set_visible(line->boxes[part], item->text != NULL);
    if (item->text == NULL) {
        gtk_label_set_text(GTK_LABEL(line->labels[part]), ""); /* whoever reads labels would still find it */
        return;
    }
    GtkWidget *label = line->labels[part];
    if (strcmp(gtk_label_get_text(GTK_LABEL(label)), item->text) != 0) gtk_label_set_text(GTK_LABEL(label), item->text);
    if (g_strcmp0(gtk_widget_get_tooltip_text(line->boxes[part]), item->tooltip) != 0)
        gtk_widget_set_tooltip_text(line->boxes[part], item->tooltip);
    gtk_widget_set_visible(line->icons[part], item->warning);
    if (item->warning)
        gtk_widget_add_css_class(line->boxes[part], "warning");
    else
        gtk_widget_remove_css_class(line->boxes[part], "warning");
}

void tinker_status_line_show(TinkerStatusLine *line, const TinkerStatusFacts *facts)
{
    TinkerStatusItem items[TINKER_STATUS_COUNT];
    tinker_status_fill(facts, items);
    for (int part = 0; part < TINKER_STATUS_COUNT; part++)
        show_item(line, part, &items[part]);
    g_autofree char *text = tinker_status_line_text(items);
    tinker_status_clear(items);
    if (g_strcmp0(text, line->shown) == 0) return;
    gtk_accessible_update_property(GTK_ACCESSIBLE(line), GTK_ACCESSIBLE_PROPERTY_LABEL, text, -1);
    g_free(line->shown);
    line->shown = g_steal_pointer(&text);
}

static void tinker_status_line_dispose(GObject *object)
{
    TinkerStatusLine *line = TINKER_STATUS_LINE(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_pointer(&line->shown, g_free);
    G_OBJECT_CLASS(tinker_status_line_parent_class)->dispose(object);
}

static void tinker_status_line_class_init(TinkerStatusLineClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_status_line_dispose;
    gtk_widget_class_set_layout_manager_type(widget_class, GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_css_name(widget_class, "statusline");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_STATUS);
}

static void add_part(TinkerStatusLine *line, GtkWidget *row, int part)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    line->boxes[part] = box;
    line->icons[part] = gtk_image_new_from_icon_name("dialog-warning-symbolic");
    line->labels[part] = gtk_label_new(NULL);
    gtk_label_set_ellipsize(GTK_LABEL(line->labels[part]), PANGO_ELLIPSIZE_END);
    gtk_widget_add_css_class(line->labels[part], "numeric");
    gtk_box_append(GTK_BOX(box), line->icons[part]);
    gtk_box_append(GTK_BOX(box), line->labels[part]);
    gtk_widget_set_visible(box, FALSE);
    gtk_box_append(GTK_BOX(row), box);
}

static void tinker_status_line_init(TinkerStatusLine *line)
{
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 24);
    for (int part = 0; part < TINKER_STATUS_COUNT; part++) {
        if (part == TINKER_STATUS_EVENT) { /* from here on at the other end; as high as a label before there is any */
            GtkWidget *gap = gtk_label_new(NULL);
            gtk_widget_set_hexpand(gap, TRUE);
            gtk_box_append(GTK_BOX(row), gap);
        }
        add_part(line, row, part);
    }
    gtk_widget_set_parent(row, GTK_WIDGET(line));
    gtk_widget_set_hexpand(GTK_WIDGET(line), TRUE);
}

TinkerStatusLine *tinker_status_line_new(void)
{
    return g_object_new(TINKER_TYPE_STATUS_LINE, NULL);
}
