/* The font of a widget is that of its style, in dots of the screen; the desktop's is told in points. */
#include "gui/widget/enlargement.h"

#define USUAL_DPI 96.0 /* of a screen of which nothing is told */

double tinker_enlargement(GtkWidget *widget)
{
    g_autofree char *name = NULL;
    int dpi = -1; /* in 1024ths; -1: unknown */
    g_object_get(gtk_widget_get_settings(widget), "gtk-font-name", &name, "gtk-xft-dpi", &dpi, NULL);
    PangoFontDescription *usual = pango_font_description_from_string(name != NULL ? name : "");
    const PangoFontDescription *own = pango_context_get_font_description(gtk_widget_get_pango_context(widget));
    const double points = pango_font_description_get_size(usual), dots = pango_font_description_get_size(own);
    const double size =
        pango_font_description_get_size_is_absolute(own) ? dots * 72 / (dpi > 0 ? dpi / 1024.0 : USUAL_DPI) : dots;
    pango_font_description_free(usual);
    return points > 0 && size > points ? size / points : 1;
}
