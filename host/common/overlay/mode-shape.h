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

/* "Mode 3: 1.59 Hz, damping ratio 0.05", in the user's language. (transfer full) */
char *tinker_mode_caption(const TinkerMode *mode, guint number);

#endif
