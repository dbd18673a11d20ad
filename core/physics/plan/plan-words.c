/* What is modelled, and what is not because nothing asks for it: sentences from the compiled model, which knows roles
 * and no block by name. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdarg.h>

#include "physics/constraint/straight-bars.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/plan/plan-private.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "scene/frame/small-wheels.h"

static void say(GPtrArray *sentences, const char *format, ...) G_GNUC_PRINTF(2, 3);
static void say(GPtrArray *sentences, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(sentences, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

/* "1 body", "3 bodies" for a place in a sentence; the text is good until the next call with the same buffer. */
static const char *counted(char buffer[128], const char *format, ...) G_GNUC_PRINTF(2, 3);
static const char *counted(char buffer[128], const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_vsnprintf(buffer, 128, format, arguments);
    va_end(arguments);
    return buffer;
}

static int32_t count_asked(const GArray *batches)
{
    int32_t count = 0;
    for (guint i = 0; i < batches->len; i++)
        count += g_array_index(batches, TinkerAskedBatch, i).batch->count;
    return count;
}

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
static int32_t count_meeting(const TinkerModel *model, const TinkerRunOptions *options)
{
    int32_t solid = 0;
    for (int32_t i = 0; model->contacts != NULL && i < model->bodies; i++)
        solid += tinker_contacts_has_outline(model->contacts, i);
    return (options->impulses ? solid > 1 : any_meet(model->contacts)) ? solid : 0;
}

/* Contact of bodies among themselves. */
static void describe_meeting(TinkerPlan *plan, const TinkerModel *model, const TinkerRunOptions *options)
{
    const int32_t solid = count_meeting(model, options);
    char text[128];
    if (solid == 0) {
        if (model->bodies > 1) say(plan->left_out, _("contact between bodies: they pass through each other"));
        return;
    }
    say(plan->modelled,
        options->impulses ? _("contact among %s: impulses, once a step")
                          : _("contact among %s: impacts and changes of friction are events"),
        counted(text, g_dngettext(GETTEXT_PACKAGE, "%d body that meets others", "%d bodies that meet", (gulong)solid),
                solid));
    if (solid < model->bodies)
        say(plan->left_out, _("contact of other bodies with each other and with these: they pass through each other"));
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
    say(plan->left_out, _("turning of wheels by ropes: %s slides over %s (cords wound on it turn it)"),
        tinker_scene_block_name(model->scene, wheel->over), tinker_scene_block_name(model->scene, wheel->body));
}

static void describe_bodies(TinkerPlan *plan, const TinkerModel *model, const TinkerRunOptions *options)
{
    char text[128];
    TinkerModelSizes sizes = tinker_model_sizes(model);
    const char *bodies =
        counted(text, g_dngettext(GETTEXT_PACKAGE, "%d body", "%d bodies", (gulong)model->bodies), model->bodies);
    if (model->turning > 0)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%s, of which %d can turn: %d degree of freedom",
                        "%s, of which %d can turn: %d degrees of freedom", (gulong)sizes.degrees_of_freedom),
            bodies, model->turning, sizes.degrees_of_freedom);
    else
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%s as points with two coordinates each: %d degree of freedom",
                        "%s as points with two coordinates each: %d degrees of freedom",
                        (gulong)sizes.degrees_of_freedom),
            bodies, sizes.degrees_of_freedom);
    if (model->turning == 0 && model->bodies > 0) say(plan->left_out, _("rotation: every body that moves is a point"));
    if (model->turning > 0 && first_solid(model) < 0)
        say(plan->left_out,
            _("contact of bodies that turn: none of them is solid, or nothing that they could meet is"));
    if (has_long_outline(model))
        say(plan->left_out, _("contact of plates with more than 64 corners: they pass through everything"));
    describe_meeting(plan, model, options);
    if (model->contacts != NULL && model->contacts->pin_count > 0)
        say(plan->left_out, _("friction of pins in blows: these pass a pin as if it were smooth"));
    describe_wheels(plan, model);
}

static void describe_lines(TinkerPlan *plan, const TinkerModel *model)
{
    char linear[128], merged[128];
    int32_t laws = 0, asked = count_asked(model->asked_lines);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics != NULL && physics->line_law != NULL) laws += batch->count;
    }
    if (laws - asked > 0)
        say(plan->modelled, _("%s with a linear law, stepped as %s"),
            counted(linear, g_dngettext(GETTEXT_PACKAGE, "%d connector", "%d connectors", (gulong)(laws - asked)),
                    laws - asked),
            counted(merged, g_dngettext(GETTEXT_PACKAGE, "%d line", "%d lines", (gulong)model->lines.count),
                    model->lines.count));
    if (asked > 0)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%d connector with a nonlinear law, asked at every evaluation",
                        "%d connectors with a nonlinear law, asked at every evaluation", (gulong)asked),
            asked);
    if (laws == 0)
        say(plan->left_out, _("elastic and viscous connectors: there are none"));
    else if (asked == 0)
        say(plan->left_out, _("nonlinear laws: every connector's law is linear"));
}

static void describe_fields(TinkerPlan *plan, const TinkerModel *model)
{
    double gravity = hypot(model->field_acceleration[0], model->field_acceleration[1]);
    int32_t asked = count_asked(model->asked_fields);
    if (gravity > 0)
        say(plan->modelled, _("a uniform acceleration of %g m/s² on every body"), gravity);
    else if (asked == 0)
        say(plan->left_out, _("gravity: no block asks for it"));
    if (model->field_drag != 0 || model->field_force[0] != 0 || model->field_force[1] != 0)
        say(plan->modelled, _("air that moves or resists: a force linear in each body's velocity"));
    else if (asked == 0)
        say(plan->left_out, _("air: no block makes it resist or blow"));
    if (asked > 0)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%d field that the state changes, asked at every evaluation",
                        "%d fields that the state changes, asked at every evaluation", (gulong)asked),
            asked);
}

/* How many joints move as they are told, such as drives. */
static int32_t count_prescribed(const TinkerConstraints *all)
{
    int32_t count = 0;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        if (part->constraint->prescribed_rate != NULL) count += part->batch->count;
    }
    return count;
}

static void describe_forces(TinkerPlan *plan, const TinkerModel *model)
{
    int32_t asked = count_asked(model->asked_forces), prescribed = count_prescribed(&model->constraints);
    if (model->driven->len > 0)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%u force of time alone", "%u forces of time alone",
                        (gulong)model->driven->len),
            model->driven->len);
    if (asked > 0)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%d force that depends on the state", "%d forces that depend on the state",
                        (gulong)asked),
            asked);
    if (prescribed > 0)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%d prescribed motion of a joint, and the force or torque that it takes",
                        "%d prescribed motions of joints, and the forces or torques that they take",
                        (gulong)prescribed),
            prescribed);
    if (model->driven->len == 0 && asked == 0 && prescribed == 0 && model->constant_force == NULL)
        say(plan->left_out, _("driving forces: no block applies one"));
}

/* Whether anything takes energy: dampers, drag, laws that are asked. */
static gboolean is_damped(const TinkerModel *model)
{
    return model->lines.any_damping || model->field_drag != 0 || model->asked_lines->len > 0 ||
           model->asked_forces->len > 0 || model->asked_fields->len > 0;
}

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
        say(plan->modelled, _("straight bars: %s kept in line, which no finite force in the rods of a line could"),
            names->str);
}

static void describe_constraints(TinkerPlan *plan, const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (all->rows == 0) {
        say(plan->left_out, _("constraint forces: nothing holds a distance fixed"));
        return;
    }
    say(plan->modelled,
        g_dngettext(GETTEXT_PACKAGE, "%d constraint row, solved after the other forces and held by projection",
                    "%d constraint rows, solved after the other forces and held by projection", (gulong)all->rows),
        all->rows);
    describe_bars(plan, model);
    if (plan->redundant->len == 0) return;
    g_autoptr(GString) names = g_string_new(NULL);
    for (guint i = 0; i < plan->redundant->len; i++)
        g_string_append_printf(names, "%s%s", i > 0 ? ", " : "", (const char *)g_ptr_array_index(plan->redundant, i));
    say(plan->modelled, _("redundant: %s; forces there are the share of least norm, as nothing determines them"),
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
        say(plan->modelled, _("%s starts displaced by (%.4g, %.4g) m: its motion does not begin at 0"),
            tinker_scene_block_name(model->scene, at->block), dx, dy);
    }
}

/* Where units do not come out. */
static void describe_typed_laws(TinkerPlan *plan, const TinkerModel *model)
{
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (guint k = 0; batch->law_notes != NULL && k < batch->law_notes->len; k++)
            g_ptr_array_add(plan->modelled, g_strdup(g_ptr_array_index(batch->law_notes, k)));
    }
}

static void describe_supports(TinkerPlan *plan, TinkerModel *model)
{
    if (model->moving_supports == 0) {
        say(plan->left_out, _("motion of supports: all of them stand still"));
        return;
    }
    say(plan->modelled,
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

static gboolean is_rough(const TinkerModel *model)
{
    const TinkerContacts *contacts = model->contacts;
    for (int32_t i = 0; contacts != NULL && i < contacts->plate_count; i++)
        if (contacts->plates[i].surface.static_friction > 0) return TRUE;
    return FALSE;
}

static void describe_contact(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options)
{
    char bodies[128], plates[128];
    TinkerContacts *contacts = model->contacts;
    if (contacts != NULL && contacts->pin_count > 0)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "friction of %d pin, which holds what does not turn: changes are events",
                        "friction of %d pins, which hold what does not turn: changes are events",
                        (gulong)contacts->pin_count),
            contacts->pin_count);
    if (contacts == NULL || contacts->plate_count == 0) {
        if (count_meeting(model, options) > 0)
            say(plan->left_out, _("contact with supports: none has a solid side that a body could meet"));
        else
            say(plan->left_out, _("contact and friction: nothing has a solid side that a body could meet"));
        return;
    }
    const int32_t shapes = count_shapes(contacts);
    gboolean rough = is_rough(model);
    counted(bodies, g_dngettext(GETTEXT_PACKAGE, "%d body", "%d bodies", (gulong)shapes), shapes);
    counted(plates, g_dngettext(GETTEXT_PACKAGE, "%d solid side", "%d solid sides", (gulong)contacts->plate_count),
            contacts->plate_count);
    if (options->impulses)
        say(plan->modelled,
            rough ? _("contact of %s with %s, with friction: impulses, once a step")
                  : _("contact of %s with %s: impulses, once a step"),
            bodies, plates);
    else
        say(plan->modelled,
            rough
                ? _("contact of %s with %s, with friction: what comes near is watched, impacts and changes of friction "
                    "are events within the steps")
                : _("contact of %s with %s: what comes near is watched, impacts and changes of friction are events "
                    "within the steps"),
            bodies, plates);
    if (contacts->resistance_count > 0)
        say(plan->modelled, _("rolling resistance: a moment, which holds what does not roll up to its limit"));
    if (!rough) say(plan->left_out, _("friction: every solid side is smooth"));
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (!tinker_contacts_touch(contacts) && !options->impulses)
        say(plan->left_out, _("forces of contact: nothing touches at the start; they enter when something does"));
}

static gboolean any_nonlinear(const TinkerPlan *plan)
{
    for (guint i = 0; i < plan->islands->len; i++)
        if (!((const TinkerIslandPlan *)g_ptr_array_index(plan->islands, i))->linear) return TRUE;
    return FALSE;
}

static void describe_islands(TinkerPlan *plan)
{
    int32_t straight = 0, count = (int32_t)plan->islands->len;
    for (guint i = 0; i < plan->islands->len; i++) {
        const TinkerIslandPlan *island = g_ptr_array_index(plan->islands, i);
        straight += island->straight;
        if (island->sideways_growth > 0)
            say(plan->warnings,
                _("straight motion is unstable, grows at %.3g/s: island %u is stepped in both coordinates, and any "
                  "disturbance across its line grows"),
                island->sideways_growth, i + 1);
        else if (island->growth_max > 0)
            say(plan->modelled, _("the start of island %u is unstable: what leaves it grows at %.3g/s"), i + 1,
                island->growth_max);
    }
    if (count > 1)
        say(plan->modelled,
            g_dngettext(GETTEXT_PACKAGE, "%d island, each with its own method and step",
                        "%d islands, each with its own method and step", (gulong)count),
            count);
    if (straight > 0)
        say(plan->left_out,
            g_dngettext(GETTEXT_PACKAGE, "motion across the line: %d island lies and moves along one line",
                        "motion across the line: %d islands lie and move along one line", (gulong)straight),
            straight);
    if (!any_nonlinear(plan)) say(plan->left_out, _("large-displacement geometry: all motion is linear"));
}

void tinker_plan_describe(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options)
{
    describe_bodies(plan, model, options);
    describe_islands(plan);
    describe_lines(plan, model);
    describe_fields(plan, model);
    describe_forces(plan, model);
    describe_constraints(plan, model);
    describe_supports(plan, model);
    describe_typed_laws(plan, model);
    describe_contact(plan, model, options);
    if (!is_damped(model) && !is_rough(model)) say(plan->left_out, _("damping: no block takes energy"));
    if (options->accuracy > 0)
        say(plan->modelled,
            _("an accuracy of %g: steps and tolerances are chosen for it, and made tighter where the run’s own error "
              "estimate misses it"),
            options->accuracy);
    if (!options->estimate) say(plan->left_out, _("the error estimate: it is switched off"));
}
