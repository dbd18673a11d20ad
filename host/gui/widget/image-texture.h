/* Painting with Cairo into images that GTK shows: a drawing area would record everything and play it back. */
#ifndef TINKER_GUI_IMAGE_TEXTURE_H
#define TINKER_GUI_IMAGE_TEXTURE_H

#include <gtk/gtk.h>

/* An image of this size in widget units, at `factor` device pixels each; the context draws in widget units. (transfer
 * full) */
cairo_surface_t *tinker_image_new(int width, int height, int factor);

/* What was painted, as a texture. Takes the image over. (transfer full) */
GdkTexture *tinker_image_to_texture(cairo_surface_t *image);

#endif
