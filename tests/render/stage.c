#include "stage.h"

#include "scene-fixture.h"

void test_stage_open(TestStage *stage, const char *blocks)
{
    g_autoptr(GError) error = NULL;
    stage->scene = scene_fixture_read_blocks(blocks);
    stage->frame = tinker_frame_new(stage->scene, &error);
    g_assert_no_error(error);
    stage->picture = test_picture_new(TEST_STAGE_WIDTH, TEST_STAGE_HEIGHT);
    stage->view = (TinkerView){.scale = 50,
                               .origin_x = TEST_STAGE_WIDTH / 2,
                               .origin_y = TEST_STAGE_HEIGHT / 2,
                               .width = TEST_STAGE_WIDTH,
                               .height = TEST_STAGE_HEIGHT};
    stage->options = tinker_paint_options_default();
    stage->options.show_grid = FALSE;
    stage->options.show_labels = FALSE;
    stage->written = tinker_written_texts_new();
}

void test_stage_paint(TestStage *stage)
{
    cairo_matrix_t before, after;
    cairo_get_matrix(stage->picture->cairo, &before);
    g_ptr_array_set_size(stage->written, 0);
    tinker_paint_scene_noting(stage->picture->cairo, stage->frame, &stage->view, &stage->options, stage->written);
    cairo_get_matrix(stage->picture->cairo, &after);
    g_assert_cmpmem(&before, sizeof before, &after, sizeof after);
}

void test_stage_close(TestStage *stage)
{
    g_ptr_array_unref(stage->written);
    test_picture_free(stage->picture);
    tinker_frame_free(stage->frame);
    tinker_scene_free(stage->scene);
}

int test_stage_shown(const TestStage *stage, int colour)
{
    return test_picture_count(stage->picture, stage->options.theme->colours[colour]);
}

const TinkerWrittenText *test_stage_text(const TestStage *stage, const char *text)
{
    for (guint i = 0; i < stage->written->len; i++) {
        const TinkerWrittenText *written = g_ptr_array_index(stage->written, i);
        if (g_str_equal(written->text, text)) return written;
    }
    return NULL;
}
