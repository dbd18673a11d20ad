/* The trade of speed against accuracy, measured on one scene: every suitable method over a range of steps or
 * tolerances, each run timed and compared with a reference that two different methods confirm to each other.
 *
 * The error of a run is the largest, over the sampled times, of the Euclidean norm of the difference of its state from
 * the reference's: positions divided by the extent of the motion, velocities by its largest speed. The wall time is the
 * median of repeated runs, of stepping alone.
 */
#ifndef TINKER_CORE_TRADE_H
#define TINKER_CORE_TRADE_H

#include "physics/plan/run-options.h"

typedef struct {
    TinkerRunOptions run;                       /* duration, times of samples and spectral radius count */
    const char *const *methods;                 /* ids, NULL-terminated; NULL: all that are installed */
    double error;                               /* that is wished for */
    double budget;                              /* s of wall time that a run may take; 0: the advice is by `error` */
    double seconds;                             /* that measuring may take, about */
    gboolean (*cancelled)(void *data);          /* TRUE ends the measuring; may be NULL */
    void (*progress)(double share, void *data); /* of the work done, 0 to 1; may be NULL */
    void *data;                                 /* of the two */
} TinkerTradeOptions;

/* What a run is to use. */
typedef struct {
    const char *method; /* id, static or the catalogue's; "impulse": contact as impulses */
    gboolean adaptive;  /* `value` is a tolerance; else a step in s */
    double value;       /* 0: the method takes neither */
} TinkerTradeSetting;

/* One measurement. */
typedef struct {
    TinkerTradeSetting setting;
    double wall_s;      /* median; NAN where the run failed */
    int repeats;        /* that the median is of */
    double mean_step;   /* s */
    gint64 evaluations; /* of accelerations */
    double error;       /* NAN where the run failed */
    gboolean at_limit;  /* the error is below what the reference is confirmed to: it may be anything up to that */
    double energy_error, constraint_error;
    gboolean advised; /* the one that the advice names */
    char *note;       /* why it failed, or NULL; owned */
} TinkerTradeRow;

typedef struct {
    const char *id;
    const TinkerIntegrator *integrator;
    /* Of TinkerTradeRow, the coarsest first; one alone, with the reason, where the method does not suit the scene. */
    GArray *rows;
    double order; /* observed: slope of the error over the mean step, both logarithmic; NAN where too few rows tell */
    gboolean asymptotic;  /* whether the slope is that of a range where it holds still */
    gboolean out_of_time; /* finer settings would have taken longer than they were given */
} TinkerTradeMethod;

/* What errors are measured against. */
typedef struct {
    TinkerTradeSetting truth, witness; /* the runs that confirm each other; the first counts */
    double level;                      /* largest difference of the two up to `until`, and no less than rounding */
    double until;                      /* s: errors are measured up to here */
    gboolean whole;                    /* that is all of the run; else the two part there, */
    gboolean predictable; /* only because there was no time for finer settings; FALSE: whatever the settings */
    double extent, speed; /* m, m/s: what differences are divided by */
} TinkerTradeReference;

typedef enum {
    TINKER_TRADE_ADVICE_NONE,    /* nothing was measured that could be advised */
    TINKER_TRADE_ADVICE_MET,     /* the cheapest, or within the budget the most accurate, that does as wished */
    TINKER_TRADE_ADVICE_NEAREST, /* nothing does: the one that comes nearest */
} TinkerTradeAdviceKind;

typedef struct {
    TinkerTradeAdviceKind kind;
    TinkerTradeRow row; /* a copy without its note */
} TinkerTradeAdvice;

typedef struct {
    double duration;    /* s of motion that every run simulates */
    GPtrArray *methods; /* of TinkerTradeMethod * */
    TinkerTradeReference reference;
    TinkerTradeAdvice advice;
    gboolean interrupted; /* what was measured up to then is here */
} TinkerTrade;

/* Measures. Errors: those of tinker_model_new; TINKER_MODEL_ERROR_METHOD for an unknown method; TINKER_MODEL_ERROR_RUN
 * where no two methods agree on the motion, so that there is nothing to measure against; TINKER_MODEL_ERROR_STOPPED
 * where it was cancelled before there was a reference. (transfer full) */
TinkerTrade *tinker_trade_new(TinkerScene *scene, const TinkerTradeOptions *options, GError **error);
void tinker_trade_free(TinkerTrade *trade);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerTrade, tinker_trade_free)

/* The advice as a sentence. (transfer full) */
char *tinker_trade_advice_text(const TinkerTrade *trade, const TinkerTradeOptions *options);

/* What errors were measured against, as a sentence. (transfer full) */
char *tinker_trade_reference_text(const TinkerTrade *trade);

/* Puts the advised method and its step or tolerance into the scene's run settings, and contact by events or as
 * impulses; an accuracy that is asked for there, in whose place the two are now, is taken out. */
void tinker_trade_apply(const TinkerTrade *trade, TinkerScene *scene);

#endif
