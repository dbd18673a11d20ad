/* Sentences about what a plugin did wrong, as the failure of the model. */
#include "physics/model/failures.h"

#include <glib/gi18n-lib.h>

#include "plugin/call/guarded.h"
#include "plugin/call/words.h"

/* For the translators: what is worked out, as "Spring 0: its tension at t = 1 s is not a number". Quantities of blocks
 * go by their ids. */
G_GNUC_UNUSED static const char *const worked_out[] = {
    N_("tension"), N_("stiffness or damping"), N_("force"), N_("constraint"), N_("energy"),
};

/* Of one text. Made with the first of a model, since few of very many islands fail. */
#define TEXT_BYTES 512

void tinker_model_tell_failure(TinkerModel *model, const char *format, ...)
{
    va_list values;
    if (model->failure_text == NULL) model->failure_text = g_malloc(TEXT_BYTES);
    va_start(values, format);
    g_vsnprintf(model->failure_text, TEXT_BYTES, format, values);
    va_end(values);
    model->failure = model->failure_text;
}

static const char *name_of_row(const TinkerModel *model, const TinkerBlockBatch *batch, int32_t row)
{
    return tinker_scene_block_name(model->scene, batch->ids[CLAMP(row, 0, batch->count - 1)]);
}

TinkerStatus tinker_model_fail(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what,
                               const char *why)
{
    const TinkerBlockClass *at_fault = batch->block_class;
    const char *name = name_of_row(model, batch, row);
    g_autofree char *words = tinker_plugin_words(at_fault, NULL, why);
    if (words != NULL)
        tinker_model_tell_failure(model, _("%s: its %s at t = %g s cannot be worked out: %s"), name, _(what),
                                  model->time, words);
    else
        tinker_model_tell_failure(
            model, _("%s: its %s at t = %g s failed, and its plugin does not say why (block type %s of the plugin %s)"),
            name, _(what), model->time, at_fault->type->id, at_fault->plugin->id);
    return TINKER_FAILED;
}

TinkerStatus tinker_model_check_guards(TinkerModel *model)
{
    const TinkerBlockClass *at_fault = NULL;
    for (guint i = 0; i < model->batches->len && at_fault == NULL; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (!tinker_guarded_is_whole(batch->scratch)) at_fault = batch->block_class;
    }
    if (at_fault != NULL) {
        tinker_model_tell_failure(
            model,
            _("the plugin %s wrote beyond the scratch of its block type %s, so nothing that it computes is to be "
              "believed (tell its author)"),
            at_fault->plugin->id, at_fault->type->id);
        return TINKER_FAILED;
    }
    if (tinker_guarded_is_whole(model->chunk)) return TINKER_OK;
    tinker_model_tell_failure(
        model,
        _("a plugin wrote beyond the results that it was asked for, so nothing that is computed is to be believed "
          "(\"tinker plugins check\" finds out which one)"));
    return TINKER_FAILED;
}

TinkerStatus tinker_model_not_finite(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what)
{
    const TinkerBlockClass *at_fault = batch->block_class;
    tinker_model_tell_failure(model, _("%s: its %s at t = %g s is not a number (block type %s of the plugin %s)"),
                              name_of_row(model, batch, row), _(what), model->time, at_fault->type->id,
                              at_fault->plugin->id);
    return TINKER_RETRY_SMALLER;
}
