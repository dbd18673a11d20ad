/* The outline of a trade: the methods, the reference, a sweep of each method, the advice. */
#include "analysis/trade/trade.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/trade/trade-private.h"
#include "numerics/methods/integrators.h"
#include "physics/impulse/impulse.h"
#include "physics/model/model.h"
#include "units/quantity/units.h"

#define REFERENCE_TIME 0.3  /* of the time for measuring: at most */
#define REFERENCE_WORK 0.15 /* of the progress */
#define LEAST_TIME     0.1  /* of the time: for the methods behind the reference, whatever that took */

/* Methods ---------------------------------------------------------------------------------------------------------- */

/* Those that are built in, then those of plugins; of const TinkerIntegrator *. */
static GPtrArray *all_integrators(TinkerCatalogue *catalogue)
{
    GPtrArray *all = g_ptr_array_new();
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++)
        g_ptr_array_add(all, (gpointer)*each);
    g_ptr_array_extend_and_steal(all, tinker_plugin_methods(catalogue));
    return all;
}

static const TinkerIntegrator *find_integrator(const GPtrArray *all, const char *id)
{
    for (guint i = 0; i < all->len; i++) {
        const TinkerIntegrator *integrator = g_ptr_array_index(all, i);
        if (g_str_equal(integrator->id, id)) return integrator;
    }
    return NULL;
}

static gboolean unknown_method(const GPtrArray *all, const char *id, GError **error)
{
    g_autoptr(GPtrArray) names = g_ptr_array_new();
    for (guint i = 0; i < all->len; i++)
        g_ptr_array_add(names, (gpointer)((const TinkerIntegrator *)g_ptr_array_index(all, i))->id);
    g_ptr_array_add(names, NULL);
    const char *nearest = tinker_nearest_word(id, (const char *const *)names->pdata);
    g_autofree char *list = g_strjoinv(", ", (char **)names->pdata);
    if (nearest != NULL)
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    _("there is no method \"%s\"; did you mean \"%s\"? (there are %s)"), id, nearest, list);
    else
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD, _("there is no method \"%s\" (there are %s)"),
                    id, list);
    return FALSE;
}

static void method_free(gpointer data)
{
    TinkerTradeMethod *method = data;
    g_array_unref(method->rows);
    g_free(method);
}

static void add_method(TinkerTrade *trade, const TinkerIntegrator *integrator)
{
    for (guint i = 0; i < trade->methods->len; i++)
        if (((TinkerTradeMethod *)g_ptr_array_index(trade->methods, i))->integrator == integrator) return;
    TinkerTradeMethod *method = g_new0(TinkerTradeMethod, 1);
    *method = (TinkerTradeMethod){
        .id = integrator->id,
        .integrator = integrator,
        .rows = g_array_new(FALSE, TRUE, sizeof(TinkerTradeRow)),
        .order = NAN,
    };
    g_array_set_clear_func(method->rows, tinker_trade_row_clear);
    g_ptr_array_add(trade->methods, method);
}

static gboolean pick_methods(TinkerTrade *trade, const TinkerTradeOptions *options, const GPtrArray *all,
                             GError **error)
{
    for (guint i = 0; options->methods == NULL && i < all->len; i++)
        add_method(trade, g_ptr_array_index(all, i));
    for (const char *const *id = options->methods; id != NULL && *id != NULL; id++) {
        gboolean impulses = g_str_equal(*id, tinker_integrator_impulse.id);
        const TinkerIntegrator *integrator = impulses ? &tinker_integrator_impulse : find_integrator(all, *id);
        if (integrator == NULL) return unknown_method(all, *id, error);
        add_method(trade, integrator);
    }
    return TRUE;
}

/* Sweeps ----------------------------------------------------------------------------------------------------------- */

/* What one method leaves of its time is shared by those behind it. */
static void sweep_all(TinkerTradeBench *bench, const TinkerTradeStandard *standard, TinkerTrade *trade)
{
    double whole = bench->options->seconds, work = (1 - REFERENCE_WORK) / trade->methods->len;
    for (guint i = 0; i < trade->methods->len && !bench->cancelled; i++) {
        TinkerTradeMethod *method = g_ptr_array_index(trade->methods, i);
        double left = whole - tinker_trade_bench_elapsed(bench);
        double seconds = fmax(left, LEAST_TIME * whole) / (trade->methods->len - i);
        double from = REFERENCE_WORK + i * work;
        tinker_trade_bench_enter(bench, from, from + work, seconds);
        tinker_trade_sweep(bench, standard, method, seconds);
        tinker_trade_observe_order(method, trade->reference.level);
    }
}

TinkerTrade *tinker_trade_new(TinkerScene *scene, const TinkerTradeOptions *options, GError **error)
{
    g_autoptr(TinkerTrade) trade = g_new0(TinkerTrade, 1);
    trade->methods = g_ptr_array_new_with_free_func(method_free);
    g_autoptr(GPtrArray) all = all_integrators(tinker_scene_catalogue(scene));
    if (!pick_methods(trade, options, all, error)) return NULL;

    TinkerTradeBench bench;
    g_auto(TinkerTrajectory) truth = {0};
    TinkerTradeStandard standard = {&trade->reference, &truth, 0};
    gboolean ready = tinker_trade_bench_init(&bench, scene, options, error);
    if (ready) {
        double seconds = REFERENCE_TIME * options->seconds;
        tinker_trade_bench_enter(&bench, 0, REFERENCE_WORK, seconds);
        ready = tinker_trade_find_reference(&bench, all, seconds, &trade->reference, &truth, &standard.samples, error);
    }
    /* it differs from the others by how it takes contact alone */
    if (ready && options->methods == NULL && truth.touches) add_method(trade, &tinker_integrator_impulse);
    if (ready) {
        sweep_all(&bench, &standard, trade);
        tinker_trade_advise(&bench, &standard, trade);
    }
    trade->duration = bench.duration;
    trade->interrupted = bench.cancelled;
    tinker_trade_bench_clear(&bench);
    return ready ? g_steal_pointer(&trade) : NULL;
}

void tinker_trade_free(TinkerTrade *trade)
{
    if (trade == NULL) return;
    g_ptr_array_unref(trade->methods);
    g_free(trade);
}

void tinker_trade_apply(const TinkerTrade *trade, TinkerScene *scene)
{
    TinkerRunSettings *run = &tinker_scene_head(scene)->run;
    const TinkerTradeSetting *setting = &trade->advice.row.setting;
    if (trade->advice.kind == TINKER_TRADE_ADVICE_NONE) return;
    gboolean impulses = g_str_equal(setting->method, tinker_integrator_impulse.id);
    g_free(run->contacts);
    run->contacts = g_strdup(impulses ? "impulse" : "events");
    if (!impulses) { /* which leave the method as it is, for a scene that has contact by events again */
        g_free(run->method);
        run->method = g_strdup(setting->method);
    }
    if (setting->value > 0) *(setting->adaptive ? &run->tolerance : &run->step) = setting->value;
    run->accuracy = 0; /* or the two would not count */
}
