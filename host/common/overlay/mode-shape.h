/* The shape of a mode, as it is drawn. */
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

#endif
