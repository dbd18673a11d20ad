/* What a plan says of bodies: their freedoms, and whether they meet one another. */
#include <glib/gi18n-lib.h>

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/plan/plan-words-private.h"
#include "scene/frame/small-wheels.h"

/* The first body that turns and may touch something; -1: none. */
static int32_t first_solid(const TinkerModel *model)
{
    for (int32_t i = 0; model->contacts != NULL && i < model->bodies; i++)
        if (tinker_model_turn_of(model, i) >= 0 && model->contacts->reach[i] > 0) return i;
    return -1;
}

static gboolean any_meet(const TinkerContacts *contacts)
{
    for (int32_t i = 0; contacts != NULL && i < contacts->pair_count; i++)
        if (contacts->pairs[i].point[1] < contacts->model->bodies) return TRUE;
    return FALSE;
}

/* How many bodies meet others; 0: none does. */
int32_t plan_count_meeting(const TinkerModel *model, const TinkerRunOptions *options)
{
    int32_t solid = 0;
    for (int32_t i = 0; model->contacts != NULL && i < model->bodies; i++)
        solid += tinker_contacts_has_outline(model->contacts, i);
    return (options->impulses ? solid > 1 : any_meet(model->contacts)) ? solid : 0;
}

/* A mass has a box that never turns: beside bodies that do, nothing shows what holds it. */
static void describe_masses(TinkerPlan *plan, const TinkerModel *model)
{
    int32_t first = 0;
    while (first < model->bodies && !(tinker_contacts_has_outline(model->contacts, first) &&
                                      tinker_model_turn_of(model, first) < 0 && model->contacts->reach[first] > 0))
        first++;
    if (first == model->bodies) return;
    plan_say(plan->left_out,
             _("turning of masses: bodies meet %s at the corners of its box, which never turns (a box or a disc does)"),
             tinker_scene_block_name(model->scene, model->body_blocks[first]));
}

/* Contact of bodies among themselves. */
static void describe_meeting(TinkerPlan *plan, const TinkerModel *model, const TinkerRunOptions *options)
{
    const int32_t solid = plan_count_meeting(model, options);
    char text[128];
    if (solid == 0) {
        if (model->bodies > 1) plan_say(plan->left_out, _("contact between bodies: they pass through each other"));
        return;
    }
    plan_say(plan->modelled,
             options->impulses ? _("contact among %s: impulses, once a step")
                               : _("contact among %s: impacts and changes of friction are events"),
             plan_counted(
                 text, g_dngettext(GETTEXT_PACKAGE, "%d body that meets others", "%d bodies that meet", (gulong)solid),
                 solid));
    if (model->turning > 0) describe_masses(plan, model);
    if (solid < model->bodies)
        plan_say(plan->left_out,
                 _("contact of other bodies with each other and with these: they pass through each other"));
}

/* Whether a solid body has an outline of more points than contact takes. */
static gboolean has_long_outline(const TinkerModel *model)
{
    for (guint i = 0; model->turning > 0 && i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics == NULL || physics->body == NULL || physics->body->shape != TINKER_SHAPE_OUTLINE) continue;
        for (int32_t row = 0; batch->point_list_count > 0 && row < batch->count; row++)
            if (batch->point_lists[row * batch->point_list_count].count > TINKER_MOST_CORNERS &&
                tinker_block_batch_meaning(batch, row, TINKER_MEANING_SOLID, 0, 0) != 0)
                return TRUE;
    }
    return FALSE;
}

/* What a rope goes over it does not turn, which its picture does not show. */
static void describe_wheels(TinkerPlan *plan, const TinkerModel *model)
{
    if (model->turning == 0) return;
    g_autoptr(GArray) wheels = tinker_small_wheels_of(model->scene);
    if (wheels->len == 0) return;
    const TinkerSmallWheel *wheel = &g_array_index(wheels, TinkerSmallWheel, 0);
    plan_say(plan->left_out, _("turning of wheels by ropes: %s slides over %s (cords wound on it turn it)"),
             tinker_scene_block_name(model->scene, wheel->over), tinker_scene_block_name(model->scene, wheel->body));
}

/* Joints of angles alone, as gears: what wheels press on each other with would turn up in their bearings. */
static void describe_gears(TinkerPlan *plan, const TinkerModel *model)
{
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (batch->count == 0 || physics == NULL || physics->constraint == NULL) continue;
        if (physics->constraint->turning == NULL || physics->constraint->joint != 0) continue;
        plan_say(plan->left_out, _("forces on bearings by %s: it ties angles alone"),
                 tinker_scene_block_name(model->scene, batch->ids[0]));
    }
}

void plan_describe_bodies(TinkerPlan *plan, const TinkerModel *model, const TinkerRunOptions *options)
{
    char text[128];
    TinkerModelSizes sizes = tinker_model_sizes(model);
    const char *bodies =
        plan_counted(text, g_dngettext(GETTEXT_PACKAGE, "%d body", "%d bodies", (gulong)model->bodies), model->bodies);
    if (model->turning > 0)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%s, of which %d can turn: %d degree of freedom",
                             "%s, of which %d can turn: %d degrees of freedom", (gulong)sizes.degrees_of_freedom),
                 bodies, model->turning, sizes.degrees_of_freedom);
    else
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "%s as points with two coordinates each: %d degree of freedom",
                             "%s as points with two coordinates each: %d degrees of freedom",
                             (gulong)sizes.degrees_of_freedom),
                 bodies, sizes.degrees_of_freedom);
    if (model->turning == 0 && model->bodies > 0)
        plan_say(plan->left_out, _("rotation: every body that moves is a point"));
    if (model->turning > 0 && first_solid(model) < 0)
        plan_say(plan->left_out,
                 _("contact of bodies that turn: none of them is solid, or nothing that they could meet is"));
    if (has_long_outline(model))
        plan_say(plan->left_out, _("contact of plates with more than 64 corners: they pass through everything"));
    describe_meeting(plan, model, options);
    if (model->contacts != NULL && model->contacts->pin_count > 0)
        plan_say(plan->left_out, _("friction of pins in blows: these pass a pin as if it were smooth"));
    describe_wheels(plan, model);
    describe_gears(plan, model);
}
