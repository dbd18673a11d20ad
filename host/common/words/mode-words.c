/* What is said of modes: which way bodies go, how far beside one another, and why there is none. */
#include "common/words/mode-words.h"

#include <glib/gi18n.h>
#include <math.h>

#define MAINLY      0.95 /* of the squares of a shape: then it goes one way */
#define A_PART      0.1  /* of the largest component: smaller ones stand still to the eye */
#define NOTHING     5e-7 /* of the largest component: smaller ones are rounding */
#define MOST_BODIES 3    /* whose ratio is told */
#define MOST_HELD   6    /* contacts that are named */

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
    g_autofree char *order = number > 0 ? g_strdup_printf(_("Mode %u"), number) : g_strdup(_("Mode"));
    g_autofree char *name = motion != NULL ? g_strdup_printf("%s, %s", order, motion) : g_strdup(order);
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

/* The ratio of a shape ----------------------------------------------------------------------------------------------
 */

static double component_of(const TinkerModeAnalysis *analysis, const TinkerMode *mode, int32_t body, int way)
{
    double radius = 1;
    if (way == TURNING) tinker_model_body_turn(analysis->model, body, &radius);
    return mode->real[coordinate_of(analysis, body, way)] / radius;
}

/* Whether a body is told of: in a small scene what stands still, too. */
static gboolean is_told(const TinkerModeAnalysis *analysis, const TinkerMode *mode, int32_t body, int way)
{
    const int32_t coordinate = coordinate_of(analysis, body, way);
    if (coordinate < 0) return FALSE;
    return tinker_model_sizes(analysis->model).bodies <= MOST_BODIES || fabs(mode->real[coordinate]) >= NOTHING;
}

char *tinker_mode_ratio(const TinkerModeAnalysis *analysis, const TinkerMode *mode, TinkerScene *scene)
{
    const TinkerModelSizes sizes = tinker_model_sizes(analysis->model);
    const int way = tinker_mode_is_standing(mode, sizes.coordinates) ? main_way(analysis, mode) : -1;
    g_autoptr(GString) names = g_string_new(NULL), numbers = g_string_new(NULL);
    double unit = 0;
    int count = 0;
    for (int32_t body = 0; way >= 0 && body < sizes.bodies; body++) {
        if (!is_told(analysis, mode, body, way)) continue;
        const double raw = component_of(analysis, mode, body, way);
        const double component = fabs(mode->real[coordinate_of(analysis, body, way)]) < NOTHING ? 0 : raw;
        if (unit == 0) unit = component; /* the first that moves counts 1 */
        const double share = unit != 0 ? component / unit : 0;
        const char *between = count++ > 0 ? " : " : "";
        g_string_append_printf(names, "%s%s", between,
                               tinker_scene_block_name(scene, tinker_model_body_block(analysis->model, body)));
        g_string_append_printf(numbers, "%s%s%.3g", between, share < 0 ? "−" : "", fabs(share));
    }
    if (count < 2 || count > MOST_BODIES) return NULL;
    return g_strdup_printf("%s = %s", names->str, numbers->str);
}

/* What does not count -------------------------------------------------------------------------------------------------
 */

GPtrArray *tinker_modes_left_out(const TinkerModeAnalysis *analysis, TinkerScene *scene)
{
    GPtrArray *sentences = g_ptr_array_new_with_free_func(g_free);
    for (guint i = 0; i < analysis->left_out->len; i++) {
        const TinkerLeftOut *out = &g_array_index(analysis->left_out, TinkerLeftOut, i);
        const char *name = tinker_scene_block_name(scene, out->block);
        if (out->kind == TINKER_LEFT_OUT_MOTION)
            g_ptr_array_add(sentences,
                            g_strdup_printf(_("%s is held still where it is at t = 0: its motion is left out"), name));
        else if (out->kind == TINKER_LEFT_OUT_VARIATION)
            g_ptr_array_add(sentences,
                            g_strdup_printf(_("%s varies in time: its stiffness and damping count as at t = 0"), name));
        else
            g_ptr_array_add(sentences, g_strdup_printf(_("%s touches %s, which is left out: it rests and moves through "
                                                         "it (a slot holds what slides, a rack what rolls)"),
                                                       name, tinker_scene_block_name(scene, out->other)));
    }
    return sentences;
}

/* Why there is none -------------------------------------------------------------------------------------------------
 */

/* What lies against something, one in a line: by friction, or between what touches. */
static GPtrArray *held_by_contact(const TinkerModeAnalysis *analysis, TinkerScene *scene)
{
    GPtrArray *lines = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GArray) contacts =
        analysis->contacts != NULL ? tinker_still_contacts_list(analysis->contacts) : g_array_new(FALSE, FALSE, 1);
    for (guint i = 0; i < contacts->len; i++) {
        const TinkerStillContact *contact = &g_array_index(contacts, TinkerStillContact, i);
        const char *name = tinker_scene_block_name(scene, contact->block);
        if (contact->kind == TINKER_STILL_STICKS)
            g_ptr_array_add(lines, g_strdup_printf(_("%s: held on %s by friction"), name,
                                                   tinker_scene_block_name(scene, contact->plate)));
        else if (contact->kind == TINKER_STILL_SLIDES)
            g_ptr_array_add(
                lines, g_strdup_printf(_("%s: stays on %s"), name, tinker_scene_block_name(scene, contact->plate)));
        else if (contact->kind == TINKER_STILL_TAUT)
            g_ptr_array_add(lines, g_strdup_printf(_("%s: stays taut"), name));
    }
    return lines;
}

char *tinker_modes_none(const TinkerModeAnalysis *analysis, TinkerScene *scene)
{
    const TinkerModelSizes sizes = tinker_model_sizes(analysis->model);
    if (sizes.bodies == 0) return g_strdup(_("Nothing in this scene can move."));
    if (sizes.degrees_of_freedom <= 0)
        return g_strdup(_("Nothing in this scene swings: its joints leave it no degree of freedom."));
    GString *text = g_string_new(NULL);
    const char *where = analysis->about_rest ? _("where it comes to rest") : _("where it starts");
    g_string_printf(text,
                    ngettext("There is nothing to swing: what touches leaves none of the scene's %d degree of freedom "
                             "%s. How things slide and fall is no swing; the run shows it.",
                             "There is nothing to swing: what touches leaves none of the scene's %d degrees of freedom "
                             "%s. How things slide and fall is no swing; the run shows it.",
                             (gulong)sizes.degrees_of_freedom),
                    sizes.degrees_of_freedom, where);
    g_autoptr(GPtrArray) held = held_by_contact(analysis, scene);
    for (guint i = 0; i < MIN(held->len, MOST_HELD); i++)
        g_string_append_printf(text, "\n%s", (const char *)g_ptr_array_index(held, i));
    if (held->len > MOST_HELD) g_string_append(text, "\n…");
    return g_string_free(text, FALSE);
}
