/* The choice of a method: the one that is named, with warnings where its step does not suit; or the cheapest by counts
 * that meets the tolerance. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "numerics/methods/integrators.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/plan/tolerances.h"
#include "physics/system/hold-energy.h"
#include "physics/system/method-call.h"

/* A part of a motion is resolved well where h omega is this. */
#define WELL_RESOLVED 0.1
/* The forecast's frequencies are from below: within this share of a limit it is looked at more closely. */
#define NEAR_LIMIT 0.5
/* A run of so many radians of what moves, and the energy's drift is what it misses by. */
#define LONG_RUN 1000.0
/* Where the energy is held the plan's error is too small by so much, measured on pendulums of wide swing. */
#define HELD_ENERGY_HASTE 10.0
/* Stiff: stability asks for this many times the steps that accuracy does. */
#define STIFF 3.0
/* Damping this many times faster than all else, and explicit steps this many times as dear: for another kind of method.
 */
#define HELD_FAST 1000.0
/* A step that is chosen for an accuracy is at most this share of the stable one. */
#define WELL_STABLE 0.9
/* An exact solution is taken at up to this many times the cost of an approximation that meets the tolerance. */
#define EXACT_IS_WORTH 3.0
/* A choice counts so many samples, whatever is recorded: the same motion has the same steps. */
#define USUAL_SAMPLES 100

/* Where the parts of a scene are stepped apart a message says which one it means. */
static const char *place_of(const TinkerIsland *island, char **text)
{
    const TinkerModel *model = island->model;
    if (!island->owns_model || model->bodies == 0) return *text = g_strdup("");
    return *text = g_strdup_printf(_(" around %s"), tinker_scene_block_name(model->scene, model->body_blocks[0]));
}

/* Accuracy --------------------------------------------------------------------------------------------------------- */

/* The error that the plan aims at where an accuracy is asked for: the estimate of a run claims twice what it sees, and
 * what is expected beforehand is rough. */
static double aim_of(const TinkerRunOptions *options)
{
    return options->accuracy / 5;
}

/* Whether the energy is to be held after every step of this method: nothing changes it, and the run is so long that its
 * drift would count. Straight and linear motion has exact solutions. */
static gboolean is_worth_holding(const TinkerIsland *island, const TinkerRunOptions *options,
                                 const TinkerForecast *forecast, const TinkerIntegrator *method)
{
    double radians = fmax(forecast->speed_of_change, forecast->turning) * tinker_options_span(options);
    gboolean suits = method == tinker_integrator_builtin("dop853") || method == tinker_integrator_builtin("dopri5");
    return suits && radians > LONG_RUN && island->linear == NULL && tinker_model_keeps_energy(island->model);
}

/* The tolerance that a method is to be taken at: the one asked for, or that at which the run is expected to end with
 * the accuracy asked for. That of a method of fixed step is what its run may miss. */
static double wanted_tolerance(const TinkerIsland *island, const TinkerForecast *forecast,
                               const TinkerIntegrator *method, const TinkerRunOptions *options)
{
    if (!(options->accuracy > 0)) return options->tolerance;
    double aim = aim_of(options);
    TinkerCost cost;
    if (!tinker_method_is_adaptive(method) || !tinker_cost_of(island, forecast, method, options, 0, aim, &cost))
        return aim;
    if (is_worth_holding(island, options, forecast, method)) cost.error *= HELD_ENERGY_HASTE;
    return fmax(TINKER_TIGHTEST_TOLERANCE, tinker_round_down(aim * fmin(1, aim / cost.error)));
}

/* Automatic -------------------------------------------------------------------------------------------------------- */

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
    double tolerance = wanted_tolerance(island, forecast, method, options);
    return tinker_method_is_adaptive(method) ? tinker_free_tolerance(island, forecast, method, tolerance) : tolerance;
}

static void explain_holding(const TinkerDecision *decision)
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
        const double tolerance = wanted_tolerance(island, forecast, method, options);
        TinkerCost cost;
        if ((method->flags & implicit) != implicit || method->real_limit >= 0) continue;
        if (!tinker_cost_of(island, forecast, method, options, 0, tolerance, &cost)) continue;
        if (!(HELD_FAST * cost.operations < explicit) || !(cost.operations < decision->cost.operations)) continue;
        decision->cost = cost;
        decision->choice = (TinkerChoice){.method = method, .tolerance = tolerance};
    }
}

static void decide_automatically(const TinkerIsland *island, const TinkerRunOptions *options,
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
    choice->holds_energy = is_worth_holding(island, options, forecast, choice->method);
    explain_automatic(decision, options, forecast, stiff);
    explain_holding(decision);
}

/* Named ------------------------------------------------------------------------------------------------------------ */

/* What `auto` would take. (transfer full) */
static char *cheap_method(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerForecast *forecast)
{
    TinkerDecision other = {0};
    decide_automatically(island, options, forecast, &other);
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
        g_ptr_array_add(warnings,
                        g_strdup_printf(_("%s is stable up to a step of %.3g s here%s, the step is %g s: it will "
                                          "diverge (a step of %g s, or %s)"),
                                        method->id, stable, around, options->step,
                                        tinker_advised_step(forecast, stable), other));
    else
        g_ptr_array_add(warnings, g_strdup_printf(_("%s is stable at no step here%s: it will diverge (it takes %s)"),
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
    wanted.tolerance = wanted_tolerance(island, forecast, method, options);
    if (!tinker_method_is_fixed(method) || !forecast->known) return wanted;
    tinker_cost_of(island, forecast, method, options, 0, aim_of(options), &cost);
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
    g_ptr_array_add(warnings,
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
    decision->choice.holds_energy = options->accuracy > 0 && is_worth_holding(island, options, forecast, method);
    if (decision->reason != NULL) {
        g_string_append(decision->reason,
                        tinker_method_solves_contact(method)
                            ? _("contacts are asked for as impulses: one velocity solve a step, order 1")
                            : _("asked for"));
        explain_holding(decision);
        tinker_cost_of(island, forecast, method, options, decision->choice.step, options->tolerance, &decision->cost);
    }
    if (!fixed || !forecast->known || warnings == NULL) return;
    gboolean explicit = (method->flags & TINKER_INTEGRATOR_EXPLICIT) != 0;
    double stable = explicit ? stable_step(island, options, forecast, spectrum, method) : INFINITY;
    if (options->step > stable)
        warn_unstable(island, options, forecast, method, stable, warnings);
    else if (isnan(stable))
        g_ptr_array_add(warnings,
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

static gboolean refuse_ropes(const TinkerIsland *island, GError **error)
{
    const TinkerConstraints *all = &island->model->constraints;
    int32_t row = 0;
    while (!all->unilateral[row])
        row++;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                _("%s holds in one direction only, which contacts as impulses do not know (treat contacts as events: "
                  "leave \"contacts\" out of the scene's run)"),
                tinker_scene_block_name(island->model->scene, all->blocks[row]));
    return FALSE;
}

/* FALSE where a top turns that bodies could meet. */
static gboolean check_tops_stay(const TinkerContacts *contacts, GError **error)
{
    for (int32_t i = 0; i < contacts->plate_count; i++) {
        if (contacts->plates[i].turned == NULL) continue;
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
            _("%s turns with what lies on it, which contacts as impulses do not know (treat contacts as events: "
              "leave \"contacts\" out of the scene's run; or set \"solid\" of the support to false)"),
            tinker_scene_block_name(contacts->model->scene, contacts->plates[i].block));
        return FALSE;
    }
    return TRUE;
}

static gboolean refuse_law(const TinkerIsland *island, GError **error)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                _("contacts as impulses know Newton's law of impact alone, and impact_law of the run is \"%s\" (treat "
                  "contacts as events: leave \"contacts\" out of the scene's run; or leave \"impact_law\" out)"),
                tinker_scene_head(island->model->scene)->run.impact_law);
    return FALSE;
}

/* The first body with a shape among those that constraints tie to a body; -1: none is. */
static int32_t tied_shape(const TinkerContacts *contacts, int32_t body)
{
    for (int32_t i = 0; contacts->held[body] && i < contacts->model->bodies; i++)
        if (contacts->group[i] == contacts->group[body] && contacts->held[i] &&
            tinker_contacts_has_outline(contacts, i))
            return i;
    return -1;
}

/* FALSE where constraints tie a mass that lands on tops, without meeting anything else, to a body with a shape. */
static gboolean check_masses_meet(const TinkerContacts *contacts, GError **error)
{
    const TinkerModel *model = contacts->model;
    for (int32_t i = 0; contacts->plate_count > 0 && i < model->bodies; i++) {
        if (isnan(contacts->half_height[i]) || tinker_contacts_has_outline(contacts, i)) continue;
        const int32_t other = tied_shape(contacts, i);
        if (other < 0) continue;
        const char *name = tinker_scene_block_name(model->scene, model->body_blocks[i]);
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    _("%s lands on supports alone, and constraints tie it to %s, which meets others with its shape: "
                      "contacts as impulses do not know both together (set \"collides\" of %s to true; or treat "
                      "contacts as events: leave \"contacts\" out of the scene's run)"),
                    name, tinker_scene_block_name(model->scene, model->body_blocks[other]), name);
        return FALSE;
    }
    return TRUE;
}

/* FALSE where something resists turning. */
static gboolean check_turns_freely(const TinkerContacts *contacts, GError **error)
{
    if (contacts->pin_count > 0) {
        const int32_t first = tinker_contacts_first_pin(contacts);
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    _("%s has friction, which contacts as impulses do not know (treat contacts as events: leave "
                      "\"contacts\" out of the scene's run; or leave its \"friction\" out)"),
                    tinker_scene_block_name(contacts->model->scene, contacts->plates[first].block));
        return FALSE;
    }
    if (contacts->resistance_count == 0) return TRUE;
    const TinkerPlate *plate = &contacts->plates[contacts->plate_count + contacts->gap_count];
    const int32_t *point = plate->pair->point;
    const gboolean second = !(contacts->surfaces[point[0]].rolling > 0);
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
        _("%s has a rolling resistance, which contacts as impulses do not know (treat contacts as events: leave "
          "\"contacts\" out of the scene's run; or leave its \"rolling_resistance\" out)"),
        tinker_scene_block_name(contacts->model->scene, tinker_model_block_of(contacts->model, point[second ? 1 : 0])));
    return FALSE;
}

/* FALSE where a body has a notch: one normal of a pair says nothing of it. */
static gboolean check_shapes_convex(const TinkerContacts *contacts, GError **error)
{
    const TinkerModel *model = contacts->model;
    for (int32_t i = 0; i < model->bodies; i++) {
        if (contacts->outlines[i].triangles == NULL) continue;
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    _("%s has corners that turn inwards, which contacts as impulses do not know (treat contacts as "
                      "events: leave \"contacts\" out of the scene's run; or set \"solid\" of it to false)"),
                    tinker_scene_block_name(model->scene, model->body_blocks[i]));
        return FALSE;
    }
    return TRUE;
}

gboolean tinker_decide(const TinkerIsland *island, const TinkerRunOptions *options, const TinkerSpectrum *spectrum,
                       TinkerDecision *decision, GPtrArray *warnings, GError **error)
{
    const TinkerContacts *contacts = island->model->contacts;
    gboolean impulses = options->impulses && tinker_contacts_can_meet(contacts);
    gboolean automatic = !impulses && g_str_equal(options->method, "auto");
    const TinkerIntegrator *method = &tinker_integrator_impulse;
    if (!impulses) method = tinker_run_method(island->model->scene, options->method, error);
    if (options->impulses && g_strcmp0(tinker_scene_head(island->model->scene)->run.impact_law, "newton") != 0)
        return refuse_law(island, error);
    if (options->impulses && island->model->constraints.unilateral != NULL) return refuse_ropes(island, error);
    if (impulses && !(check_tops_stay(contacts, error) && check_masses_meet(contacts, error) &&
                      check_shapes_convex(contacts, error) && check_turns_freely(contacts, error)))
        return FALSE;
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
        decide_automatically(island, options, &forecast, decision);
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
