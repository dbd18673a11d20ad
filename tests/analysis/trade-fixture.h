/* What tests of the trade share: scenes whose motion is known, and what was measured of them. */
#ifndef TEST_TRADE_FIXTURE_H
#define TEST_TRADE_FIXTURE_H

#include "analysis/trade/trade.h"
#include "physics-fixture.h"

/* A scene whose motion is known: place and velocity of "Mass 0", extent of the motion and largest speed. */
typedef struct {
    const char *name, *blocks;
    double duration;
    void (*exact)(double t, double state[4]);
    double extent, speed;
} KnownMotion;

/* An oscillator, and a pendulum from high up. */
#define TRADE_MOTIONS 2
extern const KnownMotion trade_motions[TRADE_MOTIONS];

/* For an error of 1e-6, in three seconds. */
TinkerTradeOptions trade_options_for(double duration);

/* Nothing may be wrong. (transfer full) */
TinkerTrade *trade_of(TinkerScene *scene, const TinkerTradeOptions *options);

/* Of this id, which was measured; and its row. Borrowed. */
const TinkerTradeMethod *trade_method_of(const TinkerTrade *trade, const char *id);
const TinkerTradeRow *trade_row_of(const TinkerTradeMethod *method, guint i);

/* The error by the closed form, of a run of its own. */
double trade_true_error(const KnownMotion *motion, const TinkerTradeSetting *setting, double extent, double speed);

#endif
