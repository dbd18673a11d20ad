/* The choice of `auto`: the method that meets the tolerance, or the accuracy asked for, at the least cost by counts. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "numerics/methods/integrators.h"
#include "physics/model/model-data.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan-automatic.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/plan/tolerances.h"
#include "physics/system/hold-energy.h"
#include "physics/system/method-call.h"

/* A run of so many radians of what moves, and the energy's drift is what it misses by. */
#define LONG_RUN 1000.0
/* Where the energy is held the plan's error is too small by so much, measured on pendulums of wide swing. */
#define HELD_ENERGY_HASTE 10.0
/* Stiff: stability asks for this many times the steps that accuracy does. */
#define STIFF 3.0
/* Damping this many times faster than all else, and explicit steps this many times as dear: for another kind of method.
 */
#define HELD_FAST 1000.0
/* An exact solution is taken at up to this many times the cost of an approximation that meets the tolerance. */
#define EXACT_IS_WORTH 3.0
/* A choice counts so many samples, whatever is recorded: the same motion has the same steps. */
#define USUAL_SAMPLES 100

double tinker_plan_aim(const TinkerRunOptions *options)
{
    return options->accuracy / 5;
}

gboolean tinker_plan_holds_energy(const TinkerIsland *island, const TinkerRunOptions *options,
                                  const TinkerForecast *forecast, const TinkerIntegrator *method)
{
    double radians = fmax(forecast->speed_of_change, forecast->turning) * tinker_options_span(options);
    gboolean suits = method == tinker_integrator_builtin("dop853") || method == tinker_integrator_builtin("dopri5");
    return suits && radians > LONG_RUN && island->linear == NULL && tinker_model_keeps_energy(island->model);
}

double tinker_plan_tolerance(const TinkerIsland *island, const TinkerForecast *forecast, const TinkerIntegrator *method,
                             const TinkerRunOptions *options)
{
    if (!(options->accuracy > 0)) return options->tolerance;
    double aim = tinker_plan_aim(options);
    TinkerCost cost;
    if (!tinker_method_is_adaptive(method) || !tinker_cost_of(island, forecast, method, options, 0, aim, &cost))
        return aim;
    if (tinker_plan_holds_energy(island, options, forecast, method)) cost.error *= HELD_ENERGY_HASTE;
    return fmax(TINKER_TIGHTEST_TOLERANCE, tinker_round_down(aim * fmin(1, aim / cost.error)));
}

/* Methods that `auto` takes: exact ones, adaptive explicit ones, and implicit ones where the island is stiff and
 * linear, so that the error of a long step can be told beforehand; but not for an accuracy, which holds for the
 * velocities of fast parts, too. Explicit ones of a fixed step are for those who ask for them: none is cheaper at an
 * error that somebody wants. */
static gboolean is_candidate(const TinkerIsland *island, const TinkerRunOptions *options,
                             const TinkerIntegrator *method, gboolean stiff)
{
    if (method->flags & TINKER_INTEGRATOR_LINEAR) return TRUE;
    if (method->flags & TINKER_INTEGRATOR_IMPLICIT)
        return stiff && tinker_method_is_fixed(method) && island->linear != NULL && options->accuracy == 0;
    return tinker_method_is_adaptive(method);
}

/* Whether the fastest frequencies hold so little of the motion that explicit steps would be spent on them alone. That
 * can be told only of what moves of its own accord and without constraints, whose tensions change with the motion. */
static gboolean is_stiff(const TinkerIsland *island, const TinkerForecast *forecast)
{
    const TinkerModel *model = island->model;
    gboolean driven = model->moving_supports > 0 || model->waveform_batches->len > 0;
    if (driven || model->constraints.rows > 0 || forecast->count == 0) return FALSE;
    double carried = fmax(fmax(forecast->speed_of_change, forecast->drive), forecast->fading);
    for (int32_t i = 0; i < forecast->count; i++)
        if (forecast->parts[i].share > TINKER_CARRIES_ENERGY) carried = fmax(carried, forecast->parts[i].omega);
    return fmax(forecast->omega_max, forecast->damping_max) > STIFF * carried;
}

static void explain_automatic(TinkerDecision *decision, const TinkerRunOptions *options, const TinkerForecast *forecast,
                              gboolean stiff)
{
    const TinkerIntegrator *method = decision->choice.method;
    GString *text = decision->reason;
    if (text == NULL) return;
    if (method->flags & TINKER_INTEGRATOR_LINEAR)
        g_string_append(text, _("the motion is linear: its exact solution is right to rounding, at any step"));
    else if ((method->flags & TINKER_INTEGRATOR_IMPLICIT) && tinker_method_is_adaptive(method))
        g_string_append_printf(text,
                               _("stiff: damping at %.3g 1/s would force an explicit method to far smaller steps than "
                                 "what moves needs; %s, which a plugin brings, is stable at any step"),
                               forecast->damping_max, method->id);
    else if (method->flags & TINKER_INTEGRATOR_IMPLICIT)
        g_string_append_printf(text,
                               _("stiff: %.3g %s would force an explicit method to far smaller steps than what moves "
                                 "needs; %s is stable at any step, and %.3g s meets the tolerance in place"),
                               fmax(forecast->omega_max, forecast->damping_max),
                               forecast->damping_max > forecast->omega_max ? "1/s" : "rad/s", method->id,
                               decision->choice.step);
    else if (options->accuracy > 0)
        g_string_append_printf(
            text,
            _("smooth and not stiff: order %d needs the fewest evaluations for an error of %g at the "
              "end of the run"),
            method->order, options->accuracy);
    else if (decision->choice.tolerance < options->tolerance)
        g_string_append_printf(text,
                               _("order %d needs the fewest evaluations; its steps are those that stability allows, at "
                                 "which a tolerance of %.2g costs no more than %g"),
                               method->order, decision->choice.tolerance, options->tolerance);
    else
        g_string_append_printf(text,
                               stiff
                                   ? _("stiff, but the tolerance asks for small steps anyway: order %d needs the "
                                       "fewest evaluations at this tolerance")
                                   : _("smooth and not stiff: order %d needs the fewest evaluations at this tolerance"),
                               method->order);
}

static double usual_operations(const TinkerCost *cost)
{
    return cost->operations + USUAL_SAMPLES * cost->sample;
}

/* The tolerance that is wanted, or a tighter one that costs nothing. */
static double cheap_tolerance(const TinkerIsland *island, const TinkerForecast *forecast,
                              const TinkerIntegrator *method, const TinkerRunOptions *options)
{
    double tolerance = tinker_plan_tolerance(island, forecast, method, options);
    return tinker_method_is_adaptive(method) ? tinker_free_tolerance(island, forecast, method, tolerance) : tolerance;
}

void tinker_plan_explain_holding(const TinkerDecision *decision)
{
    if (decision->reason == NULL || !decision->choice.holds_energy) return;
    g_string_append(decision->reason,
                    _("; nothing changes the energy in this long run: it is held after every step, or "
                      "the phase would drift with the square of time"));
}

/* Where dampers hold something so fast that explicit steps would be spent on it alone, a plugin's implicit method takes
 * the run over, if there is one: it is stable however strong the damping. What swings as fast is another matter: such
 * a method follows it no faster than an explicit one. */
static void take_damped_method(const TinkerIsland *island, const TinkerRunOptions *options,
                               const TinkerForecast *forecast, TinkerDecision *decision)
{
    const guint32 implicit = TINKER_INTEGRATOR_ADAPTIVE | TINKER_INTEGRATOR_IMPLICIT;
    const double others = fmax(fmax(forecast->omega_max, forecast->drive), forecast->speed_of_change);
    if (!forecast->known || island->linear != NULL || island->model->constraints.rows > 0) return;
    if (!(forecast->damping_max > HELD_FAST * others)) return;
    if (!(decision->choice.method->flags & TINKER_INTEGRATOR_EXPLICIT)) return;
    g_autoptr(GPtrArray) methods = tinker_plugin_methods(tinker_scene_catalogue(island->model->scene));
    const double explicit = decision->cost.operations;
    for (guint i = 0; i < methods->len; i++) {
        const TinkerIntegrator *method = g_ptr_array_index(methods, i);
        const double tolerance = tinker_plan_tolerance(island, forecast, method, options);
        TinkerCost cost;
        if ((method->flags & implicit) != implicit || method->real_limit >= 0) continue;
        if (!tinker_cost_of(island, forecast, method, options, 0, tolerance, &cost)) continue;
        if (!(HELD_FAST * cost.operations < explicit) || !(cost.operations < decision->cost.operations)) continue;
        decision->cost = cost;
        decision->choice = (TinkerChoice){.method = method, .tolerance = tolerance};
    }
}

void tinker_plan_decide_automatically(const TinkerIsland *island, const TinkerRunOptions *options,
                                      const TinkerForecast *forecast, TinkerDecision *decision)
{
    gboolean stiff = is_stiff(island, forecast);
    TinkerChoice *choice = &decision->choice;
    choice->method = tinker_integrator_builtin("dop853");
    choice->tolerance = cheap_tolerance(island, forecast, choice->method, options);
    tinker_cost_of(island, forecast, choice->method, options, 0, choice->tolerance, &decision->cost);
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); forecast->known && *each != NULL; each++) {
        TinkerCost cost;
        if (!is_candidate(island, options, *each, stiff)) continue;
        double tolerance = cheap_tolerance(island, forecast, *each, options);
        if (!tinker_cost_of(island, forecast, *each, options, 0, tolerance, &cost)) continue;
        if (tinker_method_is_fixed(*each) && cost.error > TINKER_MEETS * tolerance) continue;
        /* what is right to rounding may cost a little more */
        double worth = (*each)->flags & TINKER_INTEGRATOR_LINEAR ? EXACT_IS_WORTH : 1;
        if (!(usual_operations(&cost) < worth * usual_operations(&decision->cost))) continue;
        decision->cost = cost;
        *choice = (TinkerChoice){
            .method = *each,
            .step = tinker_method_is_fixed(*each) ? tinker_round_down(cost.step) : 0,
            .tolerance = tinker_method_is_fixed(*each) ? 0 : tolerance,
        };
    }
    take_damped_method(island, options, forecast, decision);
    choice->holds_energy = tinker_plan_holds_energy(island, options, forecast, choice->method);
    explain_automatic(decision, options, forecast, stiff);
    tinker_plan_explain_holding(decision);
}
