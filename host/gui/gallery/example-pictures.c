/* A list of what is wanted, of which an idle source paints the next. */
#include "gui/gallery/example-pictures.h"

#include <adwaita.h>

#include "render/picture/painter.h"
#include "scene/read/scene-json.h"

#define FACTOR 2 /* painted finer than shown, for screens with small pixels */
#define MARGIN 10.0

typedef struct {
    GtkWidget *picture; /* owned */
    char *path;
} Wanted;

struct _TinkerExamplePictures {
    TinkerCatalogue *catalogue;
    GPtrArray *wanted; /* of Wanted */
    guint painted;     /* of them */
    guint painter;     /* id of the idle source, or 0 */
    gulong dark;       /* of the signal */
};

static void wanted_free(gpointer data)
{
    Wanted *wanted = data;
    g_object_unref(wanted->picture);
    g_free(wanted->path);
    g_free(wanted);
}

static GdkTexture *texture_of(cairo_surface_t *surface)
{
    int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    gsize stride = (gsize)cairo_image_surface_get_stride(surface);
    cairo_surface_flush(surface);
    g_autoptr(GBytes) bytes = g_bytes_new_with_free_func(cairo_image_surface_get_data(surface), stride * (gsize)height,
                                                         (GDestroyNotify)cairo_surface_destroy, surface);
    return gdk_memory_texture_new(width, height, GDK_MEMORY_DEFAULT, bytes, stride);
}

/* NULL where the scene cannot be read or drawn. (transfer full) */
static GdkTexture *paint_example(TinkerCatalogue *catalogue, const char *path)
{
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(catalogue, path, NULL, NULL);
    if (scene == NULL) return NULL;
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return NULL;
    TinkerPaintOptions options = tinker_paint_options_default();
    gboolean dark = adw_style_manager_get_dark(adw_style_manager_get_default());
    options.theme = tinker_theme_find(dark ? "dark" : "light");
    options.show_grid = options.show_labels = FALSE;
    double box[4];
    tinker_painter_bounds(frame, box);
    TinkerView view = tinker_view_fit(box, TINKER_EXAMPLE_WIDTH, TINKER_EXAMPLE_HEIGHT, MARGIN);
    cairo_surface_t *surface =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, TINKER_EXAMPLE_WIDTH * FACTOR, TINKER_EXAMPLE_HEIGHT * FACTOR);
    cairo_surface_set_device_scale(surface, FACTOR, FACTOR);
    cairo_t *cairo = cairo_create(surface);
    tinker_paint_scene(cairo, frame, &view, &options);
    cairo_destroy(cairo);
    return texture_of(surface);
}

static gboolean paint_next(gpointer data)
{
    TinkerExamplePictures *pictures = data;
    if (pictures->painted >= pictures->wanted->len) {
        pictures->painter = 0;
        return G_SOURCE_REMOVE;
    }
    const Wanted *wanted = g_ptr_array_index(pictures->wanted, pictures->painted++);
    g_autoptr(GdkTexture) texture = paint_example(pictures->catalogue, wanted->path);
    if (texture != NULL) gtk_picture_set_paintable(GTK_PICTURE(wanted->picture), GDK_PAINTABLE(texture));
    return G_SOURCE_CONTINUE;
}

static void paint(TinkerExamplePictures *pictures)
{
    if (pictures->painter == 0) pictures->painter = g_idle_add_full(G_PRIORITY_LOW, paint_next, pictures, NULL);
}

static void on_dark(TinkerExamplePictures *pictures)
{
    pictures->painted = 0;
    paint(pictures);
}

void tinker_example_pictures_add(TinkerExamplePictures *pictures, GtkWidget *picture, const char *path)
{
    Wanted *wanted = g_new(Wanted, 1);
    *wanted = (Wanted){g_object_ref(picture), g_strdup(path)};
    g_ptr_array_add(pictures->wanted, wanted);
    paint(pictures);
}

TinkerExamplePictures *tinker_example_pictures_new(TinkerCatalogue *catalogue)
{
    TinkerExamplePictures *pictures = g_new0(TinkerExamplePictures, 1);
    pictures->catalogue = catalogue;
    pictures->wanted = g_ptr_array_new_with_free_func(wanted_free);
    pictures->dark =
        g_signal_connect_swapped(adw_style_manager_get_default(), "notify::dark", G_CALLBACK(on_dark), pictures);
    return pictures;
}

void tinker_example_pictures_free(TinkerExamplePictures *pictures)
{
    if (pictures == NULL) return;
    g_clear_handle_id(&pictures->painter, g_source_remove);
    g_signal_handler_disconnect(adw_style_manager_get_default(), pictures->dark);
    g_ptr_array_unref(pictures->wanted);
    g_free(pictures);
}
