#include "advice-checks.h"

#include <string.h>

#include "physics/compile/compile.h"
#include "physics/model/model.h"

const TinkerAdvice *advice_only(const GPtrArray *all, TinkerAdviceKind kind)
{
    if (all->len != 1) {
        for (guint i = 0; i < all->len; i++)
            g_test_message("%s", ((const TinkerAdvice *)g_ptr_array_index(all, i))->message);
        g_error("%u pieces of advice", all->len);
    }
    const TinkerAdvice *advice = g_ptr_array_index(all, 0);
    g_test_message("%s [%s]", advice->message, advice->repair == NULL ? "-" : advice->repair);
    g_assert_cmpint(advice->kind, ==, kind);
    g_assert_cmpuint(advice->blocks->len, >, 0);
    return advice;
}

void advice_assert_only(const StartFixture *f, TinkerAdviceKind kind, gboolean blocks_run, const char *block,
                        const char *part, const char *repair)
{
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    const TinkerAdvice *advice = advice_only(all, kind);
    g_assert_cmpint(advice->blocks_run, ==, blocks_run);
    g_assert_cmpint(g_array_index(advice->blocks, TinkerBlockId, 0), ==, start_fixture_block(f, block));
    g_assert_nonnull(strstr(advice->message, block));
    g_assert_nonnull(strstr(advice->message, part));
    g_assert_cmpstr(advice->repair, ==, repair);
}

void advice_repair(StartFixture *f)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) all = tinker_advice_new(f->scene);
    g_assert_cmpuint(all->len, ==, 1);
    g_assert_true(tinker_advice_repair(f->history, f->scene, g_ptr_array_index(all, 0), &error));
    g_assert_no_error(error);
    start_fixture_assert_one_step(f);
    g_autoptr(GPtrArray) left = tinker_advice_new(f->scene);
    g_assert_cmpuint(left->len, ==, 0);
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, &error);
    g_assert_no_error(error);
    g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 0);
}
