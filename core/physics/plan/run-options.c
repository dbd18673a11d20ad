/* What a run may be asked for, and the method that it names. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdarg.h>

#include "numerics/methods/integrators.h"
#include "physics/contact/contacts.h"
#include "physics/plan/run-options.h"

/* What `auto` stands for: the smooth default. */
#define DEFAULT_METHOD "dop853"
/* More samples than this in one run are a mistake rather than a wish. */
#define MOST_SAMPLES 1e10
/* More steps than this are a mistake, too: that many would take days at the least. */
#define MOST_STEPS 1e12

TinkerRunOptions tinker_run_options_of(TinkerScene *scene)
{
    const TinkerRunSettings *run = &tinker_scene_head(scene)->run;
    return (TinkerRunOptions){
        .duration = run->duration,
        .interval = run->interval,
        .method = run->method,
        .step = run->step,
        .tolerance = run->tolerance,
        .accuracy = run->accuracy,
        .spectral_radius = run->spectral_radius,
        .impulses = g_strcmp0(run->contacts, "impulse") == 0,
        .estimate = TRUE,
    };
}

static gboolean refuse(GError **error, const char *format, ...) G_GNUC_PRINTF(2, 3);
static gboolean refuse(GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (error != NULL) *error = g_error_new_valist(TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD, format, arguments);
    va_end(arguments);
    return FALSE;
}

GPtrArray *tinker_method_ids(TinkerCatalogue *catalogue, guint *builtins)
{
    GPtrArray *ids = g_ptr_array_new_with_free_func(g_free);
    g_ptr_array_add(ids, g_strdup("auto"));
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++)
        g_ptr_array_add(ids, g_strdup((*each)->id));
    if (builtins != NULL) *builtins = ids->len;
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    g_autoptr(GPtrArray) of_plugins = tinker_libraries_integrators(libraries);
    for (guint i = 0; i < of_plugins->len; i++)
        g_ptr_array_add(ids, g_strdup(of_plugins->pdata[i]));
    return ids;
}

GPtrArray *tinker_plugin_methods(TinkerCatalogue *catalogue)
{
    GPtrArray *methods = g_ptr_array_new();
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    g_autoptr(GPtrArray) ids = tinker_libraries_integrators(libraries);
    for (guint i = 0; i < ids->len; i++) {
        const char *id = g_ptr_array_index(ids, i);
        const TinkerIntegrator *found =
            tinker_integrator_builtin(id) == NULL ? tinker_catalogue_integrator(catalogue, id, NULL) : NULL;
        if (found != NULL) g_ptr_array_add(methods, (gpointer)found);
    }
    return methods;
}

/* "auto, rk4, and of plugins heun"; `names` ends with NULL, `builtins` of them are built in. (transfer full) */
static char *list_of(GPtrArray *names, guint builtins)
{
    g_autoptr(GString) list = g_string_new(NULL);
    for (guint i = 0; i < builtins; i++)
        g_string_append_printf(list, "%s%s", i > 0 ? ", " : "", (const char *)names->pdata[i]);
    if (names->pdata[builtins] == NULL) return g_string_free(g_steal_pointer(&list), FALSE);
    g_autofree char *others = g_strjoinv(", ", (char **)names->pdata + builtins);
    return g_strdup_printf(_("%s, and of plugins %s"), list->str, others);
}

static const TinkerIntegrator *unknown_method(TinkerCatalogue *catalogue, const char *id, GError **error)
{
    if (g_str_equal(id, "impulse")) {
        g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                            _("\"impulse\" is no method, but a way to treat contacts (\"contacts\": \"impulse\" in "
                              "the scene's run)"));
        return NULL;
    }
    guint builtins;
    g_autoptr(GPtrArray) names = tinker_method_ids(catalogue, &builtins);
    g_ptr_array_add(names, NULL);
    g_autofree char *list = list_of(names, builtins);
    const char *nearest = tinker_nearest_word(id, (const char *const *)names->pdata);
    g_autofree char *refused = tinker_catalogue_explain_refused(catalogue, id);
    if (nearest != NULL)
        refuse(error, _("there is no method \"%s\"; did you mean \"%s\"? (there are %s)%s"), id, nearest, list,
               refused);
    else
        refuse(error, _("there is no method \"%s\" (there are %s)%s"), id, list, refused);
    return NULL;
}

static const TinkerIntegrator *find_method(TinkerCatalogue *catalogue, const char *id, GError **error)
{
    const TinkerIntegrator *method = tinker_integrator_builtin(g_str_equal(id, "auto") ? DEFAULT_METHOD : id);
    if (method != NULL) return method;
    g_autoptr(GError) missing = NULL;
    method = tinker_catalogue_integrator(catalogue, id, &missing);
    if (method != NULL) return method;
    if (g_error_matches(missing, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_REFUSED)) {
        g_propagate_error(error, g_steal_pointer(&missing));
        return NULL;
    }
    return unknown_method(catalogue, id, error);
}

const TinkerIntegrator *tinker_run_method(TinkerScene *scene, const char *id, GError **error)
{
    return find_method(tinker_scene_catalogue(scene), id, error);
}

char *tinker_method_fault(TinkerCatalogue *catalogue, const char *id)
{
    g_autoptr(GError) error = NULL;
    return find_method(catalogue, id, &error) != NULL ? NULL : g_strdup(error->message);
}

char *tinker_options_unmet(const TinkerRunOptions *options, const TinkerModel *model)
{
    return options->impulses ? NULL : tinker_contacts_unmet(model);
}

gboolean tinker_run_options_check(const TinkerRunOptions *options, const TinkerIntegrator *method, double duration,
                                  GError **error)
{
    if (!(duration >= 0) || !isfinite(duration))
        return refuse(error, _("the duration is %g (it must be a time of 0 s or more)"), duration);
    if (options->at == NULL && (!(options->interval > 0) || !isfinite(options->interval)))
        return refuse(error, _("the recording interval is %g (it must be greater than 0 s)"), options->interval);
    if (options->at == NULL && duration / options->interval > MOST_SAMPLES)
        return refuse(error, _("the number of samples is %g (it must be at most 1e10: record less often)"),
                      duration / options->interval);
    for (gsize i = 0; options->at != NULL && i < options->at_count; i++)
        if (!(options->at[i] >= 0) || !isfinite(options->at[i]))
            return refuse(error, _("the time of a sample is %g (it must be 0 s or more)"), options->at[i]);
    if (!(options->accuracy >= 0) || !(options->accuracy < 1))
        return refuse(error, _("the accuracy is %g (it must be between 0 and 1, as in 1e-6)"), options->accuracy);
    if (method == NULL || (method->flags & TINKER_INTEGRATOR_LINEAR)) return TRUE;
    if (method->flags & TINKER_INTEGRATOR_ADAPTIVE) {
        if (!(options->tolerance > 0) || !(options->tolerance < 1))
            return refuse(error, _("the tolerance is %g (it must be between 0 and 1, as in 1e-9)"), options->tolerance);
    } else if (!(options->step > 0) || !isfinite(options->step)) {
        return refuse(error, _("the step is %g (it must be greater than 0 s)"), options->step);
    } else if (duration / options->step > MOST_STEPS) {
        return refuse(error, _("the number of steps is %g (it must be at most 1e12: take a larger step)"),
                      duration / options->step);
    }
    return TRUE;
}

double tinker_options_duration(const TinkerRunOptions *options)
{
    double duration = options->at == NULL ? options->duration : 0;
    for (gsize i = 0; options->at != NULL && i < options->at_count; i++)
        duration = fmax(duration, options->at[i]);
    return duration;
}

double tinker_options_span(const TinkerRunOptions *options)
{
    return options->duration > 0 ? options->duration : tinker_options_duration(options);
}

double tinker_options_samples(const TinkerRunOptions *options)
{
    if (options->at != NULL) return (double)options->at_count;
    return options->interval > 0 ? fmax(1.0, options->duration / options->interval) : 1.0;
}
