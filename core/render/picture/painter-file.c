/* Pictures in files: the world beside what stands in the corner of the canvas. */
#include <math.h>

#include "render/draw/surface.h"
#include "render/picture/painter-private.h"

typedef struct {
    TinkerFrame *frame;
    const double *box;
    const TinkerPaintOptions *options;
} FilePicture;

/* Fits the world under or beside what stands in the corner of the canvas, whichever leaves it larger. */
static TinkerView fit_beside_corner(const FilePicture *picture, double width, double height)
{
    TinkerView view = {.scale = 1, .width = width, .height = height};
    double corner[4] = {0}, title_width, title_height = 0, margin = TINKER_PICTURE_MARGIN * fmin(width, height);
    tinker_fields_corner(picture->frame, &view, picture->options, corner);
    if (picture->options->show_title) {
        TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
        TinkerText title = tinker_picture_title(picture->frame, width, corner[2]);
        tinker_text_measure(&pen, &title, &title_width, &title_height);
        tinker_text_pen_clear(&pen);
    }
    double beneath = fmin(fmax(corner[3], title_height), height / 2), beside = fmin(corner[2], width / 2);
    TinkerView below = tinker_view_fit(picture->box, width, height - beneath, margin);
    TinkerView right = tinker_view_fit(picture->box, width - beside, height - title_height, margin);
    gboolean choose_right = right.scale > below.scale;
    view = choose_right ? right : below;
    tinker_view_pan(&view, choose_right ? beside : 0, choose_right ? title_height : beneath);
    view.width = width;
    view.height = height;
    return view;
}

static void draw_file_picture(cairo_t *cairo, double width, double height, gpointer data)
{
    const FilePicture *picture = data;
    TinkerView view = fit_beside_corner(picture, width, height);
    tinker_paint_scene(cairo, picture->frame, &view, picture->options);
}

gboolean tinker_paint_to_file(TinkerFrame *frame, const double box[4], int width, int height,
                              const TinkerPaintOptions *options, const char *path, GError **error)
{
    double bounds[4];
    if (!box) tinker_painter_bounds(frame, bounds);
    FilePicture picture = {frame, box ? box : bounds, options};
    return tinker_surface_to_file(draw_file_picture, &picture, width, height, path, error);
}
