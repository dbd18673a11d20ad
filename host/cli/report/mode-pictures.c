/* One picture a mode: the state in grey, the displaced scene over it. */
#include <math.h>
#include <string.h>

#include "cli/report/mode-report.h"
#include "render/picture/ghost.h"

/* Of the scene's greater side: how far the largest component is drawn. */
#define DRAWN_AMPLITUDE 0.12

/* Puts the bodies where they are in the state, `amplitude` m along the shape. */
static void place_bodies(TinkerFrame *frame, const TinkerModeAnalysis *analysis, const TinkerMode *mode,
                         double amplitude)
{
    double origin[2], x, y, orientation;
    tinker_model_origin(analysis->model, origin);
    for (int32_t body = 0; body < tinker_model_sizes(analysis->model).bodies; body++) {
        TinkerBlockId block = tinker_model_body_block(analysis->model, body);
        tinker_frame_centre(frame, block, &x, &y, &orientation);
        double dx = mode != NULL ? amplitude * mode->real[2 * body] : 0;
        double dy = mode != NULL ? amplitude * mode->real[2 * body + 1] : 0;
        double radius;
        const int32_t turn = tinker_model_body_turn(analysis->model, body, &radius);
        if (turn >= 0) orientation = (analysis->q[turn] + (mode != NULL ? amplitude * mode->real[turn] : 0)) / radius;
        tinker_frame_place(frame, block, origin[0] + analysis->q[2 * body] + dx,
                           origin[1] + analysis->q[2 * body + 1] + dy, orientation);
    }
}

char *tinker_mode_caption(const TinkerMode *mode, guint number)
{
    double hertz = mode->natural / (2 * G_PI);
    switch (mode->kind) {
    case TINKER_MODE_RIGID:
        return g_strdup_printf("Mode %u: moves freely, 0 Hz", number);
    case TINKER_MODE_DECAY:
        return g_strdup_printf("Mode %u: decays at %.4g 1/s", number, mode->decay);
    case TINKER_MODE_GROWTH:
        return g_strdup_printf("Mode %u: unstable, grows at %.4g 1/s", number, -mode->decay);
    case TINKER_MODE_OSCILLATION:
        break;
    }
    if (mode->damping_ratio == 0) return g_strdup_printf("Mode %u: %.4g Hz", number, hertz);
    return g_strdup_printf("Mode %u: %.4g Hz, damping ratio %.3g", number, hertz, mode->damping_ratio);
}

static char *numbered_path(const char *path, guint number)
{
    const char *dot = strrchr(path, '.');
    return g_strdup_printf("%.*s-%u%s", (int)(dot - path), path, number, dot);
}

gboolean tinker_mode_pictures_add(TinkerFileSet *files, const char *path, guint count, GError **error)
{
    for (guint number = 1; number <= count; number++) {
        g_autofree char *file = numbered_path(path, number);
        if (!tinker_file_set_add_output(files, "--output", file, error)) return FALSE;
    }
    return TRUE;
}

gboolean tinker_mode_report_draw(const TinkerModeReport *report, const TinkerTheme *theme, int width, int height,
                                 const char *path, GError **error)
{
    double box[4];
    g_autoptr(TinkerFrame) from = tinker_frame_new(report->scene, error);
    g_autoptr(TinkerFrame) to = from != NULL ? tinker_frame_new(report->scene, error) : NULL;
    if (to == NULL) return FALSE;
    TinkerPaintOptions options = tinker_paint_options_default();
    options.theme = theme;
    place_bodies(from, report->analysis, NULL, 0);
    tinker_painter_bounds(from, box);
    double amplitude = DRAWN_AMPLITUDE * fmax(box[2] - box[0], box[3] - box[1]);
    for (guint i = 0; i < report->count; i++) {
        const TinkerMode *mode = g_ptr_array_index(report->analysis->modes, i);
        g_autofree char *caption = tinker_mode_caption(mode, i + 1), *file = numbered_path(path, i + 1);
        TinkerGhost ghost = {from, to, caption, TRUE};
        place_bodies(to, report->analysis, mode, amplitude);
        if (!tinker_ghost_to_file(&ghost, width, height, &options, file, error)) return FALSE;
    }
    return TRUE;
}
