/* A shape that is no standing one has a component out of step, which is seen a quarter of a swing later. */
#include "common/overlay/mode-shape.h"

#include <glib/gi18n.h>
#include <math.h>

#include "render/picture/painter.h"

#define SHARE  0.12 /* of the scene's greater side */
#define MAINLY 0.95 /* of the squares of a shape: then it goes one way */
#define A_PART 0.1  /* of the largest component: smaller ones stand still to the eye */

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

enum { SIDEWAYS, UPWARDS, TURNING };

static int32_t coordinate_of(const TinkerModeAnalysis *analysis, int32_t body, int way)
{
    double radius;
    return way == TURNING ? tinker_model_body_turn(analysis->model, body, &radius) : 2 * body + way;
}

/* Which way the bodies mainly go; -1 where that is not one way. */
static int main_way(const TinkerModeAnalysis *analysis, const TinkerMode *mode)
{
    double squares[3] = {0}, sum = 0;
    for (int32_t body = 0; body < tinker_model_sizes(analysis->model).bodies; body++) {
        for (int way = SIDEWAYS; way <= TURNING; way++) {
            const int32_t coordinate = coordinate_of(analysis, body, way);
            if (coordinate >= 0) squares[way] += mode->real[coordinate] * mode->real[coordinate];
        }
    }
    for (int way = SIDEWAYS; way <= TURNING; way++)
        sum += squares[way];
    for (int way = SIDEWAYS; way <= TURNING; way++)
        if (squares[way] >= MAINLY * sum) return way;
    return -1;
}

/* How many bodies go one way and the other. */
static void count_sides(const TinkerModeAnalysis *analysis, const TinkerMode *mode, int way, int sides[2])
{
    sides[0] = sides[1] = 0;
    for (int32_t body = 0; body < tinker_model_sizes(analysis->model).bodies; body++) {
        const int32_t coordinate = coordinate_of(analysis, body, way);
        if (coordinate >= 0 && fabs(mode->real[coordinate]) >= A_PART) sides[mode->real[coordinate] < 0]++;
    }
}

char *tinker_mode_motion(const TinkerModeAnalysis *analysis, const TinkerMode *mode)
{
    const char *const ways[] = {_("sideways"), _("up and down"), _("turning")};
    const int32_t size = tinker_model_sizes(analysis->model).coordinates;
    const int way = tinker_mode_is_standing(mode, size) ? main_way(analysis, mode) : -1;
    int sides[2];
    if (way < 0) return NULL;
    count_sides(analysis, mode, way, sides);
    if (sides[0] + sides[1] < 2) return g_strdup(ways[way]);
    if (sides[0] == 0 || sides[1] == 0) return g_strdup_printf(_("%s in step"), ways[way]);
    if (sides[0] == 1 && sides[1] == 1) return g_strdup_printf(_("%s against each other"), ways[way]);
    return g_strdup(ways[way]);
}

char *tinker_mode_caption(const TinkerModeAnalysis *analysis, const TinkerMode *mode, guint number)
{
    const double hertz = mode->frequency / (2 * G_PI), period = 1 / hertz;
    g_autofree char *motion = tinker_mode_motion(analysis, mode);
    g_autofree char *name =
        motion != NULL ? g_strdup_printf(_("Mode %u, %s"), number, motion) : g_strdup_printf(_("Mode %u"), number);
    switch (mode->kind) {
    case TINKER_MODE_RIGID:
        return g_strdup_printf(_("%s: moves freely, 0 Hz"), name);
    case TINKER_MODE_DECAY:
        return g_strdup_printf(_("%s: decays at %.4g 1/s"), name, mode->decay);
    case TINKER_MODE_GROWTH:
        return g_strdup_printf(_("%s: unstable, grows at %.4g 1/s"), name, -mode->decay);
    case TINKER_MODE_OSCILLATION:
        break;
    }
    if (mode->damping_ratio == 0)
        return g_strdup_printf(_("%s: ω₀ = %.4g rad/s, f = %.4g Hz, T = %.4g s"), name, mode->natural, hertz, period);
    return g_strdup_printf(_("%s: ω₀ = %.4g rad/s, damping ratio %.3g; damped: f = %.4g Hz, T = %.4g s"), name,
                           mode->natural, mode->damping_ratio, hertz, period);
}
