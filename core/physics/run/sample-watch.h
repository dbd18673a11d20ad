/* Watching a run for motion that its samples do not show: curves and playback are drawn through samples, and what goes
 * there and back between two of them looks slower than it is, or at rest. */
#ifndef TINKER_CORE_SAMPLE_WATCH_H
#define TINKER_CORE_SAMPLE_WATCH_H

#include "physics/run/island-runs.h"

/* NULL where samples are few, or are at times that were asked for one by one. The runs are borrowed.
 * (transfer full) */
TinkerSampleWatch *tinker_sample_watch_new(TinkerIslandRuns *runs);
void tinker_sample_watch_free(TinkerSampleWatch *watch);

/* The next sample is to be at t (s). */
void tinker_sample_watch_expect(TinkerSampleWatch *watch, double t);

/* The island with this number has made a step, which began at `from` (s): once between two samples its bodies are
 * looked at. */
void tinker_sample_watch_step(TinkerSampleWatch *watch, guint island, double from);

/* The sample is taken: compares what was seen with the line from the sample before. */
void tinker_sample_watch_take(TinkerSampleWatch *watch);

/* Warns of the body that leaves these lines farthest, for its range, with an interval that would show its motion; of
 * none where samples show all. */
void tinker_sample_watch_tell(const TinkerSampleWatch *watch, TinkerSummary *summary);

#endif
