/* What a plan says of what holds bodies: constraints, supports, and contact with these. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/constraint/straight-bars.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/plan/plan-words-private.h"

/* What lies on straight bars, between their ends. */
static void describe_bars(TinkerPlan *plan, const TinkerModel *model)
{
    const GArray *straight = model->constraints.straight;
    g_autoptr(GString) names = g_string_new(NULL);
    for (guint i = 0; i < straight->len; i++) {
        const TinkerStraightRow *of = &g_array_index(straight, TinkerStraightRow, i);
        TinkerBlockId block = tinker_model_block_of(model, of->between);
        g_string_append_printf(names, "%s%s", i > 0 ? ", " : "", tinker_scene_block_name(model->scene, block));
    }
    if (names->len > 0)
        plan_say(plan->modelled, _("straight bars: %s kept in line, which no finite force in the rods of a line could"),
                 names->str);
}

void plan_describe_constraints(TinkerPlan *plan, const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (all->rows == 0) {
        plan_say(plan->left_out, _("constraint forces: nothing holds a distance fixed"));
        return;
    }
    plan_say(plan->modelled,
             g_dngettext(GETTEXT_PACKAGE, "%d constraint row, solved after the other forces and held by projection",
                         "%d constraint rows, solved after the other forces and held by projection", (gulong)all->rows),
             all->rows);
    describe_bars(plan, model);
    if (plan->redundant->len == 0) return;
    g_autoptr(GString) names = g_string_new(NULL);
    for (guint i = 0; i < plan->redundant->len; i++)
        g_string_append_printf(names, "%s%s", i > 0 ? ", " : "", (const char *)g_ptr_array_index(plan->redundant, i));
    plan_say(plan->modelled, _("redundant: %s; forces there are the share of least norm, as nothing determines them"),
             names->str);
}

/* A motion need not begin at 0: a cosine begins at its amplitude. */
static void describe_displaced(TinkerPlan *plan, const TinkerModel *model)
{
    TinkerBlockId last = TINKER_NO_BLOCK;
    for (int32_t point = model->first_support; point < model->points; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        const TinkerPoint *now = &model->point[point];
        double dx = now->x - at->x, dy = now->y - at->y;
        if (!at->moving || at->turn || at->block == last || hypot(dx, dy) == 0) continue;
        last = at->block;
        plan_say(plan->modelled, _("%s starts displaced by (%.4g, %.4g) m: its motion does not begin at 0"),
                 tinker_scene_block_name(model->scene, at->block), dx, dy);
    }
}

void plan_describe_supports(TinkerPlan *plan, TinkerModel *model)
{
    if (model->moving_supports == 0) {
        plan_say(plan->left_out, _("motion of supports: all of them stand still"));
        return;
    }
    plan_say(plan->modelled,
             g_dngettext(GETTEXT_PACKAGE,
                         "%d support that moves in a way that is given, with exact velocity and acceleration",
                         "%d supports that move in a way that is given, with exact velocity and acceleration",
                         (gulong)model->moving_supports),
             model->moving_supports);
    if (tinker_model_set_time(model, 0.0) == TINKER_OK) describe_displaced(plan, model);
}

/* Bodies that could meet a solid side. */
static int32_t count_shapes(const TinkerContacts *contacts)
{
    int32_t count = 0;
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        count += tinker_contacts_may_touch(contacts, i);
    return count;
}

/* Whether it rubs on what has a friction of its own, or none that is given. */
static gboolean may_rub(const TinkerSurface *surface)
{
    return surface->static_friction != 0 || surface->dynamic_friction != 0;
}

/* A body that lies on a top is as smooth as the smoother of the two; and bodies rub on each other. */
gboolean plan_is_rough(const TinkerModel *model)
{
    const TinkerContacts *contacts = model->contacts;
    gboolean tops = FALSE, bodies = FALSE, pairs = FALSE;
    for (int32_t i = 0; contacts != NULL && i < contacts->plate_count; i++)
        tops |= may_rub(&contacts->plates[i].surface);
    for (int32_t body = 0; contacts != NULL && body < model->bodies; body++)
        bodies |= tinker_contacts_may_touch(contacts, body) &&
                  (!contacts->own_surfaces || may_rub(&contacts->surfaces[body]));
    for (int32_t i = 0; contacts != NULL && i < contacts->pair_count; i++) {
        const TinkerSurface between = tinker_contact_pair_surface(contacts, &contacts->pairs[i]);
        pairs |= may_rub(&between);
    }
    return (tops && bodies) || pairs;
}

void plan_describe_contact(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options)
{
    char bodies[128], plates[128];
    TinkerContacts *contacts = model->contacts;
    if (contacts != NULL && contacts->pin_count > 0)
        plan_say(plan->modelled,
                 g_dngettext(GETTEXT_PACKAGE, "friction of %d pin, which holds what does not turn: changes are events",
                             "friction of %d pins, which hold what does not turn: changes are events",
                             (gulong)contacts->pin_count),
                 contacts->pin_count);
    if (contacts == NULL || contacts->plate_count == 0) {
        if (plan_count_meeting(model, options) > 0)
            plan_say(plan->left_out, _("contact with supports: none has a solid side that a body could meet"));
        else
            plan_say(plan->left_out, _("contact and friction: nothing has a solid side that a body could meet"));
        return;
    }
    const int32_t shapes = count_shapes(contacts);
    gboolean rough = plan_is_rough(model);
    plan_counted(bodies, g_dngettext(GETTEXT_PACKAGE, "%d body", "%d bodies", (gulong)shapes), shapes);
    plan_counted(plates, g_dngettext(GETTEXT_PACKAGE, "%d solid side", "%d solid sides", (gulong)contacts->plate_count),
                 contacts->plate_count);
    if (options->impulses)
        plan_say(plan->modelled,
                 rough ? _("contact of %s with %s, with friction: impulses, once a step")
                       : _("contact of %s with %s: impulses, once a step"),
                 bodies, plates);
    else
        plan_say(
            plan->modelled,
            rough
                ? _("contact of %s with %s, with friction: what comes near is watched, impacts and changes of friction "
                    "are events within the steps")
                : _("contact of %s with %s: what comes near is watched, impacts and changes of friction are events "
                    "within the steps"),
            bodies, plates);
    if (contacts->resistance_count > 0)
        plan_say(plan->modelled, _("rolling resistance: a moment, which holds what does not roll up to its limit"));
    if (!rough) plan_say(plan->left_out, _("friction: every solid side is smooth"));
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (!tinker_contacts_touch(contacts) && !options->impulses)
        plan_say(plan->left_out, _("forces of contact: nothing touches at the start; they enter when something does"));
}
