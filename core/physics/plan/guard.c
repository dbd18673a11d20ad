/* The block to blame is the one that holds most of the energy in the shape of the fastest mode; for a damper, that
 * takes most of the power in the shape with the largest damping over mass. */
#include "physics/plan/guard.h"
#include "physics/system/method-call.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/force/derivatives.h"
#include "physics/impulse/impulse.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"

/* Who is to blame for a shape so far. */
typedef struct {
    double most;         /* J or W, at the shape's own size */
    TinkerBlockId block; /* TINKER_NO_BLOCK: nobody */
} Blame;

/* d . n of the displacements of a line's ends. */
static double stretch(const TinkerModel *model, const double *shape, int32_t a, int32_t b, double x, double y)
{
    double at_a[2], at_b[2];
    tinker_model_at_point(model, a, shape, at_a);
    tinker_model_at_point(model, b, shape, at_b);
    const double ax = at_a[0], ay = at_a[1], bx = at_b[0], by = at_b[1];
    return x * (bx - ax) + y * (by - ay);
}

static void consider(Blame *blame, TinkerBlockId block, double share)
{
    if (!(share > blame->most)) return;
    blame->most = share;
    blame->block = block;
}

static void consider_line(const TinkerModel *model, const double *shape, Blame *blame, TinkerBlockId block, int32_t a,
                          int32_t b, double coefficient)
{
    TinkerLineDerivatives line;
    tinker_line_geometry(model, a, b, &line);
    double along = stretch(model, shape, a, b, line.x, line.y);
    if (line.length == 0) /* pulls in every direction */
        along = hypot(stretch(model, shape, a, b, 1, 0), stretch(model, shape, a, b, 0, 1));
    consider(blame, block, coefficient * along * along);
}

static void consider_linear(TinkerModel *model, TinkerBlockBatch *batch, gboolean damping, const double *shape,
                            Blame *blame)
{
    gsize n = (gsize)batch->count;
    g_autofree double *values = g_new0(double, 4 * n);
    const int32_t *points = tinker_model_end_points(model, batch);
    TinkerBatch view = tinker_block_batch_view(batch, 0.0);
    const TinkerLineLaw *law = batch->block_class->physics->line_law;
    if (law->linear == NULL ||
        TINKER_CALL_BATCH(batch, "linear", &view,
                          law->linear(&view, values, values + n, values + 2 * n, values + 3 * n)) != TINKER_OK)
        return;
    for (gsize row = 0; row < n; row++)
        consider_line(model, shape, blame, batch->ids[row], points[2 * row], points[2 * row + 1],
                      values[damping ? n + row : row]);
}

static void consider_asked(TinkerModel *model, const TinkerAskedBatch *asked, gboolean damping, const double *shape,
                           Blame *blame)
{
    for (int32_t row = 0; row < asked->batch->count; row++) {
        TinkerLineDerivatives line;
        if (tinker_asked_line_derivatives(model, asked, row, &line) != TINKER_OK) continue;
        consider_line(model, shape, blame, asked->batch->ids[row], asked->end_points[2 * row],
                      asked->end_points[2 * row + 1], damping ? line.damping : line.along);
    }
}

static TinkerBlockId blame_for(TinkerModel *model, gboolean damping, const double *shape)
{
    Blame blame = {0, TINKER_NO_BLOCK};
    if (shape == NULL || tinker_model_set_time(model, 0.0) != TINKER_OK) return TINKER_NO_BLOCK;
    tinker_model_set_state(model, model->q_start, model->v_start);
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics != NULL && physics->line_law != NULL) consider_linear(model, batch, damping, shape, &blame);
    }
    for (guint i = 0; i < model->asked_lines->len; i++)
        consider_asked(model, &g_array_index(model->asked_lines, TinkerAskedBatch, i), damping, shape, &blame);
    return blame.block;
}

/* Whether it is damping rather than stiffness that limits the method. */
static gboolean is_damping_to_blame(const TinkerSpectrum *spectrum, const TinkerIntegrator *method)
{
    if (!(spectrum->damping_max > 0)) return FALSE;
    if (method->real_limit < 0) return FALSE;
    double by_damping = method->real_limit / spectrum->damping_max;
    double by_stiffness = spectrum->omega_max > 0 ? fabs(method->imaginary_limit) / spectrum->omega_max : INFINITY;
    return by_damping < by_stiffness;
}

static gboolean stores_energy(const TinkerPhysics *physics)
{
    return (physics->line_law != NULL && physics->line_law->energy != NULL) ||
           (physics->force_element != NULL && physics->force_element->energy != NULL) ||
           (physics->field != NULL && physics->field->energy != NULL);
}

/* The one block whose plugin is asked for forces and for energy, where nothing else acts; or TINKER_NO_BLOCK. A law
 * that it `states` is what its plugin is held to. */
static TinkerBlockId lone_block(const TinkerModel *model, gboolean *states)
{
    const GArray *asked[] = {model->asked_lines, model->asked_forces, model->asked_fields};
    TinkerBlockId block = TINKER_NO_BLOCK;
    int32_t count = model->lines.count;
    for (gsize i = 0; i < G_N_ELEMENTS(asked); i++)
        for (guint k = 0; k < asked[i]->len; k++) {
            const TinkerBlockBatch *batch = g_array_index(asked[i], TinkerAskedBatch, k).batch;
            count += batch->count;
            if (batch->count == 0) continue;
            block = stores_energy(batch->block_class->physics) ? batch->ids[0] : TINKER_NO_BLOCK;
            *states = batch->block_class->law_count > 0;
        }
    const gboolean alone =
        count == 1 && model->constraints.rows == 0 && model->contacts == NULL && model->field_drag == 0;
    return alone ? block : TINKER_NO_BLOCK;
}

static void append_check(GString *text, const char *name)
{
    g_string_append_printf(
        text, _("%s alone acts here: tinker plugins check tells whether its forces agree with its energy"), name);
}

/* `fits`: the step is no reason to diverge. A fixed one may all the same be longer than what a law does. */
static void append_nobody(GString *text, const TinkerModel *model, const TinkerIntegrator *method, gboolean fits)
{
    gboolean states = FALSE;
    TinkerBlockId lone = fits ? lone_block(model, &states) : TINKER_NO_BLOCK;
    if (lone != TINKER_NO_BLOCK && states && tinker_method_is_fixed(method))
        g_string_append_printf(text, _("the force of %s, which alone acts here, may change within a step"),
                               tinker_scene_block_name(model->scene, lone));
    else if (lone != TINKER_NO_BLOCK)
        append_check(text, tinker_scene_block_name(model->scene, lone));
    else if (model->part && model->bodies > 0)
        g_string_append_printf(text, _("no single connector around %s is to blame"),
                               tinker_scene_block_name(model->scene, model->body_blocks[0]));
    else
        g_string_append(text, _("no single connector is to blame"));
}

/* The steps are too accurate for the energy to be off by them: what remains is an energy that is not that of its
 * forces, where a plugin gives both and states no law. FALSE: there is no such block. */
static gboolean append_doubt(GString *text, const TinkerModel *model)
{
    const GArray *asked[] = {model->asked_lines, model->asked_forces, model->asked_fields};
    const char *first = NULL;
    int32_t count = 0;
    gboolean states = FALSE;
    for (gsize i = 0; i < G_N_ELEMENTS(asked); i++)
        for (guint k = 0; k < asked[i]->len; k++) {
            const TinkerBlockBatch *batch = g_array_index(asked[i], TinkerAskedBatch, k).batch;
            const TinkerBlockClass *class = batch->block_class;
            if (batch->count == 0 || class->law_count > 0 || !stores_energy(class->physics)) continue;
            if (first == NULL) first = tinker_scene_block_name(model->scene, batch->ids[0]);
            count += batch->count;
        }
    if (count == 0) return FALSE;
    if (lone_block(model, &states) != TINKER_NO_BLOCK)
        append_check(text, first);
    else if (count == 1)
        g_string_append_printf(
            text,
            _("the steps are accurate: tinker plugins check tells whether the forces of %s agree with its energy"),
            first);
    else
        g_string_append_printf(
            text,
            _("the steps are accurate: tinker plugins check tells whether forces agree with energies, "
              "for %s, the first of %d blocks that may be the cause"),
            first, count);
    return TRUE;
}

static void append_blame(GString *text, TinkerModel *model, const TinkerSpectrum *spectrum,
                         const TinkerIntegrator *method, gboolean fits)
{
    gboolean damping = is_damping_to_blame(spectrum, method);
    TinkerBlockId block = blame_for(model, damping, damping ? spectrum->most_damped : spectrum->fastest);
    if (!damping && spectrum->turned && spectrum->fastest == NULL)
        g_string_append_printf(text, _("forces across the velocity make the fastest motion, %.3g rad/s"),
                               spectrum->omega_max);
    else if (block == TINKER_NO_BLOCK)
        append_nobody(text, model, method, fits);
    else
        g_string_append_printf(text,
                               damping ? _("the damping of %s makes the fastest motion, %.3g 1/s")
                                       : _("the stiffness of %s makes the fastest motion, %.3g rad/s"),
                               tinker_scene_block_name(model->scene, block),
                               damping ? spectrum->damping_max : spectrum->omega_max);
}

/* A step that is stable, or that is finer than a stable one which was not good enough; and what `auto` takes here at
 * the scene's own tolerance. */
static void append_advice(GString *text, const TinkerIsland *island, const TinkerIntegrator *method, double step,
                          double stable)
{
    TinkerRunOptions options = tinker_run_options_of(island->model->scene);
    TinkerChoice choice = {0};
    TinkerForecast forecast;
    tinker_forecast(island, &forecast);
    options.method = "auto";
    options.impulses = FALSE;
    gboolean impulses = tinker_method_solves_contact(method);
    gboolean chosen = !impulses && tinker_plan_choose(island, &options, &choice, NULL, NULL) && choice.method != method;
    if (method->flags & TINKER_INTEGRATOR_ADAPTIVE)
        g_string_append(text, _("; use a smaller tolerance"));
    else if (isfinite(stable) && stable > 0)
        g_string_append_printf(text, _("; use a step of %g s"),
                               fmin(tinker_advised_step(&forecast, stable), tinker_round_down(0.25 * step)));
    else if (stable != 0)
        g_string_append(text, _("; use a smaller step"));
    if (impulses) g_string_append(text, _(", or contact by events"));
    if (!chosen) return;
    if (choice.step > 0)
        g_string_append_printf(text, _(", or the method %s with a step of %g s, which is cheap here"),
                               choice.method->id, choice.step);
    else
        g_string_append_printf(text, _(", or the method %s, which is cheap here"), choice.method->id);
}

static double stable_step(const TinkerSpectrum *spectrum, const TinkerIntegrator *method)
{
    return tinker_method_is_fixed_explicit(method) ? tinker_spectrum_stable_step(spectrum, method, 0.8) : INFINITY;
}

char *tinker_guard_explain(TinkerModel *model, const TinkerIntegrator *method, double step, gboolean accurate)
{
    GString *text = g_string_new(NULL);
    if (accurate && append_doubt(text, model)) return g_string_free(text, FALSE);
    TinkerIsland island = {.model = model, .linear = tinker_linear_form_new(model)};
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(&island);
    double stable = stable_step(spectrum, method);
    append_blame(text, model, spectrum, method, step <= stable);
    if (stable == 0) g_string_append_printf(text, _("; %s is stable at no step here"), method->id);
    if (isfinite(stable) && stable > 0) {
        if (step > stable)
            g_string_append_printf(text, _("; %s is stable up to a step of about %.3g s here, the step was %.3g s"),
                                   method->id, stable, step);
        else
            g_string_append_printf(text,
                                   _("; near the start %s is stable up to a step of about %.3g s, but stable is not "
                                     "yet accurate: for the motion later on the step of %.3g s may be too long"),
                                   method->id, stable, step);
    }
    append_advice(text, &island, method, step, stable);
    tinker_linear_form_free(island.linear);
    return g_string_free(text, FALSE);
}

double tinker_guard_stable_step(TinkerModel *model, const TinkerIntegrator *method)
{
    TinkerIsland island = {.model = model, .linear = tinker_linear_form_new(model)};
    g_autoptr(TinkerSpectrum) spectrum = tinker_spectrum_new(&island);
    tinker_linear_form_free(island.linear);
    return stable_step(spectrum, method);
}
