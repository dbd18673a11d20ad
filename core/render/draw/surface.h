/* Pictures in files: what scene and plot share. */
#ifndef TINKER_RENDER_SURFACE_H
#define TINKER_RENDER_SURFACE_H

#include <cairo.h>
#include <glib.h>

/* Draws a picture of this width and height. */
typedef void (*TinkerDrawFunction)(cairo_t *cairo, double width, double height, gpointer data);

/* Draws to a .png, .svg or .pdf by the ending of `path`. The file appears whole or not at all. Errors: G_FILE_ERROR,
 * with G_FILE_ERROR_INVAL for another ending or a size outside 1 to 16384. */
gboolean tinker_surface_to_file(TinkerDrawFunction draw, gpointer data, int width, int height, const char *path,
                                GError **error);

#endif
