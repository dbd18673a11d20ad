#include "drag-stage.h"

static const char blocks[] =
    "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0]},"
    "{\"type\": \"mass\", \"name\": \"B\", \"position\": [3, 0]},"
    "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -3], \"orientation\": \"90 deg\"},"
    "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"A\", [2, 2]]}";

void stage_set_up(Stage *stage, gconstpointer data)
{
    stage->scene = scene_fixture_read_blocks(blocks);
    stage->history = tinker_history_new(stage->scene);
    stage->before = tinker_scene_to_text(stage->scene, TINKER_WRITE_SI);
}

void stage_tear_down(Stage *stage, gconstpointer data)
{
    g_free(stage->before);
    tinker_history_free(stage->history);
    tinker_scene_free(stage->scene);
}

TinkerBlockId stage_block(const Stage *stage, const char *name)
{
    return tinker_scene_find_block(stage->scene, name);
}

TinkerDrag *stage_grab(Stage *stage, const char *name, int32_t part, double x, double y)
{
    TinkerDrag *drag =
        tinker_drag_begin(stage->history, stage->scene, (TinkerHit){stage_block(stage, name), part}, x, y);
    g_assert_nonnull(drag);
    return drag;
}

double stage_value(const TinkerScene *scene, const char *name, int32_t meaning, int32_t component)
{
    const TinkerBlockId block = tinker_scene_find_block(scene, name);
    const int32_t column = tinker_block_class_meaning_column(tinker_scene_block_class(scene, block), meaning);
    return tinker_scene_get(scene, block, column + component);
}

void stage_expect_place(const Stage *stage, const char *name, double x, double y)
{
    g_assert_cmpfloat_with_epsilon(stage_value(stage->scene, name, TINKER_MEANING_POSITION, 0), x, 1e-12);
    g_assert_cmpfloat_with_epsilon(stage_value(stage->scene, name, TINKER_MEANING_POSITION, 1), y, 1e-12);
}

void stage_expect_untouched(const Stage *stage)
{
    g_autofree char *now = tinker_scene_to_text(stage->scene, TINKER_WRITE_SI);
    g_assert_cmpstr(now, ==, stage->before);
    g_assert_null(tinker_history_can_undo(stage->history));
}
