#include "arrow-stage.h"

#include <math.h>

const TinkerView arrow_view = {.scale = 50,
                               .origin_x = ARROW_WIDTH / 2,
                               .origin_y = ARROW_HEIGHT / 2,
                               .width = ARROW_WIDTH,
                               .height = ARROW_HEIGHT};

void arrow_stage_open(ArrowStage *stage, const char *theme, double scale)
{
    stage->picture = test_picture_new(ARROW_WIDTH, ARROW_HEIGHT);
    stage->written = tinker_written_texts_new();
    stage->options = (TinkerArrowOptions){.theme = tinker_theme_find(theme), .scale = scale};
    const double *ground = stage->options.theme->background;
    cairo_set_source_rgb(stage->picture->cairo, ground[0], ground[1], ground[2]);
    cairo_paint(stage->picture->cairo);
}

void arrow_stage_draw(ArrowStage *stage, const TinkerForceArrow *arrows, gsize count)
{
    cairo_matrix_t before, after;
    cairo_get_matrix(stage->picture->cairo, &before);
    tinker_arrows_draw_noting(stage->picture->cairo, &arrow_view, arrows, count, &stage->options, stage->written);
    cairo_get_matrix(stage->picture->cairo, &after);
    g_assert_cmpmem(&before, sizeof before, &after, sizeof after);
}

void arrow_stage_close(ArrowStage *stage)
{
    g_ptr_array_unref(stage->written);
    test_picture_free(stage->picture);
}

const TinkerWrittenText *arrow_stage_written(const ArrowStage *stage, guint i)
{
    return g_ptr_array_index(stage->written, i);
}

double arrow_distance_to(const double box[4], double x, double y)
{
    return hypot(fmax(fmax(box[0] - x, x - box[2]), 0), fmax(fmax(box[1] - y, y - box[3]), 0));
}

void arrow_stage_assert_inside_and_apart(const ArrowStage *stage)
{
    for (guint i = 0; i < stage->written->len; i++) {
        const double *a = arrow_stage_written(stage, i)->box;
        g_assert_true(a[0] >= 0 && a[1] >= 0 && a[2] <= ARROW_WIDTH && a[3] <= ARROW_HEIGHT);
        for (guint n = 0; n < i; n++) {
            const double *b = arrow_stage_written(stage, n)->box;
            g_assert_true(a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1]);
        }
    }
}
