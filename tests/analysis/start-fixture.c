/* A scene, its history, and its text as it was. */
#include "start-fixture.h"

StartFixture *start_fixture_new(const char *blocks)
{
    StartFixture *fixture = g_new0(StartFixture, 1);
    fixture->scene = physics_scene(NULL, blocks);
    fixture->history = tinker_history_new(fixture->scene);
    fixture->text = tinker_scene_to_text(fixture->scene, TINKER_WRITE_SI);
    return fixture;
}

void start_fixture_free(StartFixture *fixture)
{
    tinker_history_free(fixture->history);
    tinker_scene_free(fixture->scene);
    g_free(fixture->text);
    g_free(fixture);
}

TinkerBlockId start_fixture_block(const StartFixture *fixture, const char *name)
{
    TinkerBlockId block = tinker_scene_find_block(fixture->scene, name);
    if (block == TINKER_NO_BLOCK) g_error("no block is called %s", name);
    return block;
}

double start_fixture_get(const StartFixture *fixture, const char *name, int32_t meaning, int32_t component)
{
    TinkerBlockId block = start_fixture_block(fixture, name);
    const TinkerBlockClass *block_class = tinker_scene_block_class(fixture->scene, block);
    int32_t column = tinker_block_class_meaning_column(block_class, meaning);
    g_assert_cmpint(column, >=, 0);
    return tinker_scene_get(fixture->scene, block, column + component);
}

void start_fixture_assert_one_step(StartFixture *fixture)
{
    g_autofree char *done = tinker_scene_to_text(fixture->scene, TINKER_WRITE_SI);
    g_assert_nonnull(tinker_history_can_undo(fixture->history));
    tinker_history_undo(fixture->history);
    g_assert_null(tinker_history_can_undo(fixture->history));
    g_autofree char *undone = tinker_scene_to_text(fixture->scene, TINKER_WRITE_SI);
    g_assert_cmpstr(undone, ==, fixture->text);
    tinker_history_redo(fixture->history);
    g_autofree char *redone = tinker_scene_to_text(fixture->scene, TINKER_WRITE_SI);
    g_assert_cmpstr(redone, ==, done);
}

void start_fixture_assert_untouched(StartFixture *fixture)
{
    g_autofree char *now = tinker_scene_to_text(fixture->scene, TINKER_WRITE_SI);
    g_assert_cmpstr(now, ==, fixture->text);
    g_assert_null(tinker_history_can_undo(fixture->history));
}
