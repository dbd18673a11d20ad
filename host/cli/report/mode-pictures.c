/* One picture a mode: the state in grey, the displaced scene over it. */
#include <string.h>

#include "cli/report/mode-report.h"
#include "common/overlay/mode-shape.h"
#include "common/words/mode-words.h"
#include "render/picture/ghost.h"

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
    g_autoptr(TinkerFrame) from = tinker_frame_new(report->scene, error);
    g_autoptr(TinkerFrame) to = from != NULL ? tinker_frame_new(report->scene, error) : NULL;
    if (to == NULL) return FALSE;
    TinkerPaintOptions options = tinker_paint_options_default();
    options.theme = theme;
    tinker_mode_place(from, report->analysis, NULL, 0, 0);
    const double amplitude = tinker_mode_amplitude(from);
    for (guint i = 0; i < report->count; i++) {
        const TinkerMode *mode = g_ptr_array_index(report->analysis->modes, i);
        g_autofree char *caption = tinker_mode_caption(report->analysis, mode, i + 1),
                        *file = numbered_path(path, i + 1);
        TinkerGhost ghost = {from, to, caption, TRUE};
        tinker_mode_place(to, report->analysis, mode, amplitude, 0);
        if (!tinker_ghost_to_file(&ghost, width, height, &options, file, error)) return FALSE;
    }
    return TRUE;
}
