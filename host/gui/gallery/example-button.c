/* The title has at most two lines, so that pictures stand in a row. */
#include "gui/gallery/example-button.h"

#include "gui/text/translate.h"
#include "gui/widget/tooltip.h"

GtkWidget *tinker_example_button_new(const TinkerExample *example, TinkerExamplePictures *pictures)
{
    GtkWidget *button = gtk_button_new(), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    const char *title = tinker_translate_title(example->title, example->description);
    GtkWidget *picture = gtk_picture_new(), *label = gtk_label_new(title);
    gtk_widget_set_size_request(picture, TINKER_EXAMPLE_WIDTH, TINKER_EXAMPLE_HEIGHT);
    gtk_widget_set_halign(picture, GTK_ALIGN_CENTER);
    gtk_picture_set_can_shrink(GTK_PICTURE(picture), TRUE);
    gtk_widget_set_overflow(picture, GTK_OVERFLOW_HIDDEN);
    gtk_widget_add_css_class(picture, "welcome-picture");
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    gtk_label_set_max_width_chars(GTK_LABEL(label), 1);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_lines(GTK_LABEL(label), 2);
    gtk_label_set_justify(GTK_LABEL(label), GTK_JUSTIFY_CENTER);
    gtk_label_set_yalign(GTK_LABEL(label), 0);
    gtk_widget_set_vexpand(label, TRUE);
    gtk_widget_set_hexpand(label, TRUE);
    gtk_box_append(GTK_BOX(box), picture);
    gtk_box_append(GTK_BOX(box), label);
    gtk_button_set_child(GTK_BUTTON(button), box);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_add_css_class(button, "welcome-example");
    tinker_widget_begin_tooltip(button, tinker_translate(example->description));
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, title, -1);
    tinker_example_pictures_add(pictures, picture, example->path);
    return button;
}

void tinker_example_button_set_small(GtkWidget *button, gboolean small)
{
    const int share = small ? 2 : 1;
    GtkWidget *picture = gtk_widget_get_first_child(gtk_button_get_child(GTK_BUTTON(button)));
    gtk_widget_set_size_request(picture, TINKER_EXAMPLE_WIDTH / share, TINKER_EXAMPLE_HEIGHT / share);
    if (small)
        gtk_widget_add_css_class(button, "small");
    else
        gtk_widget_remove_css_class(button, "small");
}
