/* The texture shares the image's memory. */
#include "gui/widget/image-texture.h"

cairo_surface_t *tinker_image_new(int width, int height, int factor)
{
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width * factor, height * factor);
    cairo_surface_set_device_scale(image, factor, factor);
    return image;
}

GdkTexture *tinker_image_to_texture(cairo_surface_t *image)
{
    cairo_surface_flush(image);
    int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image);
    gsize stride = (gsize)cairo_image_surface_get_stride(image);
    g_autoptr(GBytes) bytes = g_bytes_new_with_free_func(cairo_image_surface_get_data(image), stride * (gsize)height,
                                                         (GDestroyNotify)cairo_surface_destroy, image);
    return gdk_memory_texture_new(width, height, GDK_MEMORY_DEFAULT, bytes, stride);
}
