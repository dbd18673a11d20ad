/* What a choice does to the run settings is worked out on a copy of the scene; the history then takes over its head. */
#include "gui/document/run-choice.h"

#include <glib/gi18n.h>

static gboolean take_over(TinkerDocument *document, const char *title, const TinkerSceneHead *head, GError **error)
{
    tinker_document_begin(document, title, NULL);
    gboolean done = tinker_history_set_head(tinker_document_history(document), head, error);
    if (done)
        tinker_document_end(document);
    else
        tinker_document_abort(document);
    return done;
}

gboolean tinker_run_choice_use(TinkerDocument *document, const TinkerTradeRow *row, GError **error)
{
    g_autoptr(TinkerScene) draft = tinker_scene_copy(tinker_document_scene(document));
    const TinkerTrade chosen = {.advice = {.kind = TINKER_TRADE_ADVICE_MET, .row = *row}};
    tinker_trade_apply(&chosen, draft);
    g_autofree char *title = g_strdup_printf(_("Use %s"), row->setting.method);
    return take_over(document, title, tinker_scene_head(draft), error);
}

gboolean tinker_run_choice_automatic(TinkerDocument *document, GError **error)
{
    static char automatic[] = "auto";
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    head.run.method = automatic; /* which is copied */
    return take_over(document, _("Choose Method Automatically"), &head, error);
}

gboolean tinker_run_choice_record(TinkerDocument *document, double interval, GError **error)
{
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    head.run.interval = interval;
    return take_over(document, _("Record More Often"), &head, error);
}

char *tinker_run_choice_text(const TinkerTradeSetting *setting)
{
    if (setting->value == 0) return g_strdup(setting->method);
    return setting->adaptive ? g_strdup_printf(_("%s with a tolerance of %g"), setting->method, setting->value)
                             : g_strdup_printf(_("%s with a step of %g s"), setting->method, setting->value);
}
