/* A shape that is no standing one has a component out of step, which is seen a quarter of a swing later. */
#include "common/overlay/mode-shape.h"

#include <math.h>

#include "render/picture/painter.h"

#define SHARE 0.12 /* of the scene's greater side */

double tinker_mode_amplitude(TinkerFrame *frame)
{
    double box[4];
    tinker_painter_bounds(frame, box);
    return SHARE * fmax(box[2] - box[0], box[3] - box[1]);
}

/* How far (m) a coordinate is from its state. */
static double offset(const TinkerMode *mode, int32_t coordinate, double amplitude, double phase)
{
    if (mode == NULL) return 0;
    return amplitude * (mode->real[coordinate] * cos(phase) - mode->imaginary[coordinate] * sin(phase));
}

/* Of what is wound on bodies, as it is there. */
static void tell_lengths(TinkerFrame *frame, const TinkerModeAnalysis *analysis, const TinkerMode *mode,
                         double amplitude, double phase)
{
    const int32_t coordinates = tinker_model_sizes(analysis->model).coordinates;
    int32_t count;
    const TinkerBlockId *wound = tinker_frame_wound(frame, &count);
    if (count == 0) return;
    g_autofree double *q = g_new(double, MAX(coordinates, 1));
    for (int32_t i = 0; i < coordinates; i++)
        q[i] = analysis->q[i] + offset(mode, i, amplitude, phase);
    for (int32_t i = 0; i < count; i++)
        tinker_frame_set_length(frame, wound[i], tinker_model_held_length(analysis->model, q, wound[i]));
}

void tinker_mode_place(TinkerFrame *frame, const TinkerModeAnalysis *analysis, const TinkerMode *mode, double amplitude,
                       double phase)
{
    double origin[2], x, y, orientation, radius;
    tinker_model_origin(analysis->model, origin);
    for (int32_t body = 0; body < tinker_model_sizes(analysis->model).bodies; body++) {
        const TinkerBlockId block = tinker_model_body_block(analysis->model, body);
        const int32_t turn = tinker_model_body_turn(analysis->model, body, &radius);
        tinker_frame_centre(frame, block, &x, &y, &orientation);
        if (turn >= 0) orientation = (analysis->q[turn] + offset(mode, turn, amplitude, phase)) / radius;
        x = origin[0] + analysis->q[2 * body] + offset(mode, 2 * body, amplitude, phase);
        y = origin[1] + analysis->q[2 * body + 1] + offset(mode, 2 * body + 1, amplitude, phase);
        tinker_frame_place(frame, block, x, y, orientation);
    }
    tell_lengths(frame, analysis, mode, amplitude, phase);
}
