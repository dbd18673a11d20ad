/* Words for the measurements of a trade: one cell of a table each. */
#include "common/words/trade-words.h"

#include <glib/gi18n.h>

char *tinker_trade_value_text(const TinkerTradeSetting *setting)
{
    if (setting->value == 0) return g_strdup("");
    return g_strdup_printf(setting->adaptive ? "%.4g" : "%.6g s", setting->value);
}

char *tinker_trade_note_text(const TinkerTradeRow *row, gboolean in_full)
{
    g_autoptr(GPtrArray) notes = g_ptr_array_new();
    if (row->advised) g_ptr_array_add(notes, _("advised"));
    if (row->at_limit) g_ptr_array_add(notes, _("at the reference's limit"));
    if (row->note != NULL) g_ptr_array_add(notes, in_full ? row->note : _("no result, see below"));
    g_ptr_array_add(notes, NULL);
    return g_strjoinv("; ", (char **)notes->pdata);
}
