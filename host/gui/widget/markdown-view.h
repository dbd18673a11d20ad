/* A text in Markdown as widgets: as much of Markdown as the documentation needs, headings, paragraphs, lists, tables,
 * listings, pictures and links. */
#ifndef TINKER_GUI_MARKDOWN_VIEW_H
#define TINKER_GUI_MARKDOWN_VIEW_H

#include <gtk/gtk.h>

/* Pictures are looked for from `folder` on. A label whose link is followed asks `follow` first; the rest is GTK's. Its
 * headings are labels that carry their anchor as the widget's name. (transfer floating) */
GtkWidget *tinker_markdown_view_new(const char *text, const char *folder, GCallback follow, gpointer data);

#endif
