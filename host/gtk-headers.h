/* What the files of the window include, compiled once for all of them (-Db_pch): it is four fifths of the time of a
 * file. Each still includes what it uses. */
#include <adwaita.h>
#include <gtk/gtk.h>
