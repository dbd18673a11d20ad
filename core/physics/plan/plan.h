/* The plan: what of a scene is modelled, how each island is stepped, and why. Worked out from the model and from
 * operation counts, never from a clock: the same scene has the same plan on every machine. */
#ifndef TINKER_CORE_PLAN_H
#define TINKER_CORE_PLAN_H

#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/run-options.h"
#include "physics/plan/spectrum.h"

/* How one island is stepped. */
typedef struct {
    const TinkerIntegrator *method;
    double step, tolerance;
    double interval;       /* s: between the steps of an exact solution; else 0 */
    gboolean holds_energy; /* after every step the state is brought back onto the energy of the start: hold-energy.h */
} TinkerChoice;

typedef struct {
    GArray *blocks; /* of TinkerBlockId: bodies, then what acts on them, in scene order */
    int32_t bodies, degrees_of_freedom, constraint_rows, redundant_rows;
    gboolean linear, straight;
    gboolean shafts;          /* linear, as bodies on fixed axes */
    double direction[2];      /* of a straight one */
    double sideways_growth;   /* 1/s: straight motion is not stable; 0 */
    double omega_max;         /* rad/s: as the spectrum has it */
    double damping_max;       /* 1/s: largest rate of decay */
    double growth_max;        /* 1/s: how fast the start is left, where it is not stable; 0 */
    TinkerSpectrum *spectrum; /* what limits steps (owned) */
    double spectral_radius;   /* of the run's options */
    TinkerChoice choice;      /* of step and tolerance the one that does not count for the method is 0 */
    char *reason;             /* a sentence: why this method */
    double evaluations;       /* of the accelerations, expected of the whole run without its companion */
    double operations;        /* likewise: floating-point operations as counted by the cost model */
    double expected_s;        /* the same in seconds on the machine that the counts were calibrated on once */
    double expected_error;    /* relative to the scales of the island */
} TinkerIslandPlan;

typedef struct {
    double accuracy;                /* that is asked for, as in TinkerRunOptions; 0: none */
    GPtrArray *islands;             /* of TinkerIslandPlan *, in the order of the islands */
    GPtrArray *redundant;           /* of char *: names of the blocks whose constraints depend on others */
    GPtrArray *modelled, *left_out; /* of char *: sentences */
    GPtrArray *warnings;            /* of TinkerWarning * */
} TinkerPlan;

/* Plans a run. `islands` are those of the model. Errors: TINKER_MODEL_ERROR_METHOD. (transfer full) */
TinkerPlan *tinker_plan_new(TinkerModel *model, GPtrArray *islands, const TinkerRunOptions *options, GError **error);
void tinker_plan_free(TinkerPlan *plan);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerPlan, tinker_plan_free)

/* The methods whose steps stability limits: the built-in ones and, where it is none of them, the island's own. Of const
 * TinkerIntegrator *. (transfer container) */
GPtrArray *tinker_plan_limited_methods(const TinkerIslandPlan *island);

/* The largest step at which a fixed-step explicit method is stable on the linearised island; INFINITY where nothing
 * limits it, 0 where no step is stable, NAN where it is not known (spectrum.h). */
double tinker_plan_stable_step(const TinkerIslandPlan *island, const TinkerIntegrator *method);

/* What a run of one island needs before it starts: the method of `options`, or the one that suits. Cheap: bounded by
 * about thirty evaluations of the island's forces. Adds warnings (of TinkerWarning *): steps beyond the stable one,
 * modes that carry energy and are under-resolved. */
gboolean tinker_plan_choose(const TinkerIsland *island, const TinkerRunOptions *options, TinkerChoice *choice,
                            GPtrArray *warnings, GError **error);

#endif
