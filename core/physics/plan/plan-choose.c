/* The choice of a method: the one that is named, with warnings where its step does not suit, or that of `auto`. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "numerics/methods/integrators.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan-automatic.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/plan/tolerances.h"
#include "physics/system/method-call.h"

/* A part of a motion is resolved well where h omega is this. */
#define WELL_RESOLVED 0.1
/* The forecast's frequencies are from below: within this share of a limit it is looked at more closely. */
#define NEAR_LIMIT 0.5
/* A step that is chosen for an accuracy is at most this share of the stable one. */
#define WELL_STABLE 0.9

/* Where the parts of a scene are stepped apart a message says which one it means. */
static const char *place_of(const TinkerIsland *island, char **text)
{
    const TinkerModel *model = island->model;
    if (!island->owns_model || model->bodies == 0) return *text = g_strdup("");
    return *text = g_strdup_printf(_(" around %s"), tinker_scene_block_name(model->scene, model->body_blocks[0]));
}

/* What `auto` would take. (transfer full) */
static char *cheap_method(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerForecast *forecast)
{
    TinkerDecision other = {0};
    tinker_plan_decide_automatically(island, options, forecast, &other);
    return g_strdup_printf(_("the method %s"), other.choice.method->id);
}

double tinker_advised_step(const TinkerForecast *forecast, double stable)
{
    double fastest = 0;
    for (int32_t i = 0; i < forecast->count; i++)
        if (forecast->parts[i].share >= TINKER_CARRIES_ENERGY) fastest = fmax(fastest, forecast->parts[i].omega);
    double resolved = fastest > 0 ? WELL_RESOLVED / fastest : INFINITY;
    return tinker_round_down(fmin(0.9 * stable, resolved));
}

static void warn_unstable(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerForecast *forecast,
                          const TinkerIntegrator *method, double stable, GPtrArray *warnings)
{
    g_autofree char *around = NULL, *other = tinker_method_solves_contact(method)
                                                 ? g_strdup(_("contacts as events"))
                                                 : cheap_method(island, options, forecast);
    place_of(island, &around);
    if (stable > 0)
        tinker_warnings_add(warnings, TINKER_WARNING_METHOD,
                            g_strdup_printf(_("%s is stable up to a step of %.3g s here%s, the step is %g s: it will "
                                              "diverge (a step of %g s, or %s)"),
                                            method->id, stable, around, options->step,
                                            tinker_advised_step(forecast, stable), other));
    else
        tinker_warnings_add(warnings, TINKER_WARNING_METHOD,
                            g_strdup_printf(_("%s is stable at no step here%s: it will diverge (it takes %s)"),
                                            method->id, around, other));
}

/* The limit from the forecast: above the true one, as its frequencies are from below. */
static double rough_limit(const TinkerForecast *forecast, const TinkerIntegrator *method)
{
    double limit = INFINITY;
    if (method->imaginary_limit >= 0 && forecast->omega_max > 0) limit = method->imaginary_limit / forecast->omega_max;
    if (method->real_limit >= 0 && forecast->damping_max > 0)
        limit = fmin(limit, method->real_limit / forecast->damping_max);
    return limit;
}

static double stable_step(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerForecast *forecast,
                          const TinkerSpectrum *spectrum, const TinkerIntegrator *method)
{
    double rough = rough_limit(forecast, method);
    g_autoptr(TinkerSpectrum) own = NULL;
    if (spectrum == NULL) {
        gboolean small = island->model->coordinates <= TINKER_DENSE_SPECTRUM;
        gboolean splits = (method->flags & TINKER_INTEGRATOR_SYMPLECTIC) != 0, closer = splits && forecast->turned;
        if (!small) return closer ? NAN : rough;
        if (!closer && options->step < NEAR_LIMIT * rough) return rough;
        spectrum = own = tinker_spectrum_new(island);
    }
    return tinker_spectrum_stable_step(spectrum, method, options->spectral_radius);
}

/* The options with the step and the tolerance at which a run by this method is expected to end with the accuracy asked
 * for. Where the forecast sees nothing that could tell a step, the one of the options is the first to be tried. */
static TinkerRunOptions options_for_accuracy(const TinkerIsland *island, const TinkerRunOptions *options,
                                             const TinkerForecast *forecast, const TinkerSpectrum *spectrum,
                                             const TinkerIntegrator *method)
{
    TinkerCost cost;
    TinkerRunOptions wanted = *options;
    wanted.tolerance = tinker_plan_tolerance(island, forecast, method, options);
    if (!tinker_method_is_fixed(method) || !forecast->known) return wanted;
    tinker_cost_of(island, forecast, method, options, 0, tinker_plan_aim(options), &cost);
    if (!(cost.step < tinker_options_span(options))) return wanted;
    wanted.step = cost.step;
    gboolean explicit = (method->flags & TINKER_INTEGRATOR_EXPLICIT) != 0;
    double stable = explicit ? stable_step(island, &wanted, forecast, spectrum, method) : INFINITY;
    if (stable > 0) wanted.step = fmin(cost.step, WELL_STABLE * stable);
    wanted.step = tinker_round_down(wanted.step);
    return wanted;
}

static void warn_under_resolved(const TinkerIsland *island, const TinkerRunOptions *options,
                                const TinkerForecast *forecast, const TinkerIntegrator *method, GPtrArray *warnings)
{
    double fastest = 0, share = 0;
    for (int32_t i = 0; i < forecast->count; i++) {
        const TinkerForecastPart *part = &forecast->parts[i];
        if (part->share < TINKER_CARRIES_ENERGY || part->omega * options->step <= TINKER_LEAST_RESOLVED) continue;
        fastest = fmax(fastest, part->omega);
        share += part->share;
    }
    if (fastest == 0) return;
    g_autofree char *around = NULL;
    place_of(island, &around);
    tinker_warnings_add(warnings, TINKER_WARNING_METHOD,
                        g_strdup_printf(_("motion at up to %.3g rad/s%s, which holds %.3g %% of the energy, gets %.2g "
                                          "steps a period: %s is stable there and wrong (a step of %g s resolves it)"),
                                        fastest, around, fmin(100 * share, 100), 2 * G_PI / (fastest * options->step),
                                        method->id, tinker_round_down(WELL_RESOLVED / fastest)));
}

static void decide_named(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerForecast *forecast,
                         const TinkerSpectrum *spectrum, const TinkerIntegrator *method, TinkerDecision *decision,
                         GPtrArray *warnings)
{
    gboolean fixed = tinker_method_is_fixed(method);
    decision->choice = (TinkerChoice){
        .method = method, .step = fixed ? options->step : 0, .tolerance = fixed ? 0 : options->tolerance};
    decision->choice.holds_energy =
        options->accuracy > 0 && tinker_plan_holds_energy(island, options, forecast, method);
    if (decision->reason != NULL) {
        g_string_append(decision->reason,
                        tinker_method_solves_contact(method)
                            ? _("contacts are asked for as impulses: one velocity solve a step, order 1")
                            : _("asked for"));
        tinker_plan_explain_holding(decision);
        tinker_cost_of(island, forecast, method, options, decision->choice.step, options->tolerance, &decision->cost);
    }
    if (!fixed || !forecast->known || warnings == NULL) return;
    gboolean explicit = (method->flags & TINKER_INTEGRATOR_EXPLICIT) != 0;
    double stable = explicit ? stable_step(island, options, forecast, spectrum, method) : INFINITY;
    if (options->step > stable)
        warn_unstable(island, options, forecast, method, stable, warnings);
    else if (isnan(stable))
        tinker_warnings_add(warnings, TINKER_WARNING_METHOD,
                            g_strdup_printf(_("how large a step %s bears is not known where forces act across the "
                                              "velocity: compare with a smaller one, or with another method"),
                                            method->id));
    else
        warn_under_resolved(island, options, forecast, method, warnings);
}

static gboolean refuse_not_linear(const TinkerIsland *island, const TinkerIntegrator *method, GError **error)
{
    TinkerModel *model = island->model;
    const char *where =
        model->bodies > 0 ? tinker_scene_block_name(model->scene, model->body_blocks[0]) : _("its supports");
    double growth = tinker_model_sideways_growth(model);
    g_autofree char *why =
        g_strdup_printf(_("whose straight motion is unstable and grows sideways at %.3g 1/s"), growth);
    gboolean rubs = model->contacts != NULL && model->contacts->pin_count > 0;
    gboolean touches = model->contacts != NULL && tinker_contacts_touch(model->contacts);
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
        _("the method %s does not suit the part of the scene around %s, %s (the method auto takes one that suits)"),
        method->id, where,
        rubs         ? _("in which pins have friction")
        : touches    ? _("which rests on a solid support from the start")
        : growth > 0 ? why
                     : _("which is not linear"));
    return FALSE;
}

gboolean tinker_decide(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerSpectrum *spectrum,
                       TinkerDecision *decision, GPtrArray *warnings, GError **error)
{
    const TinkerContacts *contacts = island->model->contacts;
    gboolean impulses = options->impulses && tinker_contacts_can_meet(contacts);
    gboolean automatic = !impulses && g_str_equal(options->method, "auto");
    const TinkerIntegrator *method = &tinker_integrator_impulse;
    if (options->impulses && !tinker_plan_check_impulses(island, error)) return FALSE;
    if (!impulses) method = tinker_run_method(island->model->scene, options->method, error);
    if (impulses && warnings != NULL) tinker_impulse_tell_overlaps(contacts, warnings);
    if (method == NULL || !tinker_run_options_check(options, method, tinker_options_duration(options), error))
        return FALSE;
    if (!automatic && (method->flags & TINKER_INTEGRATOR_LINEAR) && island->linear == NULL)
        return refuse_not_linear(island, method, error);
    gboolean fixed = tinker_method_is_fixed(method);
    TinkerForecast forecast = {0};
    if (automatic || fixed || decision->reason != NULL || options->accuracy > 0) tinker_forecast(island, &forecast);
    decision->speed_of_change = forecast.speed_of_change;
    if (automatic) {
        tinker_plan_decide_automatically(island, options, &forecast, decision);
    } else {
        TinkerRunOptions wanted = *options;
        if (options->accuracy > 0) wanted = options_for_accuracy(island, options, &forecast, spectrum, method);
        decide_named(island, &wanted, &forecast, spectrum, method, decision, warnings);
    }
    if (decision->choice.method->flags & TINKER_INTEGRATOR_LINEAR)
        decision->choice.interval = tinker_cost_interval(island, options);
    return TRUE;
}

gboolean tinker_plan_choose(const TinkerIsland *island, const TinkerRunOptions *options, TinkerChoice *choice,
                            GPtrArray *warnings, GError **error)
{
    TinkerDecision decision = {0};
    if (!tinker_decide(island, options, NULL, &decision, warnings, error)) return FALSE;
    *choice = decision.choice;
    return TRUE;
}
