/* Start velocities that constraints do not allow.
 *
 * The model projects them; the difference is told once for every set of bodies that constraints tie together, by the
 * body whose velocity changes most and the connector along which it moves fastest. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/advice-private.h"
#include "analysis/start/start-private.h"
#include "physics/linearise/linearise.h"
#include "physics/model/model.h"

static const TinkerDimension speed_dimension = TINKER_DIMENSION_VELOCITY;

/* Of the fastest speed: less than this is what rounding leaves of what is held. As a velocity it would be a misfit
 * again. */
#define ROUNDING 1e-12

/* A body whose velocity does not fit. */
typedef struct {
    TinkerBlockId block;
    int32_t set;
    double given[2], allowed[2], change; /* m/s; that of what turns at its radius of gyration is part of the change */
    double rate;                         /* rad/s: allowed; NAN where it does not turn */
    gboolean said;                       /* by the user; else constraints are free to say how fast it starts */
} Misfit;

/* What is said of the body's turning; its speed at the radius of gyration, m/s. */
static double look_at_rate(const TinkerFrame *frame, const TinkerModel *model, int32_t body, const double *allowed,
                           Misfit *misfit)
{
    double radius;
    const int32_t turn = tinker_model_body_turn(model, body, &radius);
    misfit->rate = NAN;
    if (turn < 0) return 0;
    const double given = tinker_frame_meaning(frame, misfit->block, TINKER_MEANING_ANGULAR_VELOCITY, 0, 0);
    misfit->rate = allowed[turn] / radius;
    misfit->change = hypot(misfit->change, radius * (misfit->rate - given));
    return radius * fmax(fabs(given), fabs(misfit->rate));
}

static gboolean is_said(TinkerScene *scene, TinkerBlockId block)
{
    static const int32_t velocities[] = {TINKER_MEANING_VELOCITY, TINKER_MEANING_ANGULAR_VELOCITY};
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    for (gsize i = 0; i < G_N_ELEMENTS(velocities); i++) {
        const int32_t property = block_class->meanings[velocities[i]];
        if (property >= 0 && tinker_scene_property_given(scene, block, property)) return TRUE;
    }
    return FALSE;
}

static GArray *find_misfits(const TinkerFrame *frame, const TinkerModel *model, const int32_t *sets)
{
    GArray *misfits = g_array_new(FALSE, FALSE, sizeof(Misfit));
    const int32_t bodies = tinker_model_sizes(model).bodies;
    g_autofree double *allowed = g_new0(double, MAX(tinker_model_sizes(model).coordinates, 1));
    double fastest = 0;
    tinker_model_start_velocities(model, allowed);
    for (int pass = 0; pass < 2; pass++)
        for (int32_t i = 0; i < bodies; i++) {
            Misfit misfit = {.block = tinker_model_body_block(model, i),
                             .allowed = {allowed[2 * i], allowed[2 * i + 1]}};
            misfit.set = sets[misfit.block];
            misfit.said = is_said(tinker_frame_scene(frame), misfit.block);
            start_velocity_of(frame, misfit.block, misfit.given);
            fastest = fmax(fastest,
                           fmax(hypot(misfit.given[0], misfit.given[1]), hypot(misfit.allowed[0], misfit.allowed[1])));
            misfit.change = hypot(misfit.allowed[0] - misfit.given[0], misfit.allowed[1] - misfit.given[1]);
            fastest = fmax(fastest, look_at_rate(frame, model, i, allowed, &misfit));
            for (int axis = 0; axis < 2; axis++)
                if (fabs(misfit.allowed[axis]) <= ROUNDING * fastest) misfit.allowed[axis] = 0;
            if (pass == 1 && misfit.change > START_FITS * fastest) g_array_append_val(misfits, misfit);
        }
    return misfits;
}

/* Within a set those come first of which the user said something. */
static int by_set_and_change(gconstpointer a, gconstpointer b)
{
    const Misfit *first = a, *second = b;
    if (first->set != second->set) return first->set < second->set ? -1 : 1;
    if (first->said != second->said) return first->said ? -1 : 1;
    return (first->change < second->change) - (first->change > second->change);
}

/* The connector that keeps its length along which the body's given velocity is greatest; the component away from the
 * far end, and the one across it that is allowed. */
static TinkerBlockId find_connector(const TinkerFrame *frame, const Misfit *misfit, double *along, double *left)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    g_autoptr(GArray) links = start_links_new(scene, misfit->block);
    TinkerBlockId connector = TINKER_NO_BLOCK;
    *along = *left = 0;
    for (guint i = 0; i < links->len; i++) {
        const StartLink *link = &g_array_index(links, StartLink, i);
        if (!start_keeps_length(tinker_scene_block_class(scene, link->connector))) continue;
        double own[2], far[2], length = start_distance(frame, link->own, link->far);
        tinker_frame_end(frame, link->own, own);
        tinker_frame_end(frame, link->far, far);
        double nx = (own[0] - far[0]) / length, ny = (own[1] - far[1]) / length;
        double component = nx * misfit->given[0] + ny * misfit->given[1];
        if (!(length > 0) || (connector != TINKER_NO_BLOCK && fabs(component) <= fabs(*along))) continue;
        connector = link->connector;
        *along = component;
        *left = nx * misfit->allowed[0] + ny * misfit->allowed[1];
    }
    return connector;
}

static char *words_of(const TinkerFrame *frame, const Misfit *misfit, guint others, gboolean *across,
                      TinkerBlockId *connector)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    double along, left;
    *connector = find_connector(frame, misfit, &along, &left);
    const double little = START_FITS * hypot(misfit->given[0], misfit->given[1]);
    /* what is given across the connector alone, as on a straight bar, is not its length's fault */
    *across = *connector != TINKER_NO_BLOCK && fabs(along) > little && fabs(left) <= little;
    const char *name = tinker_scene_block_name(scene, misfit->block);
    g_autofree char *x = start_quantity_text(scene, misfit->allowed[0], speed_dimension);
    g_autofree char *y = start_quantity_text(scene, misfit->allowed[1], speed_dimension);
    if (!*across)
        return others == 0 ? g_strdup_printf(
                                 _("%s: its start velocity does not fit what ties it (it would start with %s to the "
                                   "right and %s up)"),
                                 name, x, y)
                           : g_strdup_printf(
                                 _("%s: its start velocity does not fit what ties it (it would start with %s to the "
                                   "right and %s up, and %u more with it)"),
                                 name, x, y, others);
    const char *tie = tinker_scene_block_name(scene, *connector);
    g_autofree char *speed = start_quantity_text(scene, fabs(along), speed_dimension);
    return others == 0 ? g_strdup_printf(
                             _("%s: it starts with %s along %s, whose length does not change (it would start with %s "
                               "to the right and %s up)"),
                             name, speed, tie, x, y)
                       : g_strdup_printf(
                             _("%s: it starts with %s along %s, whose length does not change (it would start with %s "
                               "to the right and %s up, and %u more with it)"),
                             name, speed, tie, x, y, others);
}

static void tell(GPtrArray *all, const TinkerFrame *frame, const Misfit *misfits, guint count)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    gboolean across;
    TinkerBlockId connector;
    char *message = words_of(frame, misfits, count - 1, &across, &connector);
    TinkerAdvice *advice = advice_add(all, TINKER_ADVICE_VELOCITY, FALSE, message);
    g_autofree char *speed =
        start_quantity_text(scene, hypot(misfits[0].allowed[0], misfits[0].allowed[1]), speed_dimension);
    advice->repair = count > 1 ? g_strdup(_("Set the velocities that fit"))
                     : across  ? g_strdup_printf(_("Set the velocity to %s across"), speed)
                               : g_strdup_printf(_("Set the velocity to %s"), speed);
    for (guint i = 0; i < count; i++) {
        advice_add_block(advice, misfits[i].block);
        advice_add_vector(advice, misfits[i].block, misfits[i].allowed[0], misfits[i].allowed[1], misfits[i].rate);
    }
    if (connector != TINKER_NO_BLOCK) advice_add_block(advice, connector);
}

void advice_on_velocities(GPtrArray *all, const TinkerFrame *frame, const TinkerModel *model)
{
    if (tinker_model_sizes(model).constraint_rows == 0) return;
    g_autofree int32_t *sets = start_sets_new(tinker_frame_scene(frame), START_TIED_BY_CONSTRAINTS, TINKER_NO_BLOCK);
    g_autoptr(GArray) misfits = find_misfits(frame, model, sets);
    g_array_sort(misfits, by_set_and_change);
    const Misfit *all_misfits = (const Misfit *)(const void *)misfits->data;
    for (guint first = 0, end; first < misfits->len; first = end) {
        for (end = first; end < misfits->len && all_misfits[end].set == all_misfits[first].set;)
            end++;
        if (all_misfits[first].said) tell(all, frame, all_misfits + first, end - first);
    }
}
