/* Another program on the same display: writes the picture on the clipboard to a file (PPM). Usage: clipboard FILE */
#include <gtk/gtk.h>
#include <stdio.h>

#define PATIENCE 20 /* s */

typedef struct {
    const char *path;
    GMainLoop *loop;
    gboolean asked;
    int status;
} Reader;

static void end(Reader *reader, int status)
{
    reader->status = status;
    g_main_loop_quit(reader->loop);
}

static gboolean write_picture(GdkTexture *texture, const char *path)
{
    gsize width = (gsize)gdk_texture_get_width(texture), height = (gsize)gdk_texture_get_height(texture);
    g_autofree guint32 *pixels = g_new(guint32, width * height);
    gdk_texture_download(texture, (guchar *)pixels, 4 * width);
    FILE *file = fopen(path, "wb");
    if (file == NULL) return FALSE;
    fprintf(file, "P6\n%zu %zu\n255\n", width, height);
    for (gsize i = 0; i < width * height; i++) {
        const guint8 colour[] = {(guint8)(pixels[i] >> 16), (guint8)(pixels[i] >> 8), (guint8)pixels[i]};
        fwrite(colour, 1, sizeof colour, file);
    }
    return fclose(file) == 0;
}

static void on_texture(GObject *clipboard, GAsyncResult *result, gpointer data)
{
    Reader *reader = data;
    g_autoptr(GError) error = NULL;
    g_autoptr(GdkTexture) texture = gdk_clipboard_read_texture_finish(GDK_CLIPBOARD(clipboard), result, &error);
    if (texture == NULL) g_printerr("clipboard: %s\n", error->message);
    end(reader, texture != NULL && write_picture(texture, reader->path) ? 0 : 1);
}

/* What there is becomes known some time after the start. */
static void on_changed(GdkClipboard *clipboard, gpointer data)
{
    Reader *reader = data;
    if (reader->asked || !gdk_content_formats_contain_mime_type(gdk_clipboard_get_formats(clipboard), "image/png"))
        return;
    reader->asked = TRUE;
    gdk_clipboard_read_texture_async(clipboard, NULL, on_texture, reader);
}

static gboolean on_late(gpointer data)
{
    g_printerr("clipboard: there is no picture on it\n");
    end(data, 1);
    return G_SOURCE_REMOVE;
}

int main(int argc, char **argv)
{
    if (argc != 2 || !gtk_init_check()) {
        g_printerr("usage: clipboard FILE, on a display\n");
        return 2;
    }
    Reader reader = {argv[1], g_main_loop_new(NULL, FALSE), FALSE, 1};
    GdkClipboard *clipboard = gdk_display_get_clipboard(gdk_display_get_default());
    g_signal_connect(clipboard, "changed", G_CALLBACK(on_changed), &reader);
    on_changed(clipboard, &reader);
    guint late = g_timeout_add_seconds(PATIENCE, on_late, &reader);
    g_main_loop_run(reader.loop);
    if (reader.asked) g_source_remove(late);
    g_main_loop_unref(reader.loop);
    return reader.status;
}
