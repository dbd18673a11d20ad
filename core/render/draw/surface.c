/* A picture is made in memory and then written in one go, so that a full disk or a crash leaves the old one. */
#include "render/draw/surface.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <string.h>

#include "files/replace-file.h"

#define GREATEST_SIZE 16384

typedef enum { FORMAT_PNG, FORMAT_SVG, FORMAT_PDF, FORMAT_UNKNOWN } Format;

static Format format_of(const char *path)
{
    static const char *const endings[] = {[FORMAT_PNG] = ".png", [FORMAT_SVG] = ".svg", [FORMAT_PDF] = ".pdf"};
    g_autofree char *lower = g_ascii_strdown(path, -1);
    for (int i = 0; i < FORMAT_UNKNOWN; i++)
        if (g_str_has_suffix(lower, endings[i])) return (Format)i;
    return FORMAT_UNKNOWN;
}

static cairo_status_t append(void *data, const unsigned char *bytes, unsigned int length)
{
    g_byte_array_append(data, bytes, length);
    return CAIRO_STATUS_SUCCESS;
}

static cairo_surface_t *new_surface(Format format, int width, int height, GByteArray *bytes)
{
    if (format == FORMAT_PNG) return cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    if (format == FORMAT_SVG) {
        cairo_surface_t *surface = cairo_svg_surface_create_for_stream(append, bytes, width, height);
        cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
        return surface;
    }
    return cairo_pdf_surface_create_for_stream(append, bytes, width, height);
}

/* Draws into `bytes`. */
static cairo_status_t draw_bytes(TinkerDrawFunction draw, gpointer data, Format format, int width, int height,
                                 GByteArray *bytes)
{
    cairo_surface_t *surface = new_surface(format, width, height, bytes);
    cairo_t *cairo = cairo_create(surface);
    draw(cairo, width, height, data);
    cairo_status_t status = cairo_status(cairo);
    cairo_destroy(cairo);
    if (status == CAIRO_STATUS_SUCCESS && format == FORMAT_PNG)
        status = cairo_surface_write_to_png_stream(surface, append, bytes);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return status;
}

static gboolean write_file(const char *path, const GByteArray *bytes, GError **error)
{
    g_autoptr(GError) reason = NULL;
    if (tinker_replace_file(path, (const char *)bytes->data, bytes->len, 0666, &reason)) return TRUE;
    g_set_error(error, reason->domain, reason->code, "%s: could not be written: %s", path, reason->message);
    return FALSE;
}

gboolean tinker_surface_to_file(TinkerDrawFunction draw, gpointer data, int width, int height, const char *path,
                                GError **error)
{
    Format format = format_of(path);
    if (format == FORMAT_UNKNOWN) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_INVAL,
                    "%s: no picture is made with this ending (.png, .svg or .pdf)", path);
        return FALSE;
    }
    if (width < 1 || height < 1 || width > GREATEST_SIZE || height > GREATEST_SIZE) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_INVAL, "%s: a picture cannot be %d by %d pixels large (1 to %d)",
                    path, width, height, GREATEST_SIZE);
        return FALSE;
    }
    g_autoptr(GByteArray) bytes = g_byte_array_new();
    cairo_status_t status = draw_bytes(draw, data, format, width, height, bytes);
    if (status != CAIRO_STATUS_SUCCESS) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_FAILED, "%s: could not be drawn: %s", path,
                    cairo_status_to_string(status));
        return FALSE;
    }
    return write_file(path, bytes, error);
}
