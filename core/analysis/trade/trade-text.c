/* The results of a trade in words. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/trade/trade-private.h"

/* "rk4 with a step of 0.01 s" */
static char *setting_text(const TinkerTradeSetting *setting)
{
    if (setting->value == 0) return g_strdup(setting->method);
    return setting->adaptive ? g_strdup_printf(_("%s with a tolerance of %g"), setting->method, setting->value)
                             : g_strdup_printf(_("%s with a step of %g s"), setting->method, setting->value);
}

/* "an error of 1.2e-07", as far as it is known. */
static char *error_text(const TinkerTrade *trade, const TinkerTradeRow *row)
{
    if (!row->at_limit) return g_strdup_printf(_("an error of %.2g"), row->error);
    return g_strdup_printf(_("an error of at most %.2g (the reference is confirmed to no less)"),
                           trade->reference.level);
}

char *tinker_trade_advice_text(const TinkerTrade *trade, const TinkerTradeOptions *options)
{
    const TinkerTradeRow *row = &trade->advice.row;
    if (trade->advice.kind == TINKER_TRADE_ADVICE_NONE)
        return g_strdup(_("No advice: no method ran this scene to its end."));
    g_autofree char *setting = setting_text(&row->setting), *error = error_text(trade, row);
    g_autofree char *wall = tinker_duration_text(row->wall_s, 3), *motion = tinker_duration_text(trade->duration, 3);
    gboolean met = trade->advice.kind == TINKER_TRADE_ADVICE_MET;
    if (options->budget > 0) {
        g_autofree char *budget = tinker_duration_text(options->budget, 3);
        return met ? g_strdup_printf(_("Within %s the most accurate is %s: %s in %s, for %s of motion."), budget,
                                     setting, error, wall, motion)
                   : g_strdup_printf(
                         _("Nothing measured runs within %s. The fastest is %s: %s in %s, for %s of motion."), budget,
                         setting, error, wall, motion);
    }
    return met ? g_strdup_printf(_("For an error of at most %g the cheapest is %s: %s in %s, for %s of motion."),
                                 options->error, setting, error, wall, motion)
               : g_strdup_printf(
                     _("Nothing measured keeps to an error of %g. The most accurate is %s: %s in %s, for %s of "
                       "motion."),
                     options->error, setting, error, wall, motion);
}

char *tinker_trade_reference_text(const TinkerTrade *trade)
{
    const TinkerTradeReference *reference = &trade->reference;
    g_autofree char *truth = setting_text(&reference->truth), *witness = setting_text(&reference->witness);
    if (reference->whole)
        return g_strdup_printf(
            _("Errors are measured against %s; %s confirms it to %.2g of the extent (%.3g m) and the "
              "largest speed (%.3g m/s)."),
            truth, witness, reference->level, reference->extent, reference->speed);
    const char *why = reference->predictable
                          ? _("as there was no time to make them finer")
                          : _("as fine as they get: beyond, the motion is not predictable to what was wished for");
    return g_strdup_printf(
        _("Errors are measured up to t = %.4g s of %.4g s, against %s. %s confirms it up to there, to %.2g of "
          "the extent (%.3g m) and the largest speed (%.3g m/s); then the two part, %s."),
        reference->until, trade->duration, truth, witness, reference->level, reference->extent, reference->speed, why);
}
