/* The rest state of a part of a scene, and the direction in which one leaves it. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/start-private.h"
#include "physics/compile/compile.h"
#include "physics/event/still-contacts.h"
#include "physics/linearise/linearise.h"
#include "physics/model/model.h"

/* The blocks that a model of the part needs, plates that its bodies may touch among them. (transfer full) */
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
            gboolean mine = physics->field != NULL || tinker_class_has_top(block_class);
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

static void refuse(TinkerScene *scene, TinkerBlockId body, const char *why, GError **error)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN, _("%s has no rest state: %s"),
                tinker_scene_block_name(scene, body), why);
}

static gboolean lands(const TinkerFrame *frame, const TinkerStillContacts *contacts)
{
    gboolean any = FALSE;
    g_autoptr(GArray) list = contacts != NULL ? tinker_still_contacts_list(contacts) : NULL;
    for (guint i = 0; list != NULL && i < list->len; i++) {
        const TinkerStillContact *contact = &g_array_index(list, TinkerStillContact, i);
        if (contact->plate == TINKER_NO_BLOCK) continue;
        const TinkerTop top = tinker_top_of(frame, contact->plate);
        any |= !tinker_top_touches(frame, &top, contact->block);
    }
    return any;
}

StartRest *start_rest_new(TinkerScene *scene, TinkerBlockId body, GError **error)
{
    g_autofree gboolean *include = blocks_of_part(scene, body);
    g_autoptr(TinkerModel) model = tinker_model_new_part(scene, include, error);
    if (model == NULL) return NULL;
    const int32_t bodies = tinker_model_sizes(model).bodies;
    g_autofree double *q = g_new0(double, MAX(tinker_model_sizes(model).coordinates, 1));
    tinker_model_start_places(model, q);
    g_autoptr(TinkerStillContacts) contacts = tinker_still_contacts_new(model); /* before it is held */
    if (contacts != NULL) tinker_still_contacts_leave_out_friction(contacts);
    if (tinker_model_hold(model) != TINKER_OK) {
        refuse(scene, body, _("its supports have no place at the start"), error);
        return NULL;
    }
    TinkerEquilibrium found;
    if (!tinker_equilibrium_find(model, contacts, q, &found, error)) return NULL;
    if (!found.found) {
        refuse(scene, body, found.why, error);
        return NULL;
    }
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    if (frame == NULL) return NULL;
    double origin[2];
    tinker_model_origin(model, origin);
    StartRest *rest = g_new0(StartRest, 1);
    rest->lands = lands(frame, contacts);
    rest->bodies = g_array_new(FALSE, FALSE, sizeof(StartPlace));
    for (int32_t i = 0; i < bodies; i++) {
        double radius;
        const int32_t turn = tinker_model_body_turn(model, i, &radius);
        StartPlace place = START_PLACE_AS_IT_IS(tinker_model_body_block(model, i));
        for (int k = 0; k < 2; k++) {
            place.place[k] = q[2 * i + k] + origin[k];
            place.velocity[k] = 0;
        }
        if (turn >= 0) {
            place.orientation = q[turn] / radius;
            place.rate = 0;
        }
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
    TinkerTop top = tinker_top_nearest(frame, body);
    if (!tinker_top_touches(frame, &top, body)) return;
    double sign = direction[0] * top.along[0] + direction[1] * top.along[1] < 0 ? -1 : 1;
    direction[0] = sign * top.along[0];
    direction[1] = sign * top.along[1];
}
