/* What the tests of physics share: runs from the text of a scene to the samples, through the real plugins.
 *
 * Texts of scenes are written with ' in place of " and hold the blocks alone: "{'type': 'mass'}, {'type': 'gravity'}".
 */
#ifndef TEST_PHYSICS_FIXTURE_H
#define TEST_PHYSICS_FIXTURE_H

#include "physics/model/model.h"
#include "physics/run/accurate-run.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"
#include "scene-fixture.h"

typedef struct {
    const char *method;  /* NULL: dop853 */
    double duration;     /* 0: 1 s */
    double interval;     /* 0: a tenth of the duration */
    double step;         /* 0: 0.01 s */
    double tolerance;    /* 0: 1e-12 */
    double accuracy;     /* 0: none; held where there is an estimate */
    const char *columns; /* as on a command line; NULL: none */
    const double *at;
    gsize at_count;
    const char *path;       /* what the scene's file is called: tables are looked for beside it */
    gboolean estimate;      /* run a companion for the error estimate */
    gboolean bands;         /* and evaluate the columns on it too */
    gboolean impulses;      /* contact as impulses, in steps of `step` */
    const char *impact_law; /* NULL: newton */
    void (*found)(const TinkerFound *found, void *data); /* as in TinkerRunOptions; or NULL */
    void *found_data;
} PhysicsOptions;

typedef struct {
    TinkerScene *scene;
    TinkerModel *model;           /* NULL where it did not compile */
    TinkerSimulation *simulation; /* NULL where it could not be prepared */
    const TinkerSummary *summary;
    GArray *columns;
    GArray *samples; /* of double: time and values, sample by sample */
    GError *error;   /* of compiling, preparing or running */
} PhysicsRun;

/* Replaces g_test_init and g_test_run, with the plugins of this folder. */
int physics_main(int argc, char **argv, void (*add_tests)(void));

/* A scene of these blocks. `path` may be NULL. (transfer full) */
TinkerScene *physics_scene(const char *path, const char *blocks);

/* Compiles, prepares and runs. physics_run fails the test where that fails; physics_try leaves the error. (transfer
 * full) */
PhysicsRun *physics_run(const PhysicsOptions *options, const char *blocks, ...) G_GNUC_PRINTF(2, 3);
PhysicsRun *physics_try(const PhysicsOptions *options, const char *blocks, ...) G_GNUC_PRINTF(2, 3);
/* Compiles and prepares a simulation that has not taken a step. */
PhysicsRun *physics_prepare(const PhysicsOptions *options, const char *blocks, ...) G_GNUC_PRINTF(2, 3);
void physics_run_free(PhysicsRun *run);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(PhysicsRun, physics_run_free)

gsize physics_samples(const PhysicsRun *run);
double physics_time(const PhysicsRun *run, gsize sample);
double physics_value(const PhysicsRun *run, gsize sample, gsize column);
/* Of the last sample. */
double physics_last(const PhysicsRun *run, gsize column);

/* Where a mass is at the end: x, y, vx, vy. */
void physics_state(const PhysicsRun *run, const char *block, double state[4]);
/* The states of all masses of two runs have the same bits. */
void physics_assert_same_bits(const PhysicsRun *left, const PhysicsRun *right);

/* |value - truth| <= bound; says what and how much where it is not. */
void physics_assert_near(const char *what, double value, double truth, double bound);
/* The largest |column - truth(t)| over all samples is at most `bound`. */
void physics_assert_follows(const PhysicsRun *run, gsize column, double (*truth)(double t, const void *data),
                            const void *data, double bound);
/* The run failed with this error, whose message contains all the texts up to NULL. */
void physics_assert_refused(const PhysicsRun *run, TinkerModelError code, ...) G_GNUC_NULL_TERMINATED;

/* An independent fine integration of y' = f(t, y), by the classical Runge-Kutta method. */
void physics_rk4(int n, double *y, double from, double to, int steps,
                 void (*f)(double t, const double *y, double *rate, const void *data), const void *data);

/* Blocks of nearly every kind without contact: gravity, wind, rods, springs and dampers, a support and a mass that are
 * driven. */
extern const char physics_rods_and_springs[];

#endif
