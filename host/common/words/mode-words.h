/* What is said of the modes of a scene, in the user's language. */
#ifndef TINKER_HOST_MODE_WORDS_H
#define TINKER_HOST_MODE_WORDS_H

#include "analysis/modes/mode-analysis.h"

/* What the bodies do in a mode: "sideways", "up and down against each other"; NULL where that is not simple, or no
 * standing shape. (transfer full) */
char *tinker_mode_motion(const TinkerModeAnalysis *analysis, const TinkerMode *mode);

/* "Mode 3, sideways: ω₀ = 10 rad/s, f = 1.592 Hz, T = 0.6283 s"; of a damped one "ω₀ = 10 rad/s, damping ratio 0.1;
 * damped: f = 1.584 Hz, T = 0.6315 s": ω₀ without damping, f and T as it swings. Of number 0 "Mode, up and down: …".
 * (transfer full) */
char *tinker_mode_caption(const TinkerModeAnalysis *analysis, const TinkerMode *mode, guint number);

/* "Mass 0 : Mass 1 = 1 : −1", how far bodies go the way that they mainly go, of the first that moves 1; of what turns
 * their angles. NULL but of two or three bodies, and where they do not go one way. The scene is that of the analysis.
 * (transfer full) */
char *tinker_mode_ratio(const TinkerModeAnalysis *analysis, const TinkerMode *mode, TinkerScene *scene);

/* A sentence for each thing that is there and does not count: bodies that touch, joints that drive. The scene is that
 * of the analysis. (transfer full) */
GPtrArray *tinker_modes_left_out(const TinkerModeAnalysis *analysis, TinkerScene *scene);

/* Why an analysis has no mode: nothing can move, or what holds it. The scene is that of the analysis. (transfer full)
 */
char *tinker_modes_none(const TinkerModeAnalysis *analysis, TinkerScene *scene);

#endif
