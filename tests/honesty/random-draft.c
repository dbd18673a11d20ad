#include "random-draft.h"

#include <math.h>
#include <stdarg.h>

const char *const draft_masses[] = {"m0", "m1", "m2", "m3", "m4", "m5"};
const char *const draft_anchors[] = {"A0", "A1", "A2", "A3"};

double draft_between(RandomDraft *draft, double low, double high)
{
    return g_rand_double_range(draft->dice, low, high);
}

double draft_about(RandomDraft *draft, double low, double high)
{
    return low * pow(high / low, g_rand_double(draft->dice));
}

gboolean draft_happens(RandomDraft *draft, double probability)
{
    return g_rand_double(draft->dice) < probability;
}

void draft_is_as_fast_as(RandomDraft *draft, double rate)
{
    draft->scene->rate = fmax(draft->scene->rate, rate);
}

void draft_add(RandomDraft *draft, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (draft->blocks->len > 0) g_string_append(draft->blocks, ",\n");
    g_string_append_vprintf(draft->blocks, format, arguments);
    va_end(arguments);
}

void draft_add_gravity(RandomDraft *draft)
{
    draft_add(draft, "{'type': 'gravity', 'name': 'G'}");
}

void draft_add_anchor(RandomDraft *draft, double x, double y)
{
    draft_add(draft, "{'type': 'support', 'name': 'A%d', 'position': [%.17g, %.17g], 'solid': false}",
              draft->scene->anchors++, x, y);
}

void draft_add_mass(RandomDraft *draft, double mass, double x, double y, double vx, double vy)
{
    draft_add(draft,
              "{'type': 'mass', 'name': 'm%d', 'mass': %.17g, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g], "
              "'width': 0, 'height': 0}",
              draft->scene->bodies++, mass, x, y, vx, vy);
}

void draft_add_some_mass(RandomDraft *draft, double least, double most, double x, double y, double vx, double vy)
{
    draft_add_mass(draft, draft_about(draft, least, most), x, y, vx, vy);
}

void draft_add_spring(RandomDraft *draft, const char *from, const char *to, double stiffness, double mass)
{
    draft_is_as_fast_as(draft, 2 * sqrt(stiffness / mass));
    draft_add(draft, "{'type': 'spring', 'ends': ['%s', '%s'], 'stiffness': %.17g}", from, to, stiffness);
}

void draft_add_tense_spring(RandomDraft *draft, const char *from, const char *to, double stiffness, double mass,
                            double rest_length)
{
    draft_is_as_fast_as(draft, 2 * sqrt(stiffness / mass));
    draft_add(draft, "{'type': 'spring', 'ends': ['%s', '%s'], 'stiffness': %.17g, 'rest_length': %.17g}", from, to,
              stiffness, rest_length);
}

void draft_add_damper(RandomDraft *draft, const char *from, const char *to, double damping, double mass)
{
    draft_is_as_fast_as(draft, 2 * damping / mass);
    draft_add(draft, "{'type': 'damper', 'ends': ['%s', '%s'], 'damping': %.17g}", from, to, damping);
}

void draft_add_rod(RandomDraft *draft, const char *from, const char *to)
{
    draft_add(draft, "{'type': 'rod', 'ends': ['%s', '%s']}", from, to);
}

void draft_add_support_motion(RandomDraft *draft, const char *support, double angle, double amplitude, double frequency)
{
    double phase = draft_between(draft, -3, 3);
    const char *waveform = draft_happens(draft, 0.5) ? "sine" : "cosine";
    draft_is_as_fast_as(draft, frequency);
    draft_add(draft,
              "{'type': 'support-motion', 'ends': ['%s'], 'angle': %.17g, 'waveform': '%s', 'amplitude': %.17g, "
              "'frequency': %.17g, 'phase': %.17g}",
              support, angle, waveform, amplitude, frequency, phase);
}

void draft_add_motor(RandomDraft *draft, const char *mass, double angle)
{
    if (draft_happens(draft, 0.3)) {
        double fading = draft_between(draft, 1, 5), from = draft_between(draft, 0.3, 2),
               jump = draft_between(draft, 1, 6);
        draft_add(draft,
                  "{'type': 'motor', 'ends': ['%s'], 'angle': %.17g, 'waveform': {'expression': "
                  "'%.3g*step(t-%.3g)-%.3g*t*exp(-t)'}}",
                  mass, angle, jump, from, fading);
        return;
    }
    double frequency = draft_about(draft, 0.5, 15), phase = draft_between(draft, -3, 3),
           amplitude = draft_about(draft, 0.5, 10);
    draft_is_as_fast_as(draft, frequency);
    draft_add(draft,
              "{'type': 'motor', 'ends': ['%s'], 'angle': %.17g, 'waveform': 'sine', 'amplitude': %.17g, 'frequency': "
              "%.17g, 'phase': %.17g}",
              mass, angle, amplitude, frequency, phase);
}

void draft_add_wind(RandomDraft *draft)
{
    double drag = draft_about(draft, 0.05, 2),
           quadratic = draft_happens(draft, 0.5) ? draft_about(draft, 0.02, 0.5) : 0;
    double vy = draft_between(draft, -1, 1), vx = draft_between(draft, -4, 4);
    draft_add(draft,
              "{'type': 'wind', 'name': 'W', 'velocity': [%.17g, %.17g], 'drag': %.17g, 'drag_quadratic': "
              "%.17g}",
              vx, vy, drag, quadratic);
}

void draft_add_floor(RandomDraft *draft, const char *name, double x, double y, double angle, double width,
                     double restitution, double friction)
{
    const double half = 0.2; /* of its height */
    double middle_x = x + half * sin(angle), middle_y = y - half * cos(angle);
    draft_add(draft,
              "{'type': 'support', 'name': '%s', 'position': [%.17g, %.17g], 'orientation': %.17g, 'width': %.17g, "
              "'restitution': %.17g, 'static_friction': %.17g, 'dynamic_friction': %.17g}",
              name, middle_x, middle_y, angle, width, restitution, 1.2 * friction, friction);
}

double draft_some_restitution(RandomDraft *draft)
{
    return draft_happens(draft, 0.4) ? 0 : draft_between(draft, 0.2, 0.9);
}

double draft_some_friction(RandomDraft *draft)
{
    return draft_happens(draft, 0.35) ? 0 : draft_between(draft, 0.05, 0.7);
}

void draft_add_chain(RandomDraft *draft, int count, double lowest, double highest)
{
    double x = 0, y = 0;
    draft_add_anchor(draft, 0, 0);
    for (int i = 0; i < count; i++) {
        double length = draft_between(draft, 0.4, 1.5), angle = draft_between(draft, lowest, highest);
        x += length * sin(angle);
        y -= length * cos(angle);
        draft_add_mass(draft, draft_about(draft, 0.3, 3), x, y, 0, 0);
        draft_add_rod(draft, i == 0 ? draft_anchors[0] : draft_masses[i - 1], draft_masses[i]);
    }
    draft_is_as_fast_as(draft, 20);
}
