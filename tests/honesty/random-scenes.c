#include "random-scenes.h"

#include <math.h>
#include <stdarg.h>

/* A scene that is being written. Dice are thrown in statements of their own, one in a call at most: in which order a
 * compiler works out several arguments is its own affair, and a seed is to give the same scene with any. */
typedef struct {
    GRand *dice;
    GString *blocks;
    RandomScene *scene;
} Draft;

static double between(Draft *draft, double low, double high)
{
    return g_rand_double_range(draft->dice, low, high);
}

/* Any order of magnitude is as likely as the others. */
static double about(Draft *draft, double low, double high)
{
    return low * pow(high / low, g_rand_double(draft->dice));
}

static gboolean happens(Draft *draft, double probability)
{
    return g_rand_double(draft->dice) < probability;
}

static void is_as_fast_as(Draft *draft, double rate)
{
    draft->scene->rate = fmax(draft->scene->rate, rate);
}

/* Blocks are written with ' in place of ". */
static void add(Draft *draft, const char *format, ...) G_GNUC_PRINTF(2, 3);
static void add(Draft *draft, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (draft->blocks->len > 0) g_string_append(draft->blocks, ",\n");
    g_string_append_vprintf(draft->blocks, format, arguments);
    va_end(arguments);
}

/* Blocks ----------------------------------------------------------------------------------------------------------- */

static void add_gravity(Draft *draft)
{
    add(draft, "{'type': 'gravity', 'name': 'G'}");
}

static void add_anchor(Draft *draft, double x, double y)
{
    add(draft, "{'type': 'support', 'name': 'A%d', 'position': [%.17g, %.17g], 'solid': false}",
        draft->scene->anchors++, x, y);
}

static void add_mass(Draft *draft, double mass, double x, double y, double vx, double vy)
{
    add(draft,
        "{'type': 'mass', 'name': 'm%d', 'mass': %.17g, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g], "
        "'width': 0, 'height': 0}",
        draft->scene->bodies++, mass, x, y, vx, vy);
}

/* One whose mass is drawn. */
static void add_some_mass(Draft *draft, double least, double most, double x, double y, double vx, double vy)
{
    add_mass(draft, about(draft, least, most), x, y, vx, vy);
}

static void add_spring(Draft *draft, const char *from, const char *to, double stiffness, double mass)
{
    is_as_fast_as(draft, 2 * sqrt(stiffness / mass));
    add(draft, "{'type': 'spring', 'ends': ['%s', '%s'], 'stiffness': %.17g}", from, to, stiffness);
}

/* Under tension or pressure as it is placed. */
static void add_tense_spring(Draft *draft, const char *from, const char *to, double stiffness, double mass,
                             double rest_length)
{
    is_as_fast_as(draft, 2 * sqrt(stiffness / mass));
    add(draft, "{'type': 'spring', 'ends': ['%s', '%s'], 'stiffness': %.17g, 'rest_length': %.17g}", from, to,
        stiffness, rest_length);
}

static void add_damper(Draft *draft, const char *from, const char *to, double damping, double mass)
{
    is_as_fast_as(draft, 2 * damping / mass);
    add(draft, "{'type': 'damper', 'ends': ['%s', '%s'], 'damping': %.17g}", from, to, damping);
}

static void add_rod(Draft *draft, const char *from, const char *to)
{
    add(draft, "{'type': 'rod', 'ends': ['%s', '%s']}", from, to);
}

static void add_support_motion(Draft *draft, const char *support, double angle, double amplitude, double frequency)
{
    double phase = between(draft, -3, 3);
    const char *waveform = happens(draft, 0.5) ? "sine" : "cosine";
    is_as_fast_as(draft, frequency);
    add(draft,
        "{'type': 'support-motion', 'ends': ['%s'], 'angle': %.17g, 'waveform': '%s', 'amplitude': %.17g, "
        "'frequency': %.17g, 'phase': %.17g}",
        support, angle, waveform, amplitude, frequency, phase);
}

static void add_motor(Draft *draft, const char *mass, double angle)
{
    if (happens(draft, 0.3)) {
        double fading = between(draft, 1, 5), from = between(draft, 0.3, 2), jump = between(draft, 1, 6);
        add(draft,
            "{'type': 'motor', 'ends': ['%s'], 'angle': %.17g, 'waveform': {'expression': "
            "'%.3g*step(t-%.3g)-%.3g*t*exp(-t)'}}",
            mass, angle, jump, from, fading);
        return;
    }
    double frequency = about(draft, 0.5, 15), phase = between(draft, -3, 3), amplitude = about(draft, 0.5, 10);
    is_as_fast_as(draft, frequency);
    add(draft,
        "{'type': 'motor', 'ends': ['%s'], 'angle': %.17g, 'waveform': 'sine', 'amplitude': %.17g, 'frequency': "
        "%.17g, 'phase': %.17g}",
        mass, angle, amplitude, frequency, phase);
}

static void add_wind(Draft *draft)
{
    double drag = about(draft, 0.05, 2), quadratic = happens(draft, 0.5) ? about(draft, 0.02, 0.5) : 0;
    double vy = between(draft, -1, 1), vx = between(draft, -4, 4);
    add(draft,
        "{'type': 'wind', 'name': 'W', 'velocity': [%.17g, %.17g], 'drag': %.17g, 'drag_quadratic': "
        "%.17g}",
        vx, vy, drag, quadratic);
}

/* A solid support whose top goes through (x, y). */
static void add_floor(Draft *draft, const char *name, double x, double y, double angle, double width,
                      double restitution, double friction)
{
    const double half = 0.2; /* of its height */
    double middle_x = x + half * sin(angle), middle_y = y - half * cos(angle);
    add(draft,
        "{'type': 'support', 'name': '%s', 'position': [%.17g, %.17g], 'orientation': %.17g, 'width': %.17g, "
        "'restitution': %.17g, 'static_friction': %.17g, 'dynamic_friction': %.17g}",
        name, middle_x, middle_y, angle, width, restitution, 1.2 * friction, friction);
}

static double some_restitution(Draft *draft)
{
    return happens(draft, 0.4) ? 0 : between(draft, 0.2, 0.9);
}

static double some_friction(Draft *draft)
{
    return happens(draft, 0.35) ? 0 : between(draft, 0.05, 0.7);
}

static const char *const masses[] = {"m0", "m1", "m2", "m3", "m4", "m5"};
static const char *const anchors[] = {"A0", "A1", "A2", "A3"};

/* Without contact -------------------------------------------------------------------------------------------------- */

/* Masses in a row along a line, with springs and dampers between them and an anchor at one end or both. */
static void write_row(Draft *draft, double turn, double velocity_across)
{
    int count = g_rand_int_range(draft->dice, 1, 5);
    double c = cos(turn), s = sin(turn);
    double least = 0.3, stiffness = about(draft, 5, 2000);
    add_anchor(draft, 0, 0);
    for (int i = 0; i < count; i++) {
        double along = 1.0 * (i + 1), v = between(draft, -1.5, 1.5), u = velocity_across * between(draft, -1, 1);
        add_mass(draft, about(draft, least, 3), along * c, along * s, v * c - u * s, v * s + u * c);
    }
    for (int i = 0; i < count; i++) {
        const char *from = i == 0 ? anchors[0] : masses[i - 1];
        add_spring(draft, from, masses[i], stiffness * between(draft, 0.3, 1), least);
        if (happens(draft, 0.4)) add_damper(draft, from, masses[i], about(draft, 0.05, 2), least);
    }
    if (!happens(draft, 0.4)) return;
    add_anchor(draft, (count + 1) * c, (count + 1) * s);
    add_spring(draft, masses[count - 1], anchors[1], stiffness, least);
}

static void write_straight(Draft *draft)
{
    write_row(draft, happens(draft, 0.5) ? 0 : between(draft, -1, 1), 0);
}

static void write_passing(Draft *draft)
{
    add_anchor(draft, 0, 0);
    add_some_mass(draft, 0.2, 1, 1, 0, between(draft, -9, 0), 0);
    add_some_mass(draft, 0.2, 2, 2, 0, between(draft, -2, 2), 0);
    double rest = happens(draft, 0.5) ? 0 : 0.5;
    add_tense_spring(draft, "A0", "m0", about(draft, 10, 300), 0.2, rest);
    rest = between(draft, 0.2, 1.2);
    add_tense_spring(draft, "m0", "m1", about(draft, 10, 300), 0.2, rest);
    draft->scene->duration = fmin(draft->scene->duration, 4);
}

static void write_plane(Draft *draft)
{
    if (happens(draft, 0.6)) add_gravity(draft);
    write_row(draft, between(draft, -3, 3), 1.5);
}

/* Rods in a row from an anchor. */
static void write_chain(Draft *draft, int count, double lowest, double highest)
{
    double x = 0, y = 0;
    add_anchor(draft, 0, 0);
    for (int i = 0; i < count; i++) {
        double length = between(draft, 0.4, 1.5), angle = between(draft, lowest, highest);
        x += length * sin(angle);
        y -= length * cos(angle);
        add_mass(draft, about(draft, 0.3, 3), x, y, 0, 0);
        add_rod(draft, i == 0 ? anchors[0] : masses[i - 1], masses[i]);
    }
    is_as_fast_as(draft, 20);
}

static void write_pendulum(Draft *draft)
{
    int count = happens(draft, 0.5) ? 1 : g_rand_int_range(draft->dice, 2, 4);
    add_gravity(draft);
    write_chain(draft, count, count == 1 ? -2.9 : -1.2, count == 1 ? 2.9 : 1.2);
}

static void write_linkage(Draft *draft)
{
    int count = g_rand_int_range(draft->dice, 1, 4);
    add_gravity(draft);
    write_chain(draft, count, -1.5, 1.5);
    double y = between(draft, -1, 2);
    add_anchor(draft, between(draft, -3, 3), y);
    add_spring(draft, masses[count - 1], "A1", about(draft, 2, 200), 0.3);
    if (happens(draft, 0.6)) add_damper(draft, masses[count - 1], "A1", about(draft, 0.05, 3), 0.3);
}

static void write_driven(Draft *draft)
{
    if (happens(draft, 0.4)) {
        add_gravity(draft);
        write_chain(draft, 1, -1.5, 1.5);
    } else {
        write_plane(draft);
    }
    double frequency = about(draft, 0.5, 12), amplitude = about(draft, 0.02, 0.4);
    add_support_motion(draft, "A0", between(draft, -3, 3), amplitude, frequency);
}

static void write_motors(Draft *draft)
{
    write_plane(draft);
    add_motor(draft, "m0", between(draft, -3, 3));
    if (draft->scene->bodies > 1 && happens(draft, 0.5)) add_motor(draft, "m1", between(draft, -3, 3));
}

static void write_wind(Draft *draft)
{
    if (happens(draft, 0.3)) {
        add_gravity(draft);
        double vy = between(draft, -2, 8), vx = between(draft, -8, 8);
        add_some_mass(draft, 0.3, 3, 0, 0, vx, vy);
    } else {
        write_plane(draft);
    }
    add_wind(draft);
}

/* Fast springs and strong dampers beside slow ones, in the plane, on anchors that may move. */
static void write_stiff(Draft *draft)
{
    int count = g_rand_int_range(draft->dice, 1, 3);
    if (happens(draft, 0.7)) add_gravity(draft);
    for (int i = 0; i < 3; i++) {
        double y = between(draft, 2, 4);
        add_anchor(draft, between(draft, -2, 2), y);
    }
    for (int i = 0; i < count; i++) {
        double vy = between(draft, -2, 2), vx = between(draft, -2, 2), y = between(draft, -1, 1);
        add_some_mass(draft, 0.3, 2, 1.5 * i, y, vx, vy);
    }
    for (int i = 0; i < count; i++) {
        const char *to = i == 0 ? anchors[0] : masses[i - 1];
        add_spring(draft, masses[i], to, about(draft, 1e3, 2e5), 0.3);
        add_damper(draft, masses[i], to, about(draft, 1, 1000), 0.3);
    }
    add_spring(draft, "m0", "A1", about(draft, 5, 50), 0.3);
    add_damper(draft, "m0", "A2", about(draft, 1, 500), 0.3);
    if (happens(draft, 0.5)) {
        double rest = between(draft, 0.3, 1);
        add_tense_spring(draft, "m0", "A2", about(draft, 1e3, 2e5), 0.3, rest);
    }
    for (int i = 0; i < 3; i++) {
        if (!happens(draft, 0.5)) continue;
        double frequency = about(draft, 0.5, 8), amplitude = about(draft, 0.02, 0.3);
        add_support_motion(draft, anchors[i], between(draft, -3, 3), amplitude, frequency);
    }
    draft->scene->duration = between(draft, 1, 3);
}

/* With contact ----------------------------------------------------------------------------------------------------- */

static void write_thrown(Draft *draft, double restitution, double friction)
{
    add_gravity(draft);
    add_floor(draft, "F", 0, 0, happens(draft, 0.5) ? 0 : between(draft, -0.4, 0.4), 60, restitution, friction);
    double vy = between(draft, -2, 4), vx = between(draft, -4, 4), y = between(draft, 0.2, 3);
    add_some_mass(draft, 0.3, 3, 0, y, vx, vy);
}

static void write_landing(Draft *draft)
{
    write_thrown(draft, 0, some_friction(draft));
}

static void write_bouncing(Draft *draft)
{
    double friction = some_friction(draft);
    write_thrown(draft, between(draft, 0.2, 0.95), friction);
}

static void write_elastic(Draft *draft)
{
    write_thrown(draft, 1, happens(draft, 0.7) ? 0 : between(draft, 0.05, 0.5));
}

static void write_incline(Draft *draft)
{
    double angle = between(draft, -0.7, 0.7), from = between(draft, -1, 1), speed = between(draft, -4, 4);
    add_gravity(draft);
    add_floor(draft, "F", 0, 0, angle, 60, 0, some_friction(draft));
    add_mass(draft, about(draft, 0.3, 3), from * cos(angle), from * sin(angle), speed * cos(angle), speed * sin(angle));
    if (happens(draft, 0.3)) return;
    add_anchor(draft, 3 * cos(angle), 3 * sin(angle));
    add_spring(draft, "m0", "A0", about(draft, 5, 300), 0.3);
}

static void write_wedge(Draft *draft)
{
    double restitution = happens(draft, 0.35) ? 1 : some_restitution(draft), friction = some_friction(draft);
    add_gravity(draft);
    add_floor(draft, "F0", -2, 2, between(draft, -1.1, -0.3), 8, restitution, friction);
    add_floor(draft, "F1", 2, 2, between(draft, 0.3, 1.1), 8, restitution, friction);
    double vx = between(draft, -1, 1), y = between(draft, 3, 5), x = between(draft, -1, 1);
    add_some_mass(draft, 0.3, 3, x, y, vx, 0);
}

static void write_springs_over_floor(Draft *draft)
{
    add_gravity(draft);
    double friction = some_friction(draft), restitution = some_restitution(draft);
    add_floor(draft, "F", 0, 0, happens(draft, 0.6) ? 0 : between(draft, -0.3, 0.3), 60, restitution, friction);
    double x = between(draft, -0.5, 0.5), height = between(draft, 0.7, 2);
    add_some_mass(draft, 0.3, 2, 0, height, happens(draft, 0.5) ? 0 : between(draft, -2, 2), 0);
    if (happens(draft, 0.5)) {
        add_some_mass(draft, 0.3, 2, x, height + 1, 0, between(draft, -2, 0));
        add_spring(draft, "m0", "m1", about(draft, 20, 1000), 0.3);
        if (happens(draft, 0.5)) add_damper(draft, "m0", "m1", about(draft, 0.1, 5), 0.3);
    } else {
        add_anchor(draft, happens(draft, 0.5) ? 0 : x, height + 2);
        double rest = between(draft, 1.5, 4);
        add_tense_spring(draft, "m0", "A0", about(draft, 5, 200), 0.3, rest);
    }
}

static void write_rods_onto_floor(Draft *draft)
{
    int count = g_rand_int_range(draft->dice, 2, 4);
    add_gravity(draft);
    double friction = some_friction(draft), restitution = some_restitution(draft);
    add_floor(draft, "F", 0, 0, happens(draft, 0.6) ? 0 : between(draft, -0.3, 0.3), 60, restitution, friction);
    for (int i = 0; i < count; i++) {
        double vx = between(draft, -1, 1), y = between(draft, 0.8, 1.6);
        add_some_mass(draft, 0.3, 2, i, y, vx, 0);
    }
    for (int i = 1; i < count; i++)
        add_rod(draft, masses[i - 1], masses[i]);
    is_as_fast_as(draft, 30);
}

static void write_pendulum_onto_floor(Draft *draft)
{
    add_gravity(draft);
    write_chain(draft, g_rand_int_range(draft->dice, 1, 3), 0.7, 1.7);
    double friction = some_friction(draft), restitution = some_restitution(draft);
    add_floor(draft, "F", 0, between(draft, -1.2, -0.2), 0, 60, restitution, friction);
}

static void write_moving_floor(Draft *draft)
{
    double friction = some_friction(draft);
    write_thrown(draft, some_restitution(draft), friction);
    double frequency = about(draft, 1, 15), amplitude = about(draft, 0.02, 0.2);
    add_support_motion(draft, "F", happens(draft, 0.6) ? G_PI / 2 : between(draft, -3, 3), amplitude, frequency);
}

/* What sticks and slips: a block on a floor that moves along, held by a spring. */
static void write_stick_slip(Draft *draft)
{
    add_gravity(draft);
    add_floor(draft, "F", 0, 0, 0, 60, 0, between(draft, 0.1, 0.7));
    add_some_mass(draft, 0.3, 2, 0, 0, between(draft, -2, 2), 0);
    double y = happens(draft, 0.5) ? 0 : 0.3;
    add_anchor(draft, between(draft, 1, 3), y);
    add_spring(draft, "m0", "A0", about(draft, 10, 200), 0.3);
    double frequency = about(draft, 1, 10);
    add_support_motion(draft, "F", 0, about(draft, 0.05, 0.6), frequency);
}

static void write_wind_over_floor(Draft *draft)
{
    double friction = some_friction(draft);
    write_thrown(draft, some_restitution(draft), friction);
    add_wind(draft);
}

static void write_motor_on_floor(Draft *draft)
{
    add_gravity(draft);
    double friction = some_friction(draft);
    add_floor(draft, "F", 0, 0, 0, 100, some_restitution(draft), friction);
    add_some_mass(draft, 0.5, 2, 0, happens(draft, 0.4) ? 0 : between(draft, 0.1, 1), 0, 0);
    add_motor(draft, "m0", happens(draft, 0.7) ? 0 : between(draft, -3, 3));
}

/* The kinds -------------------------------------------------------------------------------------------------------- */

const char *const random_scene_kinds[] = {
    "straight springs", "passing",     "plane springs",  "pendula",     "linkages",        "driven supports",
    "motors",           "wind",        "stiff",          "landing",     "bouncing",        "elastic bouncing",
    "incline",          "wedge",       "springs, floor", "rods, floor", "pendulum, floor", "moving floor",
    "stick and slip",   "wind, floor", "motor, floor",   NULL,
};

static void (*const writers[])(Draft *) = {
    write_straight,
    write_passing,
    write_plane,
    write_pendulum,
    write_linkage,
    write_driven,
    write_motors,
    write_wind,
    write_stiff,
    write_landing,
    write_bouncing,
    write_elastic,
    write_incline,
    write_wedge,
    write_springs_over_floor,
    write_rods_onto_floor,
    write_pendulum_onto_floor,
    write_moving_floor,
    write_stick_slip,
    write_wind_over_floor,
    write_motor_on_floor,
};

G_STATIC_ASSERT(G_N_ELEMENTS(writers) + 1 == G_N_ELEMENTS(random_scene_kinds));

RandomScene *random_scene_new(guint kind, guint32 seed)
{
    RandomScene *scene = g_new0(RandomScene, 1);
    const guint32 seeds[] = {kind, seed};
    g_autoptr(GRand) dice = g_rand_new_with_seed_array(seeds, G_N_ELEMENTS(seeds));
    g_autoptr(GString) blocks = g_string_new(NULL);
    Draft draft = {dice, blocks, scene};
    scene->duration = between(&draft, 1.5, 6);
    scene->rate = 5;
    writers[kind](&draft);
    scene->text = g_strdup_printf("{\"tinker\": 1, \"run\": {\"duration\": %.17g}, \"blocks\": [\n%s]}\n",
                                  scene->duration, blocks->str);
    g_strdelimit(scene->text, "'", '"');
    return scene;
}

void random_scene_free(RandomScene *scene)
{
    if (scene == NULL) return;
    g_free(scene->text);
    g_free(scene);
}
