/* Pieces of advice, and lists of them. */
#include "analysis/start/advice-private.h"

static void advice_free(gpointer data)
{
    TinkerAdvice *advice = data;
    g_free(advice->message);
    g_free(advice->repair);
    g_array_unref(advice->blocks);
    g_clear_pointer(&advice->vectors, g_array_unref);
    g_free(advice);
}

GPtrArray *advice_array_new(void)
{
    return g_ptr_array_new_with_free_func(advice_free);
}

TinkerAdvice *advice_add(GPtrArray *all, TinkerAdviceKind kind, gboolean blocks_run, char *message)
{
    TinkerAdvice *advice = g_new0(TinkerAdvice, 1);
    *advice = (TinkerAdvice){.kind = kind, .blocks_run = blocks_run, .message = message, .target = TINKER_NO_BLOCK};
    advice->blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    g_ptr_array_add(all, advice);
    return advice;
}

void advice_add_block(TinkerAdvice *advice, TinkerBlockId block)
{
    g_array_append_val(advice->blocks, block);
}

void advice_add_vector(TinkerAdvice *advice, TinkerBlockId block, double x, double y, double rate)
{
    TinkerAdviceVector vector = {block, x, y, rate};
    if (advice->vectors == NULL) advice->vectors = g_array_new(FALSE, FALSE, sizeof(TinkerAdviceVector));
    g_array_append_val(advice->vectors, vector);
}
