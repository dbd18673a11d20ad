/* What a run may be asked for. */
#ifndef TINKER_CORE_RUN_OPTIONS_H
#define TINKER_CORE_RUN_OPTIONS_H

#include "physics/model/model.h"
#include "scene/store/scene.h"

/* What the error estimate has found, up to a sample that the companion has come to. */
typedef struct {
    double t;                 /* s */
    double error;             /* the largest so far, relative to the scales of the motion */
    double predictable_until; /* s: where it passed a tenth; INFINITY */
    const double *bands; /* by how much each column may be off, in its unit; NULL where it is a matter of rounding */
} TinkerFound;

typedef struct {
    double duration;    /* s */
    double interval;    /* s between samples; ignored where `at` is given */
    const double *at;   /* times of the samples, any order; or NULL. Borrowed until the simulation is freed */
    gsize at_count;     /* the run lasts to the greatest of them */
    const char *method; /* "auto", or an integrator's id */
    double step;        /* s, of fixed-step methods */
    double tolerance;   /* of adaptive methods */
    double accuracy; /* wanted error estimate of the run: the plan chooses step and tolerance for it, and both are left
                           out of account; 0: they count. Held by tinker_accurate_run */
    double spectral_radius;
    gboolean impulses;                 /* contact as impulses, in steps of `step`, whatever `method` */
    gboolean estimate;                 /* run a companion for the error estimate */
    gboolean bands;                    /* and evaluate the columns on it too */
    gboolean (*cancelled)(void *data); /* asked now and then; TRUE stops the run. May be NULL */
    void (*progress)(double t, double duration, void *data); /* called now and then. May be NULL */
    /* Called for each sample, in their order, as soon as the companion has come there, and where it stops on the way
     * (`error` is NAN then), on whatever thread that is: the run may be far ahead. May be NULL. */
    void (*found)(const TinkerFound *found, void *data);
    void *data; /* of the three */
    GArray
        *jolts; /* of TinkerJolt (constraint/jolts.h): what gives bodies impulses, in place of what is there; or NULL */
} TinkerRunOptions;

/* The scene's own settings. Strings are borrowed from it. */
TinkerRunOptions tinker_run_options_of(TinkerScene *scene);

/* What is wrong with a method of this name, "there is no method ...", or NULL: for TinkerCatalogueOptions. (transfer
 * full) */
char *tinker_method_fault(TinkerCatalogue *catalogue, const char *id);

/* How long a run lasts (s): to the last sample; the time that methods and steps are chosen for, which samples do not
 * change: the scene's duration; and the number of samples. */
double tinker_options_duration(const TinkerRunOptions *options);
double tinker_options_span(const TinkerRunOptions *options);
double tinker_options_samples(const TinkerRunOptions *options);

/* The integrator of this name: built in, or of a plugin; "auto" is the default one. NULL with
 * TINKER_MODEL_ERROR_METHOD. */
const TinkerIntegrator *tinker_run_method(TinkerScene *scene, const char *id, GError **error);

/* The methods of plugins, none of which has the id of one that is built in; of const TinkerIntegrator *, which lives as
 * long as the catalogue. What is refused is left out. (transfer full) */
GPtrArray *tinker_plugin_methods(TinkerCatalogue *catalogue);

/* Of all methods that a run may name: "auto", those that are built in (`builtins`, unless NULL, is how many these are
 * with "auto"), those of plugins; of char *. (transfer full) */
GPtrArray *tinker_method_ids(TinkerCatalogue *catalogue, guint *builtins);

/* What is to be told where bodies of the scene could meet and do not, as there are too many for contact by events;
 * NULL: nothing. (transfer full) */
char *tinker_options_unmet(const TinkerRunOptions *options, const TinkerModel *model);

gboolean tinker_run_options_check(const TinkerRunOptions *options, const TinkerIntegrator *method, double duration,
                                  GError **error);

#endif
