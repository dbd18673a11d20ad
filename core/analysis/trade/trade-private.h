/* What the files of the trade share. */
#ifndef TINKER_CORE_TRADE_PRIVATE_H
#define TINKER_CORE_TRADE_PRIVATE_H

#include "analysis/trade/trade.h"
#include "physics/model/model.h"

/* A scene on the test bench: the model, the times at which states are compared, and the clock. */
typedef struct {
    TinkerModel *model;
    TinkerFrame *frame;
    GArray *columns; /* of TinkerColumn: places, velocities, angles and their rates of the bodies */
    double *arms;    /* m: what each column is multiplied by, the radius of gyration of angles; else 1 */
    double *times;   /* s, ascending, none at 0 */
    gsize time_count;
    double duration;
    const TinkerTradeOptions *options;
    gint64 begun, run_end; /* µs, monotonic: of the measuring; when the present run is stopped */
    gboolean cancelled;    /* by the caller */
    struct {
        double from, to, begun, seconds; /* the shares of the progress that it goes through, and the time it may take */
    } phase;
} TinkerTradeBench;

/* The states of one run at the bench's times, and its books. */
typedef struct {
    gsize count, width; /* samples, and numbers a sample */
    double *states;
    double extent, speed; /* of the motion, turning by the radius of gyration: an angle counts up to its diameter */
    gint64 steps, evaluations;
    gboolean touches; /* bodies touched plates */
    double energy_error, constraint_error;
    double wall_s; /* with the samples */
} TinkerTrajectory;

gboolean tinker_trade_bench_init(TinkerTradeBench *bench, TinkerScene *scene, const TinkerTradeOptions *options,
                                 GError **error);
void tinker_trade_bench_clear(TinkerTradeBench *bench);

/* Seconds since the measuring began. */
double tinker_trade_bench_elapsed(const TinkerTradeBench *bench);

/* From now on progress goes from one share to another within this time. */
void tinker_trade_bench_enter(TinkerTradeBench *bench, double from, double to, double seconds);

/* Tells the progress, and asks whether the caller has had enough: TRUE. */
gboolean tinker_trade_bench_look(TinkerTradeBench *bench);

/* Runs once with all samples, stopped after `most` seconds (TINKER_MODEL_ERROR_STOPPED). The trajectory is empty
 * before, and after a failure. */
gboolean tinker_trade_bench_sample(TinkerTradeBench *bench, TinkerTradeSetting setting, double most,
                                   TinkerTrajectory *trajectory, GError **error);

/* Seconds that stepping to the end takes: the median of repeated runs. NAN where one was stopped or failed. */
double tinker_trade_bench_time(TinkerTradeBench *bench, TinkerTradeSetting setting, double expected, int *repeats);

void tinker_trajectory_clear(TinkerTrajectory *trajectory);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerTrajectory, tinker_trajectory_clear)

/* The largest scaled difference of two trajectories over their first `samples` samples; INFINITY where one is shorter.
 */
double tinker_trade_bench_distance(const TinkerTradeBench *bench, const TinkerTrajectory *left,
                                   const TinkerTrajectory *right, gsize samples, double extent, double speed);

/* Finds the reference among all installed methods. `truth` is the trajectory that counts, `samples` how many of its
 * samples. */
gboolean tinker_trade_find_reference(TinkerTradeBench *bench, const GPtrArray *integrators, double seconds,
                                     TinkerTradeReference *reference, TinkerTrajectory *truth, gsize *samples,
                                     GError **error);

/* What a measurement is compared with. */
typedef struct {
    const TinkerTradeReference *reference;
    const TinkerTrajectory *truth;
    gsize samples;
} TinkerTradeStandard;

/* How a measurement ended. */
typedef enum {
    TINKER_TRADE_DONE,
    TINKER_TRADE_FAILED,     /* the run did; another step may do better */
    TINKER_TRADE_STOPPED,    /* the time ran out, or the caller cancelled */
    TINKER_TRADE_UNSUITABLE, /* the method does not take this scene, whatever the step */
} TinkerTradeEnd;

/* Measures one setting within `most` seconds. Why there is no result is in the row's note. */
TinkerTradeEnd tinker_trade_measure(TinkerTradeBench *bench, const TinkerTradeStandard *standard,
                                    TinkerTradeSetting setting, double most, TinkerTradeRow *row);
void tinker_trade_row_clear(gpointer row);

/* Fills the method's rows, within `seconds`. */
void tinker_trade_sweep(TinkerTradeBench *bench, const TinkerTradeStandard *standard, TinkerTradeMethod *method,
                        double seconds);

/* Works out the observed order from the rows. */
void tinker_trade_observe_order(TinkerTradeMethod *method, double level);

/* Chooses, tries settings between the measured ones, and adds the one that is advised to the rows where it is new. */
void tinker_trade_advise(TinkerTradeBench *bench, const TinkerTradeStandard *standard, TinkerTrade *trade);

#endif
