#include "start-offers.h"

#include <string.h>

const TinkerStartOption *start_find_option(const StartFixture *f, const GPtrArray *options, TinkerStartKind kind,
                                           const char *other)
{
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        if (option->kind == kind && (other == NULL || option->other == start_fixture_block(f, other))) return option;
    }
    return NULL;
}

gboolean start_is_offered(const StartFixture *f, const char *block, TinkerStartKind kind, const char *other)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    return start_find_option(f, options, kind, other) != NULL;
}

double start_value_of(const StartFixture *f, const char *block, TinkerStartKind kind, const char *other)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    const TinkerStartOption *option = start_find_option(f, options, kind, other);
    g_assert_nonnull(option);
    g_assert_true(option->asks);
    return option->value;
}

gboolean start_try_apply(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value,
                         GError **error)
{
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    const TinkerStartOption *option = start_find_option(f, options, kind, other);
    g_assert_nonnull(option);
    return tinker_start_apply(f->history, f->scene, option, value, error);
}

void start_apply(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value)
{
    g_autoptr(GError) error = NULL;
    g_assert_true(start_try_apply(f, block, kind, other, value, &error));
    g_assert_no_error(error);
    start_fixture_assert_one_step(f);
    g_autoptr(GPtrArray) options = tinker_start_options_new(f->scene, start_fixture_block(f, block));
    const TinkerStartOption *option = start_find_option(f, options, kind, other);
    if (option != NULL && option->asks) physics_assert_near(option->label, option->value, value, 1e-12);
}

void start_assert_refused(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value,
                          const char *part)
{
    g_autoptr(GError) error = NULL;
    g_assert_false(start_try_apply(f, block, kind, other, value, &error));
    g_assert_nonnull(error);
    g_test_message("%s", error->message);
    g_assert_nonnull(strstr(error->message, part));
    start_fixture_assert_untouched(f);
}

static void assert_vector(const StartFixture *f, const char *block, int32_t meaning, double x, double y)
{
    physics_assert_near(block, start_fixture_get(f, block, meaning, 0), x, 1e-10);
    physics_assert_near(block, start_fixture_get(f, block, meaning, 1), y, 1e-10);
}

void start_assert_at(const StartFixture *f, const char *block, double x, double y)
{
    assert_vector(f, block, TINKER_MEANING_POSITION, x, y);
}

void start_assert_moves(const StartFixture *f, const char *block, double x, double y)
{
    assert_vector(f, block, TINKER_MEANING_VELOCITY, x, y);
}
