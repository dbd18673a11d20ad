/* Asks libadwaita, which follows the desktop. */
#include "gui/widget/desktop-theme.h"

#include <adwaita.h>

const TinkerTheme *tinker_desktop_theme(void)
{
    AdwStyleManager *manager = adw_style_manager_get_default();
    gboolean dark = adw_style_manager_get_dark(manager);
    if (adw_style_manager_get_high_contrast(manager))
        return tinker_theme_find(dark ? "contrast-dark" : "contrast-light");
    return tinker_theme_find(dark ? "dark" : "light");
}

void tinker_desktop_theme_redraws(GtkWidget *widget)
{
    AdwStyleManager *manager = adw_style_manager_get_default();
    g_signal_connect_object(manager, "notify::dark", G_CALLBACK(gtk_widget_queue_draw), widget, G_CONNECT_SWAPPED);
    g_signal_connect_object(manager, "notify::high-contrast", G_CALLBACK(gtk_widget_queue_draw), widget,
                            G_CONNECT_SWAPPED);
}
