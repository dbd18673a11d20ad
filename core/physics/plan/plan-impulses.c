/* What contacts as impulses do not know of a scene, refused with what to change before a run begins. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan-private.h"

/* FALSE where a constraint holds in one direction only. */
static gboolean check_no_ropes(const TinkerModel *model, GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    if (all->unilateral == NULL) return TRUE;
    int32_t row = 0;
    while (!all->unilateral[row])
        row++;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                _("%s holds in one direction only, which contacts as impulses do not know (treat contacts as events: "
                  "leave \"contacts\" out of the scene's run)"),
                tinker_scene_block_name(model->scene, all->blocks[row]));
    return FALSE;
}

/* FALSE where a top turns that bodies could meet. */
static gboolean check_tops_stay(const TinkerContacts *contacts, GError **error)
{
    for (int32_t i = 0; i < contacts->plate_count; i++) {
        if (contacts->plates[i].turned == NULL) continue;
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
            _("%s turns with what lies on it, which contacts as impulses do not know (treat contacts as events: "
              "leave \"contacts\" out of the scene's run; or set \"solid\" of the support to false)"),
            tinker_scene_block_name(contacts->model->scene, contacts->plates[i].block));
        return FALSE;
    }
    return TRUE;
}

static gboolean check_law(const TinkerModel *model, GError **error)
{
    const char *law = tinker_scene_head(model->scene)->run.impact_law;
    if (g_strcmp0(law, "newton") == 0) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                _("contacts as impulses know Newton's law of impact alone, and impact_law of the run is \"%s\" (treat "
                  "contacts as events: leave \"contacts\" out of the scene's run; or leave \"impact_law\" out)"),
                law);
    return FALSE;
}

/* The first body with a shape among those that constraints tie to a body; -1: none is. */
static int32_t tied_shape(const TinkerContacts *contacts, int32_t body)
{
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        if (contacts->tied[i] == contacts->tied[body] && tinker_contacts_has_outline(contacts, i)) return i;
    return -1;
}

/* FALSE where constraints tie a mass that lands on tops, without meeting anything else, to a body with a shape. */
static gboolean check_masses_meet(const TinkerContacts *contacts, GError **error)
{
    const TinkerModel *model = contacts->model;
    for (int32_t i = 0; contacts->plate_count > 0 && i < model->bodies; i++) {
        if (isnan(contacts->half_height[i]) || tinker_contacts_has_outline(contacts, i)) continue;
        const int32_t other = tied_shape(contacts, i);
        if (other < 0) continue;
        const char *name = tinker_scene_block_name(model->scene, model->body_blocks[i]);
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    _("%s lands on supports alone, and constraints tie it to %s, which meets others with its shape: "
                      "contacts as impulses do not know both together (set \"collides\" of %s to true; or treat "
                      "contacts as events: leave \"contacts\" out of the scene's run)"),
                    name, tinker_scene_block_name(model->scene, model->body_blocks[other]), name);
        return FALSE;
    }
    return TRUE;
}

/* FALSE where something resists turning. */
static gboolean check_turns_freely(const TinkerContacts *contacts, GError **error)
{
    if (contacts->pin_count > 0) {
        const int32_t first = tinker_contacts_first_pin(contacts);
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    _("%s has friction, which contacts as impulses do not know (treat contacts as events: leave "
                      "\"contacts\" out of the scene's run; or leave its \"friction\" out)"),
                    tinker_scene_block_name(contacts->model->scene, contacts->plates[first].block));
        return FALSE;
    }
    if (contacts->resistance_count == 0) return TRUE;
    const TinkerPlate *plate = &contacts->plates[contacts->plate_count + contacts->gap_count];
    const int32_t *point = plate->pair->point;
    const gboolean second = !(contacts->surfaces[point[0]].rolling > 0);
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
        _("%s has a rolling resistance, which contacts as impulses do not know (treat contacts as events: leave "
          "\"contacts\" out of the scene's run; or leave its \"rolling_resistance\" out)"),
        tinker_scene_block_name(contacts->model->scene, tinker_model_block_of(contacts->model, point[second ? 1 : 0])));
    return FALSE;
}

/* FALSE where a body has a notch: one normal of a pair says nothing of it. */
static gboolean check_shapes_convex(const TinkerContacts *contacts, GError **error)
{
    const TinkerModel *model = contacts->model;
    for (int32_t i = 0; i < model->bodies; i++) {
        if (contacts->outlines[i].triangles == NULL) continue;
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    _("%s has corners that turn inwards, which contacts as impulses do not know (treat contacts as "
                      "events: leave \"contacts\" out of the scene's run; or set \"solid\" of it to false)"),
                    tinker_scene_block_name(model->scene, model->body_blocks[i]));
        return FALSE;
    }
    return TRUE;
}

gboolean tinker_plan_check_impulses(const TinkerIsland *island, GError **error)
{
    const TinkerModel *model = island->model;
    if (!check_law(model, error) || !check_no_ropes(model, error)) return FALSE;
    if (!tinker_contacts_can_meet(model->contacts)) return TRUE;
    return check_tops_stay(model->contacts, error) && check_masses_meet(model->contacts, error) &&
           check_shapes_convex(model->contacts, error) && check_turns_freely(model->contacts, error);
}
