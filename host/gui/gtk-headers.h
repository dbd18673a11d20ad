/* As glib-headers.h of core, for the window: of the time of a file of it, its headers take four fifths. */
#include <adwaita.h>
#include <gtk/gtk.h>
