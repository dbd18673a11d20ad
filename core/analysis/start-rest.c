/* The rest state of a part of a scene, and the direction in which one leaves it.
 *
 * The search for equilibrium knows no contacts. A single body that touches a plate is therefore brought to rest along its
 * top: the place where the force along it vanishes, by the secant method, and where the force presses it on. */
#include <math.h>

#include "analysis/start-private.h"
#include "physics/linearise.h"

#define MOST_ROUNDS 60
/* Of the largest force. */
#define BALANCED 1e-12

/* The blocks that a model of the part needs. (transfer full) */
static gboolean *blocks_of_part(TinkerScene *scene, TinkerBlockId body)
{
    gboolean *include = start_group_new(scene, body, START_TIED_BY_ANYTHING, TINKER_NO_BLOCK, NULL);
    g_autofree gboolean *bodies = g_memdup2(include, (gsize)MAX(tinker_scene_id_limit(scene), 1) * sizeof(gboolean));
    for (int pass = 0; pass < 2; pass++) { /* motions last, when it is known which supports are there */
        for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
            TinkerBlockId block = tinker_scene_block_at(scene, i);
            const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
            const TinkerPhysics *physics = block_class == NULL ? NULL : block_class->physics;
            if (physics == NULL || (physics->motion != NULL) != (pass == 1)) continue;
            const gboolean *reached = pass == 1 ? include : bodies;
            gboolean mine = physics->field != NULL;
            int32_t ends = tinker_scene_end_count(scene, block);
            for (int32_t e = 0; e < ends; e++) {
                TinkerSceneEnd end = tinker_scene_end(scene, block, e);
                mine |= end.block != TINKER_NO_BLOCK && reached[end.block];
            }
            include[block] |= mine;
            for (int32_t e = 0; mine && e < ends; e++)
                if (tinker_scene_end(scene, block, e).block != TINKER_NO_BLOCK)
                    include[tinker_scene_end(scene, block, e).block] = TRUE;
        }
    }
    return include;
}

static gboolean refuse(TinkerScene *scene, TinkerBlockId body, const char *why, GError **error)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN, "%s has no rest state: %s",
                tinker_scene_block_name(scene, body), why);
    return FALSE;
}

/* The force on a single body at q. FALSE where it cannot be worked out. */
static gboolean force_at(TinkerModel *model, const double *q, double force[2], double *scale, GError **error)
{
    g_autoptr(TinkerLinearisation) linear = tinker_linearise(model, q, error);
    if (linear == NULL) return FALSE;
    force[0] = linear->force[0];
    force[1] = linear->force[1];
    *scale = fmax(linear->force_scale, hypot(force[0], force[1]));
    return TRUE;
}

static gboolean settle_along(TinkerModel *model, const StartTop *top, double foot, double *q, const char **why,
                             GError **error)
{
    const double from[2] = {q[0], q[1]};
    double force[2], scale, s = 0, before = 0, f_before = 0;
    *why = "no place along the top balances it";
    for (int round = 0; round < MOST_ROUNDS; round++) {
        q[0] = from[0] + s * top->along[0];
        q[1] = from[1] + s * top->along[1];
        if (!force_at(model, q, force, &scale, error)) return FALSE;
        double f = force[0] * top->along[0] + force[1] * top->along[1];
        if (fabs(f) <= BALANCED * scale) {
            *why = NULL;
            break;
        }
        double next = round == 0 ? s + 1e-3 * fmax(top->half_width, 1e-3) : s - f * (s - before) / (f - f_before);
        if (!isfinite(next) || next == s || fabs(foot + next) > 4 * top->half_width) break;
        before = s;
        f_before = f;
        s = next;
    }
    if (*why != NULL) return TRUE;
    if (fabs(foot + s) > top->half_width) *why = "it would lie beyond the end of the top";
    if (force[0] * top->normal[0] + force[1] * top->normal[1] > BALANCED * scale) *why = "it is pulled off the top";
    return TRUE;
}

/* Brings the places to rest. */
static gboolean settle(TinkerModel *model, TinkerScene *scene, TinkerBlockId body, double *q, GError **error)
{
    const int32_t bodies = tinker_model_sizes(model).bodies;
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    if (frame == NULL) return FALSE;
    for (int32_t i = 0; i < bodies; i++) {
        TinkerBlockId block = tinker_model_body_block(model, i);
        StartTop top = start_nearest_top(frame, block);
        if (!start_touches(frame, &top, block)) continue;
        if (bodies > 1 || tinker_model_sizes(model).constraint_rows > 0)
            return refuse(scene, body,
                          "one of several bodies that hang together rests on a plate, where it is not looked for",
                          error);
        const char *why;
        double along, gap;
        start_foot(frame, &top, block, &along, &gap);
        if (!settle_along(model, &top, along, q, &why, error)) return FALSE;
        return why == NULL || refuse(scene, body, why, error);
    }
    TinkerEquilibrium found;
    if (!tinker_equilibrium_find(model, q, &found, error)) return FALSE;
    return found.found || refuse(scene, body, found.why, error);
}

StartRest *start_rest_new(TinkerScene *scene, TinkerBlockId body, GError **error)
{
    g_autofree gboolean *include = blocks_of_part(scene, body);
    g_autoptr(TinkerModel) model = tinker_model_new_part(scene, include, error);
    if (model == NULL) return NULL;
    const int32_t bodies = tinker_model_sizes(model).bodies;
    g_autofree double *q = g_new0(double, 2 * (gsize)MAX(bodies, 1));
    tinker_model_start_places(model, q);
    if (tinker_model_hold(model) != TINKER_OK) {
        refuse(scene, body, "its supports have no place at the start", error);
        return NULL;
    }
    if (!settle(model, scene, body, q, error)) return NULL;
    double origin[2];
    tinker_model_origin(model, origin);
    StartRest *rest = g_new0(StartRest, 1);
    rest->bodies = g_array_new(FALSE, FALSE, sizeof(StartPlace));
    for (int32_t i = 0; i < bodies; i++) {
        StartPlace place = {
            tinker_model_body_block(model, i), {q[2 * i] + origin[0], q[2 * i + 1] + origin[1]}, NAN, {0, 0}};
        if (place.body == body) rest->own = (guint)i;
        g_array_append_val(rest->bodies, place);
    }
    return rest;
}

void start_rest_free(StartRest *rest)
{
    if (rest == NULL) return;
    g_array_unref(rest->bodies);
    g_free(rest);
}

/* Where an end is at rest: on a body of the part, or where the frame has it. */
static void place_at_rest(const TinkerFrame *frame, const StartRest *rest, TinkerSceneEnd end, double place[2])
{
    tinker_frame_end(frame, end, place);
    for (guint i = 0; i < rest->bodies->len; i++) {
        const StartPlace *body = &g_array_index(rest->bodies, StartPlace, i);
        if (body->body != end.block) continue;
        place[0] = body->place[0];
        place[1] = body->place[1];
    }
}

void start_direction_at(TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body, const StartRest *rest,
                        double direction[2])
{
    const StartPlace *own = &g_array_index(rest->bodies, StartPlace, rest->own);
    g_autoptr(GArray) links = start_links_new(scene, body);
    direction[0] = 0;
    direction[1] = -1;
    for (guint i = 0; i < links->len; i++) {
        const StartLink *link = &g_array_index(links, StartLink, i);
        if (!start_has_rest_length(tinker_scene_block_class(scene, link->connector))) continue;
        double far[2];
        place_at_rest(frame, rest, link->far, far);
        double dx = own->place[0] - far[0], dy = own->place[1] - far[1], length = hypot(dx, dy);
        if (!(length > 0)) continue;
        direction[0] = dx / length;
        direction[1] = dy / length;
        break;
    }
    StartTop top = start_nearest_top(frame, body);
    if (!start_touches(frame, &top, body)) return;
    double sign = direction[0] * top.along[0] + direction[1] * top.along[1] < 0 ? -1 : 1;
    direction[0] = sign * top.along[0];
    direction[1] = sign * top.along[1];
}
