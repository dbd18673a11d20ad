/* What is offered and what it does is the core's (analysis/start/start-conditions.h); here are words and the way from
 * an entry to the document. */
#include "gui/start/start-offer.h"

#include <glib/gi18n.h>
#include <string.h>

#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"

char *tinker_start_button_text(const char *label)
{
    static const char *const small[] = {"a",  "an", "and", "as",  "at", "by", "from",
                                        "in", "of", "on",  "the", "to", "up"};
    g_auto(GStrv) words = g_strsplit(label, " ", -1);
    for (char **word = words; *word != NULL; word++) {
        gboolean is_small = FALSE;
        for (gsize i = 0; i < G_N_ELEMENTS(small); i++)
            is_small |= g_str_equal(*word, small[i]);
        if (!is_small || word == words) **word = g_ascii_toupper(**word);
    }
    return g_strjoinv(" ", words);
}

char *tinker_start_button_label(const TinkerStartOption *option)
{
    gboolean is_english = g_str_equal(_("At rest"), "At rest"); /* header capitals are */
    return is_english ? tinker_start_button_text(option->label) : g_strdup(option->label);
}

static const char *unit_of(TinkerScene *scene, const TinkerStartOption *option)
{
    return tinker_unit_for(option->dimension, tinker_scene_head(scene)->units);
}

char *tinker_start_value_text(TinkerScene *scene, const TinkerStartOption *option, gboolean trims)
{
    return tinker_number_write(option->value, option->dimension, NULL, tinker_scene_head(scene)->units, trims);
}

gboolean tinker_start_value_parse(TinkerScene *scene, const TinkerStartOption *option, const char *text, double *si,
                                  GError **error)
{
    return property_parse_number(text, option->dimension, unit_of(scene, option), si, error);
}

const TinkerStartOption *tinker_start_find(const GPtrArray *options, TinkerStartKind kind, TinkerBlockId other)
{
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        if (option->kind == kind && option->other == other) return option;
    }
    return NULL;
}

gboolean tinker_start_do(TinkerDocument *document, TinkerPlayer *player, const TinkerStartOption *option, double value,
                         GError **error)
{
    tinker_document_interrupt(document);
    if (!tinker_start_apply(tinker_document_history(document), tinker_document_scene(document), option, value, error))
        return FALSE;
    if (tinker_player_time(player) > 0) tinker_player_rewind(player);
    tinker_document_touch(document);
    return TRUE;
}

GMenuModel *tinker_start_menu_new(TinkerDocument *document)
{
    TinkerScene *scene = tinker_document_scene(document);
    g_autoptr(GPtrArray) options = tinker_start_options_new(scene, tinker_document_selected(document));
    g_autoptr(GMenu) menu = g_menu_new();
    for (guint i = 0; i < options->len; i++) {
        const TinkerStartOption *option = g_ptr_array_index(options, i);
        if (option->asks) continue;
        g_autofree char *text = tinker_start_button_label(option);
        g_autoptr(GMenuItem) item = g_menu_item_new(text, NULL);
        g_menu_item_set_action_and_target(item, "win.start", "(ii)", (gint32)option->kind, (gint32)option->other);
        g_menu_append_item(menu, item);
    }
    return g_menu_model_get_n_items(G_MENU_MODEL(menu)) > 0 ? G_MENU_MODEL(g_steal_pointer(&menu)) : NULL;
}
