/* The shape of a mode, as it is drawn, and what it is called. */
#ifndef TINKER_HOST_MODE_SHAPE_H
#define TINKER_HOST_MODE_SHAPE_H

#include "analysis/modes/mode-analysis.h"
#include "scene/frame/frame.h"

/* How far (m) the largest component of a shape is drawn in a frame of the analysed scene. */
double tinker_mode_amplitude(TinkerFrame *frame);

/* Puts the bodies of a frame of the analysed scene where they are in its state, and `amplitude` (m) along the shape at
 * a phase of the swing (rad): Re(shape exp(i phase)). `mode` NULL: the state alone. */
void tinker_mode_place(TinkerFrame *frame, const TinkerModeAnalysis *analysis, const TinkerMode *mode, double amplitude,
                       double phase);

/* What the bodies do in a mode, in the user's language: "sideways", "up and down against each other"; NULL where that
 * is not simple, or no standing shape. (transfer full) */
char *tinker_mode_motion(const TinkerModeAnalysis *analysis, const TinkerMode *mode);

/* "Mode 3, sideways: ω₀ = 10 rad/s, f = 1.592 Hz, T = 0.6283 s", in the user's language; of a damped one "ω₀ = 10
 * rad/s, damping ratio 0.1; damped: f = 1.584 Hz, T = 0.6315 s": ω₀ without damping, f and T as it swings. (transfer
 * full) */
char *tinker_mode_caption(const TinkerModeAnalysis *analysis, const TinkerMode *mode, guint number);

#endif
